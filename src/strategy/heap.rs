//! Hierarchies in the order of distance: all nodes that wait are in a heap, and the nearest is entered next (Kay and
//! Kajiya 1986).
//!
//! So no node is entered whose bound begins behind the nearest hit: the search ends with the first such node. What a
//! heap costs beside a stack is seen in its steps.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::scene::Scene;
use crate::strategy::node_bounds::{Nodes, Waiting};
use crate::strategy::slab_rays::note_slab_rays;
use crate::strategy::{Search, Strategy};
use crate::structure::{Build, Link, SlabSet, range};
use crate::trace::{Event, NodeVerdict, QueueAction, QueueStep, Recorder};

/// Visits a hierarchy in the order of the estimated distance.
#[doc(alias = "BVH traversal")]
#[doc(alias = "priority queue")]
#[derive(Clone, Debug)]
pub struct HeapOrdered<'a, const N: usize> {
    pub(super) nodes: Nodes<'a, N>,
}

impl<'a, const N: usize> HeapOrdered<'a, N> {
    /// Builds the hierarchy over a scene.
    pub fn new(scene: &'a Scene, set: &SlabSet<N>, build: Build) -> Self {
        Self {
            nodes: Nodes::new(scene, set, build),
        }
    }
}

impl<const N: usize> Strategy for HeapOrdered<'_, N> {
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let Nodes { scene, hierarchy } = &self.nodes;
        let slabs = hierarchy.ray_slabs(ray);
        note_slab_rays(&slabs, hierarchy.set(), recorder);
        let mut heap: BinaryHeap<Reverse<Waiting>> = BinaryHeap::new();
        if let Some(root) = self.nodes.root(&slabs, search.range(), recorder) {
            heap.push(Reverse(root));
            note(QueueAction::Push, root, heap.len(), recorder);
        }
        while let Some(Reverse(next)) = heap.pop() {
            // equal t does not end it: of two such hits the object first in the scene wins
            if search.range().max < next.turn.near {
                // all others begin further away still
                note(QueueAction::Stop, next, heap.len(), recorder);
                self.nodes.note(next, NodeVerdict::Pruned, recorder);
                break;
            }
            note(QueueAction::Pop, next, heap.len(), recorder);
            self.nodes.note(next, NodeVerdict::Entered, recorder);
            match self.nodes.link(next.turn.node) {
                Link::Objects { first, count } => {
                    for &id in &hierarchy.order()[range(first, count)] {
                        search.test(id, scene.primitive(id), ray, recorder)?;
                    }
                }
                Link::Children { first, count } => {
                    for child in first..first + count {
                        let (depth, range) = (next.depth + 1, search.range());
                        let met = self.nodes.meets(child, depth, &slabs, range, recorder);
                        if let Some(met) = met {
                            heap.push(Reverse(met));
                            note(QueueAction::Push, met, heap.len(), recorder);
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

/// Notes that a node went into the heap or came out of it; then `size` nodes wait.
fn note<R: Recorder>(action: QueueAction, of: Waiting, size: usize, recorder: &mut R) {
    recorder.note(|| {
        Event::Queue(QueueStep {
            action,
            node: of.turn.node,
            key: of.turn.near,
            size: size as u32,
        })
    });
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{cube_at, scene_of};
    use crate::strategy::noted::noted;

    #[test]
    fn the_nearest_node_leaves_the_heap_first_and_one_behind_the_hit_ends_the_search() {
        use QueueAction::{Pop, Push, Stop};
        // two pairs of cubes far apart, of which each pair is a leaf
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let strategy = HeapOrdered::new(&scene, &SlabSet::AXES, Build::SurfaceArea);
        let steps = |origin: f64, direction: f64| {
            let ray = Ray::new(DVec3::new(origin, 0.5, 0.5), direction * DVec3::X);
            let (events, hit) = noted(&strategy, &ray);
            let steps = events.into_iter().filter_map(|event| match event {
                // the room for rounding is below a millionth
                Event::Queue(step) => Some((step.action, step.node, step.key.round(), step.size)),
                _ => None,
            });
            (
                steps.collect::<Vec<_>>(),
                hit.map(|hit| (hit.object.0, hit.t)),
            )
        };
        let (from_left, hit) = steps(-1.0, 1.0);
        assert_eq!(hit, Some((0, 1.0)));
        let expected = [
            (Push, 0, 1.0, 1),
            (Pop, 0, 1.0, 0),
            (Push, 1, 1.0, 1),
            (Push, 2, 9.0, 2),
            (Pop, 1, 1.0, 1),
            (Stop, 2, 9.0, 0),
        ];
        assert_eq!(from_left, expected);
        let (from_right, hit) = steps(11.0, -1.0);
        assert_eq!(hit, Some((3, 1.0)));
        let expected = [
            (Push, 0, 1.0, 1),
            (Pop, 0, 1.0, 0),
            (Push, 1, 9.0, 1),
            (Push, 2, 1.0, 2),
            (Pop, 2, 1.0, 1),
            (Stop, 1, 9.0, 0),
        ];
        assert_eq!(from_right, expected);
    }

    #[test]
    fn the_objects_of_both_leaves_are_found_and_the_depth_grows_by_one() {
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let strategy = HeapOrdered::new(&scene, &SlabSet::AXES, Build::SurfaceArea);
        // between the pairs
        let (events, hit) = noted(&strategy, &Ray::new(DVec3::new(5.0, 0.5, 0.5), DVec3::X));
        assert_eq!(
            hit.map(|hit| (hit.object, hit.t)),
            Some((PrimitiveId(2), 3.0))
        );
        let depths: Vec<_> = events
            .iter()
            .filter_map(|event| match event {
                Event::Node(visit) => Some((visit.node, visit.depth)),
                _ => None,
            })
            .collect();
        assert_eq!(depths, [(0, 0), (1, 1), (2, 1)]);
        assert_eq!(strategy.bytes(), 3 * 64 + 4 * 4);
        let mut recording = crate::trace::Recording::new(Vec::new());
        strategy.note_building(&mut recording);
        assert_eq!(recording.into_sink().len(), 3);
    }
}
