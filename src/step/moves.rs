//! The moves from every step as tables, for a face that has no log: a page looks them up and computes none.
//!
//! Where a reader stands is a step and a grain, as for a [`Cursor`]. The steps of a grain lie side by side: over, back, first and
//! last walk along them. Every other move leads to a step with the grain of its siblings, whatever the grain was before.

use crate::step::cursor::{Cursor, Grain, Move, step_with};
use crate::step::level::Level;
use crate::step::tree::StepLog;

/// The moves from every step of a log.
#[derive(Clone, Debug, PartialEq)]
pub struct Moves {
    /// The grains that a reader may have.
    pub grains: Vec<Grain>,
    /// Of each grain its steps, in the order of the log.
    pub walks: Vec<Vec<usize>>,
    /// Of each level the place of the grain that opens it everywhere.
    pub levels: [usize; Level::ALL.len()],
    /// The moves from each step, by its number.
    pub from: Vec<MovesFrom>,
}

/// The moves from a step. A move that is absent leads nowhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MovesFrom {
    /// The place of the grain of its siblings.
    pub grain: usize,
    /// The first step that it holds.
    pub into: Option<usize>,
    /// The step that holds it.
    pub out: Option<usize>,
    /// The next event.
    pub next_leaf: Option<usize>,
    /// The event before.
    pub previous_leaf: Option<usize>,
    /// The next target.
    pub next_target: Option<usize>,
    /// The target before.
    pub previous_target: Option<usize>,
    /// The section around it.
    pub section: Option<usize>,
    /// The innermost ray around it.
    pub ray: Option<usize>,
}

impl StepLog<'_> {
    /// The steps of a grain, in the order of the log: each event is in one of them.
    pub fn walk(&self, grain: Grain) -> Vec<usize> {
        let first = step_with(self, grain, 0);
        let next = |&step: &usize| step_with(self, grain, self.step(step).events.end);
        std::iter::successors(first, next).collect()
    }

    /// The moves from every step.
    pub fn moves(&self) -> Moves {
        let mut grains: Vec<Grain> = Level::ALL.map(Grain::of_level).into();
        let levels = std::array::from_fn(|level| level);
        let targets = self.targets();
        let from = (0..self.steps().len())
            .map(|step| {
                let here = Cursor::at(self, step);
                let grain = grains.iter().position(|known| *known == here.grain);
                let grain = grain.unwrap_or_else(|| {
                    grains.push(here.grain);
                    grains.len() - 1
                });
                let to = |by| here.moved(self, by).map(|there| there.here);
                MovesFrom {
                    grain,
                    into: to(Move::Into),
                    out: to(Move::Out),
                    next_leaf: to(Move::NextLeaf),
                    previous_leaf: to(Move::PreviousLeaf),
                    next_target: here.next_of(self, &targets).map(|there| there.here),
                    previous_target: here.previous_of(self, &targets).map(|there| there.here),
                    section: here.around(self, Level::Section),
                    ray: here.around(self, Level::Ray),
                }
            })
            .collect();
        let walks = grains.iter().map(|&grain| self.walk(grain)).collect();
        Moves {
            grains,
            walks,
            levels,
            from,
        }
    }
}
