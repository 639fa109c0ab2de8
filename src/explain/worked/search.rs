//! The search for what a ray meets: which step is told where.

use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::{Course, Step, Told};
use crate::explain::worked::{aligned, cells, nodes, volumes};
use crate::trace::{BoundOutcome, Bounded, Event, Kind, QueueAction};

/// Up to so many slabs on a ray each is worked out; from more of them on only if all are asked for.
const SLABS_IN_FULL: usize = 24;

/// One step of the search, and what is known after it.
pub(super) fn search_step(context: &Context, event: &Event, course: &mut Course, page: &mut Pen) {
    course.follow_slabs(event);
    if let Event::GridEnter(enter) = event {
        course.grid = cells::grid_along(context, enter, course);
    }
    search(context, event, course, page);
    course.last = Some(*event);
}

/// One step of the search.
fn search(context: &Context, event: &Event, course: &Course, page: &mut Pen) {
    if !context.shows(event.kind()) {
        return;
    }
    match event {
        // of a slab that is tested S and T are told with the test
        Event::SlabRay(line) if !context.shows(Kind::SlabTest) => {
            page.of_part(Part::SlabRay, |page| volumes::slab_ray(line, course, page));
        }
        Event::SlabTest(test) if course.slabs_in_full => {
            volumes::slab_test(context, test, course, page);
        }
        Event::BoundTest(test) => volumes::bound_test(context, test, course, page),
        Event::Node(visit) => {
            page.of_part(Part::Node, |page| nodes::node(context, visit, course, page));
        }
        Event::Queue(step) => page.of_part(Part::Heap, |page| nodes::queue(step, course, page)),
        Event::GridEnter(enter) => page.of_part(Part::Grid, |page| {
            cells::grid_enter(context, enter, course, page);
        }),
        Event::Cell(cell) => page.of_part(Part::Cell, |page| cells::cell(cell, course, page)),
        Event::Mailbox { object } => {
            page.of_part(Part::Mailbox, |page| cells::mailbox(context, *object, page));
        }
        Event::HitOutsideCell(hit) => {
            page.of_part(Part::HitOutside, |page| cells::hit_outside_cell(hit, page));
        }
        Event::GridExit(exit) => {
            page.of_part(Part::WalkEnd, |page| cells::grid_exit(*exit, course, page));
        }
        Event::Align(frame) => {
            page.of_part(Part::Alignment, |page| aligned::align(context, frame, page));
        }
        Event::Aligned(point) => page.of_part(Part::AlignedPoint, |page| {
            aligned::aligned(context, point, page);
        }),
        Event::ZSort(sorted) => page.of_part(Part::ZSort, |page| {
            aligned::z_sort(context, sorted, course, page);
        }),
        // of an object on a cell's list its test is told next, or its mailbox
        _ => {}
    }
}

/// Are the slabs of a ray worked out one by one?
pub(super) fn slabs_in_full(context: &Context, steps: &[Told]) -> bool {
    let is_slab = |told: &&Told| matches!(told.step, Step::Search(Event::SlabTest(_)));
    context.options.all || steps.iter().filter(is_slab).count() <= SLABS_IN_FULL
}

/// The node that was found not to count by this step, if it is one.
pub(super) fn refused_node(step: Option<&Event>) -> Option<u32> {
    match step {
        Some(Event::BoundTest(test)) if test.outcome != BoundOutcome::Hit => match test.of {
            Bounded::Node(node) => Some(node),
            Bounded::Object(_) => None,
        },
        Some(Event::Queue(step)) if step.action == QueueAction::Stop => Some(step.node),
        _ => None,
    }
}
