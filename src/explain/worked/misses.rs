//! Many misses in a row, summed up by their reason.

use crate::explain::number::count;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::{Course, Step, Test, Told};
use crate::geometry::{PlaneVerdict, RootVerdict, Roots};
use crate::trace::{Kind, Purpose};

/// With this many tests on a ray its misses are summed up: more lines than a screen has would hide the hit.
pub(super) const FOLDED_FROM: usize = 24;

/// A run of misses longer than this is summed up, after its first.
pub(super) const LONGEST_UNFOLDED: usize = 3;

/// A run of misses: how many for which reason.
pub(super) fn folded(context: &Context, run: &[Told], course: &Course, page: &mut Pen) {
    let beyond = match course.start {
        Some(start) if start.purpose == Purpose::Shadow => "beyond the light",
        _ => "farther than the nearest hit so far",
    };
    let mut reasons: Vec<(&str, usize)> = Vec::new();
    let mut sum = 0;
    for told in run {
        let Step::Test { test, .. } = &told.step else {
            continue;
        };
        let Some(reason) = reason_of(context, test, beyond) else {
            continue;
        };
        sum += 1;
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, number)) => *number += 1,
            None => reasons.push((reason, 1)),
        }
    }
    if sum == 0 {
        return;
    }
    let list: Vec<_> = reasons
        .iter()
        .map(|(reason, number)| format!("{number} {reason}"))
        .collect();
    let text = format!(
        "… {} missed: {}",
        count(sum, "more object"),
        list.join(", ")
    );
    page.folded(sum, text);
}

/// Why the object was missed, if its kind is shown.
fn reason_of(context: &Context, test: &Test, beyond: &'static str) -> Option<&'static str> {
    let verdict = |verdict| match verdict {
        RootVerdict::BeyondNearest => beyond,
        RootVerdict::Chosen => "hit",
        RootVerdict::Behind => "behind the origin",
        RootVerdict::BelowEpsilon => "where the ray starts (t is 0 within ε)",
        RootVerdict::BackFace => "with only the back on the ray",
        RootVerdict::FrontFace => "with only the front on the ray",
        RootVerdict::BeyondEnds => "beyond the ends of the surface",
    };
    let roots = |roots: &Roots| match roots.iter().last() {
        None => "without a real root",
        Some(far) => verdict(far.verdict),
    };
    let (kind, reason) = match test {
        Test::Sphere(test) => (Kind::SphereTest, roots(&test.roots)),
        Test::Ellipsoid(test) => (Kind::EllipsoidTest, roots(&test.roots)),
        Test::Cone(test) => (Kind::ConeTest, roots(&test.roots)),
        Test::Box(test) => match test.roots {
            Roots::None => (Kind::BoxTest, "whose slabs have no t in common"),
            _ => (Kind::BoxTest, roots(&test.roots)),
        },
        Test::Polygon { plane, inside, .. } => match (plane, inside) {
            (_, Some(_)) => (Kind::PolygonTest, "with p outside the outline"),
            (Some(plane), None) => match plane.working.verdict {
                PlaneVerdict::Meets(root) => (Kind::PlaneTest, verdict(root.verdict)),
                PlaneVerdict::ParallelBeside => (Kind::PlaneTest, "parallel to the ray"),
                PlaneVerdict::ParallelWithin => (Kind::PlaneTest, "whose plane contains the ray"),
            },
            (None, None) => return None,
        },
    };
    context.shows(kind).then_some(reason)
}
