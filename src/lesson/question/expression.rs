//! Expressions over the fields of a trace: `-b - sqrt(b^2 - 4*a*c)`, `verdict = 'hit' and t < 5`.
//!
//! Numbers, words in single quotes, lists of numbers; + - * / ^, = != < <= > >=, and, or, not; `dot`, `cross`, `length`, `unit`,
//! `sqrt`, `abs`, `min`, `max`, `floor`, `round`, `has`; `sin`, `cos`, `tan`, `asin`, `acos` in degrees. A name is looked up in the facts; `.x`, `.y` and `.z` are the first, second
//! and third number of a list.

use std::fmt;

use crate::explain::shown;

/// Numbers of a list that are smaller than this share of the largest are rounding: f64 has 16 digits.
const ROUNDING: f64 = 1e-12;

/// No expression is longer, so that none nests deeper than the stack allows.
const MOST_TOKENS: usize = 128;

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Datum {
    /// A number.
    Number(f64),
    /// True or false.
    Flag(bool),
    /// A word.
    Text(String),
    /// Numbers: a point, a direction, a cell.
    List(Vec<f64>),
    /// A field that is absent.
    Nothing,
}

/// Where names are looked up.
pub(super) trait Names {
    /// What a name stands for.
    ///
    /// # Errors
    /// Nothing has this name.
    fn find(&self, name: &str) -> Result<Datum, String>;
}

/// The value of an expression.
///
/// # Errors
/// What is wrong with it, in words.
pub(super) fn evaluate(text: &str, names: &dyn Names) -> Result<Datum, String> {
    let tokens = tokens(text)?;
    if MOST_TOKENS < tokens.len() {
        return Err(format!(
            "the expression has {} parts, and at most {MOST_TOKENS} are read: name some of them",
            tokens.len()
        ));
    }
    let mut parser = Parser {
        tokens: &tokens,
        at: 0,
        names,
    };
    let value = parser.either()?;
    match parser.peek() {
        None => Ok(value),
        Some(token) => Err(format!("unexpected {token}")),
    }
}

impl Datum {
    /// The number that it is.
    ///
    /// # Errors
    /// It is something else.
    pub(super) fn number(&self) -> Result<f64, String> {
        match self {
            Self::Number(number) => Ok(*number),
            other => Err(format!("{} is no number", other.quoted())),
        }
    }

    /// Whether it is true.
    ///
    /// # Errors
    /// It is neither true nor false.
    pub(super) fn flag(&self) -> Result<bool, String> {
        match self {
            Self::Flag(flag) => Ok(*flag),
            other => Err(format!("{} is neither true nor false", other.quoted())),
        }
    }

    fn list(&self) -> Result<&[f64], String> {
        match self {
            Self::List(list) => Ok(list),
            other => Err(format!("{} is no list of numbers", other.quoted())),
        }
    }

    fn quoted(&self) -> String {
        match self {
            Self::Text(text) => format!("{text:?}"),
            Self::Nothing => "a field that is absent".into(),
            other => other.shown(6),
        }
    }

