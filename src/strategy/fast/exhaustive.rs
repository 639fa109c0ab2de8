//! Every object, each with the shortest way to its hit.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::scene::PrimitiveId;
use crate::strategy::fast::Fast;
use crate::strategy::fast::object_test::test;
use crate::strategy::{Exhaustive, Search};

impl Fast for Exhaustive<'_> {
    type Aids = ();

    fn aids(&self) {}

    #[inline]
    fn search_fast(&self, (): &(), ray: &Ray, search: &mut impl Search) -> ControlFlow<()> {
        for (id, primitive) in (0..).map(PrimitiveId).zip(&self.scene.primitives) {
            test(id, primitive, ray, search)?;
        }
        ControlFlow::Continue(())
    }
}
