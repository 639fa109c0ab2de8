//! The worked solution of a pixel: every ray and every line of arithmetic, as a tutor writes it.
//!
//! First come the paths of light that led to the pixel, if light was followed, then the pixel itself. Of each it
//! walks the tree of rays that the records make and writes each step where it happened. A test that
//! hits is worked out in full, one that misses in a line or two; where a ray hits many objects, most of
//! its misses are summed up unless all are asked for.

mod aligned;
mod arrival;
mod bare;
mod building;
mod built_again;
mod cells;
mod connection;
mod context;
mod extent;
mod gathered;
mod joined;
mod known_path;
mod leaves;
mod light_path;
mod misses;
mod nodes;
pub(crate) mod options;
mod pen;
mod photon;
mod pixel;
mod polygon;
mod quadratic;
mod ray;
mod ray_start;
mod roots;
mod search;
mod seen;
mod settle;
mod shade;
mod slabs;
mod steps;
mod title;
mod vertex;
mod volumes;
mod weight;

pub(crate) use options::WorkedOptions;

use std::collections::BTreeMap;
use std::ops::Range;

use crate::explain::page::Page;
use crate::explain::worked::built_again::BuiltAgain;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::known_path::KnownPath;
use crate::explain::worked::pen::{Pen, Wanted};
use crate::scene::Scene;
use crate::trace::{Record, Settings};

/// The worked solution of a pixel, from its records alone; `scene` says what the objects are.
///
/// Each event belongs to the steps of one line or more, but for a heading's: lines about the same events have the same
/// steps, and other lines have others. With some `kinds` or one `ray` alone that holds for the events of these.
pub fn worked_solution(
    scene: &Scene,
    settings: &Settings,
    records: &[Record],
    options: &WorkedOptions,
) -> Page {
    let sections = Sections::of(records);
    let known = KnownPath::all(records);
    let again = BuiltAgain::default();
    let context = Context::new(scene, settings, options, &known, &again, records);

    let mut page = Pen::default();
    title::title(&context, &mut page);
    let mut of_page = 0..records.len();
    if let Some(ray) = options.ray {
        let shown = pixel::one_ray(&context.section(sections.pixel), ray, &mut page);
        of_page = shown.map_or(0..0, |shown| shown.first..shown.last + 1);
    } else {
        sections.write(&context, &mut page);
    }
    let is_shown = |place: usize| options.kinds.contains(records[place].event.kind());
    settle::settle(page.into_drafts(), records, of_page, is_shown)
}

/// Writes the worked solution of a pixel a few steps at a time, as a stepper asks for it.
#[derive(Debug)]
pub(crate) struct WorkedSteps<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    records: &'a [Record],
    options: WorkedOptions,
    known: BTreeMap<u32, KnownPath>,
    again: BuiltAgain,
}

impl<'a> WorkedSteps<'a> {
    /// Of the records of a pixel.
    pub(crate) fn new(scene: &'a Scene, settings: &'a Settings, records: &'a [Record]) -> Self {
        Self {
            scene,
            settings,
            records,
            options: WorkedOptions {
                all: true,
                ..WorkedOptions::default()
            },
            known: KnownPath::all(records),
            again: BuiltAgain::default(),
        }
    }

    /// The lines of the worked solution that are about some of the records, every test in full, with the headings above
    /// them.
    ///
    /// They are those of [`worked_solution`] with [`WorkedOptions::all`] and have the same steps, but for its title, and for
    /// what it says once on a page: here that stands at each of its places. An event without words of its own belongs to
    /// the step before it or after it, so `ranges` hold the neighbours of what is asked for.
    pub(crate) fn lines(&self, ranges: &[Range<usize>]) -> Page {
        let wanted = Wanted::new(ranges);
        self.written(Some(wanted.clone()), |place| {
            wanted.meets(Extent::at(place))
        })
    }

    /// The same lines about all records, in one go: each is as [`WorkedSteps::lines`] has it.
    pub(crate) fn all_lines(&self) -> Page {
        self.written(None, |_| true)
    }

    fn written(&self, wanted: Option<Wanted>, is_shown: impl Fn(usize) -> bool) -> Page {
        let Self {
            scene,
            settings,
            records,
            options,
            known,
            again,
        } = self;
        let context = Context::new(scene, settings, options, known, again, records);
        let mut page = Pen::of_events(wanted);
        Sections::of(records).write(&context, &mut page);
        settle::settle(page.into_drafts(), records, 0..records.len(), is_shown)
    }
}

/// Where the sections of a pixel's records are: what is built comes first, then the paths; all that follows is the pixel's.
struct Sections {
    building: Range<usize>,
    paths: Range<usize>,
    pixel: Range<usize>,
}

impl Sections {
    fn of(records: &[Record]) -> Self {
        let built = length(records, |record| record.event.kind().is_of_building());
        let led = built + length(&records[built..], |record| record.path.is_some());
        Self {
            building: 0..built,
            paths: built..led,
            pixel: led..records.len(),
        }
    }

    /// All sections, one after the other.
    fn write(self, context: &Context, page: &mut Pen) {
        building::building(&context.section(self.building), page);
        light_path::light_paths(context, self.paths, page);
        pixel::pixel(&context.section(self.pixel), page);
    }
}

/// Of how many at the beginning something holds.
fn length(records: &[Record], holds: impl Fn(&Record) -> bool) -> usize {
    let first = records.iter().position(|record| !holds(record));
    first.unwrap_or(records.len())
}
