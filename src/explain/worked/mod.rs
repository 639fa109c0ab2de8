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

use crate::explain::page::Page;
use crate::explain::worked::built_again::BuiltAgain;
use crate::explain::worked::context::Context;
use crate::explain::worked::known_path::KnownPath;
use crate::explain::worked::pen::Pen;
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
    // what is built comes first, then the paths; all that follows is the pixel's
    let built = length(records, |record| record.event.kind().is_of_building());
    let led = built + length(&records[built..], |record| record.path.is_some());
    let known = KnownPath::all(records);
    let again = BuiltAgain::default();
    let context = Context::new(scene, settings, options, &known, &again, records);

    let mut page = Pen::default();
    title::title(&context, &mut page);
    let mut of_page = 0..records.len();
    if let Some(ray) = options.ray {
        let shown = pixel::one_ray(&context.section(led..records.len()), ray, &mut page);
        of_page = shown.map_or(0..0, |shown| shown.first..shown.last + 1);
    } else {
        building::building(&context.section(0..built), &mut page);
        light_path::light_paths(&context, built..led, &mut page);
        pixel::pixel(&context.section(led..records.len()), &mut page);
    }
    settle::settle(page.into_drafts(), records, of_page, options.kinds)
}

/// Of how many at the beginning something holds.
fn length(records: &[Record], holds: impl Fn(&Record) -> bool) -> usize {
    let first = records.iter().position(|record| !holds(record));
    first.unwrap_or(records.len())
}