    /// As a text shows it, numbers with so many significant digits.
    pub(super) fn shown(&self, digits: u32) -> String {
        match self {
            Self::Number(number) => shown(*number, digits),
            Self::Flag(flag) => flag.to_string(),
            Self::Text(text) => crate::explain::printable(text),
            Self::List(list) => {
                // what is left of a 0 by rounding is 0 beside the other numbers
                let size = list.iter().fold(0.0, |size: f64, of| size.max(of.abs()));
                let bare = |of: &f64| {
                    if of.abs() <= ROUNDING * size {
                        0.0
                    } else {
                        *of
                    }
                };
                let items: Vec<String> = list.iter().map(|of| shown(bare(of), digits)).collect();
                format!("({})", items.join(", "))
            }
            Self::Nothing => "none".into(),
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Text(String),
    Name(String),
    Sign(&'static str),
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => write!(f, "'{text}'"),
            Self::Name(name) => f.write_str(name),
            Self::Sign(sign) => write!(f, "\"{sign}\""),
        }
    }
}

/// The longer signs first.
const SIGNS: [&str; 16] = [
    "<=", ">=", "!=", "<", ">", "=", "+", "-", "*", "/", "^", "(", ")", "[", "]", ",",
];

fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut found = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_digit() {
            let end = end_of_number(rest);
            let number = rest[..end].parse();
            found.push(Token::Number(
                number.map_err(|_| format!("{:?} is no number", &rest[..end]))?,
            ));
            end
        } else if first == '\'' {
            let end = rest[1..].find('\'');
            let end = end.ok_or("a quotation mark is missing")? + 1;
            found.push(Token::Text(rest[1..end].into()));
            end + 1
        } else if first.is_alphabetic() || first == '_' {
            let is_end = |c: char| !c.is_alphanumeric() && !['_', '.'].contains(&c);
            let end = rest.find(is_end).unwrap_or(rest.len());
            found.push(Token::Name(rest[..end].into()));
            end
        } else {
            let sign = SIGNS.iter().find(|sign| rest.starts_with(**sign));
            let sign = sign.ok_or_else(|| format!("unexpected {first:?}"))?;
            found.push(Token::Sign(sign));
            sign.len()
        };
        rest = rest[length..].trim_start();
    }
    Ok(found)
}

/// Where a number ends: behind its digits, its point and its exponent.
fn end_of_number(text: &str) -> usize {
    let mut before = ' ';
    let end = text.char_indices().find(|&(_, c)| {
        let is_sign = (c == '-' || c == '+') && before == 'e';
        before = c;
        !(c.is_ascii_digit() || c == '.' || c == 'e' || is_sign)
    });
    end.map_or(text.len(), |(at, _)| at)
}

