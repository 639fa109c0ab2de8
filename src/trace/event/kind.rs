//! How a kind is found by its name, and when it happens.

use crate::trace::event::place::KindPlace;
use crate::trace::event::table::Kind;

impl Kind {
    /// Does it happen while a structure is built, before the first pixel?
    pub const fn is_of_building(self) -> bool {
        matches!(self.place(), KindPlace::Building)
    }

    /// The kind with a name of the log.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}
