//! Hierarchies: a child is tested only if the ray hits its parent's bound.
//!
//! Slides, "Traverse the Hierarchies":
//! `HIER_traverse(ray r, node n) { if (r intersects bounding volume of n) if (n is a leaf) intersect r with
//! object of n; else for (each child c of n) HIER_traverse(r, c); }`
//!
//! This traversal does that, with a stack in place of the recursion, and avoids more: it goes down into the nearest
//! child first, and a node whose bound begins behind a hit that is known is left out.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::scene::Scene;
use crate::strategy::node_bounds::Nodes;
use crate::strategy::slab_rays::note_slab_rays;
use crate::strategy::{Search, Strategy};
use crate::structure::{Build, Hierarchy, Link, SlabSet, range};
use crate::trace::{NodeVerdict, Recorder};

/// Visits a hierarchy from the root down, the nearest child first.
#[doc(alias = "BVH traversal")]
#[doc(alias = "traversal")]
#[doc(alias = "HIER_traverse")]
#[derive(Clone, Debug)]
pub struct DepthFirst<'a, const N: usize> {
    pub(super) nodes: Nodes<'a, N>,
}

impl<'a, const N: usize> DepthFirst<'a, N> {
    /// Builds the hierarchy over a scene.
    pub fn new(scene: &'a Scene, set: &SlabSet<N>, build: Build) -> Self {
        Self {
            nodes: Nodes::new(scene, set, build),
        }
    }

    /// The hierarchy that is visited.
    pub fn hierarchy(&self) -> &Hierarchy<N> {
        &self.nodes.hierarchy
    }
}

