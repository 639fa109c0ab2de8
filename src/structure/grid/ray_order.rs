//! Which of two planes does a ray hit first? Exactly.

use std::cmp::Ordering;

use crate::geometry::sign_of_sum;

/// Where a ray hits a plane across an axis: t = (plane − origin)/direction.
///
/// A plain t is the meeting of a ray from 0 along 1 with that plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meeting {
    /// The plane's coordinate.
    pub(crate) plane: f64,
    /// The origin's coordinate along the same axis.
    pub(crate) origin: f64,
    /// Δ along it, not 0.
    pub(crate) direction: f64,
}

impl Meeting {
    /// The t itself.
    #[inline]
    pub(crate) fn at(t: f64) -> Self {
        Self {
            plane: t,
            origin: 0.0,
            direction: 1.0,
        }
    }

    /// t, rounded twice.
    #[inline]
    pub(crate) fn t(&self) -> f64 {
        (self.plane - self.origin) / self.direction
    }

    /// Does this meeting come before the other, at the same t, or after it? Without rounding.
    #[inline]
    pub(crate) fn order(&self, other: &Self) -> Ordering {
        let (t, other_t) = (self.t(), other.t());
        if clearly_before(t, other_t) {
            return Ordering::Less;
        }
        if clearly_before(other_t, t) {
            return Ordering::Greater;
        }
        self.exact_order(other)
    }

    /// Is this meeting before the other?
    #[inline]
    pub(crate) fn before(&self, other: &Self) -> bool {
        self.order(other) == Ordering::Less
    }

    /// The sign of (p − o)·δ′ − (p′ − o′)·δ, turned where one of the directions is negative.
    #[cold]
    pub(crate) fn exact_order(&self, other: &Self) -> Ordering {
        let (own, others) = (self.direction, other.direction);
        let difference = sign_of_sum(&[
            [self.plane, others],
            [-self.origin, others],
            [-other.plane, own],
            [other.origin, own],
        ]);
        if (own < 0.0) == (others < 0.0) {
            difference
        } else {
            difference.reverse()
        }
    }
}

/// Two t in this order stay in it whatever their rounding was.
///
/// A t is rounded up to three times (the difference, 1/Δ, the product), so it is right within 2ε of itself.
const TOLERANCE: f64 = 8.0 * f64::EPSILON;

/// Below this, t loses digits to the limits of f64, and [`TOLERANCE`] says nothing.
const TINY: f64 = 1e-290;

/// Does t come before the other for certain? Infinite values that would need a closer look are not certain.
#[inline]
fn clearly_before(t: f64, other: f64) -> bool {
    t + TOLERANCE * t.abs() + TINY < other
}

/// What is not below 0 and comes after this comes after t for certain: the same with one operation less.
///
/// A t below 0 by more than [`TINY`] is below 0 whatever its rounding was.
#[inline]
pub(crate) fn just_after(t: f64) -> f64 {
    t * (1.0 + TOLERANCE) + TINY
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(a: [f64; 3], b: [f64; 3], expected: Ordering) {
        let meeting = |[plane, origin, direction]: [f64; 3]| Meeting {
            plane,
            origin,
            direction,
        };
        assert_eq!(meeting(a).order(&meeting(b)), expected);
        assert_eq!(meeting(b).order(&meeting(a)), expected.reverse());
    }

    #[test]
    fn the_smaller_t_comes_first_in_any_direction() {
        check([1.0, 0.0, 1.0], [2.0, 0.0, 1.0], Ordering::Less);
        check([1.0, 0.0, 1.0], [-2.0, 0.0, -1.0], Ordering::Less);
        check([-1.0, 0.0, -1.0], [-2.0, 0.0, -1.0], Ordering::Less);
    }

    #[test]
    fn thirds_that_f64_rounds_are_told_apart() {
        // 1/3 against 0.333…33 with 16 digits, and against 2/6
        let third = [1.0, 0.0, 3.0];
        check(third, [1.0 / 3.0, 0.0, 1.0], Ordering::Greater);
        check(third, [2.0, 0.0, 6.0], Ordering::Equal);
        check(third, [-1.0, 1.0, -6.0], Ordering::Equal);
    }

    #[test]
    fn a_difference_that_vanishes_in_f64_counts() {
        // from −1 to 2⁻⁶⁰ is further than from −1 to 0
        check(
            [0.0, -1.0, 1.0],
            [0.5f64.powi(60), -1.0, 1.0],
            Ordering::Less,
        );
    }

    #[test]
    fn thirds_are_told_apart_whichever_way_the_rays_go() {
        // a third, and the f64 below it
        let rounded = 1.0 / 3.0;
        for third in [[1.0, 0.0, 3.0], [-1.0, 0.0, -3.0]] {
            for below in [[rounded, 0.0, 1.0], [-rounded, 0.0, -1.0]] {
                check(third, below, Ordering::Greater);
            }
        }
    }

    #[test]
    fn two_large_t_that_f64_turns_round_stay_in_their_order() {
        // 0.7 is rounded down: 46806668.3 and a bit, by 7, is more than 33433334.5 by 5, which are both 6686666.9 and a bit
        let (first, second) = ([33_433_335.0, 0.5, 5.0], [46_806_669.0, 0.7, 7.0]);
        let t = |[plane, origin, direction]: [f64; 3]| (plane - origin) / direction;
        assert!(t(second) < t(first));
        check(first, second, Ordering::Less);
    }

    #[test]
    fn what_comes_just_after_a_t_is_eight_roundings_further() {
        assert_eq!(just_after(1.0), 1.0 + 8.0 * f64::EPSILON);
        assert_eq!(just_after(4.0), 4.0 + 32.0 * f64::EPSILON);
        assert_eq!(just_after(0.0), 1e-290);
    }
}
