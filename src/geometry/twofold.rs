//! Numbers of twice the precision: a sum hi + lo of two f64, about 32 digits.
//!
//! Two differences decide a sphere test, and both can cancel: c (how far outside the origin lies) and
//! the discriminant (how far inside the ray passes). Where the plain result has lost digits, the test
//! takes it again with these. After Dekker 1971 and Shewchuk 1997.

use std::ops::{Add, Mul, Sub};

use glam::DVec3;

/// hi + lo, with |lo| at most half an ulp of hi.
#[derive(Clone, Copy, Debug)]
pub(super) struct Twofold {
    hi: f64,
    lo: f64,
}

impl Twofold {
    /// a − b, exactly.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// a·b, exactly (but for products beyond f64's range). Veltkamp's split halves each factor.
    pub(super) fn product(a: f64, b: f64) -> Self {
        const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1: halves of 26 bits
        let halves = |x: f64| {
            let shifted = SPLITTER * x;
            let high = shifted - (shifted - x);
            (high, x - high)
        };
        let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
        let hi = a * b;
        let lo = a2 * b2 - (((hi - a1 * b1) - a2 * b1) - a1 * b2);
        Self { hi, lo }
    }

    /// Rounded to one f64.
    pub(super) fn value(self) -> f64 {
        self.hi + self.lo
    }

    /// a + b, exactly (Knuth).
    fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        let lo = (a - (hi - b_part)) + (b - b_part);
        Self { hi, lo }
    }

    /// hi + lo brought into order, |hi| being the larger.
    fn ordered(hi: f64, lo: f64) -> Self {
        let sum = hi + lo;
        Self {
            hi: sum,
            lo: lo - (sum - hi),
        }
    }
}

impl From<f64> for Twofold {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for Twofold {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.hi, other.hi);
        let low = Self::sum(self.lo, other.lo);
        let middle = Self::ordered(high.hi, high.lo + low.hi);
        Self::ordered(middle.hi, middle.lo + low.lo)
    }
}

impl Sub for Twofold {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + Self {
            hi: -other.hi,
            lo: -other.lo,
        }
    }
}

impl Mul for Twofold {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = Self::product(self.hi, other.hi);
        let cross = self.hi * other.lo + self.lo * other.hi;
        Self::ordered(high.hi, high.lo + cross)
    }
}

/// A vector of such numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct TwofoldVec([Twofold; 3]);

impl TwofoldVec {
    /// a − b, exactly.
    pub(super) fn difference(a: DVec3, b: DVec3) -> Self {
        Self([
            Twofold::difference(a.x, b.x),
            Twofold::difference(a.y, b.y),
            Twofold::difference(a.z, b.z),
        ])
    }

    /// |v|².
    pub(super) fn length_squared(self) -> Twofold {
        let [x, y, z] = self.0;
        x * x + y * y + z * z
    }

    /// v × w.
    pub(super) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }
}

impl From<DVec3> for TwofoldVec {
    fn from(v: DVec3) -> Self {
        Self([v.x.into(), v.y.into(), v.z.into()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_keeps_the_digits_that_one_f64_drops() {
        // (2²⁷ + 1)² = 2⁵⁴ + 2²⁸ + 1: the last 1 does not fit beside 2⁵⁴ in 53 bits.
        let x = 134_217_729.0;
        let square = Twofold::product(x, x);
        assert_eq!(square.hi, 18_014_398_777_917_440.0);
        assert_eq!(square.lo, 1.0);
    }

    #[test]
    fn a_difference_of_squares_keeps_what_cancels() {
        // (10⁸ + 1)² − 10¹⁶ = 2·10⁸ + 1, odd and so beyond one f64 at 10¹⁶.
        let x = Twofold::from(1e8 + 1.0);
        let difference = x * x - Twofold::from(1e16);
        assert_eq!(difference.value(), 200_000_001.0);
    }
}
