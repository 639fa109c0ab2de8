//! What each pixel cost: the object tests on all of its rays as a colour, one map for each strategy.

use glam::DVec2;

use crate::explain::{Compared, Cost, grouped};
use crate::figure::error::FigureError;
use crate::figure::heat_map::colour;
use crate::figure::kind::Kind;
use crate::figure::parts::picture;
use crate::figure::parts::scale_bar;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Traced;
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 460.0,
    usual: &[Layer::Legend],
    more: &[],
};

/// One map.
struct Map {
    name: String,
    /// Tests of each pixel, from the top left.
    tests: Vec<u32>,
}

impl Map {
    fn of(traced: &Traced) -> Self {
        let compared = Compared {
            settings: traced.settings.clone(),
            cost: Ok(Cost::default()),
        };
        Self {
            name: compared.name(),
            tests: traced.of_pixels(0, |tests, event| {
                if let Event::RayEnd(end) = event {
                    *tests += end.tests;
                }
            }),
        }
    }

    fn range(&self) -> Range {
        let all = || self.tests.iter().copied();
        Range {
            min: all().min().unwrap_or(0),
            max: all().max().unwrap_or(0),
        }
    }

    fn sum(&self) -> u64 {
        self.tests.iter().copied().map(u64::from).sum()
    }
}

/// From the fewest tests to the most.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Range {
    min: u32,
    max: u32,
}

impl Range {
    /// The range of both.
    fn with(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Where a number lies, from 0 to 1; 0 if all are equal.
    fn share(self, tests: u32) -> f64 {
        let length = f64::from(self.max - self.min).max(1.0);
        f64::from(tests - self.min) / length
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let has_ends = |record: &crate::trace::Record| matches!(record.event, Event::RayEnd(_));
    if !figure
        .traced
        .iter()
        .all(|of| of.records.iter().any(has_ends))
    {
        return Err(FigureError::new(
            "scene",
            "the log does not have the number of tests of each ray",
            "trace the figure again, or write the log with its ray_end lines",
        ));
    }
    let maps: Vec<Map> = figure.traced.iter().map(Map::of).collect();
    let ranges: Vec<Range> = maps.iter().map(Map::range).collect();
    let common = ranges.iter().copied().reduce(Range::with);
    let one_scale = figure.spec.one_scale;

    let gap = 2.5 * sheet.letters;
    let count = maps.len() as f64;
    let width = (body.size().x - (count - 1.0) * gap) / count;
    let mut sentences = Vec::new();
    for (place, map) in maps.iter().enumerate() {
        let left = body.min.x + place as f64 * (width + gap);
        let frame = Frame {
            min: DVec2::new(left, body.min.y),
            max: DVec2::new(left + width, body.max.y),
        };
        let own = ranges[place];
        let scale = if one_scale {
            common.unwrap_or(own)
        } else {
            own
        };
        draw_map(figure, sheet, frame, map, scale);
        sentences.push(format!(
            "{}: from {} to {} object tests for a pixel, {} in all.",
            map.name,
            own.min,
            own.max,
            grouped(map.sum())
        ));
    }
    if 1 < maps.len() {
        let scales = if one_scale {
            "All maps have the same scale."
        } else {
            "Each map has its own scale."
        };
        sentences.push(scales.into());
    }
    Ok(sentences.join(" "))
}

/// A map under its name, with its scale below.
fn draw_map(figure: &Figure, sheet: &mut Sheet, frame: Frame, map: &Map, scale: Range) {
    let line = sheet.line_height();
    let below = if figure.shows(Layer::Legend) {
        // a bar, its numbers, what it is, and air
        4.0 * line
    } else {
        0.0
    };
    let room = Frame {
        min: frame.min + DVec2::new(0.0, line),
        max: frame.max - DVec2::new(0.0, below),
    };
    let colours: Vec<Option<[u8; 3]>> = map
        .tests
        .iter()
        .map(|tests| Some(colour(scale.share(*tests))))
        .collect();
    let whole = picture::squares(sheet, room, figure.scene.camera.pixels, &colours).whole;
    let above = DVec2::new(whole.middle().x, whole.min.y - 0.5 * line);
    sheet.text(Anchor::Middle, above, &map.name);
    if figure.shows(Layer::Legend) {
        let bar = Frame {
            min: DVec2::new(whole.min.x, whole.max.y + 0.5 * line),
            max: DVec2::new(whole.max.x, whole.max.y + 1.5 * line),
        };
        legend(sheet, bar, scale);
    }
}

/// The colours of a scale as a bar, with its numbers.
fn legend(sheet: &mut Sheet, bar: Frame, scale: Range) {
    let mut numbers = vec![scale.min];
    if 1 < scale.max - scale.min {
        numbers.push(u32::midpoint(scale.min, scale.max));
    }
    if scale.min < scale.max {
        numbers.push(scale.max);
    }
    let numbers: Vec<(f64, String)> = numbers
        .into_iter()
        .map(|number| (scale.share(number), grouped(u64::from(number))))
        .collect();
    scale_bar::draw(sheet, bar, &numbers, "object tests per pixel");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_a_range_are_0_and_1_and_equal_numbers_are_0() {
        let range = Range { min: 100, max: 200 };
        assert_eq!(
            [100, 150, 200].map(|tests| range.share(tests)),
            [0.0, 0.5, 1.0]
        );
        assert_eq!(Range { min: 7, max: 7 }.share(7), 0.0);
        let both = range.with(Range { min: 3, max: 120 });
        assert_eq!(both, Range { min: 3, max: 200 });
    }
}
