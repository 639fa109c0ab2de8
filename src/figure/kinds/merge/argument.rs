//! The stages of the argument that two bounds make one.

use crate::explain::Part;
use crate::figure::kinds::merge::joined::Joined;
use crate::figure::kinds::slabs::Shown;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::look::Dash;
use crate::figure::sheet::stage::StageId;
use crate::figure::view::Projection;
use crate::structure::MergeStep;

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) bounds: StageId,
    /// Each slab that is seen from its edge, with its stage.
    pub(super) slabs: Vec<Shown>,
    pub(super) both: StageId,
}

impl Argument {
    /// Up to this number of slabs each has a stage of its own: a figure has a dozen stages at most.
    const EACH: usize = 9;

    pub(super) fn new(sheet: &mut Sheet, joined: &Joined, projection: &Projection) -> Self {
        let [first, second] = &joined.names;
        let bounds = sheet.stage(
            "two bounds",
            None,
            format!("{first} and {second} have a bound each, with the same directions."),
        );
        let pairs = joined.steps.iter().zip(&joined.bounds[2]);
        let pairs = pairs.filter(|(_, slab)| slab.is_on_edge(projection));
        let pairs: Vec<_> = pairs.collect();
        let mut stage = bounds;
        let mut slabs = Vec::new();
        for (place, ((step, merge), slab)) in pairs.iter().enumerate() {
            if place < Self::EACH {
                stage = sheet.stage("slab", *step, of_slab(merge));
            } else if let (Self::EACH, Some(((last, _), _))) = (place, pairs.last()) {
                let more = pairs.len() - place;
                let sentence = format!("The {more} other directions are joined in the same way.");
                stage = sheet.stage("slab", *last, sentence);
            }
            slabs.push(Shown::new(**slab, stage, *step, Dash::Solid));
        }
        let both = sheet.stage(
            Part::Bound,
            joined.steps.last().map(|(step, _)| *step),
            format!("What the joined slabs have in common is the bound of {first} and {second}."),
        );
        Self {
            bounds,
            slabs,
            both,
        }
    }
}

fn of_slab(merge: &MergeStep) -> String {
    let (d_min, d_max) = merge.joined();
    let [a, b] = merge.d_min.map(quantity);
    let [c, d] = merge.d_max.map(quantity);
    format!(
        "Slab {} takes the minimum of D_min, {a} and {b}, which is {}, and the maximum of D_max, {c} and {d}, which is {}.",
        merge.slab,
        quantity(d_min),
        quantity(d_max)
    )
}
