//! Which strategy a verb uses where `--strategy` does not choose one.

use raystep::explain::grouped;
use raystep::{Scene, StrategyName};

use crate::cli::notes::note;

/// With at most this number of objects a pixel is traced against each of them: the record shows what the slides' simple ray tracer
/// does, and a picture of 100 × 100 such pixels keeps to the 10⁷ events that a log may have.
pub(crate) const FEW: usize = 1000;

/// What a verb uses where `--strategy` does not choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Usual {
    /// Every object, for what is measured against that.
    Exhaustive,
    /// The hierarchy, for a picture: it is the same picture, and it takes less time.
    Hierarchy,
    /// Every object while there are few, for the record of a trace; beyond, the hierarchy, with a note.
    BySize,
}

impl Usual {
    /// The strategy for a scene. A face of a mesh counts as an object.
    pub(crate) fn strategy(self, scene: &Scene) -> StrategyName {
        let objects = scene.primitives.len();
        match self {
            Self::Exhaustive => StrategyName::Exhaustive,
            Self::Hierarchy => StrategyName::Hierarchy,
            Self::BySize if objects <= FEW => StrategyName::Exhaustive,
            Self::BySize => {
                note(&format!(
                    "the scene has {} objects (each face of a mesh is one), so the strategy is hierarchy; \
                     --strategy exhaustive tests all of them",
                    grouped(objects as u64)
                ));
                StrategyName::Hierarchy
            }
        }
    }
}
