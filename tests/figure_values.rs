//! The values in figures by another way than the program's: from the coordinates in the scene files and the textbook's
//! equations.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

use glam::{DVec2, DVec3};
use raystep::scene::Camera;
use raystep::{Event, Traced};

use crate::figure_numbers::{all, digits, drawn, has};
use crate::figures::{figure, texts_of_drawn};

/// The number, rounded to `count` significant digits, as a figure writes it.
fn significant(value: f64, count: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let before = value.abs().log10().floor() as i32 + 1;
    digits(value, (count - before).max(0) as usize)
}

fn four(value: f64) -> String {
    significant(value, 4)
}

/// The eye ray through the centre of a pixel, with a direction of length 1.
fn eye_ray(camera: &Camera, [x, y]: [u32; 2]) -> (DVec3, DVec3) {
    let [width, height] = camera.pixels.map(f64::from);
    let u = (f64::from(x) + 0.5) / width;
    let v = 1.0 - (f64::from(y) + 0.5) / height;
    let along = camera.to_corner + u * camera.right + v * camera.up;
    (camera.cop, along / along.length())
}

#[track_caller]
fn has_all(texts: &[String], parts: &[&str]) {
    for part in parts {
        has(texts, part);
    }
}

#[test]
fn the_line_of_t_has_the_points_and_both_parameters() {
    let (_, texts) = drawn("03-ray/line-of-t");
    // (1, 0, 6) + t·(2, 1, −2) at −1, 1 and 3; |Δ| = √(4 + 1 + 4) = 3, so t is three times as large when Δ is divided by it
    has_all(
        &texts,
        &[
            "(x, y, z) = (1, 0, 6) + t·(2, 1, −2)",
            "(−1, −1, 8)",
            "pixel centre (3, 1, 4)",
            "hit (7, 3, 0)",
            "|Δ| = 3",
        ],
    );
    for t in ["−1", "1", "−3", "3", "9"] {
        assert!(texts.iter().any(|text| text == t), "{t}: {texts:?}");
    }
}

#[test]
fn the_pinhole_is_as_far_from_the_window_as_from_the_negative() {
    let (_, texts) = drawn("01-pinhole/pinhole-side");
    // the window's corner (0.624, −0.72, −2.032) from the COP; (1.152, 0, 0.864) and (0, 1, 0) span it, so its unit
    // normal is (0.6, 0, −0.8): 0.6·0.624 + 0.8·2.032 = 2
    assert_eq!(texts.iter().filter(|text| *text == "2").count(), 2);
}

/// The sphere of a figure: b, c, the discriminant, the vertex of the parabola, d and the roots.
#[track_caller]
fn check_sphere(name: &str, pixel: [u32; 2], (center, r): (DVec3, f64)) {
    let (traced, texts) = drawn(name);
    let (origin, along) = eye_ray(&traced[0].scene.camera, pixel);
    let from = origin - center;
    let (b, c) = (2.0 * along.dot(from), from.length_squared() - r * r);
    let nearest = -0.5 * b;
    let d = (from + nearest * along).length();
    let discriminant = 4.0 * (r * r - d * d);
    // beside 16 and 10 these are rounding
    let is_zero = discriminant.abs() < 1e-9;
    let discriminant = if is_zero { 0.0 } else { discriminant };
    has(&texts, &format!("discriminant {}", four(discriminant)));
    has(&texts, &format!("{}t", four(b).trim_start_matches('−')));
    has(&texts, four(c).trim_start_matches('−'));
    if is_zero {
        has(&texts, &format!("t1 = t2 = {}", four(nearest)));
        has(&texts, "d = r");
        return;
    }
    let lowest = nearest * nearest + b * nearest + c;
    has(
        &texts,
        &format!("vertex ({}, {})", four(nearest), four(lowest)),
    );
    if discriminant < 0.0 {
        has(&texts, &format!("d = {} > r", four(d)));
        return;
    }
    let half = 0.5 * discriminant.sqrt();
    has(&texts, &format!("t1 = {}", four(nearest - half)));
    has(&texts, &format!("t2 = {}", four(nearest + half)));
}

