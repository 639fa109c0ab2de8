//! A disc in space: the eye's aperture, and what lies within a distance on a surface.

use std::f64::consts::TAU;

use glam::DVec3;

/// Points around it: close enough together for a circle on any sheet, and opposite ones in pairs.
const POINTS: u32 = 72;

/// The rim of a disc, by its centre, its unit normal and its radius.
pub(in crate::figure) fn rim(center: DVec3, normal: DVec3, radius: f64) -> Vec<DVec3> {
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    let at = |number: u32| {
        let (sin, cos) = libm::sincos(TAU * f64::from(number) / f64::from(POINTS));
        center + radius * (cos * across + sin * up)
    };
    (0..POINTS).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rim_lies_in_the_plane_at_the_radius() {
        let center = DVec3::new(1.0, 2.0, 3.0);
        let normal = DVec3::new(0.0, 0.6, 0.8);
        let points = rim(center, normal, 2.5);
        for point in &points {
            assert!((point.distance(center) - 2.5).abs() < 1e-12);
            assert!((point - center).dot(normal).abs() < 1e-12);
        }
        let opposite = points[0].midpoint(points[points.len() / 2]);
        assert!(opposite.distance(center) < 1e-12);
    }
}
