//! Lesson 8: light that travels.
//!
//! - leg: a part of a path of light, from one surface to the next
//! - gathered light: of the photons nearest to a point
//! - area: of the disc that they lie on
//! - irradiance: power by area
//! - geometry term: how much of what leaves one surface arrives at another

use std::f64::consts::PI;

use glam::DVec3;

/// A random direction in which a diffuse surface sends light on, from two numbers u and v in [0, 1).
///
/// The pdf is cos θ/π, with θ the angle from the unit normal. `normal.any_orthonormal_pair()` gives two unit vectors
/// across it. Every function with this pdf is right.
pub fn diffuse_direction(normal: DVec3, u: f64, v: f64) -> DVec3 {
    // BEGIN SOLUTION
    let (across, along) = normal.any_orthonormal_pair();
    let (sine, cosine) = (2.0 * PI * v).sin_cos();
    u.sqrt() * (cosine * across + sine * along) + (1.0 - u).sqrt() * normal
    // END SOLUTION
}

/// The irradiance at a point, from the photons around it: E = Σ power of the k − 1 nearest / (π·r²), with r the distance of
/// the k-th.
///
/// A photon is (distance, power), and they are in no order. Of fewer than k photons all are taken; of none E is 0.
pub fn irradiance(photons: &[(f64, f64)], k: usize) -> f64 {
    // BEGIN SOLUTION
    // gathered light
    let mut nearest = photons.to_vec();
    nearest.sort_by(|one, other| one.0.total_cmp(&other.0));
    nearest.truncate(k);
    let Some((radius, _)) = nearest.pop() else {
        return 0.0;
    };
    let power: f64 = nearest.iter().map(|(_, power)| power).sum();
    // area
    let area = PI * radius * radius;
    power / area
    // END SOLUTION
}

/// G = cos θ · cos θ′ / d² between two small surfaces with unit normals; 0 if one of them faces away from the other.
pub fn geometry_term(from: DVec3, normal_from: DVec3, to: DVec3, normal_to: DVec3) -> f64 {
    // BEGIN SOLUTION
    let along = (to - from).normalize();
    let leaves = normal_from.dot(along).max(0.0);
    let arrives = (-normal_to.dot(along)).max(0.0);
    leaves * arrives / from.distance_squared(to)
    // END SOLUTION
}
