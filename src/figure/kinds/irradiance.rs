//! The light that falls on what each pixel sees, as it is stored on the surfaces: photon by photon, or in the cells of
//! an illumination map (Arvo 1986).

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::heat_map::colour;
use crate::figure::kind::Kind;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::picture;
use crate::figure::parts::scale_bar;
use crate::figure::parts::scenery;
use crate::figure::parts::ticks;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Traced;
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 520.0,
    usual: &[Layer::Legend, Layer::Numbers],
    more: &[],
};

/// E of each pixel, the mean of its colours, from the top left; `None` where the eye ray hits nothing diffuse.
struct Map(Vec<Option<f64>>);

impl Map {
    fn of(traced: &Traced) -> Self {
        let width = traced.scene.camera.pixels[0] as usize;
        let mut map = vec![None; traced.pixel_count()];
        for record in &traced.records {
            // what other rays of the pixel gather lies elsewhere
            let (Some([x, y]), Event::Gathered(gathered), Some(0)) =
                (record.pixel, &record.event, record.ray)
            else {
                continue;
            };
            if let Some(seen) = map.get_mut(y as usize * width + x as usize) {
                *seen = Some(mean(gathered.irradiance));
            }
        }
        Self(map)
    }

    fn most(&self) -> Option<f64> {
        self.0.iter().copied().flatten().reduce(f64::max)
    }

    /// From 0 to the largest; black to the brightest colour of the scale.
    fn colours(&self, most: f64) -> Vec<Option<[u8; 3]>> {
        let share = |of: f64| if 0.0 < most { of / most } else { 0.0 };
        let pixels = self.0.iter();
        pixels.map(|of| of.map(|of| colour(share(of)))).collect()
    }
}

fn mean(of: DVec3) -> f64 {
    of.element_sum() / 3.0
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let map = Map::of(figure.first);
    let Some(most) = map.most() else {
        return Err(FigureError::new(
            "transport",
            "no light was gathered at any pixel",
            "add \"transport\": \"hybrid-stored\", and draw a scene with diffuse surfaces",
        ));
    };
    let line = sheet.line_height();
    let mut sentences = vec![format!(
        "The irradiance at the surface in each pixel: at most {} W/m².",
        quantity(most)
    )];
    sheet.stage("map", None, sentences[0].clone());
    let mut body = body;
    let mut marked = None;
    if let Some(pixel) = figure.pixels().first() {
        let section = figure.section_of(*pixel)?;
        let gatherings = Gathering::all(&section);
        let Some(gathering) = gatherings.first() else {
            return Err(FigureError::new(
                "pixel",
                "no light was gathered at this pixel",
                "name a pixel that shows a diffuse surface",
            ));
        };
        let numbers = numbers(*pixel, gathering);
        let said: Vec<String> = numbers.iter().map(|text| format!("{text}.")).collect();
        let stage = sheet.stage(Part::Irradiance, gathering.step, said.join(" "));
        if figure.shows(Layer::Numbers) {
            let mut lines = vec![Text::from(&numbers[0])];
            lines.extend(gathering.lines());
            body = sheet.at(stage, |sheet| sheet.lines(body, &lines));
        }
        sentences.extend(said);
        marked = Some((*pixel, stage));
    }
    // a bar, its numbers, what it is, and air
    let below = if figure.shows(Layer::Legend) {
        4.0 * line
    } else {
        0.0
    };
    let room = Frame {
        min: body.min,
        max: body.max - DVec2::new(0.0, below),
    };
    let image = Image::new(figure.scene.camera.pixels, map.colours(most)).in_squares();
    let whole = picture::draw_image(sheet, room, image);
    if let Some(([x, y], stage)) = marked {
        sheet.at(stage, |sheet| {
            let side = whole.size() / DVec2::from(figure.scene.camera.pixels.map(f64::from));
            // all that shows the same cell of the map, or the pixel alone
            let [first, last] = cell_around(figure.first, [x, y]);
            let corner =
                |[x, y]: [u32; 2]| whole.min + side * DVec2::new(f64::from(x), f64::from(y));
            let cell = Frame {
                min: corner(first),
                max: corner(last.map(|of| of + 1)),
            };
            sheet.on_picture(&cell.wider(sheet.unit()).corners(), true);
        });
    }
    if figure.shows(Layer::Legend) {
        let bar = Frame {
            min: DVec2::new(whole.min.x, whole.max.y + 0.5 * line),
            max: DVec2::new(whole.max.x, whole.max.y + 1.5 * line),
        };
        let numbers = numbers_below(sheet, bar, most);
        let what = Text::from("irradiance ") + formula("E") + " in W/m²";
        scale_bar::draw(sheet, bar, &numbers, what);
    }
    around_the_map(figure, sheet, (whole, room));
    Ok(sentences.join(" "))
}

