//! Cones, ellipsoids and spheres of whole numbers, and rays between whole points: every hit lies where exact
//! arithmetic says, on the surface and between the ends.
//!
//! Whole numbers make the rays that rounding is worst at: along a generator of a cone, in the plane that
//! touches it there, through its tip, along an edge of its ends. Then a, b or b² − 4ac is exactly 0, and what
//! is computed of it is rounding alone. The equations here are solved in whole numbers of 128 bits, so that it
//! is known which of them are 0.

use glam::DVec3;
use raystep::geometry::{
    AlignedRay, Cone, Ellipsoid, QuadraticTest, Ray, Roots, Sides, Sphere, TRange,
};
use raystep::scene::{Primitive, Shape};
use raystep::strategy::{BoundedObjects, DepthFirst, Exhaustive, Strategy, UniformGrid, ZAligned};
use raystep::structure::{Build, GridOptions, SlabSet, VolumeKind};
use raystep::{NoFiles, Off, Scene, load_bytes};

use crate::seeded::Seeded;

/// A hit lies this near to the surface, and t this near to the exact one, as a share of the numbers that enter:
/// what an intersection may lose, by the design's own bound.
const OFF: f64 = 1e-9;
/// A double root moves by the square root of what it is rounded by: √(32ε), and some.
const OFF_AT_A_GRAZE: f64 = 1e-6;
/// Rays of each kind of shape.
const RAYS: usize = 400_000;

/// A point or a direction of whole numbers.
type Whole = [i128; 3];

fn dot(v: Whole, w: Whole) -> i128 {
    (0..3).map(|i| v[i] * w[i]).sum()
}

fn cross([a, b, c]: Whole, [x, y, z]: Whole) -> Whole {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn difference(v: Whole, w: Whole) -> Whole {
    [0, 1, 2].map(|i| v[i] - w[i])
}

/// v + k·w
fn along(v: Whole, k: i128, w: Whole) -> Whole {
    [0, 1, 2].map(|i| v[i] + k * w[i])
}

fn real(v: Whole) -> DVec3 {
    DVec3::from_array(v.map(|x| x as f64))
}

/// A surface of whole numbers.
#[derive(Clone, Copy, Debug)]
enum Quadric {
    /// The first point and its radius, the second and its own.
    Cone([Whole; 2], [i128; 2]),
    Ellipsoid(Whole, Whole),
    Sphere(Whole, i128),
}

/// a·t² + 2h·t + c = 0, and the height that a cone's hit has: m + t·n, from 0 to `height`.
struct Equation {
    a: i128,
    half_b: i128,
    c: i128,
    ends: Option<[i128; 3]>,
}

impl Quadric {
    fn shape(self) -> Shape {
        match self {
            Self::Cone([base, apex], [r, s]) => {
                Shape::Cone(Cone::new(real(base), r as f64, real(apex), s as f64).unwrap())
            }
            Self::Ellipsoid(center, radii) => Shape::Ellipsoid(Ellipsoid {
                center: real(center),
                radii: real(radii),
            }),
            Self::Sphere(center, radius) => Shape::Sphere(Sphere {
                center: real(center),
                radius: radius as f64,
            }),
        }
    }

    /// The equation of t along o + t·d, times a whole number that rids it of fractions.
    fn equation(self, o: Whole, d: Whole) -> Equation {
        match self {
            // with W = apex − base, y = m·W/|W|² from 0 to 1 and the radius r + y·(s − r):
            // |m|² − (m·W)²/|W|² = (r + (s − r)·m·W/|W|²)², times |W|⁴
            Self::Cone([base, apex], [r, s]) => {
                let (w, m) = (difference(apex, base), difference(o, base));
                let height2 = dot(w, w);
                let (rise, climb) = (dot(m, w), dot(d, w));
                let (radius, narrowing) = (r * height2 + (s - r) * rise, (s - r) * climb);
                let (past, across) = (cross(d, w), cross(m, w));
                Equation {
                    a: height2 * dot(past, past) - narrowing * narrowing,
                    half_b: height2 * dot(past, across) - narrowing * radius,
                    c: height2 * dot(across, across) - radius * radius,
                    ends: Some([rise, climb, height2]),
                }
            }
            Self::Ellipsoid(center, [x, y, z]) => {
                let m = difference(o, center);
                let weights = [y * z, z * x, x * y].map(|product| product * product);
                let weighed = |v: Whole| [0, 1, 2].map(|i| weights[i] * v[i]);
                Equation {
                    a: dot(weighed(d), d),
                    half_b: dot(weighed(d), m),
                    c: dot(weighed(m), m) - x * x * y * y * z * z,
                    ends: None,
                }
            }
            Self::Sphere(center, radius) => Self::Ellipsoid(center, [radius; 3]).equation(o, d),
        }
    }

    /// How far is a point off the surface?
    fn off(self, p: DVec3) -> f64 {
        match self {
            Self::Cone([base, apex], [r, s]) => {
                let (w, m) = (real(difference(apex, base)), p - real(base));
                let share = m.dot(w) / w.length_squared();
                let from_axis = (m - share * w).length();
                (from_axis - (r as f64 + share * (s - r) as f64)).abs()
            }
            Self::Ellipsoid(center, radii) => {
                let in_radii = (p - real(center)) / real(radii);
                let slope = 2.0 * (in_radii / real(radii)).length();
                (in_radii.length_squared() - 1.0).abs() / slope
            }
            Self::Sphere(center, radius) => ((p - real(center)).length() - radius as f64).abs(),
        }
    }
}

/// The hit that exact arithmetic expects.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Expected {
    Hit(f64),
    None,
    /// A double root, an origin on the surface or a root on the very end: rounding decides whether it counts.
    Either,
}

