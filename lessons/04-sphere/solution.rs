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
    // BEGIN SOLUTION
    // frame
    let from_center = ray.origin - sphere.center;
    // a, b, c
    let a = ray.direction.length_squared();
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.length_squared() - sphere.radius * sphere.radius;
    [a, b, c]
    // END SOLUTION
}

/// The real roots of a·t² + b·t + c = 0, the smaller first: none, one or two. a is above 0.
///
/// The discriminants of the cases are exactly 0 or clearly not.
pub fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    // BEGIN SOLUTION
    // discriminant
    let discriminant = b * b - 4.0 * a * c;
    // roots
    if discriminant < 0.0 {
        return vec![];
    }
    if discriminant == 0.0 {
        return vec![-b / (2.0 * a)];
    }
    let root = discriminant.sqrt();
    vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
    // END SOLUTION
}

/// The smallest root t that counts: 0 < t and `range.min` ≤ t ≤ `range.max`. `None` if none does.
///
/// `_sides` says which sides of a surface can be seen; here both can.
pub fn root_that_counts(sphere: &Sphere, ray: &Ray, range: TRange, _sides: Sides) -> Option<f64> {
    // BEGIN SOLUTION
    let [a, b, c] = coefficients(sphere, ray);
    // root that counts
    let counts = |t: &f64| 0.0 < *t && range.min <= *t && *t <= range.max;
    roots(a, b, c).into_iter().find(counts)
    // END SOLUTION
}
