//! The z-aligned search finds what the exhaustive one finds: the same object, at the same t within nine digits.

mod events;
mod hard_rays;

use std::path::Path;

use glam::DVec3;
use raystep::geometry::{
    AlignedRay, Alignment, AxisBox, Ellipsoid, Polygon, Ray, Sides, Sphere, TRange,
};
use raystep::scene::{Primitive, Shape};
use raystep::strategy::{Exhaustive, Hit, Strategy, ZAligned};
use raystep::{NoFiles, Off, Scene, load, load_bytes};

use crate::seeded::Seeded;
use crate::z_aligned::hard_rays::{ray, shape};

/// The digits in which both searches agree on t: the design's own bound.
const T: f64 = 1e-9;
/// Rows of a rotation, and what it makes of unit vectors: some eight roundings.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A scene of these shapes, all of one object.
fn scene(shapes: Vec<(Shape, Sides)>) -> Scene {
    let text = br#"{
      "camera": { "look_at": { "cop": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 },
                  "pixels": [1, 1] },
      "background": [0, 0, 0], "ambient": [0, 0, 0],
      "materials": { "m": { "colour": [1, 1, 1] } },
      "objects": [ { "name": "A", "material": "m", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } } ]
    }"#;
    let loaded = load_bytes("shapes.json", text, &NoFiles).unwrap();
    let mut scene = loaded.build().unwrap();
    let primitive = |(shape, sides)| Primitive {
        shape,
        object: 0,
        sides,
    };
    scene.primitives = shapes.into_iter().map(primitive).collect();
    scene
}

fn both_sides(shapes: Vec<Shape>) -> Scene {
    scene(
        shapes
            .into_iter()
            .map(|shape| (shape, Sides::Both))
            .collect(),
    )
}

/// Holds one ray's nearest hit against that of the exhaustive search, and returns that.
#[track_caller]
fn check(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
    let expected = Exhaustive::new(scene).nearest(ray, range, &mut Off);
    let found = ZAligned::new(scene).nearest(ray, range, &mut Off);
    let context = || {
        let shape = |hit: Option<Hit>| hit.map(|hit| &scene.primitive(hit.object).shape);
        format!(
            "{ray:?} {range:?}\nfound {found:?} {:?}\nexpected {expected:?} {:?}",
            shape(found),
            shape(expected)
        )
    };
    match (found, expected) {
        (None, None) => {}
        (Some(found), Some(expected)) => {
            let off = (found.t - expected.t).abs();
            assert!(off <= T * expected.t, "t is {off:e} off\n{}", context());
            assert_eq!(found.object, expected.object, "{}", context());
        }
        _ => panic!("one of them hits\n{}", context()),
    }
    expected
}

#[test]
fn a_ray_along_3_4_5_is_turned_as_on_paper() {
    let ray = Ray::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.6, 0.0, 0.8));
    let frame = Alignment::of(&ray);
    assert_eq!(frame.x, DVec3::Y);
    assert_eq!(frame.y, DVec3::new(-0.8, 0.0, 0.6));
    assert_eq!(frame.z, ray.direction);
    // the ray's own points: o, and o + 5Δ = (4, 2, 7)
    assert_eq!(frame.point(ray.origin), DVec3::ZERO);
    let five = frame.point(DVec3::new(4.0, 2.0, 7.0));
    assert!((five - 5.0 * DVec3::Z).length() <= 5.0 * ROUNDING, "{five}");
    // (5, 3, 0) − o = (4, 1, −3): x′ = 1, y′ = −3.2 − 1.8, z′ = 2.4 − 2.4
    let aside = frame.point(DVec3::new(5.0, 3.0, 0.0));
    let expected = DVec3::new(1.0, -5.0, 0.0);
    assert!((aside - expected).length() <= 5.0 * ROUNDING, "{aside}");
    let back = frame.back(DVec3::new(0.0, 0.0, 5.0)) - DVec3::new(4.0, 2.0, 7.0);
    assert!(back.length() <= 5.0 * ROUNDING, "{back}");
}

