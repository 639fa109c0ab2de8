//! The search for what a ray meets: which step is told where.

use crate::explain::worked::Solution;
use crate::explain::worked::steps::{Course, Step};
use crate::trace::{BoundOutcome, Bounded, Event, Kind, QueueAction};

/// Up to so many slabs on a ray each is worked out; from more of them on only if all are asked for.
const SLABS_IN_FULL: usize = 24;

impl Solution<'_> {
    /// One step of the search, and what is known after it.
    pub(super) fn search_step(&mut self, event: &Event, course: &mut Course) {
        course.follow_slabs(event);
        if let Event::GridEnter(enter) = event {
            course.grid = self.grid_along(enter, course);
        }
        self.search(event, course);
        course.last = Some(*event);
    }

    /// One step of the search.
    fn search(&mut self, event: &Event, course: &Course) {
        if !self.shows(event.kind()) {
            return;
        }
        match event {
            // of a slab that is tested S and T are told with the test
            Event::SlabRay(line) if !self.shows(Kind::SlabTest) => self.slab_ray(line, course),
            Event::SlabTest(test) if course.slabs_in_full => self.slab_test(test, course),
            Event::BoundTest(test) => self.bound_test(test, course),
            Event::Node(visit) => self.node(visit, course),
            Event::Queue(step) => self.queue(step, course),
            Event::GridEnter(enter) => self.grid_enter(enter, course),
            Event::Cell(cell) => self.cell(cell, course),
            Event::Mailbox { object } => self.mailbox(*object),
            Event::HitOutsideCell(hit) => self.hit_outside_cell(hit),
            Event::GridExit(exit) => self.grid_exit(*exit, course),
            Event::Align(frame) => self.align(frame),
            Event::Aligned(point) => self.aligned(point),
            Event::ZSort(sorted) => self.z_sort(sorted, course),
            // of an object on a cell's list its test is told next, or its mailbox
            _ => {}
        }
    }

    /// Are the slabs of a ray worked out one by one?
    pub(super) fn slabs_in_full(&self, steps: &[Step]) -> bool {
        let is_slab = |step: &&Step| matches!(step, Step::Search(Event::SlabTest(_)));
        self.options.all || steps.iter().filter(is_slab).count() <= SLABS_IN_FULL
    }
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

/// Kinds that tell how a structure was built.
pub(super) const BUILDING: [Kind; 2] = [Kind::Merge, Kind::Assign];
