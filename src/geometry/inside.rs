//! What slabs have in common along a ray: from the largest near to the smallest far.
//!
//! Slides, "Optimizing Intersection Calculations" (Fig. 15.58): the ray is inside a bound from the maximum of the near
//! values of t to the minimum of the far ones, both "updated as each of its slabs is processed". A box, a bound of slabs
//! and the box of a grid are all met by this rule, and so is a line cut at a frame.

use crate::geometry::extremes::{larger, smaller};
use crate::geometry::{SlabInterval, TRange};

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

    /// Outside of a slab: no t.
    pub const NOWHERE: Self = Self {
        near: f64::INFINITY,
        far: f64::NEG_INFINITY,
    };

    /// What is left of it inside one more slab: near = max(near, nearᵢ), far = min(far, farᵢ).
    ///
    /// A slab that the ray is parallel to and inside of changes nothing; one that it is outside of leaves nothing.
    ///
    /// ```
    /// use raystep::geometry::{Inside, SlabInterval};
    ///
    /// let x = SlabInterval::Between { near: 1.0, far: 4.0 };
    /// let y = SlabInterval::Between { near: 2.0, far: 9.0 };
    /// let both = Inside::EVERYWHERE.and(x).and(y);
    /// assert_eq!(both, Inside { near: 2.0, far: 4.0 });
    /// assert!(both.and(SlabInterval::ParallelOutside).is_empty());
    /// ```
    #[inline]
    #[must_use]
    pub fn and(self, slab: SlabInterval) -> Self {
        match slab {
            SlabInterval::Between { near, far } => Self {
                near: self.near.max(near),
                far: self.far.min(far),
            },
            SlabInterval::ParallelInside => self,
            SlabInterval::ParallelOutside => Self::NOWHERE,
        }
    }

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

#[cfg(test)]
mod tests {
    use super::*;

    fn between(near: f64, far: f64) -> SlabInterval {
        SlabInterval::Between { near, far }
    }

    #[test]
    fn slabs_have_in_common_what_is_in_each_of_them_in_any_order() {
        let slabs = [between(1.0, 5.0), between(-2.0, 4.0), between(3.0, 9.0)];
        for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
            let all = order.map(|i| slabs[i]);
            let inside = all.into_iter().fold(Inside::EVERYWHERE, Inside::and);
            assert_eq!(inside.ends(), Some([3.0, 4.0]));
        }
    }

    #[test]
    fn slabs_that_touch_in_one_t_have_that_in_common_and_slabs_apart_nothing() {
        let inside = Inside::EVERYWHERE.and(between(1.0, 2.0));
        assert_eq!(inside.and(between(2.0, 3.0)).ends(), Some([2.0, 2.0]));
        assert_eq!(inside.and(between(2.5, 3.0)).ends(), None);
    }

    #[test]
    fn a_parallel_slab_leaves_all_or_nothing() {
        let inside = Inside::EVERYWHERE.and(between(1.0, 2.0));
        assert_eq!(inside.and(SlabInterval::ParallelInside), inside);
        let nothing = inside.and(SlabInterval::ParallelOutside);
        // what comes later brings nothing back
        assert!(nothing.and(between(-9.0, 9.0)).is_empty());
        assert!(
            Inside::EVERYWHERE
                .and(SlabInterval::ParallelOutside)
                .is_empty()
        );
    }

    const INSIDE: Inside = Inside {
        near: 2.0,
        far: 5.0,
    };

    #[test]
    fn it_meets_a_range_that_begins_where_it_ends_or_ends_where_it_begins() {
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
