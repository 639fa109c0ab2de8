//! A hierarchy, the nearest child first: without a step on the stack for a node that is entered at once.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::strategy::fast::Fast;
use crate::strategy::fast::leaf_order::LeafOrder;
use crate::strategy::fast::slabs::BothPlanes;
use crate::strategy::fast::stack::{Stack, Waiting};
use crate::strategy::{DepthFirst, Search};
use crate::structure::{Link, range};

impl<const N: usize> Fast for DepthFirst<'_, N> {
    type Aids = LeafOrder;

    fn aids(&self) -> LeafOrder {
        LeafOrder::of_leaves(self.nodes.scene, self.nodes.hierarchy.order())
    }

    #[inline]
    fn search_fast(
        &self,
        objects: &LeafOrder,
        ray: &Ray,
        search: &mut impl Search,
    ) -> ControlFlow<()> {
        let (scene, hierarchy) = (self.nodes.scene, &self.nodes.hierarchy);
        let slabs = BothPlanes::new(ray, hierarchy.set(), hierarchy.room(ray));
        let mut waiting = Stack::new();
        let root = hierarchy.nodes().first();
        let mut next = root.and_then(|root| Waiting::met(0, &root.bound, &slabs, search.range()));
        while let Some(node) = next {
            next = None;
            match hierarchy.nodes()[node.node as usize].link {
                Link::Objects { first, count } => {
                    objects.test(scene, hierarchy.order(), range(first, count), ray, search)?;
                }
                Link::Children { first, count } => {
                    let children = &hierarchy.nodes()[range(first, count)];
                    for (child, of) in (first..).zip(children) {
                        let met = Waiting::met(child, &of.bound, &slabs, search.range());
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
                }
            }
        }
        ControlFlow::Continue(())
    }

    fn bytes_of(objects: &LeafOrder) -> usize {
        objects.bytes()
    }
}
