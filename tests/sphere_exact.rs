//! The roots of the sphere against exact arithmetic on the same f64 input.
//!
//! Δ, o = origin − center and r are taken as the exact values of their f64s. a, b, c and the
//! discriminant then are exact, and a root has 60 digits and more: (−b/2 ± √(b²/4 − ac)) / a.
//!
//! A grazing ray is the hard case. Where it passes the center at r·(1 ± 10⁻ᵏ), half the chord is
//! r·√(2·10⁻ᵏ), and its digits go as k grows.

use glam::DVec3;
use raystep::geometry::{QuadraticTest, Ray, Root, Roots, Sides, Sphere, TRange};

use crate::exact::{Exact, ExactVec3};
use crate::seeded::Seeded;

/// The relative error of a root whose ray is clear of grazing: nine digits, three more than a scene
/// file usually gives.
const ROOT: f64 = 1e-9;
/// Clear of grazing: the line's closest approach to the center differs from r by this share of r.
const CLEAR: f64 = 1e-12;
/// Nearer than that, roots are compared as distances, in radii: two roots that are taken for one
/// differ by up to 4√ε (the documentation of `GRAZE`).
const GRAZING_ROOT: f64 = 4.0 * 1.490_116_119_384_765_6e-8;
/// One root may be taken for two, or for none, where the discriminant is within this share of 4ar²:
/// half the chord is then at most 4√ε radii.
const GRAZING_DISCRIMINANT: f64 = 16.0 * f64::EPSILON;
/// Three squares and two sums of positive terms: at most 3 roundings of ε/2.
const A: f64 = 4.0 * f64::EPSILON;
/// Of the size of the three products in b: o, the products and two sums round.
const B: f64 = 4.0 * f64::EPSILON;
/// c is taken twice where it cancels: nine digits, as for the roots.
const C: f64 = 1e-9;
/// Of 4a(|o|² + r²), the size of the terms in b² − 4ac: some ten roundings of ε/2.
const DISCRIMINANT_TERMS: f64 = 8.0 * f64::EPSILON;
/// Of the discriminant itself: the six digits that the plain formula leaves.
const DISCRIMINANT: f64 = 1e-5;
/// Rays per test.
const RAYS: usize = 4000;

/// The exact coefficients, with b halved and the discriminant quartered.
struct Expected {
    a: Exact,
    half_b: Exact,
    c: Exact,
    quarter: Exact,
    offset2: Exact,
    radius2: Exact,
}

impl Expected {
    fn new(sphere: Sphere, ray: &Ray) -> Self {
        let offset = &ExactVec3::from(ray.origin) - &ExactVec3::from(sphere.center);
        let direction = ExactVec3::from(ray.direction);
        let radius = Exact::from(sphere.radius);
        let (a, half_b) = (direction.dot(&direction), direction.dot(&offset));
        let (offset2, radius2) = (offset.dot(&offset), &radius * &radius);
        let c = &offset2 - &radius2;
        let quarter = &half_b * &half_b - &a * &c;
        Self {
            a,
            half_b,
            c,
            quarter,
            offset2,
            radius2,
        }
    }

    /// Does the closest approach differ from r by [`CLEAR`] and more?
    fn is_clear(&self) -> bool {
        // a·(closest approach)² = |o × Δ|² = a·r² − quarter
        let approach2 = &self.a * &self.radius2 - self.quarter.clone();
        let beyond = |share: f64| {
            let bound = Exact::from(share);
            &self.a * &self.radius2 * (&bound * &bound)
        };
        approach2 <= beyond(1.0 - CLEAR) || beyond(1.0 + CLEAR) <= approach2
    }

    /// a·t for both exact roots, the smaller first; of the closest approach if there is no root.
    fn roots_times_a(&self) -> [Exact; 2] {
        let middle = -&self.half_b;
        if self.quarter.sign() < 0 {
            return [middle.clone(), middle];
        }
        let half_chord = self.quarter.sqrt();
        [&middle - &half_chord, &middle + &half_chord]
    }
}

/// |found − expected|, in units of `unit`.
fn error(found: f64, expected: &Exact, unit: &Exact) -> f64 {
    let difference = (&Exact::from(found) - expected).abs();
    if difference.sign() == 0 {
        0.0
    } else {
        difference.to_f64() / unit.abs().to_f64()
    }
}

