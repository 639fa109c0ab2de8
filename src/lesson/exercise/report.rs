//! The result of a check for programs: JSON, and `JUnit`'s XML for several.

use std::fmt::{self, Write};

use serde_json::{Value as Json, json};

use crate::lesson::exercise::{About, Outcome};

/// The result of a check, as a JSON object.
#[derive(Clone, Debug, PartialEq)]
pub struct Report(Json);

impl Report {
    /// The result with its message, and the file of the picture if there is one.
    pub fn new(
        about: &About,
        outcome: &Outcome,
        message: &[String],
        picture: Option<&str>,
    ) -> Self {
        let mut told = json!({
            "exercise": about.id(),
            "lesson": about.lesson,
            "name": about.name,
            "title": about.title,
            "state": outcome.state(),
            "message": message,
        });
        match outcome {
            Outcome::Wrong(divergence) => {
                told["case"] = divergence.case.number.into();
                told["special"] = divergence.case.note.clone().into();
                told["failing"] = divergence.failing.into();
                told["cases"] = divergence.cases.into();
                if let Some(line) = divergence.lines.last() {
                    told["quantity"] = line.label.clone().into();
                    told["yours"] = line.yours.clone().into();
                    told["expected"] = line.expected.clone().into();
                }
                if let Some(mistake) = divergence.mistake {
                    told["mistake"] = mistake.name.into();
                }
                if let Some(picture) = picture {
                    told["picture"] = picture.into();
                }
            }
            Outcome::Broken { what, case, place } => {
                told["what"] = what.clone().into();
                if let Some(case) = case {
                    told["case"] = case.number.into();
                    told["special"] = case.note.clone().into();
                }
                if let Some(place) = place {
                    told["place"] = place.clone().into();
                }
            }
            Outcome::Right { cases } => told["cases"] = (*cases).into(),
            Outcome::NotWritten => {}
        }
        Self(told)
    }

    /// The result that a JSON text holds, if it is one.
    pub fn parse(text: &str) -> Option<Self> {
        let told: Json = serde_json::from_str(text).ok()?;
        let has = |key: &str| told.get(key).is_some_and(Json::is_string);
        let is_report = has("exercise") && has("state");
        is_report.then_some(Self(told))
    }

    /// A text of the object; empty if it is absent.
    pub fn text(&self, key: &str) -> &str {
        self.0.get(key).and_then(Json::as_str).unwrap_or("")
    }

    /// The state, as [`Outcome::state`] names it.
    pub fn state(&self) -> &str {
        self.text("state")
    }

    /// The lines of the message.
    pub fn message(&self) -> impl Iterator<Item = &str> {
        let lines = self.0.get("message").and_then(Json::as_array);
        lines.into_iter().flatten().filter_map(Json::as_str)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// A test suite in the XML that `JUnit` writes: an exercise that is not written is skipped, a broken one an error, a wrong
/// one a failure.
pub fn junit(reports: &[Report]) -> String {
    let count = |state: &str| reports.iter().filter(|of| of.state() == state).count();
    let mut xml = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let _ = writeln!(
        xml,
        "<testsuite name=\"lessons\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">",
        reports.len(),
        count("wrong"),
        count("broken"),
        count("not written")
    );
    for report in reports {
        let id = report.text("exercise");
        let lesson = id.split('_').next().unwrap_or_default();
        let _ = write!(xml, "  <testcase classname=\"{lesson}\" name=\"{id}\"");
        let lines: Vec<&str> = report.message().collect();
        let text = escaped(&lines.join("\n"));
        let first = escaped(lines.first().copied().unwrap_or_default());
        let inside = match report.state() {
            "right" => None,
            "not written" => Some("skipped"),
            "broken" => Some("error"),
            _ => Some("failure"),
        };
        let _ = match inside {
            None => writeln!(xml, "/>"),
            Some(kind) => writeln!(
                xml,
                ">\n    <{kind} message=\"{first}\">{text}</{kind}>\n  </testcase>"
            ),
        };
    }
    xml.push_str("</testsuite>\n");
    xml
}

/// In XML; control characters, which XML does not allow, become spaces.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            '\n' => escaped.push('\n'),
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_cannot_break_the_xml() {
        assert_eq!(
            escaped("a < b & \"c\"\u{1b}[0m\n"),
            "a &lt; b &amp; &quot;c&quot; [0m\n"
        );
    }

    #[test]
    fn what_is_no_report_is_none() {
        assert_eq!(Report::parse("{}"), None);
        assert_eq!(Report::parse("{\"exercise\":\"l04_roots\",\"sta"), None);
        let report = Report::parse(r#"{"exercise":"l04_roots","state":"right","message":["a"]}"#);
        let report = report.unwrap();
        assert_eq!(report.message().collect::<Vec<_>>(), ["a"]);
        assert!(junit(&[report]).contains(r#"classname="l04" name="l04_roots"/>"#));
    }
}
