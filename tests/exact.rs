//! Exact arithmetic to hold f64 results against.
//!
//! Every finite f64 is an integer times a power of two, and sums, differences and products of such
//! numbers are such numbers again. So nothing is ever rounded here, but for the square root and the
//! way back to f64. There is no division: a quotient is compared by multiplying up.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use glam::{DVec2, DVec3};
use num_bigint::{BigInt, Sign};

/// digits·2^exponent.
#[derive(Clone, Debug)]
pub(crate) struct Exact {
    digits: BigInt,
    exponent: i32,
}

/// A square root is cut off after half as many bits: 320 bits are 96 decimal digits, so that 60 are
/// left when the first 36 cancel.
const RADICAND_BITS: i32 = 640;

impl Exact {
    /// −1, 0 or 1.
    pub(crate) fn sign(&self) -> i32 {
        match self.digits.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    pub(crate) fn abs(&self) -> Self {
        if self.sign() < 0 { -self } else { self.clone() }
    }

    /// The digits for a smaller exponent, or the same.
    fn aligned(&self, exponent: i32) -> BigInt {
        &self.digits << (self.exponent - exponent)
    }

    /// The square root of a number that is not negative: exact for the square of an f64, else cut off.
    pub(crate) fn sqrt(&self) -> Self {
        let mut shift = (RADICAND_BITS - self.digits.bits() as i32).max(0);
        // half of the exponent must be whole
        shift += (self.exponent - shift).rem_euclid(2);
        Self {
            digits: (&self.digits << shift).sqrt(),
            exponent: (self.exponent - shift) / 2,
        }
    }

    /// The nearest f64, or the one next to it; for magnitudes well within f64's range.
    pub(crate) fn to_f64(&self) -> f64 {
        let excess = (self.digits.bits() as i32 - 64).max(0);
        let leading = u64::try_from(self.abs().digits >> excess).expect("64 bits are left");
        f64::from(self.sign()) * leading as f64 * 2f64.powi(self.exponent + excess)
    }
}

impl From<f64> for Exact {
    fn from(value: f64) -> Self {
        assert!(value.is_finite(), "{value} has no exact value");
        let bits = value.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let biased = (bits >> 52 & 0x7ff) as i32;
        // a subnormal number has no hidden leading 1
        let (magnitude, biased) = if biased == 0 {
            (fraction, 1)
        } else {
            (fraction | 1 << 52, biased)
        };
        let digits = BigInt::from(magnitude);
        Self {
            digits: if value.is_sign_negative() {
                -digits
            } else {
                digits
            },
            exponent: biased - 1075,
        }
    }
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, other: Self) -> Exact {
        let exponent = self.exponent.min(other.exponent);
        Exact {
            digits: self.aligned(exponent) + other.aligned(exponent),
            exponent,
        }
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact {
            digits: -&self.digits,
            exponent: self.exponent,
        }
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, other: Self) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: Self) -> Exact {
        Exact {
            digits: &self.digits * &other.digits,
            exponent: self.exponent + other.exponent,
        }
    }
}

macro_rules! also_by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Exact {
            type Output = Exact;
            fn $method(self, other: Self) -> Exact {
                (&self).$method(&other)
            }
        }
    )*};
}
also_by_value!(Add add, Sub sub, Mul mul);

impl PartialEq for Exact {
    fn eq(&self, other: &Self) -> bool {
        (self - other).sign() == 0
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some((self - other).sign().cmp(&0))
    }
}

/// A vector, or a point, in space.
#[derive(Clone, Debug)]
pub(crate) struct ExactVec3(pub(crate) [Exact; 3]);

impl From<DVec3> for ExactVec3 {
    fn from(v: DVec3) -> Self {
        Self(v.to_array().map(Exact::from))
    }
}

impl Sub for &ExactVec3 {
    type Output = ExactVec3;
    fn sub(self, other: Self) -> ExactVec3 {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        ExactVec3([a - x, b - y, c - z])
    }
}

impl ExactVec3 {
    pub(crate) fn dot(&self, other: &Self) -> Exact {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        a * x + b * y + c * z
    }
}

/// A point in a plane.
pub(crate) type ExactPoint = [Exact; 2];

pub(crate) fn exact_point(p: DVec2) -> ExactPoint {
    p.to_array().map(Exact::from)
}

/// Where does a point lie with respect to an outline?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Inside,
    Outside,
    OnEdge,
}

/// The even-odd rule, exactly: does a half-line from the point cross an odd number of edges?
///
/// The half-line runs upwards, along the second coordinate: another one than the polygons use.
pub(crate) fn even_odd(outline: &[ExactPoint], [x, y]: &ExactPoint) -> Place {
    let mut inside = false;
    for (i, from) in outline.iter().enumerate() {
        let to = &outline[(i + 1) % outline.len()];
        let [left, right] = if from[0] <= to[0] {
            [from, to]
        } else {
            [to, from]
        };
        if *x < left[0] || right[0] < *x {
            continue;
        }
        // above 0 if the point lies above the line from left to right
        let above =
            (&right[0] - &left[0]) * (y - &left[1]) - (&right[1] - &left[1]) * (x - &left[0]);
        if left[0] == right[0] {
            let [low, high] = if left[1] <= right[1] {
                [left, right]
            } else {
                [right, left]
            };
            if low[1] <= *y && *y <= high[1] {
                return Place::OnEdge;
            }
        } else if above.sign() == 0 {
            return Place::OnEdge;
        } else if above.sign() < 0 && left[0] <= *x && *x < right[0] {
            inside = !inside;
        }
    }
    if inside {
        Place::Inside
    } else {
        Place::Outside
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_keeps_what_f64_drops() {
        let sum = Exact::from(1e300) + Exact::from(1e-300);
        assert_eq!(sum - Exact::from(1e300), Exact::from(1e-300));
        assert_eq!(Exact::from(-0.1).to_f64(), -0.1);
        assert_eq!(Exact::from(-0.0).sign(), 0);
    }

    #[test]
    fn the_root_of_two_has_96_digits() {
        let two = Exact::from(2.0);
        let root = two.sqrt();
        let error = (&root * &root - two).abs().to_f64();
        assert!(error <= 1e-95, "{error:e}");
        assert_eq!(Exact::from(9.0).sqrt(), Exact::from(3.0));
    }

    #[test]
    fn a_square_contains_its_middle_and_has_its_corners_on_the_edge() {
        let square: Vec<_> = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
            .map(|(x, y)| exact_point(DVec2::new(x, y)))
            .to_vec();
        let place = |x, y| even_odd(&square, &exact_point(DVec2::new(x, y)));
        assert_eq!(place(1.0, 1.0), Place::Inside);
        assert_eq!(place(1.0, 3.0), Place::Outside);
        assert_eq!(place(3.0, 2.0), Place::Outside);
        assert_eq!(place(2.0, 2.0), Place::OnEdge);
        assert_eq!(place(0.0, 1.0), Place::OnEdge);
        assert_eq!(place(1.0, 2.0), Place::OnEdge);
    }
}
