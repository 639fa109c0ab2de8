//! The worked solution of a pixel: every ray and every line of arithmetic, as a tutor writes it.
//!
//! It walks the tree of rays that the records make and writes each step where it happened. A test that
//! hits is worked out in full, one that misses in a line or two; where a ray meets many objects, most of
//! its misses are summed up unless all are asked for.

mod aligned;
mod arrival;
mod carried;
mod cells;
mod leaves;
mod misses;
mod nodes;
mod polygon;
mod quadratic;
mod ray;
mod search;
mod shade;
mod slabs;
mod steps;
mod volumes;

use std::cell::OnceCell;

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::{Page, Tone, printable};
use crate::explain::worked::leaves::Leaves;
use crate::explain::worked::search::BUILDING;
use crate::scene::{PrimitiveId, Scene};
use crate::trace::{
    Event, Item, Kind, Kinds, PixelColour, PixelSample, RayTree, Record, Settings, StrategyName,
    Through, Transport,
};

/// What of the working is printed, and how.
#[derive(Clone, Copy, Debug)]
pub struct WorkedOptions {
    /// The kinds of event.
    pub kinds: Kinds,
    /// One ray alone.
    pub ray: Option<u32>,
    /// Every test in full, also where many miss.
    pub all: bool,
    /// With ANSI colours.
    pub colour: bool,
}

impl Default for WorkedOptions {
    fn default() -> Self {
        Self {
            kinds: Kinds::ALL,
            ray: None,
            all: false,
            colour: false,
        }
    }
}

/// The worked solution of a pixel, from its records alone; `scene` says what the objects are.
pub fn worked_solution(
    scene: &Scene,
    settings: &Settings,
    records: &[Record],
    options: &WorkedOptions,
) -> String {
    let mut solution = Solution {
        scene,
        settings,
        records,
        tree: RayTree::new(records),
        options,
        page: Page::new(options.colour),
    };
    solution.write();
    solution.page.into_text()
}

/// What a solution is written from, and the page it is written on.
struct Solution<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    records: &'a [Record],
    tree: RayTree,
    options: &'a WorkedOptions,
    page: Page,
}

