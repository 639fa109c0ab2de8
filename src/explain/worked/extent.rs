//! Which events a line is about, by their places among the records.

/// From a first record to a last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Extent {
    pub(super) first: usize,
    pub(super) last: usize,
}

impl Extent {
    /// One record.
    pub(super) fn at(place: usize) -> Self {
        Self {
            first: place,
            last: place,
        }
    }

    /// From the first record of the two to the last.
    pub(super) fn to(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }

    /// From the first to the last of several; `None` of none.
    pub(super) fn around(extents: impl IntoIterator<Item = Self>) -> Option<Self> {
        extents.into_iter().reduce(Self::to)
    }
}