/// Rows of unit length, at right angles, right-handed; the direction comes to z and every point back.
#[track_caller]
fn check_frame(ray: &Ray, points: [DVec3; 2]) {
    let frame = Alignment::of(ray);
    let rows = [frame.x, frame.y, frame.z];
    for (i, &row) in rows.iter().enumerate() {
        for (j, &other) in rows.iter().enumerate() {
            let identity = if i == j { 1.0 } else { 0.0 };
            let off = (row.dot(other) - identity).abs();
            assert!(off <= ROUNDING, "{ray:?}: rows {i} and {j}: {off:e}");
        }
    }
    let handed = frame.x.cross(frame.y) - frame.z;
    assert!(handed.length() <= ROUNDING, "{ray:?}: {handed}");
    let z = frame.vector(ray.direction.normalize()) - DVec3::Z;
    assert!(z.length() <= ROUNDING, "{ray:?}: {z}");
    for point in points {
        let off = (frame.back(frame.point(point)) - point).length();
        let size = point.length() + ray.origin.length();
        assert!(
            off <= 4.0 * ROUNDING * size,
            "{ray:?}: {point} is {off:e} off"
        );
    }
}

#[test]
fn the_rotation_is_orthonormal_for_every_direction() {
    let mut seeded = Seeded::new(1);
    for _ in 0..100_000 {
        let points = [seeded.point(10.0), seeded.point(10.0)];
        let mut direction = seeded.direction();
        // close to an axis, and exactly across one
        if seeded.index(2) == 0 {
            let flat = seeded.power(-100.0, 0.0);
            direction[seeded.index(3)] *= flat;
            direction[seeded.index(3)] *= flat;
            direction = direction.normalize();
        }
        if seeded.index(4) == 0 {
            direction[seeded.index(3)] = 0.0 * seeded.sign();
            direction = direction.normalize();
        }
        check_frame(&Ray::new(seeded.point(10.0), direction), points);
        let length = seeded.power(-30.0, 30.0);
        check_frame(&Ray::new(seeded.point(10.0), length * direction), points);
    }
}

#[test]
fn every_shape_is_met_where_the_exhaustive_search_meets_it() {
    let mut seeded = Seeded::new(2);
    let mut hits = 0;
    for _ in 0..400 {
        let shapes = (0..20).map(|_| {
            let sides = [Sides::Both, Sides::Both, Sides::Front, Sides::Back];
            (shape(&mut seeded), sides[seeded.index(4)])
        });
        let scene = scene(shapes.collect());
        for _ in 0..400 {
            let ray = ray(&scene, &mut seeded);
            let Some(hit) = check(&scene, &ray, TRange::FORWARD) else {
                continue;
            };
            hits += 1;
            // and on from there, as a ray that is sent on: it starts on a surface
            let point = ray.at(hit.t);
            let range = TRange {
                min: 1e-9 * point.abs().max_element().max(hit.t),
                ..TRange::FORWARD
            };
            let on = [seeded.direction(), ray.direction.normalize()][seeded.index(2)];
            check(&scene, &Ray::new(point, on), range);
        }
    }
    assert!(60_000 < hits, "only {hits} hits");
}

#[test]
fn a_mesh_is_met_in_the_same_face_also_exactly_through_vertices_and_edges() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/nff/tetra-3.nff");
    let tetra = load(&path).unwrap().build().unwrap();
    for scene in [tetra, bumpy_field()] {
        let corners: Vec<Vec<DVec3>> = scene
            .primitives
            .iter()
            .filter_map(|primitive| match &primitive.shape {
                Shape::Polygon(polygon) => Some(polygon.vertices().collect()),
                _ => None,
            })
            .collect();
        let mut seeded = Seeded::new(3);
        let mut hits = 0;
        for _ in 0..30_000 {
            let face = &corners[seeded.index(corners.len())];
            let at = seeded.index(face.len());
            let along = [0.0, 0.5, 0.25, seeded.unit()][seeded.index(4)];
            let target = face[at] + along * (face[(at + 1) % face.len()] - face[at]);
            let ray = match seeded.index(3) {
                // down an axis through a vertex: exact in both frames
                0 => {
                    let axis = DVec3::AXES[seeded.index(3)] * seeded.sign();
                    Ray::new(target - 4.0 * axis, axis)
                }
                1 => Ray::through(seeded.point(6.0), target),
                _ => {
                    Ray::through(seeded.point(6.0), target)
                        .normalised()
                        .unwrap()
                        .0
                }
            };
            let expected = check(&scene, &ray, TRange::FORWARD);
            let found = ZAligned::new(&scene).nearest(&ray, TRange::FORWARD, &mut Off);
            assert_eq!(found, expected, "{ray:?}");
            hits += usize::from(expected.is_some());
        }
        assert!(20_000 < hits, "{}: only {hits} hits", scene.name);
    }
}

