//! The stages of the argument that a ray hits a bound of slabs or not.

use crate::explain::Part;
use crate::figure::kinds::slabs::{SlabTests, bounded};
use crate::figure::parts::bound::Slab;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::stage::StageId;
use crate::figure::subject::Figure;
use crate::geometry::SlabInterval;
use crate::structure::SlabStep;

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) ray: StageId,
    /// One for each slab that was tested, but for the last of many.
    slabs: Vec<StageId>,
    pub(super) interval: StageId,
}

impl Argument {
    /// Up to this number of slabs each has a stage of its own: a figure has a dozen stages at most.
    const EACH: usize = 9;

    pub(super) fn new(
        figure: &Figure,
        sheet: &mut Sheet,
        found: &SlabTests,
        all: &[Slab],
        starts: Option<u32>,
    ) -> Self {
        let of = bounded(figure, found.of);
        let ray = sheet.stage(
            Part::Ray,
            starts,
            format!("The ray starts at the COP, and {of} lies in a bound of slabs."),
        );
        let mut slabs = Vec::new();
        let mut before = None;
        for (step, test) in found.tests.iter().take(Self::EACH) {
            let sentence = of_slab(&test.step, before);
            slabs.push(sheet.stage(Part::NearFar, *step, sentence));
            before = Some(&test.step);
        }
        let more = found.tests.len().saturating_sub(slabs.len());
        if let (true, Some((step, last))) = (0 < more, found.tests.last()) {
            let sentence = format!(
                "With {more} more slabs the largest near is {} and the smallest far {}.",
                quantity(last.step.max_near),
                quantity(last.step.min_far)
            );
            slabs.push(sheet.stage(Part::NearFar, *step, sentence));
        }
        let decided = found.decided.map(|(step, _)| step);
        let last = found.tests.last();
        let interval = sheet.stage(
            Part::Interval,
            decided.or(last.map(|(step, _)| *step)),
            last.map_or(String::new(), |(_, test)| {
                what_is_left(&test.step, all.len() - found.tests.len())
            }),
        );
        Self {
            ray,
            slabs,
            interval,
        }
    }

    /// The stage of a test, numbered from 0.
    pub(super) fn slab(&self, test: usize) -> StageId {
        let own = self.slabs.get(test).or(self.slabs.last());
        own.copied().unwrap_or(self.interval)
    }
}

/// What a slab says, and what it changes.
fn of_slab(step: &SlabStep, before: Option<&SlabStep>) -> String {
    let number = step.slab;
    let (near, far) = match step.interval {
        SlabInterval::Between { near, far } => (near, far),
        SlabInterval::ParallelInside => {
            return format!(
                "The ray is parallel to the planes of slab {number} and between them at every t."
            );
        }
        SlabInterval::ParallelOutside => {
            return format!(
                "The ray is parallel to the planes of slab {number} and never between them."
            );
        }
    };
    let own = format!(
        "The ray is between the planes of slab {number} from t = {} (near) to t = {} (far)",
        quantity(near),
        quantity(far)
    );
    let Some(before) = before else {
        return format!("{own}.");
    };
    let change = |was: f64, is: f64, moves: &str| {
        let verb = if was == is { "stays" } else { moves };
        format!("{verb} {}", quantity(is))
    };
    format!(
        "{own}: the largest near {}, the smallest far {}.",
        change(before.max_near, step.max_near, "rises to"),
        change(before.min_far, step.min_far, "falls to")
    )
}

/// What follows from the last slab that was looked at.
fn what_is_left(step: &SlabStep, untested: usize) -> String {
    let (near, far) = (quantity(step.max_near), quantity(step.min_far));
    let rest = match untested {
        0 => String::new(),
        1 => ", and the last slab is not tested".into(),
        _ => format!(", and the last {untested} slabs are not tested"),
    };
    match (step.inside(), step.interval) {
        (Some(_), _) => format!(
            "The ray is inside the bound from the largest near, {near}, to the smallest far, {far}."
        ),
        (None, SlabInterval::ParallelOutside) => {
            format!("No t is left: the ray misses the bound{rest}.")
        }
        (None, _) => format!(
            "The largest near, {near}, is above the smallest far, {far}: no t is left, the ray misses the bound{rest}."
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slab_raises_near_or_lowers_far() {
        let step = |number, near, far, [max_near, min_far]: [f64; 2]| SlabStep {
            slab: number,
            interval: SlabInterval::Between { near, far },
            max_near,
            min_far,
            ..SlabStep::default()
        };
        let first = step(0, 2.0, 9.0, [2.0, 9.0]);
        let second = step(1, 3.0, 12.0, [3.0, 9.0]);
        assert_eq!(
            of_slab(&first, None),
            "The ray is between the planes of slab 0 from t = 2 (near) to t = 9 (far)."
        );
        assert_eq!(
            of_slab(&second, Some(&first)),
            "The ray is between the planes of slab 1 from t = 3 (near) to t = 12 (far): the largest near rises to 3, the \
             smallest far stays 9."
        );
    }
}
