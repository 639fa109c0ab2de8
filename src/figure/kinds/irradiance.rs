//! The light that falls on what each pixel sees, as it is stored on the surfaces: photon by photon, or in the cells of
//! an illumination map (Arvo 1986).

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::heat_map::colour;
use crate::figure::kind::Kind;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::picture;
use crate::figure::parts::scale_bar;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::text::Text;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Traced;
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
            let corner = whole.min + side * DVec2::new(f64::from(x), f64::from(y));
            let pixel = Frame {
                min: corner,
                max: corner + side,
            };
            sheet.on_picture(&pixel.wider(sheet.unit()).corners(), true);
        });
    }
    if figure.shows(Layer::Legend) {
        let bar = Frame {
            min: DVec2::new(whole.min.x, whole.max.y + 0.5 * line),
            max: DVec2::new(whole.max.x, whole.max.y + 1.5 * line),
        };
        let numbers = [0.0, 0.5, 1.0].map(|share| (share, quantity(share * most)));
        scale_bar::draw(sheet, bar, &numbers, "irradiance E in W/m²");
    }
    Ok(sentences.join(" "))
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
