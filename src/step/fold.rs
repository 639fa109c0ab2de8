//! Many siblings of one kind and verdict as one step: "7 379 spheres missed".

use std::ops::Range;

use crate::step::level::Level;
use crate::step::quantity::{Changed, Quantity};
use crate::step::verdict::Became;
use crate::trace::Kind;

/// So many siblings in a row are one step: two are read as fast as their sum.
pub(in crate::step) const FOLDED_FROM: usize = 3;

/// What siblings must have in common to be one step.
#[derive(Clone, Copy, Debug)]
pub(in crate::step) struct FoldKey {
    pub(in crate::step) level: Level,
    /// The kind of the event that they are named by.
    pub(in crate::step) kind: Kind,
    pub(in crate::step) became: Option<Became>,
}

impl FoldKey {
    /// Are two siblings of one kind and verdict? The reason of a verdict may differ.
    fn is_like(self, other: Self) -> bool {
        let same_verdict = match (self.became, other.became) {
            (Some(one), Some(other)) => one.is_like(other),
            (one, other) => one == other,
        };
        self.level == other.level && self.kind == other.kind && same_verdict
    }
}

/// Does a step of this level stand alone because of what it changed?
///
/// A ray always does: it brings a colour or says whether light arrives. A test leaves a mark in a mailbox, whatever comes of
/// it, and the interval of its bound and the crossings of its polygon end with it: these are changes only among its own terms.
pub(in crate::step) fn stands_alone(level: Level, changed: Changed) -> bool {
    match level {
        Level::Section | Level::Ray => true,
        Level::Place | Level::Test => changed.beside(Changed::of(&[
            Quantity::Mailboxes,
            Quantity::MaxNear,
            Quantity::MinFar,
            Quantity::Crossings,
        ])),
        Level::Term => changed.beside(Changed::of(&[Quantity::Mailboxes])),
    }
}

/// The runs of siblings that become one step each. A sibling without a key stands alone.
///
/// `keeps_all` says that a run of all of them stays: their parent is that step already.
pub(in crate::step) fn runs(keys: &[Option<FoldKey>], keeps_all: bool) -> Vec<Range<usize>> {
    let mut runs = Vec::new();
    let mut first = 0;
    for run in keys.chunk_by(|one, other| {
        one.zip(*other)
            .is_some_and(|(one, other)| one.is_like(other))
    }) {
        let places = first..first + run.len();
        first = places.end;
        let is_all = places.len() == keys.len() && keeps_all;
        if FOLDED_FROM <= places.len() && !is_all {
            runs.push(places);
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::{Verdict, Why};

    const MISSED: Option<Became> = Some(Became::Tested(Verdict::Rejected, Some(Why::NoRoot)));
    const BEHIND: Option<Became> = Some(Became::Tested(Verdict::Rejected, Some(Why::Behind)));
    const HIT: Option<Became> = Some(Became::Tested(Verdict::Hit, None));

    fn spheres(of: &[Option<Became>]) -> Vec<Option<FoldKey>> {
        let key = |&became| {
            Some(FoldKey {
                level: Level::Test,
                kind: Kind::SphereTest,
                became,
            })
        };
        of.iter().map(key).collect()
    }

    /// The places of each run.
    fn places(keys: &[Option<FoldKey>], keeps_all: bool) -> Vec<Vec<usize>> {
        runs(keys, keeps_all)
            .into_iter()
            .map(Iterator::collect)
            .collect()
    }

    #[test]
    fn three_of_one_kind_and_verdict_are_one_step_whatever_the_reason_and_two_are_not() {
        let keys = spheres(&[MISSED, BEHIND, HIT, MISSED, MISSED, BEHIND, MISSED]);
        assert_eq!(places(&keys, true), [[3, 4, 5, 6]]);
        assert!(runs(&keys[..3], true).is_empty());
    }

    #[test]
    fn a_sibling_that_stands_alone_or_is_of_another_kind_ends_a_run() {
        let mut keys = spheres(&[MISSED; 7]);
        keys[3] = None;
        assert_eq!(places(&keys, true), [[0, 1, 2], [4, 5, 6]]);
        keys[3] = Some(FoldKey {
            level: Level::Test,
            kind: Kind::BoxTest,
            became: MISSED,
        });
        assert_eq!(places(&keys, true), [[0, 1, 2], [4, 5, 6]]);
    }

    #[test]
    fn a_run_of_all_stays_where_its_parent_is_that_step_already() {
        let keys = spheres(&[MISSED; 4]);
        assert!(runs(&keys, true).is_empty());
        assert_eq!(places(&keys, false), [[0, 1, 2, 3]]);
    }

    #[test]
    fn a_mark_in_a_mailbox_is_no_reason_to_stand_alone_and_a_nearer_hit_is() {
        let stamped = Changed::of(&[Quantity::Mailboxes, Quantity::MaxNear]);
        assert!(!stands_alone(Level::Test, stamped));
        // the slab that raises the largest near stands alone among the slabs
        assert!(stands_alone(Level::Term, stamped));
        assert!(stands_alone(
            Level::Test,
            stamped.and(Changed::of(&[Quantity::Nearest]))
        ));
        assert!(stands_alone(Level::Ray, Changed::default()));
    }
}
