//! What both walks of a hierarchy have in common: the test of a node's bound, and what becomes of the node.

use std::cmp::Ordering;

use crate::geometry::TRange;
use crate::scene::Scene;
use crate::structure::{Build, Hierarchy, Link, RaySlabs, SlabSet, VolumeKind};
use crate::trace::{
    BoundOutcome, BoundTest, Bounded, Event, NodeOutcome, NodeVisit, Recorder, SlabTest,
};

/// A hierarchy over a scene.
#[derive(Clone, Debug)]
pub(super) struct Nodes<'a, const N: usize> {
    pub(super) scene: &'a Scene,
    pub(super) hierarchy: Hierarchy<N>,
}

/// A node whose bound the ray meets, and which waits to be entered.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Waiting {
    /// Where the ray enters its bound: the estimated distance.
    pub(super) near: f64,
    pub(super) node: u32,
    /// How deep it lies; the root at 0.
    pub(super) depth: u32,
}

impl<'a, const N: usize> Nodes<'a, N> {
    pub(super) fn new(scene: &'a Scene, set: &SlabSet<N>, build: Build) -> Self {
        Self {
            scene,
            hierarchy: Hierarchy::new(scene, set, build),
        }
    }

    /// What is below a node.
    pub(super) fn link(&self, node: u32) -> Link {
        self.hierarchy.nodes()[node as usize].link
    }

    /// The root, if there is one and the ray meets its bound.
    pub(super) fn root<R: Recorder>(
        &self,
        ray: &RaySlabs<N>,
        range: TRange,
        recorder: &mut R,
    ) -> Option<Waiting> {
        self.hierarchy.nodes().first()?;
        self.meets(0, 0, ray, range, recorder)
    }

    /// Does the ray meet a node's bound where a hit still counts? Slab by slab, until it misses one.
    pub(super) fn meets<R: Recorder>(
        &self,
        node: u32,
        depth: u32,
        ray: &RaySlabs<N>,
        range: TRange,
        recorder: &mut R,
    ) -> Option<Waiting> {
        let of = Bounded::Node(node);
        let bound = &self.hierarchy.nodes()[node as usize].bound;
        let mut inside = None;
        for step in bound.steps(ray, self.hierarchy.set()) {
            recorder.note(|| Event::SlabTest(SlabTest { of, step }));
            inside = step.inside();
        }
        let ends = inside.and_then(|inside| inside.ends());
        let outcome = BoundOutcome::of(ends, range);
        recorder.note(|| {
            Event::BoundTest(BoundTest {
                of,
                volume: VolumeKind::Slabs,
                inside: ends,
                room: ray.room(),
                outcome,
            })
        });
        let near = inside.map_or(range.min, |inside| inside.begins(range));
        let waiting = Waiting { near, node, depth };
        match outcome {
            BoundOutcome::Hit => return Some(waiting),
            BoundOutcome::Beyond => self.note(waiting, NodeOutcome::Pruned, recorder),
            BoundOutcome::Missed | BoundOutcome::Behind => {
                self.note(waiting, NodeOutcome::Rejected, recorder);
            }
        }
        None
    }

    /// Notes what became of a node.
    pub(super) fn note<R: Recorder>(&self, of: Waiting, outcome: NodeOutcome, recorder: &mut R) {
        recorder.note(|| {
            let (children, objects) = match self.link(of.node) {
                Link::Children { count, .. } => (count, 0),
                Link::Objects { count, .. } => (0, count),
            };
            Event::Node(NodeVisit {
                node: of.node,
                depth: of.depth,
                children,
                objects,
                near: (outcome != NodeOutcome::Rejected).then_some(of.near),
                outcome,
            })
        });
    }

    /// Notes how the bounds came about.
    pub(super) fn note_building<R: Recorder>(&self, recorder: &mut R) {
        if R::ENABLED {
            for merge in self.hierarchy.merges() {
                recorder.note(|| Event::Merge(merge));
            }
        }
    }
}

/// By the estimated distance; of equals by the number of the node, so that the order is always the same.
impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_distance = self.near.total_cmp(&other.near);
        by_distance.then(self.node.cmp(&other.node))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_node_comes_first_and_of_equals_the_one_with_the_lower_number() {
        let waiting = |near, node| Waiting {
            near,
            node,
            depth: 0,
        };
        assert_eq!(waiting(1.0, 9).cmp(&waiting(2.0, 3)), Ordering::Less);
        assert_eq!(waiting(2.0, 3).cmp(&waiting(2.0, 9)), Ordering::Less);
        assert!(waiting(2.0, 3) == waiting(2.0, 3));
        assert!(waiting(2.0, 3) != waiting(2.0, 4));
        assert!(waiting(3.0, 3) > waiting(2.0, 4));
    }
}
