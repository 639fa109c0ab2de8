//! The stepper of a book: a figure that is drawn up to a step, with the step's words, and the list of all steps.
//!
//! Without its script, and in print, it is the complete figure and the list. The figure and its data are one line of HTML;
//! the style and the script stand once in each chapter.

use std::fmt::Write;

use serde::Serialize;

use crate::explain::render::{escaped, whole_words};
use crate::page::json::inline_json;
use crate::page::steps::{PixelSteps, StepFace, TracePlace};

/// What a stepper shows.
#[derive(Clone, Copy, Debug)]
pub struct Stepper<'a> {
    /// The figure's drawing, on one line.
    pub svg: &'a str,
    /// The id of the whole.
    pub id: &'a str,
    /// What stands below the figure, as HTML on one line.
    pub caption: &'a str,
    /// The steps.
    pub steps: &'a PixelSteps,
    /// The last step that it shows, and the trace. `None` if it goes beyond a pixel.
    pub until: Option<&'a TracePlace>,
    /// Is the question asked before the verdict is shown?
    pub predicts: bool,
}

/// What the script knows.
#[derive(Serialize)]
struct Data<'a> {
    #[serde(flatten)]
    steps: &'a PixelSteps,
    #[serde(skip_serializing_if = "Option::is_none")]
    until: Option<&'a TracePlace>,
}

/// The figure of a stepper, on one line.
pub fn stepper(stepper: &Stepper) -> String {
    let Stepper {
        svg,
        id,
        caption,
        steps,
        until,
        predicts,
    } = *stepper;
    let predict = if predicts { " data-predict" } else { "" };
    let heading = match steps.steps.len() {
        1 => "1 step".into(),
        many => format!("All {many} steps"),
    };
    let items: String = steps.steps.iter().map(item).collect();
    format!(
        "<div class=\"raystep-stepper\" id=\"{id}\"{predict}><figure class=\"raystep\">{svg}<figcaption>{caption}</figcaption></figure>\
         <p class=\"raystep-heading\">{heading}</p><ol class=\"raystep-list\">{items}</ol>\
         <script type=\"application/json\">{}</script></div>",
        inline_json(&Data { steps, until })
    )
}

/// A step in the list: all that it says.
fn item(step: &StepFace) -> String {
    let mut html = format!(
        "<li><div class=\"raystep-words\"><p class=\"raystep-title\">{}</p><p class=\"raystep-place\">{}</p>",
        escaped(&step.title),
        escaped(&step.place)
    );
    for line in &step.lines {
        let gap = if line.gap { " gap" } else { "" };
        // writing into a String does not fail
        let _ = write!(
            html,
            "<div class=\"raystep-line {}{gap}\" style=\"--indent: {}\">{}</div>",
            line.tone,
            line.indent,
            whole_words(&escaped(&line.text))
        );
    }
    html.push_str("<div class=\"raystep-facts\">");
    for fact in &step.facts {
        let _ = write!(html, "<div>{}</div>", whole_words(&escaped(fact)));
    }
    html.push_str("</div></div></li>");
    html
}

/// The style and the script of the steppers and the questions, once for a chapter: lines of HTML, none of which is empty.
pub fn shared() -> String {
    let style = [
        include_str!("core.css"),
        include_str!("stepper.css"),
        include_str!("quiz.css"),
    ]
    .concat();
    let script = [
        include_str!("core.js"),
        include_str!("stepper.js"),
        include_str!("quiz.js"),
    ]
    .concat();
    let script = script.lines().filter(|line| !line.trim().is_empty());
    let script: Vec<&str> = script.collect();
    format!(
        "<div><style>\n{}\n</style>\n<script>\n(() => {{\n\"use strict\";\n{}\n}})();\n</script></div>",
        style.trim_end(),
        script.join("\n")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn style_and_script_have_at_most_30_kb_and_no_line_that_ends_a_block() {
        let shared = shared();
        assert!(shared.len() <= 30_000, "{}", shared.len());
        assert!(shared.lines().all(|line| !line.trim().is_empty()));
        // mdBook reads these as its own
        assert!(!shared.contains("{{"));
        // nothing comes from elsewhere
        assert!(!shared.contains("http") && !shared.contains("url("));
    }
}
