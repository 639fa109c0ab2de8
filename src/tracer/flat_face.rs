//! The flat faces of a scene: polygons, and the sides of boxes. Light that is stored on one of them stays on it,
//! and its edges are known.

use glam::{DVec2, DVec3};

use crate::scene::{PrimitiveId, Scene, Shape};
use crate::tracer::surface::Surface;

/// Which surface light is stored on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Patch {
    /// One side of a polygon, or of a face of a box.
    Flat {
        primitive: PrimitiveId,
        /// Of a box, which face: the axis across it, and whether it is the one at the upper end.
        face: (u8, bool),
        back: bool,
    },
    /// One side of any other object; the faces of a mesh are one surface.
    Curved { object: u32, back: bool },
}

impl Patch {
    /// The patch that a point lies on.
    pub(super) fn of(scene: &Scene, surface: &Surface<'_>) -> Self {
        let object = scene.object_of(surface.object);
        let is_flat = matches!(
            scene.primitive(surface.object).shape,
            Shape::Polygon(_) | Shape::Box(_)
        );
        if is_flat && !object.is_mesh {
            // the normal is on the side that is seen: from inside a box, it points inwards
            let axis = surface.across.abs().max_position();
            let points_up = 0.0 < surface.across[axis];
            Self::Flat {
                primitive: surface.object,
                face: (axis as u8, points_up != surface.back),
                back: surface.back,
            }
        } else {
            Self::Curved {
                object: scene.primitive(surface.object).object,
                back: surface.back,
            }
        }
    }

    /// The corners of a flat face, in space; none of a curved one.
    pub(super) fn corners(self, scene: &Scene) -> Vec<DVec3> {
        let Self::Flat {
            primitive, face, ..
        } = self
        else {
            return Vec::new();
        };
        match &scene.primitive(primitive).shape {
            Shape::Polygon(polygon) => polygon.vertices().collect(),
            Shape::Box(solid) => {
                let (axis, is_upper) = (usize::from(face.0), face.1);
                let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                let corner = |at_u: DVec3, at_v: DVec3| {
                    let mut corner = if is_upper { solid.max } else { solid.min };
                    corner[u] = at_u[u];
                    corner[v] = at_v[v];
                    corner
                };
                vec![
                    corner(solid.min, solid.min),
                    corner(solid.max, solid.min),
                    corner(solid.max, solid.max),
                    corner(solid.min, solid.max),
                ]
            }
            _ => Vec::new(),
        }
    }
}

/// Coordinates along a plane: which unit vectors are at right angles to each other and to a unit normal?
pub(super) fn along(normal: DVec3) -> [DVec3; 2] {
    let first = normal.any_orthonormal_vector();
    [first, normal.cross(first)]
}

/// Points on a plane, seen from one of them.
pub(super) fn on_plane(
    corners: &[DVec3],
    origin: DVec3,
    [right, up]: [DVec3; 2],
) -> impl ExactSizeIterator<Item = DVec2> + Clone {
    corners.iter().map(move |&corner| {
        let offset = corner - origin;
        DVec2::new(offset.dot(right), offset.dot(up))
    })
}
