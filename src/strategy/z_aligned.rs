//! Every object, in the frame in which the ray is the z axis; the nearest hit comes out of a z sort.
//!
//! Slides, "Optimizing Intersection Calculations": "any intersection occurs at x = y = 0. This simplifies the
//! intersection calculation and allows the closest object to be determined by a z sort". Each test is
//! simpler, but every object has to be transformed for every ray, and none is left out.

use std::ops::ControlFlow;

use crate::geometry::{AlignedRay, Ray, TRange};
use crate::scene::{Primitive, PrimitiveId, Scene, Shape};
use crate::strategy::transformed::note_transformed;
use crate::strategy::{Hit, Search, Strategy};
use crate::trace::{Event, Recorder, ZSort};

/// Transforms every object into the frame of the ray, tests it there, and sorts the hits by z.
///
/// Finds what the exhaustive search finds, at a t within 10⁻⁹ of it: the transformed points are rounded
/// once more. Boxes and polygons have the same t bit for bit.
///
/// A ray whose end is the first hit, whichever that is (a shadow ray), needs no sort and has none.
#[derive(Clone, Copy, Debug)]
pub struct ZAligned<'a> {
    scene: &'a Scene,
}

impl<'a> ZAligned<'a> {
    /// Over this scene; there is nothing to build.
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene }
    }
}

impl Strategy for ZAligned<'_> {
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let ray = AlignedRay::new(ray);
        recorder.note(|| Event::Align(ray.frame));
        let mut hits = Vec::new();
        for (object, primitive) in (0..).map(PrimitiveId).zip(&self.scene.primitives) {
            let Some(t) = test_aligned(object, primitive, &ray, search.range(), recorder) else {
                continue;
            };
            if search.ends_at_first() {
                search.offer(object, t, recorder)?;
            } else {
                hits.push(Hit { object, t });
            }
        }
        // a stable sort: hits at equal z stay in the order of the scene
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        for (place, hit) in (0..).zip(&hits) {
            let (object, z) = (hit.object, hit.t * ray.length);
            recorder.note(|| Event::ZSort(ZSort { place, object, z }));
        }
        match hits.first() {
            // all others are behind it
            Some(nearest) => search.offer(nearest.object, nearest.t, recorder),
            None => ControlFlow::Continue(()),
        }
    }
}

/// Where does the z axis meet the transformed primitive, if it does so in the range?
#[inline]
fn test_aligned<R: Recorder>(
    object: PrimitiveId,
    primitive: &Primitive,
    ray: &AlignedRay,
    range: TRange,
    recorder: &mut R,
) -> Option<f64> {
    if R::ENABLED {
        note_transformed(object, &primitive.shape, &ray.frame, recorder);
    }
    let sides = primitive.sides;
    match &primitive.shape {
        Shape::Sphere(sphere) => {
            let test = sphere.test_aligned(ray, range, sides);
            recorder.note(|| Event::SphereTest { object, test });
            test.roots.chosen()
        }
        Shape::Ellipsoid(ellipsoid) => {
            let test = ellipsoid.test_aligned(ray, range, sides);
            recorder.note(|| Event::EllipsoidTest { object, test });
            test.roots.chosen()
        }
        Shape::Box(solid) => {
            let test = solid.test_aligned(ray, range, sides);
            recorder.note(|| Event::BoxTest { object, test });
            test.roots.chosen()
        }
        Shape::Cone(cone) => {
            let test = cone.test_aligned(ray, range, sides);
            recorder.note(|| Event::ConeTest { object, test });
            test.roots.chosen()
        }
        Shape::Polygon(polygon) => {
            // first the plane …
            let plane = polygon.plane_test_aligned(ray, range, sides);
            recorder.note(|| Event::PlaneTest {
                object,
                test: plane,
            });
            let t = plane.chosen()?;
            // … then whether (0, 0) lies inside of the outline, its edges first
            let test = polygon.contains_aligned(ray, t);
            if R::ENABLED {
                for edge in polygon.edges_aligned(ray, test) {
                    recorder.note(|| Event::Edge { object, edge });
                }
            }
            recorder.note(|| Event::PolygonTest { object, test });
            test.inside.then_some(t)
        }
    }
}
