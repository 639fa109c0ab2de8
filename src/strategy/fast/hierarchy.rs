//! A hierarchy, the nearest child first: without a step on the stack for a node that is entered at once.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::strategy::fast::Fast;
use crate::strategy::fast::leaf_order::LeafOrder;
use crate::strategy::fast::slabs::BothPlanes;
use crate::strategy::fast::stack::{Stack, turn_of};
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
        let mut next = root.and_then(|root| turn_of(0, &root.bound, &slabs, search.range()));
        while let Some(node) = next {
            next = None;
            match hierarchy.nodes()[node.node as usize].link {
                Link::Objects { first, count } => {
                    objects.test(scene, hierarchy.order(), range(first, count), ray, search)?;
                }
                Link::Children { first, count } => {
                    let children = &hierarchy.nodes()[range(first, count)];
                    for (child, of) in (first..).zip(children) {
                        let met = turn_of(child, &of.bound, &slabs, search.range());
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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::TRange;
    use crate::scene::small_scene::{cube_at, polygon, scene_of};
    use crate::strategy::{HeapOrdered, NearestSoFar, Strategy};
    use crate::structure::{Build, SlabSet};
    use crate::trace::Off;

    #[test]
    fn a_node_that_waits_behind_the_nearest_child_is_entered_if_it_begins_before_the_hit() {
        // the bound of a slanted triangle begins at x = 1, and the ray hits the triangle at 10; the cube begins at 3
        let slanted = polygon(&[[1.0, -9.0, 0.0], [11.0, 1.0, 0.0], [11.0, 1.0, 4.0]]);
        for shapes in [[slanted.clone(), cube_at(3.0)], [cube_at(3.0), slanted]] {
            let scene = scene_of(&shapes);
            let ray = Ray::new(DVec3::new(0.0, 0.25, 0.1), DVec3::X);
            let depth_first = DepthFirst::new(&scene, &SlabSet::AXES, Build::BottomUp);
            let heap = HeapOrdered::new(&scene, &SlabSet::AXES, Build::BottomUp);
            let mut found = [NearestSoFar::new(TRange::FORWARD); 2];
            let _ = depth_first.search_fast(&depth_first.aids(), &ray, &mut found[0]);
            let _ = heap.search_fast(&heap.aids(), &ray, &mut found[1]);
            let followed = depth_first.nearest(&ray, TRange::FORWARD, &mut Off);
            for hit in [found[0].hit(), found[1].hit(), followed] {
                assert_eq!(hit.map(|hit| hit.t), Some(3.0));
            }
            // the triangle alone: y = x − 10 at x = 10.25
            let beyond = TRange {
                min: 4.5,
                ..TRange::FORWARD
            };
            let mut found = NearestSoFar::new(beyond);
            let _ = depth_first.search_fast(&depth_first.aids(), &ray, &mut found);
            assert!((found.hit().unwrap().t - 10.25).abs() <= 1e-14);
        }
    }
}
