//! `{{#raystep-blanks NAME}}`: the worked solution of a pixel with some of its results taken out, to be worked out by hand.

use std::fmt::Write;
use std::ops::Range;

use crate::explain::Tone;
use crate::explain::page::Page;
use crate::explain::render::{escaped, html, no_hint};

/// What has a number for its name.
const NAMED: [&str; 3] = ["node ", "leaf ", "slab "];

/// How many results are taken out if nothing is said.
pub(super) const USUAL: u32 = 3;

/// Which results are taken out.
#[derive(Clone, Debug)]
pub(super) struct Taken {
    /// The largest number of blanks.
    pub(super) count: u32,
    /// Only those of lines that have this word: what follows from the other lines.
    pub(super) word: Option<String>,
}

/// The page with some of its results taken out, spread over its lines, and the answers behind a line that is opened, as
/// HTML on one line.
///
/// # Errors
/// The page has no result.
pub(super) fn blanks(mut page: Page, taken: &Taken) -> Result<String, String> {
    let has_word = |text: &str| {
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        let wanted = taken.word.as_deref();
        wanted.is_none_or(|wanted| words.any(|word| word == wanted))
    };
    let lines = page.lines.iter().enumerate();
    let found: Vec<(usize, Range<usize>)> = lines
        .filter(|(_, line)| {
            let is_told = line.steps.is_some();
            is_told && !matches!(line.tone, Tone::Heading | Tone::Folded(_)) && has_word(&line.text)
        })
        .filter_map(|(at, line)| Some((at, result(&line.text)?)))
        .collect();
    let count = found.len().min(taken.count as usize);
    if count == 0 {
        return Err(
            "no line has a result that can be taken out\n  choose other lines by only=KIND, word=WORD or all, or another figure"
                .into(),
        );
    }
    let mut answers: Vec<String> = Vec::new();
    // from the middle of each of as many equal stretches; from behind, so that no place moves
    let chosen = (0..count).map(|place| &found[(2 * place + 1) * found.len() / (2 * count)]);
    for (line, range) in chosen {
        let answer = page.lines[*line].text[range.clone()].to_owned();
        let mark = format!("[{}]", answers.len() + 1);
        // a later line would tell it; a short number stands for other things too
        let is_telling = 3 <= answer.chars().filter(char::is_ascii_digit).count();
        page.lines[*line].text.replace_range(range.clone(), &mark);
        if is_telling {
            let later = found.iter().map(|(line, _)| *line).collect::<Vec<_>>();
            for other in line + 1..page.lines.len() {
                // the places of results that are still to be taken out stay
                if !later.contains(&other) {
                    page.lines[other].text = without(&page.lines[other].text, &answer, &mark);
                }
            }
        }
        answers.push(answer);
    }
    let mut items = String::new();
    for (at, answer) in answers.iter().enumerate() {
        // writing into a String does not fail
        let _ = write!(items, "<li>[{}] is {}</li>", at + 1, escaped(answer));
    }
    Ok(format!(
        "<div class=\"raystep-blanks\">{}<details><summary>Answers</summary><ul>{items}</ul></details></div>",
        html(&page, no_hint)
    ))
}

/// Where the number or the vector stands that a line ends up with: behind its last equals sign if it has one, else its last
/// number.
fn result(text: &str) -> Option<Range<usize>> {
    let sign = text
        .match_indices("= ")
        .filter(|(at, _)| text[..*at].is_empty() || text[..*at].ends_with(' '))
        .last();
    if let Some((at, _)) = sign {
        let start = at + "= ".len();
        let end = start + length(&text[start..])?;
        // a term of what follows is no result
        let goes_on = text[end..]
            .trim_start()
            .starts_with(['+', '−', '·', '/', '×', '²', '^']);
        return (!goes_on).then_some(start..end);
    }
    // a name follows from nothing
    let is_name = |range: &Range<usize>| NAMED.iter().any(|of| text[..range.start].ends_with(of));
    let numbers: Vec<Range<usize>> = numbers(text).filter(|range| !is_name(range)).collect();
    let is_decimal = |range: &&Range<usize>| text[(*range).clone()].contains('.');
    numbers
        .iter()
        .rev()
        .find(is_decimal)
        .or(numbers.last())
        .cloned()
}

/// How long the number or the vector is that stands here.
fn length(text: &str) -> Option<usize> {
    if text.starts_with('(') {
        let end = text.find(')')? + 1;
        let is_vector = |c: char| c.is_ascii_digit() || "(), .−-e".contains(c);
        return text[..end].chars().all(is_vector).then_some(end);
    }
    numbers(text)
        .next()
        .filter(|range| range.start == 0)
        .map(|range| range.end)
}

