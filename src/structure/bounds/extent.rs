//! How far a shape reaches along a direction: what its slab's D_min and D_max are made of.

use glam::DVec3;

use crate::geometry::AxisBox;
use crate::scene::Shape;

/// The room that a shape is given on either side for rounding, as a share of its own coordinates.
///
/// A computed hit lies off the exact surface by some 10⁻¹⁵ of the numbers that it was computed from, a
/// hundredfold where the ray hits the surface flatly. With 10⁻¹⁰ no bound cuts a hit off.
pub(in crate::structure) const ROUNDING: f64 = 1e-10;

/// The smallest and the largest n·p over the points p of the shape.
///
/// n is of unit length. A slab's planes are n·p + D = 0, so D_min = −largest and D_max = −smallest
/// (erratum 5).
///
/// - sphere: n·c ± r
/// - ellipsoid: n·c ± |(n_x·r_x, n_y·r_y, n_z·r_z)|
/// - box: n·(center) ± Σ |nᵢ|·half sideᵢ
/// - cone: over its two rims, n·rim ± r·|n × axis|
/// - polygon: over its vertices, and as thick as a bent one is
pub fn extent(shape: &Shape, n: DVec3) -> [f64; 2] {
    match shape {
        Shape::Sphere(sphere) => around(n.dot(sphere.center), sphere.radius),
        Shape::Ellipsoid(ellipsoid) => {
            around(n.dot(ellipsoid.center), (n * ellipsoid.radii).length())
        }
        Shape::Box(solid) => {
            let (low, high) = (n * solid.min, n * solid.max);
            [low.min(high).element_sum(), low.max(high).element_sum()]
        }
        Shape::Cone(cone) => {
            // of an axis nearly along n the root of 1 − (n·axis)² would be rounding, some 10⁻⁸
            let slant = n.cross(cone.axis()).length();
            let [base, apex] = cone.radii();
            union(
                around(n.dot(cone.base()), base * slant),
                around(n.dot(cone.apex()), apex * slant),
            )
        }
        Shape::Polygon(polygon) => {
            let thickness = thickness(shape);
            polygon
                .vertices()
                .map(|vertex| around(n.dot(vertex), thickness))
                .fold([f64::INFINITY, f64::NEG_INFINITY], union)
        }
    }
}

/// How far a hit may lie off the extent of a shape's own points: 0, but for a polygon whose vertices are off their
/// plane by more than rounding.
pub(in crate::structure) fn thickness(shape: &Shape) -> f64 {
    match shape {
        // what is less belongs to the room for rounding, of which it is a small part
        Shape::Polygon(polygon) if ROUNDING * shape.reach() < polygon.room() => polygon.room(),
        _ => 0.0,
    }
}

/// The box around a shape: [`extent`] along x, y and z at one go.
pub(in crate::structure) fn box_around(shape: &Shape) -> AxisBox {
    match shape {
        Shape::Sphere(sphere) => AxisBox {
            min: sphere.center - sphere.radius,
            max: sphere.center + sphere.radius,
        },
        Shape::Box(solid) => *solid,
        Shape::Polygon(polygon) => AxisBox::around(polygon.vertices()).with_room(thickness(shape)),
        Shape::Ellipsoid(_) | Shape::Cone(_) => {
            let [x, y, z] = DVec3::AXES.map(|axis| extent(shape, axis));
            AxisBox {
                min: DVec3::new(x[0], y[0], z[0]),
                max: DVec3::new(x[1], y[1], z[1]),
            }
        }
    }
}

/// [`box_around`] with room for rounding: 10⁻¹⁰ of the shape's coordinates, and for a polygon as much as its hits may lie
/// off its vertices.
pub(in crate::structure) fn box_with_room(shape: &Shape) -> AxisBox {
    let off_plane = match shape {
        Shape::Polygon(polygon) => polygon.room() - thickness(shape),
        _ => 0.0,
    };
    let AxisBox { min, max } = box_around(shape);
    let rounding = ROUNDING * shape.reach();
    AxisBox {
        min: min - off_plane - rounding,
        max: max + off_plane + rounding,
    }
}

fn around(middle: f64, half: f64) -> [f64; 2] {
    [middle - half, middle + half]
}

