//! `{{#raystep-run VERB …}}`: a command that only reads, and what it prints when the book is built.
//!
//! The preprocessor knows no command line: whoever calls it hands in what runs commands.

use crate::book::Project;
use crate::book::words::whole_number;
use crate::explain::render::{escaped, whole_words};
use crate::scene::quoted;

/// What a command printed, and its exit code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ran {
    /// Standard output; behind it the message, if the command failed.
    pub out: String,
    /// 0 if all went well.
    pub code: u8,
}

/// Runs commands of this program that only read.
pub trait Commands {
    /// Runs one in the project's root; the words are those behind the name of the program.
    ///
    /// # Errors
    /// The command writes something, reads what is not the course's, or cannot be run.
    fn run(&self, words: &[String], project: &Project) -> Result<Ran, String>;
}

/// Runs none.
#[derive(Clone, Copy, Debug)]
pub struct NoCommands;

impl Commands for NoCommands {
    fn run(&self, _: &[String], _: &Project) -> Result<Ran, String> {
        Err("no commands can be run here\n  build the book with the command raystep".into())
    }
}

/// What a directive asks for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Asked {
    lines: Option<u32>,
    from: Option<String>,
    to: Option<String>,
    exit: u8,
    words: Vec<String>,
}

/// The command and what it prints, as HTML on one line.
///
/// # Errors
/// What is wrong with the words, or with the command, and what to do about it.
pub(super) fn run(
    rest: &str,
    commands: &dyn Commands,
    project: &Project,
) -> Result<String, String> {
    let asked = asked(split(rest)?)?;
    let ran = commands.run(&asked.words, project)?;
    if ran.code != asked.exit {
        let said = ran.out.trim_end().lines().last().unwrap_or_default();
        return Err(format!(
            "the command ends with {}, not with {}: {said}\n  mend the command, or say exit={}",
            ran.code, asked.exit, ran.code
        ));
    }
    let shown = excerpt(&ran.out, &asked)?;
    let command: Vec<String> = asked.words.iter().map(|word| for_shell(word)).collect();
    let text = format!("$ raystep {}\n{shown}", command.join(" "));
    let columns = if has_columns(&shown) {
        " raystep-columns"
    } else {
        ""
    };
    // a highlighter would take the marks out that keep words whole
    Ok(format!(
        "<pre class=\"raystep-run{columns}\"><code class=\"nohighlight\">{}</code></pre>",
        whole_words(&escaped(text.trim_end()))
    ))
}

/// Has a text columns? Then its lines are not broken: two lines or more have a gap between words.
fn has_columns(text: &str) -> bool {
    let has_gap = |line: &&str| line.trim().contains("  ");
    1 < text.lines().filter(has_gap).count()
}

/// Reads the options, which stand before the verb.
fn asked(words: Vec<String>) -> Result<Asked, String> {
    let mut asked = Asked::default();
    let mut words = words.into_iter().peekable();
    while let Some(word) = words.next_if(|word| !word.starts_with('-') && word.contains('=')) {
        match word.split_once('=') {
            Some(("lines", number)) => asked.lines = Some(whole_number("lines", number)?),
            Some(("from", text)) => asked.from = Some(text.into()),
            Some(("to", text)) => asked.to = Some(text.into()),
            Some(("exit", number)) => {
                let code = number.parse();
                asked.exit = code.map_err(|_| {
                    format!("exit={} is no exit code\n  as in exit=1", quoted(number))
                })?;
            }
            _ => {
                return Err(format!(
                    "{} is not one of its options\n  before the verb may stand lines=N, from=TEXT, to=TEXT, exit=N",
                    quoted(&word)
                ));
            }
        }
    }
    asked.words = words.collect();
    if asked.words.is_empty() {
        return Err(
            "no verb is named\n  as in {{#raystep-run pixel lessons/04-sphere/scene.json 80,60}}"
                .into(),
        );
    }
    Ok(asked)
}

