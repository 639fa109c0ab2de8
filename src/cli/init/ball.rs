//! What the lesson is about.

/// The discriminant of a·t² + b·t + c = 0: below 0 the line of the ray misses the sphere.
pub fn discriminant(a: f64, b: f64, c: f64) -> f64 {
    b * b - 4.0 * a * c
}
