//! The normal of a surface.

use glam::DVec3;

use crate::mistake::{Mistake, Wrong};
use crate::scene::{Normals, Shape};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "p instead of p − c",
        sentence: "The normal of a sphere is taken from the world's origin to the point, not from the sphere's center.",
        spoils: "N",
        wrong: Wrong::Normals(point_alone),
    },
    Mistake {
        name: "not divided by r",
        sentence: "The normal of a sphere is p − c, whose length is the radius and not 1.",
        spoils: "N",
        wrong: Wrong::Normals(not_divided_by_r),
    },
    Mistake {
        name: "cross product turned",
        sentence: "The two edges of the cross product are exchanged, so the normal of a polygon points to its back.",
        spoils: "N",
        wrong: Wrong::Normals(cross_product_turned),
    },
];

/// The same normal across the surface and to shade with.
fn alike(normal: DVec3) -> Normals {
    Normals {
        geometric: normal,
        shading: normal,
    }
}

fn point_alone(shape: &Shape, point: DVec3) -> Normals {
    match shape {
        Shape::Sphere(_) => alike(point.normalize_or(DVec3::Y)),
        _ => shape.normals(point),
    }
}

fn not_divided_by_r(shape: &Shape, point: DVec3) -> Normals {
    match shape {
        Shape::Sphere(sphere) => alike(point - sphere.center),
        _ => shape.normals(point),
    }
}

fn cross_product_turned(shape: &Shape, point: DVec3) -> Normals {
    let Normals { geometric, shading } = shape.normals(point);
    match shape {
        Shape::Polygon(_) => Normals {
            geometric: -geometric,
            shading: -shading,
        },
        _ => Normals { geometric, shading },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polygon, Sphere};

    fn sphere(x: f64, radius: f64) -> Shape {
        Shape::Sphere(Sphere {
            center: DVec3::new(x, 0.0, 0.0),
            radius,
        })
    }

    #[test]
    fn the_normal_of_a_sphere_needs_its_center_and_its_radius() {
        // (3, 4, 0) on a sphere around (3, 0, 0) of radius 4
        let (shape, p) = (sphere(3.0, 4.0), DVec3::new(3.0, 4.0, 0.0));
        assert_eq!(shape.normals(p), alike(DVec3::Y));
        let from_world = point_alone(&shape, p).geometric - DVec3::new(0.6, 0.8, 0.0);
        assert!(from_world.length() <= 1e-15);
        assert_eq!(
            not_divided_by_r(&shape, p),
            alike(DVec3::new(0.0, 4.0, 0.0))
        );
        assert_eq!(cross_product_turned(&shape, p), alike(DVec3::Y));
        let unit = sphere(0.0, 1.0);
        for wrong in [point_alone, not_divided_by_r] {
            assert_eq!(wrong(&unit, DVec3::Y), unit.normals(DVec3::Y));
        }
    }

    #[test]
    fn edges_the_other_way_round_turn_the_normal_of_a_polygon() {
        // counter-clockwise as seen from +z
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let corners = corners.map(DVec3::from).to_vec();
        let triangle = Shape::Polygon(Polygon::new(corners, None).unwrap());
        assert_eq!(triangle.normals(DVec3::ZERO), alike(DVec3::Z));
        let turned = cross_product_turned(&triangle, DVec3::ZERO);
        assert_eq!(turned, alike(DVec3::NEG_Z));
        assert_eq!(point_alone(&triangle, DVec3::ZERO), alike(DVec3::Z));
    }
}
