//! Refraction against a table of Snell's law and against what Snell's law says about the vectors.
//!
//! The table was worked out with 40 digits and has 13 decimals: θ₂ = arcsin(n₁ sin θ₁ / n₂).

use glam::DVec3;
use raystep::geometry::{Refraction, refract};

use crate::exact::{Exact, ExactVec3};
use crate::seeded::Seeded;

/// The sine of θ₂, and all else that is in proportion to n₁ sin θ₁: a dozen roundings, of numbers up
/// to (n₁/n₂)², which is below 6.
const SINE: f64 = 64.0 * f64::EPSILON;
/// cos²θ₂, of the terms 1 and (n₁/n₂)² that it is the difference of: five roundings of each.
const COSINE_SQUARED: f64 = 8.0 * f64::EPSILON;
/// A unit vector, after its normalisation.
const UNIT: f64 = 4.0 * f64::EPSILON;
/// Pairs of vectors per test.
const RAYS: usize = 20_000;

/// What is expected at an angle in degrees: `Some` of θ₂ in degrees, or total internal reflection.
type Row = (f64, Option<f64>);

/// n₁, n₂, and the rows. Critical angles: 41.8103148957786° from 1.5 to 1, 48.6066263916903° from
/// 1.333 to 1, 24.4397438654519° from 2.417 to 1, 62.7061760793324° from 1.5 to 1.333.
const TABLE: [(f64, f64, &[Row]); 8] = [
    // air to glass
    (
        1.0,
        1.5,
        &[
            (0.0, Some(0.0)),
            (10.0, Some(6.647_777_092_828_6)),
            (30.0, Some(19.471_220_634_490_7)),
            (45.0, Some(28.125_505_702_055_7)),
            (60.0, Some(35.264_389_682_754_7)),
            (75.0, Some(40.087_036_908_483_3)),
            (89.0, Some(41.802_510_219_635_4)),
        ],
    ),
    // air to water
    (
        1.0,
        1.333,
        &[
            (15.0, Some(11.195_822_288_427_3)),
            (45.0, Some(32.036_723_039_928_4)),
            (80.0, Some(47.628_487_453_416_4)),
        ],
    ),
    // glass to air: the last but three is 0.0003° below the critical angle
    (
        1.5,
        1.0,
        &[
            (0.0, Some(0.0)),
            (10.0, Some(15.098_086_605_159)),
            (30.0, Some(48.590_377_890_729_1)),
            (40.0, Some(74.618_568_308_020_3)),
            (41.8, Some(88.850_362_277_336_2)),
            (41.81, Some(89.799_142_527_827_9)),
            (41.811, None),
            (60.0, None),
            (90.0, None),
        ],
    ),
    // water to air
    (
        1.333,
        1.0,
        &[
            (20.0, Some(27.123_684_065_631_8)),
            (48.0, Some(82.142_881_430_430_5)),
            (48.6, Some(89.181_869_574_835_4)),
            (48.607, None),
        ],
    ),
    // diamond to air
    (
        2.417,
        1.0,
        &[
            (10.0, Some(24.816_131_301_891_8)),
            (24.0, Some(79.445_921_282_512_1)),
            (24.4, Some(86.833_681_892_967_7)),
            (24.44, None),
            (45.0, None),
        ],
    ),
    // water to glass
    (
        1.333,
        1.5,
        &[
            (30.0, Some(26.380_693_513_073)),
            (70.0, Some(56.623_493_228_989_8)),
            (89.9, Some(62.706_006_959_458_5)),
        ],
    ),
    // glass to water
    (
        1.5,
        1.333,
        &[
            (30.0, Some(34.238_614_425_012_8)),
            (62.7, Some(89.395_657_514_491_4)),
            (62.707, None),
        ],
    ),
    // nothing to air
    (
        1.0,
        1.000_29,
        &[
            (45.0, Some(44.983_391_448_079_7)),
            (89.0, Some(88.296_070_905_582)),
        ],
    ),
];

