//! Line-oriented text: what NFF and OBJ have in common.
//!
//! Lines count from 1, `#` starts a comment that ends with its line, and words stand between white
//! space. Each word remembers its line, so that a mistake is reported with it.

use std::borrow::Cow;
use std::iter::Peekable;
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;

use crate::scene::fault::LARGEST;
use crate::scene::load::error::{LoadError, Place};
use crate::scene::quoted;

/// What stands between white space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    /// Counted from 1.
    pub(super) line: usize,
}

/// The lines without their comments, with their numbers.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    // the mark that some editors put first is no part of the first word
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let cut = |line: &'_ str| line.find('#').unwrap_or(line.len());
    (1..).zip(text.lines().map(move |line| &line[..cut(line)]))
}

/// The words of a line.
pub(super) fn words_of((line, text): (usize, &str)) -> impl Iterator<Item = Word<'_>> {
    let word = move |text| Word { text, line };
    text.split_whitespace().map(word)
}

/// Something that begins with a word and goes on with numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entity {
    /// Its name in a sentence: "the sphere".
    pub(super) what: &'static str,
    /// How it is written, as a sentence.
    pub(super) form: &'static str,
    /// The line where it begins.
    pub(super) line: usize,
    /// How many numbers follow those that are asked for next.
    pub(super) later: u64,
}

impl Entity {
    /// An entity that has all its numbers in one go.
    pub(super) fn new(what: &'static str, form: &'static str, line: usize) -> Self {
        Self {
            what,
            form,
            line,
            later: 0,
        }
    }
}

/// All words of a text, one after the other.
pub(super) struct Words<'a> {
    file: &'a str,
    text: &'a str,
    rest: Peekable<Box<dyn Iterator<Item = Word<'a>> + 'a>>,
    before: Option<Entity>,
}

impl<'a> Words<'a> {
    /// The words of a file.
    pub(super) fn new(file: &'a str, text: &'a str) -> Self {
        let words: Box<dyn Iterator<Item = Word<'a>> + 'a> =
            Box::new(lines(text).flat_map(words_of));
        Self {
            file,
            text,
            rest: words.peekable(),
            before: None,
        }
    }

    /// The next word, which stays the next one.
    pub(super) fn peek(&mut self) -> Option<Word<'a>> {
        self.rest.peek().copied()
    }

    /// The entity that was read last.
    pub(super) fn before(&self) -> Option<Entity> {
        self.before
    }

    /// The next numbers of an entity, whatever lines they are on.
    ///
    /// # Errors
    /// The end of the file, or a word that is no finite number.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        entity: &Entity,
    ) -> Result<[f64; N], LoadError> {
        let mut numbers = [0.0; N];
        for (i, value) in numbers.iter_mut().enumerate() {
            let missing = entity.later.saturating_add((N - i) as u64);
            let word = self.next_of(entity, missing)?;
            *value = number(word, entity.form).map_err(|(what, fix)| {
                let Entity { what: of, line, .. } = entity;
                let more = count(missing, "number", "numbers");
                let what = format!("{what}, and {of} of line {line} needs {more} more");
                self.error(word.line, what, fix)
            })?;
        }
        Ok(numbers)
    }

    /// The next word of an entity as a whole number.
    ///
    /// # Errors
    /// The end of the file, or a word that is no whole number of this type.
    pub(super) fn whole<T: FromStr>(&mut self, entity: &Entity) -> Result<T, LoadError> {
        let word = self.next_of(entity, entity.later.saturating_add(1))?;
        word.text.parse().map_err(|_| {
            let what = format!(
                "{} is not a whole number, or is too large for {}",
                quoted(word.text),
                entity.what
            );
            self.error(word.line, what, entity.form)
        })
    }

    /// A mistake in this file.
    pub(super) fn error(
        &self,
        line: impl Into<Option<usize>>,
        what: impl Into<String>,
        fix: impl Into<Box<str>>,
    ) -> LoadError {
        form_error(self.file, line, what, fix)
    }

    fn next_of(&mut self, entity: &Entity, missing: u64) -> Result<Word<'a>, LoadError> {
        self.before = Some(*entity);
        self.next().ok_or_else(|| {
            let Entity {
                what, form, line, ..
            } = entity;
            let numbers = count(missing, "number is", "numbers are");
            self.error(
                self.text.lines().count(),
                format!(
                    "the file ends inside {what} that begins in line {line}: {numbers} missing"
                ),
                format!("add the rest; {form}"),
            )
        })
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = Word<'a>;
    fn next(&mut self) -> Option<Word<'a>> {
        self.rest.next()
    }
}

