//! Refraction at a surface: Snell's law, and total internal reflection beyond the critical angle.

use glam::DVec3;

/// What Snell's law gave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Refraction {
    /// n₁: the index on the side that the ray comes from.
    pub index_from: f64,
    /// n₂: the index on the side that it goes to.
    pub index_to: f64,
    /// cos θ₁ = −Δ·N, between the ray and the normal.
    pub cos_incident: f64,
    /// 1 − (n₁/n₂)²(1 − cos²θ₁): cos²θ₂, or negative if no ray can pass.
    pub cos_refracted_squared: f64,
    /// The unit direction behind the surface; `None`: total internal reflection.
    pub direction: Option<DVec3>,
}

impl Refraction {
    /// (n₁/n₂)²: what becomes of radiance, power by area and solid angle, for a ray from the eye. Behind the
    /// surface the same light fills another solid angle: n²·cos θ·dω is the same on both sides.
    #[inline]
    pub fn radiance_factor(&self) -> f64 {
        let eta = self.index_from / self.index_to;
        eta * eta
    }
}

/// Which way does a ray go on behind a surface?
///
/// n₁ sin θ₁ = n₂ sin θ₂ (Snell), as vectors with η = n₁/n₂:
/// T = η·Δ + (η cos θ₁ − cos θ₂)·N,  cos²θ₂ = 1 − η²(1 − cos²θ₁)
///
/// `direction` Δ and `normal` N have unit length and N points to the side that Δ comes from
/// (Δ·N ≤ 0). The indices are positive. If cos²θ₂ < 0 the sine of θ₂ would be above 1: all light is
/// reflected. cos²θ₂ = 0, the critical angle itself, still passes, along the surface.
///
/// ```
/// use glam::DVec3;
/// // sin θ₁ = 0.6 into an index of 1.2: sin θ₂ = 0.5, cos θ₂ = √0.75
/// let passed = raystep::geometry::refract(DVec3::new(0.6, -0.8, 0.0), DVec3::Y, 1.0, 1.2);
/// let direction = passed.direction.unwrap();
/// assert!((direction - DVec3::new(0.5, -0.75f64.sqrt(), 0.0)).length() < 1e-15);
/// ```
#[doc(alias = "Snell law")]
#[inline]
pub fn refract(direction: DVec3, normal: DVec3, index_from: f64, index_to: f64) -> Refraction {
    let eta = index_from / index_to;
    let cos_incident = -direction.dot(normal);
    let cos_refracted_squared = 1.0 - eta * eta * (1.0 - cos_incident * cos_incident);
    let passes = 0.0 <= cos_refracted_squared;
    Refraction {
        index_from,
        index_to,
        cos_incident,
        cos_refracted_squared,
        direction: passes.then(|| {
            let cos_refracted = cos_refracted_squared.sqrt();
            let bent = eta * direction + (eta * cos_incident - cos_refracted) * normal;
            bent.normalize_or(direction)
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six decimals, as the table below was worked out.
    const TABLE: f64 = 5e-7;

    /// (θ₁ in degrees, n₁, n₂, θ₂ in degrees), by hand from sin θ₂ = n₁ sin θ₁ / n₂.
    const SNELL: [(f64, f64, f64, f64); 6] = [
        (0.0, 1.0, 1.5, 0.0),
        (30.0, 1.0, 1.5, 19.471_221),
        (60.0, 1.0, 1.5, 35.264_390),
        (45.0, 1.0, 1.333, 32.036_723),
        (30.0, 1.5, 1.0, 48.590_378),
        (41.0, 1.5, 1.0, 79.765_417),
    ];

    #[test]
    fn angles_follow_snells_table() {
        for (theta1, n1, n2, theta2) in SNELL {
            let angle = f64::to_radians(theta1);
            let direction = DVec3::new(angle.sin(), -angle.cos(), 0.0);
            let bent = refract(direction, DVec3::Y, n1, n2).direction.unwrap();
            let found = bent.x.atan2(-bent.y).to_degrees();
            assert!(
                (found - theta2).abs() <= TABLE,
                "{theta1}°: {found}° {theta2}°"
            );
            assert!((bent.length() - 1.0).abs() <= 1e-15);
        }
    }

    #[test]
    fn beyond_the_critical_angle_nothing_passes() {
        // arcsin(1/1.5) = 41.810315°
        let at = |degrees: f64| {
            let angle = degrees.to_radians();
            let direction = DVec3::new(angle.sin(), -angle.cos(), 0.0);
            refract(direction, DVec3::Y, 1.5, 1.0).direction
        };
        assert!(at(41.810_31).is_some());
        assert_eq!(at(41.810_32), None);
        assert_eq!(at(90.0), None);
    }

    #[test]
    fn equal_indices_do_not_bend() {
        let direction = DVec3::new(0.6, -0.8, 0.0);
        let bent = refract(direction, DVec3::Y, 1.5, 1.5).direction.unwrap();
        assert!((bent - direction).length() <= 1e-15);
    }

    #[test]
    fn radiance_is_n_squared_times_as_much_in_a_medium() {
        // a ray from the eye that leaves glass of 1.5 for air brings 2.25 times what is seen there; one that goes in
        // brings 4/9, and one that goes in and out again brings it all
        let factor = |from, to| refract(DVec3::NEG_Y, DVec3::Y, from, to).radiance_factor();
        assert_eq!(factor(1.5, 1.0), 2.25);
        assert!((factor(1.0, 1.5) - 4.0 / 9.0).abs() <= 1e-15);
        assert_eq!(factor(1.5, 1.5), 1.0);
    }

    #[test]
    fn at_the_critical_angle_itself_the_ray_passes_along_the_surface() {
        // cos²θ₂ = 1 − 1·(1 − 0) = 0
        let along = refract(DVec3::X, DVec3::Y, 1.5, 1.5);
        assert_eq!(along.cos_refracted_squared, 0.0);
        assert_eq!(along.direction, Some(DVec3::X));
    }
}
