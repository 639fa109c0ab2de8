//! The window from the side of the COP, in its own plane: its corner, its vectors right and up, its pixels counted from the
//! upper left, and the centre of each, through which its eye ray passes.
//!
//! Two places that students take instead are marked: the pixel's own corner, which lacks the ½, and the centre in a window
//! that is divided by n − 1.

use glam::DVec2;

use crate::explain::{MINUS, Part};
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::scene::Camera;
use crate::trace::{Event, PixelSample};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 360.0,
    usual: &[],
    more: &[],
};

/// The room at the left of the window, in lines: for the numbers of the rows and for `up`.
const ASIDE: f64 = 3.2;

/// More pixels along a side could not be told apart.
const MOST: u32 = 12;

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let camera = &figure.scene.camera;
    let pixel = figure.pixel()?;
    if camera.pixels.iter().any(|side| MOST < *side) {
        return Err(FigureError::new(
            "size",
            "this kind of figure shows each pixel, and they are too many",
            "give the figure a \"size\" of at most 12 × 12 pixels",
        ));
    }
    let found = figure
        .records()?
        .iter()
        .find_map(|record| match record.event {
            Event::Pixel(sample) => Some((sample, record.step)),
            _ => None,
        });
    let Some((sample, step)) = found else {
        return Err(FigureError::new(
            "pixel",
            "the log has no eye ray of this pixel",
            "trace the figure again",
        ));
    };
    let [x, y] = pixel;
    let [width, height] = camera.pixels;
    let centre = format!(
        "The eye ray of pixel ({x}, {y}) passes its centre, half a pixel from its edges: {}.",
        coordinates(sample.point)
    );
    let window = sheet.stage(
        "window",
        None,
        "The window starts at its lower left corner; the vectors right and up span it.",
    );
    let counted = sheet.stage(
        "pixels",
        None,
        format!(
            "Its {width} × {height} pixels are counted from the upper left: x to the right, y downwards."
        ),
    );
    let through = sheet.stage(Part::WindowPoint, step, centre.clone());
    let wrong = sheet.stage(
        "not here",
        step,
        format!(
            "Without ½ the ray passes the pixel's upper left corner, and with n {MINUS} 1 for n it passes beside the centre."
        ),
    );
    let stages = Stages {
        window,
        counted,
        through,
        wrong,
    };

    let share = match sheet.width {
        Width::Book => 0.56,
        Width::Slide => 0.5,
    };
    let [left, right] = body.split(share, 1.5 * sheet.letters);
    let plan = Plan::new(sheet, left, camera);
    plan.draw(sheet, pixel, &sample, &stages);
    formulas(sheet, right, (camera, pixel, &sample), &stages);
    Ok(format!(
        "The window in its own plane, {width} × {height} pixels. Pixel (0, 0) is at the upper left. {centre}"
    ))
}

struct Stages {
    window: StageId,
    counted: StageId,
    through: StageId,
    wrong: StageId,
}

/// Where places on the window, counted in pixels from the upper left, are on the sheet.
struct Plan {
    frame: Frame,
    /// The window's upper left corner, and how large a pixel is.
    corner: DVec2,
    side: DVec2,
    pixels: [u32; 2],
}

impl Plan {
    fn new(sheet: &Sheet, frame: Frame, camera: &Camera) -> Self {
        let line = sheet.line_height();
        // columns above, rows and `up` at the left, `right` below
        let min = frame.min + DVec2::new(ASIDE * line, 1.2 * line);
        let max = frame.max - DVec2::new(0.6 * line, 1.6 * line);
        let room = Frame { min, max };
        let [width, height] = camera.pixels.map(f64::from);
        let aspect = camera.right.length() / camera.up.length();
        let wide = room.size().x.min(aspect * room.size().y);
        let size = DVec2::new(wide, wide / aspect);
        let corner = DVec2::new(room.middle().x - 0.5 * size.x, room.min.y);
        Self {
            frame,
            corner,
            side: size / DVec2::new(width, height),
            pixels: camera.pixels,
        }
    }

    fn at(&self, x: f64, y: f64) -> DVec2 {
        self.corner + self.side * DVec2::new(x, y)
    }

    fn cell(&self, [x, y]: [u32; 2]) -> Frame {
        let [x, y] = [x, y].map(f64::from);
        Frame {
            min: self.at(x, y),
            max: self.at(x + 1.0, y + 1.0),
        }
    }

