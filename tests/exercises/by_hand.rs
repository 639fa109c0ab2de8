//! The expected answers of the exercises whose functions the crate itself does not have, worked out by hand.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use raystep::geometry::{Alignment, AxisBox, Ray};
use raystep::lesson::exercise::course;

const ROUNDED: f64 = 1e-14;

#[track_caller]
fn check(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= ROUNDED,
        "{found}, expected {expected}"
    );
}

#[test]
fn of_three_photons_the_two_nearest_count_over_the_disc_of_the_third() {
    let irradiance = course::IRRADIANCE.own;
    let three = [(3.0, 5.0), (1.0, 3.0), (2.0, 6.0)];
    // (3 + 6)/(π·3²); of the nearest two the first alone, over π·2²
    check(irradiance(&three, 3), 1.0 / PI);
    check(irradiance(&three, 2), 3.0 / (4.0 * PI));
    check(irradiance(&three, 99), 1.0 / PI);
    check(irradiance(&[], 3), 0.0);
}

#[test]
fn diffuse_directions_lie_above_their_points_of_the_disc() {
    let direction = course::DIFFUSE_DIRECTION.own;
    // u = 0 is the middle of the disc, u = 1 its rim, u = ½ lies below 45°
    assert!(direction(DVec3::Z, 0.0, 0.3).distance(DVec3::Z) <= ROUNDED);
    check(direction(DVec3::Y, 1.0, 0.3).dot(DVec3::Y), 0.0);
    check(direction(DVec3::X, 0.5, 0.9).dot(DVec3::X), 0.5f64.sqrt());
    check(direction(DVec3::X, 0.7, 0.2).length(), 1.0);
}

#[test]
fn the_geometry_term_of_surfaces_2_apart_is_a_quarter_and_0_where_one_faces_away() {
    let geometry = course::GEOMETRY_TERM.own;
    let above = DVec3::Y * 2.0;
    check(geometry(DVec3::ZERO, DVec3::Y, above, DVec3::NEG_Y), 0.25);
    check(geometry(DVec3::ZERO, DVec3::NEG_Y, above, DVec3::Y), 0.0);
    // 4/5 at either end, and 5² between
    let aslant = DVec3::new(3.0, 4.0, 0.0);
    check(
        geometry(DVec3::ZERO, DVec3::Y, aslant, DVec3::NEG_Y),
        0.64 / 25.0,
    );
}

#[test]
fn a_million_pixels_of_100_objects_are_100_million_tests() {
    let cost = course::COST.own;
    assert_eq!(cost([1024, 1024], 100, 0, 1), 104_857_600);
    // 10 000 eye rays and 2 · 5000 shadow rays
    assert_eq!(cost([100, 100], 10, 5000, 2), 200_000);
}

#[test]
fn the_smallest_z_in_front_is_the_hit_and_lies_on_the_ray() {
    let ray = Ray::new(DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.6, 0.0, 0.8));
    let (object, point) = (course::Z_SORT.own)(&Alignment::of(&ray), &[7.0, -1.0, 5.0]).unwrap();
    assert_eq!(object, 2);
    assert!(
        point.distance(DVec3::new(4.0, 0.0, 4.0)) <= ROUNDED,
        "{point}"
    );
}

#[test]
fn a_sphere_around_a_box_has_half_its_diagonal() {
    // 2, 3 and 6: the diagonal is 7
    let around = AxisBox::around([DVec3::ONE, DVec3::new(3.0, 4.0, 7.0)]);
    let sphere = (course::SPHERE_AROUND.own)(&around);
    assert_eq!(
        (sphere.center, sphere.radius),
        (DVec3::new(2.0, 2.5, 4.0), 3.5)
    );
}

#[test]
fn d_grows_backwards_along_the_normal() {
    let vertices = [DVec3::X, DVec3::X * 3.0, DVec3::new(2.0, 2.0, 0.0)];
    assert_eq!((course::SLAB_OF.own)(&vertices, DVec3::X), [-3.0, -1.0]);
    assert_eq!((course::SLAB_OF.own)(&vertices, DVec3::Y), [-2.0, 0.0]);
    let union = (course::UNION.own)(&[[0.0, 1.0], [2.0, 3.0]], &[[-1.0, 0.5], [2.5, 9.0]]);
    assert_eq!(union, [[-1.0, 1.0], [2.0, 9.0]]);
}

#[test]
fn a_cut_costs_a_node_and_the_objects_by_their_share_of_area() {
    // 1.5 + (4·2 + 6·3)/8
    check(
        (course::SPLIT_COST.own)(1.5, 8.0, [(4.0, 2), (6.0, 3)]),
        4.75,
    );
}

#[test]
fn an_outline_is_crossed_once_from_inside_and_a_vertex_counts_for_one_edge() {
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
    let crossings = course::CROSSINGS.own;
    assert_eq!(crossings(&square, DVec2::new(1.0, 1.0)), 1);
    assert_eq!(crossings(&square, DVec2::new(-1.0, 1.0)), 2);
    assert_eq!(crossings(&square, DVec2::new(3.0, 1.0)), 0);
    let rhombus = [[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]].map(DVec2::from);
    assert_eq!(crossings(&rhombus, DVec2::new(0.5, 0.0)), 1);
    assert_eq!(crossings(&rhombus, DVec2::new(-3.0, 0.0)), 2);
}

#[test]
fn cells_own_their_lower_faces_and_the_last_one_both() {
    let around = AxisBox::around([DVec3::ZERO, DVec3::splat(4.0)]);
    let cell = |x: f64| (course::CELL_OF.own)(&around, [4; 3], DVec3::new(x, 0.5, 2.5));
    assert_eq!(
        [cell(1.9), cell(2.0), cell(4.0)],
        [[1, 0, 2], [2, 0, 2], [3, 0, 2]]
    );
    let object = AxisBox::around([DVec3::new(-1.0, 1.2, 2.5), DVec3::new(0.5, 2.3, 9.0)]);
    let cells = (course::OBJECT_TO_CELLS.own)(&around, [4; 3], &object);
    assert_eq!(cells, [[0, 1, 2], [0, 2, 3]]);
    // from 2.5 to plane 2 at −1, to plane 3 at ½; never along z
    let ray = Ray::new(DVec3::splat(2.5), DVec3::new(-1.0, 0.5, 0.0));
    let planes = (course::FIRST_PLANES.own)(&around, [4; 3], &ray, [2; 3]);
    assert_eq!(planes, [[0.5, 1.0], [1.0, 2.0], [f64::INFINITY; 2]]);
    let next = |t, direction| (course::NEXT_CELL.own)([2, 0, 3], t, direction, [4; 3]);
    let aslant = DVec3::new(-1.0, -1.0, 1.0);
    assert_eq!(next([0.5, 1.0, 2.0], aslant), Some([1, 0, 3]));
    assert_eq!(next([2.0, 1.0, 3.0], aslant), None);
    assert_eq!(next([2.0, 1.5, 1.0], aslant), None);
}
