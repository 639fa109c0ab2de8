//! What became of a test: one pair of words for all kinds of tests, `verdict` and, where rejected, `why`.

use crate::geometry::{BoxTest, Fate, PlaneTest, PlaneVerdict, Roots, SlabInterval};
use crate::structure::SlabOutcome;
use crate::trace::event::fields::Visitor;
use crate::trace::event::{BoundOutcome, Event, Verdict, Why};

impl Event {
    /// What became of a test, and if it was rejected, why. `None` for all that is no test.
    ///
    /// ```
    /// use raystep::{Event, PolygonTest, PrimitiveId, Verdict, Why};
    ///
    /// let test = PolygonTest { inside: false, ..PolygonTest::default() };
    /// let event = Event::PolygonTest { object: PrimitiveId(0), test };
    /// assert_eq!(event.verdict(), Some((Verdict::Rejected, Some(Why::Outside))));
    /// ```
    pub fn verdict(&self) -> Option<(Verdict, Option<Why>)> {
        let why = match self {
            Self::SphereTest { test, .. }
            | Self::EllipsoidTest { test, .. }
            | Self::ConeTest { test, .. } => why_no_hit(&test.roots, Why::NoRoot),
            Self::BoxTest { test, .. } => of_box(test),
            Self::PlaneTest { test, .. } => of_plane(test),
            Self::PolygonTest { test, .. } => of_polygon(test.inside),
            Self::BoundTest(test) => of_bound(test.outcome),
            Self::SlabTest(test) => of_slab(test.step.outcome),
            _ => return None,
        };
        Some((verdict(why), why))
    }
}

const fn verdict(why: Option<Why>) -> Verdict {
    match why {
        None => Verdict::Hit,
        Some(_) => Verdict::Rejected,
    }
}

impl Why {
    /// Why a root is not the hit; `None` for the hit.
    const fn of_root(fate: Fate) -> Option<Self> {
        match fate {
            Fate::Chosen => None,
            Fate::Behind => Some(Self::Behind),
            Fate::BelowEpsilon => Some(Self::BelowEpsilon),
            Fate::BeyondNearest => Some(Self::BeyondNearest),
            Fate::BackFace => Some(Self::BackFace),
            Fate::FrontFace => Some(Self::FrontFace),
            Fate::BeyondEnds => Some(Self::BeyondEnds),
        }
    }
}

/// Why no root is the hit; `None` if one is.
///
/// Of two rejected roots the nearer one in front of the origin has the reason. If both lie behind the origin or at it,
/// the further one has it. Without a root the reason is `without`.
pub(super) fn why_no_hit(roots: &Roots, without: Why) -> Option<Why> {
    if roots.chosen().is_some() {
        return None;
    }
    let in_front = |fate| !matches!(fate, Fate::Behind | Fate::BelowEpsilon);
    let root = roots.iter().find(|root| in_front(root.fate));
    let root = root.or_else(|| roots.iter().last());
    root.map_or(Some(without), |root| Why::of_root(root.fate))
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
        PlaneVerdict::Meets(root) => Why::of_root(root.fate),
        PlaneVerdict::ParallelBeside | PlaneVerdict::ParallelWithin => Some(Why::Parallel),
    }
}

pub(super) fn of_polygon(inside: bool) -> Option<Why> {
    (!inside).then_some(Why::Outside)
}

pub(super) fn of_bound(outcome: BoundOutcome) -> Option<Why> {
    match outcome {
        BoundOutcome::Hit => None,
        BoundOutcome::Missed => Some(Why::Missed),
        BoundOutcome::Behind => Some(Why::Behind),
        BoundOutcome::Beyond => Some(Why::BeyondNearest),
    }
}

pub(super) fn of_slab(outcome: SlabOutcome) -> Option<Why> {
    match outcome {
        SlabOutcome::GoesOn | SlabOutcome::ParallelInside => None,
        SlabOutcome::Null => Some(Why::Empty),
        SlabOutcome::ParallelOutside => Some(Why::Parallel),
    }
}

/// The verdict of a test that nothing else in its line says.
pub(super) fn verdict_fields<V: Visitor>(why: &mut Option<Why>, v: &mut V) {
    let mut found = verdict(*why);
    v.field("verdict", "what became of the test", &mut found);
    v.optional("why", "why the test was rejected; absent: it was not", why);
    if found != verdict(*why) {
        v.fail("a test has a \"why\" if it is rejected, and only then");
    }
}

/// The verdict of a test that follows from the rest of its line, for those who look for it alone.
pub(super) fn derived_verdict<V: Visitor>(why: Option<Why>, v: &mut V) {
    let mut found = why;
    verdict_fields(&mut found, v);
    if found != why {
        v.fail("\"verdict\" or \"why\" does not follow from the test");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Root;

    #[track_caller]
    fn check(fates: &[Fate], expected: Option<Why>) {
        let root = |fate| Root { t: 1.0, fate };
        let roots = match *fates {
            [] => Roots::None,
            [fate] => Roots::Graze(root(fate)),
            [near, far, ..] => Roots::Two {
                near: root(near),
                far: root(far),
            },
        };
        assert_eq!(why_no_hit(&roots, Why::NoRoot), expected, "{fates:?}");
    }

    #[test]
    fn the_nearer_root_in_front_of_the_origin_says_why_there_is_no_hit() {
        use Fate::{BackFace, Behind, BelowEpsilon, BeyondEnds, BeyondNearest, Chosen};
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