/// The part of the output that is shown, with the number of lines that are omitted.
fn excerpt(out: &str, asked: &Asked) -> Result<String, String> {
    let all: Vec<&str> = out.trim_end().lines().collect();
    let place = |text: &Option<String>, after: usize| match text {
        None => Ok(None),
        Some(text) => {
            let found = all
                .iter()
                .skip(after)
                .position(|line| line.contains(&**text));
            found.map(|at| Some(after + at)).ok_or_else(|| {
                format!(
                    "no line of the output has {}\n  run the command, and choose another text",
                    quoted(text)
                )
            })
        }
    };
    let first = place(&asked.from, 0)?.unwrap_or(0);
    // a block ends on a later line than it begins
    let behind = if asked.from.is_some() {
        first + 1
    } else {
        first
    };
    let last = place(&asked.to, behind)?.map_or(all.len(), |at| at + 1);
    let most = asked.lines.map_or(usize::MAX, |lines| lines as usize);
    let end = last.min(first.saturating_add(most));
    let mut shown = String::new();
    let left_out = |count: usize| match count {
        0 => String::new(),
        1 => "… (1 more line)\n".into(),
        _ => format!("… ({count} more lines)\n"),
    };
    shown.push_str(&left_out(first));
    for line in &all[first.min(end)..end] {
        shown.push_str(line);
        shown.push('\n');
    }
    shown.push_str(&left_out(all.len() - end));
    Ok(shown)
}

/// Words as a shell splits them: at spaces, but for those between quotation marks.
///
/// # Errors
/// A quotation mark that is not closed.
fn split(rest: &str) -> Result<Vec<String>, String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for c in rest.chars() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            None if c.is_whitespace() => words.extend(word.take()),
            Some(_) | None => word.get_or_insert_default().push(c),
        }
    }
    words.extend(word);
    match quote {
        Some(quote) => Err(format!(
            "a {quote} is not closed\n  close it before the }}}}"
        )),
        None => Ok(words),
    }
}

/// A word as a shell reads it.
pub(super) fn for_shell(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "._/-,:=+@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.into();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Prints the numbers 1 to 5, a line each.
    struct Numbers(u8);

    impl Commands for Numbers {
        fn run(&self, words: &[String], _: &Project) -> Result<Ran, String> {
            assert_eq!(words[0], "count");
            Ok(Ran {
                out: "one\ntwo\nthree\n\nfive\n".into(),
                code: self.0,
            })
        }
    }

    fn shown(rest: &str, code: u8) -> Result<String, String> {
        let project = Project::new(".".as_ref(), "lessons".as_ref());
        let html = run(rest, &Numbers(code), &project)?;
        let text = html
            .splitn(3, "\">")
            .nth(2)
            .unwrap()
            .replace("&#10;", "\n")
            .replace("&#36;", "$");
        Ok(text.replace("</code></pre>", ""))
    }

    #[test]
    fn what_is_left_out_is_told() {
        assert_eq!(
            shown("count", 0).unwrap(),
            "$ raystep count\none\ntwo\nthree\n\nfive"
        );
        assert_eq!(
            shown("lines=2 count", 0).unwrap(),
            "$ raystep count\none\ntwo\n… (3 more lines)"
        );
        assert_eq!(
            shown("from=tw to=\"three\" count", 0).unwrap(),
            "$ raystep count\n… (1 more line)\ntwo\nthree\n… (2 more lines)"
        );
        let told = shown("from=ten count", 0).unwrap_err();
        assert!(told.contains("no line of the output has \"ten\""), "{told}");
    }

    #[test]
    fn an_exit_code_is_expected_or_a_mistake() {
        let told = shown("count", 1).unwrap_err();
        assert!(
            told.starts_with("the command ends with 1, not with 0: five"),
            "{told}"
        );
        shown("exit=1 count", 1).unwrap();
        shown("exit=1 count", 0).unwrap_err();
    }

    #[test]
    fn words_between_quotation_marks_are_one_and_can_be_copied() {
        assert_eq!(split("a 'b c' d\"e f\"").unwrap(), ["a", "b c", "de f"]);
        assert!(split("a 'b").unwrap_err().contains("is not closed"));
        let text = shown("count --script 'into n n' a=b", 0).unwrap();
        // the words are those of the command, and one with hyphens is not broken
        let option = "<span style=\"white-space: nowrap\">--script</span>";
        let command = format!("$ raystep count {option} 'into n n' a=b\n");
        assert!(text.starts_with(&command), "{text}");
    }

    #[test]
    fn options_stand_before_the_verb() {
        for (rest, says) in [
            ("line=3 count", "lines=N"),
            ("lines=x count", "is not a whole number"),
            ("exit=-1 count", "is no exit code"),
            ("lines=3", "no verb is named"),
        ] {
            let told = shown(rest, 0).unwrap_err();
            assert!(told.contains(says), "{rest}: {told}");
        }
    }
}
