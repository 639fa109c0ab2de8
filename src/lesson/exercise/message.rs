//! The message of a check: at most [`MOST_LINES`] lines.

use crate::lesson::exercise::{About, CaseSaid, Outcome};

/// A message stands on a small terminal, below the line of the program that printed it.
pub const MOST_LINES: usize = 14;

/// What a student can do next, in the words of the program that checks.
#[derive(Clone, Debug, Default)]
pub struct Commands {
    /// The command that shows the step.
    pub see: String,
    /// The command that prints a hint.
    pub hint: String,
    /// The file to write in.
    pub file: String,
    /// The file of the picture; nothing if there is none.
    pub picture: Option<String>,
}

/// What came out of a check, for the student.
pub fn message(about: &About, outcome: &Outcome, commands: &Commands) -> Vec<String> {
    let head = |mark: char, state: &str| {
        format!(
            "{mark} {}  lesson {}: {}: {state}",
            about.id(),
            about.lesson,
            about.title
        )
    };
    let mut lines = Vec::new();
    match outcome {
        Outcome::NotWritten => {
            lines.push(head('○', "not written"));
            lines.push(format!("  write it: {}", commands.file));
            lines.push(format!("  see it:   {}", commands.see));
            lines.push(format!("  hint:     {}", commands.hint));
        }
        Outcome::Broken { what, case, place } => {
            lines.push(head('◐', "broken"));
            lines.extend(case.iter().flat_map(said));
            lines.push(format!("  ✗ {}", one_line(what)));
            if let Some(place) = place {
                lines.push(format!("  last visited: {}", one_line(place)));
            }
            lines.push(format!("  see it:   {}", commands.see));
            lines.push(format!("  hint:     {}", commands.hint));
        }
        Outcome::Wrong(of) => {
            lines.push(head('◐', "wrong"));
            lines.extend(said(&of.case));
            let widest = of.lines.iter().map(|line| line.label.chars().count());
            let widest = widest.max().unwrap_or(0);
            // of a long derivation the last parts
            let most = MOST_LINES - 8;
            let skipped = of.lines.len().saturating_sub(most);
            for line in &of.lines[skipped..] {
                let (label, yours) = (&line.label, &line.yours);
                lines.push(if line.is_same {
                    format!("  ✓ {label:<widest$}  {yours}")
                } else {
                    format!(
                        "  ✗ {label:<widest$}  yours {yours}, expected {}",
                        line.expected
                    )
                });
            }
            if let Some(form) = of.form {
                lines.push(format!("  form:     {form}"));
            }
            if let Some(mistake) = of.mistake {
                lines.push(format!(
                    "  mistake:  {}: {}",
                    mistake.name, mistake.sentence
                ));
            }
            lines.push(format!(
                "  in all:   {} of {} cases differ",
                of.failing, of.cases
            ));
            lines.push(format!("  see it:   {}", commands.see));
            if let Some(picture) = &commands.picture {
                lines.push(format!("  picture:  {picture}"));
            }
            lines.push(format!("  hint:     {}", commands.hint));
        }
        Outcome::Right { cases } => {
            lines.push(head('●', "right"));
            lines.push(format!("  {cases} cases. {}", about.take_away));
            lines.push(format!("  next:     {}", about.next));
        }
    }
    lines
}

fn said(case: &CaseSaid) -> [String; 2] {
    [
        format!("  case {}: {}", case.number, case.note),
        format!("    {}", case.given),
    ]
}

/// What a student's program says may have any number of lines.
fn one_line(text: &str) -> String {
    const MOST: usize = 160;
    let mut words: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((end, _)) = words.char_indices().nth(MOST) {
        words.truncate(end);
        words.push('…');
    }
    words
}