/// Holds every root and every coefficient of one test against the exact ones.
#[track_caller]
fn check(sphere: Sphere, ray: &Ray) {
    let test = sphere.test(ray, TRange::FORWARD, Sides::Both);
    let expected = Expected::new(sphere, ray);
    let reach = (expected.offset2.to_f64() / expected.radius2.to_f64()).sqrt();
    assert!(
        reach <= 1001.0,
        "the origin is {reach} radii from the center"
    );
    let context = || {
        let roots = expected.roots_times_a();
        let t = roots.map(|root| root.to_f64() / expected.a.to_f64());
        format!("{sphere:?}\n{ray:?}\nfound {test:?}\nexact roots {t:?}")
    };
    check_coefficients(&test, &expected, sphere, ray, context);

    let found: Vec<Root> = test.roots.iter().collect();
    if expected.is_clear() {
        let count = if expected.quarter.sign() < 0 { 0 } else { 2 };
        assert_eq!(found.len(), count, "number of roots\n{}", context());
        for (root, exact) in found.iter().zip(expected.roots_times_a()) {
            let times_a = &Exact::from(root.t) * &expected.a - exact.clone();
            let off = error(0.0, &times_a, &exact);
            assert!(
                off <= ROOT,
                "t = {} is off by {off:e}\n{}",
                root.t,
                context()
            );
        }
    } else {
        let [near, far] = expected.roots_times_a();
        // the root of the closest approach, between the two, if only one was found
        let middle = [-&expected.half_b];
        let exact = if found.len() == 2 {
            &[near, far][..]
        } else {
            &middle
        };
        // |Δ|·|dt|/r = |a·dt| / (|Δ|·r)
        let radius = (&expected.a * &expected.radius2).sqrt();
        for (root, exact) in found.iter().zip(exact) {
            let times_a = &Exact::from(root.t) * &expected.a - exact.clone();
            let off = error(0.0, &times_a, &radius);
            assert!(
                off <= GRAZING_ROOT,
                "t = {} is off by {off:e} r\n{}",
                root.t,
                context()
            );
        }
        let count = if expected.quarter.sign() < 0 { 0 } else { 2 };
        if found.len() != count {
            let share = error(0.0, &expected.quarter, &(&expected.a * &expected.radius2));
            assert!(
                share <= GRAZING_DISCRIMINANT,
                "number of roots at {share:e}\n{}",
                context()
            );
        }
    }
}

#[track_caller]
fn check_coefficients(
    test: &QuadraticTest,
    expected: &Expected,
    sphere: Sphere,
    ray: &Ray,
    context: impl Fn() -> String,
) {
    let products = (ray.origin - sphere.center).abs().dot(ray.direction.abs());
    let terms = &expected.a * &(&expected.offset2 + &expected.radius2);
    let (half_b, quarter) = (0.5 * test.b, 0.25 * test.discriminant);
    for (name, found, exact, unit, tolerance) in [
        ("a", test.a, &expected.a, &expected.a, A),
        ("b/2", half_b, &expected.half_b, &Exact::from(products), B),
        ("c", test.c, &expected.c, &expected.c, C),
        (
            "discriminant/4, of its terms",
            quarter,
            &expected.quarter,
            &terms,
            DISCRIMINANT_TERMS,
        ),
        (
            "discriminant/4",
            quarter,
            &expected.quarter,
            &expected.quarter,
            DISCRIMINANT,
        ),
    ] {
        let off = error(found, exact, unit);
        let exact = exact.to_f64();
        assert!(
            off <= tolerance,
            "{name}: {found:e} {exact:e} off by {off:e}\n{}",
            context()
        );
    }
}

/// A sphere of an everyday size.
fn sphere(random: &mut Seeded) -> Sphere {
    Sphere {
        center: random.point(10.0),
        radius: random.power(-2.0, 2.0),
    }
}

/// Half of the rays keep the length 1, the others get any.
fn scaled(random: &mut Seeded, direction: DVec3) -> DVec3 {
    if random.sign() < 0.0 {
        direction
    } else {
        direction * random.power(-3.0, 3.0)
    }
}

/// A ray that passes the center at `approach`, the closest point being `before` ahead of its origin.
fn passing(random: &mut Seeded, center: DVec3, approach: f64, before: f64) -> Ray {
    let direction = random.direction();
    let closest = center + approach * random.across(direction);
    Ray::new(closest - before * direction, scaled(random, direction))
}

#[test]
fn a_ray_of_three_four_five_has_the_roots_of_the_hand() {
    // from (−5, 0.6, 0) along x the unit sphere is met at x = ∓0.8: 4.2 and 5.8
    let unit = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let ray = Ray::new(DVec3::new(-5.0, 0.6, 0.0), DVec3::X);
    check(unit, &ray);
    let [near, far] = Expected::new(unit, &ray)
        .roots_times_a()
        .map(|root| root.to_f64());
    assert!(
        (near - 4.2).abs() <= 1e-15 && (far - 5.8).abs() <= 1e-15,
        "{near} {far}"
    );
}

#[test]
fn rays_from_anywhere_within_a_thousand_radii_have_the_exact_roots() {
    let mut random = Seeded::new(1);
    for _ in 0..RAYS {
        let sphere = sphere(&mut random);
        let away = sphere.radius * random.power(-3.0, 2.99);
        let origin = sphere.center + away * random.direction();
        // aimed at a ball of 1.2 radii, so that some pass by, or anywhere
        let direction = if random.sign() < 0.0 {
            random.direction()
        } else {
            sphere.center + 1.2 * random.unit() * sphere.radius * random.direction() - origin
        };
        check(sphere, &Ray::new(origin, direction));
    }
}

