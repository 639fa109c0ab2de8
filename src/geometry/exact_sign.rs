//! The sign of a sum of products, without rounding.
//!
//! A product of two f64 is a whole number of 106 bits times a power of two. Each is added in its place to
//! one long fixed-point number that has room for all of them (U. Kulisch's long accumulator): nothing is
//! rounded, nothing overflows or vanishes. The positive products have such a number, and the negative ones have another:
//! nothing is ever subtracted, and the larger number decides the sign.

use std::cmp::Ordering;

/// The place of the last bit: the smallest f64 is 2⁻¹⁰⁷⁴, and here is its square.
const LOWEST: i32 = -2 * 1074;

/// Products lie below 2²⁰⁴⁸: 2048 + 2148 bits, and some for carries.
const WORDS: usize = 66;

/// A long fixed-point number at or above 0, the highest word first: so the larger of two is the later in their order.
type Long = [u64; WORDS];

/// Is Σ aᵢ·bᵢ below, at or above 0? Exactly, for finite numbers of any size.
///
/// It takes some 50 ns, so a caller compares in f64 first and asks here where that is too close.
pub(crate) fn sign_of_sum(products: &[[f64; 2]]) -> Ordering {
    let (mut positive, mut negative) = ([0; WORDS], [0; WORDS]);
    for &[a, b] in products {
        let sum = if a.is_sign_negative() == b.is_sign_negative() {
            &mut positive
        } else {
            &mut negative
        };
        add_size(sum, a, b);
    }
    positive.cmp(&negative)
}

/// Adds |a·b|.
fn add_size(sum: &mut Long, a: f64, b: f64) {
    let ((a_digits, a_exponent), (b_digits, b_exponent)) = (parts(a), parts(b));
    let product = u128::from(a_digits) * u128::from(b_digits);
    let place = (a_exponent + b_exponent - LOWEST) as usize;
    let (above_lowest, shift) = (place / 64, (place % 64) as u32);

    // 106 bits, shifted by up to 63, lie in three words
    let low = product << shift;
    let above = product.checked_shr(128 - shift).unwrap_or(0);
    let words = [low as u64, (low >> 64) as u64, above as u64];
    let mut carry = false;
    let upwards = sum[..WORDS - above_lowest].iter_mut().rev();
    for (i, word) in upwards.enumerate() {
        let part = words.get(i).copied();
        if part.is_none() && !carry {
            return;
        }
        let (once, carry_once) = word.overflowing_add(part.unwrap_or(0));
        let (twice, carry_twice) = once.overflowing_add(u64::from(carry));
        *word = twice;
        carry = carry_once || carry_twice;
    }
}

/// |value| = digits·2^exponent.
fn parts(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    let biased = (bits >> 52 & 0x7ff) as i32;
    // a subnormal number has no hidden leading 1
    if biased == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, biased - 1075)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(products: &[[f64; 2]], expected: Ordering) {
        assert_eq!(sign_of_sum(products), expected, "{products:?}");
        let negated: Vec<_> = products.iter().map(|&[a, b]| [-a, b]).collect();
        assert_eq!(sign_of_sum(&negated), expected.reverse(), "−{products:?}");
    }

    #[test]
    fn a_product_is_not_rounded() {
        // (2²⁷ + 1)² = 2⁵⁴ + 2²⁸ + 1, and f64 drops the 1
        let x = 134_217_729.0;
        let rounded = [18_014_398_777_917_440.0, -1.0];
        check(&[[x, x], rounded], Ordering::Greater);
        check(&[[x, x], rounded, [-1.0, 1.0]], Ordering::Equal);
    }

    #[test]
    fn the_smallest_beside_the_largest_still_counts() {
        let (small, large) = (5e-324, f64::MAX);
        check(&[[large, large], [small, small]], Ordering::Greater);
        let left = [[large, large], [small, -small], [-large, large]];
        check(&left, Ordering::Less);
        check(&[[large, large], [large, large]], Ordering::Greater);
    }

    #[test]
    fn a_carry_goes_on_through_as_many_words_as_are_full() {
        // 2⁻¹⁰⁰ + 2⁻⁹⁹ + … + 2⁹⁹ are 200 bits of 1 in four words, and one 2⁻¹⁰⁰ more makes them 2¹⁰⁰
        let bits = (-100..100).map(|power| [2f64.powi(power), 1.0]);
        let full: Vec<_> = bits.chain([[2f64.powi(-100), 1.0]]).collect();
        let with = |last: f64| [&full[..], &[[2f64.powi(100), last]]].concat();
        check(&with(-1.0), Ordering::Equal);
        check(
            &[&with(-1.0)[..], &[[5e-324, 5e-324]]].concat(),
            Ordering::Greater,
        );
        check(&full[..200], Ordering::Greater);
    }

    #[test]
    fn zeros_of_either_sign_are_nothing() {
        check(&[[0.0, 1.0], [-0.0, 1e300]], Ordering::Equal);
        check(&[], Ordering::Equal);
    }
}
