//! What came out of a check, as text, as JSON and as JUnit.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::{Value as Json, json};

use crate::explain::grouped;
use crate::lesson::check::checked::{Checked, Divergence, UnknownField};
use crate::scene::quoted;
use crate::trace::{Kind, StrategyName};

/// What a report names beside what was compared.
#[derive(Clone, Debug, Default)]
pub struct Named {
    /// The scene.
    pub scene: String,
    /// The log.
    pub log: String,
    /// The command that shows the step.
    pub see: String,
    /// The file of the picture, if one was written.
    pub picture: Option<String>,
}

/// The words of the worked solution for keys that are other words.
const WORDS: [(&str, &str); 16] = [
    ("near", "t₁"),
    ("far", "t₂"),
    ("discriminant", "b² − 4ac"),
    ("n_dot_l", "N·L"),
    ("r_dot_v", "R·V"),
    ("to_light", "L"),
    ("normal", "N"),
    ("numerator", "A·x₀ + B·y₀ + C·z₀ + D"),
    ("denominator", "A·Δx + B·Δy + C·Δz"),
    ("dropped", "the axis that is dropped"),
    ("projected", "p′"),
    ("point", "p"),
    ("direction", "Δ"),
    ("origin", "(x₀, y₀, z₀)"),
    ("next_x", "t of the next plane across x"),
    ("cos_incident", "cos θ₁"),
];

/// A key with its word.
fn label(key: &str) -> String {
    match WORDS.iter().find(|(known, _)| *known == key) {
        Some((_, word)) => format!("{word} ({key})"),
        None => key.into(),
    }
}

impl UnknownField {
    fn told(&self) -> String {
        let (key, kind, line) = (quoted(&self.key), self.kind.name(), self.line);
        let lines = match self.lines {
            1 => format!("line {line}"),
            lines => format!("{} lines, the first one is line {line}", grouped(lines)),
        };
        let near = match &self.near {
            Some(near) => format!("; did you mean {near:?}?"),
            None => String::new(),
        };
        format!("the field {key} of {kind} is not known and not compared ({lines}){near}")
    }
}

impl Divergence {
    /// Where it is, in words.
    pub fn place(&self) -> String {
        let [x, y] = self.pixel;
        let mut place = format!("line {}: pixel {x},{y}", self.line);
        if !self.ray.is_empty() {
            let _ = write!(place, ", {}", self.ray);
        }
        let _ = write!(place, ", {}", self.kind.name());
        if !self.subject.is_empty() {
            let _ = write!(place, " of {}", self.subject.replace(char::is_control, " "));
        }
        place
    }

    /// The strategy whose log has the step; any if `None`.
    pub fn strategy(&self) -> Option<StrategyName> {
        let of_grid = matches!(
            self.kind,
            Kind::Cell
                | Kind::GridEnter
                | Kind::GridExit
                | Kind::Listed
                | Kind::Mailbox
                | Kind::HitOutsideCell
        );
        of_grid.then_some(StrategyName::Grid)
    }
}

impl Checked {
    /// For reading.
    pub fn text(&self, named: &Named) -> String {
        let mut text = String::new();
        let pixels = if self.pixels == 1 { "pixel" } else { "pixels" };
        let Named { scene, log, .. } = named;
        let _ = writeln!(
            text,
            "{log} against {scene}: {} {pixels}",
            grouped(self.pixels)
        );
        let _ = writeln!(text, "  compared: {}", counts(&self.compared));
        if !self.absent.is_empty() {
            let names: Vec<&str> = self.absent.iter().map(|kind| kind.name()).collect();
            let _ = writeln!(text, "  not in the log: {}", names.join(", "));
        }
        if !self.beyond.is_empty() {
            let _ = writeln!(
                text,
                "  not compared, since this program has no such step there, or the ray cannot be told: {}",
                counts(&self.beyond)
            );
        }
        for of in &self.unknown {
            let _ = writeln!(text, "  note: {}", of.told());
        }
        let Some(divergence) = &self.divergence else {
            text += if self.compared.is_empty() {
                "● nothing was compared\n"
            } else {
                "● nothing differs\n"
            };
            return text;
        };
        let _ = writeln!(text, "✗ {}", divergence.place());
        let labels: Vec<String> = divergence
            .quantities
            .iter()
            .map(|of| label(&of.key))
            .collect();
        let widest = labels
            .iter()
            .map(|label| label.chars().count())
            .max()
            .unwrap_or(0);
        for (of, label) in divergence.quantities.iter().zip(&labels) {
            let room = " ".repeat(widest - label.chars().count());
            let _ = if of.is_same {
                writeln!(text, "  ✓ {label}{room}  {}", of.yours)
            } else {
                writeln!(
                    text,
                    "  ✗ {label}{room}  yours {}, expected {}",
                    of.yours, of.expected
                )
            };
        }
        if let Some(mistake) = divergence.mistake {
            let _ = writeln!(text, "  mistake:  {}: {}", mistake.name, mistake.sentence);
        }
        let kind = divergence.kind;
        let of = |counts: &BTreeMap<Kind, u64>| grouped(counts.get(&kind).copied().unwrap_or(0));
        let (wrong, all) = (of(&self.different), of(&self.compared));
        let _ = writeln!(
            text,
            "  in all:   {wrong} of {all} lines {} differ",
            kind.name()
        );
        let _ = writeln!(text, "  see it:   {}", named.see);
        if let Some(picture) = &named.picture {
            let _ = writeln!(text, "  picture:  {picture}");
        }
        text
    }

