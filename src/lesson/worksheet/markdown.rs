//! A sheet as Markdown, in one file that prints: figures are in it as data.

use std::fmt::Write;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;

use crate::explain::page::Page;
use crate::explain::render::{self, escaped_markdown as escaped};
use crate::lesson::question::{Form, letter};
use crate::lesson::worksheet::sheet::{Figure, Item, Worksheet};

impl Worksheet {
    /// The sheet to be filled in; with answers the key, which has the questions too, each with its answer, why every other is wrong, and
    /// the worked solution.
    pub fn markdown(&self, with_answers: bool) -> String {
        let mut text = String::new();
        let number = self.lesson.split('-').next().unwrap_or(&self.lesson);
        let what = if with_answers {
            "Key to worksheet"
        } else {
            "Worksheet"
        };
        let _ = writeln!(
            text,
            "# {what} {}: {}\n",
            escaped(number),
            escaped(&self.title)
        );
        if with_answers {
            let _ = writeln!(text, "Seed {}\n", self.seed);
        } else {
            let _ = writeln!(text, "Seed {} · Name: {}\n", self.seed, blank(40));
        }
        for (place, item) in self.items.iter().enumerate() {
            let _ = writeln!(text, "## {}\n", place + 1);
            question(&mut text, item, with_answers);
            if with_answers {
                key(&mut text, item);
            } else {
                room(&mut text, item);
            }
        }
        text
    }
}

/// A line to write on.
fn blank(length: usize) -> String {
    "\\_".repeat(length)
}

fn question(text: &mut String, item: &Item, with_answers: bool) {
    let asked = &item.asked;
    let _ = writeln!(text, "{}\n", escaped(&asked.text));
    if let Some([given, whole]) = &item.figure {
        let figure = if with_answers { whole } else { given };
        let _ = writeln!(text, "{}\n", image(figure));
    }
    if let Form::Blank(of) = &asked.form {
        for line in &of.lines {
            let _ = writeln!(text, "> {}  ", escaped(line));
        }
        text.push('\n');
    }
    let choices = asked.form.choices();
    for (place, choice) in choices.iter().enumerate() {
        let _ = writeln!(text, "- **{}** {}", letter(place), escaped(&choice.text));
    }
    if !choices.is_empty() {
        text.push('\n');
    }
}

/// A figure as data, so that the sheet is one file.
fn image(figure: &Figure) -> String {
    let description = escaped(&figure.description.replace('\n', " "));
    let data = BASE64.encode(&figure.svg);
    format!("![{description}](data:image/svg+xml;base64,{data})")
}

/// Where the answer is written.
fn room(text: &mut String, item: &Item) {
    let accepted = item.asked.accepts();
    match &item.asked.form {
        Form::Number(number) => {
            let _ = writeln!(text, "Answer: {} {}\n", blank(16), escaped(&number.unit));
            let _ = writeln!(text, "Working:\n\n<br><br><br><br>\n");
        }
        Form::Blank(of) => {
            let blanks = (1..=of.answers.len()).map(|place| format!("\\[{place}\\] {}", blank(14)));
            let _ = writeln!(text, "{}\n", blanks.collect::<Vec<_>>().join(" · "));
        }
        Form::Choice(_) | Form::Place(_) => {
            let _ = writeln!(text, "Answer: {} · because {}\n", blank(4), blank(50));
        }
        Form::Several(_) | Form::Order(_) => {
            let _ = writeln!(text, "Answer ({}): {}\n", escaped(&accepted), blank(24));
        }
    }
}

/// The answer, why each choice is right or wrong, and the working.
fn key(text: &mut String, item: &Item) {
    let asked = &item.asked;
    let _ = writeln!(text, "**Answer: {}**\n", escaped(&asked.answer_text()));
    for reason in asked.reasons() {
        let _ = writeln!(text, "- {}", escaped(&reason));
    }
    if asked.working.is_empty() {
        text.push('\n');
        return;
    }
    let page = Page {
        lines: asked.working.clone(),
    };
    let working = render::markdown(&page, render::no_hint);
    let _ = writeln!(text, "\nWorking:\n\n{working}");
}
