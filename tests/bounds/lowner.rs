//! The ellipsoid of least volume: closed forms, and no other ellipsoid around the object is smaller.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec3};
use raystep::geometry::OrientedEllipsoid;
use raystep::structure::{Volume, VolumeKind};
use serde_json::Value;

use super::{around, brick, cone, mesh, mesh_of, outline, polygon, solid};
use crate::seeded::Seeded;

/// What the room for rounding may add, as a share.
const ROOM: f64 = 1e-7;

#[track_caller]
fn ellipsoid_around(shape: Value) -> OrientedEllipsoid {
    match around(shape, VolumeKind::Ellipsoid) {
        Volume::Ellipsoid(ellipsoid) => ellipsoid,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn check_near(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= ROOM * expected,
        "{found}, expected {expected}"
    );
}

/// The largest half axis first.
fn sorted(ellipsoid: &OrientedEllipsoid) -> [f64; 3] {
    let mut radii = ellipsoid.radii.to_array();
    radii.sort_by(|a, b| b.total_cmp(a));
    radii
}

/// The area of the ellipse that a flat ellipsoid is.
fn area(ellipsoid: &OrientedEllipsoid) -> f64 {
    let [a, b, _] = sorted(ellipsoid);
    PI * a * b
}

#[test]
fn a_box_has_half_its_sides_times_the_root_of_three() {
    let found = ellipsoid_around(solid(DVec3::ZERO, DVec3::new(2.0, 4.0, 10.0)));
    // (4/3)π·(√3)³·1·2·5
    check_near(found.volume(), 4.0 / 3.0 * PI * 27.0_f64.sqrt() * 10.0);
    assert_eq!(found.center, DVec3::new(1.0, 2.0, 5.0));
}

#[test]
fn the_corners_of_a_box_have_the_ellipsoid_of_the_box_however_they_are_turned() {
    let mut random = Seeded::new(6);
    for _ in 0..100 {
        let faces = brick(&mut random);
        let found = ellipsoid_around(mesh(&faces));
        // the first face is 0, 2, 3, 1 and the second begins with 4
        let sides = [1, 3].map(|i| faces[0][i] - faces[0][0]).map(DVec3::length);
        let depth = (faces[1][0] - faces[0][0]).length();
        let product = 0.125 * sides[0] * sides[1] * depth;
        check_near(found.volume(), 4.0 / 3.0 * PI * 27.0_f64.sqrt() * product);
    }
}

#[test]
fn a_cylinder_has_its_height_times_half_the_root_of_three_and_its_radius_times_that_of_three_halves()
 {
    let found = ellipsoid_around(cone(DVec3::ZERO, 1.0, DVec3::new(0.0, 4.0, 0.0), 1.0));
    let [long, wide, also] = sorted(&found);
    check_near(long, 12.0_f64.sqrt());
    check_near(wide, 1.5_f64.sqrt());
    check_near(also, 1.5_f64.sqrt());
    assert!(found.center.distance(DVec3::new(0.0, 2.0, 0.0)) <= ROOM);
}

#[test]
fn a_cone_with_a_tip_has_its_center_a_quarter_up() {
    // like the simplex: the tip on the ellipsoid, 3 over the center; (1/3)² + (8/9) = 1 at the rim
    for (base, apex, radii) in [
        (0.0, 4.0, [1.0, 0.0]),
        (4.0, 0.0, [0.0, 1.0]),
        (0.0, -4.0, [1.0, 0.0]),
    ] {
        let at = |y: f64| DVec3::new(0.0, y, 0.0);
        let found = ellipsoid_around(cone(at(base), radii[0], at(apex), radii[1]));
        let [long, wide, _] = sorted(&found);
        check_near(long, 3.0);
        check_near(wide, (9.0_f64 / 8.0).sqrt());
        let rim = if radii[0] == 1.0 { base } else { apex };
        let expected = rim + 0.25 * (base + apex - 2.0 * rim);
        assert!(found.center.distance(at(expected)) <= ROOM, "{found:?}");
    }
}

#[test]
fn a_frustum_has_the_ellipsoid_of_its_rims_corners() {
    // seven corners at even angles on each rim have the moments of the rims, and so the same ellipsoid:
    // that of the corners is found by steps, that of the frustum in closed form
    let mut random = Seeded::new(7);
    for _ in 0..50 {
        let (base, apex) = (random.point(3.0), random.point(3.0));
        let radii = [random.power(-1.0, 1.0), random.power(-1.0, 1.0)];
        let u = random.across(apex - base);
        let v = (apex - base).normalize().cross(u);
        let rim = |middle: DVec3, radius: f64| -> Vec<DVec3> {
            (0..7)
                .map(|i| TAU * f64::from(i) / 7.0)
                .map(|a| middle + radius * (a.cos() * u + a.sin() * v))
                .collect()
        };
        let rims = [rim(base, radii[0]), rim(apex, radii[1])];
        let closed = ellipsoid_around(cone(base, radii[0], apex, radii[1]));
        let stepped = ellipsoid_around(mesh(&rims));
        check_near(closed.volume(), stepped.volume());
        assert!(closed.center.distance(stepped.center) <= 1e-4);
    }
}

#[test]
fn a_thin_tilted_cylinder_has_a_tilted_ellipsoid() {
    let tilt = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let found = ellipsoid_around(cone(-3.0 * tilt, 0.1, 3.0 * tilt, 0.1));
    assert!((found.axes[0].dot(tilt).abs() - 1.0).abs() <= 1e-12);
    // the box along the axes is far larger
    let shape = cone(-3.0 * tilt, 0.1, 3.0 * tilt, 0.1);
    let upright = around(shape, VolumeKind::Box).volume().unwrap();
    assert!(50.0 * found.volume() < upright, "{upright}");
}

#[test]
fn a_regular_tetrahedron_and_a_cube_have_their_circumscribed_sphere() {
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ]
    .map(DVec3::from);
    let tetrahedron = mesh_of(&corners);
    let cube: Vec<_> = corners.iter().flat_map(|&p| [p, -p]).collect();
    for shape in [tetrahedron, mesh_of(&cube)] {
        for radius in sorted(&ellipsoid_around(shape)) {
            check_near(radius, 3.0_f64.sqrt());
        }
    }
}

