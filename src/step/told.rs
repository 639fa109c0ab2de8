//! What a step says, the same in every face: its title, where it is, its words, what it changed.

use crate::explain::{Line, Tone};
use crate::step::address::Address;
use crate::step::headline::headline;
use crate::step::interest::Interest;
use crate::step::level::Level;
use crate::step::tree::StepLog;
use crate::step::words::StepWords;

/// What a step says.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// Its title: what it is about, and what became of it.
    pub title: String,
    /// Where it is: `test, steps 2 to 3 of 32, ray 0`.
    pub place: String,
    /// The lines of the worked solution that tell it, without a heading that its title has already.
    pub lines: Vec<Line>,
    /// What it changed, each with its ray: `ray 0, nearest hit: none → A at t = 7.92`.
    pub changes: Vec<String>,
    /// Why it is a target by itself, if it is one.
    pub interest: Option<Interest>,
    /// The number of steps that it holds.
    pub holds: usize,
}

impl Told {
    /// What is said below the lines, one fact a line.
    pub fn facts(&self) -> Vec<String> {
        let changes = self.changes.iter();
        let mut facts: Vec<String> = changes.map(|change| format!("changed: {change}")).collect();
        facts.extend(
            self.interest
                .map(|interest| format!("of interest: {interest}")),
        );
        facts.extend(match self.holds {
            0 => None,
            1 => Some("holds 1 step".into()),
            many => Some(format!("holds {many} steps")),
        });
        facts
    }
}

impl StepLog<'_> {
    /// What a step says. `words` are those of this log.
    pub fn told(&self, words: &StepWords, number: usize) -> Told {
        let title = headline(self, number);
        let mut lines = words.of(self, number);
        // a ray's heading is its title already
        lines.retain(|line| line.tone != Tone::Heading || !title.starts_with(&line.text));
        let changes = self.changes(number).into_iter().map(|change| {
            let ray = change.ray;
            let ray = ray.map_or(String::new(), |ray| format!("ray {ray}, "));
            format!("{ray}{}", change.text(self.scene))
        });
        Told {
            place: self.place_text(number),
            lines,
            changes: changes.collect(),
            interest: self.interest(number),
            holds: self.step(number).children.len(),
            title,
        }
    }

    /// Where a step is, in words: `test, steps 2 to 3 of 32, ray 0`.
    pub fn place_text(&self, number: usize) -> String {
        let step = self.step(number);
        let mut with_above = std::iter::once(number).chain(self.above(number));
        let section = with_above.find(|&above| self.step(above).level == Level::Section);
        let end = section.map_or(step.events.end, |section| self.step(section).events.end);
        let last_of_all = self.records[end - 1].step;
        let first = Address::of(self, step.events.start);
        let last = self.records[step.events.end - 1].step;
        let steps = match step.events.len() {
            1 => format!("step {first} of {last_of_all}"),
            _ => format!("steps {first} to {last} of {last_of_all}"),
        };
        let ray = self.records[step.lead].ray;
        let ray = ray.map_or(String::new(), |ray| format!(", ray {ray}"));
        format!("{}, {steps}{ray}", step.level)
    }

    /// Why a step is a target by itself; `None` if it is none.
    pub fn interest(&self, number: usize) -> Option<Interest> {
        let of = self.interests();
        let step = self.step(number);
        let first = of.partition_point(|(event, _)| *event < step.events.start);
        let inside = of[first..]
            .iter()
            .take_while(|(event, _)| step.events.contains(event));
        let landed = inside.filter(|(event, _)| self.landing(*event) == number);
        landed.last().map(|&(_, interest)| interest)
    }

    /// The address of a step's first event.
    pub fn address(&self, number: usize) -> Address {
        Address::of(self, self.step(number).events.start)
    }
}
