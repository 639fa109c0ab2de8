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

    /// hi + lo of whole numbers as one whole number.
    fn whole(number: Twofold) -> i128 {
        number.hi as i128 + number.lo as i128
    }

    #[test]
    fn products_sums_and_differences_of_whole_numbers_are_exact() {
        // odd, of up to 53 bits: products have up to 106, and whole-number arithmetic says which
        let numbers: [i64; 8] = [
            3,
            -134_217_729,
            94_906_267,
            -1_234_567_890_123,
            4_503_599_627_370_497,
            -6_004_799_503_160_661,
            7_777_777_777_777_777,
            9_007_199_254_740_991,
        ];
        for a in numbers {
            for b in numbers {
                let [x, y] = [a, b].map(|n| n as f64);
                let [a, b] = [a, b].map(i128::from);
                assert_eq!(whole(Twofold::product(x, y)), a * b, "{a}·{b}");
                // 2⁻⁴⁰ of a beside b: bits that one f64 cannot hold together
                let small = x / 1_099_511_627_776.0;
                let sum = Twofold::sum(y, small);
                assert_eq!((sum.hi - y) + sum.lo, small, "{b} + {a}/2⁴⁰");
                let difference = Twofold::difference(x, y);
                assert_eq!(whole(difference), a - b, "{a} − {b}");
            }
        }
    }

    #[test]
    fn what_the_larger_parts_cancel_leaves_is_kept_to_the_last_bit() {
        // (2¹⁰⁰ + 2⁴⁶) − (2¹⁰⁰ − 2⁻²⁰) = 2⁴⁶ + 2⁻²⁰, 66 bits apart
        let [large, middle, small] = [100, 46, -20].map(|power| 2.0_f64.powi(power));
        let number = |hi, lo| Twofold { hi, lo };
        let left = number(large, middle) - number(large, -small);
        assert_eq!((left.hi, left.lo), (middle, small));
        // two that do not cancel: 2¹⁰⁰ + 2⁴⁶ + 2¹⁰⁰ + 2⁴⁵, in order again
        let sum = number(large, middle) + number(large, 0.5 * middle);
        assert_eq!((sum.hi, sum.lo), (2.0 * large, 1.5 * middle));
        // (2⁶⁰ + 1)(2⁶⁰ + 3) = 2¹²⁰ + 4·2⁶⁰ + 3, and the 3 is beyond 106 bits
        let [a, b] = [1.0, 3.0].map(|lo| number(2.0_f64.powi(60), lo));
        let product = a * b;
        assert_eq!(
            (product.hi, product.lo),
            (2.0_f64.powi(120), 2.0_f64.powi(62))
        );
        // a part that is more than half an ulp of the other is carried over: 1 + 1.5 = 2.5
        let ordered = Twofold::ordered(1.0, 1.5);
        assert_eq!((ordered.hi, ordered.lo), (2.5, 0.0));
        // 1 + ε + ½ε lies in the middle of 1 + ε and 1 + 2ε, of which the latter is even
        let eps = f64::EPSILON;
        assert_eq!(number(1.0 + eps, 0.5 * eps).value(), 1.0 + 2.0 * eps);
    }

    #[test]
    fn a_cross_product_of_nearly_parallel_vectors_keeps_all_that_is_left() {
        // v × (v + (1, 1, 1)) = v × (1, 1, 1) = (y − z, z − x, x − y)
        let v = DVec3::new(4_503_599_627_370_497.0, 4_503_599_627_370_400.0, 7.0);
        let cross = TwofoldVec::from(v).cross(TwofoldVec::from(v + DVec3::ONE));
        let found = cross.0.map(Twofold::value);
        let expected = [4_503_599_627_370_393.0, -4_503_599_627_370_490.0, 97.0];
        assert_eq!(found, expected);
        // 3² + 4² + 12² = 13²
        let length2 = TwofoldVec::difference(DVec3::new(4.0, 6.0, 15.0), DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(length2.length_squared().value(), 169.0);
    }
}
