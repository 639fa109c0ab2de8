//! A reader in a log: where one stands, which targets there are, and the question that waits. Each face shows what comes of a
//! command; what a command does is said here once.

use crate::step::address::Address;
use crate::step::cursor::Cursor;
use crate::step::filter::{Filter, told_of};
use crate::step::keys::{Command, PAGE};
use crate::step::level::Level;
use crate::step::question::Question;
use crate::step::tree::StepLog;
use crate::step::who::Asked;

/// A reader in a log.
#[derive(Clone, Debug)]
pub struct Reader<'a, 'l> {
    log: &'a StepLog<'l>,
    cursor: Cursor,
    filter: Option<Filter>,
    predicts: bool,
    asked: Option<Question>,
    targets: Vec<usize>,
}

/// What comes of a command.
#[derive(Clone, Debug, PartialEq)]
pub enum Reaction {
    /// These lines are said, and then the step where the reader stands is shown, or its question.
    Shown(Vec<String>),
    /// These lines are said.
    Said(Vec<String>),
    /// What the face does, or whoever has the scene: to show the keys or the state, to save, another pixel, the end.
    Left(Command),
}

impl<'a, 'l> Reader<'a, 'l> {
    /// At a step of a log.
    pub fn new(
        log: &'a StepLog<'l>,
        cursor: Cursor,
        filter: Option<Filter>,
        predicts: bool,
    ) -> Self {
        let mut reader = Self {
            log,
            cursor,
            filter: None,
            predicts,
            asked: None,
            targets: Vec::new(),
        };
        reader.choose(filter);
        reader.arrive();
        reader
    }

    /// The log.
    pub fn log(&self) -> &'a StepLog<'l> {
        self.log
    }

    /// Where the reader stands.
    pub fn cursor(&self) -> Cursor {
        self.cursor
    }

    /// The number of the step where the reader stands.
    pub fn here(&self) -> usize {
        self.cursor.here
    }

    /// What the targets are chosen by; `None`: by what is of interest.
    pub fn filter(&self) -> Option<&Filter> {
        self.filter.as_ref()
    }

    /// Are questions asked?
    pub fn predicts(&self) -> bool {
        self.predicts
    }

    /// The question that waits for an answer.
    pub fn asked(&self) -> Option<&Question> {
        self.asked.as_ref()
    }

    /// The number of events whose verdicts may be shown: with questions those up to the test or the event where the reader stands, and
    /// before an answer, or on a step that holds tests, those before it. What follows has questions of its own.
    pub fn seen(&self) -> usize {
        let step = self.log.step(self.cursor.here);
        let holds_tests = !step.is_leaf() && step.level < Level::Test;
        match (self.predicts, &self.asked) {
            (false, _) => self.log.records.len(),
            (true, None) if !holds_tests => step.events.end,
            (true, _) => step.events.start,
        }
    }

    /// May the verdict of a step be shown?
    pub fn is_seen(&self, step: usize) -> bool {
        let is_told = step == self.cursor.here && self.asked.is_none();
        is_told || self.log.step(step).events.end <= self.seen()
    }

    /// The targets are what the filter names, or what is of interest.
    fn choose(&mut self, filter: Option<Filter>) {
        self.targets = match &filter {
            Some(filter) => filter.targets(self.log),
            None => self.log.targets(),
        };
        self.filter = filter;
    }

    /// The step has a question, if questions are asked.
    fn arrive(&mut self) {
        let question = || self.log.question(self.cursor.here);
        self.asked = self.predicts.then(question).flatten();
    }

    /// Does what a command says.
    pub fn obey(&mut self, command: Command) -> Reaction {
        let said = |text: &str| Reaction::Said(vec![text.into()]);
        match command {
            Command::Move(by) => self.go(self.cursor.moved(self.log, by), by.leads_nowhere()),
            Command::Page(by) => {
                let moved = |here: &Cursor| here.moved(self.log, by);
                let steps = std::iter::successors(moved(&self.cursor), moved);
                self.go(steps.take(PAGE).last(), by.leads_nowhere())
            }
            Command::NextTarget => {
                let next = self.cursor.next_of(self.log, &self.targets);
                self.go(next, "there is no target after this step")
            }
            Command::PreviousTarget => {
                let previous = self.cursor.previous_of(self.log, &self.targets);
                self.go(previous, "there is no target before this step")
            }
            Command::Filter(filter) => {
                self.choose(filter);
                Reaction::Said(told_of(self.log, self.filter.as_ref(), &self.targets))
            }
            Command::Who(asked) => self.who(asked),
            Command::Go(step) => match step.parse().and_then(|at| self.log.event_at(at)) {
                Ok(event) => {
                    let there = Cursor::at(self.log, self.log.leaf(event));
                    self.go(Some(there), "")
                }
                Err(error) => said(&error.to_string()),
            },
            Command::Level(level) => {
                let there = self.cursor.at_level(self.log, level);
                self.go(Some(there), "")
            }
            Command::Predict => {
                self.predicts = !self.predicts;
                if self.predicts {
                    return said("questions are asked before verdicts");
                }
                let lines = vec!["no more questions are asked".into()];
                match self.asked.take() {
                    Some(_) => Reaction::Shown(lines),
                    None => Reaction::Said(lines),
                }
            }
            Command::Answer(choice) => self.answer(choice),
            Command::Skip => match self.asked.take() {
                Some(_) => Reaction::Shown(Vec::new()),
                None => said("no question waits for an answer"),
            },
            // the state after the step, and its drawing, would give the answer away
            Command::View | Command::Save if self.asked.is_some() => {
                said("answer the question, or skip it")
            }
            Command::View
            | Command::Save
            | Command::Address
            | Command::Keys
            | Command::Strategy
            | Command::Pixel(_)
            | Command::Quit => Reaction::Left(command),
        }
    }

    /// To another step; or a message that there is none.
    fn go(&mut self, to: Option<Cursor>, none: &str) -> Reaction {
        match to {
            Some(there) => {
                self.cursor = there;
                self.arrive();
                Reaction::Shown(Vec::new())
            }
            None => Reaction::Said(vec![none.into()]),
        }
    }

    /// To the step that set a value.
    fn who(&mut self, asked: Option<Asked>) -> Reaction {
        let step = self.log.step(self.cursor.here);
        // of a pixel or a ray a reader sees what it comes to in the end
        let last = self.log.leaf(step.events.end - 1);
        let holds_rays = !step.is_leaf() && step.level <= Level::Ray;
        let in_the_end = || self.log.who_set(last, asked).filter(|_| holds_rays);
        let setter = self.log.who_set(self.cursor.here, asked);
        let Some(setter) = setter.or_else(in_the_end) else {
            return Reaction::Said(vec!["no step before this one has set it".into()]);
        };
        let scene = self.log.scene;
        let text = format!(
            "{}: {}, set by step {}",
            setter.quantity.name(scene),
            setter.value.text(scene),
            Address::of(self.log, setter.event)
        );
        self.cursor = Cursor::at(self.log, self.log.landing(setter.event));
        self.arrive();
        Reaction::Shown(vec![text])
    }

    /// Right or wrong, why each choice is so, and then the step.
    fn answer(&mut self, choice: usize) -> Reaction {
        let Some(question) = self.asked.take() else {
            return Reaction::Said(vec!["no question waits for an answer".into()]);
        };
        if question.choices.len() <= choice {
            self.asked = Some(question);
            return Reaction::Said(vec!["the question has no such choice".into()]);
        }
        let verdict = std::iter::once(question.verdict(choice));
        Reaction::Shown(verdict.chain(question.reasons()).collect())
    }
}
