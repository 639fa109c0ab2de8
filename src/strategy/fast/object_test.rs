//! One ray against one object: its hit, without the working.

use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::scene::{Primitive, PrimitiveId, Shape};
use crate::strategy::fast::sphere;
use crate::strategy::{Search, test_primitive};
use crate::trace::Off;

/// Where does the ray meet the primitive, if it does so in the range? As [`test_primitive`] says.
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
