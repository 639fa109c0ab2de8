//! The terminal says what every face says.

use raystep::step::Cursor;
use raystep::step::{Level, StepLog, StepWords};
use raystep::tui::{App, Kept, Look, Titles};

use super::{buffer, rows};
use crate::step::each_of_few;

/// Without blanks, which depend on where lines are broken.
fn letters(text: &str) -> String {
    text.split_whitespace().collect()
}

/// What stands between two titles of parts.
fn part(rows: &[String], title: &str) -> String {
    let is_title =
        |row: &&String| row.starts_with(' ') && row.contains("──") || row.contains(" ──");
    let start = rows
        .iter()
        .position(|row| row.starts_with(&format!(" {title} ─")));
    let after = &rows[start.unwrap_or_else(|| panic!("no {title}: {rows:#?}")) + 1..];
    let end = after
        .iter()
        .position(|row| is_title(&row))
        .unwrap_or(after.len() - 1);
    after[..end].concat()
}

#[test]
fn the_terminal_shows_the_words_of_each_step_and_what_it_changed() {
    let (mut logs, mut steps, mut changes) = (0, 0, 0);
    each_of_few(|name, log: &StepLog| {
        let words = StepWords::new(log);
        logs += 1;
        let count = log.steps().len();
        for step in (logs % 7 % count..count).step_by(1 + count / 2) {
            let told = log.told(&words, step);
            let mut app = App::new(
                log,
                Cursor::at(log, step),
                Kept::new(false),
                Titles::default(),
            );
            // as high as any working, and too narrow for the drawing
            let size = [109, 300];
            let buffer = buffer(&mut app, size, Look::default());
            // the tree takes 42 of 100 columns
            let rows = rows(&buffer, 46);
            let place = format!("{name}, step {step}");
            let mut expected = format!("{}{}", told.title, told.place);
            for line in &told.lines {
                expected.push_str(&line.text);
            }
            for fact in told.facts() {
                if !fact.starts_with("changed: ") {
                    expected.push_str(&fact);
                }
            }
            assert_eq!(
                letters(&part(&rows, "working")),
                letters(&expected),
                "{place}"
            );
            let state = letters(&part(&rows, "state"));
            for change in &told.changes {
                assert!(
                    state.contains(&letters(change)),
                    "{place}: {change}\n{state}"
                );
                changes += 1;
            }
            // the tree beside it has the title, cut where it is long
            let all = super::rows(&buffer, 0);
            let here: String = told.title.chars().take(20).collect();
            assert!(all.iter().any(|row| row.contains(&here)), "{place}: {here}");
            steps += usize::from(log.step(step).level <= Level::Term);
        }
    });
    assert!(500 < steps && 400 < changes, "{steps} {changes}");
}
