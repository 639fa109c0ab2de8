//! Hierarchies: a child is looked at only if the ray meets its parent's bound.
//!
//! Slides, "Traverse the Hierarchies":
//! `HIER_traverse(ray r, node n) { if (r intersects bounding volume of n) if (n is a leaf) intersect r with
//! object of n; else for (each child c of n) HIER_traverse(r, c); }`
//!
//! Both walks below do that and avoid more: a node whose bound begins behind a hit that is known is left
//! out. [`DepthFirst`] goes down into the nearest child first; [`HeapOrdered`] keeps all nodes that wait in
//! a heap and always takes the nearest of them (Kay and Kajiya 1986).

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::scene::Scene;
use crate::strategy::leaf_order::LeafOrder;
use crate::strategy::slab_rays::note_slab_rays;
use crate::strategy::waiting::{Stack, Waiting};
use crate::strategy::{Search, Strategy};
use crate::structure::{
    Build, Hierarchy, Inside, Link, NO_SLAB, Node, RaySlabs, SlabSet, VolumeKind, crossed, range,
};
use crate::trace::{
    BoundOutcome, BoundTest, Bounded, Event, NodeOutcome, NodeVisit, QueueAction, QueueStep,
    Recorder, SlabTest,
};

/// Walks a hierarchy from the root down, the nearest child first.
#[derive(Clone, Debug)]
pub struct DepthFirst<'a, const N: usize> {
    nodes: Nodes<'a, N>,
}

/// Walks a hierarchy in the order of the estimated distance.
#[derive(Clone, Debug)]
pub struct HeapOrdered<'a, const N: usize> {
    nodes: Nodes<'a, N>,
}

/// A hierarchy and the objects at its leaves.
#[derive(Clone, Debug)]
struct Nodes<'a, const N: usize> {
    hierarchy: Hierarchy<N>,
    /// The objects in the order of the leaves.
    objects: LeafOrder<'a>,
}

impl<'a, const N: usize> DepthFirst<'a, N> {
    /// Builds the hierarchy over a scene.
    pub fn new(scene: &'a Scene, set: &SlabSet<N>, build: Build) -> Self {
        Self {
            nodes: Nodes::new(scene, set, build),
        }
    }

    /// The hierarchy that is walked.
    pub fn hierarchy(&self) -> &Hierarchy<N> {
        &self.nodes.hierarchy
    }
}

impl<'a, const N: usize> HeapOrdered<'a, N> {
    /// Builds the hierarchy over a scene.
    pub fn new(scene: &'a Scene, set: &SlabSet<N>, build: Build) -> Self {
        Self {
            nodes: Nodes::new(scene, set, build),
        }
    }
}

impl<const N: usize> Strategy for DepthFirst<'_, N> {
    #[inline]
    fn search<R: Recorder>(&self, ray: &Ray, search: &mut impl Search, recorder: &mut R) {
        let nodes = &self.nodes;
        let slabs = nodes.hierarchy.ray_slabs(ray);
        note_slab_rays(ray, nodes.hierarchy.set(), recorder);
        let mut waiting = Stack::new();
        let mut next = nodes.root(ray, &slabs, search, recorder);
        while let Some(node) = next {
            nodes.note(node, NodeOutcome::Entered, recorder);
            next = None;
            match nodes.hierarchy.nodes()[node.node as usize].link {
                Link::Objects { first, count } => {
                    let tested = nodes.test_objects(first, count, ray, search, recorder);
                    if tested.is_break() {
                        return;
                    }
                }
                Link::Children { first, count } => {
                    let children = &nodes.hierarchy.nodes()[range(first, count)];
                    for child in (first..).zip(children) {
                        let depth = node.depth + 1;
                        let met = nodes.meets(child, depth, ray, &slabs, search, recorder);
                        // the nearest child is next, the others wait
                        if let Some(met) = met {
                            match next {
                                None => next = Some(met),
                                Some(nearer) if nearer.near <= met.near => waiting.push(met),
                                Some(further) => {
                                    waiting.push(further);
                                    next = Some(met);
                                }
                            }
                        }
                    }
                }
            }
            while next.is_none()
                && let Some(last) = waiting.pop()
            {
                // equal t does not prune: of two such hits the object first in the scene wins
                if last.near <= search.range().max {
                    next = Some(last);
                } else {
                    nodes.note(last, NodeOutcome::Pruned, recorder);
                }
            }
        }
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        self.nodes.note_building(recorder);
    }

    fn bytes(&self) -> usize {
        self.nodes.hierarchy.bytes() + self.nodes.objects.bytes()
    }
}

