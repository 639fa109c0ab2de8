//! A grid, walked without branches, with what is tested beside each other in the order of the lists.

mod axis_walk;
mod guess;
mod one_way;
mod walk;

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::scene::PrimitiveId;
use crate::strategy::fast::Fast;
use crate::strategy::fast::grid::one_way::Ways;
use crate::strategy::fast::grid::walk::Walk;
use crate::strategy::fast::leaf_order::LeafOrder;
use crate::strategy::fast::mailbox::Mailboxes;
use crate::strategy::grid::{is_passed, walked};
use crate::strategy::{Search, UniformGrid};

/// What only speed wants beside the grid.
#[derive(Clone, Debug)]
pub(in crate::strategy) struct Aids {
    /// The planes in the order in which rays hit them.
    ways: Ways,
    /// The objects in the order of the lists.
    objects: LeafOrder,
}

impl UniformGrid<'_> {
    /// Walks the cells; `is_first` says whether an object is to be tested.
    #[inline]
    fn walk_fast(
        &self,
        aids: &Aids,
        ray: &Ray,
        search: &mut impl Search,
        mut is_first: impl FnMut(PrimitiveId) -> bool,
    ) -> ControlFlow<()> {
        let range = search.range();
        let lists = self.grid.lists();
        let mut walk = Walk::new(&aids.ways, self.grid.cells(), ray, walked(range));
        while let Some((number, t_out)) = walk.step() {
            let listed = lists.range(number);
            let order = lists.objects();
            (aids.objects).test_some(self.scene, order, listed, ray, search, &mut is_first)?;
            let nearest = search.range().max;
            if nearest < range.max && is_passed(nearest, t_out) {
                break;
            }
        }
        ControlFlow::Continue(())
    }
}

impl Fast for UniformGrid<'_> {
    type Aids = Aids;

    fn aids(&self) -> Aids {
        Aids {
            ways: Ways::new(self.grid.cells()),
            objects: LeafOrder::of_cells(self.scene, self.grid.lists().objects()),
        }
    }

    #[inline]
    fn search_fast(&self, aids: &Aids, ray: &Ray, search: &mut impl Search) -> ControlFlow<()> {
        if self.mailboxes {
            let mut mailboxes = Mailboxes::for_ray(self.scene.primitives.len());
            let is_first = |object: PrimitiveId| mailboxes.is_first(object.0 as usize);
            self.walk_fast(aids, ray, search, is_first)
        } else {
            self.walk_fast(aids, ray, search, |_| true)
        }
    }

    fn bytes_of(aids: &Aids) -> usize {
        aids.ways.bytes() + aids.objects.bytes()
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::TRange;
    use crate::scene::small_scene::{polygon, scene_of, solid};
    use crate::strategy::Strategy;
    use crate::structure::GridOptions;

    #[test]
    fn a_nearer_object_in_a_cell_before_the_hit_is_found() {
        // a wall slanted through four cells in a row, hit in the third; a box in the second that the ray hits sooner (Fig. 15.62)
        let wall = [
            [0.5, 0.1, 0.1],
            [3.5, 1.9, 0.1],
            [3.5, 1.9, 1.9],
            [0.5, 0.1, 1.9],
        ];
        let scene = scene_of(&[
            polygon(&wall),
            solid([1.25, 1.1, 0.5], [1.5, 1.5, 1.5]),
            solid([0.0, 1.8, 0.0], [0.25, 2.0, 2.0]),
            solid([3.75, 0.0, 0.0], [4.0, 2.0, 2.0]),
        ]);
        let ray = Ray::new(DVec3::new(-1.0, 1.2, 1.0), DVec3::X);
        for mailboxes in [false, true] {
            let options = GridOptions {
                resolution: Some([4, 1, 1]),
                mailboxes,
                ..GridOptions::default()
            };
            let grid = UniformGrid::new(&scene, &options).unwrap();
            let mut found = crate::strategy::NearestSoFar::new(TRange::FORWARD);
            let _ = grid.search_fast(&grid.aids(), &ray, &mut found);
            let hit = found.hit().map(|hit| (hit.object.0, hit.t));
            assert_eq!(hit, Some((1, 2.25)));
            let followed = crate::strategy::noted::noted(&grid, &ray).1;
            assert_eq!(followed.map(|hit| (hit.object.0, hit.t)), hit);
            assert_eq!(grid.bytes(), grid.grid().bytes());
        }
    }
}
