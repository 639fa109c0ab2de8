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