#[test]
fn the_spheres_have_the_roots_of_the_triangle_of_centre_foot_and_hit() {
    let apart = (DVec3::new(4.0, 0.0, 1.5), 1.5);
    check_sphere("04-sphere/no-root", [13, 15], apart);
    check_sphere("04-sphere/graze", [20, 15], apart);
    check_sphere("04-sphere/two-roots", [38, 15], apart);
    let around = (DVec3::new(2.0, 0.0, 0.0), 2.0);
    check_sphere("04-sphere/inside", [20, 15], around);
    let (_, texts) = drawn("04-sphere/normal");
    // (4.4 − 6, 0, 0 − 1.2)/2, and 0.64 + 0.36 = 1
    has_all(&texts, &["N = (−0.8, 0, −0.6)", "|N| = 1"]);
}

#[test]
fn an_ellipsoid_has_the_roots_worked_out_by_hand_in_the_unit_sphere() {
    let (_, texts) = drawn("04-sphere/stretched");
    // (−4, 2.4) and (0.8, −0.6) by the radii 2 and 1: (−2, 2.4) and (0.4, −0.6); a = 0.16 + 0.36,
    // b = 2(−0.8 − 1.44), c = 4 + 5.76 − 1; D = 20.0704 − 18.2208 = 1.36²
    has_all(
        &texts,
        &["|Δ| = 1", "a = |Δ′|2 = 0.52", "b = −4.48", "c = 8.76"],
    );
    has(&texts, &format!("|Δ′| = {}", four(0.52f64.sqrt())));
    // (4.48 − 1.36)/1.04 and (4.48 + 1.36)/1.04, and 20.0704 − 35.04 < 0
    let far = four(5.84 / 1.04);
    has(&texts, &format!("t1 = 3, t2 = {far} in both spaces"));
    has(&texts, "b2 − 4c = −14.97, no root");
}

#[test]
fn the_shade_is_the_sum_of_the_terms_worked_out_by_hand() {
    let (_, texts) = drawn("05-shading/phong");
    // N = (0, 1, 0) at (0, 1, 0), L = (3, 4, 0)/5, V = (−4, 3, 0)/5, R = (−3, 4, 0)/5: N·L = 0.8, R·V = (12 + 12)/25
    let angles = [0.8f64, 0.96].map(|cosine| digits(cosine.acos().to_degrees(), 2));
    has(&texts, &format!("θ = {}°", angles[0]));
    has(&texts, &format!("α = {}°", angles[1]));
    has_all(
        &texts,
        &[
            "= 1·(0.9, 0.3, 0.2)·0.5·0.8",
            "= (0.36, 0.12, 0.08)",
            "cos α = 0.96",
            "= 0.2304",
            "(0.18, 0.06, 0.04)",
            // 0.18 + 0.36 + 0.2304, 0.06 + 0.12 + 0.2304, 0.04 + 0.08 + 0.2304
            "(0.7704, 0.4104, 0.3504)",
        ],
    );
}

const POLYGON: [[f64; 3]; 5] = [
    [1.0, 2.53, 1.2],
    [3.4, 3.17, 0.8],
    [4.6, 3.38, 1.7],
    [3.4, 2.85, 4.0],
    [1.4, 2.41, 3.4],
];
const CONCAVE: [[f64; 3]; 8] = [
    [1.0, 2.57, 0.8],
    [4.8, 3.52, 0.8],
    [4.8, 3.24, 3.6],
    [3.5, 2.885, 3.9],
    [3.5, 3.065, 2.1],
    [2.4, 2.79, 2.1],
    [2.4, 2.59, 4.1],
    [1.0, 2.27, 3.8],
];

/// The plane by a cross product of two edges, and inside by the angles under which p′ sees the edges: they add up to a turn.
#[track_caller]
fn check_polygon(name: &str, pixel: [u32; 2], corners: &[[f64; 3]]) {
    let (traced, texts) = drawn(name);
    let (origin, along) = eye_ray(&traced[0].scene.camera, pixel);
    let corners: Vec<DVec3> = corners.iter().map(|at| DVec3::from(*at)).collect();
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let normal = normal.normalize();
    let [a, b, c] = normal.abs().to_array().map(four);
    has(&texts, &format!("|A|, |B|, |C| = {a}, {b}, {c}"));
    let p = origin + (corners[0] - origin).dot(normal) / along.dot(normal) * along;
    let seen: Vec<DVec2> = corners
        .iter()
        .map(|at| DVec2::new(at.x - p.x, at.z - p.z))
        .collect();
    let next = seen.iter().cycle().skip(1);
    let turn: f64 = seen.iter().zip(next).map(|(a, b)| a.angle_to(*b)).sum();
    let is_inside = PI < turn.abs();
    has(
        &texts,
        if is_inside {
            "odd: inside"
        } else {
            "even: outside"
        },
    );
}

