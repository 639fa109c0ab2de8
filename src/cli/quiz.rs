//! `raystep lesson quiz`: asks the questions of a lesson, in a terminal or line by line in a pipe.

use std::collections::VecDeque;
use std::fmt::Write;
use std::io::{self, BufRead, IsTerminal, Write as _};
use std::path::PathBuf;

use raystep::Page;
use raystep::explain::render;
use raystep::lesson::Lesson;
use raystep::lesson::question::{Asked, Form, letter};

use crate::cli::Error;
use crate::cli::course;
use crate::cli::output::Output;
use crate::cli::step_command::{figure_command, step_command};

/// Which questions are asked, and where their answers come from.
pub(crate) struct Quiz<'a> {
    /// The number of the lesson.
    pub(crate) lesson: u8,
    /// The names of the questions; none: all.
    pub(crate) only: &'a [String],
    /// Answers with semicolons between them; absent: they are read from standard input.
    pub(crate) script: Option<&'a str>,
    /// The folder of the lessons, if it was given.
    pub(crate) lessons: Option<&'a PathBuf>,
}

/// What came of the questions.
#[derive(Default)]
struct Counts {
    right: usize,
    wrong: usize,
    skipped: usize,
}

/// What was typed.
enum Typed {
    Answer(String),
    Skip,
    Help,
    Quit,
}

impl Quiz<'_> {
    /// Asks.
    pub(crate) fn run(&self) -> Result<(), Error> {
        let (library, folder) = course::library(self.lesson, self.lessons)?;
        let lesson = course::lesson(&library, self.lesson)?;
        let names = self.names(lesson)?;
        let mut input = Answers::new(self.script);
        let mut out = Output::standard();
        let count = names.len();
        let few = if count == 1 { "question" } else { "questions" };
        say(
            &format!(
                "Lesson {}: {}. {count} {few}. s skips a question, ? says what is accepted, q ends.\n",
                self.lesson, lesson.content.title
            ),
            &mut out,
        )?;
        let mut counts = Counts::default();
        for (place, name) in names.iter().enumerate() {
            let asked = library.ask(&lesson.name, name)?;
            say(
                &format!("\n{} of {count}: {name}\n{}", place + 1, question(&asked)),
                &mut out,
            )?;
            if !ask(&asked, &folder, &mut input, &mut counts, &mut out)? {
                break;
            }
        }
        let Counts {
            right,
            wrong,
            skipped,
        } = counts;
        let left = count - right - wrong - skipped;
        let mut text = format!("\n{right} right, {wrong} wrong, {skipped} skipped");
        if 0 < left {
            let _ = write!(text, ", {left} not asked");
        }
        text.push('\n');
        say(&text, &mut out)?;
        out.finish()
    }

    /// The names of the questions that are asked.
    fn names(&self, lesson: &Lesson) -> Result<Vec<String>, Error> {
        let known: Vec<&str> = lesson
            .content
            .questions
            .iter()
            .map(|of| of.name.as_str())
            .collect();
        if let Some(wrong) = self
            .only
            .iter()
            .find(|name| !known.contains(&name.as_str()))
        {
            let near = raystep::scene::nearest_name(wrong, known.iter().copied());
            return Err(Error::Exercise {
                what: format!("lesson {} has no question {wrong:?}", self.lesson),
                fix: match near {
                    Some(near) => format!("did you mean {near}?"),
                    None => format!("its questions are {}", known.join(", ")),
                },
            });
        }
        if known.is_empty() {
            return Err(Error::Exercise {
                what: format!("lesson {} has no questions", self.lesson),
                fix: "write \"questions\" in its lesson.json".into(),
            });
        }
        Ok(match self.only {
            [] => known.into_iter().map(str::to_owned).collect(),
            only => only.to_vec(),
        })
    }
}

