//! What came out of a check.

use std::collections::BTreeMap;

use crate::lesson::check::agreeing::Agreeing;
use crate::lesson::check::suspects::Suspects;
use crate::mistake::Mistake;
use crate::trace::Kind;

/// A quantity of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its key in the log.
    pub key: String,
    /// What the log has.
    pub yours: String,
    /// What is expected.
    pub expected: String,
    /// Are both the same within the tolerance?
    pub is_same: bool,
}

/// The first line that differs.
#[derive(Clone, Debug)]
pub struct Divergence {
    /// The number of the line, from 1.
    pub line: u64,
    /// Column and row.
    pub pixel: [u32; 2],
    /// What the line is about.
    pub kind: Kind,
    /// In words: `eye ray`, `shadow ray to lamp`; nothing for what belongs to the pixel.
    pub ray: String,
    /// In words: `A`, `lamp`, `cell 3`; nothing if the kind says it all.
    pub subject: String,
    /// The quantities up to the one that differs, which is the last one.
    pub quantities: Vec<Quantity>,
    /// The step of the pixel's log that shows what is right.
    pub step: u32,
    /// The number of the ray in that log.
    pub ray_number: Option<u32>,
    /// The line's own fields, as JSON.
    pub fields: Vec<(String, String)>,
    /// The mistake that gives these values on all lines of the kind that differ.
    pub mistake: Option<&'static Mistake>,
}

/// A field that no line of its kind has: a slip, or the program's own.
#[derive(Clone, Debug)]
pub struct UnknownField {
    /// The kind of the lines that have it.
    pub kind: Kind,
    /// Its key.
    pub key: String,
    /// The first line that has it, from 1.
    pub line: u64,
    /// How many lines have it.
    pub lines: u64,
    /// The field of the kind that it is most like.
    pub near: Option<String>,
}

/// What was compared, what was absent, and the first divergence.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// How many pixels the log has.
    pub pixels: u64,
    /// How many lines of each kind were compared.
    pub compared: BTreeMap<Kind, u64>,
    /// How many lines of each kind differ.
    pub different: BTreeMap<Kind, u64>,
    /// How many lines of each kind have nothing to be compared with: this program takes no such step there.
    pub beyond: BTreeMap<Kind, u64>,
    /// Kinds that the pixels have here, and the log has not.
    pub absent: Vec<Kind>,
    /// Lines that are not compared, by what they say they are.
    pub ignored: BTreeMap<String, u64>,
    /// Fields that no line of their kind has, which are not compared.
    pub unknown: Vec<UnknownField>,
    /// The first line that differs, in the order of the working.
    pub divergence: Option<Divergence>,
    /// The mistakes that explain all that differs so far; none before anything does.
    pub(super) suspects: Option<Suspects>,
    /// Some colours that agree before the first one differs.
    pub(super) agreeing: Agreeing,
    pub(super) expected: std::collections::BTreeSet<Kind>,
}

impl Checked {
    /// Is nothing different?
    pub fn is_right(&self) -> bool {
        self.divergence.is_none()
    }

    pub(super) fn finish(
        &mut self,
        (ignored, unknown): (BTreeMap<String, u64>, Vec<UnknownField>),
    ) {
        self.ignored = ignored;
        self.unknown = unknown;
        let met = |kind: &Kind| self.compared.contains_key(kind) || self.beyond.contains_key(kind);
        self.absent = self
            .expected
            .iter()
            .copied()
            .filter(|kind| !met(kind))
            .collect();
        let suspects = self.suspects.take();
        if let (Some(divergence), Some(suspects)) = (&mut self.divergence, suspects) {
            divergence.mistake = suspects.found();
        }
    }
}
