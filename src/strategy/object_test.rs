//! One ray against one object: the test of its shape, and the line that records it.

use crate::geometry::{Ray, TRange};
use crate::scene::{Primitive, PrimitiveId, Shape};
use crate::trace::{Event, Recorder};

/// Where does the ray hit the primitive, if it does so in the range?
#[inline]
pub fn test_primitive<R: Recorder>(
    object: PrimitiveId,
    primitive: &Primitive,
    ray: &Ray,
    range: TRange,
    recorder: &mut R,
) -> Option<f64> {
    let sides = primitive.sides;
    match &primitive.shape {
        Shape::Sphere(sphere) => {
            let test = sphere.test(ray, range, sides);
            recorder.note(|| Event::SphereTest { object, test });
            test.roots.chosen()
        }
        Shape::Ellipsoid(ellipsoid) => {
            let test = ellipsoid.test(ray, range, sides);
            recorder.note(|| Event::EllipsoidTest { object, test });
            test.roots.chosen()
        }
        Shape::Box(solid) => {
            let test = solid.test(ray, range, sides);
            recorder.note(|| Event::BoxTest { object, test });
            test.roots.chosen()
        }
        Shape::Cone(cone) => {
            let test = cone.test(ray, range, sides);
            recorder.note(|| Event::ConeTest { object, test });
            test.roots.chosen()
        }
        Shape::Polygon(polygon) => {
            // first the plane …
            let plane = polygon.plane_test(ray, range, sides);
            recorder.note(|| Event::PlaneTest {
                object,
                test: plane,
            });
            let t = plane.chosen()?;
            // … then whether the point lies inside, its edges first
            let test = polygon.contains(ray, t);
            if R::ENABLED {
                for edge in polygon.edges(ray, test) {
                    recorder.note(|| Event::Edge { object, edge });
                }
            }
            recorder.note(|| Event::PolygonTest { object, test });
            test.inside.then_some(t)
        }
    }
}
