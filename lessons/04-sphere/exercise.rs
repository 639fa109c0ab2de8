//! Lesson 4: the sphere.
//!
//! A point o + t·Δ of the ray lies on the sphere if a·t² + b·t + c = 0 … (iii). In this order:
//!
//! - frame: o − centre, the ray as the sphere sees it
//! - a, b, c: the coefficients
//! - discriminant: b² − 4ac, whose sign says how many roots there are
//! - roots: the t at which the line hits the sphere
//! - root that counts: the smallest one in front of the origin, in the range

use raystep::geometry::{Ray, Sides, Sphere, TRange};

/// The coefficients a, b and c of the quadratic (iii).
///
/// `sphere.center` and `sphere.radius`, `ray.origin` and `ray.direction` are what you need. The direction may have any length.
/// `v.dot(w)` and `v.length_squared()` are the products of vectors.
pub fn coefficients(sphere: &Sphere, ray: &Ray) -> [f64; 3] {
    todo!()
}

/// The real roots of a·t² + b·t + c = 0, the smaller first: none, one or two. a is above 0.
///
/// The discriminants of the cases are exactly 0 or clearly not.
pub fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    todo!()
}

/// The smallest root t that counts: 0 < t and `range.min` ≤ t ≤ `range.max`. `None` if none does.
///
/// `_sides` says which sides of a surface can be seen; here both can.
pub fn root_that_counts(sphere: &Sphere, ray: &Ray, range: TRange, _sides: Sides) -> Option<f64> {
    todo!()
}
