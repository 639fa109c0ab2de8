//! A step.

use std::ops::Range;

use crate::step::level::Level;
use crate::step::quantity::Changed;
use crate::step::verdict::Became;

/// A step: some events in a row, with the steps that they are made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Its events, by their places among the records.
    pub events: Range<usize>,
    /// How much it is.
    pub level: Level,
    /// The step that holds it; `None` for a section.
    pub parent: Option<usize>,
    /// The steps that it holds, by their numbers; none for a single event.
    pub children: Range<usize>,
    /// The event that it is named by: of a test the one that decides, of a fold that of the first.
    pub lead: usize,
    /// What became of it; `None` where nothing is decided.
    pub became: Option<Became>,
    /// How many siblings are one step here; 0 for every other step.
    pub folded: usize,
    /// How many rays hold it.
    pub nesting: usize,
    /// What its events changed.
    pub(in crate::step) changed: Changed,
}

impl Step {
    /// Is it a single event?
    pub fn is_leaf(&self) -> bool {
        self.children.is_empty()
    }

    /// Are several siblings of one kind and verdict one step here?
    pub fn is_fold(&self) -> bool {
        0 < self.folded
    }
}
