//! What becomes of the points of an object in the frame of a ray.

use glam::DVec3;

use crate::geometry::Alignment;
use crate::scene::{PrimitiveId, Shape};
use crate::trace::{Aligned, AlignedPart, Event, Recorder};

/// Notes the points and half axes of an object, before and after.
pub(super) fn note_transformed<R: Recorder>(
    object: PrimitiveId,
    shape: &Shape,
    frame: &Alignment,
    recorder: &mut R,
) {
    let mut note = |part, index, from| {
        recorder.note(|| {
            let to = match part {
                AlignedPart::HalfAxis => frame.vector(from),
                _ => frame.point(from),
            };
            Event::Aligned(Aligned {
                object,
                part,
                index,
                from,
                to,
            })
        });
    };
    match shape {
        Shape::Sphere(sphere) => note(AlignedPart::Center, 0, sphere.center),
        Shape::Ellipsoid(ellipsoid) => {
            note(AlignedPart::Center, 0, ellipsoid.center);
            for (index, axis) in (0..).zip(half_axes(ellipsoid.radii)) {
                note(AlignedPart::HalfAxis, index, axis);
            }
        }
        Shape::Box(solid) => {
            note(AlignedPart::Center, 0, 0.5 * (solid.min + solid.max));
            for (index, axis) in (0..).zip(half_axes(0.5 * (solid.max - solid.min))) {
                note(AlignedPart::HalfAxis, index, axis);
            }
        }
        Shape::Cone(cone) => {
            note(AlignedPart::Base, 0, cone.base());
            note(AlignedPart::Apex, 0, cone.apex());
        }
        Shape::Polygon(polygon) => {
            for (index, vertex) in (0..).zip(polygon.vertices()) {
                note(AlignedPart::Vertex, index, vertex);
            }
        }
    }
}

/// The half axes of an ellipsoid or a box, as vectors.
fn half_axes(radii: DVec3) -> [DVec3; 3] {
    [
        DVec3::new(radii.x, 0.0, 0.0),
        DVec3::new(0.0, radii.y, 0.0),
        DVec3::new(0.0, 0.0, radii.z),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::scene::small_scene::{polygon, scene_of, solid, sphere};
    use crate::trace::Recording;

    /// The parts of a shape in the frame of a ray from (1, 2, 3) along z.
    fn parts(shape: String) -> Vec<(AlignedPart, u32, [f64; 3], [f64; 3])> {
        let frame = Alignment::of(&Ray::new(DVec3::new(1.0, 2.0, 3.0), DVec3::Z));
        let scene = scene_of(&[shape]);
        let mut recording = Recording::new(Vec::new());
        note_transformed(
            PrimitiveId(0),
            &scene.primitives[0].shape,
            &frame,
            &mut recording,
        );
        let of = |event: Event| match event {
            Event::Aligned(of) => {
                assert_eq!(of.object, PrimitiveId(0));
                (of.part, of.index, of.from.to_array(), of.to.to_array())
            }
            other => panic!("{other:?}"),
        };
        let records = recording.into_sink();
        records.into_iter().map(|record| of(record.event)).collect()
    }

    #[test]
    fn a_frame_along_z_is_that_of_the_world_moved() {
        // e = x, and z × e = y
        let frame = Alignment::of(&Ray::new(DVec3::new(1.0, 2.0, 3.0), DVec3::Z));
        assert_eq!((frame.x, frame.y, frame.z), (DVec3::X, DVec3::Y, DVec3::Z));
    }

    #[test]
    fn a_sphere_has_its_center_and_a_polygon_its_vertices_moved() {
        use AlignedPart::{Center, Vertex};
        let of_sphere = parts(sphere([5.0, 6.0, 7.0], 1.0));
        assert_eq!(of_sphere, [(Center, 0, [5.0, 6.0, 7.0], [4.0, 4.0, 4.0])]);
        let corners = [[1.0, 2.0, 3.0], [2.0, 2.0, 3.0], [2.0, 4.0, 9.0]];
        let expected = [
            (Vertex, 0, corners[0], [0.0; 3]),
            (Vertex, 1, corners[1], [1.0, 0.0, 0.0]),
            (Vertex, 2, corners[2], [1.0, 2.0, 6.0]),
        ];
        assert_eq!(parts(polygon(&corners)), expected);
    }

    #[test]
    fn a_box_has_its_center_moved_and_its_half_sides_only_turned() {
        use AlignedPart::{Center, HalfAxis};
        let expected = [
            (Center, 0, [4.0, 6.0, 8.0], [3.0, 4.0, 5.0]),
            (HalfAxis, 0, [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
            (HalfAxis, 1, [0.0, 2.0, 0.0], [0.0, 2.0, 0.0]),
            (HalfAxis, 2, [0.0, 0.0, 3.0], [0.0, 0.0, 3.0]),
        ];
        assert_eq!(parts(solid([3.0, 4.0, 5.0], [5.0, 8.0, 11.0])), expected);
        let ellipsoid = r#"{"ellipsoid":{"center":[4,6,8],"radii":[1,2,3]}}"#;
        assert_eq!(parts(ellipsoid.to_string()), expected);
    }

    #[test]
    fn a_cone_has_the_centers_of_its_rims_moved() {
        use AlignedPart::{Apex, Base};
        let cone = r#"{"cone":{"base":[1,2,4],"base_radius":1,"apex":[1,5,3],"apex_radius":0}}"#;
        let expected = [
            (Base, 0, [1.0, 2.0, 4.0], [0.0, 0.0, 1.0]),
            (Apex, 0, [1.0, 5.0, 3.0], [0.0, 3.0, 0.0]),
        ];
        assert_eq!(parts(cone.to_string()), expected);
    }
}