#[test]
fn the_polygons_have_the_coefficients_and_sides_of_another_method() {
    check_polygon("06-polygon/inside", [32, 24], &POLYGON);
    check_polygon("06-polygon/outside", [22, 36], &POLYGON);
    check_polygon("06-polygon/concave", [30, 22], &CONCAVE);
    let (_, texts) = drawn("06-polygon/parallel");
    // the COP is at y = 2.4, the polygon at y = 1
    has(&texts, "A·x0 + B·y0 + C·z0 + D = 1.4");
}

#[test]
fn angles_follow_from_the_law_of_reflection_and_from_snells_law() {
    let (_, texts) = drawn("07-reflection-refraction/reflection");
    // the ray falls 3 on 4 to the side: the sine of its angle to N is 0.8
    let angle = format!("{}°", digits(0.8f64.asin().to_degrees(), 2));
    assert_eq!(texts.iter().filter(|text| **text == angle).count(), 2);

    let (_, texts) = drawn("07-reflection-refraction/refraction");
    let (before, after) = (60f64.to_radians(), (60f64.to_radians().sin() / 1.5).asin());
    let angle = digits(after.to_degrees(), 2);
    has(&texts, &format!("1·sin 60° = 1.5·sin {angle}°"));
    // the glass is 1.7 thick
    let offset = 1.7 * (before - after).sin() / after.cos();
    has(&texts, &format!("offset {}", four(offset)));

    let (_, texts) = drawn("07-reflection-refraction/total-internal-reflection");
    let after = (45f64.to_radians().sin() / 1.5).asin().to_degrees();
    let (after, below) = (digits(after, 2), digits(90.0 - after, 2));
    let critical = digits((1f64 / 1.5).asin().to_degrees(), 2);
    has(&texts, &format!("1·sin 45° = 1.5·sin {after}°"));
    has(&texts, &format!("{below}° > critical angle {critical}°"));
}

/// Of the points of an outline in x and y the slabs across (1, 0), (0, 1), (1, −1) and (1, 1): [D_min, D_max] with
/// D = −n·v.
fn slabs_around(points: &[[f64; 2]]) -> [[f64; 2]; 4] {
    let h = FRAC_1_SQRT_2;
    NORMALS.map(|n| {
        let n = if n[1] == 0.0 || n[0] == 0.0 {
            DVec2::from(n)
        } else {
            h * DVec2::from(n)
        };
        let all = points.iter().map(|at| -n.dot(DVec2::from(*at)));
        let ends = |(least, most): (f64, f64), d: f64| (least.min(d), most.max(d));
        let (least, most) = all.fold((f64::INFINITY, f64::NEG_INFINITY), ends);
        [least, most]
    })
}

const NORMALS: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]];
/// The outline of the shape in three slab figures.
const SHAPE: [[f64; 2]; 7] = [
    [-1.6, -0.7],
    [0.3, -1.2],
    [1.7, -0.3],
    [0.8, 0.1],
    [1.0, 1.1],
    [-0.2, 0.5],
    [-0.65, 1.1],
];

#[test]
fn slabs_and_their_terms_are_those_of_the_corners() {
    let (_, texts) = drawn("10-bounds/slabs");
    let (traced, terms) = drawn("10-bounds/slab-terms");
    let (origin, along) = eye_ray(&traced[0].scene.camera, [20, 15]);
    for (n, ends) in NORMALS.iter().zip(slabs_around(&SHAPE)) {
        let n = DVec2::from(*n).normalize();
        let s = n.dot(origin.truncate());
        let scale = -1.0 / n.dot(along.truncate());
        let [a, b] = ends.map(|d| (s + d) * scale);
        for d in ends {
            has(&texts, &four(d));
        }
        for value in [ends[0], ends[1], s, scale, a, b] {
            has(&terms, &four(value));
        }
    }
    has(&texts, "−Dmin = 1.7");
}