impl Solution<'_> {
    fn write(&mut self) {
        self.title();
        if let Some(id) = self.options.ray {
            if let Some(place) = self.tree.find(id) {
                self.page.gap();
                self.ray(place);
            }
            return;
        }
        self.building();
        let mut colours = Vec::new();
        for item in self.tree.items.clone() {
            match item {
                Item::Ray(place) => {
                    self.page.gap();
                    self.ray(place);
                    colours.extend(self.tree.rays[place].end.and_then(|end| end.colour));
                }
                Item::Event(at) => match self.records[at].event {
                    Event::Pixel(sample) => self.window_point(&sample),
                    Event::PixelColour(colour) => self.pixel_colour(&colour, &colours),
                    _ => {}
                },
            }
        }
    }

    /// How the structure was built, if that was recorded; in part, unless all is asked for.
    fn building(&mut self) {
        /// More lines than a screen has would hide the pixel.
        const SHOWN: usize = 24;
        let built: Vec<Event> = self
            .records
            .iter()
            .map(|record| record.event)
            .filter(|event| BUILDING.contains(&event.kind()) && self.shows(event.kind()))
            .collect();
        if built.is_empty() {
            return;
        }
        let shown = if self.options.all { built.len() } else { SHOWN };
        self.page.gap();
        self.page.line(Tone::Heading, "Built before the first ray");
        self.page.indent();
        let leaves = OnceCell::new();
        for event in built.iter().take(shown) {
            match event {
                Event::Merge(step) => self.merge(step, leaves.get_or_init(|| Leaves::of(self))),
                Event::Assign(step) => self.assign(step),
                _ => {}
            }
        }
        if let Some(more) = built.len().checked_sub(shown).filter(|&more| 0 < more) {
            let text = format!("… {} (--all tells them)", count(more, "more step"));
            self.page.line(Tone::Aside, text);
        }
        self.page.outdent();
    }

    fn shows(&self, kind: Kind) -> bool {
        self.options.kinds.contains(kind)
    }

    fn title(&mut self) {
        let [width, height] = self.scene.camera.pixels;
        let mut title = String::from("Pixel");
        if let Some([x, y]) = self.records.iter().find_map(|record| record.pixel) {
            title = format!("Pixel ({x}, {y})");
        }
        if !self.scene.name.is_empty() {
            title = format!("{title} of \"{}\"", printable(&self.scene.name));
        }
        self.page.line(Tone::Heading, title);
        let transport = match self.settings.transport {
            Transport::Backward => "backward, without rays to the lights",
            Transport::HybridLight => "backward with rays to the lights",
            Transport::Forward => "forward, from the lights into the eye",
            Transport::HybridStored => "forward, stored on the surfaces, then backward",
            Transport::HybridConnected => "forward and backward, with connecting lines",
        };
        let objects = self.scene.primitives.len();
        let sides = if self.settings.one_sided {
            "; opaque surfaces show only their front"
        } else {
            ""
        };
        self.page.line(
            Tone::Aside,
            format!(
                "{width} × {height} pixels, traced {transport}, each ray tested against {}{}, \
                 depth up to {}{sides}",
                count(objects, "object"),
                how(self.settings),
                self.scene.max_depth
            ),
        );
        if matches!(
            self.settings.strategy,
            StrategyName::Bounds
                | StrategyName::Hierarchy
                | StrategyName::Heap
                | StrategyName::Grid
        ) {
            let note = "what is around objects is wider than they are by some 1e-10 of the coordinates, \
                        so that rounding cuts nothing off";
            self.page.line(Tone::Aside, note);
        }
        if let Some(only) = &self.settings.only {
            let note = format!("the log holds only: {}", only.join(", "));
            self.page.line(Tone::Aside, note);
        }
    }

    /// P = corner + (x/width)·right + (1 − y/height)·up
    fn window_point(&mut self, sample: &PixelSample) {
        if !self.shows(Kind::Pixel) {
            return;
        }
        let d = Digits::USUAL;
        let camera = &self.scene.camera;
        let [width, height] = camera.pixels;
        self.page.gap();
        let place = match self.settings.through {
            Through::Centres => "The pixel's centre on the window".into(),
            Through::Corners => {
                format!(
                    "Corner {} of {} on the window",
                    sample.sample + 1,
                    sample.samples
                )
            }
        };
        self.page.line(Tone::Heading, place);
        let (across, down) = (
            sample.place.x / f64::from(width),
            1.0 - sample.place.y / f64::from(height),
        );
        // an eye far from the origin: as many digits as P - COP needs
        let to_window = (sample.point - camera.cop).length();
        let d_point = Digits::for_difference(sample.point.abs().max_element(), to_window);
        let lines = [
            format!(
                "{} pixels from the left and {} from the top, of {width} × {height}",
                d.number(sample.place.x),
                d.number(sample.place.y)
            ),
            format!(
                "P = corner + {}/{width}·right + (1 - {}/{height})·up",
                d.number(sample.place.x),
                d.number(sample.place.y)
            ),
            format!(
                "  = {} + {}·{} + {}·{}",
                d_point.vector(camera.corner()),
                d.number(across),
                d.vector(camera.right),
                d.number(down),
                d.vector(camera.up)
            ),
            format!("  = {}", d_point.vector(sample.point)),
        ];
        self.page.indented(|page| {
            for line in lines {
                page.plain(line);
            }
        });
    }

    fn pixel_colour(&mut self, colour: &PixelColour, of_rays: &[DVec3]) {
        if !self.shows(Kind::PixelColour) {
            return;
        }
        let d = Digits::USUAL;
        self.page.gap();
        self.page.line(Tone::Heading, "The pixel's colour");
        let mut lines = Vec::new();
        if 1 < of_rays.len() {
            let terms: Vec<_> = of_rays.iter().map(|&c| d.vector(c)).collect();
            lines.push(format!(
                "the mean of its {} eye rays: [{}] / {} = {}",
                of_rays.len(),
                terms.join(" + "),
                of_rays.len(),
                d.vector(colour.raw)
            ));
        } else {
            lines.push(format!(
                "what the eye ray brings back: {}",
                d.vector(colour.raw)
            ));
        }
        if colour.raw != colour.clamped {
            lines.push(format!("cut to 0..1: {}", d.vector(colour.clamped)));
        }
        let [r, g, b] = (colour.clamped * 255.0).round().to_array();
        lines.push(format!("in the picture, times 255: ({r}, {g}, {b})"));
        self.page.indented(|page| {
            for line in lines {
                page.plain(line);
            }
        });
    }

    /// A primitive as it is called in the text.
    fn name(&self, id: PrimitiveId) -> String {
        match self.scene.name_of(id) {
            (name, None) => printable(name),
            (name, Some(face)) => format!("{} face {face}", printable(name)),
        }
    }
}

/// Which of the objects a ray is tested against.
fn how(settings: &Settings) -> &'static str {
    match settings.strategy {
        StrategyName::Exhaustive => "",
        StrategyName::Bounds => " whose bounding volumes it meets",
        StrategyName::Hierarchy => " in a hierarchy, walked depth first",
        StrategyName::Heap => " in a hierarchy, walked by distance",
        StrategyName::Grid => " in the cells of a grid",
        StrategyName::ZAligned => " in a frame in which it is the z axis",
    }
}

/// A number of things: `1 object`, `4 objects`.
fn count(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}
