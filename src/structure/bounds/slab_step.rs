//! One slab of a bound against a ray: its near and far t, and whether the next slab is looked at.
//!
//! Slides, "Optimizing Intersection Calculations": the maximum of the near values of t and the minimum of the far ones
//! are "updated as each of its slabs is processed, and the processing of the bound terminated if the former ever
//! exceeds the latter".

use crate::geometry::{SlabInterval, SlabRay, TRange};
use crate::structure::bounds::extremes::{larger, smaller};

/// What became of a bound at one of its slabs?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SlabOutcome {
    /// Near and far have not crossed: the next slab is looked at.
    #[default]
    GoesOn,
    /// The largest near is above the smallest far: the ray misses the bound.
    Null,
    /// The ray is parallel to the slab and inside it.
    ParallelInside,
    /// The ray is parallel to the slab and outside of it: it misses the bound.
    ParallelOutside,
}

/// One slab of a bound against a ray. Near and far are those of the slab with its room: they decide.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlabStep {
    /// Which direction of the set, from 0.
    pub slab: u32,
    /// D of the plane that is furthest along the normal, without room.
    pub d_min: f64,
    /// D of the plane that is furthest back, without room.
    pub d_max: f64,
    /// By how much either plane is moved outwards for rounding: a length.
    pub room: f64,
    /// The near and the far t of this slab, with its room.
    pub interval: SlabInterval,
    /// The largest near of the slabs up to this one; −∞ if the ray is parallel to all of them.
    pub max_near: f64,
    /// The smallest far of the slabs up to this one; ∞ if the ray is parallel to all of them.
    pub min_far: f64,
    /// Whether the next slab is looked at.
    pub outcome: SlabOutcome,
}

/// Where a ray is inside a bound: from the largest near to the smallest far; nowhere if these have crossed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// The largest of the near values.
    pub near: f64,
    /// The smallest of the far values.
    pub far: f64,
}

impl Inside {
    /// Before the first slab: every t.
    pub const EVERYWHERE: Self = Self {
        near: f64::NEG_INFINITY,
        far: f64::INFINITY,
    };

    /// Is any of it in the range? Equality counts.
    #[inline]
    pub fn meets(&self, range: TRange) -> bool {
        self.begins(range) <= smaller(self.far, range.max)
    }

    /// Where the ray comes into it: not before its own range begins.
    #[inline]
    pub fn begins(&self, range: TRange) -> f64 {
        larger(self.near, range.min)
    }

    /// Have both ends crossed?
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.far < self.near
    }

    /// Both ends, unless they have crossed.
    pub fn ends(&self) -> Option<[f64; 2]> {
        (!self.is_empty()).then_some([self.near, self.far])
    }
}

impl SlabStep {
    /// Where the ray is inside the slabs up to this one; `None` if it misses the bound.
    pub fn inside(&self) -> Option<Inside> {
        match self.outcome {
            SlabOutcome::Null | SlabOutcome::ParallelOutside => None,
            SlabOutcome::GoesOn | SlabOutcome::ParallelInside => Some(Inside {
                near: self.max_near,
                far: self.min_far,
            }),
        }
    }

    /// The step as it would be without room: what the slab itself says. `line` is S and T for its direction, `before` the
    /// slab before it, without room.
    ///
    /// Words and figures show this; what decided is the step with its room.
    #[must_use]
    pub fn without_room(&self, line: &SlabRay, before: Option<&Self>) -> Self {
        let so_far = before.map_or(Inside::EVERYWHERE, |before| Inside {
            near: before.max_near,
            far: before.min_far,
        });
        Self { room: 0.0, ..*self }.decided(line, so_far)
    }

    /// Fills in near and far, and what follows from them.
    pub(in crate::structure) fn decided(self, line: &SlabRay, so_far: Inside) -> Self {
        let interval = line.interval_with_room(self.d_min, self.d_max, self.room);
        let inside = match interval {
            SlabInterval::Between { near, far } => Inside {
                near: so_far.near.max(near),
                far: so_far.far.min(far),
            },
            SlabInterval::ParallelInside | SlabInterval::ParallelOutside => so_far,
        };
        let outcome = match interval {
            SlabInterval::ParallelOutside => SlabOutcome::ParallelOutside,
            _ if inside.is_empty() => SlabOutcome::Null,
            SlabInterval::ParallelInside => SlabOutcome::ParallelInside,
            SlabInterval::Between { .. } => SlabOutcome::GoesOn,
        };
        Self {
            interval,
            max_near: inside.near,
            min_far: inside.far,
            outcome,
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INSIDE: Inside = Inside {
        near: 2.0,
        far: 5.0,
    };

    #[test]
    fn a_stretch_meets_a_range_that_begins_where_it_ends_or_ends_where_it_begins() {
        let meets = |min, max| INSIDE.meets(TRange { min, max });
        assert!(meets(0.0, 2.0) && meets(5.0, 9.0) && meets(3.0, 4.0) && meets(0.0, 9.0));
        assert!(!meets(0.0, 1.9) && !meets(5.1, 9.0));
    }

    #[test]
    fn it_begins_where_the_ray_enters_or_where_its_range_begins() {
        let begins = |min| INSIDE.begins(TRange { min, max: 9.0 });
        assert_eq!((begins(0.0), begins(3.0)), (2.0, 3.0));
    }

    #[test]
    fn it_is_empty_once_its_ends_have_crossed() {
        let point = Inside {
            near: 2.0,
            far: 2.0,
        };
        assert!(!point.is_empty());
        assert_eq!(point.ends(), Some([2.0, 2.0]));
        let crossed = Inside {
            near: 2.0,
            far: 1.9,
        };
        assert!(crossed.is_empty());
        assert_eq!(crossed.ends(), None);
    }
}
