//! A value of an answer: how it is compared, and how it is shown.

use glam::DVec3;

use crate::explain::shown;

/// Two numbers count as the same within this share of the larger of 1 and the expected one: a right formula written another
/// way differs by some 10⁻¹⁴, and every mistake by more than a millionth.
const SAME: f64 = 1e-9;

/// What an exercise asks for, or what came out.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// Several numbers, in their order.
    Numbers(Vec<f64>),
    /// A point or a vector.
    Vector(DVec3),
    /// A word: a name, a verdict, yes or no.
    Word(String),
    /// A number that counts only by whether it is odd or even.
    Parity(u64),
    /// A number that counts if it is close enough: it is an average, or one of many right answers.
    About {
        /// The number.
        number: f64,
        /// By how much it may differ.
        within: f64,
    },
}

impl Value {
    /// A number, or the word that there is none.
    pub fn number_or(number: Option<f64>, none: &str) -> Self {
        number.map_or_else(|| Self::word(none), Self::Number)
    }

    /// A word.
    pub fn word(word: impl Into<String>) -> Self {
        Self::Word(word.into())
    }

    /// Yes or no.
    pub fn is(yes: bool) -> Self {
        Self::word(if yes { "yes" } else { "no" })
    }

    /// Is it one of few values?
    pub(super) fn is_word(&self) -> bool {
        matches!(self, Self::Word(_) | Self::Parity(_))
    }

    /// The number, if it is one.
    pub(super) fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// The vector, if it is one.
    pub(super) fn vector(&self) -> Option<DVec3> {
        match self {
            Self::Vector(vector) => Some(*vector),
            _ => None,
        }
    }

    /// Is it the expected value?
    pub fn is_same(&self, expected: &Self) -> bool {
        match (self, expected) {
            (Self::Number(yours), Self::Number(expected)) => same(*yours, *expected),
            (Self::Numbers(yours), Self::Numbers(expected)) => {
                let pairs = || yours.iter().zip(expected);
                yours.len() == expected.len() && pairs().all(|(a, b)| same(*a, *b))
            }
            (Self::Vector(yours), Self::Vector(expected)) => {
                let size = expected.length().max(1.0);
                (*yours - *expected).length() <= SAME * size
            }
            (Self::Parity(yours), Self::Parity(expected)) => yours % 2 == expected % 2,
            (Self::About { number, .. }, Self::About { number: of, within }) => {
                (number - of).abs() <= *within
            }
            (yours, expected) => yours == expected,
        }
    }

    /// Are both no number?
    pub(super) fn is_no_number_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(yours), Self::Number(other)) => yours.is_nan() && other.is_nan(),
            (Self::Vector(yours), Self::Vector(other)) => yours.is_nan() && other.is_nan(),
            _ => false,
        }
    }

    /// With a number of significant digits.
    fn text(&self, digits: u32) -> String {
        match self {
            Self::Number(x) | Self::About { number: x, .. } => number(*x, digits),
            Self::Numbers(numbers) => {
                let each: Vec<_> = numbers.iter().map(|x| number(*x, digits)).collect();
                if each.is_empty() {
                    "none".into()
                } else {
                    each.join(", ")
                }
            }
            Self::Vector(v) => {
                let [x, y, z] = v.to_array().map(|x| number(x, digits));
                format!("({x}, {y}, {z})")
            }
            Self::Word(word) => word.clone(),
            Self::Parity(count) => {
                let kind = if count % 2 == 1 { "odd" } else { "even" };
                format!("{count} ({kind})")
            }
        }
    }

    /// Both values, with as many digits as tell them apart.
    pub(super) fn pair(yours: &Self, expected: &Self) -> [String; 2] {
        let with = |digits| [yours.text(digits), expected.text(digits)];
        let short = with(6);
        if short[0] != short[1] || yours.is_same(expected) {
            return short;
        }
        let long = with(12);
        if long[0] == long[1] { with(17) } else { long }
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<DVec3> for Value {
    fn from(vector: DVec3) -> Self {
        Self::Vector(vector)
    }
}

fn same(yours: f64, expected: f64) -> bool {
    yours == expected || (yours - expected).abs() <= SAME * expected.abs().max(1.0)
}

/// A number as a student reads it.
pub(super) fn number(x: f64, digits: u32) -> String {
    if x.is_nan() {
        "no number (NaN)".into()
    } else if x.is_infinite() {
        if x < 0.0 { "−∞" } else { "∞" }.into()
    } else {
        shown(x, digits)
    }
}

/// A point or a vector as a student reads it.
pub(super) fn vector(v: DVec3) -> String {
    Value::Vector(v).text(6)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_the_same_and_a_millionth_is_not() {
        let one = Value::Number(1.0);
        assert!(Value::Number(1.0 + 1e-12).is_same(&one));
        assert!(!Value::Number(1.0 + 1e-6).is_same(&one));
        assert!(Value::Number(f64::INFINITY).is_same(&Value::Number(f64::INFINITY)));
        assert!(!Value::Number(f64::NAN).is_same(&one));
        assert!(!Value::Number(f64::NAN).is_same(&Value::Number(f64::INFINITY)));
        assert!(!Value::word("miss").is_same(&one));
        assert!(Value::Parity(3).is_same(&Value::Parity(1)));
        assert!(!Value::Parity(2).is_same(&Value::Parity(1)));
        assert!(Value::Vector(DVec3::X * 1e9).is_same(&Value::Vector(DVec3::X * (1e9 + 0.1))));
    }

    #[test]
    fn digits_grow_until_the_two_differ() {
        let pair = |a, b| Value::pair(&Value::Number(a), &Value::Number(b));
        assert_eq!(pair(-1.5, 2.0), ["−1.5", "2"]);
        assert_eq!(pair(1.000_000_1, 1.0), ["1.0000001", "1"]);
        assert_eq!(pair(f64::NAN, f64::NEG_INFINITY), ["no number (NaN)", "−∞"]);
    }
}
