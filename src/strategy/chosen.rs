//! The strategy that was asked for by name: the one place that knows them all.

use crate::geometry::{MOST_SLABS, Ray};
use crate::scene::Scene;
use crate::strategy::{
    BoundedObjects, DepthFirst, Exhaustive, HeapOrdered, Search, Strategy, UniformGrid, ZAligned,
};
use crate::structure::{Grid, SlabChoice, SlabSet, StructureError, StructureOptions, VolumeKind};
use crate::trace::{Recorder, StrategyName};

/// One of the strategies, with its structure built. Which one is asked once for each ray.
#[derive(Clone, Debug)]
pub enum Chosen<'a> {
    /// Every object.
    Exhaustive(Exhaustive<'a>),
    /// A volume around each object; slabs across the axes.
    Bounds3(BoundedObjects<'a, 3>),
    /// The same, with the seven slabs of Kay and Kajiya.
    Bounds7(BoundedObjects<'a, 7>),
    /// The same, with the scene's own slabs.
    BoundsOwn(Box<BoundedObjects<'a, MOST_SLABS>>),
    /// A hierarchy of boxes.
    Hierarchy3(DepthFirst<'a, 3>),
    /// A hierarchy with the seven slabs of Kay and Kajiya.
    Hierarchy7(DepthFirst<'a, 7>),
    /// A hierarchy with the scene's own slabs.
    HierarchyOwn(Box<DepthFirst<'a, MOST_SLABS>>),
    /// The same, walked by a heap.
    Heap3(HeapOrdered<'a, 3>),
    /// The same, walked by a heap.
    Heap7(HeapOrdered<'a, 7>),
    /// The same, walked by a heap.
    HeapOwn(Box<HeapOrdered<'a, MOST_SLABS>>),
    /// Every object, in the frame of the ray.
    ZAligned(ZAligned<'a>),
    /// A uniform grid.
    Grid(Box<UniformGrid<'a>>),
}

impl<'a> Chosen<'a> {
    /// Builds what the strategy needs.
    ///
    /// # Errors
    /// Options that do not fit the scene.
    pub fn new(
        scene: &'a Scene,
        name: StrategyName,
        options: &StructureOptions,
    ) -> Result<Self, StructureError> {
        let StructureOptions { build, volume, .. } = *options;
        let own = || {
            SlabSet::of(scene.slabs.as_ref().ok_or(StructureError::NoSlabs)?)
                .map_err(StructureError::Slabs)
        };
        // other volumes have no slabs to choose
        let slabs = match (name, volume) {
            (
                StrategyName::Bounds,
                VolumeKind::Sphere | VolumeKind::Ellipsoid | VolumeKind::Box,
            ) => SlabChoice::Axes,
            _ => options.slabs,
        };
        Ok(match (name, slabs) {
            (StrategyName::Exhaustive, _) => Self::Exhaustive(Exhaustive::new(scene)),
            (StrategyName::Bounds, SlabChoice::Axes) => {
                Self::Bounds3(BoundedObjects::new(scene, volume, &SlabSet::AXES))
            }
            (StrategyName::Bounds, SlabChoice::Seven) => {
                Self::Bounds7(BoundedObjects::new(scene, volume, &SlabSet::SEVEN))
            }
            (StrategyName::Bounds, SlabChoice::Scene) => {
                Self::BoundsOwn(Box::new(BoundedObjects::new(scene, volume, &own()?)))
            }
            (StrategyName::Hierarchy, SlabChoice::Axes) => {
                Self::Hierarchy3(DepthFirst::new(scene, &SlabSet::AXES, build))
            }
            (StrategyName::Hierarchy, SlabChoice::Seven) => {
                Self::Hierarchy7(DepthFirst::new(scene, &SlabSet::SEVEN, build))
            }
            (StrategyName::Hierarchy, SlabChoice::Scene) => {
                Self::HierarchyOwn(Box::new(DepthFirst::new(scene, &own()?, build)))
            }
            (StrategyName::Heap, SlabChoice::Axes) => {
                Self::Heap3(HeapOrdered::new(scene, &SlabSet::AXES, build))
            }
            (StrategyName::Heap, SlabChoice::Seven) => {
                Self::Heap7(HeapOrdered::new(scene, &SlabSet::SEVEN, build))
            }
            (StrategyName::Heap, SlabChoice::Scene) => {
                Self::HeapOwn(Box::new(HeapOrdered::new(scene, &own()?, build)))
            }
            (StrategyName::ZAligned, _) => Self::ZAligned(ZAligned::new(scene)),
            (StrategyName::Grid, _) => {
                let grid = UniformGrid::new(scene, &options.grid).map_err(StructureError::Grid)?;
                Self::Grid(Box::new(grid))
            }
        })
    }
}

impl Chosen<'_> {
    /// The grid, if that is the strategy.
    pub fn grid(&self) -> Option<&Grid> {
        match self {
            Self::Grid(strategy) => Some(strategy.grid()),
            _ => None,
        }
    }
}

/// Does the same with whichever strategy it is.
macro_rules! whichever {
    ($chosen:expr, $strategy:ident => $work:expr) => {
        match $chosen {
            Chosen::Exhaustive($strategy) => $work,
            Chosen::Bounds3($strategy) => $work,
            Chosen::Bounds7($strategy) => $work,
            Chosen::BoundsOwn($strategy) => $work,
            Chosen::Hierarchy3($strategy) => $work,
            Chosen::Hierarchy7($strategy) => $work,
            Chosen::HierarchyOwn($strategy) => $work,
            Chosen::Heap3($strategy) => $work,
            Chosen::Heap7($strategy) => $work,
            Chosen::HeapOwn($strategy) => $work,
            Chosen::ZAligned($strategy) => $work,
            Chosen::Grid($strategy) => $work,
        }
    };
}

impl Strategy for Chosen<'_> {
    fn search<R: Recorder>(&self, ray: &Ray, search: &mut impl Search, recorder: &mut R) {
        whichever!(self, strategy => strategy.search(ray, search, recorder));
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        whichever!(self, strategy => strategy.note_building(recorder));
    }

    fn bytes(&self) -> usize {
        whichever!(self, strategy => strategy.bytes())
    }
}
