//! A strategy over bounds of slabs, for each number of them.
//!
//! How many slabs a bound has is known when the program is built, so that a search asks for it nowhere: three across the
//! axes, the seven of Kay and Kajiya, or the scene's own, of which there are sixteen at most.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::strategy::{Search, Strategy};
use crate::trace::Recorder;

/// A strategy `S` over three slabs, seven, or the scene's own.
#[derive(Clone, Debug)]
pub(super) enum BySlabs<S3, S7, SOwn> {
    Axes(S3),
    Seven(S7),
    /// Rare, and several times as large.
    Own(Box<SOwn>),
}

/// Builds a strategy over the set of slabs that was chosen. The scene's own can be missing.
macro_rules! by_slabs {
    ($scene:expr, $slabs:expr, $set:ident => $strategy:expr) => {
        match $slabs {
            SlabChoice::Axes => {
                let $set = &SlabSet::AXES;
                BySlabs::Axes($strategy)
            }
            SlabChoice::Seven => {
                let $set = &SlabSet::SEVEN;
                BySlabs::Seven($strategy)
            }
            SlabChoice::Scene => {
                let own = $scene.slabs.as_ref().ok_or(StructureError::NoSlabs)?;
                let $set = &SlabSet::of(own).map_err(StructureError::Slabs)?;
                BySlabs::Own(Box::new($strategy))
            }
        }
    };
}

pub(super) use by_slabs;

impl<S3: Strategy, S7: Strategy, SOwn: Strategy> Strategy for BySlabs<S3, S7, SOwn> {
    #[inline]
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        match self {
            Self::Axes(strategy) => strategy.search(ray, search, recorder),
            Self::Seven(strategy) => strategy.search(ray, search, recorder),
            Self::Own(strategy) => strategy.search(ray, search, recorder),
        }
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        match self {
            Self::Axes(strategy) => strategy.note_building(recorder),
            Self::Seven(strategy) => strategy.note_building(recorder),
            Self::Own(strategy) => strategy.note_building(recorder),
        }
    }

    fn bytes(&self) -> usize {
        match self {
            Self::Axes(strategy) => strategy.bytes(),
            Self::Seven(strategy) => strategy.bytes(),
            Self::Own(strategy) => strategy.bytes(),
        }
    }
}
