//! The output image, the traced pixels marked, each with what became of its rays.

use glam::DVec2;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::parts::scenery;
use crate::figure::parts::transport_name::transport_name;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::subject::Figure;
use crate::scene::Scene;
use crate::trace::{Purpose, RayNode, RayTree, RayVerdict, Record};

/// The frame of a figure and that of the picture at its right.
pub(in crate::figure) fn room_beside(sheet: &Sheet, frame: Frame) -> [Frame; 2] {
    /// Of the width: the figure itself is what matters.
    const SHARE: f64 = 0.64;
    frame.split(SHARE, 2.0 * sheet.letters)
}

/// Draws the picture at the right of a figure.
///
/// # Errors
/// There is no picture in the log.
pub(in crate::figure) fn beside(
    figure: &Figure,
    sheet: &mut Sheet,
    right: Frame,
) -> Result<(), FigureError> {
    let line = sheet.line_height();
    let room = Frame {
        min: right.min,
        max: right.max - DVec2::new(0.0, line),
    };
    let placed = Placed::draw(figure, sheet, room)?;
    let pixels = figure.pixels();
    for pixel in &pixels {
        placed.mark(sheet, *pixel);
    }
    if let [[x, y]] = pixels.as_slice() {
        let whole = placed.whole;
        let below = DVec2::new(whole.middle().x, whole.max.y + 0.75 * line);
        sheet.text(Anchor::Middle, below, format!("pixel ({x}, {y})"));
    }
    Ok(())
}

/// Draws the picture as large as the frame allows, what became of the marked pixels at its right, and says it in words.
///
/// # Errors
/// There is no picture in the log, or no event of a pixel.
pub(in crate::figure) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
) -> Result<String, FigureError> {
    if 1 < figure.traced.len() {
        return several(figure, sheet, frame);
    }
    let pixels = figure.pixels();
    let mut verdicts = Vec::new();
    for pixel in &pixels {
        verdicts.push(verdict(figure.scene, figure.records_of(*pixel)?));
    }
    // those that cannot be told apart by one place alone have numbers
    let notes: Vec<String> = match (pixels.as_slice(), verdicts.as_slice()) {
        ([[x, y]], [verdict]) => vec![format!("pixel ({x}, {y})"), verdict.clone()],
        _ => (1..)
            .zip(&verdicts)
            .map(|(number, verdict)| format!("{number}: {verdict}"))
            .collect(),
    };
    let widest = notes.iter().map(|note| sheet.width_of(note));
    let widest = widest.fold(0.0, f64::max);
    let room = if notes.is_empty() {
        0.0
    } else {
        widest + GAP * sheet.letters
    };
    let left = Frame {
        min: frame.min,
        max: frame.max - DVec2::new(room, 0.0),
    };
    let placed = Placed::draw(figure, sheet, left)?;
    let [width, height] = figure.scene.camera.pixels;
    let mut sentences = vec![format!(
        "The picture of the scene, {width} × {height} pixels."
    )];
    let in_words = pixels.iter().zip(&verdicts);
    sentences.extend(in_words.map(|([x, y], verdict)| format!("Pixel ({x}, {y}): {verdict}.")));
    sheet.stage("picture", None, sentences[0].clone());
    // a stage for each pixel, if they are few
    let sentences_of_pixels = &sentences[1..];
    let stages: Vec<StageId> = if pixels.len() <= FEW {
        let each = pixels.iter().zip(sentences_of_pixels);
        let each = each.map(|(pixel, said)| {
            let step = figure
                .records_of(*pixel)
                .ok()
                .and_then(|of| of.last())
                .map(|last| last.step);
            sheet.stage(Part::PixelColour, step, said.clone())
        });
        each.collect()
    } else {
        let all = sheet.stage("pixels", None, sentences_of_pixels.join(" "));
        vec![all; pixels.len()]
    };
    match pixels.as_slice() {
        [pixel] => sheet.at(stages[0], |sheet| placed.note(sheet, *pixel, &notes)),
        _ => placed.notes(sheet, &pixels, &notes, &stages),
    }
    Ok(sentences.join(" "))
}

/// The pictures of several kinds of ray tracing side by side, each below its name.
fn several(figure: &Figure, sheet: &mut Sheet, frame: Frame) -> Result<String, FigureError> {
    let count = figure.traced.len() as f64;
    let gap = 1.5 * sheet.letters;
    let width = (frame.size().x - (count - 1.0) * gap) / count;
    let mut names = Vec::new();
    for (place, traced) in figure.traced.iter().enumerate() {
        let image = traced.picture().ok_or_else(no_picture)?;
        let name = transport_name(traced.settings.transport);
        let stage = sheet.stage(name, None, format!("The picture by {name}."));
        let left = frame.min.x + place as f64 * (width + gap);
        let line = sheet.line_height();
        let room = Frame {
            min: DVec2::new(left, frame.min.y + line),
            max: DVec2::new(left + width, frame.max.y),
        };
        sheet.at(stage, |sheet| {
            let whole = draw_image(sheet, room, image);
            let above = DVec2::new(whole.middle().x, whole.min.y - 0.5 * line);
            sheet.text(Anchor::Middle, above, name);
        });
        names.push(name);
    }
    let [width, height] = figure.scene.camera.pixels;
    Ok(format!(
        "The picture of the scene, {width} × {height} pixels, by {}.",
        names.join(" and by ")
    ))
}

fn no_picture() -> FigureError {
    FigureError::new(
        "kind",
        "the log has no picture and no colour of a pixel",
        "trace the figure again",
    )
}

/// So many pixels have a stage each.
const FEW: usize = 8;

/// Between the picture and what stands at its right, in letters.
const GAP: f64 = 1.5;

