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
use crate::trace::{Event, NodeOutcome, QueueAction, QueueStep, Recorder};

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
        note_slab_rays(ray, hierarchy.set(), recorder);
        let mut heap: BinaryHeap<Reverse<Waiting>> = BinaryHeap::new();
        if let Some(root) = self.nodes.root(&slabs, search.range(), recorder) {
            heap.push(Reverse(root));
            note(QueueAction::Push, root, heap.len(), recorder);
        }
        while let Some(Reverse(next)) = heap.pop() {
            // equal t does not end it: of two such hits the object first in the scene wins
            if search.range().max < next.near {
                // all others begin further away still
                note(QueueAction::Stop, next, heap.len(), recorder);
                self.nodes.note(next, NodeOutcome::Pruned, recorder);
                break;
            }
            note(QueueAction::Pop, next, heap.len(), recorder);
            self.nodes.note(next, NodeOutcome::Entered, recorder);
            match self.nodes.link(next.node) {
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
            node: of.node,
            key: of.near,
            size: size as u32,
        })
    });
}
