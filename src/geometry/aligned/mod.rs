//! The tests of the shapes in the frame of the ray: o = (0, 0, 0), Δ = (0, 0, 1), and any hit at x = y = 0.
//!
//! Only the shape is transformed, and what its equation leaves at x = y = 0 is solved for z, which is t. Some
//! numbers are the same in both frames, because a rotation keeps lengths and angles: a plane's distance from
//! the origin, its cosine with the ray, the coefficients of a quadratic. The transformed points are rounded
//! once more than the world's, by some 10⁻¹⁶ of the object's distance. Two rules keep that from changing what
//! is hit:
//! - planes and slabs take D′ and C′ from the world, where they are not rounded that once more;
//! - a quadratic of which the aligned numbers leave too few digits (a graze, an origin close to the surface, a
//!   hit on the very end of a cone) is that of the world.

mod r#box;
mod cone;
mod ellipsoid;
mod polygon;
mod sphere;

pub use r#box::AlignedSlab;

use crate::geometry::QuadraticTest;
use crate::geometry::sphere::{C_CANCELS, DISCRIMINANT_CANCELS};

/// Did the rounding of the aligned points take more than the last six digits of a root?
///
/// The measure is that of [`Sphere::test`](crate::geometry::Sphere::test): `direction2` and `offset2` are the
/// squares of the sizes of Δ and of o − center among the numbers that entered the equation. A coefficient of
/// t² close to 0 (a cone along its generator) counts like a c close to 0.
#[inline]
fn lost_digits(test: &QuadraticTest, direction2: f64, offset2: f64) -> bool {
    let inside = 0.25 * test.discriminant.abs();
    let plain = DISCRIMINANT_CANCELS * direction2 * offset2;
    let half_b2 = 0.25 * test.b * test.b;
    let cancels = inside < plain && inside * inside.max(half_b2) < plain * plain;
    cancels
        || test.c.abs() < C_CANCELS * offset2
        || test.a.abs() < DISCRIMINANT_CANCELS * direction2
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A test of which all but two numbers are far from any bound.
    fn test(discriminant: f64, b: f64) -> QuadraticTest {
        QuadraticTest {
            a: 100.0,
            b,
            c: 1e9,
            discriminant,
            ..QuadraticTest::default()
        }
    }

    #[test]
    fn a_discriminant_has_lost_digits_below_a_share_that_falls_with_b() {
        // |Δ|² = 4 and |o|² = 25000: the share of 10⁻⁵ is D = 1, with D a quarter of the discriminant
        for (discriminant, b, lost) in [
            (3.6, 0.0, true), // 0.9² < 1
            (-3.6, 0.0, true),
            (4.4, 0.0, false), // 1.1
            (-4.4, 0.0, false),
            (1.0, 3.9, true),   // ¼·(3.9/2)² < 1
            (1.0, -4.1, false), // ¼·(4.1/2)² > 1
            (-0.01, 4.1, true),
        ] {
            let found = lost_digits(&test(discriminant, b), 4.0, 25_000.0);
            assert_eq!(found, lost, "{discriminant} {b}");
        }
        // four times as long a ray has D = 4: 3.6² < 4², 4.4² is not
        assert!(lost_digits(&test(14.4, 0.0), 16.0, 25_000.0));
        assert!(!lost_digits(&test(17.6, 0.0), 16.0, 25_000.0));
        // the bound itself is not below it: ¼·(4/2)² = 1
        assert_eq!(DISCRIMINANT_CANCELS * 1e5, 1.0);
        assert!(!lost_digits(&test(1.0, 4.0), 1.0, 1e5));
    }

    #[test]
    fn a_c_or_an_a_close_to_0_has_lost_digits() {
        let plain = test(1e9, 0.0);
        // a millionth of |o|² = 10⁶, and 10⁻⁵ of |Δ|² = 4
        for (a, c, lost) in [
            (1.0, 0.9, true),
            (1.0, -0.9, true),
            (1.0, 1.1, false),
            (3.9e-5, 1.1, true),
            (-3.9e-5, 1.1, true),
            (4.1e-5, 1.1, false),
            (-4.1e-5, -1.1, false),
            (4.0 * DISCRIMINANT_CANCELS, 1.1, false),
            (1.0, C_CANCELS * 1e6, false),
        ] {
            let found = lost_digits(&QuadraticTest { a, c, ..plain }, 4.0, 1e6);
            assert_eq!(found, lost, "{a} {c}");
        }
    }
}
