//! The strategies by name: which one a scene is searched with, over which slabs.

use std::ops::ControlFlow;

use crate::geometry::{MOST_SLABS, Ray};
use crate::scene::Scene;
use crate::strategy::by_slabs::{BySlabs, by_slabs};
use crate::strategy::chosen::Driven;
use crate::strategy::{
    BoundedObjects, DepthFirst, Exhaustive, HeapOrdered, Search, Strategy, UniformGrid, ZAligned,
};
use crate::structure::{Grid, SlabChoice, SlabSet, StructureError, StructureOptions, VolumeKind};
use crate::trace::{Recorder, StrategyName};

/// One of the strategies.
#[derive(Clone, Debug)]
pub(super) enum ByName<'a> {
    Exhaustive(Driven<Exhaustive<'a>>),
    Bounds(
        BySlabs<
            Driven<BoundedObjects<'a, 3>>,
            Driven<BoundedObjects<'a, 7>>,
            Driven<BoundedObjects<'a, MOST_SLABS>>,
        >,
    ),
    Hierarchy(
        BySlabs<
            Driven<DepthFirst<'a, 3>>,
            Driven<DepthFirst<'a, 7>>,
            Driven<DepthFirst<'a, MOST_SLABS>>,
        >,
    ),
    Heap(
        BySlabs<
            Driven<HeapOrdered<'a, 3>>,
            Driven<HeapOrdered<'a, 7>>,
            Driven<HeapOrdered<'a, MOST_SLABS>>,
        >,
    ),
    ZAligned(ZAligned<'a>),
    Grid(Box<Driven<UniformGrid<'a>>>),
}

impl<'a> ByName<'a> {
    /// Builds what the strategy needs.
    ///
    /// # Errors
    /// Options that do not fit the scene.
    pub(super) fn new(
        scene: &'a Scene,
        name: StrategyName,
        options: &StructureOptions,
    ) -> Result<Self, StructureError> {
        let StructureOptions {
            build,
            volume,
            slabs,
            ref grid,
        } = *options;
        // other volumes have no slabs to choose
        let of_objects = match volume {
            VolumeKind::Sphere | VolumeKind::Ellipsoid | VolumeKind::Box => SlabChoice::Axes,
            VolumeKind::Slabs => slabs,
        };
        Ok(match name {
            StrategyName::Exhaustive => Self::Exhaustive(Driven::new(Exhaustive::new(scene))),
            StrategyName::Bounds => Self::Bounds(by_slabs!(scene, of_objects, set =>
                Driven::new(BoundedObjects::new(scene, volume, set)))),
            StrategyName::Hierarchy => Self::Hierarchy(by_slabs!(scene, slabs, set =>
                Driven::new(DepthFirst::new(scene, set, build)))),
            StrategyName::Heap => Self::Heap(by_slabs!(scene, slabs, set =>
                Driven::new(HeapOrdered::new(scene, set, build)))),
            StrategyName::ZAligned => Self::ZAligned(ZAligned::new(scene)),
            StrategyName::Grid => {
                let grid = UniformGrid::new(scene, grid).map_err(StructureError::Grid)?;
                Self::Grid(Box::new(Driven::new(grid)))
            }
        })
    }

    /// The grid, if that is the strategy.
    pub(super) fn grid(&self) -> Option<&Grid> {
        match self {
            Self::Grid(driven) => Some(driven.strategy.grid()),
            _ => None,
        }
    }
}

/// Does the same with whichever strategy it is.
macro_rules! whichever {
    ($by_name:expr, $strategy:ident => $work:expr) => {
        match $by_name {
            ByName::Exhaustive($strategy) => $work,
            ByName::Bounds($strategy) => $work,
            ByName::Hierarchy($strategy) => $work,
            ByName::Heap($strategy) => $work,
            ByName::ZAligned($strategy) => $work,
            ByName::Grid($strategy) => $work,
        }
    };
}

impl Strategy for ByName<'_> {
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        whichever!(self, strategy => strategy.search(ray, search, recorder))
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        whichever!(self, strategy => strategy.note_building(recorder));
    }

    fn bytes(&self) -> usize {
        whichever!(self, strategy => strategy.bytes())
    }
}
