//! The stages of the argument that slabs bound an object.

use crate::explain::Part;
use crate::figure::kinds::slabs::found::{SlabTests, bounded};
use crate::figure::parts::bound::Slab;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::subject::Figure;

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) object: StageId,
    /// Each slab that was tested, with its stage.
    pub(super) slabs: Vec<Shown>,
    pub(super) bound: StageId,
}

/// A slab, and since when it is there.
#[derive(Clone, Copy, Debug)]
pub(in crate::figure::kinds) struct Shown {
    pub(in crate::figure::kinds) slab: Slab,
    stage: StageId,
    step: u32,
    /// The pattern of its pair of planes.
    dash: Dash,
}

impl Shown {
    pub(in crate::figure::kinds) fn new(slab: Slab, stage: StageId, step: u32, dash: Dash) -> Self {
        Self {
            slab,
            stage,
            step,
            dash,
        }
    }

    /// Draws what belongs to the slab.
    pub(in crate::figure::kinds) fn draw(&self, sheet: &mut Sheet, draw: impl FnOnce(&mut Sheet)) {
        sheet.at(self.stage, |sheet| sheet.step(self.step, draw));
    }

    pub(super) fn look(&self) -> Look {
        Look {
            dash: self.dash,
            ..Look::VISITED.outline().wide(1.25)
        }
    }
}

/// The planes of a pair have one pattern.
const PATTERNS: [Dash; 6] = [
    Dash::Solid,
    Dash::Dashed,
    Dash::Alternating,
    Dash::Dotted,
    Dash::TwoDots,
    Dash::Long,
];

impl Argument {
    /// Up to this number of slabs each has a stage of its own: a figure has a dozen stages at most.
    const EACH: usize = 9;

    pub(super) fn new(figure: &Figure, sheet: &mut Sheet, found: &SlabTests) -> Self {
        let name = bounded(figure, found.of);
        let object = sheet.stage("object", None, format!("A bound around {name} is sought."));
        let of_trace: Vec<(u32, Slab)> = found.slabs().collect();
        let mut stage = object;
        let mut slabs = Vec::new();
        for (place, (step, slab)) in of_trace.iter().enumerate() {
            if place < Self::EACH {
                let sentence = of_slab(&name, slab);
                stage = sheet.stage("slab", *step, sentence);
            } else if let (Self::EACH, Some((last, _))) = (place, of_trace.last()) {
                let more = of_trace.len() - place;
                let sentence = format!("In the same way {more} more directions have a slab each.");
                stage = sheet.stage("slab", *last, sentence);
            }
            let dash = PATTERNS[place % PATTERNS.len()];
            slabs.push(Shown::new(*slab, stage, *step, dash));
        }
        let last = of_trace.last().map(|(step, _)| *step);
        let decided = found.decided.map(|(step, _)| step);
        let bound = sheet.stage(
            Part::Bound,
            decided.or(last),
            format!("What all slabs have in common is the bound of {name}."),
        );
        Self {
            object,
            slabs,
            bound,
        }
    }
}

fn of_slab(name: &str, slab: &Slab) -> String {
    format!(
        "Along the normal {} of slab {} two parallel planes touch {name}, at −D_max = {} and at −D_min = {}.",
        coordinates(slab.normal),
        slab.number,
        quantity(-slab.d_max),
        quantity(-slab.d_min)
    )
}
