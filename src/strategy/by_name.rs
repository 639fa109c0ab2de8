//! The strategy that was asked for by name, over the slabs that were asked for.

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

/// One of the strategies, with its structure built and both its drivers. Which one is asked once for each ray.
#[derive(Clone, Debug)]
pub struct Chosen<'a>(Strategies<'a>);

/// All of them.
#[derive(Clone, Debug)]
enum Strategies<'a> {
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
        Ok(Self(match name {
            StrategyName::Exhaustive => Strategies::Exhaustive(Driven::new(Exhaustive::new(scene))),
            StrategyName::Bounds => Strategies::Bounds(by_slabs!(scene, of_objects, set =>
                Driven::new(BoundedObjects::new(scene, volume, set)))),
            StrategyName::Hierarchy => Strategies::Hierarchy(by_slabs!(scene, slabs, set =>
                Driven::new(DepthFirst::new(scene, set, build)))),
            StrategyName::Heap => Strategies::Heap(by_slabs!(scene, slabs, set =>
                Driven::new(HeapOrdered::new(scene, set, build)))),
            StrategyName::ZAligned => Strategies::ZAligned(ZAligned::new(scene)),
            StrategyName::Grid => {
                let grid = UniformGrid::new(scene, grid).map_err(StructureError::Grid)?;
                Strategies::Grid(Box::new(Driven::new(grid)))
            }
        }))
    }

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
            Strategies::Bounds($strategy) => $work,
            Strategies::Hierarchy($strategy) => $work,
            Strategies::Heap($strategy) => $work,
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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::TRange;
    use crate::scene::small_scene::{cube_at, polygon, scene_of, sphere};
    use crate::strategy::Hit;
    use crate::strategy::noted::noted_in;
    use crate::structure::Build;
    use crate::trace::Off;

    /// Along x through (0, ¼, ¼): a cube from 3 to 4, a sphere around 7, triangles at 10 and 12, a cube from 14 to 15 and the
    /// same once more.
    fn scene() -> Scene {
        let across = |x: f64| polygon(&[[x, -1.0, -1.0], [x, 2.0, -1.0], [x, -1.0, 2.0]]);
        let mut scene = scene_of(&[
            cube_at(14.0),
            across(12.0),
            sphere([7.0, 0.25, 0.25], 1.0),
            across(10.0),
            cube_at(3.0),
            cube_at(14.0),
        ]);
        let half = 0.5;
        scene.slabs = Some(vec![
            DVec3::X,
            DVec3::Y,
            DVec3::new(half, half, 0.0),
            DVec3::Z,
        ]);
        scene
    }

    /// All strategies, with every choice that makes another driver of them.
    fn all(scene: &Scene) -> Vec<(String, Chosen<'_>)> {
        use SlabChoice::{Axes, Scene as Own, Seven};
        use StrategyName::{Bounds, Exhaustive, Grid, Heap, Hierarchy, ZAligned};
        let mut all = Vec::new();
        for name in [Exhaustive, Bounds, Hierarchy, Heap, Grid, ZAligned] {
            for slabs in [Axes, Seven, Own] {
                for volume in [VolumeKind::Box, VolumeKind::Slabs, VolumeKind::Sphere] {
                    for build in [Build::BottomUp, Build::Insertion, Build::SurfaceArea] {
                        let mut options = StructureOptions {
                            volume,
                            slabs,
                            build,
                            ..StructureOptions::default()
                        };
                        options.grid.mailboxes = build == Build::BottomUp;
                        let told = format!("{name:?} {options:?}");
                        all.push((told, Chosen::new(scene, name, &options).unwrap()));
                    }
                }
            }
        }
        all
    }

    #[test]
    fn every_strategy_finds_the_hits_worked_out_by_hand_with_either_driver() {
        let scene = scene();
        let rays = [
            (0.0, 1.0, 0.0, f64::INFINITY, Some((4, 3.0))),
            // from inside the first cube its other side at 4, then beyond it the sphere
            (3.5, 1.0, 0.0, f64::INFINITY, Some((4, 0.5))),
            (0.0, 1.0, 4.5, f64::INFINITY, Some((2, 6.0))),
            (0.0, 1.0, 4.5, 5.5, None),
            (0.0, 1.0, 8.5, f64::INFINITY, Some((3, 10.0))),
            (0.0, 1.0, 10.5, f64::INFINITY, Some((1, 12.0))),
            // of two equal hits the first object's
            (0.0, 1.0, 12.5, f64::INFINITY, Some((0, 14.0))),
            (20.0, -1.0, 0.0, f64::INFINITY, Some((0, 5.0))),
            (20.0, -1.0, 6.5, 9.0, Some((1, 8.0))),
            (20.0, -1.0, 6.5, 7.5, None),
            (20.0, 1.0, 0.0, f64::INFINITY, None),
        ];
        for (told, strategy) in all(&scene) {
            for (x, direction, min, max, expected) in rays {
                let ray = Ray::new(DVec3::new(x, 0.25, 0.25), direction * DVec3::X);
                let range = TRange { min, max };
                let followed = noted_in(&strategy, &ray, range).1;
                let alone = strategy.nearest(&ray, range, &mut Off);
                for found in [followed, alone] {
                    let is_it = |(hit, (object, t)): (Hit, (u32, f64))| {
                        hit.object.0 == object && (hit.t - t).abs() <= 1e-9 * t
                    };
                    let same = found.is_some() == expected.is_some();
                    assert!(
                        same && found.zip(expected).is_none_or(is_it),
                        "{told}: {found:?} {ray:?}"
                    );
                }
                // any hit is one in the range
                let any = strategy.any(&ray, range, &mut Off);
                assert_eq!(any.is_some(), expected.is_some(), "{told} {ray:?}");
                assert!(any.is_none_or(|hit| range.min < hit.t && hit.t < range.max));
            }
        }
    }

    #[test]
    fn the_fast_driver_s_copies_count_once_they_are_made() {
        let scene = scene_of(&[sphere([5.0, 0.0, 0.0], 1.0), sphere([9.0, 0.0, 0.0], 1.0)]);
        let options = StructureOptions {
            build: Build::SurfaceArea,
            ..StructureOptions::default()
        };
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let bytes = |name| {
            let chosen = Chosen::new(&scene, name, &options).unwrap();
            let before = chosen.bytes();
            let _ = noted_in(&chosen, &ray, TRange::FORWARD);
            assert_eq!(chosen.bytes(), before);
            let _ = chosen.nearest(&ray, TRange::FORWARD, &mut Off);
            (before, chosen.bytes() - before)
        };
        // one leaf of 64 bytes and two objects of 4; then two copies of 40
        assert_eq!(bytes(StrategyName::Hierarchy), (72, 80));
        assert_eq!(bytes(StrategyName::Heap), (72, 80));
        assert_eq!(bytes(StrategyName::Exhaustive), (0, 0));
        assert_eq!(bytes(StrategyName::ZAligned), (0, 0));
        // beside the copies of the lists' entries the planes, both ways, and two more each
        let chosen = Chosen::new(&scene, StrategyName::Grid, &options).unwrap();
        let grid = chosen.grid().unwrap();
        let planes: u32 = grid.resolution().iter().map(|cells| 2 * (cells + 2)).sum();
        let copies = 40 * grid.lists_total() + 8 * planes as usize;
        assert_eq!(bytes(StrategyName::Grid), (grid.bytes(), copies));
    }

    #[test]
    fn the_grid_is_at_hand_of_a_grid_alone_and_a_set_of_slabs_must_be_in_the_scene() {
        let scene = scene_of(&[cube_at(3.0)]);
        let chosen = |name, slabs| {
            let options = StructureOptions {
                slabs,
                ..StructureOptions::default()
            };
            Chosen::new(&scene, name, &options)
        };
        assert!(
            chosen(StrategyName::Grid, SlabChoice::Axes)
                .unwrap()
                .grid()
                .is_some()
        );
        assert!(
            chosen(StrategyName::Heap, SlabChoice::Axes)
                .unwrap()
                .grid()
                .is_none()
        );
        let refused = chosen(StrategyName::Hierarchy, SlabChoice::Scene);
        assert_eq!(refused.err(), Some(StructureError::NoSlabs));
        // a box has no slabs to choose
        assert!(chosen(StrategyName::Bounds, SlabChoice::Scene).is_ok());
    }

    #[test]
    fn the_building_of_a_hierarchy_is_noted_and_an_exhaustive_search_has_none() {
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let noted = |name| {
            let options = StructureOptions {
                build: Build::SurfaceArea,
                ..StructureOptions::default()
            };
            let mut recording = crate::trace::Recording::new(Vec::new());
            let chosen = Chosen::new(&scene, name, &options).unwrap();
            chosen.note_building(&mut recording);
            recording.into_sink().len()
        };
        // two leaves joined, in three slabs
        assert_eq!(noted(StrategyName::Hierarchy), 3);
        assert_eq!(noted(StrategyName::Heap), 3);
        assert_eq!(noted(StrategyName::Exhaustive), 0);
    }
}
