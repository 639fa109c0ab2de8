//! The strategy that was asked for by name, and the one line that chooses its driver.
//!
//! ```text
//!                    ┌─ somebody follows ─▶ the strategy: steps, each noted ─┐
//! ray ─▶ Chosen ─────┤                                                       ├─▶ the same hit
//!                    └─ nobody does ──────▶ fast: the same structure, aids ──┘
//! ```

use std::ops::ControlFlow;
use std::sync::OnceLock;

use crate::geometry::{MOST_SLABS, Ray};
use crate::scene::Scene;
use crate::strategy::fast::Fast;
use crate::strategy::{
    BoundedObjects, DepthFirst, Exhaustive, HeapOrdered, Search, Strategy, UniformGrid, ZAligned,
};
use crate::structure::{Grid, SlabChoice, SlabSet, StructureError, StructureOptions, VolumeKind};
use crate::trace::{Recorder, StrategyName};

/// One of the strategies, with its structure built and both its drivers. Which one is asked once for each ray.
#[derive(Clone, Debug)]
pub struct Chosen<'a>(Strategies<'a>);

/// A strategy, and what its fast driver needs.
#[derive(Clone, Debug)]
struct Driven<S: Fast> {
    strategy: S,
    /// Built when the first ray comes that nobody follows.
    aids: OnceLock<S::Aids>,
}

/// All of them. Slabs across the axes are three, those of Kay and Kajiya seven, the scene's own up to sixteen.
#[derive(Clone, Debug)]
enum Strategies<'a> {
    Exhaustive(Driven<Exhaustive<'a>>),
    Bounds3(Driven<BoundedObjects<'a, 3>>),
    Bounds7(Driven<BoundedObjects<'a, 7>>),
    BoundsOwn(Box<Driven<BoundedObjects<'a, MOST_SLABS>>>),
    Hierarchy3(Driven<DepthFirst<'a, 3>>),
    Hierarchy7(Driven<DepthFirst<'a, 7>>),
    HierarchyOwn(Box<Driven<DepthFirst<'a, MOST_SLABS>>>),
    Heap3(Driven<HeapOrdered<'a, 3>>),
    Heap7(Driven<HeapOrdered<'a, 7>>),
    HeapOwn(Box<Driven<HeapOrdered<'a, MOST_SLABS>>>),
    ZAligned(ZAligned<'a>),
    Grid(Box<Driven<UniformGrid<'a>>>),
}

impl<S: Fast> Driven<S> {
    fn new(strategy: S) -> Self {
        Self {
            strategy,
            aids: OnceLock::new(),
        }
    }
}

impl<S: Fast> Strategy for Driven<S> {
    #[inline]
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let Self { strategy, aids } = self;
        if R::ENABLED {
            strategy.search(ray, search, recorder)
        } else {
            strategy.search_fast(aids.get_or_init(|| strategy.aids()), ray, search)
        }
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        self.strategy.note_building(recorder);
    }

    fn bytes(&self) -> usize {
        self.strategy.bytes() + self.aids.get().map_or(0, S::bytes_of)
    }
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
        Ok(Self(match (name, slabs) {
            (StrategyName::Exhaustive, _) => {
                Strategies::Exhaustive(Driven::new(Exhaustive::new(scene)))
            }
            (StrategyName::Bounds, SlabChoice::Axes) => Strategies::Bounds3(Driven::new(
                BoundedObjects::new(scene, volume, &SlabSet::AXES),
            )),
            (StrategyName::Bounds, SlabChoice::Seven) => Strategies::Bounds7(Driven::new(
                BoundedObjects::new(scene, volume, &SlabSet::SEVEN),
            )),
            (StrategyName::Bounds, SlabChoice::Scene) => Strategies::BoundsOwn(Box::new(
                Driven::new(BoundedObjects::new(scene, volume, &own()?)),
            )),
            (StrategyName::Hierarchy, SlabChoice::Axes) => {
                Strategies::Hierarchy3(Driven::new(DepthFirst::new(scene, &SlabSet::AXES, build)))
            }
            (StrategyName::Hierarchy, SlabChoice::Seven) => {
                Strategies::Hierarchy7(Driven::new(DepthFirst::new(scene, &SlabSet::SEVEN, build)))
            }
            (StrategyName::Hierarchy, SlabChoice::Scene) => Strategies::HierarchyOwn(Box::new(
                Driven::new(DepthFirst::new(scene, &own()?, build)),
            )),
            (StrategyName::Heap, SlabChoice::Axes) => {
                Strategies::Heap3(Driven::new(HeapOrdered::new(scene, &SlabSet::AXES, build)))
            }
            (StrategyName::Heap, SlabChoice::Seven) => {
                Strategies::Heap7(Driven::new(HeapOrdered::new(scene, &SlabSet::SEVEN, build)))
            }
            (StrategyName::Heap, SlabChoice::Scene) => Strategies::HeapOwn(Box::new(Driven::new(
                HeapOrdered::new(scene, &own()?, build),
            ))),
            (StrategyName::ZAligned, _) => Strategies::ZAligned(ZAligned::new(scene)),
            (StrategyName::Grid, _) => {
                let grid = UniformGrid::new(scene, &options.grid).map_err(StructureError::Grid)?;
                Strategies::Grid(Box::new(Driven::new(grid)))
            }
        }))
    }
}

impl Chosen<'_> {
    /// The grid, if that is the strategy.
    pub fn grid(&self) -> Option<&Grid> {
        match &self.0 {
            Strategies::Grid(driven) => Some(driven.strategy.grid()),
            _ => None,
        }
    }
}

/// Does the same with whichever strategy it is.
macro_rules! whichever {
    ($chosen:expr, $strategy:ident => $work:expr) => {
        match &$chosen.0 {
            Strategies::Exhaustive($strategy) => $work,
            Strategies::Bounds3($strategy) => $work,
            Strategies::Bounds7($strategy) => $work,
            Strategies::BoundsOwn($strategy) => $work,
            Strategies::Hierarchy3($strategy) => $work,
            Strategies::Hierarchy7($strategy) => $work,
            Strategies::HierarchyOwn($strategy) => $work,
            Strategies::Heap3($strategy) => $work,
            Strategies::Heap7($strategy) => $work,
            Strategies::HeapOwn($strategy) => $work,
            Strategies::ZAligned($strategy) => $work,
            Strategies::Grid($strategy) => $work,
        }
    };
}

impl Strategy for Chosen<'_> {
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
