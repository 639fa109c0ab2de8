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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{cube_at, polygon, scene_of, sphere};
    use crate::strategy::noted::{noted, noted_in};
    use crate::trace::Off;

    #[test]
    fn hits_are_sorted_by_z_which_is_t_times_the_length_of_the_direction() {
        // along x: the cube at 9, the sphere from 4 to 6, the triangle at 7, one cube beside
        let triangle = polygon(&[[7.0, -1.0, -1.0], [7.0, 2.0, -1.0], [7.0, -1.0, 2.0]]);
        let scene = scene_of(&[
            cube_at(9.0),
            sphere([5.0, 0.25, 0.25], 1.0),
            triangle,
            r#"{"cone":{"base":[3,9,0],"base_radius":1,"apex":[3,12,0],"apex_radius":0}}"#
                .to_string(),
            r#"{"ellipsoid":{"center":[20,0.25,0.25],"radii":[8,1,1]}}"#.to_string(),
        ]);
        let ray = Ray::new(DVec3::new(0.0, 0.25, 0.25), 2.0 * DVec3::X);
        let (events, hit) = noted(&ZAligned::new(&scene), &ray);
        let hit = hit.unwrap();
        assert_eq!(hit.object, PrimitiveId(1));
        assert!((hit.t - 2.0).abs() <= 1e-15, "{hit:?}");
        let sorted: Vec<_> = events
            .iter()
            .filter_map(|event| match event {
                Event::ZSort(of) => Some((of.place, of.object.0, (of.z * 1e9).round() / 1e9)),
                _ => None,
            })
            .collect();
        assert_eq!(
            sorted,
            [(0, 1, 4.0), (1, 2, 7.0), (2, 0, 9.0), (3, 4, 12.0)]
        );
    }

    #[test]
    fn hits_beyond_the_range_are_none_and_of_equal_ones_the_first_object_wins() {
        let scene = scene_of(&[cube_at(5.0), cube_at(3.0), cube_at(3.0)]);
        let strategy = ZAligned::new(&scene);
        let ray = Ray::new(DVec3::new(0.0, 0.5, 0.5), DVec3::X);
        let hit = noted(&strategy, &ray).1.unwrap();
        assert_eq!((hit.object, hit.t), (PrimitiveId(1), 3.0));
        assert_eq!(
            noted_in(&strategy, &ray, TRange::FORWARD.up_to(2.9)).1,
            None
        );
        // a shadow ray ends at the first that it hits in the order of the scene
        let any = strategy.any(&ray, TRange::FORWARD, &mut Off).unwrap();
        assert_eq!((any.object, any.t), (PrimitiveId(0), 5.0));
    }
}