    fn draw(&self, sheet: &mut Sheet, pixel: [u32; 2], sample: &PixelSample, stages: &Stages) {
        let [width, height] = self.pixels;
        let [w, h] = self.pixels.map(f64::from);
        let line = sheet.line_height();
        let whole = Frame {
            min: self.at(0.0, 0.0),
            max: self.at(w, h),
        };
        let low = self.at(0.0, h);
        sheet.at(stages.window, |sheet| {
            sheet.rectangle(Look::OBJECT.outline().wide(1.75), whole);
            let off = DVec2::new(0.0, 0.4 * line);
            sheet.arrow(Look::RAY, low + off, self.at(w, h) + off);
            let below = self.at(0.5 * w, h) + DVec2::new(0.0, 1.1 * line);
            sheet.text(Anchor::Middle, below, "right");
            let aside = DVec2::new(0.6 * line - ASIDE * line, 0.0);
            sheet.arrow(Look::RAY, low + aside, self.at(0.0, 0.0) + aside);
            let beside = self.at(0.0, 0.0) + aside - DVec2::new(0.0, 0.5 * line);
            sheet.text(Anchor::Middle, beside, "up");
            sheet.dot(Look::RAY, low);
            let place = low + DVec2::new(-0.2 * line, 1.1 * line);
            sheet.text(Anchor::Middle, place, "corner");
        });
        sheet.at(stages.counted, |sheet| {
            for x in 1..width {
                let x = f64::from(x);
                sheet.line(Look::THIN.wide(0.75), self.at(x, 0.0), self.at(x, h));
            }
            for y in 1..height {
                let y = f64::from(y);
                sheet.line(Look::THIN.wide(0.75), self.at(0.0, y), self.at(w, y));
            }
            for x in 0..width {
                let above = self.at(f64::from(x) + 0.5, 0.0) - DVec2::new(0.0, 0.6 * line);
                sheet.text(Anchor::Middle, above, index("x", x, sheet.width));
            }
            for y in 0..height {
                let beside = self.at(0.0, f64::from(y) + 0.5) - DVec2::new(0.3 * line, 0.0);
                sheet.text(Anchor::End, beside, index("y", y, sheet.width));
            }
            sheet.rectangle(Look::VISITED.inside(), self.cell([0, 0]));
            sheet.label_in(self.cell([0, 0]), "(0, 0)");
            for y in 0..height {
                for x in 0..width {
                    let centre = self.cell([x, y]).middle();
                    sheet.circle(Look::RAY.inside().full(), centre, 2.0 * sheet.unit());
                }
            }
        });
        let centre = self.at(sample.place.x, sample.place.y);
        sheet.at(stages.through, |sheet| {
            sheet.rectangle(Look::VISITED.wide(2.5).outline(), self.cell(pixel));
            sheet.dot(Look::ANSWER, centre);
            sheet.label(self.frame, centre, DVec2::new(1.0, 0.8), formula("P"));
        });
        sheet.at(stages.wrong, |sheet| {
            let [x, y] = pixel.map(f64::from);
            let stretched = DVec2::new((x + 0.5) * w / (w - 1.0), (y + 0.5) * h / (h - 1.0));
            sheet.cross(Look::REJECTED, self.at(x, y));
            sheet.label(self.frame, self.at(x, y), DVec2::new(-1.0, 1.0), "no ½");
            if 1 < width && 1 < height {
                let at = self.at(stretched.x, stretched.y);
                sheet.cross(Look::REJECTED, at);
                let text = formula("n - 1");
                sheet.label(self.frame, at, DVec2::new(1.0, 0.5), text);
            }
        });
    }
}

/// The number of a column or a row; the first of them says which letter counts.
fn index(letter: &str, number: u32, width: Width) -> Text {
    match (number, width) {
        (0, Width::Book) => formula(&format!("{letter} = 0")),
        _ => number.to_string().into(),
    }
}

/// Where the centre is, in letters and in numbers.
fn formulas(
    sheet: &mut Sheet,
    frame: Frame,
    (camera, [x, y], sample): (&Camera, [u32; 2], &PixelSample),
    stages: &Stages,
) {
    let [width, height] = camera.pixels.map(f64::from);
    let given = [
        Text::from("corner = ") + coordinates(camera.corner()),
        Text::from("right = ") + coordinates(camera.right),
        Text::from("up = ") + coordinates(camera.up),
    ];
    let rest = sheet.at(stages.window, |sheet| sheet.lines(frame, &given));
    let [u, v] = [sample.place.x / width, 1.0 - sample.place.y / height];
    let [along, upwards] = [
        formula(&format!("u = (x + ½)/{width} = ({x} + ½)/{width} = ")) + quantity(u),
        formula(&format!(
            "v = 1 - (y + ½)/{height} = 1 - ({y} + ½)/{height} = "
        )) + quantity(v),
    ];
    let point = [
        formula("P = ") + "corner + " + formula("u") + "·right + " + formula("v") + "·up",
        formula("P = ") + coordinates(sample.point),
    ];
    let [p, value] = point;
    sheet.at(stages.through, |sheet| {
        sheet.lines(rest, &[along, upwards, p, value]);
    });
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, traced};
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::trace::{Event, PixelSample};

    #[test]
    fn the_centre_lies_half_a_pixel_from_the_crossed_corner_and_from_the_edges() {
        let mut scene = scene_of(&[sphere([0.0, 0.0, -5.0], 1.0)]);
        scene.camera.pixels = [4, 3];
        let sample = PixelSample {
            samples: 1,
            // the pixel of a trace made by hand is (0, 0)
            place: DVec2::new(0.5, 0.5),
            point: DVec3::new(0.0, 0.0, 1.0),
            ..PixelSample::default()
        };
        let spec = json!({"kind": "pixel-grid", "pixel": [0, 0]});
        let drawn = ReadBack::of(spec, traced(scene, [(None, Event::Pixel(sample))]));
        let [centre] = drawn.dots("answer")[..] else {
            panic!("one centre");
        };
        let [no_half, stretched] = drawn.crosses("rejected")[..] else {
            panic!("two crosses");
        };
        let half = centre - no_half;
        // (½·4/3, ½·3/2) from the corner
        let expected = no_half + half * DVec2::new(4.0 / 3.0, 1.5);
        assert!(stretched.distance(expected) < 3.0 * DRAWN);
        // the centre of the last pixel, 3½ and 2½ pixels from the corner
        let last = no_half + half * DVec2::new(7.0, 5.0);
        let has = |at: DVec2| {
            drawn
                .dots("ink")
                .iter()
                .any(|dot| dot.distance(at) < 8.0 * DRAWN)
        };
        assert!(has(last), "{:?}", drawn.dots("ink"));
        assert!(drawn.texts().iter().any(|text| text.contains("= 0.125")));
        // 1 − ½/3
        assert!(drawn.texts().iter().any(|text| text.contains("0.8333")));
    }
}
