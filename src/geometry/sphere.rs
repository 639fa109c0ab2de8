//! The sphere: the slides' quadratic (iii), its roots and its normal.

use glam::DVec3;

use crate::geometry::quadratic::Quadratic;
use crate::geometry::twofold::{Twofold, TwofoldVec};
use crate::geometry::{QuadraticTest, Ray, Sides, TRange};

/// (x − a)² + (y − b)² + (z − c)² = r² … (ii)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// (a, b, c), in world coordinates.
    pub center: DVec3,
    /// The radius r, above 0.
    pub radius: f64,
}

impl Sphere {
    /// Where does the ray hit the sphere?
    ///
    /// a·t² + b·t + c = 0 … (iii), with
    /// a = Δx² + Δy² + Δz² (1 for a unit ray),
    /// b = 2[Δx(x₀ − a) + Δy(y₀ − b) + Δz(z₀ − c)],
    /// c = (x₀ − a)² + (y₀ − b)² + (z₀ − c)² − r² (negative if the ray starts inside).
    ///
    /// The ray may have any length. No real root if the line passes by; a graze if |b² − 4ac| is
    /// within [`GRAZE`](crate::geometry::GRAZE)·4a·r²; from inside, the near root lies behind the
    /// origin and the far one is the hit. A direction of zero gives no root.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Ray, Sides, Sphere, TRange};
    ///
    /// let sphere = Sphere { center: DVec3::new(0.0, 1.0, 0.0), radius: 1.0 };
    /// let ray = Ray::new(DVec3::new(0.0, 1.0, 6.0), DVec3::new(0.0, 0.0, -1.0));
    /// let test = sphere.test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!((test.a, test.b, test.c), (1.0, -12.0, 35.0)); // 6² − 1² = 35
    /// assert_eq!(test.discriminant, 4.0); // 144 − 140
    /// assert_eq!(test.roots.chosen(), Some(5.0)); // (12 − 2) / 2
    /// ```
    #[inline]
    pub fn test(&self, ray: &Ray, range: TRange, sides: Sides) -> QuadraticTest {
        Quadratic::of_sphere(ray, self.center, self.radius).test(range, sides, |_| false)
    }

    /// ((x − a)/r, (y − b)/r, (z − c)/r): the unit normal at a point of the surface, outwards.
    ///
    /// A computed point is on the surface but for its rounding, so the quotient is brought to unit
    /// length once more; in the center itself, where no normal exists, it points up.
    pub fn normal(&self, point: DVec3) -> DVec3 {
        ((point - self.center) / self.radius).normalize_or(DVec3::Y)
    }
}

/// Below this geometric mean of two shares of |Δ|²|o − center|², the discriminant's and that of the
/// larger of it and (b/2)², the discriminant is taken again. With D a quarter of it, the larger root is
/// (|b|/2 + √D)/a: the plain rounding of D, some 10⁻¹⁵ of |Δ|²|o − center|², changes that by
/// 10⁻¹⁵/(2·10⁻⁵) = 5·10⁻¹¹ of itself at most, from afar as from close to the surface.
pub(crate) const DISCRIMINANT_CANCELS: f64 = 1e-5;
/// Below this share of r², c has lost digits and is taken again, for the same reason.
pub(super) const C_CANCELS: f64 = 1e-6;

impl Quadratic {
    /// Equation (iii).
    ///
    /// With o = origin − center and Lagrange's identity (o·Δ)² = |o|²|Δ|² − |o × Δ|²:
    ///
    /// b² − 4ac = 4(o·Δ)² − 4|Δ|²(|o|² − r²) = 4(a·r² − |o × Δ|²)
    ///
    /// |o × Δ| / |Δ| is the distance at which the line passes the center, so this compares two lengths
    /// instead of subtracting two large products.
    #[inline]
    pub(crate) fn of_sphere(ray: &Ray, center: DVec3, radius: f64) -> Self {
        let offset = ray.origin - center;
        let offset2 = offset.length_squared();
        let radius2 = radius * radius;

        let a = ray.direction.length_squared();
        let b = 2.0 * ray.direction.dot(offset);
        let mut c = offset2 - radius2;
        let mut inside = a * radius2 - ray.direction.cross(offset).length_squared();

        // the first comparison follows from the second, and settles it for nearly every ray
        let plain = DISCRIMINANT_CANCELS * a * offset2;
        let cancels =
            inside.abs() < plain && inside.abs() * inside.abs().max(0.25 * b * b) < plain * plain;
        if cancels || c.abs() < C_CANCELS * radius2 {
            (c, inside) = with_twice_the_precision(ray, center, radius);
        }
        Self {
            a,
            b,
            c,
            discriminant: 4.0 * inside,
            scale: 4.0 * a * radius2,
        }
    }
}

