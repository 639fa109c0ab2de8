//! `{{#raystep-blanks NAME}}`: the worked solution of a pixel with some of its results taken out, to be worked out by hand.

use crate::explain::page::Page;
use crate::explain::render::{escaped, html, no_hint};

/// How many results are taken out if nothing is said.
pub(super) const USUAL: u32 = 3;

/// The page with results taken out, spread over its lines, and the answers behind a line that is opened, as HTML on one line.
///
/// # Errors
/// The page has fewer results.
pub(super) fn blanks(mut page: Page, count: u32) -> Result<String, String> {
    let lines = page.lines.iter().enumerate();
    let found: Vec<(usize, String)> = lines
        .filter_map(|(at, line)| Some((at, result(&line.text)?.to_owned())))
        .collect();
    let count = count as usize;
    if count == 0 || found.len() < count {
        return Err(format!(
            "{count} results cannot be taken out: these lines have {}\n  choose another number, or other lines by only=KIND",
            found.len()
        ));
    }
    let mut answers: Vec<String> = Vec::new();
    for place in 0..count {
        // from the middle of each of as many equal stretches
        let (first, answer) = &found[(2 * place + 1) * found.len() / (2 * count)];
        let number = answers.len() + 1;
        let mark = format!("[{number}]");
        // a later line would tell it; a short number stands for other things too
        let is_telling = 3 <= answer.chars().filter(char::is_ascii_digit).count();
        let Some((before, _)) = page.lines[*first].text.rsplit_once(" = ") else {
            continue;
        };
        let behind =
            page.lines[*first].text[before.len() + " = ".len()..].replacen(&**answer, &mark, 1);
        page.lines[*first].text = format!("{before} = {behind}");
        if is_telling {
            for line in &mut page.lines[first + 1..] {
                line.text = without(&line.text, answer, &mark);
            }
        }
        answers.push(answer.clone());
    }
    let items: String = answers
        .iter()
        .enumerate()
        .map(|(at, answer)| format!("<li>[{}] is {}</li>", at + 1, escaped(answer)))
        .collect();
    Ok(format!(
        "<div class=\"raystep-blanks\">{}<details><summary>Answers</summary><ul>{items}</ul></details></div>",
        html(&page, no_hint)
    ))
}

/// The number or the vector that a line ends up with: what follows its last equals sign.
fn result(text: &str) -> Option<&str> {
    let (before, last) = text.rsplit_once(" = ")?;
    let end = if last.starts_with('(') {
        last.find(')')? + 1
    } else {
        let is_digit = |c: char| c.is_ascii_digit() || "−-.e".contains(c);
        last.find(|c| !is_digit(c)).unwrap_or(last.len())
    };
    let found = last[..end].trim_end_matches(['.', 'e']);
    let is_number = found.contains(|c: char| c.is_ascii_digit());
    // what is given is no result: t = 4 alone has no working
    (is_number && before.contains(" = ") || is_number && before.contains(['·', '−', '+', '/']))
        .then_some(found)
}

/// The text with a mark in the place of a number, wherever it stands by itself.
fn without(text: &str, number: &str, mark: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    let mut copied = 0;
    for (at, _) in text.match_indices(number) {
        let is_part = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit() || c == '.');
        let behind = &text[at + number.len()..];
        let mut next = behind.chars();
        let goes_on = match next.next() {
            Some('.') => is_part(next.next()),
            other => is_part(other),
        };
        if at < copied || goes_on || is_part(text[..at].chars().next_back()) {
            continue;
        }
        safe.push_str(&text[copied..at]);
        safe.push_str(mark);
        copied = at + number.len();
    }
    safe.push_str(&text[copied..]);
    safe
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explain::{Line, Tone};

    fn page(texts: &[&str]) -> Page {
        let line = |text: &&str| Line {
            gap: false,
            indent: 0,
            tone: Tone::Plain,
            ray: None,
            steps: None,
            part: None,
            text: (*text).into(),
        };
        Page {
            lines: texts.iter().map(line).collect(),
        }
    }

    #[test]
    fn results_are_taken_out_wherever_they_stand() {
        let page = page(&[
            "sphere, radius 1",
            "b = 2·Δ·(o − centre) = 2·3 = −11.5",
            "c = |o − centre|² − r² = 35",
            "discriminant: b² − 4ac = 132.25 − 140 = −7.75 < 0: no real root",
            "of b = −11.5 and −11.55",
        ]);
        let shown = blanks(page, 2).unwrap();
        assert!(shown.contains("2·3 = [1]<"), "{shown}");
        assert!(shown.contains("132.25 − 140 = [2] &lt; 0"), "{shown}");
        assert!(shown.contains("of b = [1] and −11.55"), "{shown}");
        assert!(
            shown.contains("<li>[1] is −11.5</li><li>[2] is −7.75</li>"),
            "{shown}"
        );
        assert!(shown.contains("r² = 35"), "{shown}");
    }

    #[test]
    fn the_result_of_a_line_is_what_follows_its_last_equals_sign() {
        assert_eq!(result("L = (a − b)/2 = (0.5, −1, 2)"), Some("(0.5, −1, 2)"));
        assert_eq!(result("frame: o − centre = (0, 0, 6)"), Some("(0, 0, 6)"));
        assert_eq!(result("t = 4"), None);
        assert_eq!(result("no number at all"), None);
        assert_eq!(result("x = y·z = none"), None);
    }

    #[test]
    fn more_than_there_are_cannot_be_taken_out() {
        let told = blanks(page(&["a = 1 + 2 = 3"]), 2).unwrap_err();
        assert!(told.contains("these lines have 1"), "{told}");
        blanks(page(&["a = 1 + 2 = 3"]), 0).unwrap_err();
    }
}
