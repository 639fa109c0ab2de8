//! Lesson 3: the ray.
//!
//! - direction: Δ, of any length or of unit length
//! - ray: (x, y, z) = o + t·Δ … (i)

use glam::DVec3;
use raystep::geometry::Ray;

/// The point at t. `ray.origin` is o, `ray.direction` is Δ; a vector times a number is `t * v`.
pub fn point_at_t(ray: &Ray, t: f64) -> DVec3 {
    // BEGIN SOLUTION
    ray.origin + t * ray.direction
    // END SOLUTION
}

/// The same ray with |Δ| = 1, and the t at which the point of the former t = 1 now lies.
///
/// None if Δ has length 0.
pub fn normalised(ray: &Ray) -> Option<(Ray, f64)> {
    // BEGIN SOLUTION
    let length = ray.direction.length();
    if length == 0.0 {
        return None;
    }
    Some((Ray::new(ray.origin, ray.direction / length), length))
    // END SOLUTION
}
