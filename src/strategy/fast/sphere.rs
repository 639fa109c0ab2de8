//! The sphere without its working: where it is hit, and whether a few products settle that it is not.

use crate::geometry::{
    DISCRIMINANT_CANCELS, Quadratic, Ray, RealRoots, RootVerdict, Sides, Sphere, TRange,
    hidden_side, verdict_of,
};

/// The hit distance that [`Sphere::test`] chooses: the same real roots, without a verdict on those that are not the hit.
#[inline]
pub(super) fn hit(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let is_hit = |t: f64, entering| {
        verdict_of(t, range) == RootVerdict::Chosen && hidden_side(entering, sides).is_none()
    };
    match Quadratic::of_sphere(ray, sphere.center, sphere.radius).real_roots() {
        RealRoots::None => None,
        RealRoots::Linear { t, entering } => is_hit(t, entering).then_some(t),
        RealRoots::Graze(t) => is_hit(t, true).then_some(t),
        RealRoots::Two {
            t: [near, far],
            near_enters,
        } => {
            if is_hit(near, near_enters) {
                Some(near)
            } else {
                is_hit(far, !near_enters).then_some(far)
            }
        }
    }
}

/// Does the line of the ray pass the sphere so far from its edge that [`Sphere::test`] finds no real root,
/// whatever is rounded? `false` is inconclusive.
///
/// The discriminant (o·Δ)² − a·(|o|² − r²), a quarter of b² − 4ac, is below 0 by more than 10⁻⁵ of a·|o|²: that
/// is beyond the rounding of its terms and beyond what counts as a graze. So it is enough to subtract them here,
/// with fewer products than the test needs.
#[inline]
pub(super) fn is_clearly_missed(sphere: &Sphere, ray: &Ray) -> bool {
    let offset = ray.origin - sphere.center;
    let a = ray.direction.length_squared();
    let half_b = ray.direction.dot(offset);
    let c = (1.0 - DISCRIMINANT_CANCELS) * offset.length_squared() - sphere.radius * sphere.radius;
    half_b * half_b < a * c
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    const UNIT: Sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };

    #[test]
    fn the_hit_is_the_root_that_the_test_chooses() {
        let from = 1e-9;
        let ranges = [TRange::FORWARD, TRange::FORWARD.up_to(3.999)];
        let rays = [
            // two roots; a graze; from inside; behind; from the surface; past it; without a direction
            ([-5.0, 0.0, 0.0], [1.0, 0.0, 0.0], Some(4.0)),
            ([-5.0, 1.0, 0.0], [1.0, 0.0, 0.0], Some(5.0)),
            ([0.0; 3], [0.0, 1.0, 0.0], Some(1.0)),
            ([5.0, 0.0, 0.0], [1.0, 0.0, 0.0], None),
            ([-1.0 - 1e-12, 0.0, 0.0], [1.0, 0.0, 0.0], Some(2.0)),
            ([-5.0, 2.0, 0.0], [1.0, 0.0, 0.0], None),
            ([0.5, 0.0, 0.0], [0.0; 3], None),
        ];
        for (origin, direction, expected) in rays {
            let ray = Ray::new(DVec3::from(origin), DVec3::from(direction));
            for (range, sides) in ranges
                .iter()
                .flat_map(|range| [Sides::Both, Sides::Front, Sides::Back].map(|of| (*range, of)))
            {
                let range = TRange { min: from, ..range };
                let chosen = UNIT.test(&ray, range, sides).roots.chosen();
                let found = hit(&UNIT, &ray, range, sides);
                assert_eq!(found.map(f64::to_bits), chosen.map(f64::to_bits));
            }
            let range = TRange {
                min: from,
                ..TRange::FORWARD
            };
            let found = hit(&UNIT, &ray, range, Sides::Both);
            let off = found.zip(expected).map_or(0.0, |(t, of)| (t - of).abs());
            assert!(
                found.is_some() == expected.is_some() && off <= 1e-11,
                "{found:?}"
            );
        }
    }

    #[test]
    fn only_a_ray_that_passes_well_beside_the_sphere_misses_it_clearly() {
        // from (−5, y, 0) along x: r² − y² against 10⁻⁵·(25 + y²), which is 0.00026
        for (y, clear) in [
            (2.0, true),
            (1.01, true),
            (1.0001, false),
            (1.0, false),
            (0.5, false),
        ] {
            let ray = Ray::new(DVec3::new(-5.0, y, 0.0), 3.0 * DVec3::X);
            assert_eq!(is_clearly_missed(&UNIT, &ray), clear, "{y}");
        }
        // a direction of zero says nothing
        let still = Ray::new(DVec3::new(-5.0, 2.0, 0.0), DVec3::ZERO);
        assert!(!is_clearly_missed(&UNIT, &still));
    }

    #[test]
    fn a_sphere_of_any_size_and_place_is_missed_by_its_own_radius() {
        let ball = Sphere {
            center: DVec3::new(3.0, 4.0, 5.0),
            radius: 2.0,
        };
        for (y, clear) in [
            (7.0, true),
            (6.1, true),
            (5.9, false),
            (4.0, false),
            (2.1, false),
            (1.9, true),
        ] {
            let ray = Ray::new(DVec3::new(-2.0, y, 5.0), DVec3::X);
            assert_eq!(is_clearly_missed(&ball, &ray), clear, "{y}");
        }
    }
}