/// What the rows of the interval figures say, up to the slab that makes the interval empty.
#[track_caller]
fn check_intervals(name: &str) {
    let (traced, texts) = drawn(name);
    let (origin, along) = eye_ray(&traced[0].scene.camera, [20, 15]);
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for (n, ends) in NORMALS.iter().zip(slabs_around(&SHAPE)) {
        let n = DVec2::from(*n).normalize();
        let at = ends.map(|d| -(n.dot(origin.truncate()) + d) / n.dot(along.truncate()));
        let (enters, leaves) = (at[0].min(at[1]), at[0].max(at[1]));
        has(&texts, &four(enters));
        has(&texts, &four(leaves));
        (near, far) = (near.max(enters), far.min(leaves));
        if far < near {
            break;
        }
    }
    has(&texts, &format!("max near {}", four(near)));
    has(&texts, &format!("min far {}", four(far)));
    let is_null = texts.iter().any(|text| text.contains("null"));
    assert_eq!(is_null, far < near);
}

#[test]
fn intervals_are_those_of_the_lines_through_the_corners() {
    check_intervals("10-bounds/intervals");
    check_intervals("10-bounds/null");
    check_intervals("10-bounds/starts-inside");
}

#[test]
fn the_joined_bound_has_the_extremes_of_both_shapes() {
    let (_, texts) = drawn("10-bounds/merge");
    let b = [
        [-2.6, 0.6],
        [-1.4, 0.2],
        [-0.2, 0.7],
        [-0.7, 1.9],
        [-1.9, 2.1],
    ];
    let a = [
        [0.4, -1.9],
        [1.9, -2.1],
        [2.5, -0.9],
        [1.8, 0.4],
        [0.9, -0.5],
    ];
    for shape in [a, b] {
        for d in slabs_around(&shape).concat() {
            has(&texts, &four(d));
        }
    }
}

#[test]
fn the_sort_by_z_has_the_roots_in_world_coordinates() {
    let (_, texts) = drawn("10-bounds/alignment");
    // (1, 0, 1) + t·(0.6, 0, 0.8); the ellipsoid stretched into a ball of radius 1, the box entered across z = 4.4
    let root = |from: [f64; 2], along: [f64; 2], r: f64| {
        let (from, along) = (DVec2::from(from), DVec2::from(along));
        let (a, half_b) = (along.length_squared(), along.dot(from));
        let c = from.length_squared() - r * r;
        (-half_b - (half_b * half_b - a * c).sqrt()) / a
    };
    let c = root([-1.8 / 1.1, -1.9 / 0.5], [0.6 / 1.1, 0.8 / 0.5], 1.0);
    let a = root([-5.3, -6.3], [0.6, 0.8], 1.0);
    has(&texts, &format!("z = {}", four(c)));
    has(&texts, &format!("z = {}", four((4.4 - 1.0) / 0.8)));
    has(&texts, &format!("z = {}", four(a)));
    let [x, z] = [0.6, 0.8].map(|along| four(1.0 + c * along));
    has(&texts, &format!("({x}, 0, {z})"));
}

#[test]
fn the_empty_part_of_a_volume_is_that_of_the_areas() {
    let (_, texts) = drawn("10-bounds/volumes");
    // a pencil from above: a rectangle of √19.602 by √1.0125, and a triangle on its end that is √1.9845 high
    let pencil = (19.602f64 * 1.0125).sqrt() + 0.5 * (1.0125f64 * 1.9845).sqrt();
    let rectangle: f64 = 5.445 * 3.06;
    // x + z ends at 1.395 and −1.935 in place of 4.41 and −4.095, z − x at 4.005 in place of 4.455: three corners off
    let corners = [4.41 - 1.395, 4.095 - 1.935, 4.455 - 4.005].map(|h: f64| 0.5 * h * h);
    let slabs = rectangle - corners.iter().sum::<f64>();
    for area in [rectangle, slabs] {
        let empty = 100.0 * (1.0 - pencil / area);
        has(&texts, &format!("{empty:.0} % empty"));
    }
}

/// Where a ray in the plane y = 0 enters a box around boxes [x min, x max, z min, z max].
fn enters(camera: &Camera, pixel: [u32; 2], boxes: &[[f64; 4]]) -> f64 {
    let (origin, along) = eye_ray(camera, pixel);
    assert_eq!(along.y, 0.0);
    let extreme = |place: usize, of: fn(f64, f64) -> f64| {
        boxes.iter().map(|of| of[place]).reduce(of).unwrap()
    };
    let [x0, x1] = [extreme(0, f64::min), extreme(1, f64::max)];
    let [z0, z1] = [extreme(2, f64::min), extreme(3, f64::max)];
    let across = |from: f64, along: f64, ends: [f64; 2]| {
        let [a, b] = ends.map(|end| (end - from) / along);
        [a.min(b), a.max(b)]
    };
    let z = across(origin.z, along.z, [z0, z1]);
    let x = if along.x == 0.0 {
        [f64::NEG_INFINITY, f64::INFINITY]
    } else {
        across(origin.x, along.x, [x0, x1])
    };
    let (near, far) = (x[0].max(z[0]), x[1].min(z[1]));
    assert!(near <= far, "the ray misses {boxes:?}");
    near
}