impl Equation {
    /// All roots, exact but for one rounding or a few, and whether the root is double.
    fn roots(&self) -> (Vec<f64>, bool) {
        let (a, h, c) = (self.a, self.half_b, self.c);
        let inside = h * h - a * c;
        match (a, h) {
            (0, 0) => (vec![], false),
            (0, _) => (vec![-(c as f64) / (2 * h) as f64], false),
            _ if inside < 0 => (vec![], false),
            _ if inside == 0 => (vec![-(h as f64) / a as f64], true),
            _ => {
                let root = (inside as f64).sqrt();
                // −h and the root have one sign in q
                let q = if h < 0 {
                    -(h as f64) + root
                } else {
                    -(h as f64) - root
                };
                let mut both = vec![q / a as f64, c as f64 / q];
                both.sort_by(f64::total_cmp);
                (both, false)
            }
        }
    }

    fn expected(&self) -> Expected {
        let (roots, is_double) = self.roots();
        if is_double || self.c == 0 {
            return Expected::Either;
        }
        for t in roots {
            if t < 0.0 {
                continue;
            }
            if let Some([rise, climb, height2]) = self.ends {
                let y = rise as f64 + t * climb as f64;
                let rounding = OFF * (rise.abs() as f64 + t * climb.abs() as f64);
                let height2 = height2 as f64;
                if y.abs() <= rounding || (y - height2).abs() <= rounding {
                    return Expected::Either;
                }
                if y < 0.0 || height2 < y {
                    continue;
                }
            }
            return Expected::Hit(t);
        }
        Expected::None
    }
}

/// What was met, for a test to be sure that it has seen each.
#[derive(Debug, Default)]
struct Seen {
    hits: usize,
    misses: usize,
    linear: usize,
    no_equation: usize,
    grazes: usize,
}

/// One ray from `o` to `o` + `d`, whole and as a unit ray, in the world and aligned with z.
#[track_caller]
fn check(quadric: Quadric, o: Whole, d: Whole, seen: &mut Seen) {
    let equation = quadric.equation(o, d);
    let expected = equation.expected();
    let (roots, is_double) = equation.roots();
    seen.linear += usize::from(equation.a == 0 && equation.half_b != 0);
    seen.no_equation += usize::from(equation.a == 0 && equation.half_b == 0);
    seen.grazes += usize::from(is_double);
    match expected {
        Expected::Hit(_) => seen.hits += 1,
        Expected::None => seen.misses += 1,
        Expected::Either => {}
    }

    let whole = Ray::new(real(o), real(d));
    let (unit, length) = whole.normalised().unwrap();
    for (ray, per_t) in [(whole, 1.0), (unit, length)] {
        let aligned = AlignedRay::new(&ray);
        let (range, sides) = (TRange::FORWARD, Sides::Both);
        let tests: [QuadraticTest; 2] = match quadric.shape() {
            Shape::Cone(cone) => [
                cone.test(&ray, range, sides),
                cone.test_aligned(&aligned, range, sides),
            ],
            Shape::Ellipsoid(of) => [
                of.test(&ray, range, sides),
                of.test_aligned(&aligned, range, sides),
            ],
            Shape::Sphere(of) => [
                of.test(&ray, range, sides),
                of.test_aligned(&aligned, range, sides),
            ],
            other => panic!("{other:?} is no quadric"),
        };
        for test in tests {
            let context = || {
                format!(
                    "{quadric:?}\nray from {o:?} along {d:?}, {ray:?}\na {}, b/2 {}, c {}\n\
                     expected {expected:?} of {roots:?}, in lengths {per_t}\nfound {test:?}",
                    equation.a, equation.half_b, equation.c
                )
            };
            let found = test.roots.chosen();
            if let Some(t) = found {
                let p = ray.at(t);
                let size = real(o).length() + p.length() + 30.0;
                let off = quadric.off(p);
                let allowed = if is_double { OFF_AT_A_GRAZE } else { OFF };
                assert!(
                    off <= allowed * size,
                    "{off:e} off the surface\n{}",
                    context()
                );
                if let Some([rise, climb, height2]) = equation.ends {
                    let y = (rise as f64 + t / per_t * climb as f64) / height2 as f64;
                    assert!(
                        -OFF * size <= y && y <= 1.0 + OFF * size,
                        "at {y} of the height\n{}",
                        context()
                    );
                }
            }
            match (expected, found) {
                (Expected::Either, _) | (Expected::None, None) => {}
                (Expected::Hit(t), Some(found)) => {
                    let off = (found / per_t - t).abs();
                    assert!(off <= OFF * t.max(1.0), "t is {off:e} off\n{}", context());
                }
                _ => panic!("{}", context()),
            }
            if equation.a == 0 {
                let linear = matches!(test.roots, Roots::Linear(_) | Roots::None);
                assert!(linear && test.a == 0.0, "{}", context());
            }
        }
    }
}

