//! Steps as plain text: no drawing characters, one fact a line.

use std::io::Write;

use raystep::Page;
use raystep::explain::render;
use raystep::scene::printable;
use raystep::step::{
    Asked, Command, Cursor, Filter, KEYS, LETTERS, Move, PAGE, Question, Shift, StepLog, StepWords,
    subject,
};

use crate::cli::Error;
use crate::cli::output::Output;
use crate::cli::step::address::Words;
use crate::cli::step::address_of;
use crate::cli::step::save::save;

/// What follows a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Next {
    /// More commands.
    Here,
    /// The same pixel with the next strategy.
    Strategy,
    /// The pixel beside.
    Pixel(Shift),
    /// The end.
    Quit,
}

/// A reader in a log.
pub(crate) struct Face<'a, 'l> {
    log: &'a StepLog<'l>,
    words: StepWords<'l>,
    pub(crate) cursor: Cursor,
    pub(crate) filter: Option<Filter>,
    /// Are questions asked?
    pub(crate) predicts: bool,
    /// The question that waits for an answer.
    asked: Option<Question>,
    targets: Vec<usize>,
}

impl<'a, 'l> Face<'a, 'l> {
    /// At a step of a log.
    pub(crate) fn new(
        log: &'a StepLog<'l>,
        cursor: Cursor,
        filter: Option<Filter>,
        predicts: bool,
    ) -> Self {
        let mut face = Self {
            log,
            words: StepWords::new(log),
            cursor,
            filter: None,
            predicts,
            asked: None,
            targets: Vec::new(),
        };
        face.choose(filter);
        face
    }

    /// The targets are what the filter names, or what is of interest.
    fn choose(&mut self, filter: Option<Filter>) {
        self.targets = match &filter {
            Some(filter) => filter.targets(self.log),
            None => self.log.targets(),
        };
        self.filter = filter;
    }

    /// Does what a command says, and prints what follows.
    pub(crate) fn obey(
        &mut self,
        command: Command,
        words: &Words,
        out: &mut Output,
    ) -> Result<Next, Error> {
        match command {
            Command::Move(by) => {
                self.go(self.cursor.moved(self.log, by), nothing_there(by), out)?;
            }
            Command::Page(by) => {
                let moved = |here: &Cursor| here.moved(self.log, by);
                let steps = std::iter::successors(moved(&self.cursor), moved);
                let last = steps.take(PAGE).last();
                self.go(last, nothing_there(by), out)?;
            }
            Command::NextTarget => {
                let next = self.cursor.next_of(self.log, &self.targets);
                self.go(next, "there is no target behind this step", out)?;
            }
            Command::PreviousTarget => {
                let previous = self.cursor.previous_of(self.log, &self.targets);
                self.go(previous, "there is no target before this step", out)?;
            }
            Command::Filter(filter) => {
                self.choose(filter);
                let what = match self.filter {
                    Some(_) => "named by the filter",
                    None => "of interest",
                };
                let text = match self.targets.len() {
                    1 => format!("1 step is {what}"),
                    many => format!("{many} steps are {what}"),
                };
                say(&text, out)?;
                let filter = self.filter.as_ref();
                let why = filter.filter(|_| self.targets.is_empty());
                if let Some(why) = why.and_then(|filter| filter.why_none(self.log)) {
                    say(&why, out)?;
                }
            }
            Command::Who(asked) => self.who(asked, out)?,
            Command::Go(step) => match step.parse().and_then(|at| self.log.event_at(at)) {
                Ok(event) => {
                    let there = Cursor::at(self.log, self.log.leaf(event));
                    self.go(Some(there), "", out)?;
                }
                Err(error) => say(&error.to_string(), out)?,
            },
            Command::Level(level) => {
                let there = self.cursor.at_level(self.log, level);
                self.go(Some(there), "", out)?;
            }
            Command::Predict => {
                self.predicts = !self.predicts;
                say(
                    if self.predicts {
                        "questions are asked before verdicts"
                    } else {
                        "no more questions are asked"
                    },
                    out,
                )?;
                if !self.predicts && self.asked.take().is_some() {
                    self.show(out)?;
                }
            }
            Command::Answer(choice) => self.answer(choice, out)?,
            Command::Skip => match self.asked.take() {
                Some(_) => self.show(out)?,
                None => say("no question waits for an answer", out)?,
            },
            // the state after the step would give the answer away
            Command::View if self.asked.is_some() => say("answer the question, or skip it", out)?,
            Command::View => self.view(out)?,
            Command::Save if self.asked.is_some() => say("answer the question, or skip it", out)?,
            Command::Save => match save(self.log, self.cursor.here, words) {
                Ok(text) => say(&text, out)?,
                // the next step may be drawn, or another folder be free
                Err(error) => say(&error.to_string(), out)?,
            },
            Command::Address => {
                let at = self.log.step(self.cursor.here).events.start;
                say(&words.command(&address_of(self.log, at)), out)?;
            }
            Command::Keys => {
                for key in KEYS {
                    let argument = if key.argument.is_empty() {
                        String::new()
                    } else {
                        format!(" {}", key.argument)
                    };
                    let names = key.words.iter().copied().chain([key.key]);
                    let mut seen: Vec<&str> = Vec::new();
                    for name in names {
                        if !seen.contains(&name) {
                            seen.push(name);
                        }
                    }
                    say(&format!("{}{argument}: {}", seen.join(", "), key.does), out)?;
                }
            }
            Command::Strategy => return Ok(Next::Strategy),
            Command::Pixel(shift) => return Ok(Next::Pixel(shift)),
            Command::Quit => return Ok(Next::Quit),
        }
        Ok(Next::Here)
    }

