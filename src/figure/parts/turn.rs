//! Directions by their angle, with the same digits on every system.

use glam::DVec2;

/// The unit vector at an angle from x towards y, in radians.
pub(in crate::figure) fn at_angle(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}

/// The angle from one direction to another, in radians, between −π and π: positive from x towards y.
pub(in crate::figure) fn angle_between(from: DVec2, to: DVec2) -> f64 {
    libm::atan2(from.perp_dot(to), from.dot(to))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn a_right_angle_leads_from_x_to_y_and_back() {
        assert!(at_angle(FRAC_PI_2).abs_diff_eq(DVec2::Y, 1e-15));
        assert_eq!(angle_between(DVec2::X, DVec2::Y), FRAC_PI_2);
        assert_eq!(angle_between(DVec2::Y, DVec2::X), -FRAC_PI_2);
    }
}