/// Asks one question until it is answered or skipped; `false`: no more are wanted.
fn ask(
    asked: &Asked,
    folder: &std::path::Path,
    input: &mut Answers,
    counts: &mut Counts,
    out: &mut Output,
) -> Result<bool, Error> {
    loop {
        match input.next(out)? {
            None | Some(Typed::Quit) => return Ok(false),
            Some(Typed::Help) => say(&format!("{}\n", asked.accepts()), out)?,
            Some(Typed::Skip) => {
                counts.skipped += 1;
                say(
                    &format!(
                        "skipped; right is: {}\n{}",
                        asked.answer_text(),
                        told(asked, folder)
                    ),
                    out,
                )?;
                return Ok(true);
            }
            Some(Typed::Answer(text)) => match asked.read(&text) {
                Err(what) => say(&format!("{what}\n"), out)?,
                Ok(given) => {
                    let judged = asked.answer(&given);
                    let verdict = if judged.right {
                        counts.right += 1;
                        format!("right: {}\n", judged.reason)
                    } else {
                        counts.wrong += 1;
                        format!(
                            "wrong: {}\nright is: {}\n",
                            judged.reason,
                            asked.answer_text()
                        )
                    };
                    say(&format!("{verdict}{}", told(asked, folder)), out)?;
                    return Ok(true);
                }
            },
        }
    }
}

/// The question with its choices, or with its lines.
fn question(asked: &Asked) -> String {
    let mut text = format!("{}\n", asked.text);
    if let Form::Blank(blank) = &asked.form {
        for line in &blank.lines {
            let _ = writeln!(text, "  {line}");
        }
    }
    for (place, choice) in asked.form.choices().iter().enumerate() {
        let _ = writeln!(text, "  {}  {}", letter(place), choice.text);
    }
    text
}

/// Every choice with its reason, the working, and the command that leads to the step.
fn told(asked: &Asked, folder: &std::path::Path) -> String {
    let mut text = String::new();
    for reason in asked.reasons() {
        let _ = writeln!(text, "  {reason}");
    }
    if !asked.working.is_empty() {
        let page = Page {
            lines: asked.working.clone(),
        };
        let _ = writeln!(text, "Working:");
        for line in render::plain(&page, render::no_hint).lines() {
            let _ = writeln!(text, "  {line}");
        }
    }
    let _ = writeln!(text, "To step to it: {}", step_command(asked, folder));
    if let Some(figure) = &asked.figure {
        let _ = writeln!(text, "Its figure: {}", figure_command(figure, folder));
    }
    text
}

fn say(text: &str, out: &mut Output) -> Result<(), Error> {
    out.write_all(text.as_bytes())
        .map_err(|error| out.failed(error))
}

/// Where answers come from: a script, or standard input line by line.
struct Answers {
    script: Option<VecDeque<String>>,
}

impl Answers {
    fn new(script: Option<&str>) -> Self {
        Self {
            script: script.map(|script| script.split(';').map(str::to_owned).collect()),
        }
    }

    /// What is typed next; `None` at the end.
    fn next(&mut self, out: &mut Output) -> Result<Option<Typed>, Error> {
        let line = match &mut self.script {
            Some(script) => script.pop_front(),
            None => line(out)?,
        };
        Ok(line.map(|line| match line.trim() {
            "" | "s" | "skip" => Typed::Skip,
            "?" => Typed::Help,
            "q" | "quit" => Typed::Quit,
            text => Typed::Answer(text.into()),
        }))
    }
}

/// A line of standard input.
fn line(out: &mut Output) -> Result<Option<String>, Error> {
    let mut input = io::stdin().lock();
    if input.is_terminal() {
        say("> ", out)?;
    }
    out.flush().map_err(|error| out.failed(error))?;
    let mut line = String::new();
    let read = input.read_line(&mut line).map_err(|source| {
        Error::Load(raystep::LoadError::Read {
            file: "standard input".into(),
            source,
        })
    })?;
    Ok((0 < read).then_some(line))
}
