//! Light on its way, in words: what chance decided, what was stored and gathered, and the lines that connect.

use crate::explain::worked::Solution;
use crate::trace::Event;

impl Solution<'_> {
    /// One event of light on its way.
    pub(super) fn carried(&mut self, event: &Event) {
        self.page.plain(format!("{event:?}"));
    }
}
