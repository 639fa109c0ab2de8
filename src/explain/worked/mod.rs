//! The worked solution of a pixel: every ray and every line of arithmetic, as a tutor writes it.
//!
//! First come the paths of light that led to the pixel, if light was followed, then the pixel itself. Of each it
//! walks the tree of rays that the records make and writes each step where it happened. A test that
//! hits is worked out in full, one that misses in a line or two; where a ray meets many objects, most of
//! its misses are summed up unless all are asked for.

mod aligned;
mod arrival;
mod bare;
mod cells;
mod connection;
mod gathered;
mod leaves;
mod light_path;
mod misses;
mod nodes;
mod photon;
mod pixel;
mod polygon;
mod quadratic;
mod ray;
mod ray_start;
mod search;
mod seen;
mod shade;
mod slabs;
mod steps;
mod title;
mod vertex;
mod volumes;
mod weight;

use std::cell::OnceCell;
use std::collections::BTreeMap;

use crate::explain::page::{Page, Tone};
use crate::explain::printable;
use crate::explain::worked::leaves::Leaves;
use crate::explain::worked::light_path::KnownPath;
use crate::explain::worked::search::BUILDING;
use crate::geometry::MOST_SLABS;
use crate::scene::{PrimitiveId, Scene};
use crate::structure::{BareGrid, Hierarchy};
use crate::trace::{Event, Kind, Kinds, RayTree, Record, Settings};

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
    let pixel = records.iter().find_map(|record| record.pixel);
    let mut solution = Solution {
        scene,
        settings,
        options,
        pixel,
        paths: KnownPath::all(records),
        records: &[],
        tree: RayTree::default(),
        hierarchy: OnceCell::new(),
        grid: OnceCell::new(),
        page: Page::new(options.colour),
    };
    solution.write(records);
    solution.page.into_text()
}

/// What a solution is written from, and the page it is written on.
struct Solution<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    options: &'a WorkedOptions,
    /// The pixel; a filtered log may hold nothing of it.
    pixel: Option<[u32; 2]>,
    /// The paths of light that led to it.
    paths: BTreeMap<u32, KnownPath>,
    /// The part that is told now: the building, a path of light, or the pixel.
    records: &'a [Record],
    /// Its rays, whose numbers begin at 0 in each part.
    tree: RayTree,
    /// The hierarchy, built again where the log says too little of its bounds.
    hierarchy: OnceCell<Hierarchy<MOST_SLABS>>,
    /// The grid without room, built again once it is asked for.
    grid: OnceCell<BareGrid>,
    page: Page,
}

impl<'a> Solution<'a> {
    fn write(&mut self, records: &'a [Record]) {
        // what is built comes first, then the paths; all that follows is the pixel's
        let is_built = |record: &Record| record.event.kind().is_of_building();
        let (building, traced) = split(records, is_built);
        let (paths, pixel) = split(traced, |record| record.path.is_some());

        self.title();
        if let Some(id) = self.options.ray {
            self.turn_to(pixel);
            return self.one_ray(id);
        }
        self.turn_to(building);
        self.building();
        self.light_paths(paths);
        self.turn_to(pixel);
        self.pixel();
    }

    /// What follows is told of these records.
    fn turn_to(&mut self, records: &'a [Record]) {
        self.records = records;
        self.tree = RayTree::new(records);
    }
}

/// Those at the beginning of which something holds, and the rest.
fn split(records: &[Record], holds: impl Fn(&Record) -> bool) -> (&[Record], &[Record]) {
    let first = records.iter().position(|record| !holds(record));
    records.split_at(first.unwrap_or(records.len()))
}

impl Solution<'_> {
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

    /// A primitive as it is called in the text.
    fn name(&self, id: PrimitiveId) -> String {
        match self.scene.name_of(id) {
            (name, None) => printable(name),
            (name, Some(face)) => format!("{} face {face}", printable(name)),
        }
    }
}

/// A number of things: `1 object`, `4 objects`.
fn count(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}