/// What became of the rays of a pixel, as far as one looks at the picture: of the eye ray, and of the rays to the lights
/// from where it hits.
fn verdict(scene: &Scene, records: &[Record]) -> String {
    let tree = RayTree::new(records);
    if let Some(mirrored) = mirrored(scene, &tree) {
        return mirrored;
    }
    of_eye_ray(&tree).into()
}

/// That the object which the eye ray hits shows another one, as a mirror does.
fn mirrored(scene: &Scene, tree: &RayTree) -> Option<String> {
    let eye_ray = tree.rays.first()?;
    let mirror = eye_ray.end?.object?;
    let is_reflected = |node: &&RayNode| {
        let purpose = node.start.map(|start| start.purpose);
        node.parent == Some(eye_ray.id) && purpose == Some(Purpose::Reflected)
    };
    let shown = tree.rays.iter().find(is_reflected)?.end?.object?;
    let [mirror, shown] = [mirror, shown].map(|id| scenery::name_of(scene, id));
    Some(format!("{mirror} shows {shown}"))
}

fn of_eye_ray(tree: &RayTree) -> &'static str {
    let Some(eye_ray) = tree.rays.first() else {
        return "not traced";
    };
    if eye_ray
        .end
        .is_some_and(|end| end.verdict == RayVerdict::Miss)
    {
        return "misses";
    }
    let children = tree
        .rays
        .iter()
        .filter(|node| node.parent == Some(eye_ray.id));
    let shadow_rays = children.filter(|node| {
        let purpose = node.start.map(|start| start.purpose);
        purpose == Some(Purpose::Shadow)
    });
    let blocked: Vec<bool> = shadow_rays
        .filter_map(|node| Some(node.end?.verdict == RayVerdict::Blocked))
        .collect();
    match (blocked.contains(&true), blocked.contains(&false)) {
        (true, true) => "lit by some lights",
        (true, false) => "in shadow",
        (false, true) => "lit",
        (false, false) => "hits an object",
    }
}

/// A picture on a sheet.
struct Placed {
    /// What it fills.
    whole: Frame,
    /// How large one of the scene's pixels is.
    side: DVec2,
}

impl Placed {
    fn draw(figure: &Figure, sheet: &mut Sheet, room: Frame) -> Result<Self, FigureError> {
        let image = figure.first.picture().ok_or_else(no_picture)?;
        let whole = draw_image(sheet, room, image);
        let [width, height] = figure.scene.camera.pixels.map(f64::from);
        Ok(Self {
            whole,
            side: whole.size() / DVec2::new(width, height),
        })
    }

    /// One of the scene's pixels.
    fn pixel(&self, [x, y]: [u32; 2]) -> Frame {
        let corner = self.whole.min + self.side * DVec2::new(f64::from(x), f64::from(y));
        Frame {
            min: corner,
            max: corner + self.side,
        }
    }

    /// A frame around one of the scene's pixels.
    fn mark(&self, sheet: &mut Sheet, pixel: [u32; 2]) {
        let around = self.pixel(pixel).wider(sheet.unit());
        sheet.on_picture(&around.corners(), true);
    }

    /// Marks a pixel, and writes lines beside the picture at its height.
    fn note(&self, sheet: &mut Sheet, pixel: [u32; 2], lines: &[String]) {
        let Some((first, rest)) = lines.split_first() else {
            return;
        };
        self.write_note(sheet, pixel, self.pixel(pixel).middle().y, first);
        let at = DVec2::new(
            self.whole.max.x + GAP * sheet.letters,
            self.pixel(pixel).middle().y,
        );
        for (line, text) in (1..).zip(rest) {
            let down = DVec2::new(0.0, f64::from(line) * sheet.line_height());
            sheet.text(Anchor::Start, at + down, text.as_str());
        }
    }

    /// Marks pixels, and joins each to a line of letters beside the picture.
    fn notes(&self, sheet: &mut Sheet, pixels: &[[u32; 2]], notes: &[String], stages: &[StageId]) {
        let mut order: Vec<usize> = (0..pixels.len()).collect();
        order.sort_by_key(|&place| (pixels[place][1], pixels[place][0]));
        let mut lowest = f64::NEG_INFINITY;
        for place in order {
            let pixel = self.pixel(pixels[place]);
            // lines of letters do not lie over each other
            let y = pixel.middle().y.max(lowest + sheet.line_height());
            lowest = y;
            sheet.at(stages[place], |sheet| {
                self.write_note(sheet, pixels[place], y, &notes[place]);
            });
        }
    }

    /// Marks a pixel, and joins it to a line of letters at this height.
    fn write_note(&self, sheet: &mut Sheet, pixel: [u32; 2], y: f64, note: &str) {
        let of = self.pixel(pixel);
        let edge = DVec2::new(self.whole.max.x, y);
        let side = DVec2::new(of.max.x + sheet.unit(), of.middle().y);
        sheet.on_picture(&[side, edge], false);
        self.mark(sheet, pixel);
        let gap = DVec2::new(GAP * sheet.letters, 0.0);
        sheet.line(Look::THIN, edge, edge + 0.7 * gap);
        sheet.text(Anchor::Start, edge + gap, note);
    }
}

/// Draws an image in the middle of a frame, as large as it allows, with a line around it, and gives back what it fills.
pub(in crate::figure) fn draw_image(sheet: &mut Sheet, room: Frame, image: Image) -> Frame {
    let aspect = image.aspect();
    let width = room.size().x.min(aspect * room.size().y);
    let half = 0.5 * DVec2::new(width, width / aspect);
    let whole = Frame {
        min: room.middle() - half,
        max: room.middle() + half,
    };
    sheet.image(whole, image);
    sheet.rectangle(Look::THIN, whole);
    whole
}
