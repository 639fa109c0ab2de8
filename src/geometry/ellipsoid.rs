//! The ellipsoid with axes along x, y and z: a unit sphere in a space of its own.

use glam::DVec3;

use crate::geometry::quadratic::Quadratic;
use crate::geometry::{QuadraticTest, Ray, Sides, TRange};

/// ((x − a)/rₓ)² + ((y − b)/r_y)² + ((z − c)/r_z)² = 1
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// (a, b, c), in world coordinates.
    pub center: DVec3,
    /// (rₓ, r_y, r_z), each > 0.
    pub radii: DVec3,
}

impl Ellipsoid {
    /// Where does the ray hit the ellipsoid?
    ///
    /// The slides' (iii) for the unit sphere and the ray o′ + t·Δ′, with o′ = (o − center)/radii and
    /// Δ′ = Δ/radii. The transformation is linear, so t stays what it was; but Δ′ has no unit length
    /// and a ≠ 1 (erratum 11).
    ///
    /// Degenerate cases are those of [`Sphere::test`](crate::geometry::Sphere::test).
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Ellipsoid, Ray, Sides, TRange};
    ///
    /// let egg = Ellipsoid { center: DVec3::ZERO, radii: DVec3::new(2.0, 1.0, 1.0) };
    /// let ray = Ray::new(DVec3::new(-6.0, 0.0, 0.0), DVec3::X);
    /// let test = egg.test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!((test.a, test.b, test.c), (0.25, -3.0, 8.0)); // (1/2)², 2·(1/2)·(−3), 3² − 1
    /// assert_eq!(test.roots.chosen(), Some(4.0)); // (3 − √(9 − 8)) / 0.5
    /// ```
    #[inline]
    pub fn test(&self, ray: &Ray, range: TRange, sides: Sides) -> QuadraticTest {
        let in_unit_space = Ray::new(
            (ray.origin - self.center) / self.radii,
            ray.direction / self.radii,
        );
        Quadratic::of_sphere(&in_unit_space, DVec3::ZERO, 1.0).test(range, sides, |_| false)
    }

    /// The unit normal at a point of the surface, outwards: the gradient of the equation, normalised.
    pub fn normal(&self, point: DVec3) -> DVec3 {
        let gradient = (point - self.center) / self.radii / self.radii;
        gradient.normalize_or(DVec3::Y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Roots, Sphere};

    const EGG: Ellipsoid = Ellipsoid {
        center: DVec3::new(1.0, 0.0, 0.0),
        radii: DVec3::new(4.0, 2.0, 1.0),
    };

    #[test]
    fn each_axis_is_met_at_its_own_radius() {
        for (axis, radius) in [(DVec3::X, 4.0), (DVec3::Y, 2.0), (DVec3::Z, 1.0)] {
            let ray = Ray::new(EGG.center + 10.0 * axis, -axis);
            let test = EGG.test(&ray, TRange::FORWARD, Sides::Both);
            assert_eq!(test.roots.chosen(), Some(10.0 - radius));
        }
    }

    #[test]
    fn a_ray_that_a_sphere_of_the_largest_radius_would_catch_can_miss() {
        let ray = Ray::new(DVec3::new(-9.0, 0.0, 1.5), DVec3::X);
        let test = EGG.test(&ray, TRange::FORWARD, Sides::Both);
        // a = 1/16, o′ = (−2.5, 0, 1.5), b = 2·(−2.5/4) = −1.25, c = 6.25 + 2.25 − 1 = 7.5
        assert_eq!((test.a, test.b, test.c), (0.0625, -1.25, 7.5));
        assert_eq!(test.discriminant, 1.5625 - 1.875);
        assert_eq!(test.roots, Roots::None);
    }

    #[test]
    fn equal_radii_give_the_roots_of_the_sphere() {
        let center = DVec3::new(0.5, -1.0, 2.0);
        let ball = Ellipsoid {
            center,
            radii: DVec3::splat(2.0),
        };
        let sphere = Sphere {
            center,
            radius: 2.0,
        };
        let ray = Ray::new(DVec3::new(5.0, 0.0, 1.0), DVec3::new(-1.0, -0.25, 0.125));
        let hit = |test: QuadraticTest| test.roots.chosen().unwrap();
        let (a, b) = (
            hit(ball.test(&ray, TRange::FORWARD, Sides::Both)),
            hit(sphere.test(&ray, TRange::FORWARD, Sides::Both)),
        );
        assert!((a - b).abs() <= 1e-14 * b, "{a} {b}");
    }

    #[test]
    fn the_normal_leans_towards_the_short_axis() {
        // at (1 + 4·0.6, 2·0.8, 0) the gradient is (0.6/4, 0.8/2, 0) = (0.15, 0.4, 0)
        let normal = EGG.normal(DVec3::new(3.4, 1.6, 0.0));
        let expected = DVec3::new(0.15, 0.4, 0.0) / (0.15f64 * 0.15 + 0.4 * 0.4).sqrt();
        assert!((normal - expected).length() <= 1e-15, "{normal}");
    }
}