fn union(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Cone, Ellipsoid, Polygon, Sphere};

    #[track_caller]
    fn check(shape: &Shape, n: [f64; 3], expected: [f64; 2]) {
        let found = extent(shape, DVec3::from(n));
        let off = |found: f64, expected: f64| (found - expected).abs();
        for (found, expected) in found.into_iter().zip(expected) {
            // a few roundings
            assert!(
                off(found, expected) <= 1e-14,
                "{found}, expected {expected}"
            );
        }
        let (bare, wider) = (box_around(shape), box_with_room(shape));
        for (axis, along) in DVec3::AXES.into_iter().enumerate() {
            assert_eq!(bare.along(axis), extent(shape, along));
            let [low, high] = bare.along(axis);
            let [below, above] = wider.along(axis);
            assert!(below < low && high < above);
            assert!(off(below, low) <= 1e-8 && off(above, high) <= 1e-8);
        }
    }

    const DIAGONAL: [f64; 3] = [0.6, 0.8, 0.0];

    #[test]
    fn a_sphere_reaches_its_radius_to_both_sides_of_its_center() {
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::new(5.0, 10.0, 1.0),
            radius: 2.0,
        });
        // 3 + 8 = 11
        check(&sphere, DIAGONAL, [9.0, 13.0]);
    }

    #[test]
    fn an_ellipsoid_reaches_the_length_of_its_scaled_direction() {
        let ellipsoid = Shape::Ellipsoid(Ellipsoid {
            center: DVec3::ZERO,
            radii: DVec3::new(5.0, 15.0, 1.0),
        });
        // |(3, 12, 0)| = √153
        check(&ellipsoid, DIAGONAL, [-153.0_f64.sqrt(), 153.0_f64.sqrt()]);
    }

    #[test]
    fn a_box_reaches_to_its_corners() {
        let solid = Shape::Box(AxisBox {
            min: DVec3::new(0.0, -5.0, 0.0),
            max: DVec3::new(10.0, 5.0, 1.0),
        });
        check(&solid, DIAGONAL, [-4.0, 10.0]);
    }

    #[test]
    fn a_cone_reaches_to_its_rims() {
        // base in y = 0 with radius 5: n·rim = ±5·0.6; apex at y = 10 with radius 0: 8
        let cone = Cone::new(DVec3::ZERO, 5.0, DVec3::new(0.0, 10.0, 0.0), 0.0).unwrap();
        check(&Shape::Cone(cone), DIAGONAL, [-3.0, 8.0]);
    }

    #[test]
    fn a_cylinder_whose_axis_is_nearly_along_x_reaches_below_its_base() {
        // tilted by 2⁻²⁴, of which the square keeps 4 bits beside 1: the rim of radius 10 reaches some 10·2⁻²⁴ to either side
        let tilt = 0.5_f64.powi(24);
        let cylinder = Cone::new(DVec3::ZERO, 10.0, DVec3::new(1.0, tilt, 0.0), 10.0).unwrap();
        let [low, high] = extent(&Shape::Cone(cylinder), DVec3::X);
        // 10·sin of the tilt, but for the rounding of the sine and of one product
        let reach = 10.0 * tilt / (1.0 + tilt * tilt).sqrt() * (1.0 - 4.0 * f64::EPSILON);
        assert!(low <= -reach && 1.0 + reach <= high, "{low} {high}");
        assert!(
            -11.0 * tilt <= low && high <= 1.0 + 11.0 * tilt,
            "{low} {high}"
        );
    }

    #[test]
    fn a_polygon_reaches_to_its_vertices() {
        let corners = [[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [0.0, 5.0, 0.0]].map(DVec3::from);
        let triangle = Polygon::new(corners.to_vec(), None).unwrap();
        check(&Shape::Polygon(triangle), DIAGONAL, [0.0, 4.0]);
    }

    #[test]
    fn a_bent_polygon_is_as_thick_as_its_hits_may_lie_off_its_vertices() {
        let corners = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 4e-6],
            [0.0, 1.0, 0.0],
        ];
        let bent = Polygon::new(corners.map(DVec3::from).to_vec(), None).unwrap();
        // each vertex is 10⁻⁶ off the plane, and a ray that hits it under 1 in 64 finds it 64·10⁻⁶ away
        let [low, high] = extent(&Shape::Polygon(bent), DVec3::Z);
        assert!((low + 64e-6).abs() <= 1e-11, "{low}");
        assert!((high - 68e-6).abs() <= 1e-11, "{high}");
    }

    /// Two roundings of coordinates up to 16.
    const TWICE_ROUNDED: f64 = 4e-15;

    #[track_caller]
    fn check_box(found: AxisBox, expected: [[f64; 3]; 2]) {
        for (found, expected) in [found.min, found.max]
            .into_iter()
            .zip(expected.map(DVec3::from))
        {
            let off = (found - expected).abs().max_element();
            assert!(off <= TWICE_ROUNDED, "{found}, expected {expected}");
        }
    }

    #[test]
    fn the_box_around_a_shape_has_its_extents_along_the_axes_as_sides() {
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::new(5.0, 10.0, 1.0),
            radius: 2.0,
        });
        check_box(box_around(&sphere), [[3.0, 8.0, -1.0], [7.0, 12.0, 3.0]]);
        let ellipsoid = Shape::Ellipsoid(Ellipsoid {
            center: DVec3::new(5.0, 10.0, 1.0),
            radii: DVec3::new(1.0, 2.0, 4.0),
        });
        check_box(box_around(&ellipsoid), [[4.0, 8.0, -3.0], [6.0, 12.0, 5.0]]);
        let solid = Shape::Box(AxisBox {
            min: DVec3::new(1.0, 2.0, 3.0),
            max: DVec3::new(3.0, 6.0, 7.0),
        });
        check_box(box_around(&solid), [[1.0, 2.0, 3.0], [3.0, 6.0, 7.0]]);
        // the rims are circles across y
        let cone = Cone::new(
            DVec3::new(4.0, 1.0, 2.0),
            1.0,
            DVec3::new(4.0, 5.0, 2.0),
            3.0,
        );
        check_box(
            box_around(&Shape::Cone(cone.unwrap())),
            [[1.0, 1.0, -1.0], [7.0, 5.0, 5.0]],
        );
        let corners = [[1.0, 2.0, 3.0], [5.0, 2.0, 3.0], [1.0, 2.0, 7.0]].map(DVec3::from);
        let triangle = Polygon::new(corners.to_vec(), None).unwrap();
        check_box(
            box_around(&Shape::Polygon(triangle)),
            [[1.0, 2.0, 3.0], [5.0, 2.0, 7.0]],
        );
    }

    #[test]
    fn room_for_rounding_is_a_ten_billionth_of_the_shape_s_coordinates() {
        // reach: 10 + 2
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::new(5.0, 10.0, 1.0),
            radius: 2.0,
        });
        let room = 1.2e-9;
        check_box(
            box_with_room(&sphere),
            [
                [3.0 - room, 8.0 - room, -1.0 - room],
                [7.0 + room, 12.0 + room, 3.0 + room],
            ],
        );
        let [low, high] = box_with_room(&sphere).along(1);
        assert!((low - (8.0 - room)).abs() <= TWICE_ROUNDED, "{low}");
        assert!((high - (12.0 + room)).abs() <= TWICE_ROUNDED, "{high}");
    }

    #[test]
    fn a_polygon_s_room_is_for_its_bend_and_a_ten_billionth_of_its_coordinates() {
        // in z = 3 exactly: the room for a bend is 64 times the rounding of the distances of its vertices, 8ε·(5 + 2 + 3)
        let corners = [[1.0, 1.0, 3.0], [5.0, 1.0, 3.0], [5.0, 2.0, 3.0]].map(DVec3::from);
        let flat = Shape::Polygon(Polygon::new(corners.to_vec(), None).unwrap());
        assert_eq!(thickness(&flat), 0.0);
        let room = 64.0 * 80.0 * f64::EPSILON + 5e-10;
        check_box(
            box_with_room(&flat),
            [
                [1.0 - room, 1.0 - room, 3.0 - room],
                [5.0 + room, 2.0 + room, 3.0 + room],
            ],
        );
        let [low, high] = box_with_room(&flat).along(2);
        assert!((low - (3.0 - room)).abs() <= TWICE_ROUNDED, "{low}");
        assert!((high - (3.0 + room)).abs() <= TWICE_ROUNDED, "{high}");
    }

    #[test]
    fn a_bent_polygon_s_thickness_is_its_room_and_counts_once() {
        let corners = [
            [1.0, 1.0, 1.0],
            [2.0, 1.0, 1.0],
            [2.0, 2.0, 1.0 + 4e-6],
            [1.0, 2.0, 1.0],
        ];
        let bent = Polygon::new(corners.map(DVec3::from).to_vec(), None).unwrap();
        let thick = bent.room();
        let bent = Shape::Polygon(bent);
        assert!((thick - 64e-6).abs() <= 1e-11, "{thick}");
        assert_eq!(thickness(&bent), thick);
        let top = 1.0 + 4e-6;
        check_box(
            box_around(&bent),
            [
                [1.0 - thick, 1.0 - thick, 1.0 - thick],
                [2.0 + thick, 2.0 + thick, top + thick],
            ],
        );
        // and 10⁻¹⁰ of 2
        let room = thick + 2e-10;
        check_box(
            box_with_room(&bent),
            [
                [1.0 - room, 1.0 - room, 1.0 - room],
                [2.0 + room, 2.0 + room, top + room],
            ],
        );
        let [low, high] = box_with_room(&bent).along(2);
        assert!((low - (1.0 - room)).abs() <= TWICE_ROUNDED, "{low}");
        assert!((high - (top + room)).abs() <= TWICE_ROUNDED, "{high}");
    }

    #[test]
    fn a_polygon_that_is_bent_by_less_than_its_room_for_rounding_is_not_thick() {
        // each corner is 2.5·10⁻¹² off the plane, 64 times that is 1.6·10⁻¹⁰; the room is 10⁻¹⁰ of 5
        let corners = [
            [1.0, 1.0, 1.0],
            [5.0, 1.0, 1.0],
            [5.0, 5.0, 1.0 + 1e-11],
            [1.0, 5.0, 1.0],
        ];
        let bent = Polygon::new(corners.map(DVec3::from).to_vec(), None).unwrap();
        assert!((1.5e-10..1.7e-10).contains(&bent.room()), "{}", bent.room());
        assert_eq!(thickness(&Shape::Polygon(bent)), 0.0);
    }
}
