//! Steps as plain text: no drawing characters, one fact a line.

use std::io::Write;

use raystep::Page;
use raystep::explain::render;
use raystep::scene::printable;
use raystep::step::{
    Command, Cursor, Filter, KEYS, LETTERS, Question, Reaction, Reader, StepLog, StepWords, subject,
};

use crate::cli::Error;
use crate::cli::output::Output;
use crate::cli::step::address::Words;
use crate::cli::step::next::Next;
use crate::cli::step::save::save;

/// A reader in a log, with the words of its steps.
pub(crate) struct Face<'a, 'l> {
    pub(crate) reader: Reader<'a, 'l>,
    words: StepWords<'l>,
}

impl<'a, 'l> Face<'a, 'l> {
    /// At a step of a log.
    pub(crate) fn new(
        log: &'a StepLog<'l>,
        cursor: Cursor,
        filter: Option<Filter>,
        predicts: bool,
    ) -> Self {
        Self {
            reader: Reader::new(log, cursor, filter, predicts),
            words: StepWords::new(log),
        }
    }

    /// Does what a command says, and prints what follows.
    pub(crate) fn obey(
        &mut self,
        command: Command,
        words: &Words,
        out: &mut Output,
    ) -> Result<Next, Error> {
        let log = self.reader.log();
        let here = self.reader.here();
        match self.reader.obey(command) {
            Reaction::Shown(lines) => {
                say_all(&lines, out)?;
                self.show(out)?;
            }
            Reaction::Said(lines) => say_all(&lines, out)?,
            Reaction::Left(command) => match command {
                Command::View => say_all(&log.view(self.reader.here()), out)?,
                Command::Save => match save(log, here, words) {
                    Ok(text) => say(&text, out)?,
                    // the next step may be drawn, or another folder be free
                    Err(error) => say(&error.to_string(), out)?,
                },
                Command::Address => say(&words.command(&log.address(here).to_string()), out)?,
                Command::Keys => {
                    for key in KEYS {
                        say(&format!("{}: {}", key.names(), key.does), out)?;
                    }
                }
                other => return Ok(Next::of(&other)),
            },
        }
        Ok(Next::Here)
    }

    /// The question of the step, if one waits for an answer; or the step.
    pub(crate) fn show(&self, out: &mut Output) -> Result<(), Error> {
        match self.reader.asked() {
            Some(question) => self.ask(question, out),
            None => self.tell(out),
        }
    }

    fn ask(&self, question: &Question, out: &mut Output) -> Result<(), Error> {
        let (log, here) = (self.reader.log(), self.reader.here());
        let choices: String = LETTERS
            .iter()
            .zip(&question.choices)
            .fold(String::new(), |text, (letter, choice)| {
                text + &format!("{letter}: {}\n", choice.text)
            });
        let text = format!(
            "\n{}\n{}\nquestion: {}\n{choices}answer with a letter, or skip\n",
            subject(log, here),
            log.place_text(here),
            question.text
        );
        write(&text, out)
    }

    /// The step: its title, where it is, its words, and what it changed.
    fn tell(&self, out: &mut Output) -> Result<(), Error> {
        let told = self.reader.log().told(&self.words, self.reader.here());
        let mut text = format!("\n{}\n{}\n", told.title, told.place);
        let facts = told.facts();
        let page = Page { lines: told.lines };
        text.push_str(&render::plain(&page, render::no_hint));
        for fact in facts {
            text.push_str(&fact);
            text.push('\n');
        }
        write(&text, out)
    }
}

fn say_all(lines: &[String], out: &mut Output) -> Result<(), Error> {
    for line in lines {
        say(line, out)?;
    }
    Ok(())
}

/// A message, in lines that cannot control a terminal.
pub(crate) fn say(text: &str, out: &mut Output) -> Result<(), Error> {
    let lines: Vec<String> = text.lines().map(printable).collect();
    write(&format!("{}\n", lines.join("\n")), out)
}

/// Text as it is.
pub(crate) fn write(text: &str, out: &mut Output) -> Result<(), Error> {
    out.write_all(text.as_bytes())
        .map_err(|error| out.failed(error))
}
