//! ε: how far from its origin a ray must go before a hit counts.
//!
//! The slides ask for the smallest positive t. A ray that starts on a surface would hit that surface
//! again at a t of rounding size, so it needs t > ε (erratum 8).

use glam::DVec3;

/// ε as a share of the numbers that the point was computed from.
///
/// A point's coordinates are wrong by some 10⁻¹⁵ of those numbers, more where a ray hits a surface
/// flatly; 10⁻⁹ leaves room for a million times that and is far below anything that shows in a
/// picture.
pub const EPSILON: f64 = 1e-9;

/// What the surface's own size adds: the rounding of a huge sphere is that of its radius, not of the
/// point's coordinates.
const SURFACE: f64 = 1e-13;

/// The smallest t that counts for a ray that starts at a point where another ray ended at t.
///
/// ε = max(10⁻⁹ · max(|x|, |y|, |z|, t), 10⁻¹³ · reach)
///
/// `reach` is the surface's largest coordinate or radius
/// ([`Shape::reach`](crate::scene::Shape::reach)). ε scales with the scene.
#[doc(alias = "shadow acne")]
#[doc(alias = "shadow bias")]
#[doc(alias = "t_min")]
pub fn start_epsilon(point: DVec3, t: f64, reach: f64) -> f64 {
    let numbers = point.abs().max_element().max(t);
    (EPSILON * numbers).max(SURFACE * reach)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn epsilon_is_a_billionth_of_the_largest_number_that_the_point_was_computed_from() {
        let of = |t, reach| start_epsilon(DVec3::new(3.0, -4.0, 2.0), t, reach);
        // the coordinate 4, t = 10, and of a surface that reaches to 10⁶ a part in 10¹³
        for (found, expected) in [
            (of(1.0, 5.0), 4e-9),
            (of(10.0, 5.0), 1e-8),
            (of(1.0, 1e6), 1e-7),
        ] {
            assert!((found - expected).abs() <= 1e-15 * expected, "{found}");
        }
    }
}
