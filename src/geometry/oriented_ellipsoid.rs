//! The ellipsoid turned in any way: what is put around an object that lies askew.
//!
//! A scene's own ellipsoids stand along x, y and z ([`Ellipsoid`](crate::geometry::Ellipsoid)); this one is
//! a bounding volume. Its test is the same, after a rotation.

use std::f64::consts::PI;

use glam::DVec3;

use crate::geometry::{QuadraticTest, Ray, Sides, Sphere, TRange};

/// Σ (wᵢ·(p − center)/rᵢ)² = 1, with three unit vectors wᵢ at right angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientedEllipsoid {
    /// The center in world coordinates.
    pub center: DVec3,
    /// w₁, w₂ and w₃: the directions of the half axes, of unit length, at right angles to each other.
    pub axes: [DVec3; 3],
    /// (r₁, r₂, r₃): the lengths of the half axes, each > 0.
    pub radii: DVec3,
}

impl OrientedEllipsoid {
    /// Where does the ray hit the ellipsoid?
    ///
    /// The slides' (iii) in the space of the half axes, each coordinate divided by rᵢ/r and r the smallest
    /// of the three: there the ellipsoid is the sphere of radius r around 0,
    /// o′ᵢ = wᵢ·(o − center)·r/rᵢ and Δ′ᵢ = (wᵢ·Δ)·r/rᵢ. The transformation is linear, so t stays what it
    /// was; but Δ′ has no unit length and a ≠ 1 (erratum 11).
    ///
    /// The slides' unit sphere is the same divided by r. This way every length shrinks on its way there, and
    /// no square of an allowed coordinate leaves f64, however flat the ellipsoid.
    ///
    /// Degenerate cases are those of [`Sphere::test`].
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{OrientedEllipsoid, Ray, Sides, TRange};
    ///
    /// let slanted = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
    /// let egg = OrientedEllipsoid {
    ///     center: DVec3::ZERO,
    ///     axes: slanted.map(DVec3::from_array),
    ///     radii: DVec3::new(2.0, 1.0, 1.0),
    /// };
    /// // towards the long half axis, which ends in (1.2, 1.6, 0), from 6 away
    /// let ray = Ray::new(DVec3::new(3.6, 4.8, 0.0), DVec3::new(-0.6, -0.8, 0.0));
    /// let test = egg.test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!(test.roots.chosen(), Some(4.0)); // 6 − 2
    /// ```
    #[inline]
    pub fn test(&self, ray: &Ray, range: TRange, sides: Sides) -> QuadraticTest {
        let radius = self.radii.min_element();
        let among_spheres = Ray::new(
            self.along_axes(ray.origin - self.center) * (radius / self.radii),
            self.along_axes(ray.direction) * (radius / self.radii),
        );
        let center = DVec3::ZERO;
        Sphere { center, radius }.test(&among_spheres, range, sides)
    }

    /// How far out does a point lie? 0 in the center, 1 on the surface.
    ///
    /// √(Σ (wᵢ·(p − center)/rᵢ)²)
    pub fn level(&self, point: DVec3) -> f64 {
        (self.along_axes(point - self.center) / self.radii).length()
    }

    /// A larger ellipsoid that holds every point within `room` of this one.
    ///
    /// Every half axis grows by the same factor, the smallest by `room`. Half axes below 16 times the room are first
    /// brought to that, so that the factor is 17/16 at most.
    #[must_use]
    #[inline]
    pub fn with_room(&self, room: f64) -> Self {
        /// A needle would else grow along its length by as much as across.
        const LEAST: f64 = 16.0;
        let radii = self.radii.max(DVec3::splat(LEAST * room));
        Self {
            radii: radii * (1.0 + room / radii.min_element()),
            ..*self
        }
    }

    /// How much space is in it? (4/3)π·r₁·r₂·r₃
    pub fn volume(&self) -> f64 {
        4.0 / 3.0 * PI * self.radii.element_product()
    }

