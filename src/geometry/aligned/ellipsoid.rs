//! The ellipsoid with the ray along z: its axes are no longer those of the coordinates.

use glam::DVec3;

use crate::geometry::aligned::lost_digits;
use crate::geometry::quadratic::Quadratic;
use crate::geometry::{AlignedRay, Ellipsoid, QuadraticTest, Ray, Sides, TRange};

impl Ellipsoid {
    /// Where does the z axis meet the transformed ellipsoid?
    ///
    /// (iii) for the unit sphere and the ray of [`Ellipsoid::unit_ray`]; Δ′ has no unit length, and a ≠ 1
    /// (erratum 11). Degenerate cases are those of [`Sphere::test`](crate::geometry::Sphere::test).
    #[inline]
    pub fn test_aligned(&self, ray: &AlignedRay, range: TRange, sides: Sides) -> QuadraticTest {
        let scaled = self.unit_ray(ray);
        let test = Quadratic::of_sphere(&scaled, DVec3::ZERO, 1.0).test(range, sides, |_| false);
        // the center is rounded by its distance, whichever radius that is divided by
        let smallest = self.radii.min_element();
        let reach2 = (ray.world.origin - self.center).length_squared() / (smallest * smallest);
        if lost_digits(&test, test.a, reach2) {
            return self.test(&ray.world, range, sides);
        }
        test
    }

    /// What is the z axis in the space in which the transformed ellipsoid is the unit sphere?
    ///
    /// With the center c′ and the half axes hᵢ = rᵢ·uᵢ, which the rotation has turned:
    /// o′ᵢ = hᵢ·(0 − c′)/rᵢ²,  Δ′ᵢ = hᵢ·Δ/rᵢ², where hᵢ·Δ is the z of hᵢ for a unit ray.
    #[inline]
    pub fn unit_ray(&self, ray: &AlignedRay) -> Ray {
        let center = ray.frame.point(self.center);
        let turned = DVec3::AXES.map(|axis| ray.frame.vector(axis));
        let along = |v: DVec3| DVec3::from_array(turned.map(|axis| axis.dot(v)));
        let direction = DVec3::from_array(turned.map(|axis| axis.z * ray.length));
        Ray::new(along(-center) / self.radii, direction / self.radii)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_half_axis_that_the_rotation_turns_to_z_is_where_the_ray_meets_it() {
        // along (0.6, 0, 0.8) at the center (6, 0, 8): the half axis along x lies at 0.6 to z
        let egg = Ellipsoid {
            center: DVec3::new(6.0, 0.0, 8.0),
            radii: DVec3::new(0.6, 1.0, 0.8),
        };
        let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8)));
        // (0.6·t/0.6)² + (0.8·t/0.8)² = 1 from the center on: t = 10 ± √½
        let test = egg.test_aligned(&ray, TRange::FORWARD, Sides::Both);
        let expected = 10.0 - 0.5_f64.sqrt();
        let found = test.roots.chosen().unwrap();
        assert!((found - expected).abs() <= 1e-14 * expected, "{found}");
        assert!((test.a - 2.0).abs() <= 1e-15, "{test:?}");
    }

    #[test]
    fn a_ray_of_another_length_has_its_t_in_its_own_lengths() {
        let egg = Ellipsoid {
            center: DVec3::new(6.0, 0.0, 8.0),
            radii: DVec3::new(0.6, 1.0, 0.8),
        };
        let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, DVec3::new(2.4, 0.0, 3.2)));
        // as above with |Δ| = 4: a = 2·16, and t = (10 − √½)/4
        let test = egg.test_aligned(&ray, TRange::FORWARD, Sides::Both);
        assert!((test.a - 32.0).abs() <= 1e-13, "{test:?}");
        let expected = 0.25 * (10.0 - 0.5_f64.sqrt());
        assert!((test.roots.chosen().unwrap() - expected).abs() <= 1e-14);
    }

    #[test]
    fn a_c_that_is_small_beside_the_smallest_radius_is_that_of_the_world() {
        // the center is rounded by some 10⁻¹⁶ of 30, which is 10⁻¹² of the thickness
        let sheet = Ellipsoid {
            center: DVec3::new(-15.0, 0.0, 0.0),
            radii: DVec3::new(10.0, 10.0, 1e-3),
        };
        for k in 0..8 {
            let origin = DVec3::new(15.0, 0.1 * f64::from(k), 0.0);
            let ray = Ray::new(origin, DVec3::new(-0.6, 0.48, 0.64));
            let world = sheet.test(&ray, TRange::FORWARD, Sides::Both);
            let test = sheet.test_aligned(&AlignedRay::new(&ray), TRange::FORWARD, Sides::Both);
            assert_eq!(test, world, "{k}");
        }
    }
}