fn point(random: &mut Seeded, size: i32) -> Whole {
    [0; 3].map(|_| i128::from(random.whole(-size, size)))
}

/// Three directions at right angles and of one length, which is whole: along the axes, or by 3-4-5.
fn frame(random: &mut Seeded) -> ([Whole; 3], i128) {
    let (rows, length) = match random.index(3) {
        0 => ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1),
        1 => ([[3, 4, 0], [-4, 3, 0], [0, 0, 5]], 5),
        // 2² + 3² + 6² = 7²
        _ => ([[2, 3, 6], [3, -6, 2], [6, 2, -3]], 7),
    };
    let (shift, first) = (random.index(3), random.index(3));
    let turned = rows.map(|row: Whole| [0, 1, 2].map(|i| row[(i + shift) % 3]));
    ([0, 1, 2].map(|i| turned[(i + first) % 3]), length)
}

/// A direction across the axis with a whole length of `length`·5: by 3-4-5 between two directions across it.
fn across(random: &mut Seeded, [_, u, v]: [Whole; 3]) -> Whole {
    let [a, b] = [[5, 0], [3, 4], [4, 3], [0, 5]][random.index(4)];
    let sign = [1, -1][random.index(2)];
    [0, 1, 2].map(|i| sign * a * u[i] + b * v[i])
}

/// A cone, and a ray that is hard on it or any.
fn cone_and_ray(random: &mut Seeded) -> (Quadric, Whole, Whole) {
    let (rows, length) = frame(random);
    let base = point(random, 6);
    let steps = i128::from(random.whole(1, 4));
    let apex = along(base, steps, rows[0]);
    // the height is steps·length, and radii in whole lengths keep the generators whole
    let unit = if random.index(2) == 0 { length } else { 1 };
    let radius = |random: &mut Seeded| unit * i128::from(random.whole(0, 4));
    let radii = loop {
        let radii = [radius(random), radius(random)];
        if radii != [0, 0] {
            break radii;
        }
    };
    let cone = Quadric::Cone([base, apex], radii);

    // a generator, times 5·length: it climbs 5·length·(steps·rows[0]) and goes out by (s − r)·out
    let out = across(random, rows);
    let generator =
        [0, 1, 2].map(|i| 5 * length * steps * rows[0][i] + (radii[1] - radii[0]) * out[i]);
    // on the surface, at the base, times 5·length
    let scale = 5 * length;
    let foot = [0, 1, 2].map(|i| scale * base[i] + radii[0] * out[i]);
    let sideways = cross(rows[0], out);
    let jump = |random: &mut Seeded| i128::from(random.whole(-6, 6));
    let scaled = Quadric::Cone(
        [base, apex].map(|p| p.map(|x| scale * x)),
        radii.map(|r| scale * r),
    );
    match random.index(6) {
        // along a generator: in the plane that touches the cone there …
        0 => {
            let o = along(along(foot, jump(random), sideways), jump(random), generator);
            (scaled, o, generator)
        }
        // … parallel to that plane, and on the surface itself
        1 => {
            let o = along(along(foot, jump(random), sideways), jump(random), out);
            (scaled, o, generator)
        }
        // across the plane that touches, in it: a double root
        2 => {
            let o = along(along(foot, jump(random), sideways), jump(random), generator);
            let (j, k) = (jump(random), 1 + random.index(3) as i128);
            let d = along([0, 1, 2].map(|i| k * sideways[i]), j, generator);
            (scaled, o, d)
        }
        // through the tip, or any point of the axis
        3 => {
            let tip = along(base, i128::from(random.whole(-1, 5)), rows[0]);
            let o = point(random, 9);
            (cone, o, difference(tip, o))
        }
        // along the axis
        4 => (cone, point(random, 9), rows[0]),
        _ => (cone, point(random, 9), point(random, 9)),
    }
}

