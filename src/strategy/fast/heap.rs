//! A hierarchy in the order of distance, without its working.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::strategy::fast::Fast;
use crate::strategy::fast::leaf_order::LeafOrder;
use crate::strategy::fast::slabs::BothPlanes;
use crate::strategy::fast::stack::turn_of;
use crate::strategy::{HeapOrdered, Search};
use crate::structure::{Link, range};

impl<const N: usize> Fast for HeapOrdered<'_, N> {
    type Aids = LeafOrder;

    fn aids(&self) -> LeafOrder {
        LeafOrder::of_leaves(self.nodes.scene, self.nodes.hierarchy.order())
    }

    fn search_fast(
        &self,
        objects: &LeafOrder,
        ray: &Ray,
        search: &mut impl Search,
    ) -> ControlFlow<()> {
        let (scene, hierarchy) = (self.nodes.scene, &self.nodes.hierarchy);
        let slabs = BothPlanes::new(ray, hierarchy.set(), hierarchy.room(ray));
        let mut heap = BinaryHeap::new();
        let root = hierarchy.nodes().first();
        let root = root.and_then(|root| turn_of(0, &root.bound, &slabs, search.range()));
        heap.extend(root.map(Reverse));
        while let Some(Reverse(next)) = heap.pop() {
            if search.range().max < next.near {
                break;
            }
            match hierarchy.nodes()[next.node as usize].link {
                Link::Objects { first, count } => {
                    objects.test(scene, hierarchy.order(), range(first, count), ray, search)?;
                }
                Link::Children { first, count } => {
                    let children = &hierarchy.nodes()[range(first, count)];
                    for (child, of) in (first..).zip(children) {
                        let met = turn_of(child, &of.bound, &slabs, search.range());
                        if let Some(met) = met {
                            heap.push(Reverse(met));
                        }
                    }
                }
            }
        }
        ControlFlow::Continue(())
    }

    fn bytes_of(objects: &LeafOrder) -> usize {
        objects.bytes()
    }
}
