//! Where a ray hits an object, for the objects that a question is about.

use crate::geometry::{Ray, TRange};
use crate::scene::{Primitive, Shape};

/// t of the hit with a primitive, by the test of its shape.
pub(super) fn object_hit(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let sides = primitive.sides;
    match &primitive.shape {
        Shape::Sphere(sphere) => sphere.test(ray, range, sides).roots.chosen(),
        Shape::Ellipsoid(ellipsoid) => ellipsoid.test(ray, range, sides).roots.chosen(),
        Shape::Box(solid) => solid.test(ray, range, sides).roots.chosen(),
        Shape::Cone(cone) => cone.test(ray, range, sides).roots.chosen(),
        Shape::Polygon(polygon) => {
            let t = polygon.plane_test(ray, range, sides).chosen()?;
            polygon.contains(ray, t).inside.then_some(t)
        }
    }
}
