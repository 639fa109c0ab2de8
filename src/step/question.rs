//! The question that a step asks before it shows its verdict.
//!
//! The right choice is computed from the event, and so are the wrong ones, by the mistakes of students
//! ([`mistake`](crate::mistake)) or as the other things that might happen. Where the printed numbers do not decide, or where nothing is
//! there to be decided, no question is asked. A file for each subject.

mod at;
mod bound;
mod choice;
mod grid;
mod node;
mod object_hit;
mod plane;
mod polygon;
mod refraction;
mod root;
mod shade;
mod shadow;
mod slab;

pub use choice::{Asks, Choice, LETTERS, Question};

use crate::step::level::Level;
use crate::step::question::at::At;
use crate::step::tree::StepLog;
use crate::trace::{Event, QueueAction};

impl StepLog<'_> {
    /// The question of a step; `None` if it has no good one.
    ///
    /// Of a test of several events the question is about all of them, and each event by itself may have another one. A fold
    /// has none.
    pub fn question(&self, number: usize) -> Option<Question> {
        let step = self.step(number);
        if step.is_fold() {
            return None;
        }
        if step.is_leaf() {
            return self.of_event(number);
        }
        let events = &self.records[step.events.clone()];
        let lead = &self.records[step.lead].event;
        match step.level {
            Level::Ray => shadow::blocked(&At::new(self, number, step.events.start)),
            Level::Place => match (&events[0].event, lead) {
                (Event::Queue(queue), _) if queue.action == QueueAction::Pop => {
                    node::next_node(&At::new(self, number, step.events.start), queue)
                }
                (_, Event::Cell(cell)) => {
                    grid::next_plane(&At::new(self, number, step.lead), &cell.step)
                }
                (_, Event::Node(visit)) => node::pruned(&At::new(self, number, step.lead), visit),
                _ => None,
            },
            Level::Test => {
                let at = At::new(self, number, step.events.start);
                match (&events[0].event, lead) {
                    (Event::Listed { object }, _) => grid::mailbox(&at, *object),
                    (_, Event::BoundTest(test)) => {
                        let at = At::new(self, number, step.lead);
                        slab::that_ends(&at, test).or_else(|| bound::verdict(&at, test))
                    }
                    (_, Event::PlaneTest { .. }) => events.iter().find_map(|record| {
                        let Event::PolygonTest { object, test } = &record.event else {
                            return None;
                        };
                        polygon::dropped_axis(&at, *object, test)
                    }),
                    _ => self.of_event(self.leaf(step.lead)),
                }
            }
            Level::Section | Level::Term => None,
        }
    }

    /// The question of a single event.
    fn of_event(&self, leaf: usize) -> Option<Question> {
        let event = self.step(leaf).events.start;
        let at = At::new(self, leaf, event);
        match &self.records[event].event {
            Event::SphereTest { object, test }
            | Event::EllipsoidTest { object, test }
            | Event::ConeTest { object, test } => root::of_quadratic(&at, *object, test),
            Event::BoxTest { object, test } => root::of_box(&at, *object, test),
            Event::PlaneTest { object, test } => plane::t(&at, *object, test),
            Event::PolygonTest { object, test } => polygon::inside(&at, *object, test),
            Event::BoundTest(test) => bound::verdict(&at, test),
            Event::Node(visit) => node::pruned(&at, visit),
            Event::Queue(queue) if queue.action == QueueAction::Pop => node::next_node(&at, queue),
            Event::Cell(cell) => grid::next_plane(&at, &cell.step),
            Event::Nearest(hit) => grid::hit_is_final(&at, hit),
            Event::LightTerm(term) => shade::zero_terms(&at, term),
            Event::Refraction(refraction) => refraction::total(&at, refraction),
            _ => None,
        }
    }
}
