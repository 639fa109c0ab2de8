//! Takes a line of the log apart, byte after byte, as the writer put it together.
//!
//! It knows what the writer writes and no more: no white space, no escapes. Whatever else JSON
//! allows, and whatever is wrong, it answers with `None` or `false`.

/// A place in a line.
#[derive(Clone, Debug)]
pub(super) struct Scanner<'a> {
    rest: &'a str,
}

impl<'a> Scanner<'a> {
    /// The start of a line.
    pub(super) fn new(line: &'a str) -> Self {
        Self { rest: line }
    }

    /// Is the line at its end?
    pub(super) fn is_at_end(&self) -> bool {
        self.rest.is_empty()
    }

    /// Steps over this text, if it is next.
    #[inline]
    pub(super) fn take(&mut self, text: &str) -> bool {
        match self.rest.strip_prefix(text) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Steps over `,"key":`, if it is next.
    #[inline]
    pub(super) fn take_key(&mut self, key: &str) -> bool {
        let after_key = self
            .rest
            .strip_prefix(",\"")
            .and_then(|rest| rest.strip_prefix(key));
        match after_key.and_then(|rest| rest.strip_prefix("\":")) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// The text between two quotation marks, none of which needs an escape.
    #[inline]
    pub(super) fn plain_text(&mut self) -> Option<&'a str> {
        let inside = self.rest.strip_prefix('"')?;
        let needs_escape = |byte: u8| byte == b'"' || byte == b'\\' || byte < b' ';
        let end = inside.bytes().position(needs_escape)?;
        let (text, rest) = inside.split_at(end);
        self.rest = rest.strip_prefix('"')?;
        Some(text)
    }

    /// A whole number of 0 or more, of up to 9 digits: so it is below 2³².
    #[inline]
    pub(super) fn whole_number(&mut self) -> Option<u32> {
        let (digits, rest) = split_digits(self.rest);
        let leading_zero = digits.starts_with('0') && digits != "0";
        let goes_on = rest.starts_with(['.', 'e', 'E']);
        if !(1..=9).contains(&digits.len()) || leading_zero || goes_on {
            return None;
        }
        self.rest = rest;
        let value = |digit: u8| u32::from(digit - b'0');
        Some(digits.bytes().fold(0, |sum, digit| 10 * sum + value(digit)))
    }

    /// A number, correctly rounded: `-`? digits (`.` digits)? (`e` (`+`|`-`)? digits)?
    #[inline]
    pub(super) fn next_number(&mut self) -> Option<f64> {
        if let Some(value) = self.digit_and_zero() {
            return Some(value);
        }
        let unsigned = self.rest.strip_prefix('-').unwrap_or(self.rest);
        let (whole, mut rest) = split_digits(unsigned);
        if whole.is_empty() || (whole.starts_with('0') && whole != "0") {
            return None;
        }
        if let Some(fraction) = rest.strip_prefix('.') {
            rest = after_digits(fraction)?;
        }
        if let Some(exponent) = rest.strip_prefix(['e', 'E']) {
            rest = after_digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent))?;
        }
        let (text, rest) = self.rest.split_at(self.rest.len() - rest.len());
        self.rest = rest;
        // beyond the largest f64: not a number of JSON
        text.parse().ok().filter(|value: &f64| value.is_finite())
    }

    /// Every fourth number is one digit and `.0`.
    #[inline]
    fn digit_and_zero(&mut self) -> Option<f64> {
        let [digit @ b'0'..=b'9', b'.', b'0', b',' | b']' | b'}', ..] = *self.rest.as_bytes()
        else {
            return None;
        };
        self.rest = &self.rest[3..];
        Some(f64::from(digit - b'0'))
    }
}

/// The digits at the start, and what follows them.
#[inline]
fn split_digits(text: &str) -> (&str, &str) {
    let end = text.bytes().position(|byte| !byte.is_ascii_digit());
    text.split_at(end.unwrap_or(text.len()))
}

/// What follows the digits at the start; `None` if there are none.
#[inline]
fn after_digits(text: &str) -> Option<&str> {
    let (digits, rest) = split_digits(text);
    (!digits.is_empty()).then_some(rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number at the start of a text, and what is left.
    fn number(text: &str) -> (Option<f64>, &str) {
        let mut scanner = Scanner::new(text);
        let value = scanner.next_number();
        (value, scanner.rest)
    }

    #[test]
    fn a_number_is_read_as_the_standard_library_reads_it() {
        for text in [
            "0",
            "7",
            "10",
            "1.0",
            "9.0",
            "-0.0",
            "-1.0",
            "0.1",
            "2.5e-7",
            "1E+3",
            "5e-324",
            "1.7976931348623157e308",
            "0.30000000000000004",
            "123456789012345678901234567890",
        ] {
            let expected: f64 = text.parse().unwrap();
            for after in [",", "]", "}", ""] {
                let line = format!("{text}{after}");
                let (value, rest) = number(&line);
                assert_eq!(value.map(f64::to_bits), Some(expected.to_bits()), "{line}");
                assert_eq!(rest, after);
            }
        }
    }

    #[test]
    fn what_json_does_not_call_a_number_is_none() {
        for text in [
            "", "-", "+1", ".5", "1.", "1.e5", "1e", "1e+", "01", "-01", "NaN", "inf", "1e400",
            "null", "\"1\"", "٣",
        ] {
            assert_eq!(number(text).0, None, "{text}");
        }
    }

    #[test]
    fn a_whole_number_has_neither_sign_nor_fraction() {
        let whole = |text| Scanner::new(text).whole_number();
        assert_eq!(whole("0,"), Some(0));
        assert_eq!(whole("999999999}"), Some(999_999_999));
        for text in ["", "-1", "1.0", "1e3", "00", "01", "4294967296", "x"] {
            assert_eq!(whole(text), None, "{text}");
        }
    }

    #[test]
    fn a_text_that_needs_an_escape_is_none() {
        let text = |line| Scanner::new(line).plain_text();
        assert_eq!(text("\"\","), Some(""));
        assert_eq!(text("\"lämp\"}"), Some("lämp"));
        for line in ["", "x", "\"open", "\"a\\n\"", "\"a\\\"\"", "\"a\nb\""] {
            assert_eq!(text(line), None, "{line}");
        }
    }
}