/// Holds one refraction against Snell's law as vectors; gives it back.
#[track_caller]
fn check(direction: DVec3, normal: DVec3, n1: f64, n2: f64) -> Refraction {
    let refraction = refract(direction, normal, n1, n2);
    let context = || format!("{direction} {normal} {refraction:?}");
    assert_eq!((refraction.index_from, refraction.index_to), (n1, n2));

    // n₂²cos²θ₂ = n₂² − n₁²(1 − (Δ·N)²), exactly
    let cosine = ExactVec3::from(direction).dot(&ExactVec3::from(normal));
    let square = |x: &Exact| x * x;
    let [from2, to2] = [n1, n2].map(|n| square(&Exact::from(n)));
    let exact = &to2 - &(&from2 * &(Exact::from(1.0) - square(&cosine)));
    let found = &Exact::from(refraction.cos_refracted_squared) * &to2;
    let (off, exact) = ((found - exact.clone()).abs().to_f64(), exact.to_f64());
    let terms = n1 * n1 + n2 * n2;
    assert!(
        off <= COSINE_SQUARED * terms,
        "n₂²cos²θ₂ = {exact}, off by {off:e}\n{}",
        context()
    );

    let sine1 = n1 * direction.cross(normal).length();
    let Some(bent) = refraction.direction else {
        assert!(
            exact <= COSINE_SQUARED * terms,
            "reflected at n₂²cos²θ₂ = {exact}\n{}",
            context()
        );
        assert!(
            n2 * (1.0 - SINE) <= sine1,
            "n₁ sin θ₁ = {sine1} < n₂\n{}",
            context()
        );
        return refraction;
    };
    assert!(
        -COSINE_SQUARED * terms <= exact,
        "passed at n₂²cos²θ₂ = {exact}\n{}",
        context()
    );
    assert!(
        (bent.length() - 1.0).abs() <= UNIT,
        "|T| = {}\n{}",
        bent.length(),
        context()
    );
    assert!(
        bent.dot(normal) <= UNIT,
        "T leaves the surface on the wrong side\n{}",
        context()
    );

    let sine2 = n2 * bent.cross(normal).length();
    assert!(
        (sine1 - sine2).abs() <= SINE * n1,
        "n₁ sin θ₁ = {sine1}, n₂ sin θ₂ = {sine2}\n{}",
        context()
    );
    // n₁(Δ − (Δ·N)N) = n₂(T − (T·N)N): the same, with its direction
    let along = |v: DVec3| v - v.dot(normal) * normal;
    let (before, after) = (n1 * along(direction), n2 * along(bent));
    assert!(
        (before - after).length() <= SINE * n1,
        "along the surface {before} {after}\n{}",
        context()
    );
    let volume = bent.dot(direction.cross(normal));
    assert!(
        volume.abs() <= SINE,
        "T is off the plane of Δ and N by {volume:e}\n{}",
        context()
    );
    refraction
}

/// Down onto the surface y = 0 at an angle from the normal.
fn at(degrees: f64) -> DVec3 {
    let angle = degrees.to_radians();
    DVec3::new(angle.sin(), -angle.cos(), 0.0)
}

/// A random normal, a random direction against it, and two indices from 1 to 2.4.
fn any(random: &mut Seeded) -> (DVec3, DVec3, f64, f64) {
    let normal = random.direction();
    let direction = random.direction();
    let direction = if 0.0 < direction.dot(normal) {
        -direction
    } else {
        direction
    };
    (
        direction,
        normal,
        random.within(1.0, 2.4),
        random.within(1.0, 2.4),
    )
}

#[test]
fn a_sine_of_three_fifths_becomes_one_half_in_an_index_of_six_fifths() {
    // Δ = (0.6, −0.8): cos²θ₂ = 1 − 0.36/1.44 = 0.75
    let refraction = check(DVec3::new(0.6, -0.8, 0.0), DVec3::Y, 1.0, 1.2);
    let expected = DVec3::new(0.5, -0.75f64.sqrt(), 0.0);
    let found = refraction.direction.unwrap();
    assert!((found - expected).length() <= UNIT, "{found} {expected}");
}

#[test]
fn the_angles_are_those_of_the_table() {
    for (n1, n2, rows) in TABLE {
        for &(degrees, expected) in rows {
            let bent = check(at(degrees), DVec3::Y, n1, n2).direction;
            assert_eq!(
                bent.is_some(),
                expected.is_some(),
                "{degrees}° from {n1} to {n2}"
            );
            let (Some(bent), Some(expected)) = (bent, expected) else {
                continue;
            };
            let found = bent.x.atan2(-bent.y).to_degrees();
            // dθ = d(sin θ)/cos θ: towards the critical angle digits are lost
            let tolerance = SINE.to_degrees() / expected.to_radians().cos();
            let off = (found - expected).abs();
            assert!(
                off <= tolerance,
                "{degrees}° from {n1} to {n2}: {found}° {expected}°, off by {off:e}°"
            );
        }
    }
}

#[test]
fn straight_through_the_surface_nothing_bends_at_any_index() {
    let mut random = Seeded::new(1);
    for _ in 0..RAYS / 10 {
        let (_, normal, n1, n2) = any(&mut random);
        let bent = check(-normal, normal, n1, n2).direction.unwrap();
        assert!((bent + normal).length() <= UNIT, "{bent} {normal}");
    }
    let (n1, n2) = (1.0, 1.5);
    assert_eq!(
        check(-DVec3::Z, DVec3::Z, n1, n2).direction,
        Some(-DVec3::Z)
    );
}