impl<const N: usize> Strategy for HeapOrdered<'_, N> {
    fn search<R: Recorder>(&self, ray: &Ray, search: &mut impl Search, recorder: &mut R) {
        let nodes = &self.nodes;
        let slabs = nodes.hierarchy.ray_slabs(ray);
        note_slab_rays(ray, nodes.hierarchy.set(), recorder);
        let mut heap: BinaryHeap<Reverse<Waiting>> = BinaryHeap::new();
        let note = |action, of: Waiting, size: usize, recorder: &mut R| {
            recorder.note(|| {
                Event::Queue(QueueStep {
                    action,
                    node: of.node,
                    key: of.near,
                    size: size as u32,
                })
            });
        };
        if let Some(root) = nodes.root(ray, &slabs, search, recorder) {
            heap.push(Reverse(root));
            note(QueueAction::Push, root, heap.len(), recorder);
        }
        while let Some(Reverse(next)) = heap.pop() {
            if search.range().max < next.near {
                // all others begin further away still
                note(QueueAction::Stop, next, heap.len(), recorder);
                nodes.note(next, NodeOutcome::Pruned, recorder);
                return;
            }
            note(QueueAction::Pop, next, heap.len(), recorder);
            nodes.note(next, NodeOutcome::Entered, recorder);
            match nodes.hierarchy.nodes()[next.node as usize].link {
                Link::Objects { first, count } => {
                    let tested = nodes.test_objects(first, count, ray, search, recorder);
                    if tested.is_break() {
                        return;
                    }
                }
                Link::Children { first, count } => {
                    let children = &nodes.hierarchy.nodes()[range(first, count)];
                    for child in (first..).zip(children) {
                        let depth = next.depth + 1;
                        let met = nodes.meets(child, depth, ray, &slabs, search, recorder);
                        if let Some(met) = met {
                            heap.push(Reverse(met));
                            note(QueueAction::Push, met, heap.len(), recorder);
                        }
                    }
                }
            }
        }
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        self.nodes.note_building(recorder);
    }

    fn bytes(&self) -> usize {
        self.nodes.hierarchy.bytes() + self.nodes.objects.bytes()
    }
}

impl<'a, const N: usize> Nodes<'a, N> {
    fn new(scene: &'a Scene, set: &SlabSet<N>, build: Build) -> Self {
        let hierarchy = Hierarchy::new(scene, set, build);
        Self {
            objects: LeafOrder::of_leaves(scene, hierarchy.order()),
            hierarchy,
        }
    }

    /// The root, if there is one and the ray meets its bound.
    #[inline]
    fn root<R: Recorder>(
        &self,
        ray: &Ray,
        slabs: &RaySlabs<N>,
        search: &impl Search,
        recorder: &mut R,
    ) -> Option<Waiting> {
        let root = self.hierarchy.nodes().first()?;
        self.meets((0, root), 0, ray, slabs, search, recorder)
    }

    /// Does the ray meet a node's bound where a hit still counts?
    #[inline]
    fn meets<R: Recorder>(
        &self,
        (node, of): (u32, &Node<N>),
        depth: u32,
        ray: &Ray,
        slabs: &RaySlabs<N>,
        search: &impl Search,
        recorder: &mut R,
    ) -> Option<Waiting> {
        let bound = &of.bound;
        let of = Bounded::Node(node);
        let mut so_far = NO_SLAB;
        let inside = bound.inside(slabs, |slab, near, far| {
            // a set with fewer directions than it has room for is filled up with slabs that hold everything
            if R::ENABLED && slab < self.hierarchy.set().directions().len() {
                let step = bound.step(slab, ray, self.hierarchy.set(), so_far, crossed(near, far));
                so_far = [step.max_near, step.min_far];
                recorder.note(|| Event::SlabTest(SlabTest { of, step }));
            }
            R::ENABLED
        });
        let range = search.range();
        let waiting = Waiting {
            near: inside.begins(range),
            node,
            depth,
        };
        if R::ENABLED {
            self.note_bound(waiting, inside, so_far, range, recorder);
        }
        inside.meets(range).then_some(waiting)
    }

    fn note_bound<R: Recorder>(
        &self,
        of: Waiting,
        inside: Inside,
        so_far: [f64; 2],
        range: TRange,
        recorder: &mut R,
    ) {
        let outcome = BoundOutcome::of(inside.ends(), range);
        // decided with room for rounding, told as the slabs were
        let inside = inside.ends().map(|_| so_far);
        recorder.note(|| {
            Event::BoundTest(BoundTest {
                of: Bounded::Node(of.node),
                volume: VolumeKind::Slabs,
                inside,
                outcome,
            })
        });
        match outcome {
            BoundOutcome::Hit => {}
            BoundOutcome::Beyond => self.note(of, NodeOutcome::Pruned, recorder),
            BoundOutcome::Missed | BoundOutcome::Behind => {
                self.note(of, NodeOutcome::Rejected, recorder);
            }
        }
    }

    /// Tests the objects of a leaf.
    #[inline]
    fn test_objects<R: Recorder>(
        &self,
        first: u32,
        count: u32,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let order = self.hierarchy.order();
        let places = range(first, count);
        self.objects.test(order, places, ray, search, recorder)
    }

    #[inline]
    fn note<R: Recorder>(&self, of: Waiting, outcome: NodeOutcome, recorder: &mut R) {
        recorder.note(|| {
            let (children, objects) = match self.hierarchy.nodes()[of.node as usize].link {
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

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
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
