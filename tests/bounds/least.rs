//! The smallest sphere: no sphere around the object is smaller.

use glam::{DMat3, DVec3};
use raystep::geometry::Sphere;
use raystep::structure::{Volume, VolumeKind};
use serde_json::Value;

use super::{around, cone, mesh, mesh_of, outline, polygon, solid};
use crate::seeded::Seeded;

/// What the room for rounding adds to a radius, at coordinates of up to 30.
const ROOM: f64 = 1e-8;

#[track_caller]
fn sphere_around(shape: Value) -> Sphere {
    match around(shape, VolumeKind::Sphere) {
        Volume::Sphere(sphere) => sphere,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn check(shape: Value, center: [f64; 3], radius: f64) {
    let found = sphere_around(shape);
    let off = found.center.distance(DVec3::from(center));
    assert!(
        off <= ROOM && (found.radius - radius).abs() <= ROOM,
        "{found:?}, expected {center:?} {radius}"
    );
}

#[test]
fn a_box_has_the_sphere_of_half_its_diagonal() {
    // 2² + 3² + 6² = 7²
    check(
        solid(DVec3::ZERO, DVec3::new(2.0, 3.0, 6.0)),
        [1.0, 1.5, 3.0],
        3.5,
    );
}

#[test]
fn a_cone_has_the_sphere_through_both_rims() {
    let up = |height| DVec3::new(0.0, height, 0.0);
    // radii 4 and 3, 7 apart: 3 over the base, 3² + 4² = 4² + 3² = 5²
    check(cone(DVec3::ZERO, 4.0, up(7.0), 3.0), [0.0, 3.0, 0.0], 5.0);
    check(cone(DVec3::ZERO, 3.0, up(7.0), 4.0), [0.0, 4.0, 0.0], 5.0);
    // a cylinder: 4 half-way up, 3² + 4² = 5²
    check(cone(DVec3::ZERO, 3.0, up(8.0), 3.0), [0.0, 4.0, 0.0], 5.0);
    // a tip 9 over a rim of 3: at 4 over the base both are 5 away
    check(cone(DVec3::ZERO, 3.0, up(9.0), 0.0), [0.0, 4.0, 0.0], 5.0);
}

#[test]
fn a_flat_cone_has_the_sphere_whose_equator_is_its_wider_rim() {
    let up = DVec3::new(0.0, 1.0, 0.0);
    // radii 4 and 3, 1 apart: the apex's rim lies √(1 + 9) = 3.16 from the middle of the base
    check(cone(DVec3::ZERO, 4.0, up, 3.0), [0.0; 3], 4.0);
    check(cone(DVec3::ZERO, 3.0, up, 4.0), [0.0, 1.0, 0.0], 4.0);
    check(cone(DVec3::ZERO, 3.0, up, 0.0), [0.0; 3], 3.0);
}

/// The center of the sphere through some points in their own plane: c with 2e·c = |e|² for each edge e
/// from the first, by Cramer's rule; a plane's and a line's points get edges across them.
fn center_through(points: &[DVec3]) -> DVec3 {
    let first = points[0];
    let mut edges: Vec<_> = points[1..].iter().map(|&p| p - first).collect();
    let squares: Vec<_> = edges.iter().map(|e| 0.5 * e.length_squared()).collect();
    if edges.len() == 1 {
        edges.push(edges[0].any_orthogonal_vector());
    }
    if edges.len() == 2 {
        edges.push(edges[0].cross(edges[1]));
    }
    let right = DVec3::from([0, 1, 2].map(|i| squares.get(i).copied().unwrap_or(0.0)));
    let rows = DMat3::from_cols(edges[0], edges[1], edges[2]).transpose();
    first + rows.inverse() * right
}

/// The smallest of all spheres that two, three or four of the points settle and that hold all.
fn smallest_by_trying_all(points: &[DVec3]) -> f64 {
    let mut smallest = f64::INFINITY;
    for choice in 1_u32..1 << points.len() {
        if !(2..=4).contains(&choice.count_ones()) {
            continue;
        }
        let chosen: Vec<_> = (0..points.len())
            .filter(|i| choice >> i & 1 == 1)
            .map(|i| points[i])
            .collect();
        let center = center_through(&chosen);
        let radius = center.distance(chosen[0]);
        let holds = |p: &DVec3| p.distance(center) <= radius * (1.0 + 1e-9);
        if points.iter().all(holds) && radius < smallest {
            smallest = radius;
        }
    }
    smallest
}

#[test]
fn the_sphere_around_a_few_points_is_the_smallest_of_all_that_can_be_tried() {
    let mut random = Seeded::new(3);
    for round in 0..400 {
        let count = 3 + random.index(8);
        let flatness = [1.0, 1e-3, 1e-7][round % 3];
        let stretch = DVec3::new(1.0, 1.0, flatness);
        let points: Vec<_> = (0..count).map(|_| random.point(5.0) * stretch).collect();
        let expected = smallest_by_trying_all(&points);
        let found = sphere_around(mesh_of(&points)).radius;
        assert!(
            (found - expected).abs() <= ROOM,
            "{found}, expected {expected}: {points:?}"
        );
    }
}

#[test]
fn many_points_on_a_sphere_have_that_sphere() {
    // on its equator at least, three points at 120°: no smaller sphere holds them
    let mut random = Seeded::new(4);
    let center = DVec3::new(1.0, -2.0, 0.5);
    let mut points: Vec<_> = (0..20_000)
        .map(|_| center + 2.0 * random.direction())
        .collect();
    for (x, y) in [
        (1.0, 0.0),
        (-0.5, 0.75_f64.sqrt()),
        (-0.5, -0.75_f64.sqrt()),
    ] {
        points.push(center + 2.0 * DVec3::new(x, y, 0.0));
    }
    let found = sphere_around(mesh_of(&points));
    assert!((found.radius - 2.0).abs() <= ROOM, "{found:?}");
    assert!(found.center.distance(center) <= 1e-6, "{found:?}");
}

#[test]
fn repeated_vertices_and_faces_in_one_plane_change_nothing() {
    let mut random = Seeded::new(5);
    for _ in 0..100 {
        let vertices = outline(&mut random, 7, 0.3);
        let alone = sphere_around(polygon(&vertices));
        let fan: Vec<_> = (1..6)
            .map(|i| vec![vertices[0], vertices[i], vertices[i + 1]])
            .collect();
        let twice = sphere_around(mesh(&[fan.clone(), fan].concat()));
        assert!((alone.radius - twice.radius).abs() <= ROOM);
        let expected = smallest_by_trying_all(&vertices);
        assert!((alone.radius - expected).abs() <= ROOM);
    }
}