/// The first and the last pixel, both ways, of those around one that gather the same: they show the same cell of the map.
fn cell_around(traced: &Traced, pixel: [u32; 2]) -> [[u32; 2]; 2] {
    let mut gathered = BTreeMap::new();
    for record in &traced.records {
        if let (Some(pixel), Event::Gathered(of), Some(0)) =
            (record.pixel, &record.event, record.ray)
        {
            // photons around a point belong to no cell
            let of_cell = of.radius.is_none();
            let same = (of.count, mean(of.irradiance).to_bits(), of.area.to_bits());
            gathered.insert(pixel, of_cell.then_some(same));
        }
    }
    let [mut first, mut last] = [pixel; 2];
    let Some(Some(here)) = gathered.get(&pixel).copied() else {
        return [first, last];
    };
    let (mut open, mut seen) = (vec![pixel], BTreeSet::from([pixel]));
    while let Some([x, y]) = open.pop() {
        first = [first[0].min(x), first[1].min(y)];
        last = [last[0].max(x), last[1].max(y)];
        let beside = [
            [x.wrapping_sub(1), y],
            [x + 1, y],
            [x, y.wrapping_sub(1)],
            [x, y + 1],
        ];
        for next in beside {
            if gathered.get(&next) == Some(&Some(here)) && seen.insert(next) {
                open.push(next);
            }
        }
    }
    [first, last]
}

/// Round numbers below the scale, and the largest at its end; a round one too near to that is left out.
fn numbers_below(sheet: &Sheet, bar: Frame, most: f64) -> Vec<(f64, String)> {
    // ticks are of whole numbers: of thousandths of the power of ten above
    let unit = libm::pow(10.0, libm::log10(most.max(f64::MIN_POSITIVE)).ceil() - 3.0);
    let last = quantity(most);
    let room = bar.size().x - sheet.width_of(&last) - 0.5 * sheet.letters;
    let round = ticks::linear((most / unit) as u128);
    let round = round.into_iter().map(|tick| tick as f64 * unit);
    let mut numbers: Vec<(f64, String)> = round
        .map(|tick| (tick / most.max(f64::MIN_POSITIVE), quantity(tick)))
        .filter(|(share, text)| share * bar.size().x + 0.5 * sheet.width_of(text) < room)
        .collect();
    numbers.push((1.0, last));
    numbers
}

/// The lamps and the polygons that hold light back, as the camera sees them, where they are beside the map or over it.
fn around_the_map(figure: &Figure, sheet: &mut Sheet, (whole, room): (Frame, Frame)) {
    let camera = &figure.scene.camera;
    let place = |at: DVec3| -> Option<DVec2> {
        let normal = camera.right.cross(camera.up);
        let towards = at - camera.cop;
        let t = normal.dot(camera.to_corner) / normal.dot(towards);
        if !(0.0 < t && t.is_finite()) {
            return None;
        }
        let on_window = t * towards - camera.to_corner;
        let share = |side: DVec3| on_window.dot(side) / side.length_squared();
        let from_corner = DVec2::new(share(camera.right), 1.0 - share(camera.up));
        let at = whole.min + whole.size() * from_corner;
        room.contains(at).then_some(at)
    };
    let lit: Vec<_> = figure
        .first
        .records
        .iter()
        .filter_map(|record| match &record.event {
            Event::Gathered(of) => Some(of.object),
            _ => None,
        })
        .collect();
    for (id, primitive) in (0..).map(PrimitiveId).zip(&figure.scene.primitives) {
        let Shape::Polygon(polygon) = &primitive.shape else {
            continue;
        };
        let outline: Option<Vec<DVec2>> = polygon.vertices().map(place).collect();
        if let (Some(outline), false) = (outline, lit.contains(&id)) {
            let first = outline[0];
            sheet.polygon(Look::OBJECT.wide(1.5), outline);
            let name = scenery::name_of(figure.scene, id);
            sheet.label(room, first, DVec2::Y, name);
        }
    }
    for light in &figure.scene.lights {
        if let Some(at) = place(light.position) {
            sheet.circle(Look::LIGHT_RAY, at, 5.0 * sheet.unit());
            sheet.label(room, at, DVec2::NEG_Y, light.name.as_str());
        }
    }
}

/// What was gathered at a pixel, in lines.
fn numbers(pixel: [u32; 2], gathering: &Gathering) -> Vec<String> {
    let [x, y] = pixel;
    let count = gathering.gathered.count;
    let on = match gathering.gathered.radius {
        None => "in the cell of the map",
        Some(_) => "around the point",
    };
    let mut lines = vec![format!("Pixel ({x}, {y}): {count} photons {on}")];
    lines.extend(gathering.working());
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_colours_of_a_map_go_from_0_to_the_largest() {
        let map = Map(vec![Some(0.0), None, Some(4.0), Some(2.0)]);
        assert_eq!(map.most(), Some(4.0));
        let scale = [0.0, 1.0, 0.5].map(colour);
        let expected = [Some(scale[0]), None, Some(scale[1]), Some(scale[2])];
        assert_eq!(map.colours(4.0), expected);
        // no light at all is dark
        assert_eq!(Map(vec![Some(0.0)]).colours(0.0), [Some(colour(0.0))]);
    }
}
