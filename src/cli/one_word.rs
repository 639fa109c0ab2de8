//! `80 60` where `80,60` is meant: the error says how to write it.

use std::ffi::OsString;

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};

/// The most numbers that one argument has: the cells of a grid, along x, y and z.
const MOST: usize = 3;

/// The error with a tip, if the arguments make sense once two or three numbers in a row are one word: a pixel, a size,
/// cells.
pub(super) fn with_tip(
    mut error: Error,
    arguments: &[OsString],
    makes_sense: impl Fn(&[OsString]) -> bool,
) -> Error {
    let kinds = [ErrorKind::UnknownArgument, ErrorKind::ValueValidation];
    if kinds.contains(&error.kind())
        && let Some(word) = joined(arguments, makes_sense)
    {
        let tip = StyledStr::from(format!("write it as one word: {word}"));
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip]));
    }
    error
}

/// The numbers as one word, without the option that they belong to.
fn joined(arguments: &[OsString], makes_sense: impl Fn(&[OsString]) -> bool) -> Option<String> {
    let words: Vec<&str> = arguments
        .iter()
        .map(|word| word.to_str().unwrap_or_default())
        .collect();
    let ends = |start: usize| (start + 2..=words.len()).take(MOST - 1);
    let mut runs = (0..words.len()).flat_map(|start| ends(start).map(move |end| (start, end)));
    runs.find_map(|(start, end)| {
        // as in --region=80 60
        let (option, first) = match words[start].split_once('=') {
            Some((option, first)) => (format!("{option}="), first),
            None => (String::new(), words[start]),
        };
        let numbers = std::iter::once(first).chain(words[start + 1..end].iter().copied());
        let numbers: Option<Vec<&str>> = numbers.map(number).collect();
        let word = numbers?.join(",");
        let one = OsString::from(format!("{option}{word}"));
        let changed = [&arguments[..start], &[one], &arguments[end..]].concat();
        makes_sense(&changed).then_some(word)
    })
}

/// A whole number, perhaps with a comma beside it: `80,` and `60`.
fn number(word: &str) -> Option<&str> {
    let digits = word.trim_matches(',');
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some(digits)
}
