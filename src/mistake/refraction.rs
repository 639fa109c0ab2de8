//! Snell's law.

use glam::DVec3;

use crate::geometry::{Refraction, refract};
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "ratio never inverted",
        sentence: "The ratio of the indices on the way in is used on the way out too.",
        spoils: "n₁/n₂",
        wrong: Wrong::Refract(ratio_never_inverted),
    },
    Mistake {
        name: "normal not turned",
        sentence: "On the way out the normal still points outwards, away from the side that the ray comes from.",
        spoils: "cos θ₁",
        wrong: Wrong::Refract(normal_not_turned),
    },
    Mistake {
        name: "root of a negative number",
        sentence: "cos²θ₂ is not compared with 0, so total internal reflection gives a direction that is no number.",
        spoils: "cos θ₂",
        wrong: Wrong::Refract(root_of_a_negative_number),
    },
];

fn ratio_never_inverted(direction: DVec3, normal: DVec3, from: f64, to: f64) -> Refraction {
    refract(direction, normal, from.min(to), from.max(to))
}

/// The ray leaves where the index falls.
fn normal_not_turned(direction: DVec3, normal: DVec3, from: f64, to: f64) -> Refraction {
    let outwards = if to < from { -normal } else { normal };
    refract(direction, outwards, from, to)
}

fn root_of_a_negative_number(direction: DVec3, normal: DVec3, from: f64, to: f64) -> Refraction {
    let right = refract(direction, normal, from, to);
    Refraction {
        direction: Some(right.direction.unwrap_or(DVec3::NAN)),
        ..right
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A few roundings of numbers up to 1.
    const ROUNDED: f64 = 1e-15;

    /// sin θ₁ = 0.6, cos θ₁ = 0.8, from above.
    const SLANTED: DVec3 = DVec3::new(0.6, -0.8, 0.0);

    #[track_caller]
    fn check(found: Refraction, expected: [f64; 2]) {
        let [x, y] = expected;
        let direction = found.direction.unwrap();
        let off = (direction - DVec3::new(x, y, 0.0)).length();
        assert!(off <= ROUNDED, "{direction}, expected {expected:?}");
    }

    #[test]
    fn on_the_way_out_the_ratio_is_inverted_and_the_normal_turned() {
        // out of 1.5: sin θ₂ = 0.9, cos²θ₂ = 0.19; with the ratio of the way in sin θ₂ = 0.4, cos²θ₂ = 0.84
        check(refract(SLANTED, DVec3::Y, 1.5, 1.0), [0.9, -0.19f64.sqrt()]);
        check(
            ratio_never_inverted(SLANTED, DVec3::Y, 1.5, 1.0),
            [0.4, -0.84f64.sqrt()],
        );
        // η·Δ − (η·0.8 + cos θ₂)·(−y): the ray goes back up
        check(
            normal_not_turned(SLANTED, DVec3::Y, 1.5, 1.0),
            [0.9, 0.19f64.sqrt()],
        );
        // on the way in nothing is wrong
        let inwards = refract(SLANTED, DVec3::Y, 1.0, 1.5);
        for wrong in [
            ratio_never_inverted,
            normal_not_turned,
            root_of_a_negative_number,
        ] {
            assert_eq!(wrong(SLANTED, DVec3::Y, 1.0, 1.5), inwards);
        }
    }

    #[test]
    fn beyond_the_critical_angle_the_root_has_no_value() {
        // out of 2: sin θ₂ would be 1.2, cos²θ₂ = 1 − 4·0.36
        let right = refract(SLANTED, DVec3::Y, 2.0, 1.0);
        assert!((right.cos_refracted_squared - -0.44).abs() <= ROUNDED);
        assert_eq!(right.direction, None);
        let wrong = root_of_a_negative_number(SLANTED, DVec3::Y, 2.0, 1.0);
        assert!(wrong.direction.unwrap().is_nan());
    }
}