/// The first three of the numbers that a line holds; the others are only checked.
///
/// # Errors
/// Too few numbers or too many, or a word that is no finite number.
pub(super) fn numbers_of(
    file: &str,
    entity: &Entity,
    words: &[Word<'_>],
    counts: RangeInclusive<usize>,
) -> Result<[f64; 3], LoadError> {
    let Entity {
        what, form, line, ..
    } = *entity;
    if !counts.contains(&words.len()) {
        let (least, most, here) = (counts.start(), counts.end(), words.len());
        let what = format!("{what} has {least} to {most} numbers, and there are {here}");
        return Err(form_error(file, line, what, form));
    }
    let mut numbers = [0.0; 3];
    for (i, &word) in words.iter().enumerate() {
        let value =
            number(word, form).map_err(|(what, fix)| form_error(file, word.line, what, fix))?;
        if let Some(number) = numbers.get_mut(i) {
            *number = value;
        }
    }
    Ok(numbers)
}

/// A mistake in a file.
pub(super) fn form_error(
    file: &str,
    line: impl Into<Option<usize>>,
    what: impl Into<String>,
    fix: impl Into<Box<str>>,
) -> LoadError {
    LoadError::Form {
        place: Place {
            file: file.into(),
            line: line.into(),
            path: String::new(),
        },
        what: what.into(),
        fix: fix.into(),
        schema: None,
    }
}

/// A count with the right one of two words: "1 face", "2 faces".
pub(super) fn count(count: u64, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// The file's name without folder and ending; empty if nothing is left.
pub(super) fn stem(file: &str) -> &str {
    let stem = Path::new(file).file_stem().and_then(|stem| stem.to_str());
    // the names of standard streams, such as "-", are no names
    stem.filter(|stem| stem.contains(char::is_alphanumeric))
        .unwrap_or_default()
}

/// The number that a word is, or what is wrong with it and what to do; `form` says what else to do.
fn number<'a>(word: Word<'_>, form: &'a str) -> Result<f64, (String, Cow<'a, str>)> {
    match word.text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err((
            format!("{} is not a finite number", quoted(word.text)),
            format!("give a number within ±{LARGEST:e}").into(),
        )),
        Err(_) => Err((
            format!("{} is not a number", quoted(word.text)),
            match word.text.replace(',', ".").parse::<f64>() {
                Ok(_) => "write decimals with a point, as in 0.5".into(),
                Err(_) => form.into(),
            },
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sphere() -> Entity {
        Entity::new("the sphere", "a sphere is written s x y z r", 2)
    }

    #[test]
    fn words_keep_their_lines_and_comments_are_cut() {
        let words: Vec<_> = Words::new("a", "\u{feff}a b# c\r\n\n#d\n e\t-1")
            .map(|word| (word.text, word.line))
            .collect();
        assert_eq!(words, [("a", 1), ("b", 1), ("e", 4), ("-1", 4)]);
    }

    #[test]
    fn numbers_are_read_across_lines() {
        let mut words = Words::new("a", "1 -2.5 # x\n+.5e1\n3.");
        assert_eq!(words.numbers(&sphere()).unwrap(), [1.0, -2.5, 5.0, 3.0]);
        assert_eq!(words.next(), None);
    }

    #[track_caller]
    fn refused(text: &str, message: &str) {
        let error = Words::new("a.nff", text)
            .numbers::<4>(&sphere())
            .unwrap_err();
        assert_eq!(error.to_string(), message);
    }

    #[test]
    fn what_is_no_number_is_told_with_its_line_and_what_to_do() {
        let more = "and the sphere of line 2 needs 2 numbers more";
        for word in ["nan", "-inf", "1e400", "infinity"] {
            refused(
                &format!("1 2\n{word} 4"),
                &format!(
                    "a.nff, line 2: {word:?} is not a finite number, {more}\n  \
                     give a number within ±1e50"
                ),
            );
        }
        refused(
            "1 2\n3,5 4",
            &format!(
                "a.nff, line 2: \"3,5\" is not a number, {more}\n  \
                 write decimals with a point, as in 0.5"
            ),
        );
        refused(
            "1 2\np 4",
            &format!(
                "a.nff, line 2: \"p\" is not a number, {more}\n  a sphere is written s x y z r"
            ),
        );
    }

    #[test]
    fn a_truncated_entity_is_told_with_both_lines() {
        refused(
            "\n\n1 2\n\n",
            "a.nff, line 4: the file ends inside the sphere that begins in line 2: \
             2 numbers are missing\n  add the rest; a sphere is written s x y z r",
        );
    }

    #[test]
    fn whole_numbers_are_neither_negative_nor_broken_nor_too_large() {
        for (word, value) in [("4", Some(4)), ("-1", None), ("3.5", None), ("300", None)] {
            let whole = Words::new("a", word).whole::<u8>(&sphere()).ok();
            assert_eq!(whole, value, "{word}");
        }
    }

    #[test]
    fn the_stem_of_a_stream_is_empty() {
        assert_eq!((stem("x/b.2.nff"), stem("-"), stem("")), ("b.2", "", ""));
    }
}