/// c and a·r² − |o × Δ|², both with about 32 digits before they are rounded.
#[cold]
fn with_twice_the_precision(ray: &Ray, center: DVec3, radius: f64) -> (f64, f64) {
    let offset = TwofoldVec::difference(ray.origin, center);
    let direction = TwofoldVec::from(ray.direction);
    let radius2 = Twofold::product(radius, radius);
    let c = offset.length_squared() - radius2;
    let inside = direction.length_squared() * radius2 - direction.cross(offset).length_squared();
    (c.value(), inside.value())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Root, RootVerdict, Roots};

    const UNIT: Sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };

    fn root(t: f64, verdict: RootVerdict) -> Root {
        Root { t, verdict }
    }

    #[track_caller]
    fn check(sphere: Sphere, origin: [f64; 3], direction: [f64; 3], range: TRange, roots: Roots) {
        let ray = Ray::new(origin.into(), direction.into());
        let test = sphere.test(&ray, range, Sides::Both);
        assert_eq!(test.roots, roots, "{test:?}");
    }

    #[test]
    fn ray_passing_above_the_sphere_has_no_real_root() {
        // b² − 4ac = 4(1 − 2²) = −12
        let ray = Ray::new(DVec3::new(-5.0, 2.0, 0.0), DVec3::X);
        let test = UNIT.test(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!(test.discriminant, -12.0);
        assert_eq!(test.roots, Roots::None);
    }

    #[test]
    fn ray_along_a_tangent_grazes_in_one_root() {
        let roots = Roots::Graze(root(5.0, RootVerdict::Chosen));
        check(
            UNIT,
            [-5.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            TRange::FORWARD,
            roots,
        );
    }

    #[test]
    fn ray_through_the_center_has_two_roots_and_the_nearer_is_the_hit() {
        let roots = Roots::Two {
            near: root(4.0, RootVerdict::Chosen),
            far: root(6.0, RootVerdict::BeyondNearest),
        };
        check(
            UNIT,
            [-5.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            TRange::FORWARD,
            roots,
        );
    }

    #[test]
    fn ray_starting_inside_the_sphere_hits_the_far_root() {
        let roots = Roots::Two {
            near: root(-1.0, RootVerdict::Behind),
            far: root(1.0, RootVerdict::Chosen),
        };
        check(UNIT, [0.0; 3], [0.0, 1.0, 0.0], TRange::FORWARD, roots);
    }

    #[test]
    fn sphere_behind_the_origin_has_both_roots_behind() {
        let roots = Roots::Two {
            near: root(-6.0, RootVerdict::Behind),
            far: root(-4.0, RootVerdict::Behind),
        };
        check(
            UNIT,
            [5.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            TRange::FORWARD,
            roots,
        );
    }

    #[test]
    fn ray_starting_on_the_surface_leaves_its_own_root_below_epsilon() {
        let on_surface = [-1.0 - 1e-12, 0.0, 0.0];
        let range = TRange {
            min: 1e-9,
            ..TRange::FORWARD
        };
        let ray = Ray::new(on_surface.into(), DVec3::X);
        let Roots::Two { near, far } = UNIT.test(&ray, range, Sides::Both).roots else {
            panic!("two roots");
        };
        assert_eq!(
            (near.verdict, far.verdict),
            (RootVerdict::BelowEpsilon, RootVerdict::Chosen)
        );
    }

    #[test]
    fn a_root_at_the_end_of_the_range_counts_and_one_beyond_it_does_not() {
        let far = root(6.0, RootVerdict::BeyondNearest);
        let near = |verdict| root(4.0, verdict);
        for (max, verdict) in [
            (4.0, RootVerdict::Chosen),
            (3.999, RootVerdict::BeyondNearest),
        ] {
            let roots = Roots::Two {
                near: near(verdict),
                far,
            };
            check(
                UNIT,
                [-5.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                TRange::FORWARD.up_to(max),
                roots,
            );
        }
    }

    #[test]
    fn a_sphere_that_shows_one_side_is_hit_on_that_side() {
        let ray = Ray::new(DVec3::new(-5.0, 0.0, 0.0), DVec3::X);
        let hit = |ray: &Ray, sides| UNIT.test(ray, TRange::FORWARD, sides).roots.chosen();
        assert_eq!(hit(&ray, Sides::Front), Some(4.0));
        assert_eq!(hit(&ray, Sides::Back), Some(6.0));
        let inside = Ray::new(DVec3::ZERO, DVec3::X);
        assert_eq!(hit(&inside, Sides::Front), None);
        assert_eq!(hit(&inside, Sides::Back), Some(1.0));
    }

    #[test]
    fn t_of_a_ray_that_is_not_normalised_counts_its_own_length() {
        // erratum 11: a = 4, and the hit at distance 4 lies at t = 2
        let ray = Ray::new(DVec3::new(-5.0, 0.0, 0.0), 2.0 * DVec3::X);
        let test = UNIT.test(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!((test.a, test.b, test.c), (4.0, -20.0, 24.0));
        assert_eq!(test.roots.chosen(), Some(2.0));
    }

    #[test]
    fn a_huge_sphere_close_by_keeps_its_digits() {
        // the sphere's top is at y = −1 exactly
        let earth = Sphere {
            center: DVec3::new(0.0, -1e9, 0.0),
            radius: 1e9 - 1.0,
        };
        let ray = Ray::new(DVec3::ZERO, -DVec3::Y);
        assert_eq!(
            earth
                .test(&ray, TRange::FORWARD, Sides::Both)
                .roots
                .chosen(),
            Some(1.0)
        );
    }

    #[test]
    fn a_direction_of_zero_gives_no_root() {
        check(
            UNIT,
            [0.5, 0.0, 0.0],
            [0.0; 3],
            TRange::FORWARD,
            Roots::None,
        );
    }

    #[test]
    fn the_normal_is_the_unit_vector_from_the_center() {
        let sphere = Sphere {
            center: DVec3::new(1.0, 2.0, 3.0),
            radius: 2.0,
        };
        assert_eq!(sphere.normal(DVec3::new(1.0, 4.0, 3.0)), DVec3::Y);
    }

    #[test]
    fn a_graze_is_measured_by_the_size_of_the_sphere_and_of_the_direction() {
        // at y = r(1 − nε), along 4x: 4·16(r² − y²) = 128nε·r², and 4ε·4·16·r² is a graze
        for radius in [1.0, 1024.0, 1.0 / 1024.0] {
            let ball = Sphere {
                center: DVec3::ZERO,
                radius,
            };
            for (n, grazes) in [(1.0, true), (2.0, true), (3.0, false)] {
                let origin = DVec3::new(-5.0 * radius, radius * (1.0 - n * f64::EPSILON), 0.0);
                let ray = Ray::new(origin, 4.0 * DVec3::X);
                let roots = ball.test(&ray, TRange::FORWARD, Sides::Both).roots;
                assert_eq!(
                    matches!(roots, Roots::Graze(_)),
                    grazes,
                    "{radius} {n}: {roots:?}"
                );
            }
        }
    }

    #[test]
    fn what_cancels_in_the_discriminant_is_taken_again_to_the_last_digit_at_every_size() {
        // Δ = (3, 4, 0), o = m(4, −3, 0) + (0, 0, n) + sΔ: |o × Δ|² = 25(25m² + n²), so that with r = 5m + 1
        // a·r² − |o × Δ|² = 25(10m + 1 − n²); with n = 20001 and 10m = n² + 99999 that is 25·100000
        let (m, n) = (40_014_000.0, 20_001.0);
        let direction = DVec3::new(3.0, 4.0, 0.0);
        for size in [1.0, 2.0_f64.powi(-40), 2.0_f64.powi(40)] {
            let ball = Sphere {
                center: DVec3::ZERO,
                radius: size * (5.0 * m + 1.0),
            };
            let test = |s: f64| {
                let origin = DVec3::new(4.0 * m, -3.0 * m, n) + s * direction;
                ball.test(
                    &Ray::new(size * origin, direction),
                    TRange::FORWARD,
                    Sides::Both,
                )
            };
            // 10¹⁸ − 10¹⁸, each rounded to 128
            let far = test(-40_000_000.0);
            assert_eq!(far.discriminant / size / size, 1e7);
            // c = |o|² − r² = 25s² − 100000, of two squares of 17 digits
            let close = test(-100.0);
            assert_eq!(close.c / size / size, 150_000.0);
            assert_eq!(close.discriminant / size / size, 1e7);
        }
    }
}
