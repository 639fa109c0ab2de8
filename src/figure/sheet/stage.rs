//! The stages of a figure's argument: a few, named, with one sentence each.
//!
//! A trace has one step for each event; a lecture has one for each thought. A kind of figure names its stages and draws
//! what belongs to each. A drawing up to a stage shows that stage and those before it.

use std::borrow::Cow;
use std::ops::Range;

use crate::explain::Part;

/// Which of a figure's stages, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::figure) struct StageId(pub(in crate::figure) u32);

/// What a stage is called: a named part of a derivation, or a word that a figure alone needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::figure) struct StageName(pub(in crate::figure) Cow<'static, str>);

impl From<Part> for StageName {
    fn from(part: Part) -> Self {
        Self(part.name().into())
    }
}

impl From<&'static str> for StageName {
    fn from(name: &'static str) -> Self {
        Self(name.into())
    }
}

impl From<String> for StageName {
    fn from(name: String) -> Self {
        Self(name.into())
    }
}

/// A stage of a figure's argument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::figure) struct Stage {
    pub(in crate::figure) name: StageName,
    /// The last step of the trace that it needs; `None` if it needs none.
    pub(in crate::figure) step: Option<u32>,
    /// What it says.
    pub(in crate::figure) sentence: String,
}

/// So many things in stages, at most `most` of them: one by one, or in parts of equal size that follow each other.
pub(in crate::figure) fn parts(count: usize, most: usize) -> Vec<Range<usize>> {
    let stages = count.min(most.max(1));
    let start = |stage: usize| stage * count / stages;
    (0..stages)
        .map(|stage| start(stage)..start(stage + 1))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_things_are_cut_into_parts_of_equal_size() {
        assert_eq!(parts(2, 3), [0..1, 1..2]);
        assert_eq!(parts(6, 3), [0..2, 2..4, 4..6]);
        assert_eq!(parts(5, 3), [0..1, 1..3, 3..5]);
        assert!(parts(0, 3).is_empty());
    }
}