    /// To another step, which is shown; or a message that there is none.
    fn go(&mut self, to: Option<Cursor>, none: &str, out: &mut Output) -> Result<(), Error> {
        match to {
            Some(there) => {
                self.cursor = there;
                self.arrive(out)
            }
            None => say(none, out),
        }
    }

    /// To the step that set a value.
    fn who(&mut self, asked: Option<Asked>, out: &mut Output) -> Result<(), Error> {
        let Some(setter) = self.log.who_set(self.cursor.here, asked) else {
            return say("no step before this one has set it", out);
        };
        say(&setter.text(self.log), out)?;
        let there = Cursor::at(self.log, self.log.landing(setter.event));
        self.go(Some(there), "", out)
    }

    /// The question of the step, if questions are asked and it has one; or the step.
    pub(crate) fn arrive(&mut self, out: &mut Output) -> Result<(), Error> {
        self.asked = None;
        let here = self.cursor.here;
        let asked = self.predicts.then(|| self.log.question(here)).flatten();
        let Some(question) = asked else {
            return self.show(out);
        };
        let choices: String = LETTERS
            .iter()
            .zip(&question.choices)
            .fold(String::new(), |text, (letter, choice)| {
                text + &format!("{letter}: {}\n", choice.text)
            });
        let text = format!(
            "\n{}\n{}\nquestion: {}\n{choices}answer with a letter, or skip\n",
            subject(self.log, here),
            self.log.place_text(here),
            question.text
        );
        self.asked = Some(question);
        write(&text, out)
    }

    /// Right or wrong, why each choice is so, and then the step.
    fn answer(&mut self, choice: usize, out: &mut Output) -> Result<(), Error> {
        let Some(question) = self.asked.take() else {
            return say("no question waits for an answer", out);
        };
        if question.choices.len() <= choice {
            self.asked = Some(question);
            return say("the question has no such choice", out);
        }
        let mut text = format!("{}\n", question.verdict(choice));
        for reason in question.reasons() {
            text.push_str(&reason);
            text.push('\n');
        }
        write(&text, out)?;
        self.show(out)
    }

    /// The step: its title, where it is, its words, and what it changed.
    pub(crate) fn show(&self, out: &mut Output) -> Result<(), Error> {
        let told = self.log.told(&self.words, self.cursor.here);
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

    /// All that is known after the step.
    fn view(&self, out: &mut Output) -> Result<(), Error> {
        let log = self.log;
        let state = log.state_after(self.cursor.here);
        let own = state.quantities.iter().map(|held| (None, held));
        let rays = state.rays.iter().flat_map(|ray| {
            let id = Some(ray.id);
            ray.quantities.iter().map(move |held| (id, held))
        });
        let mut lines = Vec::new();
        let open: Vec<String> = state.rays.iter().map(|ray| ray.id.to_string()).collect();
        lines.push(match open.as_slice() {
            [] => "no ray is open".into(),
            open => format!("open rays: {}", open.join(", ")),
        });
        for (ray, (quantity, held)) in own.chain(rays) {
            let ray = ray.map_or(String::new(), |ray| format!("ray {ray}, "));
            lines.push(format!(
                "{ray}{}: {}, set by step {}",
                quantity.name(log.scene),
                held.value.text(log.scene),
                address_of(log, held.by)
            ));
        }
        for line in lines {
            say(&line, out)?;
        }
        Ok(())
    }
}

/// Why a move leads nowhere.
fn nothing_there(by: Move) -> &'static str {
    match by {
        Move::Over | Move::NextLeaf | Move::Last => "this is the last step",
        Move::Back | Move::PreviousLeaf | Move::First => "this is the first step",
        Move::Into => "this is a single event: nothing is inside",
        Move::Out => "nothing is around this step",
    }
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
