//! The ray in parametric form, the slides' equation (i), and the stretch of it that is searched.

use glam::DVec3;

/// Where is the point that belongs to a value of t?
///
/// x = x₀ + t·Δx, y = y₀ + t·Δy, z = z₀ + t·Δz … (i)
///
/// What t measures depends on the length of (Δx, Δy, Δz), and the slides use both cases
/// (erratum 4):
/// - [`Ray::through`] a pixel's centre: t = 0 at the centre of projection, t = 1 on the window;
/// - [`Ray::normalised`]: t is a distance in world units, and the window lies at t = the distance to
///   the pixel's centre, not at 1.
///
/// In both, t < 0 lies behind the origin.
///
/// ```
/// use glam::DVec3;
/// use raystep::geometry::Ray;
///
/// let to_pixel = Ray::through(DVec3::new(0.0, 1.0, 6.0), DVec3::new(3.0, 1.0, 2.0));
/// assert_eq!(to_pixel.at(1.0), DVec3::new(3.0, 1.0, 2.0));
/// let (unit, distance) = to_pixel.normalised().unwrap();
/// assert_eq!(distance, 5.0); // √(3² + 0² + 4²)
/// assert_eq!(unit.direction, DVec3::new(0.6, 0.0, -0.8));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ray {
    /// (x₀, y₀, z₀), in world coordinates.
    pub origin: DVec3,
    /// (Δx, Δy, Δz); of unit length wherever the tracer makes the ray.
    pub direction: DVec3,
}

impl Ray {
    /// The ray from an origin along a direction of any length.
    pub const fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction }
    }

    /// The ray from (x₀, y₀, z₀) to (x₁, y₁, z₁): t is 0 at the first point and 1 at the second.
    pub fn through(from: DVec3, to: DVec3) -> Self {
        Self::new(from, to - from)
    }

    /// The point at t.
    #[inline]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// The same ray with |Δ| = 1, and the length that Δ had: the t at which the former t = 1 now lies.
    ///
    /// `None` if the direction is zero or its length is beyond f64.
    pub fn normalised(&self) -> Option<(Self, f64)> {
        let length = self.direction.length();
        if !length.is_finite() || length <= 0.0 {
            return None;
        }
        Some((Self::new(self.origin, self.direction / length), length))
    }
}

/// Which t count? Those with t > 0 and `min` ≤ t ≤ `max`.
///
/// `min` is 0 for an eye ray and ε for a ray that starts on a surface, so that it does not hit that
/// surface again (erratum 8). `max` is the nearest hit so far, or the distance to the light; both
/// ends count, because of two objects at equal t the one that comes first in the scene wins, and
/// that is decided by whoever compares them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TRange {
    /// The smallest t that counts (ε), at least 0.
    pub min: f64,
    /// The largest t that counts; `f64::INFINITY` if there is no limit.
    pub max: f64,
}

impl TRange {
    /// Everything in front of the origin.
    pub const FORWARD: Self = Self {
        min: 0.0,
        max: f64::INFINITY,
    };

    /// The same range, cut off at `max`.
    #[inline]
    #[must_use]
    pub fn up_to(self, max: f64) -> Self {
        Self {
            max: self.max.min(max),
            ..self
        }
    }
}

impl Default for TRange {
    fn default() -> Self {
        Self::FORWARD
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn t_is_one_on_the_window_until_the_ray_is_normalised() {
        let ray = Ray::through(DVec3::new(1.0, 1.0, 1.0), DVec3::new(3.0, 4.0, 7.0));
        assert_eq!(ray.direction, DVec3::new(2.0, 3.0, 6.0));
        assert_eq!(ray.at(1.0), DVec3::new(3.0, 4.0, 7.0));
        assert_eq!(ray.at(-1.0), DVec3::new(-1.0, -2.0, -5.0));
        let (unit, length) = ray.normalised().unwrap();
        assert_eq!(length, 7.0); // 4 + 9 + 36 = 49
        assert!((unit.at(7.0) - DVec3::new(3.0, 4.0, 7.0)).length() <= 1e-15);
    }

    #[test]
    fn a_ray_without_direction_cannot_be_normalised() {
        assert_eq!(Ray::through(DVec3::ONE, DVec3::ONE).normalised(), None);
        let endless = Ray::new(DVec3::ZERO, DVec3::splat(f64::MAX));
        assert_eq!(endless.normalised(), None);
    }
}