#[test]
fn a_node_begins_where_the_ray_enters_the_box_around_its_objects() {
    // the objects of 11-hierarchy/scene.json, as rectangles in x and z
    let a = [-3.6, -2.4, 2.3, 3.5];
    let b = [-2.2, -1.3, 1.3, 2.2];
    let c = [-4.2, -2.8, -3.9, -2.5];
    let d = [-2.7, -1.7, -2.2, -1.2];
    let e = [0.1, 1.7, -3.1, -1.5];
    let f = [1.9, 3.3, -1.7, -0.3];
    let g = [1.35, 2.55, 2.0, 3.2];
    let h = [2.8, 4.0, 1.0, 2.2];
    let (traced, texts) = drawn("11-hierarchy/tree");
    let camera = &traced[0].scene.camera;
    let at = |boxes: &[[f64; 4]]| significant(enters(camera, [26, 15], boxes), 3);
    let root = at(&[a, b, c, d, e, f, g, h]);
    assert_eq!(
        texts.iter().filter(|text| **text == root).count(),
        2,
        "{root}"
    );
    assert_eq!(at(&[a, b, g, h]), root);
    let upper = at(&[c, d, e, f]);
    assert_eq!(at(&[e, f]), upper);
    assert_eq!(at(&[f]), upper);
    assert_eq!(texts.iter().filter(|text| **text == upper).count(), 3);
    has(&texts, &at(&[g]));
    // the ball F: its center is 7 + 1 before the eye and 2.6 to the right, its radius 0.7
    let (_, along) = eye_ray(camera, [26, 15]);
    let nearest = along.dot(DVec3::new(2.6, 0.0, -8.0));
    let d2 = 2.6 * 2.6 + 64.0 - nearest * nearest;
    let hit = nearest - (0.49 - d2).sqrt();
    has(&texts, &format!("t = {}", significant(hit, 3)));

    let (traced, texts) = drawn("11-hierarchy/pruned");
    let camera = &traced[0].scene.camera;
    let at = |boxes: &[[f64; 4]]| significant(enters(camera, [13, 15], boxes), 3);
    for boxes in [&[a, b, g, h][..], &[a, b], &[b], &[c, d, e, f]] {
        has(&texts, &at(boxes));
    }
    // the box B is its own bound, and node 1 begins behind it
    has(&texts, &format!("t = {}", at(&[b])));
    has(&texts, &format!("t = {}", at(&[c, d, e, f])));
}

#[test]
fn the_keys_of_the_heap_are_distances_to_the_front_of_boxes() {
    // the ray runs down z from 7; a slanted rod with a radius of 0.2 reaches 0.2·sin 45° beyond its end
    let rod = |z: f64| 7.0 - (z + 0.2 * FRAC_1_SQRT_2);
    let key = |t: f64| significant(t, 3);
    // G in front of D, H, then C and A; I is the ball at the front of node 1
    let (g, d, h, a) = (key(rod(3.7)), key(rod(2.4)), key(rod(1.9)), key(rod(0.3)));
    let i = key(7.0 + 1.6 - 0.51);
    // D is cut along its axis at 45°: x = 0 is at z = 1.6 on the axis, and 0.2·√2 nearer on the surface
    let hit = key(7.0 - 1.6 - 0.2 * 2f64.sqrt());
    let (_, texts) = drawn("11-hierarchy/heap");
    let keys = [
        (0, &g),
        (2, &g),
        (7, &g),
        (10, &g),
        (13, &d),
        (8, &h),
        (9, &a),
        (1, &i),
    ];
    for (node, key) in keys {
        has(&texts, &format!("{node}: {key}"));
    }
    has(&texts, &format!("{hit} < {a}"));
    let (_, texts) = drawn("11-hierarchy/heap-tree");
    for key in [&g, &d, &h, &a, &i] {
        assert!(texts.contains(key), "{key}: {texts:?}");
    }
    has(&texts, &format!("t = {hit}"));
}