/// The numbers of a text that are no parts of words.
fn numbers(text: &str) -> impl Iterator<Item = Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let start = at + text[at..].find(|c: char| c.is_ascii_digit())?;
            let is_digit = |c: char| c.is_ascii_digit() || c == '.';
            let end = text[start..]
                .find(|c| !is_digit(c))
                .map_or(text.len(), |end| start + end);
            let end = start + text[start..end].trim_end_matches('.').len();
            at = end;
            let before = text[..start].chars().next_back();
            let behind = text[end..].chars().next();
            let is_part =
                |c: Option<char>| c.is_some_and(|c| c.is_alphabetic() || "₀₁₂₃_".contains(c));
            if is_part(before) || is_part(behind) {
                continue;
            }
            let sign = if before == Some('−') {
                '−'.len_utf8()
            } else {
                0
            };
            return Some(start - sign..end);
        }
    })
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
    use crate::explain::{Line, Section, StepAddress, StepRange};

    fn page(texts: &[&str]) -> Page {
        let step = StepAddress {
            section: Section::Pixel,
            step: 0,
        };
        let line = |text: &&str| Line {
            gap: false,
            indent: 0,
            tone: Tone::Plain,
            ray: None,
            steps: Some(StepRange {
                first: step,
                last: step,
            }),
            part: None,
            text: (*text).into(),
        };
        Page {
            lines: texts.iter().map(line).collect(),
        }
    }

    fn taken(count: u32) -> Taken {
        Taken { count, word: None }
    }

    #[test]
    fn results_are_taken_out_wherever_they_stand() {
        let page = page(&[
            "b = 2·Δ·(o − centre) = 2·3 = −11.5",
            "c = |o − centre|² − r² = 35",
            "discriminant: b² − 4ac = 132.25 − 140 = −7.75 < 0: no real root",
            "b = −11.5 + −11.55, and so on",
        ]);
        let shown = blanks(page, &taken(2)).unwrap();
        assert!(shown.contains("2·3 = [1]<"), "{shown}");
        assert!(shown.contains("132.25 − 140 = [2] &lt; 0"), "{shown}");
        assert!(shown.contains("b = [1] + −11.55"), "{shown}");
        assert!(
            shown.contains("<li>[1] is −11.5</li><li>[2] is −7.75</li>"),
            "{shown}"
        );
        assert!(shown.contains("r² = 35"), "{shown}");
    }

    #[test]
    fn the_result_of_a_line_is_what_follows_its_last_equals_sign_or_its_last_number() {
        for (text, found) in [
            ("L = (a − b)/2 = (0.5, −1, 2)", Some("(0.5, −1, 2)")),
            ("= (1.04, 1.3, −1.78)", Some("(1.04, 1.3, −1.78)")),
            ("= (1, 0, 0) + 0.5·(0, 1, 0)", None),
            ("x = y·z = none", None),
            ("discriminant: b² − 4ac = 4 > 0: two real roots", Some("4")),
            (
                "hit, inside for t in [−1.36, 11.35], so the node can be entered",
                Some("11.35"),
            ),
            ("node 2 goes in with key 3.15; 2 nodes wait", Some("3.15")),
            ("inside or outside: 2 crossings, an even number", Some("2")),
            ("no number at all: t₁ and l04", None),
            ("bounding volume of node 13 (slabs): missed", None),
        ] {
            assert_eq!(result(text).map(|range| &text[range]), found, "{text}");
        }
    }

    #[test]
    fn no_more_are_taken_out_than_there_are() {
        let shown = blanks(page(&["a = 1 + 2 = 3"]), &taken(2)).unwrap();
        assert!(shown.contains("[1]") && !shown.contains("[2]"), "{shown}");
        blanks(page(&["a = 1 + 2 = 3"]), &taken(0)).unwrap_err();
        blanks(page(&["no number"]), &taken(1)).unwrap_err();
    }

    #[test]
    fn only_lines_with_the_word_lose_their_result() {
        let lines = [
            "node 1 waits at t = 2.5",
            "node 1 is nearest, key 2.5",
            "nearestmost is 7",
        ];
        let taken = Taken {
            count: 3,
            word: Some("nearest".into()),
        };
        let shown = blanks(page(&lines), &taken).unwrap();
        assert!(shown.contains("at t = 2.5<"), "{shown}");
        assert!(
            shown.contains("key [1]<") && !shown.contains("[2]"),
            "{shown}"
        );
    }
}
