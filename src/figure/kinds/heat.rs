//! What each pixel cost: all tests on all of its rays as a colour, one map for each strategy, all on one scale.

use glam::DVec2;

use crate::explain::{Compared, Cost, grouped, grouped_sum};
use crate::figure::error::FigureError;
use crate::figure::heat_map::colour;
use crate::figure::kind::Kind;
use crate::figure::parts::{picture, scale_bar, ticks};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Traced;
use crate::trace::{Counts, Recorder};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 460.0,
    usual: &[Layer::Legend],
    more: &[],
};

/// One map.
struct Map {
    name: String,
    /// All tests of each pixel, from the top left.
    tests: Vec<u64>,
    /// Tests of objects, of bounds and nodes, and of cells, of all pixels together.
    sums: [u64; 3],
}

impl Map {
    /// `None` if the log does not have the tests of each pixel.
    fn of(traced: &Traced) -> Option<Self> {
        let compared = Compared {
            settings: traced.settings.clone(),
            cost: Ok(Cost::default()),
        };
        let of_each = tests_of_each(traced)?;
        let sum = |of: usize| of_each.iter().map(|tests| tests[of]).sum();
        Some(Self {
            name: compared.name(),
            tests: of_each.iter().map(|tests| tests.iter().sum()).collect(),
            sums: [0, 1, 2].map(sum),
        })
    }

    fn total(&self) -> u64 {
        self.sums.iter().sum()
    }

    /// What the tests are of, without what there is none of.
    fn parts(&self) -> Vec<String> {
        let parts = ["object tests", "bound tests and nodes", "cells"];
        let parts = self.sums.iter().zip(parts).filter(|(sum, _)| 0 < **sum);
        parts
            .map(|(sum, what)| format!("{} {what}", grouped(*sum)))
            .collect()
    }
}

/// The tests of objects, of bounds and nodes, and of cells, for each pixel: as the figure's log has them, or from the
/// events of a log that has all of them.
fn tests_of_each(traced: &Traced) -> Option<Vec<[u64; 3]>> {
    let rows = &traced.of_pixels.tests;
    if !rows.is_empty() {
        let pixels = rows.iter().flat_map(|row| {
            let searched = row.nodes.iter().zip(&row.cells);
            let all = row.objects.iter().zip(searched);
            all.map(|(&objects, (&nodes, &cells))| [objects, nodes, cells])
        });
        return Some(pixels.collect());
    }
    if traced.settings.only.is_some() {
        return None;
    }
    let width = traced.scene.camera.pixels[0] as usize;
    let mut of_each = vec![[0; 3]; traced.pixel_count()];
    for records in traced.records.chunk_by(|a, b| a.pixel == b.pixel) {
        let Some([x, y]) = records[0].pixel else {
            continue;
        };
        let mut counts = Counts::default();
        for record in records {
            counts.note(|| record.event);
        }
        let search = &counts.search;
        let nodes = search.bounds.tests + search.entered;
        if let Some(tests) = of_each.get_mut(y as usize * width + x as usize) {
            *tests = [counts.objects_tested(), nodes, search.cells];
        }
    }
    Some(of_each)
}

/// From which number of tests a colour is seen to which other.
#[derive(Clone, Debug, PartialEq)]
struct Scale {
    is_logarithmic: bool,
    /// The numbers along it, the ends among them.
    ticks: Vec<u128>,
}

impl Scale {
    /// One scale for all maps.
    fn of(maps: &[Map]) -> Self {
        /// From here on equal steps of colour are equal ratios: on a linear scale the smallest number would look like none.
        const RATIO: u64 = 10;
        let all = || maps.iter().flat_map(|map| map.tests.iter().copied());
        let least = all().min().unwrap_or(0).max(1);
        let most = all().max().unwrap_or(0);
        let is_logarithmic = least.saturating_mul(RATIO) <= most;
        let ticks = if is_logarithmic {
            ticks::logarithmic(least, most)
        } else {
            ticks::linear(most.into())
        };
        Self {
            is_logarithmic,
            ticks,
        }
    }

