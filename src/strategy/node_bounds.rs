//! What both walks of a hierarchy have in common: the test of a node's bound, and what becomes of the node.

use crate::geometry::TRange;
use crate::scene::Scene;
use crate::strategy::turn::Turn;
use crate::structure::{Build, Hierarchy, Link, RaySlabs, SlabSet, VolumeKind};
use crate::trace::{
    BoundTest, BoundVerdict, Bounded, Event, NodeVerdict, NodeVisit, Recorder, SlabTest,
};

/// A hierarchy over a scene.
#[derive(Clone, Debug)]
pub(super) struct Nodes<'a, const N: usize> {
    pub(super) scene: &'a Scene,
    pub(super) hierarchy: Hierarchy<N>,
}

/// A node whose bound the ray hits, and which waits to be entered: by its turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Waiting {
    pub(super) turn: Turn,
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

    /// The root, if there is one and the ray hits its bound.
    pub(super) fn root<R: Recorder>(
        &self,
        ray: &RaySlabs<N>,
        range: TRange,
        recorder: &mut R,
    ) -> Option<Waiting> {
        self.hierarchy.nodes().first()?;
        self.meets(0, 0, ray, range, recorder)
    }

    /// Does the ray hit a node's bound where a hit still counts? Slab by slab, until it misses one.
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
        let verdict = BoundVerdict::of(ends, range);
        recorder.note(|| {
            Event::BoundTest(BoundTest {
                of,
                volume: VolumeKind::Slabs,
                inside: ends,
                room: ray.room(),
                verdict,
            })
        });
        let near = inside.map_or(range.min, |inside| inside.begins(range));
        let turn = Turn { near, node };
        let waiting = Waiting { turn, depth };
        match verdict {
            BoundVerdict::Hit => return Some(waiting),
            BoundVerdict::Beyond => self.note(waiting, NodeVerdict::Pruned, recorder),
            BoundVerdict::Missed | BoundVerdict::Behind => {
                self.note(waiting, NodeVerdict::Rejected, recorder);
            }
        }
        None
    }

    /// Notes what became of a node.
    pub(super) fn note<R: Recorder>(&self, of: Waiting, verdict: NodeVerdict, recorder: &mut R) {
        recorder.note(|| {
            let (children, objects) = match self.link(of.turn.node) {
                Link::Children { count, .. } => (count, 0),
                Link::Objects { count, .. } => (0, count),
            };
            Event::Node(NodeVisit {
                node: of.turn.node,
                depth: of.depth,
                children,
                objects,
                near: (verdict != NodeVerdict::Rejected).then_some(of.turn.near),
                verdict,
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