    /// For programs.
    pub fn json(&self, named: &Named) -> Json {
        let divergence = self.divergence.as_ref().map(|of| {
            let quantities: Vec<Json> = of
                .quantities
                .iter()
                .map(|of| json!({"key": of.key, "yours": of.yours, "expected": of.expected, "same": of.is_same}))
                .collect();
            json!({
                "line": of.line,
                "pixel": of.pixel,
                "kind": of.kind.name(),
                "ray": of.ray,
                "subject": of.subject,
                "quantities": quantities,
                "step": of.step,
                "mistake": of.mistake.map(|mistake| mistake.name),
                "see": named.see,
                "picture": named.picture,
            })
        });
        let unknown: Vec<Json> = self
            .unknown
            .iter()
            .map(|of| json!({"kind": of.kind.name(), "field": of.key, "line": of.line, "lines": of.lines, "near": of.near}))
            .collect();
        json!({
            "scene": named.scene,
            "log": named.log,
            "right": self.is_right(),
            "pixels": self.pixels,
            "compared": in_json(&self.compared),
            "different": in_json(&self.different),
            "beyond": in_json(&self.beyond),
            "absent": self.absent.iter().map(|kind| kind.name()).collect::<Vec<_>>(),
            "ignored": self.ignored,
            "unknown": unknown,
            "divergence": divergence,
        })
    }

    /// For programs that show tests: a case for each kind.
    pub fn junit(&self, named: &Named) -> String {
        let failures = self.different.len();
        let mut xml = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"{}\" tests=\"{}\" failures=\"{failures}\">\n",
            escaped(&named.log),
            self.compared.len()
        );
        for kind in self.compared.keys() {
            let name = kind.name();
            match self.different.get(kind) {
                None => {
                    let _ = writeln!(
                        xml,
                        "    <testcase classname=\"raystep.check\" name=\"{name}\"/>"
                    );
                }
                Some(count) => {
                    let told = match &self.divergence {
                        Some(of) if of.kind == *kind => self.text(named),
                        _ => format!("{count} lines differ"),
                    };
                    let _ = writeln!(
                        xml,
                        "    <testcase classname=\"raystep.check\" name=\"{name}\">\n      <failure message=\"{count} lines differ\">{}</failure>\n    </testcase>",
                        escaped(&told)
                    );
                }
            }
        }
        xml + "  </testsuite>\n</testsuites>\n"
    }
}

fn counts(of: &BTreeMap<Kind, u64>) -> String {
    if of.is_empty() {
        return "nothing".into();
    }
    let counts: Vec<String> = of
        .iter()
        .map(|(kind, count)| format!("{} {}", grouped(*count), kind.name()))
        .collect();
    counts.join(", ")
}

fn in_json(of: &BTreeMap<Kind, u64>) -> Json {
    of.iter()
        .map(|(kind, count)| (kind.name().to_owned(), json!(count)))
        .collect::<serde_json::Map<_, _>>()
        .into()
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            // XML 1.0 has no place for others
            letter if letter.is_control() && !matches!(letter, '\n' | '\t') => out.push(' '),
            letter => out.push(letter),
        }
    }
    out
}
