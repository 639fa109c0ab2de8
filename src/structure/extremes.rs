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