#[test]
fn rays_that_nearly_graze_have_the_exact_roots() {
    let mut random = Seeded::new(2);
    for _ in 0..RAYS {
        let sphere = sphere(&mut random);
        let k = random.whole(2, 16);
        let approach = sphere.radius * (1.0 + random.sign() * 10f64.powi(-k));
        let before = random.sign() * sphere.radius * random.power(-8.0, 2.99);
        check(
            sphere,
            &passing(&mut random, sphere.center, approach, before),
        );
    }
}

#[test]
fn rays_that_nearly_graze_from_close_to_the_surface_have_the_exact_roots() {
    // the discriminant and c cancel at once, and the roots are short
    let mut random = Seeded::new(3);
    for _ in 0..2 * RAYS {
        let sphere = sphere(&mut random);
        let approach = sphere.radius * (1.0 + random.sign() * random.power(-12.0, -2.0));
        let before = random.sign() * sphere.radius * random.power(-6.0, 0.0);
        check(
            sphere,
            &passing(&mut random, sphere.center, approach, before),
        );
    }
}

#[test]
fn rays_that_start_inside_have_one_root_on_either_side() {
    let mut random = Seeded::new(4);
    for _ in 0..RAYS {
        let sphere = sphere(&mut random);
        let away = sphere.radius * (1.0 - random.power(-6.0, -0.01));
        let origin = sphere.center + away * random.direction();
        let direction = random.direction();
        let ray = Ray::new(origin, scaled(&mut random, direction));
        check(sphere, &ray);
        let roots = sphere.test(&ray, TRange::FORWARD, Sides::Both).roots;
        let Roots::Two { near, far } = roots else {
            panic!("{sphere:?} {ray:?} {roots:?}");
        };
        assert!(near.t < 0.0 && 0.0 < far.t, "{near:?} {far:?}");
    }
}

#[test]
fn rays_that_start_on_or_close_to_the_surface_have_the_exact_roots() {
    let mut random = Seeded::new(5);
    for i in 0..2 * RAYS {
        let sphere = sphere(&mut random);
        let up = random.direction();
        // every third on the surface, as nearly as f64 can say it
        let off = if i % 3 == 0 {
            0.0
        } else {
            random.sign() * random.power(-15.0, -1.0)
        };
        let origin = sphere.center + sphere.radius * (1.0 + off) * up;
        // from straight up to nearly along the surface
        let climb = random.sign() * random.power(-5.0, 0.0);
        let direction = (random.across(up) + climb * up).normalize();
        check(sphere, &Ray::new(origin, scaled(&mut random, direction)));
    }
}

#[test]
fn a_ray_that_starts_exactly_on_the_surface_has_the_root_zero() {
    // (3, 4, 12)·s lies on the sphere of radius 13·s, and every number is a whole one
    let on_surface = DVec3::new(3.0, 4.0, 12.0);
    let mut random = Seeded::new(6);
    for _ in 0..RAYS {
        let center = random.point(100.0).round();
        let scale = (1.0 + random.index(1000) as f64) * random.sign();
        let sphere = Sphere {
            center,
            radius: 13.0 * scale.abs(),
        };
        check(
            sphere,
            &Ray::new(center + scale * on_surface, random.direction()),
        );
    }
}

#[test]
fn small_spheres_far_off_have_the_exact_roots() {
    // far from the ray's origin in radii, and from the world's origin
    let mut random = Seeded::new(7);
    for _ in 0..RAYS {
        let size = random.power(0.0, 6.0);
        let center = random.point(size);
        let sphere = Sphere {
            center,
            radius: random.power(-4.0, 0.0),
        };
        let approach = sphere.radius * random.within(0.0, 1.1);
        let before = sphere.radius * random.within(500.0, 999.0);
        check(sphere, &passing(&mut random, center, approach, before));
    }
}

#[test]
fn huge_spheres_close_by_have_the_exact_roots() {
    // the ground as a sphere: radius up to 10⁹, origin at a height of about 1, above or below it
    let mut random = Seeded::new(8);
    for i in 0..2 * RAYS {
        let radius = random.power(3.0, 9.0);
        let up = random.direction();
        let height = random.sign() * random.power(-1.0, 1.0);
        let origin = random.point(10.0);
        let sphere = Sphere {
            center: origin - (radius + height) * up,
            radius,
        };
        let along = random.across(up);
        let direction = match i % 4 {
            0 => random.direction(),
            1 => -up,
            // towards the horizon, √(2h/r) below the level, and just above and below it
            2 => {
                let horizon = (2.0 * height.abs() / radius).sqrt();
                let share = 1.0 + random.sign() * random.power(-6.0, 0.0);
                (along - horizon * share * up).normalize()
            }
            _ => (along + random.sign() * random.power(-5.0, 0.0) * up).normalize(),
        };
        check(sphere, &Ray::new(origin, scaled(&mut random, direction)));
    }
}
