//! Where a reader stands in the steps, and the moves from there.
//!
//! A *grain* says which steps are opened. The steps that are not opened lie side by side and hold each event once, so over
//! and back walk along them in either direction, and none is skipped. A move into a step or out of it changes the grain
//! to that of the step's siblings: as in a debugger, a ray that is spawned there is then one step. A level opens every ray.

use std::cmp::Reverse;
use std::ops::Range;

use crate::step::level::Level;
use crate::step::step::Step;
use crate::step::tree::StepLog;

/// Which steps are opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grain {
    /// Rays are opened that fewer than so many rays hold: with 1 the eye rays, but no ray that they spawn.
    pub rays: usize,
    /// Sections, places and tests are opened that are more than this.
    pub level: Level,
    /// Are folds of this level opened too?
    pub unfolded: bool,
}

impl Grain {
    /// The sections.
    pub const SECTIONS: Self = Self {
        rays: 0,
        level: Level::Section,
        unfolded: false,
    };

    /// Every event by itself.
    pub const EVENTS: Self = Self {
        rays: usize::MAX,
        level: Level::Term,
        unfolded: true,
    };

    /// All places, tests or terms, of every ray; of rays those of the eye.
    pub fn of_level(level: Level) -> Self {
        match level {
            Level::Section => Self::SECTIONS,
            Level::Ray => Self {
                rays: 0,
                level,
                unfolded: false,
            },
            Level::Place | Level::Test => Self {
                rays: usize::MAX,
                level,
                unfolded: false,
            },
            Level::Term => Self::EVENTS,
        }
    }

    /// Is a step opened?
    fn opens(self, step: &Step) -> bool {
        if step.is_leaf() {
            return false;
        }
        let is_finer = step.level < self.level;
        match step.level {
            Level::Ray => Level::Section < self.level && step.nesting < self.rays,
            _ if step.is_fold() => is_finer || step.level == self.level && self.unfolded,
            _ => is_finer,
        }
    }
}

/// A move of the cursor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// To the next step of the grain.
    Over,
    /// To the step of the grain before.
    Back,
    /// To the first step that this one holds.
    Into,
    /// To the step that holds this one.
    Out,
    /// To the next event; from a step that holds several, to its first.
    NextLeaf,
    /// To the event before.
    PreviousLeaf,
    /// To the first step of the grain.
    First,
    /// To the last step of the grain.
    Last,
}

impl Move {
    /// What is said where the move leads nowhere.
    pub const fn leads_nowhere(self) -> &'static str {
        match self {
            Self::Over | Self::NextLeaf | Self::Last => "this is the last step",
            Self::Back | Self::PreviousLeaf | Self::First => "this is the first step",
            Self::Into => "this is a single event: nothing is inside",
            Self::Out => "nothing is around this step",
        }
    }
}

/// Where a reader stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cursor {
    /// The number of the step.
    pub here: usize,
    /// Which steps are opened: this one is not, and all that hold it are.
    pub grain: Grain,
}

impl Cursor {
    /// At the first section; `None` in an empty log.
    pub fn at_start(log: &StepLog) -> Option<Self> {
        let here = log.sections().next()?;
        Some(Self {
            here,
            grain: Grain::SECTIONS,
        })
    }

    /// At a step, with the grain of its siblings.
    pub fn at(log: &StepLog, here: usize) -> Self {
        let mut grain = Grain::SECTIONS;
        for above in log.above(here) {
            let step = log.step(above);
            match step.level {
                Level::Ray => {
                    grain.rays += 1;
                    grain.level = grain.level.max(Level::Ray);
                }
                _ if step.is_fold() => grain.level = grain.level.max(step.level),
                level => grain.level = grain.level.max(level.below()),
            }
        }
        grain.unfolded = log.above(here).any(|above| {
            let step = log.step(above);
            step.is_fold() && step.level == grain.level
        });
        Self { here, grain }
    }

    /// Where a move leads; `None` where there is nothing.
    pub fn moved(self, log: &StepLog, by: Move) -> Option<Self> {
        let Range { start, end } = log.step(self.here).events;
        let last = log.records.len().checked_sub(1)?;
        match by {
            Move::Over => self.along(log, Some(end)),
            Move::Back => self.along(log, start.checked_sub(1)),
            Move::First => self.along(log, Some(0)),
            Move::Last => self.along(log, Some(last)),
            Move::Into => {
                let child = log.step(self.here).children.clone().next()?;
                Some(Self::at(log, child))
            }
            Move::Out => Some(Self::at(log, log.step(self.here).parent?)),
            Move::NextLeaf if log.step(self.here).is_leaf() => {
                (end <= last).then(|| Self::at(log, log.leaf(end)))
            }
            Move::NextLeaf => Some(Self::at(log, log.leaf(start))),
            Move::PreviousLeaf => Some(Self::at(log, log.leaf(start.checked_sub(1)?))),
        }
    }

    /// The step of the grain that holds an event.
    fn along(self, log: &StepLog, event: Option<usize>) -> Option<Self> {
        let here = step_with(log, self.grain, event?)?;
        Some(Self { here, ..self })
    }

    /// The same place at another level: the ray or the section around it, or all places, tests or terms.
    ///
    /// Of rays that is the innermost one that holds the step. Where a level has nothing, as a place among the tests of a
    /// simple search, what is less stands for it.
    #[must_use]
    pub fn at_level(self, log: &StepLog, level: Level) -> Self {
        let wanted = match level {
            Level::Section | Level::Ray => self.around(log, level).map(|here| Self::at(log, here)),
            Level::Place | Level::Test | Level::Term => None,
        };
        wanted.unwrap_or_else(|| {
            let grain = Grain::of_level(level);
            let start = log.step(self.here).events.start;
            let here = step_with(log, grain, start).unwrap_or(self.here);
            Self { here, grain }
        })
    }

    /// The innermost step of a level that is this one or holds it.
    pub(in crate::step) fn around(self, log: &StepLog, level: Level) -> Option<usize> {
        let mut with_above = std::iter::once(self.here).chain(log.above(self.here));
        with_above.find(|&step| log.step(step).level == level && !log.step(step).is_fold())
    }

    /// The next of some steps, which are in the order of the log and none in another; `None` behind the last.
    pub fn next_of(self, log: &StepLog, targets: &[usize]) -> Option<Self> {
        let here = place(log, self.here);
        let next = targets.partition_point(|&target| place(log, target) <= here);
        targets.get(next).map(|&target| Self::at(log, target))
    }

    /// The one of some steps before this; `None` before the first.
    pub fn previous_of(self, log: &StepLog, targets: &[usize]) -> Option<Self> {
        let here = place(log, self.here);
        let next = targets.partition_point(|&target| place(log, target) < here);
        let previous = targets.get(next.checked_sub(1)?);
        previous.map(|&target| Self::at(log, target))
    }
}

/// Where a step is in the order of the log: a step comes before those that it holds.
pub(in crate::step) fn place(log: &StepLog, step: usize) -> (usize, Reverse<usize>, usize) {
    let Range { start, end } = log.step(step).events;
    // of a ray with a single event the ray comes first
    (start, Reverse(end), log.above(step).count())
}

/// The step of a grain that holds an event; `None` behind the last event.
pub(in crate::step) fn step_with(log: &StepLog, grain: Grain, event: usize) -> Option<usize> {
    let mut here = log.among(log.sections(), event)?;
    while grain.opens(log.step(here)) {
        here = log.among(log.step(here).children.clone(), event)?;
    }
    Some(here)
}
