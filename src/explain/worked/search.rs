//! The search for what a ray meets: bounds, nodes, cells, alignment.

use crate::explain::worked::Solution;
use crate::explain::worked::steps::Course;
use crate::trace::Event;

impl Solution<'_> {
    /// One step of the search.
    pub(super) fn search(&mut self, event: &Event, course: &Course) {
        let _ = (event, course);
    }
}
