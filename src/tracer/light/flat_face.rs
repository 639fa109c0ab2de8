//! The flat faces of a scene: polygons, and the sides of boxes. Light that is stored on one of them stays on it,
//! and its edges are known.

use glam::{DVec2, DVec3};

use crate::scene::{PrimitiveId, Scene, Shape};
use crate::tracer::surface::Surface;

/// Which surface light is stored on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::tracer) enum Patch {
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
    pub(in crate::tracer) fn of(scene: &Scene, surface: &Surface<'_>) -> Self {
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
    pub(in crate::tracer) fn corners(self, scene: &Scene) -> Vec<DVec3> {
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
pub(in crate::tracer) fn along(normal: DVec3) -> [DVec3; 2] {
    let first = normal.any_orthonormal_vector();
    [first, normal.cross(first)]
}

/// Points on a plane, seen from one of them.
pub(in crate::tracer) fn on_plane(
    corners: &[DVec3],
    origin: DVec3,
    [right, up]: [DVec3; 2],
) -> impl ExactSizeIterator<Item = DVec2> + Clone {
    corners.iter().map(move |&corner| {
        let offset = corner - origin;
        DVec2::new(offset.dot(right), offset.dot(up))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::scene::small_scene::{object, one_pixel, polygon, solid, sphere};
    use crate::strategy::Hit;

    fn scene() -> Scene {
        let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let mesh = format!(r#"{{"mesh":{{"faces":[{{"vertices":{triangle:?}}}]}}}}"#);
        one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,1,1]}}}},"objects":[{},{},{},{}]"#,
            object("box", "m", &solid([1.0, 2.0, 3.0], [4.0, 6.0, 8.0])),
            object("triangle", "m", &polygon(&triangle)),
            object("ball", "m", &sphere([0.0, 0.0, 0.0], 1.0)),
            object("mesh", "m", &mesh)
        ))
    }

    /// The patch where a ray hits a primitive.
    fn patch(primitive: u32, origin: [f64; 3], direction: [f64; 3], t: f64) -> Patch {
        let scene = scene();
        let ray = Ray::new(origin.into(), direction.into());
        let object = PrimitiveId(primitive);
        let normals = scene.primitive(object).shape.normals(ray.at(t));
        let hit = Hit { object, t };
        Patch::of(&scene, &Surface::new(&scene, &ray, 1, hit, normals))
    }

    const BOX: PrimitiveId = PrimitiveId(0);

    #[test]
    fn a_face_of_a_box_is_its_axis_and_end_whichever_side_is_met() {
        let face = |face, back| Patch::Flat {
            primitive: BOX,
            face,
            back,
        };
        // the upper face across x at 4: from outside and from inside
        assert_eq!(
            patch(0, [9.0, 4.0, 5.0], [-1.0, 0.0, 0.0], 5.0),
            face((0, true), false)
        );
        assert_eq!(
            patch(0, [2.0, 4.0, 5.0], [1.0, 0.0, 0.0], 2.0),
            face((0, true), true)
        );
        // the lower one across z at 3
        assert_eq!(
            patch(0, [2.0, 4.0, 0.0], [0.0, 0.0, 1.0], 3.0),
            face((2, false), false)
        );
        assert_eq!(
            patch(0, [2.0, 4.0, 5.0], [0.0, 0.0, -1.0], 2.0),
            face((2, false), true)
        );
    }

    #[test]
    fn a_face_has_its_corners_in_order_around_it() {
        let scene = scene();
        let corners = |face| {
            let patch = Patch::Flat {
                primitive: BOX,
                face,
                back: false,
            };
            patch
                .corners(&scene)
                .iter()
                .map(DVec3::to_array)
                .collect::<Vec<_>>()
        };
        let upper_x = [
            [4.0, 2.0, 3.0],
            [4.0, 6.0, 3.0],
            [4.0, 6.0, 8.0],
            [4.0, 2.0, 8.0],
        ];
        assert_eq!(corners((0, true)), upper_x);
        let lower_y = [
            [1.0, 2.0, 3.0],
            [1.0, 2.0, 8.0],
            [4.0, 2.0, 8.0],
            [4.0, 2.0, 3.0],
        ];
        assert_eq!(corners((1, false)), lower_y);
        let lower_z = [
            [1.0, 2.0, 3.0],
            [4.0, 2.0, 3.0],
            [4.0, 6.0, 3.0],
            [1.0, 6.0, 3.0],
        ];
        assert_eq!(corners((2, false)), lower_z);
    }

    #[test]
    fn a_polygon_is_flat_with_its_own_corners_and_a_ball_or_a_mesh_is_curved() {
        let scene = scene();
        let triangle = patch(1, [1.0, 1.0, 5.0], [0.0, 0.0, -1.0], 5.0);
        assert!(matches!(triangle, Patch::Flat { back: false, .. }));
        let below = patch(1, [1.0, 1.0, -5.0], [0.0, 0.0, 1.0], 5.0);
        assert!(matches!(below, Patch::Flat { back: true, .. }));
        let corners = [DVec3::ZERO, 4.0 * DVec3::X, 4.0 * DVec3::Y];
        assert_eq!(triangle.corners(&scene), corners);
        let curved = |object, back| Patch::Curved { object, back };
        let ball = patch(2, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], 4.0);
        assert_eq!(ball, curved(2, false));
        assert!(ball.corners(&scene).is_empty());
        assert_eq!(patch(2, [0.0; 3], [0.0, 0.0, -1.0], 1.0), curved(2, true));
        let mesh = patch(3, [1.0, 1.0, 5.0], [0.0, 0.0, -1.0], 5.0);
        assert_eq!(mesh, curved(3, false));
    }

    #[test]
    fn coordinates_along_a_plane_are_lengths_along_two_unit_vectors_across_its_normal() {
        let normal = DVec3::new(0.6, 0.0, 0.8);
        let [right, up] = along(normal);
        assert!((right.length() - 1.0).abs() <= 1e-15 && (up.length() - 1.0).abs() <= 1e-15);
        let dots = [right.dot(up), right.dot(normal), up.dot(normal)];
        assert!(dots.iter().all(|dot| dot.abs() <= 1e-15), "{dots:?}");
        // right-handed: seen from the side of the normal the second lies to the left of the first
        assert!((right.cross(up) - normal).length() <= 1e-15);
        let origin = DVec3::new(1.0, 2.0, 3.0);
        let points = [origin, origin + 2.0 * right - 5.0 * up];
        let found: Vec<_> = on_plane(&points, origin, [right, up]).collect();
        assert_eq!(found[0], DVec2::ZERO);
        assert!((found[1] - DVec2::new(2.0, -5.0)).length() <= 1e-14);
    }
}
