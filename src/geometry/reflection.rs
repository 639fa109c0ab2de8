//! Reflection at a surface: the mirror direction.

use glam::DVec3;

/// The direction in which a mirror sends a ray on.
///
/// R = Δ − 2(Δ·N)N
///
/// `direction` Δ runs towards the surface; `normal` N has unit length and may point to either side.
/// The length of Δ is kept.
///
/// ```
/// use glam::DVec3;
/// let down = DVec3::new(3.0, -4.0, 0.0);
/// assert_eq!(raystep::geometry::reflect(down, DVec3::Y), DVec3::new(3.0, 4.0, 0.0));
/// ```
#[doc(alias = "mirror direction")]
#[inline]
pub fn reflect(direction: DVec3, normal: DVec3) -> DVec3 {
    direction - 2.0 * direction.dot(normal) * normal
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_side_of_the_normal_makes_no_difference() {
        let direction = DVec3::new(0.6, -0.8, 0.0);
        assert_eq!(reflect(direction, DVec3::Y), reflect(direction, -DVec3::Y));
    }

    #[test]
    fn a_mirror_at_45_degrees_turns_x_into_y() {
        let normal = DVec3::new(-1.0, 1.0, 0.0) / 2f64.sqrt();
        assert!((reflect(DVec3::X, normal) - DVec3::Y).length() <= 1e-15);
    }
}
