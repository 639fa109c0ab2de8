//! Texts that differ in their numbers alone: each form once, and the numbers of each text.
//!
//! The steps of a pixel are thousands of tests of a few kinds. Written out, each has two kilobytes, of which the numbers are
//! the smallest part; what zip leaves of the rest is still more than half of a page.
//!
//! A row is the place of a text's form, and then, each behind a space, its numbers:
//!
//! | mark | the number |
//! |---|---|
//! | nothing | that of the text of this form before, at this place |
//! | `+` | the same plus 1 |
//! | `@2` | the one at place 2 of this row; places are written in base 36 |
//! | `7.25` | 7.25 |

use std::collections::HashMap;

use serde::Serialize;

/// Texts by form and numbers. The text is whatever it is: it comes back letter by letter.
#[derive(Debug, Default, Serialize)]
pub(super) struct Forms {
    /// Of each form the pieces between which the numbers stand; one more than there are numbers.
    forms: Vec<Vec<String>>,
    /// The texts.
    rows: Vec<String>,
}

impl Forms {
    pub(super) fn of(texts: impl Iterator<Item = String>) -> Self {
        let mut known: HashMap<Vec<String>, usize> = HashMap::new();
        // the numbers of the last text of each form
        let mut last: Vec<Vec<String>> = Vec::new();
        let mut rows = Vec::new();
        for text in texts {
            let (pieces, numbers) = taken_apart(&text);
            let next = known.len();
            let form = *known.entry(pieces).or_insert(next);
            if form == last.len() {
                last.push(Vec::new());
            }
            let mut row = form.to_string();
            for (place, number) in numbers.iter().enumerate() {
                row.push(' ');
                row.push_str(&mark(&numbers, place, number, last[form].get(place)));
            }
            last[form] = numbers;
            rows.push(row);
        }
        let mut forms: Vec<(Vec<String>, usize)> = known.into_iter().collect();
        forms.sort_by_key(|(_, form)| *form);
        Self {
            forms: forms.into_iter().map(|(pieces, _)| pieces).collect(),
            rows,
        }
    }
}

/// Numbers as a page has them: each as the distance from the one before, the first from 0. Most are 1, which takes next to no
/// room.
pub(super) fn distances(numbers: impl Iterator<Item = usize>) -> Vec<isize> {
    let mut before = 0;
    numbers
        .map(|number| number.cast_signed() - std::mem::replace(&mut before, number).cast_signed())
        .collect()
}

/// How a number is written, where the text of its form before had another one at its place.
fn mark(numbers: &[String], place: usize, number: &str, before: Option<&String>) -> String {
    if before.is_some_and(|before| before == number) {
        return String::new();
    }
    let next = before.and_then(|before| before.parse::<u32>().ok()?.checked_add(1));
    if next.is_some_and(|next| next.to_string() == number) {
        return "+".into();
    }
    match numbers[..place].iter().position(|known| known == number) {
        // a digit or two take no more room
        Some(known) if 2 < number.len() => format!("@{}", in_base_36(known)),
        _ => number.into(),
    }
}

fn in_base_36(number: usize) -> String {
    const BASE: u32 = 36;
    let mut rest = number as u32;
    let mut digits = Vec::new();
    loop {
        digits.extend(char::from_digit(rest % BASE, BASE));
        rest /= BASE;
        if rest == 0 {
            return digits.into_iter().rev().collect();
        }
    }
}

/// The pieces of a text, and the numbers between them: digits, or digits with a point among them.
fn taken_apart(text: &str) -> (Vec<String>, Vec<String>) {
    let (mut pieces, mut numbers) = (Vec::new(), Vec::new());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (piece, from) = rest.split_at(start);
        let digits = |text: &str| {
            text.find(|c: char| !c.is_ascii_digit())
                .unwrap_or(text.len())
        };
        let mut end = digits(from);
        if let Some(behind) = from[end..].strip_prefix('.')
            && behind.starts_with(|c: char| c.is_ascii_digit())
        {
            end += 1 + digits(behind);
        }
        pieces.push(piece.into());
        numbers.push(from[..end].into());
        rest = &from[end..];
    }
    pieces.push(rest.into());
    (pieces, numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_taken_apart_at_its_numbers() {
        let (pieces, numbers) = taken_apart("a = −2.50 of ball-007, 3. and 1e-5");
        assert_eq!(pieces, ["a = −", " of ball-", ", ", ". and ", "e-", ""]);
        assert_eq!(numbers, ["2.50", "007", "3", "1", "5"]);
        assert_eq!(taken_apart("none").0, ["none"]);
        assert_eq!(taken_apart("").0, [""]);
    }

    #[test]
    fn a_row_says_what_is_new() {
        let texts = [
            "step 9: 0.25 + 0.25",
            "step 10: 0.25 + 0.5",
            "none",
            "step 11: 0.75 + 4",
            "step 011: 0.75 + 5",
        ];
        let forms = Forms::of(texts.map(String::from).into_iter());
        assert_eq!(forms.forms, [vec!["step ", ": ", " + ", ""], vec!["none"]]);
        // the last: 011 is no 12, and 5 is 4 plus 1
        assert_eq!(
            forms.rows,
            ["0 9 0.25 @1", "0 +  0.5", "1", "0 + 0.75 4", "0 011  +"]
        );
    }

    #[test]
    fn a_number_is_the_distance_from_the_one_before() {
        assert_eq!(distances([3, 4, 5, 5, 2].into_iter()), [3, 1, 1, 0, -3]);
    }

    #[test]
    fn places_have_digits_and_then_letters() {
        assert_eq!(
            [0, 9, 10, 35, 36, 1295].map(in_base_36),
            ["0", "9", "a", "z", "10", "zz"]
        );
    }
}
