//! How much a step holds.

use std::fmt;

/// How much a step holds, from the most to the least.
///
/// Rays nest: a ray holds the rays that it spawned. A single event has the level of what it is by itself: a sphere's test
/// is a test, a pruned node a place, all else a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// The building of the structure, a path of light, or the pixel.
    Section,
    /// A ray.
    Ray,
    /// A node of the hierarchy that is visited, or a cell of the grid.
    Place,
    /// The test of an object or a bounding volume, with the events that belong to it.
    Test,
    /// One event: an edge, a slab, a light's term, the start of a ray.
    Term,
}

impl Level {
    /// All levels, from the most to the least.
    pub const ALL: [Self; 5] = [
        Self::Section,
        Self::Ray,
        Self::Place,
        Self::Test,
        Self::Term,
    ];

    /// The level below; a term has none and stays one.
    pub(in crate::step) fn below(self) -> Self {
        match self {
            Self::Section => Self::Ray,
            Self::Ray => Self::Place,
            Self::Place => Self::Test,
            Self::Test | Self::Term => Self::Term,
        }
    }

    /// The name that people read.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Section => "section",
            Self::Ray => "ray",
            Self::Place => "place",
            Self::Test => "test",
            Self::Term => "term",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