#[test]
fn a_cone_of_whole_numbers_is_hit_where_exact_arithmetic_says() {
    let mut random = Seeded::new(14);
    let mut seen = Seen::default();
    for _ in 0..RAYS {
        let (cone, o, d) = cone_and_ray(&mut random);
        if d != [0; 3] {
            check(cone, o, d, &mut seen);
        }
    }
    // each kind of equation, many times
    for count in [
        seen.hits,
        seen.misses,
        seen.linear,
        seen.no_equation,
        seen.grazes,
    ] {
        assert!(RAYS / 40 <= count, "{seen:?}");
    }
}

#[test]
fn ellipsoids_and_spheres_of_whole_numbers_are_hit_where_exact_arithmetic_says() {
    let mut random = Seeded::new(15);
    let mut seen = Seen::default();
    for i in 0..RAYS {
        let center = point(&mut random, 6);
        let radius = |random: &mut Seeded| i128::from(random.whole(1, 5));
        let quadric = if i % 2 == 0 {
            Quadric::Sphere(center, radius(&mut random))
        } else {
            Quadric::Ellipsoid(center, [0; 3].map(|_| radius(&mut random)))
        };
        let radii = match quadric {
            Quadric::Ellipsoid(_, radii) => radii,
            _ => [radius(&mut random); 3],
        };
        // from anywhere; or past the end of an axis, across it: a double root if the radius fits
        let d = match random.index(2) {
            0 => point(&mut random, 9),
            _ => {
                let mut d = point(&mut random, 9);
                d[random.index(3)] = 0;
                d
            }
        };
        let flat = (0..3).find(|&axis| d[axis] == 0).unwrap_or(0);
        let mut o = along(center, i128::from(random.whole(-9, 9)), d);
        o[flat] += radii[flat];
        if random.index(2) == 0 {
            o = point(&mut random, 9);
        }
        if d != [0; 3] {
            check(quadric, o, d, &mut seen);
        }
    }
    for count in [seen.hits, seen.misses, seen.grazes] {
        assert!(RAYS / 40 <= count, "{seen:?}");
    }
    assert_eq!((seen.linear, seen.no_equation), (0, 0));
}

/// A scene of one object, as the strategies want it.
fn scene_of(quadric: Quadric) -> Scene {
    let text = br#"{
      "camera": { "look_at": { "cop": [-6, -3, -6], "target": [-3, 0, -6], "up": [0, 0, 1], "fov_degrees": 40 },
                  "pixels": [21, 21] },
      "materials": { "m": { "colour": [1, 1, 1] } },
      "objects": [ { "name": "A", "material": "m", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } } ]
    }"#;
    let loaded = load_bytes("quadric.json", text, &NoFiles).unwrap();
    let mut scene = loaded.build().unwrap();
    scene.primitives = vec![Primitive {
        shape: quadric.shape(),
        object: 0,
        sides: Sides::Both,
    }];
    scene
}

#[test]
fn no_strategy_hits_a_cone_in_the_empty_space_of_its_tangent_plane() {
    // the ray lies in the plane z = −6, and the cone between z = −1 and 5: it was hit at t = 2, since a and b,
    // both 0, came out as 2e−16 and −9e−16, and b² − 4ac as a graze
    let cone = Quadric::Cone([[-3, -3, 2], [-3, 0, 2]], [3, 0]);
    let (o, d) = ([-6, -3, -6], [1, 1, 0]);
    check(cone, o, d, &mut Seen::default());
    let scene = scene_of(cone);
    // the eye ray through the middle of the picture, whose Δx and Δy differ in the last bit
    let ray = scene.camera.eye_ray(10.5, 10.5).0;
    assert_eq!((ray.origin, ray.direction.z), (real(o), 0.0));
    let (range, axes) = (TRange::FORWARD, &SlabSet::AXES);
    let grid = UniformGrid::new(&scene, &GridOptions::default()).unwrap();
    let found = [
        Exhaustive::new(&scene).nearest(&ray, range, &mut Off),
        ZAligned::new(&scene).nearest(&ray, range, &mut Off),
        BoundedObjects::new(&scene, VolumeKind::Sphere, axes).nearest(&ray, range, &mut Off),
        DepthFirst::new(&scene, axes, Build::SurfaceArea).nearest(&ray, range, &mut Off),
        grid.nearest(&ray, range, &mut Off),
    ];
    assert_eq!(found, [None; 5]);
}
