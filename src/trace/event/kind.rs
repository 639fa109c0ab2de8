//! How a kind is found by its name, and when it happens.

use crate::trace::event::place::KindPlace;
use crate::trace::event::table::Kind;

impl Kind {
    /// Does it happen while a structure is built, before the first pixel?
    pub const fn is_of_building(self) -> bool {
        matches!(self.place(), KindPlace::Building)
    }

    /// The kind without which this one cannot be read: a test of a slab takes S and T from its `slab_ray`.
    pub const fn needs(self) -> Option<Self> {
        match self {
            Self::SlabTest => Some(Self::SlabRay),
            _ => None,
        }
    }

    /// The kind with a name of the log.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}