#[test]
fn a_triangle_has_the_ellipse_of_steiner() {
    let mut random = Seeded::new(8);
    for _ in 0..200 {
        let [a, b, c] = [0; 3].map(|_| random.point(4.0));
        let triangle = 0.5 * (b - a).cross(c - a).length();
        // one of these in some thousand is a needle, whose short half axis would be room alone
        if triangle <= 1e-2 {
            continue;
        }
        let found = ellipsoid_around(polygon(&[a, b, c]));
        check_near(area(&found), 4.0 * PI / 27.0_f64.sqrt() * triangle);
        assert!(found.center.distance((a + b + c) / 3.0) <= ROOM);
        let [long, _, thick] = sorted(&found);
        assert!((thick / long - 1e-3).abs() <= 1e-9, "{found:?}");
    }
}

#[test]
fn a_square_has_its_circle_alone_and_as_two_triangles() {
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let square = corners.map(|[x, y]| DVec3::new(x, y, 0.6 * x));
    // the slant makes the sides √5.44 and 2, an ellipse of area π/2 times theirs
    let expected = PI / 2.0 * 2.0 * (4.0 + 1.44_f64).sqrt();
    let [a, b, c, d] = square;
    for shape in [polygon(&square), mesh(&[vec![a, b, c], vec![a, c, d]])] {
        let found = ellipsoid_around(shape);
        check_near(area(&found), expected);
    }
    let upright = corners.map(|[x, y]| DVec3::new(x, y, 5.0));
    let [long, short, _] = sorted(&ellipsoid_around(polygon(&upright)));
    check_near(long, 2.0_f64.sqrt());
    check_near(short, 2.0_f64.sqrt());
}

/// An ellipsoid near another, brought to the size in which it just holds the points; only its volume
/// counts. `flat` leaves the third axis alone and gives the area.
fn perturbed(
    least: &OrientedEllipsoid,
    points: &[DVec3],
    size: f64,
    flat: bool,
    random: &mut Seeded,
) -> f64 {
    let axes = DMat3::from_cols(least.axes[0], least.axes[1], least.axes[2]);
    let unit = |p: DVec3| axes.transpose() * (p - least.center) / least.radii;
    let across = if flat {
        DVec3::new(1.0, 1.0, 0.0)
    } else {
        DVec3::ONE
    };
    // p ↦ A·p + b near the identity
    let mut columns = DMat3::IDENTITY;
    for axis in 0..3 {
        if across[axis] != 0.0 {
            *columns.col_mut(axis) += random.point(size) * across;
        }
    }
    let shift = random.point(size) * across;
    let image = |p: DVec3| columns * (unit(p) * across + shift);
    let largest = points
        .iter()
        .map(|&p| image(p).length())
        .fold(0.0, f64::max);
    // the unit sphere of that space, scaled: its share of the volume of the least
    let dimensions = if flat { 2 } else { 3 };
    largest.powi(dimensions) / columns.determinant().abs()
}

#[test]
fn no_ellipsoid_near_it_that_holds_the_points_has_less_volume() {
    // the problem is convex: what is least among its neighbours is the least
    let mut random = Seeded::new(9);
    let mut nearest = f64::INFINITY;
    for round in 0..120 {
        let flat = round % 3 == 0;
        let count = [4, 6, 9, 20, 40, 300][round % 6];
        let points = if flat {
            outline(&mut random, count, 0.7)
        } else {
            let stretch = DVec3::from([0; 3].map(|_| random.power(-2.0, 1.0)));
            let turn = glam::DQuat::from_axis_angle(random.direction(), 1.0);
            let middle = random.point(3.0);
            let mut point = || middle + turn * (stretch * random.point(1.0));
            (0..count).map(|_| point()).collect()
        };
        let shape = if flat {
            polygon(&points)
        } else {
            mesh_of(&points)
        };
        let least = ellipsoid_around(shape);
        for size in [0.3, 1e-2, 1e-3, 1e-4, 1e-5] {
            for _ in 0..200 {
                let share = perturbed(&least, &points, size, flat, &mut random);
                assert!(1.0 - ROOM <= share, "{share} {size} {count}");
                nearest = nearest.min(share);
            }
        }
    }
    // the neighbours came near enough to have shown a smaller one
    assert!(nearest <= 1.0 + 1e-4, "{nearest}");
}

#[test]
fn a_needle_and_a_sheet_keep_their_proportions() {
    // a simplex 1 by 10⁻² by 10⁻⁴: its ellipsoid has the same share of it as the sphere has of the regular
    // one above, (4/3)π(√3)³ to 8/3
    let corners = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.3, 1e-2, 0.0],
        [0.6, 2e-3, 1e-4],
    ]
    .map(DVec3::from);
    let found = ellipsoid_around(mesh_of(&corners));
    let ratio = 4.0 / 3.0 * PI * 27.0_f64.sqrt() / (8.0 / 3.0);
    // a room of 10⁻¹⁰ is 2·10⁻⁶ of the shortest half axis
    let expected = ratio * 1e-6 / 6.0;
    assert!(
        (found.volume() - expected).abs() <= 1e-5 * expected,
        "{}",
        found.volume()
    );
}
