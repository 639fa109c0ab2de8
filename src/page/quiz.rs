//! A question of a book: its text, its choices, and what is said to an answer.
//!
//! Without its script, and in print, it is the question, and its answer behind a line that is opened. With it, one answers
//! at once. The question and its data are one line of HTML; the style and the script stand once in each chapter.

use std::fmt::Write;

use serde::Serialize;

use crate::explain::render::{escaped, whole_words};
use crate::page::json::inline_json;
use crate::page::steps::{LineFace, TracePlace};

/// A question as a page shows it.
#[derive(Clone, Debug)]
pub struct Quiz<'a> {
    /// The id of the whole.
    pub id: &'a str,
    /// What it asks.
    pub text: &'a str,
    /// Lines with quantities taken out, where those are asked for.
    pub lines: &'a [String],
    /// What may be chosen.
    pub choices: Vec<&'a str>,
    /// Every choice with its reason.
    pub reasons: &'a [String],
    /// The working.
    pub working: Vec<LineFace>,
    /// Where the step can be looked at, and the other answers, as HTML.
    pub look: &'a str,
    /// What the script knows.
    pub data: QuizData,
}

/// What the script of a question knows: which answer is right, and under which name an answer is remembered.
#[derive(Clone, Debug, Default, Serialize)]
pub struct QuizData {
    /// Lesson and question.
    pub name: String,
    /// `one`, `several`, `order`, `number` or `blanks`.
    pub form: &'static str,
    /// The right choices, by their places.
    pub right: Vec<usize>,
    /// Of an order: which choice must come before which.
    pub before: Vec<(usize, usize)>,
    /// Of numbers: each with how far an answer may be from it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub answers: Vec<(f64, f64)>,
    /// Of a number: its unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The answer in words.
    pub answer: String,
    /// The step that it is about. A stepper of the page that goes through the same trace shows it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<TracePlace>,
}

/// The question, on one line.
pub fn quiz(quiz: &Quiz) -> String {
    let mut html = format!(
        "<div class=\"raystep-quiz\" id=\"{}\" role=\"group\" aria-label=\"Question {}\"><p class=\"raystep-question\">{}</p>",
        quiz.id,
        escaped(&quiz.data.name),
        whole_words(&escaped(quiz.text))
    );
    for line in quiz.lines {
        // writing into a String does not fail
        let _ = write!(
            html,
            "<div class=\"raystep-line\">{}</div>",
            whole_words(&escaped(line))
        );
    }
    if !quiz.choices.is_empty() {
        html.push_str("<ol type=\"a\">");
        for choice in &quiz.choices {
            let _ = write!(html, "<li>{}</li>", whole_words(&escaped(choice)));
        }
        html.push_str("</ol>");
    }
    let _ = write!(
        html,
        "<details><summary>Answer</summary>{}</details><script type=\"application/json\">{}</script></div>",
        told(quiz),
        inline_json(&quiz.data)
    );
    html
}

/// The answer with every reason, the working, and where to look.
pub fn told(quiz: &Quiz) -> String {
    let mut html = format!(
        "<p>Answer: {}</p><ul class=\"raystep-reasons\">",
        escaped(&quiz.data.answer)
    );
    for reason in quiz.reasons {
        let _ = write!(html, "<li>{}</li>", whole_words(&escaped(reason)));
    }
    html.push_str("</ul>");
    for line in &quiz.working {
        let gap = if line.gap { " gap" } else { "" };
        let _ = write!(
            html,
            "<div class=\"raystep-line {}{gap}\" style=\"--indent: {}\">{}</div>",
            line.tone,
            line.indent,
            whole_words(&escaped(&line.text))
        );
    }
    let _ = write!(html, "<p>{}</p>", quiz.look);
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_is_one_line_in_which_every_text_stays_text() {
        let lines = ["a = [1] <b>".to_owned()];
        let reasons = ["a is right: </script>".to_owned()];
        let html = quiz(&Quiz {
            id: "x",
            text: "Which {{#raystep x}} & \n root?",
            lines: &lines,
            choices: vec!["t = 4 < 5", "`none`"],
            reasons: &reasons,
            working: Vec::new(),
            look: "<code>look</code>",
            data: QuizData {
                name: "04-sphere/roots".into(),
                form: "one",
                answer: "a".into(),
                ..QuizData::default()
            },
        });
        assert!(
            !html.contains('\n') && !html.contains("{{") && !html.contains("<b>"),
            "{html}"
        );
        assert_eq!(html.matches("</script>").count(), 1, "{html}");
        assert!(
            html.contains("<li>t = 4 &lt; 5</li><li>&#96;none&#96;</li>"),
            "{html}"
        );
        // without a script it can be opened
        assert!(
            html.contains("<details><summary>Answer</summary><p>Answer: a</p>"),
            "{html}"
        );
    }
}
