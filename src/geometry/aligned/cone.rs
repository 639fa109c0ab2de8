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
    /// use raystep::{AlignedRay, Cone, Ray, Sides, TRange};
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
