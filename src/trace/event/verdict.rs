//! What became of a test: one pair of words for all kinds of tests, `verdict` and, where rejected, `why`.

use crate::geometry::{
    BoxTest, PlaneTest, PlaneVerdict, PolygonTest, QuadraticTest, RootVerdict, Roots, SlabInterval,
};
use crate::structure::SlabVerdict;
use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::words::{Verdict, Why};

pub(super) const fn verdict(why: Option<Why>) -> Verdict {
    match why {
        None => Verdict::Hit,
        Some(_) => Verdict::Rejected,
    }
}

impl Why {
    /// Why a root is not the hit; `None` for the hit.
    const fn of_root(verdict: RootVerdict) -> Option<Self> {
        match verdict {
            RootVerdict::Chosen => None,
            RootVerdict::Behind => Some(Self::Behind),
            RootVerdict::BelowEpsilon => Some(Self::BelowEpsilon),
            RootVerdict::BeyondNearest => Some(Self::BeyondNearest),
            RootVerdict::BackFace => Some(Self::BackFace),
            RootVerdict::FrontFace => Some(Self::FrontFace),
            RootVerdict::BeyondEnds => Some(Self::BeyondEnds),
        }
    }
}

/// Why no root is the hit; `None` if one is.
///
/// Of two rejected roots the nearer one in front of the origin has the reason. If both lie behind the origin or at it,
/// the further one has it. Without a root the reason is `without`.
fn why_no_hit(roots: &Roots, without: Why) -> Option<Why> {
    if roots.chosen().is_some() {
        return None;
    }
    let in_front = |verdict| !matches!(verdict, RootVerdict::Behind | RootVerdict::BelowEpsilon);
    let root = roots.iter().find(|root| in_front(root.verdict));
    let root = root.or_else(|| roots.iter().last());
    root.map_or(Some(without), |root| Why::of_root(root.verdict))
}

pub(super) fn of_quadratic(test: &QuadraticTest) -> Option<Why> {
    why_no_hit(&test.roots, Why::NoRoot)
}

pub(super) fn of_box(test: &BoxTest) -> Option<Why> {
    let without = if test.slabs.contains(&SlabInterval::ParallelOutside) {
        Why::Parallel
    } else {
        Why::Empty
    };
    why_no_hit(&test.roots, without)
}

pub(super) fn of_plane(test: &PlaneTest) -> Option<Why> {
    match test.verdict {
        PlaneVerdict::Meets(root) => Why::of_root(root.verdict),
        PlaneVerdict::ParallelBeside | PlaneVerdict::ParallelWithin => Some(Why::Parallel),
    }
}

pub(super) fn of_polygon(test: &PolygonTest) -> Option<Why> {
    (!test.inside).then_some(Why::Outside)
}

pub(super) fn of_slab(verdict: SlabVerdict) -> Option<Why> {
    match verdict {
        SlabVerdict::GoesOn | SlabVerdict::ParallelInside => None,
        SlabVerdict::Null => Some(Why::Empty),
        SlabVerdict::ParallelOutside => Some(Why::Parallel),
    }
}

/// A verdict as two fields: why a test was rejected, if it was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Judged(pub(super) Option<Why>);

impl Fields for Judged {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let mut found = verdict(self.0);
        v.field("verdict", "What became of the test.", &mut found);
        let meaning = "Why the test was rejected; absent: it was not.";
        v.optional("why", meaning, &mut self.0);
        if found != verdict(self.0) {
            v.fail("a test has a \"why\" if it is rejected, and only then");
        }
    }
}

impl Judged {
    /// A verdict that follows from the rest of the line, and stands in it for whoever looks for it alone.
    pub(super) fn derived<V: Visitor>(why: Option<Why>, v: &mut V) {
        let mut found = Self(why);
        found.fields(v);
        if found.0 != why {
            v.fail("\"verdict\" or \"why\" does not follow from the test");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Root;

    #[track_caller]
    fn check(verdicts: &[RootVerdict], expected: Option<Why>) {
        let root = |verdict| Root { t: 1.0, verdict };
        let roots = match *verdicts {
            [] => Roots::None,
            [verdict] => Roots::Graze(root(verdict)),
            [near, far, ..] => Roots::Two {
                near: root(near),
                far: root(far),
            },
        };
        assert_eq!(why_no_hit(&roots, Why::NoRoot), expected, "{verdicts:?}");
    }

    #[test]
    fn the_nearer_root_in_front_of_the_origin_says_why_there_is_no_hit() {
        use RootVerdict::{BackFace, Behind, BelowEpsilon, BeyondEnds, BeyondNearest, Chosen};
        check(&[], Some(Why::NoRoot));
        check(&[Chosen], None);
        check(&[Behind, Chosen], None);
        check(&[Chosen, BeyondNearest], None);
        check(&[BeyondEnds], Some(Why::BeyondEnds));
        check(&[BeyondEnds, BeyondNearest], Some(Why::BeyondEnds));
        check(&[Behind, BeyondNearest], Some(Why::BeyondNearest));
        check(&[BelowEpsilon, BackFace], Some(Why::BackFace));
        check(&[Behind, Behind], Some(Why::Behind));
        check(&[Behind, BelowEpsilon], Some(Why::BelowEpsilon));
    }
}
