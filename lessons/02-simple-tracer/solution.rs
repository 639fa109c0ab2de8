//! Lesson 2: the simple ray tracer, Fig. 15.56.
//!
//! - nearest hit: the closest object that the ray hits, and its name
//!
//! The crate tests an object for you: `hit(primitive, ray, range)` is t of the hit, or None.

use raystep::Scene;
use raystep::geometry::{Ray, TRange};
use raystep::lesson::exercise::supplied::hit;
use raystep::scene::PrimitiveId;
use raystep::strategy::Hit;

/// The nearest object that the ray hits in the range; of two hits at equal t the object that comes first in the scene.
///
/// `scene.primitives` are the objects. An object is named by its number: `PrimitiveId(0)` is the first one. A hit is
/// `Hit { object: PrimitiveId(number), t }`, and can be copied.
pub fn nearest(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
    // BEGIN SOLUTION
    let mut closest: Option<Hit> = None;
    for (number, primitive) in (0..).zip(&scene.primitives) {
        if let Some(t) = hit(primitive, ray, range)
            && closest.is_none_or(|closest| t < closest.t)
        {
            let object = PrimitiveId(number);
            closest = Some(Hit { object, t });
        }
    }
    closest
    // END SOLUTION
}