/// Reads tokens and computes at once, one method for each rank of operators.
struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    names: &'a dyn Names,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn takes(&mut self, sign: &str) -> bool {
        let is_next = match self.peek() {
            Some(Token::Sign(next)) => *next == sign,
            Some(Token::Name(name)) => name == sign,
            _ => false,
        };
        self.at += usize::from(is_next);
        is_next
    }

    fn needs(&mut self, sign: &str) -> Result<(), String> {
        if self.takes(sign) {
            return Ok(());
        }
        match self.peek() {
            Some(token) => Err(format!("expected {sign:?}, found {token}")),
            None => Err(format!("expected {sign:?} at the end")),
        }
    }

    fn either(&mut self) -> Result<Datum, String> {
        let mut value = self.both()?;
        while self.takes("or") {
            let other = self.both()?.flag()?;
            value = Datum::Flag(value.flag()? || other);
        }
        Ok(value)
    }

    fn both(&mut self) -> Result<Datum, String> {
        let mut value = self.not()?;
        while self.takes("and") {
            let other = self.not()?.flag()?;
            value = Datum::Flag(value.flag()? && other);
        }
        Ok(value)
    }

    fn not(&mut self) -> Result<Datum, String> {
        if self.takes("not") {
            return Ok(Datum::Flag(!self.not()?.flag()?));
        }
        self.compared()
    }

    fn compared(&mut self) -> Result<Datum, String> {
        let left = self.sum()?;
        for sign in ["<=", ">=", "!=", "<", ">", "="] {
            if !self.takes(sign) {
                continue;
            }
            let right = self.sum()?;
            let holds = match sign {
                "=" => left == right,
                "!=" => left != right,
                // what is absent is neither smaller nor larger
                _ if left == Datum::Nothing || right == Datum::Nothing => false,
                _ => {
                    let (left, right) = (left.number()?, right.number()?);
                    match sign {
                        "<=" => left <= right,
                        ">=" => right <= left,
                        "<" => left < right,
                        _ => right < left,
                    }
                }
            };
            return Ok(Datum::Flag(holds));
        }
        Ok(left)
    }

    fn sum(&mut self) -> Result<Datum, String> {
        let mut value = self.product()?;
        loop {
            if self.takes("+") {
                value = paired(&value, &self.product()?, |a, b| a + b)?;
            } else if self.takes("-") {
                value = paired(&value, &self.product()?, |a, b| a - b)?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<Datum, String> {
        let mut value = self.signed()?;
        loop {
            if self.takes("*") {
                value = scaled(&value, &self.signed()?)?;
            } else if self.takes("/") {
                let divisor = self.signed()?.number()?;
                value = match &value {
                    Datum::List(list) => Datum::List(list.iter().map(|of| of / divisor).collect()),
                    value => Datum::Number(value.number()? / divisor),
                };
            } else {
                return Ok(value);
            }
        }
    }

    fn signed(&mut self) -> Result<Datum, String> {
        if self.takes("-") {
            return scaled(&Datum::Number(-1.0), &self.signed()?);
        }
        let base = self.atom()?;
        if self.takes("^") {
            let exponent = self.signed()?.number()?;
            return Ok(Datum::Number(libm::pow(base.number()?, exponent)));
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<Datum, String> {
        let token = self.peek().cloned();
        self.at += 1;
        match token {
            Some(Token::Number(number)) => Ok(Datum::Number(number)),
            Some(Token::Text(text)) => Ok(Datum::Text(text)),
            Some(Token::Sign("(")) => {
                let value = self.either()?;
                self.needs(")")?;
                Ok(value)
            }
            Some(Token::Sign("[")) => {
                let mut list = vec![self.sum()?.number()?];
                while self.takes(",") {
                    list.push(self.sum()?.number()?);
                }
                self.needs("]")?;
                Ok(Datum::List(list))
            }
            Some(Token::Name(name)) if name == "true" || name == "false" => {
                Ok(Datum::Flag(name == "true"))
            }
            Some(Token::Name(name)) if self.takes("(") => {
                let mut given = vec![self.either()?];
                while self.takes(",") {
                    given.push(self.either()?);
                }
                self.needs(")")?;
                called(&name, &given)
            }
            Some(Token::Name(name)) => self.names.find(&name),
            Some(token) => Err(format!("unexpected {token}")),
            None => Err("the expression ends too early".into()),
        }
    }
}

/// Number with number, or list with list.
fn paired(left: &Datum, right: &Datum, of: fn(f64, f64) -> f64) -> Result<Datum, String> {
    match (left, right) {
        (Datum::List(left), Datum::List(right)) if left.len() == right.len() => {
            let items = left.iter().zip(right);
            Ok(Datum::List(items.map(|(a, b)| of(*a, *b)).collect()))
        }
        _ => Ok(Datum::Number(of(left.number()?, right.number()?))),
    }
}

/// A product of numbers, or of a number and a list.
fn scaled(left: &Datum, right: &Datum) -> Result<Datum, String> {
    match (left, right) {
        (Datum::List(list), by) | (by, Datum::List(list)) => {
            let by = by.number()?;
            Ok(Datum::List(list.iter().map(|of| of * by).collect()))
        }
        _ => Ok(Datum::Number(left.number()? * right.number()?)),
    }
}

fn called(name: &str, given: &[Datum]) -> Result<Datum, String> {
    let vector = |place: usize| -> Result<glam::DVec3, String> {
        let list = given.get(place).ok_or("a vector is missing")?.list()?;
        let array: [f64; 3] = list.try_into().map_err(|_| "a vector has three numbers")?;
        Ok(array.into())
    };
    let number = |place: usize| given.get(place).ok_or("a number is missing")?.number();
    let count = match name {
        "dot" | "cross" | "min" | "max" => 2,
        _ => 1,
    };
    if given.len() != count {
        return Err(format!(
            "{name} takes {count} values, and {} are given",
            given.len()
        ));
    }
    Ok(match name {
        "dot" => Datum::Number(vector(0)?.dot(vector(1)?)),
        "cross" => Datum::List(vector(0)?.cross(vector(1)?).to_array().into()),
        "length" => Datum::Number(vector(0)?.length()),
        "unit" => Datum::List(vector(0)?.normalize_or_zero().to_array().into()),
        "sqrt" => Datum::Number(number(0)?.sqrt()),
        "abs" => Datum::Number(number(0)?.abs()),
        "floor" => Datum::Number(number(0)?.floor()),
        "round" => Datum::Number(number(0)?.round()),
        "sin" => Datum::Number(libm::sin(number(0)?.to_radians())),
        "cos" => Datum::Number(libm::cos(number(0)?.to_radians())),
        "tan" => Datum::Number(libm::tan(number(0)?.to_radians())),
        "asin" => Datum::Number(libm::asin(number(0)?).to_degrees()),
        "acos" => Datum::Number(libm::acos(number(0)?).to_degrees()),
        "min" => Datum::Number(number(0)?.min(number(1)?)),
        "max" => Datum::Number(number(0)?.max(number(1)?)),
        "has" => Datum::Flag(given[0] != Datum::Nothing),
        _ => return Err(format!("there is no function {name:?}")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Known;

    impl Names for Known {
        fn find(&self, name: &str) -> Result<Datum, String> {
            Ok(match name {
                "a" => Datum::Number(1.0),
                "b" => Datum::Number(-10.0),
                "c" => Datum::Number(21.0),
                "n" => Datum::List(vec![0.0, 3.0, 4.0]),
                "verdict" => Datum::Text("hit".into()),
                "why" => Datum::Nothing,
                other => return Err(format!("nothing is called {other:?}")),
            })
        }
    }

    #[track_caller]
    fn check(text: &str, expected: Datum) {
        assert_eq!(evaluate(text, &Known), Ok(expected), "{text}");
    }

    #[test]
    fn operators_bind_as_in_mathematics() {
        // t² − 10t + 21 = (t − 3)(t − 7)
        check("(-b - sqrt(b^2 - 4*a*c))/(2*a)", Datum::Number(3.0));
        check("-b^2", Datum::Number(-100.0));
        check("2 + 3*4 - 1", Datum::Number(13.0));
        check("12/4/3", Datum::Number(1.0));
        check("n/2 + [1, 0, 0]", Datum::List(vec![1.0, 1.5, 2.0]));
        check("length(n)", Datum::Number(5.0));
        check(
            "cross([1, 0, 0], [0, 1, 0])",
            Datum::List(vec![0.0, 0.0, 1.0]),
        );
        check("acos(0)", Datum::Number(90.0));
        check("1e-3*2e2 - 1.5", Datum::Number(-1.3));
    }

    #[test]
    fn comparisons_are_true_or_false_and_what_is_absent_is_neither_smaller_nor_larger() {
        check("verdict = 'hit' and not (a > 2)", Datum::Flag(true));
        check("a = 2 or b < 0", Datum::Flag(true));
        check("why < 1 or why > 1", Datum::Flag(false));
        check("has(why)", Datum::Flag(false));
    }

    #[test]
    fn what_makes_no_sense_is_said() {
        for (text, part) in [
            ("a +", "ends too early"),
            ("a b", "unexpected b"),
            ("(a", "expected \")\""),
            ("verdict + 1", "is no number"),
            ("d", "nothing is called \"d\""),
            ("sine(a)", "no function"),
            ("dot(n)", "takes 2 values"),
            ("'hit", "quotation mark"),
            ("a # b", "unexpected '#'"),
            ("a and true", "neither true nor false"),
            (&"(".repeat(100_000), "at most 128 are read"),
        ] {
            let error = evaluate(text, &Known).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
