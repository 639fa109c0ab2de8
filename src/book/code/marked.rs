//! A piece of a file in any language, between the marks that mdBook knows: `ANCHOR: name` and `ANCHOR_END: name` in comments.

use crate::book::code::text::{dedented, others};
use crate::scene::quoted;

/// The lines between two marks, without other marks among them.
///
/// # Errors
/// There are no such marks, or they stand there twice.
pub(super) fn item(text: &str, name: &str) -> Result<String, String> {
    let named = |line: &str, mark: &str| {
        let (_, rest) = line.split_once(mark)?;
        rest.split_whitespace().next().map(str::to_owned)
    };
    let begins = |line: &str| named(line, "ANCHOR:");
    let ends = |line: &str| named(line, "ANCHOR_END:");
    let lines: Vec<&str> = text.lines().collect();
    let places = |mark: &dyn Fn(&str) -> Option<String>| {
        let found = lines.iter().enumerate();
        let found = found.filter(|(_, line)| mark(line).as_deref() == Some(name));
        found.map(|(at, _)| at).collect::<Vec<_>>()
    };
    let (starts, stops) = (places(&begins), places(&ends));
    let (first, last) = match (&starts[..], &stops[..]) {
        ([first], [last]) if first < last => (first + 1, *last),
        ([], _) => {
            let known: Vec<String> = lines.iter().filter_map(|line| begins(line)).collect();
            return Err(format!(
                "there is no mark ANCHOR: {}\n  {}",
                name,
                others(name, &known)
            ));
        }
        _ => {
            return Err(format!(
                "the marks of {} are not one ANCHOR: and one ANCHOR_END: behind it\n  write each once",
                quoted(name)
            ));
        }
    };
    let kept = lines[first..last].iter();
    let kept: Vec<&str> = kept
        .filter(|line| begins(line).is_none() && ends(line).is_none())
        .copied()
        .collect();
    let indentation = kept
        .iter()
        .filter(|line| !line.trim().is_empty())
        .map(|line| line.len() - line.trim_start().len())
        .min();
    Ok(dedented(&kept.join("\n"), indentation.unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "a\n  # ANCHOR: two\n  b\n    # ANCHOR: inner\n    c\n    # ANCHOR_END: inner\n\n  # ANCHOR_END: two\nd # ANCHOR: open\n";

    #[test]
    fn the_lines_between_the_marks_are_shown_without_marks() {
        assert_eq!(item(TEXT, "two").unwrap(), "b\n  c");
        assert_eq!(item(TEXT, "inner").unwrap(), "c");
    }

    #[test]
    fn marks_that_are_missing_or_open_are_told() {
        assert!(item(TEXT, "tow").unwrap_err().contains("did you mean two?"));
        assert!(item(TEXT, "open").unwrap_err().contains("write each once"));
    }
}