/// A field of 8 × 8 quadrilaterals, each two triangles, over whole x and z: rays along the axes meet its
/// vertices exactly.
fn bumpy_field() -> Scene {
    let height = |x: i32, z: i32| 0.25 * f64::from((3 * x + 5 * z + x * z).rem_euclid(4));
    let corner = |x: i32, z: i32| DVec3::new(f64::from(x), height(x, z), f64::from(z));
    let mut shapes = Vec::new();
    for (x, z) in (-4..4).flat_map(|x| (-4..4).map(move |z| (x, z))) {
        let [a, b, c, d] = [(0, 0), (0, 1), (1, 1), (1, 0)].map(|(i, k)| corner(x + i, z + k));
        for triangle in [[a, b, c], [a, c, d]] {
            shapes.push(Shape::Polygon(
                Polygon::new(triangle.to_vec(), None).unwrap(),
            ));
        }
    }
    both_sides(shapes)
}

#[test]
fn a_huge_sphere_close_by_keeps_its_digits() {
    // its top lies 1 below; its center is 10⁹ away, and rounded there by 10⁻⁷ in another frame
    let earth = Sphere {
        center: DVec3::new(0.0, -1e9, 0.0),
        radius: 1e9 - 1.0,
    };
    let scene = both_sides(vec![Shape::Sphere(earth)]);
    let direction = DVec3::new(0.48, -0.6, 0.64);
    check(&scene, &Ray::new(DVec3::ZERO, direction), TRange::FORWARD).unwrap();
}

#[test]
fn a_ray_in_the_face_of_a_box_is_inside_of_it_in_both_frames() {
    let solid = AxisBox {
        min: DVec3::splat(0.1),
        max: DVec3::splat(0.7),
    };
    let scene = both_sides(vec![Shape::Box(solid)]);
    for z in [0.1, 0.7] {
        let ray = Ray::new(
            DVec3::new(-1.0, -1.0, z),
            DVec3::new(0.8, 0.6, 0.0).normalize(),
        );
        let found = check(&scene, &ray, TRange::FORWARD);
        // y ≥ 0.1 from t = 1.1/0.6 on
        let expected = 1.1 / 0.6;
        assert!((found.unwrap().t - expected).abs() <= 1e-14, "{found:?}");
    }
}

#[test]
fn the_aligned_ray_of_any_length_is_met_at_its_own_t() {
    let ball = Sphere {
        center: DVec3::new(6.0, 1.0, 8.0),
        radius: 1.0,
    };
    // grazes the ball at z = 10, which is 2 of its lengths
    let ray = AlignedRay::new(&Ray::new(
        DVec3::new(0.0, 0.5, 0.0),
        DVec3::new(3.0, 0.0, 4.0),
    ));
    let test = ball.test_aligned(&ray, TRange::FORWARD, Sides::Both);
    // c′ = (½, 0, 10): z = 10 − √(1 − ¼)
    let expected = (10.0 - 0.75_f64.sqrt()) / 5.0;
    let found = test.roots.chosen().unwrap();
    assert!((found - expected).abs() <= 10.0 * ROUNDING, "{found}");
    assert_eq!(test.a, 25.0);
}

#[test]
fn hits_of_two_objects_may_change_places_only_where_they_are_one_but_for_rounding() {
    // a ball told twice: as a sphere, and as an ellipsoid whose t is rounded otherwise
    let (center, radius) = (DVec3::new(0.1, -0.3, 0.7), 1.3);
    let radii = DVec3::splat(radius);
    let ball = Shape::Sphere(Sphere { center, radius });
    let scene = both_sides(vec![ball, Shape::Ellipsoid(Ellipsoid { center, radii })]);
    let mut seeded = Seeded::new(5);
    for _ in 0..1000 {
        let aim = center + 0.9 * radius * seeded.direction();
        let ray = Ray::through(seeded.point(20.0), aim)
            .normalised()
            .unwrap()
            .0;
        let nearest = |found: Option<Hit>| found.unwrap().t;
        let expected = nearest(Exhaustive::new(&scene).nearest(&ray, TRange::FORWARD, &mut Off));
        let found = nearest(ZAligned::new(&scene).nearest(&ray, TRange::FORWARD, &mut Off));
        assert!((found - expected).abs() <= T * expected, "{ray:?}");
    }
}
