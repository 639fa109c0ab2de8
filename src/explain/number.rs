//! Numbers as a reader meets them: rounded in this one place.

use glam::{DVec2, DVec3};

/// How many significant digits a line of working shows.
///
/// Six, as a pocket calculator is read; more where a difference cancels, so that whoever computes the
/// line again from the printed numbers gets the printed result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Digits(u32);

/// The sign of a negative number in what people read; the hyphen of a keyboard is shorter.
pub(crate) const MINUS: char = '−';

impl Digits {
    /// What is shown where nothing cancels.
    pub(super) const USUAL: Self = Self(6);
    /// All that an f64 has.
    const ALL: u32 = 17;

    /// Enough for a difference of terms of a size to come out right; as usual where the difference is
    /// nothing but rounding, which no number of digits would show.
    pub(super) fn for_difference(size: f64, difference: f64) -> Self {
        if is_rounding(size, difference) {
            return Self::USUAL;
        }
        let lost = libm::log10((size / difference.abs()).abs()).ceil();
        if lost.is_nan() || lost <= 0.0 {
            return Self::USUAL;
        }
        let Self(usual) = Self::USUAL;
        Self((f64::from(usual) + lost).min(f64::from(Self::ALL)) as u32)
    }

    /// The larger of two precisions.
    pub(super) fn or(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    /// A number, without zeros at its end and with a minus sign (U+2212); in powers of ten if it is very large or very
    /// small.
    pub(super) fn number(self, x: f64) -> String {
        let size = self.size(x.abs());
        if x < 0.0 {
            format!("{MINUS}{size}")
        } else {
            size
        }
    }

    /// A number that is not negative.
    fn size(self, x: f64) -> String {
        if x == 0.0 {
            return "0".into();
        }
        let rounded = format!("{x:.*e}", self.0 as usize - 1);
        let Some((digits, exponent)) = rounded.split_once('e') else {
            return rounded;
        };
        let power: i32 = exponent.parse().unwrap_or(0);
        if (-5..10).contains(&power) {
            let decimals = (i64::from(self.0) - 1 - i64::from(power)).max(0) as usize;
            // through the rounded digits, so that 9.9999996 becomes 10 and not 10.000000
            let value: f64 = rounded.parse().unwrap_or(x);
            trimmed(&format!("{value:.decimals$}")).into()
        } else {
            format!("{}e{exponent}", trimmed(digits))
        }
    }

    /// A number as a factor or a base: in brackets if it is negative.
    pub(super) fn factor(self, x: f64) -> String {
        let number = self.number(x);
        if number.starts_with(MINUS) {
            format!("({number})")
        } else {
            number
        }
    }

    /// A difference of terms of a size: a number, or that it is 0.
    pub(super) fn difference(self, size: f64, difference: f64) -> String {
        if is_rounding(size, difference) && difference != 0.0 {
            "0 but for rounding".into()
        } else {
            self.number(difference)
        }
    }

    /// A number with its sign as a further term: `+ 3` or `− 3`.
    pub(super) fn term(self, x: f64) -> String {
        let number = self.number(x);
        match number.strip_prefix(MINUS) {
            Some(positive) => format!("{MINUS} {positive}"),
            None => format!("+ {number}"),
        }
    }

    /// A coefficient with its variable: `2·t`, or `t` alone if it is 1.
    pub(super) fn times(self, x: f64, variable: &str) -> String {
        match self.number(x).as_str() {
            "1" => variable.into(),
            "−1" => format!("{MINUS}{variable}"),
            number => format!("{number}·{variable}"),
        }
    }

    /// The same as a further term: `+ 2·t` or `− t`.
    pub(super) fn term_times(self, x: f64, variable: &str) -> String {
        let product = self.times(x, variable);
        match product.strip_prefix(MINUS) {
            Some(positive) => format!("{MINUS} {positive}"),
            None => format!("+ {product}"),
        }
    }

    /// A point or vector in space.
    pub(super) fn vector(self, v: DVec3) -> String {
        let [x, y, z] = v.to_array().map(|value| self.number(value));
        format!("({x}, {y}, {z})")
    }

    /// A point in the plane.
    pub(super) fn point(self, v: DVec2) -> String {
        let [x, y] = v.to_array().map(|value| self.number(value));
        format!("({x}, {y})")
    }

    /// v·w, written out: `1·2 + 3·(−4) + 5·6`.
    pub(super) fn dot(self, v: DVec3, w: DVec3) -> String {
        let [v, w] = [v, w].map(|v| v.to_array().map(|value| self.factor(value)));
        format!("{}·{} + {}·{} + {}·{}", v[0], w[0], v[1], w[1], v[2], w[2])
    }

    /// |v|², written out: `1² + (−2)² + 3²`.
    pub(super) fn squares(self, v: DVec3) -> String {
        let [x, y, z] = v.to_array().map(|value| self.factor(value));
        format!("{x}² + {y}² + {z}²")
    }
}

/// A number with a number of significant digits, as a figure has room for.
pub(crate) fn shown(x: f64, digits: u32) -> String {
    Digits(digits).number(x)
}

/// A cell of a grid as the log, the worked text and the figures name it: `[3, 1, 0]`.
pub(crate) fn cell_name([i, j, k]: [u32; 3]) -> String {
    format!("[{i}, {j}, {k}]")
}

/// A count with its digits in groups of three, as in 104 857 600.
pub fn grouped(count: u64) -> String {
    grouped_sum(count.into())
}

/// A sum of counts in the same form.
pub(crate) fn grouped_sum(count: u128) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if 0 < i && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// Is a difference of terms of a size no more than what their rounding leaves?
fn is_rounding(size: f64, difference: f64) -> bool {
    /// Some roundings of 10⁻¹⁶ each.
    const ROUNDING: f64 = 1e-14;
    difference.abs() <= ROUNDING * size.abs()
}

/// A turned vector as a reader works it out: a coordinate that is 0 but for rounding is 0.
pub(super) fn without_rounding(v: DVec3) -> DVec3 {
    /// Some roundings of 10⁻¹⁶ each.
    const ROUNDING: f64 = 1e-14;
    let size = v.abs().max_element();
    DVec3::select(v.abs().cmple(DVec3::splat(ROUNDING * size)), DVec3::ZERO, v)
}

/// A number without the zeros at the end of its decimals.
fn trimmed(number: &str) -> &str {
    if number.contains('.') {
        number.trim_end_matches('0').trim_end_matches('.')
    } else {
        number
    }
}

/// A number of things: `1 object`, `4 objects`.
pub(in crate::explain) fn count(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits_and_no_zeros_at_the_end() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-12.5, "−12.5"),
            (1.0 / 3.0, "0.333333"),
            (9.999_999_6, "10"),
            (123_456.7, "123457"),
            (1_234_567.0, "1234570"),
            (2e-5, "0.00002"),
            (1.5e-9, "1.5e-9"),
            (-6.02e23, "−6.02e23"),
        ] {
            assert_eq!(Digits::USUAL.number(x), text);
        }
    }

    #[test]
    fn a_difference_that_cancels_is_shown_with_more_digits() {
        // 100.0001 − 100 = 0.0001: six digits are lost and six are wanted
        let digits = Digits::for_difference(100.0, 0.0001);
        assert_eq!(digits, Digits(12));
        assert_eq!(digits.number(100.000_112_345_678), "100.000112346");
        assert_eq!(Digits::for_difference(3.0, 5.0), Digits::USUAL);
        assert_eq!(Digits::for_difference(1.0, 1e-11), Digits(17));
        assert_eq!(Digits::for_difference(1.0, 1e-15), Digits::USUAL);
        assert_eq!(Digits::USUAL.difference(1.0, 1e-15), "0 but for rounding");
        assert_eq!(Digits::for_difference(0.0, 0.0), Digits::USUAL);
    }

    #[test]
    fn factors_and_terms_carry_their_sign() {
        assert_eq!(Digits::USUAL.factor(-2.0), "(−2)");
        assert_eq!(Digits::USUAL.term(-2.0), "− 2");
        // a coefficient of 1 is not written
        assert_eq!(Digits::USUAL.times(1.0, "t²"), "t²");
        assert_eq!(Digits::USUAL.times(-1.0, "x"), "−x");
        assert_eq!(Digits::USUAL.term_times(1.0, "t"), "+ t");
        assert_eq!(Digits::USUAL.term_times(-2.5, "t"), "− 2.5·t");
        assert_eq!(Digits::USUAL.term(2.0), "+ 2");
        let v = DVec3::new(1.0, -2.0, 0.0);
        assert_eq!(Digits::USUAL.dot(v, v), "1·1 + (−2)·(−2) + 0·0");
        assert_eq!(Digits::USUAL.squares(v), "1² + (−2)² + 0²");
    }
}
