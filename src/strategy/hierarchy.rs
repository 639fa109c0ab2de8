//! Hierarchies: a child is looked at only if the ray meets its parent's bound.
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
use crate::trace::{NodeOutcome, Recorder};

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
        note_slab_rays(ray, hierarchy.set(), recorder);
        let root = self.nodes.root(&slabs, search.range(), recorder);
        let mut waiting = Vec::from_iter(root);
        while let Some(next) = waiting.pop() {
            // equal t does not prune: of two such hits the object first in the scene wins
            if search.range().max < next.near {
                self.nodes.note(next, NodeOutcome::Pruned, recorder);
                continue;
            }
            self.nodes.note(next, NodeOutcome::Entered, recorder);
            match self.nodes.link(next.node) {
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
                            && nearest.near <= last.near
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
