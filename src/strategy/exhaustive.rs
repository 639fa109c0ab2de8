//! Every object, in the order of the scene: the inner loop of Fig. 15.56.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::{Search, Strategy};
use crate::trace::Recorder;

/// Tests a ray against every object in the scene.
///
/// `for (each object in scene) { if (object is intersected and is closest considered thus far) record
/// intersection and object name; }` (Fig. 15.56)
#[derive(Clone, Copy, Debug)]
pub struct Exhaustive<'a> {
    pub(super) scene: &'a Scene,
}

impl<'a> Exhaustive<'a> {
    /// Over this scene; there is nothing to build.
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene }
    }
}

impl Strategy for Exhaustive<'_> {
    #[inline]
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        for (id, primitive) in (0..).map(PrimitiveId).zip(&self.scene.primitives) {
            search.test(id, primitive, ray, recorder)?;
        }
        ControlFlow::Continue(())
    }
}
