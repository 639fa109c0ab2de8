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
use crate::trace::Off;

/// What only speed wants beside the grid.
#[derive(Clone, Debug)]
pub(in crate::strategy) struct Aids {
    /// The planes in the order in which rays meet them.
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
            aids.objects.visit(lists.objects(), listed, ray, |object| {
                let id = object.id();
                if !is_first(id) {
                    return ControlFlow::Continue(());
                }
                match object.test(self.scene, ray, search.range()) {
                    Some(t) => search.offer(id, t, &mut Off),
                    None => ControlFlow::Continue(()),
                }
            })?;
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
