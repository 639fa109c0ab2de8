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
