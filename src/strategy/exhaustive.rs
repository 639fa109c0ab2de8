//! Every object, in the order of the scene: the inner loop of Fig. 15.56.

use crate::geometry::{Ray, TRange};
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::{Hit, NearestSoFar, Strategy, test_primitive};
use crate::trace::Recorder;

/// Tests a ray against every object in the scene.
///
/// `for (each object in scene) { if (object is intersected and is closest considered thus far) record
/// intersection and object name; }` (Fig. 15.56)
#[derive(Clone, Copy, Debug)]
pub struct Exhaustive<'a> {
    scene: &'a Scene,
}

impl<'a> Exhaustive<'a> {
    /// Over this scene; there is nothing to build.
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene }
    }
}

impl Strategy for Exhaustive<'_> {
    #[inline]
    fn nearest<R: Recorder>(&self, ray: &Ray, range: TRange, recorder: &mut R) -> Option<Hit> {
        let mut nearest = NearestSoFar::new(range);
        for (id, primitive) in (0..).map(PrimitiveId).zip(&self.scene.primitives) {
            if let Some(t) = test_primitive(id, primitive, ray, nearest.range(), recorder) {
                nearest.offer(id, t, recorder);
            }
        }
        nearest.hit()
    }

    #[inline]
    fn any<R: Recorder>(&self, ray: &Ray, range: TRange, recorder: &mut R) -> Option<Hit> {
        (0..)
            .map(PrimitiveId)
            .zip(&self.scene.primitives)
            .find_map(|(object, primitive)| {
                let t = test_primitive(object, primitive, ray, range, recorder)?;
                Some(Hit { object, t })
            })
    }
}