    /// (w₁·v, w₂·v, w₃·v)
    #[inline]
    fn along_axes(&self, v: DVec3) -> DVec3 {
        DVec3::from(self.axes.map(|axis| axis.dot(v)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Ellipsoid, Roots};

    /// The half axes lie along y, z and x.
    const TURNED: OrientedEllipsoid = OrientedEllipsoid {
        center: DVec3::new(1.0, 0.0, 0.0),
        axes: [DVec3::Y, DVec3::Z, DVec3::X],
        radii: DVec3::new(2.0, 1.0, 4.0),
    };

    #[test]
    fn turned_by_right_angles_it_is_the_ellipsoid_along_the_axes() {
        let straight = Ellipsoid {
            center: DVec3::new(1.0, 0.0, 0.0),
            radii: DVec3::new(4.0, 2.0, 1.0),
        };
        for (origin, direction) in [
            ([-9.0, 0.5, 0.25], [1.0, 0.0, 0.0]),
            ([3.0, 5.0, -2.0], [-0.25, -1.0, 0.5]),
            ([1.0, 0.0, 0.0], [0.0, 0.6, -0.8]),
        ] {
            let ray = Ray::new(origin.into(), direction.into());
            let hit = |test: QuadraticTest| test.roots.chosen().unwrap();
            let turned = hit(TURNED.test(&ray, TRange::FORWARD, Sides::Both));
            let expected = hit(straight.test(&ray, TRange::FORWARD, Sides::Both));
            assert!((turned - expected).abs() <= 1e-14 * expected, "{turned}");
        }
    }

    #[test]
    fn a_ray_that_passes_the_short_half_axis_misses() {
        let ray = Ray::new(DVec3::new(-9.0, 0.0, 1.01), DVec3::X);
        let test = TURNED.test(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!(test.roots, Roots::None);
        // with a room of 0.02 the short half axis is 1.02
        let wider = TURNED.with_room(0.02);
        assert_eq!(wider.radii, DVec3::new(2.04, 1.02, 4.08));
        let test = wider.test(&ray, TRange::FORWARD, Sides::Both);
        assert!(matches!(test.roots, Roots::Two { .. }), "{test:?}");
    }

    #[test]
    fn a_sheet_far_off_keeps_every_number_finite() {
        let sheet = OrientedEllipsoid {
            center: DVec3::splat(1e50),
            axes: DVec3::AXES,
            radii: DVec3::new(1e50, 1e50, 1e-50),
        };
        let ray = Ray::new(DVec3::splat(-1e50), DVec3::ONE);
        let test = sheet.test(&ray, TRange::FORWARD, Sides::Both);
        assert!((test.roots.chosen().unwrap() - 2e50).abs() <= 1e40);
    }

    #[test]
    fn the_level_is_one_on_the_surface_and_the_volume_that_of_the_half_axes() {
        assert_eq!(TURNED.level(TURNED.center), 0.0);
        assert_eq!(TURNED.level(DVec3::new(1.0, 2.0, 0.0)), 1.0);
        assert_eq!(TURNED.level(DVec3::new(-7.0, 0.0, 0.0)), 2.0);
        // (4/3)π·8
        assert!((TURNED.volume() - 33.510_321_638_291_124).abs() <= 1e-13);
    }

    #[test]
    fn room_widens_the_smallest_half_axis_by_itself_and_the_others_by_their_share() {
        // ⅛ on 2 is a sixteenth: 4·17/16, 2·17/16, 8·17/16
        let larger = OrientedEllipsoid {
            radii: 2.0 * TURNED.radii,
            ..TURNED
        };
        assert_eq!(larger.with_room(0.125).radii, DVec3::new(4.25, 2.125, 8.5));
    }

    #[test]
    fn the_coefficients_are_those_among_spheres_of_the_smallest_half_axis() {
        // half axis 4 along x, r = 1: o′ = −10/4, Δ′ = ¼; a = 1/16, b = 2·(−2.5)/4, c = 6.25 − 1
        let ray = Ray::new(DVec3::new(-9.0, 0.0, 0.0), DVec3::X);
        let test = TURNED.test(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!((test.a, test.b, test.c), (0.0625, -1.25, 5.25));
    }
}
