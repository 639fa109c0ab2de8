//! The steps of a log, and where each is among the others.

use std::ops::Range;

use crate::scene::Scene;
use crate::step::builder::{Built, build};
use crate::step::interest::Interest;
use crate::step::level::Level;
use crate::step::state::State;
use crate::step::states::States;
use crate::step::step::Step;
use crate::trace::{Record, Settings};

/// The log of a pixel as a tree of steps, with the state at each of them.
///
/// The records are those of one pixel: how the structure was built, the paths of light that led to it, then its own, as
/// `record_pixel` and `LogReader::pixel` return them.
#[derive(Debug)]
pub struct StepLog<'a> {
    /// The scene that was traced.
    pub scene: &'a Scene,
    /// How it was traced.
    pub settings: &'a Settings,
    /// The events, of which each is a leaf.
    pub records: &'a [Record],
    steps: Vec<Step>,
    /// The number of the leaf of each event.
    leaves: Vec<usize>,
    /// The sections, by their numbers.
    sections: Range<usize>,
    states: States,
    interests: Vec<(usize, Interest)>,
}

impl<'a> StepLog<'a> {
    /// The steps of a log.
    pub fn new(scene: &'a Scene, settings: &'a Settings, records: &'a [Record]) -> Self {
        let Built {
            steps,
            leaves,
            sections,
            states,
            interests,
        } = build(settings, records);
        Self {
            scene,
            settings,
            records,
            steps,
            leaves,
            sections,
            states,
            interests,
        }
    }

    /// A step by its number. Siblings have numbers in a row.
    pub fn step(&self, number: usize) -> &Step {
        &self.steps[number]
    }

    /// All steps, by their numbers.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The sections, by their numbers: none in an empty log.
    pub fn sections(&self) -> Range<usize> {
        self.sections.clone()
    }

    /// The leaf of an event.
    pub fn leaf(&self, event: usize) -> usize {
        self.leaves[event]
    }

    /// The step to stand at for an event: its leaf, or the test that it is a term of.
    pub fn landing(&self, event: usize) -> usize {
        let leaf = self.leaf(event);
        let is_test = |parent: &usize| {
            let parent = &self.steps[*parent];
            parent.level == Level::Test && !parent.is_fold()
        };
        if self.steps[leaf].level == Level::Term {
            let mut above = self.steps[leaf].parent;
            // many terms may be one step in the test
            while let Some(parent) = above.filter(|&parent| self.steps[parent].level == Level::Term)
            {
                above = self.steps[parent].parent;
            }
            return above.filter(is_test).unwrap_or(leaf);
        }
        leaf
    }

    /// The steps that hold a step, the innermost first.
    pub fn above(&self, number: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(self.steps[number].parent, |&above| self.steps[above].parent)
    }

    /// The step among some siblings that holds an event.
    pub(in crate::step) fn among(&self, siblings: Range<usize>, event: usize) -> Option<usize> {
        let steps = &self.steps[siblings.clone()];
        let place = steps.partition_point(|step| step.events.end <= event);
        (place < steps.len()).then_some(siblings.start + place)
    }

    /// What is known before an event; behind the last one, what is known after all.
    pub fn state_before(&self, event: usize) -> State {
        self.states.before(event, self.records)
    }

    /// The steps to stand at for what is of interest by itself, in the order of the log.
    pub fn targets(&self) -> Vec<usize> {
        let events = self.interests.iter().map(|&(event, _)| event);
        let mut targets: Vec<usize> = events.map(|event| self.landing(event)).collect();
        // several events of one test
        targets.dedup();
        targets
    }

    /// The events that are of interest by themselves, in their order.
    pub fn interests(&self) -> &[(usize, Interest)] {
        &self.interests
    }
}