/// A ray along one axis of a grid: the size of a cell, where it starts, its direction, the planes that it crosses.
struct Along {
    cell: f64,
    from: f64,
    direction: f64,
    planes: [i32; 4],
}

impl Along {
    fn crossings(&self) -> [f64; 4] {
        let at = |plane: i32| (self.cell * f64::from(plane) - self.from) / self.direction;
        self.planes.map(at)
    }
}

#[test]
fn the_steps_through_a_grid_are_where_the_ray_crosses_its_planes() {
    // cells of 2.4 × 2.7, Δ = ±(0.8, −0.6): Δt is 2.4/0.8 and 2.7/0.6
    let along = |cell: f64, from: f64, direction: f64| Along {
        cell,
        from,
        direction,
        planes: if 0.0 < direction {
            [1, 2, 3, 4]
        } else {
            [3, 2, 1, 0]
        },
    };
    for (name, x, z, enters) in [
        (
            "12-grid/steps",
            along(2.4, -1.6, 0.8),
            along(2.7, 10.65, -0.6),
            "t = 2",
        ),
        (
            "12-grid/steps-back",
            along(2.4, 14.4, -0.8),
            along(2.7, -1.35, 0.6),
            "t = 6",
        ),
    ] {
        let (_, texts) = drawn(name);
        has_all(&texts, &["+ 3", "+ 4.5", enters]);
        for t in [x.crossings(), z.crossings()].concat() {
            let text = digits(t, 2);
            assert!(texts.contains(&text), "{name}: {text} {texts:?}");
        }
        // the grid is left across x
        let [.., leaves] = x.crossings();
        has(&texts, &format!("t = {}", digits(leaves, 2)));
    }
}

/// How many cells a ray passes up to its end, by looking where it is at very many t.
fn cells_passed(traced: &Traced) -> usize {
    const LOOKS: u32 = 400_000;
    let grid = all(&traced.records, |record| match record.event {
        Event::GridEnter(grid) => Some(grid),
        _ => None,
    })[0];
    // the eye ray alone
    let of_eye = |record: &&raystep::Record| record.ray == Some(0);
    let records: Vec<_> = traced.records.iter().filter(of_eye).copied().collect();
    let start = all(&records, |record| match record.event {
        Event::Ray(start) => Some(start.ray),
        _ => None,
    })[0];
    let end = all(&records, |record| match record.event {
        Event::RayEnd(end) => Some(end.t),
        _ => None,
    })[0];
    let [enters, leaves] = grid.inside.unwrap();
    let from = enters.max(0.0);
    let to = end.unwrap_or(leaves).min(leaves);
    let size = grid.around.max - grid.around.min;
    let mut cells = BTreeSet::new();
    for look in 0..LOOKS {
        let t = from + (to - from) * (f64::from(look) + 0.5) / f64::from(LOOKS);
        let share = (start.origin + t * start.direction - grid.around.min) / size;
        cells.insert([0, 1, 2].map(|axis| {
            let n = f64::from(grid.resolution[axis]);
            (share[axis] * n).floor() as i64
        }));
    }
    cells.len()
}

#[test]
fn a_walk_has_the_cells_that_lie_on_the_ray() {
    for (name, expected) in [
        ("12-grid/walk", 10),
        ("12-grid/outside-its-cell", 3),
        ("12-grid/mailbox", 5),
    ] {
        let (traced, texts) = drawn(name);
        assert_eq!(cells_passed(&traced[0]), expected, "{name}");
        let numbered = |number: usize| {
            let begins = |text: &String| {
                let rest = text.strip_prefix(&number.to_string());
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(':'))
            };
            texts.iter().any(begins)
        };
        assert!(numbered(expected) && !numbered(expected + 1), "{texts:?}");
    }
}

#[test]
fn coarse_cells_test_the_whole_teapot_and_fine_ones_take_a_cell_for_each_step() {
    for name in ["12-grid/stadium", "12-grid/resolutions"] {
        let (traced, texts) = drawn(name);
        for of in &traced {
            has(&texts, &format!("{} cells + ", cells_passed(of)));
        }
    }
    let (_, texts) = drawn("12-grid/stadium");
    // 37 pieces and the two stands at the corner that the ray's first cells touch
    has(&texts, "4 cells + 39 tests");
}