impl<const N: usize> Strategy for DepthFirst<'_, N> {
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let Nodes { scene, hierarchy } = &self.nodes;
        let slabs = hierarchy.ray_slabs(ray);
        note_slab_rays(&slabs, hierarchy.set(), recorder);
        let root = self.nodes.root(&slabs, search.range(), recorder);
        let mut waiting = Vec::from_iter(root);
        while let Some(next) = waiting.pop() {
            // equal t does not prune: of two such hits the object first in the scene wins
            if search.range().max < next.turn.near {
                self.nodes.note(next, NodeVerdict::Pruned, recorder);
                continue;
            }
            self.nodes.note(next, NodeVerdict::Entered, recorder);
            match self.nodes.link(next.turn.node) {
                Link::Objects { first, count } => {
                    for &id in &hierarchy.order()[range(first, count)] {
                        search.test(id, scene.primitive(id), ray, recorder)?;
                    }
                }
                Link::Children { first, count } => {
                    let others = waiting.len();
                    for child in first..first + count {
                        let (depth, range) = (next.depth + 1, search.range());
                        let met = self.nodes.meets(child, depth, &slabs, range, recorder);
                        waiting.extend(met);
                        // the nearest child stays on top of the stack
                        if let [.., nearest, last] = &mut waiting[others..]
                            && met.is_some()
                            && nearest.turn.near <= last.turn.near
                        {
                            std::mem::swap(nearest, last);
                        }
                    }
                }
            }
        }
        ControlFlow::Continue(())
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        self.nodes.note_building(recorder);
    }

    fn bytes(&self) -> usize {
        self.nodes.hierarchy.bytes()
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::TRange;
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{cube_at, scene_of};
    use crate::strategy::noted::{noted, noted_in};
    use crate::trace::Event;

    /// Two pairs of cubes far apart in a row, of which each pair is a leaf.
    fn row() -> Scene {
        scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at))
    }

    /// The nodes as they are noted: number, depth, near, verdict.
    fn nodes(events: &[Event]) -> Vec<(u32, u32, Option<f64>, NodeVerdict)> {
        let visits = events.iter().filter_map(|event| match event {
            Event::Node(visit) => {
                // the room for rounding is below a millionth
                let near = visit.near.map(|near| (near * 1e6).round() / 1e6);
                Some((visit.node, visit.depth, near, visit.verdict))
            }
            _ => None,
        });
        visits.collect()
    }

    #[test]
    fn the_nearest_child_is_entered_first_and_what_begins_behind_its_hit_is_pruned() {
        use NodeVerdict::{Entered, Pruned};
        let scene = row();
        let strategy = DepthFirst::new(&scene, &SlabSet::AXES, Build::SurfaceArea);
        let (events, hit) = noted(&strategy, &Ray::new(DVec3::new(-1.0, 0.5, 0.5), DVec3::X));
        assert_eq!(
            hit.map(|hit| (hit.object, hit.t)),
            Some((PrimitiveId(0), 1.0))
        );
        let expected = [
            (0, 0, Some(1.0), Entered),
            (1, 1, Some(1.0), Entered),
            (2, 1, Some(9.0), Pruned),
        ];
        assert_eq!(nodes(&events), expected);
        // from the other end the second child is the nearer one
        let (events, hit) = noted(&strategy, &Ray::new(DVec3::new(11.0, 0.5, 0.5), -DVec3::X));
        assert_eq!(
            hit.map(|hit| (hit.object, hit.t)),
            Some((PrimitiveId(3), 1.0))
        );
        let expected = [
            (0, 0, Some(1.0), Entered),
            (2, 1, Some(1.0), Entered),
            (1, 1, Some(9.0), Pruned),
        ];
        assert_eq!(nodes(&events), expected);
    }

    #[test]
    fn a_bound_beside_the_ray_or_behind_it_is_rejected_and_one_beyond_the_range_pruned() {
        use NodeVerdict::{Entered, Pruned, Rejected};
        let scene = row();
        let strategy = DepthFirst::new(&scene, &SlabSet::AXES, Build::SurfaceArea);
        let at = |x: f64, y: f64| Ray::new(DVec3::new(x, y, 0.5), DVec3::X);
        let (events, _) = noted(&strategy, &at(-1.0, 1.5));
        assert_eq!(nodes(&events), [(0, 0, None, Rejected)]);
        // between the pairs: the first lies behind; the root's bound begins behind too, and counts from 0 on
        let (events, hit) = noted(&strategy, &at(5.0, 0.5));
        assert_eq!(hit.map(|hit| hit.t), Some(3.0));
        let expected = [
            (0, 0, Some(0.0), Entered),
            (1, 1, None, Rejected),
            (2, 1, Some(3.0), Entered),
        ];
        assert_eq!(nodes(&events), expected);
        let (events, hit) = noted_in(&strategy, &at(-1.0, 0.5), TRange::FORWARD.up_to(0.5));
        assert_eq!(
            (nodes(&events), hit),
            (vec![(0, 0, Some(1.0), Pruned)], None)
        );
    }

    #[test]
    fn the_building_joins_the_two_leaves_and_nodes_take_64_bytes() {
        let scene = row();
        let strategy = DepthFirst::new(&scene, &SlabSet::AXES, Build::SurfaceArea);
        let mut recording = crate::trace::Recording::new(Vec::new());
        strategy.note_building(&mut recording);
        let records = recording.into_sink();
        // one for each slab
        let of = |event: &Event| match event {
            Event::Merge(step) => (step.node, step.first, step.second, step.slab),
            other => panic!("{other:?}"),
        };
        let merges: Vec<_> = records.iter().map(|record| of(&record.event)).collect();
        assert_eq!(merges, [(0, 1, 2, 0), (0, 1, 2, 1), (0, 1, 2, 2)]);
        // three nodes, and four objects of 4 bytes
        assert_eq!(strategy.bytes(), 3 * 64 + 4 * 4);
    }

    #[test]
    fn a_scene_without_objects_has_no_node_to_enter() {
        let scene = scene_of(&[]);
        let strategy = DepthFirst::new(&scene, &SlabSet::AXES, Build::BottomUp);
        let (events, hit) = noted(&strategy, &Ray::new(DVec3::ZERO, DVec3::X));
        assert!(nodes(&events).is_empty() && hit.is_none());
    }
}
