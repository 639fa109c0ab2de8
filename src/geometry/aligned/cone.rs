//! The open cone with the ray along z.

use crate::geometry::aligned::lost_digits;
use crate::geometry::{AlignedRay, Cone, QuadraticTest, Root, Sides, TRange};

/// A root so near to an end of the cone, relative to the numbers involved, is taken from the world: its own
/// error is smaller than that wherever [`lost_digits`] lets it pass.
const END: f64 = 1e-9;

impl Cone {
    /// Where does the z axis meet the transformed cone?
    ///
    /// The equation of [`Cone::test`] with o = (0, 0, 0) and Δ = (0, 0, 1): with the axis w′ and base b′,
    /// Δ·w is the z of w′, and m = −b′. Degenerate cases are those of [`Cone::test`].
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{AlignedRay, Cone, Ray, Sides, TRange};
    ///
    /// let pipe = Cone::new(DVec3::new(6.0, -9.0, 8.0), 1.0, DVec3::new(6.0, 9.0, 8.0), 1.0).unwrap();
    /// let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8)));
    /// let test = pipe.test_aligned(&ray, TRange::FORWARD, Sides::Both); // around x′ at z′ = 10
    /// assert_eq!((test.a, test.b, test.c), (1.0, -20.0, 99.0));
    /// assert_eq!(test.roots.chosen(), Some(9.0));
    /// ```
    #[inline]
    pub fn test_aligned(&self, ray: &AlignedRay, range: TRange, sides: Sides) -> QuadraticTest {
        let aligned = self.aligned(&ray.frame);
        let test = aligned.test(&ray.in_frame(), range, sides);
        // k·(m·w) and k·(Δ·w) enter beside m and Δ
        let steepness = 1.0 + self.slope().abs();
        let offset = (ray.world.origin - self.base()).length() + self.radii()[0];
        let direction2 = steepness * steepness * ray.length * ray.length;
        // where a root lies on an end, its rounding decides whether it counts
        let near_end = |root: Root| {
            let y = aligned
                .axis()
                .dot(ray.in_frame().at(root.t) - aligned.base());
            let rounding = END * (offset + self.height() + root.t.abs() * ray.length);
            y.abs() <= rounding || (y - self.height()).abs() <= rounding
        };
        if lost_digits(&test, direction2, steepness * steepness * offset * offset)
            || test.roots.iter().any(near_end)
        {
            return self.test(&ray.world, range, sides);
        }
        test
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use glam::DVec3;

    use super::*;
    use crate::geometry::Ray;

    /// Radius 3 at y = 2, radius 2 at y = 6: k = −¼.
    fn frustum() -> Cone {
        let base = DVec3::new(1.0, 2.0, 3.0);
        Cone::new(base, 3.0, base + 4.0 * DVec3::Y, 2.0).unwrap()
    }

    /// The point so high over the base and so far from the axis, in one of twelve directions.
    fn around(height: f64, radius: f64, hour: u32) -> DVec3 {
        let (sine, cosine) = (f64::from(hour) * PI / 6.0 + 0.1).sin_cos();
        frustum().base() + DVec3::new(radius * cosine, height, radius * sine)
    }

    /// For how many of twelve rays are the numbers not those of the world? The aligned ones differ in their last
    /// digits for most.
    fn own_numbers(ray: impl Fn(u32) -> Ray) -> usize {
        let differs = |ray: Ray| {
            let world = frustum().test(&ray, TRange::FORWARD, Sides::Both);
            world != frustum().test_aligned(&AlignedRay::new(&ray), TRange::FORWARD, Sides::Both)
        };
        (0..12).filter(|&hour| differs(ray(hour))).count()
    }

    /// Below the bound all numbers are those of the world; beyond it some are not, or nothing would have been shown.
    #[track_caller]
    fn check(ray: impl Fn(f64, f64, u32) -> Ray) {
        for length in [0.25, 1.0, 4.0] {
            assert_eq!(own_numbers(|hour| ray(0.9, length, hour)), 0, "{length}");
            assert!(0 < own_numbers(|hour| ray(1.1, length, hour)), "{length}");
        }
    }

    #[test]
    fn within_a_billionth_of_the_sizes_a_hit_on_an_end_is_that_of_the_world() {
        // in front of the origin, and behind it
        for (from_base, inwards, way) in [(0.0, 1.0, 1.0), (4.0, -1.0, 1.0), (4.0, -1.0, -1.0)] {
            check(|share, length, hour| {
                let origin = around(7.0, 9.0, hour + 1);
                let distance = (around(from_base, 3.0 - 0.25 * from_base, hour) - origin).length();
                // |o − base| + r_base, the height, and t·|Δ|
                let sizes = (origin - frustum().base()).length() + 3.0 + 4.0 + distance;
                let y = from_base + inwards * share * 1e-9 * sizes;
                let end = around(y, 3.0 - 0.25 * y, hour);
                Ray::new(origin, way * length * (end - origin).normalize())
            });
        }
    }

    #[test]
    fn close_to_the_surface_the_numbers_are_those_of_the_world() {
        check(|share, length, hour| {
            // c = ρ² − R² with R = 2.75, against 10⁻⁶·(1 + |k|)²(|o − base| + r_base)²; the latter hardly changes with ρ
            let offset = around(1.0, 2.75, hour) - frustum().base();
            let size = 1.25 * (offset.length() + 3.0);
            let radius = (2.75 * 2.75 + share * 1e-6 * size * size).sqrt();
            let origin = around(1.0, radius, hour);
            let target = around(2.0, 1.0, hour + 3);
            Ray::new(origin, length * (target - origin).normalize())
        });
    }

    #[test]
    fn close_to_the_direction_of_a_generator_the_numbers_are_those_of_the_world() {
        check(|share, length, hour| {
            // a/|Δ|² = sin² − k²cos² = 1 − 17/16·cos², against 10⁻⁵·(1 + |k|)²
            let cosine = ((1.0 - share * 1e-5 * 1.25 * 1.25) * 16.0 / 17.0).sqrt();
            let sine = (1.0 - cosine * cosine).sqrt();
            let direction = around(cosine, sine, hour) - frustum().base();
            Ray::new(around(0.5, 0.5, hour + 5), length * direction)
        });
    }
}