#[test]
fn just_below_the_critical_angle_a_ray_passes_and_just_above_it_none() {
    for (n1, n2) in [
        (1.5, 1.0),
        (1.333, 1.0),
        (2.417, 1.0),
        (1.5, 1.333),
        (1.000_29, 1.0),
    ] {
        for k in 3..=13 {
            for below in [true, false] {
                let share = if below {
                    1.0 - 10f64.powi(-k)
                } else {
                    1.0 + 10f64.powi(-k)
                };
                let sine = share * n2 / n1;
                // 1.00029 has its critical angle at 88.6°: not every share above it is a sine
                if 1.0 < sine {
                    continue;
                }
                let direction = DVec3::new(sine, -((1.0 - sine) * (1.0 + sine)).sqrt(), 0.0);
                let bent = check(direction, DVec3::Y, n1, n2).direction;
                assert_eq!(
                    bent.is_some(),
                    below,
                    "10^-{k} from the critical sine from {n1} to {n2}"
                );
            }
        }
    }
}

#[test]
fn at_the_critical_angle_a_ray_passes_along_the_surface_or_is_within_rounding_of_it() {
    // whole triangles: sin θ₁ = opposite/hypotenuse = n₂/n₁
    for (opposite, adjacent, hypotenuse) in [
        (3.0, 4.0, 5.0),
        (4.0, 3.0, 5.0),
        (5.0, 12.0, 13.0),
        (15.0, 8.0, 17.0),
    ] {
        let direction = DVec3::new(opposite, -adjacent, 0.0) / hypotenuse;
        let refraction = check(direction, DVec3::Y, hypotenuse, opposite);
        let scale = 1.0 + (hypotenuse / opposite).powi(2);
        let cosine_squared = refraction.cos_refracted_squared;
        assert!(
            cosine_squared.abs() <= COSINE_SQUARED * scale,
            "{refraction:?}"
        );
        // √ of the rounding is what is left of the cosine
        let along =
            |bent: DVec3| (bent - DVec3::X).length() <= (2.0 * COSINE_SQUARED * scale).sqrt();
        assert!(refraction.direction.is_none_or(along), "{refraction:?}");
    }
    // equal indices at 90°: every number is exact, cos²θ₂ = 0, and the ray goes on along the surface
    let along = check(DVec3::X, DVec3::Y, 1.5, 1.5);
    assert_eq!(
        (along.cos_refracted_squared, along.direction),
        (0.0, Some(DVec3::X))
    );
}

#[test]
fn any_ray_obeys_snells_law_in_the_plane_of_incidence() {
    let mut random = Seeded::new(2);
    let mut passed = 0;
    for _ in 0..RAYS {
        let (direction, normal, n1, n2) = any(&mut random);
        passed += usize::from(check(direction, normal, n1, n2).direction.is_some());
    }
    // some are reflected, most pass
    assert!(RAYS / 2 < passed && passed < RAYS - RAYS / 20, "{passed}");
}

#[test]
fn a_ray_that_flatly_meets_the_surface_obeys_snells_law() {
    let mut random = Seeded::new(3);
    for _ in 0..RAYS {
        let (_, normal, n1, n2) = any(&mut random);
        let direction = random.across(normal) - random.power(-12.0, -1.0) * normal;
        check(direction.normalize(), normal, n1, n2);
    }
}

#[test]
fn the_way_back_is_the_way_there() {
    let mut random = Seeded::new(4);
    for _ in 0..RAYS {
        let (direction, normal, n1, n2) = any(&mut random);
        let cosine = -direction.dot(normal);
        // flatter than this, the way back is at its own critical angle
        if cosine < 1e-3 {
            continue;
        }
        let Some(bent) = check(direction, normal, n1, n2).direction else {
            continue;
        };
        let back = check(-bent, -normal, n2, n1).direction.unwrap();
        let off = (back + direction).length();
        assert!(
            off <= SINE / cosine,
            "{direction} comes back as {back}, off by {off:e}"
        );
    }
}

#[test]
fn a_plate_leaves_the_direction_as_it_was() {
    let mut random = Seeded::new(5);
    for _ in 0..RAYS {
        let (direction, normal, _, n2) = any(&mut random);
        let cosine = -direction.dot(normal);
        if cosine < 1e-3 {
            continue;
        }
        // in through one side and out through the other, which is parallel to it
        let within = check(direction, normal, 1.0, n2).direction.unwrap();
        let out = check(within, normal, n2, 1.0).direction.unwrap();
        let off = (out - direction).length();
        assert!(
            off <= SINE / cosine,
            "{direction} leaves as {out}, off by {off:e}"
        );
    }
}
