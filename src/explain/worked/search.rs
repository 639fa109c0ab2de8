//! The search for the objects that a ray may hit: which function writes which step.

use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::{Course, Step, Told};
use crate::explain::worked::{aligned, cells, nodes, volumes};
use crate::trace::{Event, Kind};

/// With at most this many slab tests on a ray each is worked out; with more only if all are asked for.
const SLABS_IN_FULL: usize = 24;

/// What is known of the ray at a step of the search, whether the step is written or not.
pub(super) fn before_step(context: &Context, step: &Step, course: &mut Course) {
    let Step::Search(event) = step else {
        return;
    };
    course.follow_slabs(event);
    if let Event::GridEnter(enter) = event {
        course.grid = cells::grid_along(context, enter, course);
    }
}

/// One step of the search.
pub(super) fn search(context: &Context, event: &Event, course: &Course, page: &mut Pen) {
    if !context.shows(event.kind()) {
        return;
    }
    match event {
        // S and T of a slab that is tested are written with the test
        Event::SlabRay(line) if !context.shows(Kind::SlabTest) => {
            volumes::slab_ray(line, course, page);
        }
        Event::SlabTest(test) if course.slabs_in_full => {
            volumes::slab_test(context, test, course, page);
        }
        Event::BoundTest(test) => volumes::bound_test(context, test, course, page),
        Event::Node(visit) => nodes::node(context, visit, course, page),
        Event::Queue(step) => nodes::queue(step, course, page),
        Event::GridEnter(enter) => page.of_part(Part::Grid, |page| {
            cells::grid_enter(context, enter, course, page);
        }),
        Event::Cell(cell) => cells::cell(cell, course, page),
        Event::Mailbox { object } => cells::mailbox(context, *object, page),
        Event::HitOutsideCell(hit) => cells::hit_outside_cell(hit, page),
        Event::GridExit(exit) => cells::grid_exit(*exit, course, page),
        Event::Align(frame) => {
            page.of_part(Part::Alignment, |page| aligned::align(context, frame, page));
        }
        Event::Aligned(point) => page.of_part(Part::AlignedPoint, |page| {
            aligned::aligned(context, point, page);
        }),
        Event::ZSort(sorted) => page.of_part(Part::ZSort, |page| {
            aligned::z_sort(context, sorted, course, page);
        }),
        // the test of an object on a cell's list follows, or its mailbox
        _ => {}
    }
}

/// Are the slabs of a ray worked out one by one?
pub(super) fn slabs_in_full(context: &Context, steps: &[Told]) -> bool {
    let is_slab = |told: &&Told| matches!(told.step, Step::Search(Event::SlabTest(_)));
    context.options.all || steps.iter().filter(is_slab).count() <= SLABS_IN_FULL
}