#[test]
fn an_irradiance_is_power_over_area() {
    let watts = |count: f64, power: f64, paths: f64| count * power / paths;
    // 100 W in 3000 paths on the disc, 60 W in 400 000 paths on a cell of 0.25 × 0.25
    for name in ["08-transport/hybrid-stored", "08-transport/caustic"] {
        let (traced, texts) = drawn(name);
        let gathered = all(&traced[0].records, |record| match record.event {
            Event::Gathered(gathered) => gathered.radius.map(|r| (gathered.count, r)),
            _ => None,
        });
        let (count, r) = gathered[0];
        let e = watts(f64::from(count), 100.0, 3000.0) / (PI * r * r);
        has(&texts, &format!("2r = {}", four(2.0 * r)));
        has(&texts, &format!("= {} W/m2", four(e)));
    }
    let (_, texts) = drawn("08-transport/map");
    let power = watts(174.0, 60.0, 400_000.0);
    has(&texts, "174 photons in the cell");
    has(
        &texts,
        &format!(
            "E = {} W / 0.0625 m2 = {} W/m2",
            four(power),
            four(power / 0.0625)
        ),
    );
}

#[test]
fn the_radius_of_the_disc_is_the_distance_of_the_20th_photon() {
    let (traced, texts) = drawn("08-transport/gather");
    let floor = |record: &raystep::Record| match record.event {
        Event::Stored(photon) if photon.point.y.abs() < 1e-9 => Some(photon.point),
        _ => None,
    };
    let p = all(&traced[0].records, |record| match record.event {
        Event::Gathered(gathered) => Some(gathered.point),
        _ => None,
    })[0];
    let mut distances: Vec<f64> = all(&traced[0].records, floor)
        .into_iter()
        .map(|at| at.distance(p))
        .collect();
    distances.sort_by(f64::total_cmp);
    let r = distances[19];
    has(&texts, &format!("r = {}", four(r)));
    let e = 19.0 * 100.0 / 3000.0 / (PI * r * r);
    has(&texts, &format!("= {} W/m2", four(e)));
}

#[test]
fn the_geometry_term_is_that_of_the_two_points() {
    let (traced, texts) = drawn("08-transport/hybrid-connected");
    let line = all(&traced[0].records, |record| match record.event {
        Event::Connection(of) if (of.light_vertex, of.eye_vertex) == (1, 1) => Some(of),
        _ => None,
    })[0];
    // from the floor, whose normal is y, to the front of B, whose normal is z
    let between = line.to - line.from;
    let d = between.length();
    let cosines = [between.y / d, -between.z / d].map(f64::abs);
    let g = cosines[0] * cosines[1] / (d * d);
    let [a, b] = cosines.map(four);
    has(&texts, &format!("= {a} · {b} / {}2 = {}", four(d), four(g)));
}

#[test]
fn the_pixels_that_a_mistake_changes_are_counted_from_the_pictures() {
    let gallery = crate::figures::traced().iter();
    let mut count = 0;
    for (name, ..) in gallery {
        let (spec, traced) = figure(&name.to_string());
        let of_pixels = &traced[0].of_pixels;
        let (Some(right), Some(mistake)) = (&of_pixels.picture, &of_pixels.mistake) else {
            continue;
        };
        count += 1;
        let texts = texts_of_drawn(spec, traced);
        let [x, y] = mistake.pixel;
        let Some(wrong) = &mistake.picture else {
            has(&texts, &format!("On a ray of pixel ({x}, {y})"));
            continue;
        };
        let pairs = right.rgb.chunks(3).zip(wrong.rgb.chunks(3));
        let differ: Vec<usize> = pairs
            .enumerate()
            .filter(|(_, (right, wrong))| right != wrong)
            .map(|(place, _)| place)
            .collect();
        let width = right.pixels[0] as usize;
        let first = [differ[0] % width, differ[0] / width];
        assert_eq!(first, mistake.pixel.map(|of| of as usize), "{name}");
        let number = differ.len();
        let number = match number {
            1000.. => format!("{} {:03}", number / 1000, number % 1000),
            _ => number.to_string(),
        };
        let pixels = right.rgb.len() / 3;
        let all = format!("{} {:03}", pixels / 1000, pixels % 1000);
        has(
            &texts,
            &format!("{number} of {all} pixels differ. In the first, ({x}, {y}):"),
        );
    }
    // each of the gallery, and the one of lesson 5
    assert_eq!(count, 61);
}
