//! A quantity with its right and its wrong value, and whether the two differ.

use std::borrow::Cow;

use crate::trace::SpoiltValue;

/// A quantity by its name: right and wrong.
pub(super) type Pair = (Cow<'static, str>, [SpoiltValue; 2]);

/// A value of each of two, as a quantity.
pub(super) fn pair<T, V: Into<SpoiltValue>>(
    name: impl Into<Cow<'static, str>>,
    [right, wrong]: [&T; 2],
    value: impl Fn(&T) -> V,
) -> Pair {
    (name.into(), [right, wrong].map(|of| value(of).into()))
}

/// Do two values differ by more than rounding?
pub(super) fn differ(right: &SpoiltValue, wrong: &SpoiltValue) -> bool {
    /// Of the larger one: rounding is far below, and what shows in a picture far above.
    const LEAST: f64 = 1e-6;
    let numbers = |a: f64, b: f64| LEAST * a.abs().max(b.abs()) < (a - b).abs();
    match (right, wrong) {
        (SpoiltValue::Number(a), SpoiltValue::Number(b)) => numbers(*a, *b),
        (SpoiltValue::Vector(a), SpoiltValue::Vector(b)) => {
            a.iter().zip(b).any(|(a, b)| numbers(*a, *b))
        }
        _ => right != wrong,
    }
}

/// t, or that there is none.
pub(super) fn t_or_none(t: Option<f64>) -> SpoiltValue {
    t.map_or_else(|| "no hit".into(), SpoiltValue::from)
}

/// One of two words.
pub(super) fn words(is: bool, [yes, no]: [&str; 2]) -> SpoiltValue {
    if is { yes.into() } else { no.into() }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn rounding_is_no_difference_and_a_word_is_one() {
        let of = |a: f64, b: f64| differ(&a.into(), &b.into());
        assert!(!of(3.0, 3.0 + 1e-9) && of(3.0, 3.001));
        // an ε of one billionth in place of a hundredth
        assert!(of(0.01, 1e-9));
        assert!(of(2.0, f64::NAN) && !of(f64::INFINITY, f64::INFINITY));
        let x: SpoiltValue = DVec3::X.into();
        assert!(differ(&x, &DVec3::NEG_X.into()) && !differ(&x, &DVec3::X.into()));
        assert!(differ(&t_or_none(None), &t_or_none(Some(1.0))));
    }
}
