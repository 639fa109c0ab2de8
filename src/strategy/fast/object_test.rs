//! One ray against one object: its hit, without the working.

use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::scene::{Primitive, PrimitiveId, Shape};
use crate::strategy::fast::sphere;
use crate::strategy::{Search, test_primitive};
use crate::trace::Off;

/// Where does the ray hit the primitive, if it does so in the range? As [`test_primitive`] says.
#[inline]
pub(super) fn hit(
    object: PrimitiveId,
    primitive: &Primitive,
    ray: &Ray,
    range: TRange,
) -> Option<f64> {
    match &primitive.shape {
        Shape::Sphere(of) => sphere::hit(of, ray, range, primitive.sides),
        _ => test_primitive(object, primitive, ray, range, &mut Off),
    }
}

/// Tests an object and takes its hit, if there is one.
#[inline]
pub(super) fn test(
    object: PrimitiveId,
    primitive: &Primitive,
    ray: &Ray,
    search: &mut impl Search,
) -> ControlFlow<()> {
    match hit(object, primitive, ray, search.range()) {
        Some(t) => search.offer(object, t, &mut Off),
        None => ControlFlow::Continue(()),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{cube_at, scene_of, sphere};
    use crate::strategy::NearestSoFar;

    #[test]
    fn the_hit_is_that_of_the_object_s_own_test_and_is_offered_if_it_is_in_the_range() {
        let scene = scene_of(&[sphere([5.0, 0.0, 0.0], 1.0), cube_at(3.0)]);
        let ray = Ray::new(DVec3::new(0.0, 0.0, 0.0), DVec3::X);
        let ids = [PrimitiveId(0), PrimitiveId(1)];
        let of = |range| ids.map(|id| hit(id, scene.primitive(id), &ray, range));
        assert_eq!(of(TRange::FORWARD), [Some(4.0), Some(3.0)]);
        assert_eq!(of(TRange::FORWARD.up_to(3.5)), [None, Some(3.0)]);
        let mut search = NearestSoFar::new(TRange::FORWARD);
        for id in ids {
            assert!(test(id, scene.primitive(id), &ray, &mut search).is_continue());
        }
        assert_eq!(
            search.hit().map(|hit| (hit.object, hit.t)),
            Some((ids[1], 3.0))
        );
    }
}
