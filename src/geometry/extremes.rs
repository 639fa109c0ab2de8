//! The larger and the smaller of two numbers, where NaN cannot occur.
//!
//! `f64::max` and `f64::min` give the other number if one is NaN, which takes several instructions. These take one, and
//! of a NaN and a number give the first.

/// The larger of two numbers.
#[inline]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// The smaller of two numbers.
#[inline]
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_larger_and_the_smaller_of_two_numbers() {
        for (a, b) in [(1.0, 2.0), (2.0, 1.0)] {
            assert_eq!((larger(a, b), smaller(a, b)), (2.0, 1.0));
        }
        // of equals, such as zeros of both signs, the first; and so of a number that is none
        assert!(larger(-0.0, 0.0).is_sign_negative() && smaller(0.0, -0.0).is_sign_positive());
        assert!(larger(f64::NAN, 1.0).is_nan() && smaller(f64::NAN, 1.0).is_nan());
    }
}
