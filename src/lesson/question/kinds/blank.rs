//! Worked lines with quantities taken out.

use crate::explain::shown;
use crate::lesson::question::asked::{BlankForm, Form};
use crate::lesson::question::fault::Fault;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::Blank;

/// Digits of a number in worked lines.
const DIGITS: u32 = 6;

/// The most digits there, where a difference loses some.
const MOST_DIGITS: u32 = 12;

/// An answer with three right digits is right.
const TOLERANCE: f64 = 5e-3;

pub(in crate::lesson::question) fn blank(
    situation: &Situation<'_>,
    of: &Blank,
) -> Result<Form, Fault> {
    let key = "ask.blank";
    let mut lines = Vec::new();
    if of.lines.is_empty() {
        for line in situation.step_lines() {
            lines.push(format!("{}{}", "  ".repeat(line.indent), line.text));
        }
    }
    for (place, line) in of.lines.iter().enumerate() {
        lines.push(situation.filled(&format!("{key}.lines[{place}]"), line)?);
    }
    let mut answers = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    for (place, expression) in of.take.iter().enumerate() {
        let key = format!("{key}.take[{place}]");
        let value = situation
            .facts
            .value(expression)
            .and_then(|value| value.number());
        let value = value.map_err(|what| Fault::text(key.clone(), what))?;
        let text = shown(value, DIGITS);
        if seen.contains(&text) {
            let what = format!("{text} is taken out already");
            return Err(Fault::new(key, what, "take out another quantity"));
        }
        let mark = format!("[{}]", place + 1);
        let mut is_there = false;
        // the longest first: a shorter one may be the beginning of it
        for digits in (DIGITS..=MOST_DIGITS).rev() {
            let text = shown(value, digits);
            for line in &mut lines {
                let taken = without(line, &text, &mark);
                is_there |= taken != *line;
                *line = taken;
            }
        }
        if !is_there {
            return Err(Fault::new(
                key,
                format!("{expression:?} is {text}, which is in none of the lines"),
                "take out a quantity that the lines have",
            ));
        }
        seen.push(text);
        answers.push((value, TOLERANCE * value.abs()));
    }
    if answers.is_empty() {
        let key = format!("{key}.take");
        return Err(Fault::new(
            key,
            "nothing is taken out",
            "name a quantity or several",
        ));
    }
    Ok(Form::Blank(BlankForm {
        lines,
        answers,
        reason: situation.filled(&format!("{key}.reason"), &of.reason)?,
    }))
}

/// A line with a mark wherever the number stands by itself.
fn without(line: &str, number: &str, mark: &str) -> String {
    let mut taken = String::new();
    let mut rest = line;
    while let Some(at) = rest.find(number) {
        let (before, from) = rest.split_at(at);
        let after = &from[number.len()..];
        let is_part = |c: char| c.is_ascii_digit() || c == '.';
        let goes_on = match (after.chars().next(), after.chars().nth(1)) {
            (Some('.'), Some(next)) => next.is_ascii_digit(),
            (Some(next), _) => next.is_ascii_digit() || next == 'e',
            (None, _) => false,
        };
        let begins = before.chars().next_back().is_some_and(is_part);
        taken.push_str(before);
        taken.push_str(if begins || goes_on { number } else { mark });
        rest = after;
    }
    taken.push_str(rest);
    taken
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_taken_out_where_it_stands_alone() {
        let line = "t = (8.2 − 1.8)/2 = 3.2; 13.2, 3.25, 3.2e5, 3.2.";
        let taken = "t = (8.2 − 1.8)/2 = [1]; 13.2, 3.25, 3.2e5, [1].";
        assert_eq!(without(line, "3.2", "[1]"), taken);
        assert_eq!(without("b = −8.2", "−8.2", "[2]"), "b = [2]");
    }
}