    /// Where a number lies, from 0 to 1.
    fn share(&self, tests: u128) -> f64 {
        let place = |tests: u128| {
            if self.is_logarithmic {
                libm::log10(tests.max(1) as f64)
            } else {
                tests as f64
            }
        };
        let [from, to] = [self.ticks[0], self.ticks[self.ticks.len() - 1]].map(place);
        if to <= from {
            return 0.0;
        }
        (place(tests) - from) / (to - from)
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let maps: Option<Vec<Map>> = figure.traced.iter().map(Map::of).collect();
    let maps = maps.ok_or_else(|| {
        FigureError::new(
            "scene",
            "the log does not have the number of tests of each pixel",
            "trace the figure again, or write a log with all events",
        )
    })?;
    let scale = Scale::of(&maps);
    let line = sheet.line_height();
    let body = if figure.shows(Layer::Legend) {
        // a bar, its numbers, what it is, and air
        let above = body.size().y - 4.0 * line;
        let [above, below] = body.split_top(above);
        let bar = Frame {
            min: below.min + DVec2::new(0.0, 0.5 * line),
            max: DVec2::new(below.max.x, below.min.y + 1.5 * line),
        };
        legend(sheet, bar, &scale);
        above
    } else {
        body
    };

    let gap = 2.0 * sheet.letters;
    let count = maps.len() as f64;
    let width = (body.size().x - (count - 1.0) * gap) / count;
    let sentence = |map: &Map| {
        let all = || map.tests.iter().copied();
        let [least, most] = [all().min(), all().max()].map(|of| grouped(of.unwrap_or(0)));
        format!(
            "{}: {} tests in all, from {least} to {most} for a pixel: {}.",
            map.name,
            grouped(map.total()),
            map.parts().join(", ")
        )
    };
    let mut sentences: Vec<String> = maps.iter().map(sentence).collect();
    for (place, map) in maps.iter().enumerate() {
        // map by map, in order
        let stage = sheet.stage(map.name.clone(), None, sentences[place].clone());
        let left = body.min.x + place as f64 * (width + gap);
        let frame = Frame {
            min: DVec2::new(left, body.min.y),
            max: DVec2::new(left + width, body.max.y),
        };
        sheet.at(stage, |sheet| draw_map(figure, sheet, frame, map, &scale));
    }
    if 1 < maps.len() {
        sentences.push("All maps have the same scale.".into());
    }
    Ok(sentences.join(" "))
}

/// A map under its name, with its sums below.
fn draw_map(figure: &Figure, sheet: &mut Sheet, frame: Frame, map: &Map, scale: &Scale) {
    let mut lines = vec![format!("{} tests in all", grouped(map.total()))];
    // and what it consists of, at most two kinds; a slide has no room for small print
    let mut below = 1.0;
    if sheet.width == Width::Book {
        lines.extend(map.parts());
        below = 3.0;
    }
    let line = sheet.line_height();
    let room = Frame {
        min: frame.min + DVec2::new(0.0, line),
        max: frame.max - DVec2::new(0.0, (below + 0.5) * line),
    };
    let colours = map.tests.iter();
    let colours = colours.map(|tests| Some(colour(scale.share((*tests).into()))));
    let image = Image::new(figure.scene.camera.pixels, colours.collect()).in_squares();
    let whole = picture::draw_image(sheet, room, image);
    let middle = whole.middle().x;
    let above = DVec2::new(middle, whole.min.y - 0.5 * line);
    sheet.text(Anchor::Middle, above, &map.name);
    for (place, text) in (0..).zip(lines) {
        let below = DVec2::new(middle, whole.max.y + (f64::from(place) + 0.75) * line);
        sheet.text(Anchor::Middle, below, text);
    }
}

/// The colours of the scale as a bar, with its numbers.
fn legend(sheet: &mut Sheet, bar: Frame, scale: &Scale) {
    let number = |tick: &u128| grouped_sum(*tick);
    let numbers = scale
        .ticks
        .iter()
        .map(|tick| (scale.share(*tick), number(tick)));
    let what = if scale.is_logarithmic {
        "tests for each pixel: of objects, bounds, nodes and cells (logarithmic)"
    } else {
        "tests for each pixel: of objects, bounds, nodes and cells"
    };
    scale_bar::draw(sheet, bar, &numbers.collect::<Vec<_>>(), what);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(tests: &[u64]) -> Map {
        Map {
            name: String::new(),
            tests: tests.into(),
            sums: [tests.iter().sum(), 0, 0],
        }
    }

    #[test]
    fn numbers_near_each_other_have_a_linear_scale_from_0() {
        let scale = Scale::of(&[map(&[100, 120]), map(&[30, 200])]);
        assert_eq!(scale.ticks, [0, 50, 100, 150, 200]);
        assert_eq!(
            [0, 50, 200].map(|tests| scale.share(tests)),
            [0.0, 0.25, 1.0]
        );
    }

    #[test]
    fn numbers_far_apart_have_a_scale_on_which_equal_ratios_are_equal() {
        let scale = Scale::of(&[map(&[1000, 100]), map(&[0, 12])]);
        assert_eq!(scale.ticks[0], 1);
        assert_eq!(scale.ticks.last(), Some(&1000));
        let shares = [0, 1, 10, 100, 1000].map(|tests| scale.share(tests));
        let expected = [0.0, 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
        let apart = shares.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-12, "{shares:?}");
        assert_eq!(Scale::of(&[map(&[0, 0])]).share(0), 0.0);
    }
}
