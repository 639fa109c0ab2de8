//! The sphere with the ray along z.

use crate::geometry::aligned::lost_digits;
use crate::geometry::quadratic::Quadratic;
use crate::geometry::{AlignedRay, QuadraticTest, Sides, Sphere, TRange};

impl Sphere {
    /// Where does the z axis meet the transformed sphere?
    ///
    /// (ii) at x = y = 0, with the center c′ = (c_x, c_y, c_z): z = c_z ± √(r² − c_x² − c_y²).
    ///
    /// As (iii), with o = (0, 0, 0) and Δ = (0, 0, 1): a = 1, b = −2c_z, c = |c′|² − r², and
    /// b² − 4ac = 4(r² − c_x² − c_y²). A ray of another length has z = t·|Δ|.
    ///
    /// Degenerate cases are those of [`Sphere::test`].
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{AlignedRay, Ray, Sides, Sphere, TRange};
    ///
    /// let ball = Sphere { center: DVec3::new(3.0, 3.0, 4.0), radius: 5.0 };
    /// let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8)));
    /// let test = ball.test_aligned(&ray, TRange::FORWARD, Sides::Both); // c′ = (3, 0, 5)
    /// assert_eq!((test.a, test.b, test.c), (1.0, -10.0, 9.0)); // 3² + 5² − 5²
    /// assert_eq!(test.roots.chosen(), Some(1.0)); // 5 − √(25 − 9)
    /// ```
    #[inline]
    pub fn test_aligned(&self, ray: &AlignedRay, range: TRange, sides: Sides) -> QuadraticTest {
        let center = ray.frame.point(self.center);
        let length2 = ray.length * ray.length;
        let radius2 = self.radius * self.radius;
        let equation = Quadratic {
            a: length2,
            b: -2.0 * ray.length * center.z,
            c: center.length_squared() - radius2,
            discriminant: 4.0 * length2 * (radius2 - center.truncate().length_squared()),
            scale: 4.0 * length2 * radius2,
        };
        let test = equation.test(range, sides, |_| false);
        if lost_digits(&test, length2, center.length_squared()) {
            return self.test(&ray.world, range, sides);
        }
        test
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::{Ray, Roots};

    #[test]
    fn the_coefficients_go_with_the_lengths_of_the_ray_and_of_the_sphere() {
        // c′ = (3, 0, 5) and |Δ| = 2: a = 2², b = −2·2·5, c = 3² + 5² − 5², b² − 4ac = 400 − 144
        let (large, small) = (2.0_f64.powi(20), 2.0_f64.powi(-20));
        for (size, length) in [
            (1.0, 1.0),
            (large, 1.0),
            (small, 1.0),
            (1.0, large),
            (1.0, small),
        ] {
            let ball = Sphere {
                center: size * DVec3::new(3.0, 3.0, 4.0),
                radius: 5.0 * size,
            };
            let direction = length * DVec3::new(1.2, 0.0, 1.6);
            let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, direction));
            let test = ball.test_aligned(&ray, TRange::FORWARD, Sides::Both);
            let Roots::Two { near, far } = test.roots else {
                panic!("{test:?}");
            };
            let both = size * length;
            // t of (20 ∓ 16)/8
            for (found, expected) in [
                (test.a / length / length, 4.0),
                (test.b / both, -20.0),
                (test.c / size / size, 9.0),
                (test.discriminant / both / both, 256.0),
                (near.t * length / size, 0.5),
                (far.t * length / size, 4.5),
            ] {
                assert!(
                    (found - expected).abs() <= 1e-15 * 256.0,
                    "{expected}: {test:?}"
                );
            }
        }
    }
}
