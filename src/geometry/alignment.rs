//! A frame in which a ray lies along the z axis.
//!
//! Slides, "Optimizing Intersection Calculations": "if rays are transformed to lie along the z axis, the
//! same transformation can be applied to each candidate object so that any intersection occurs at x = y = 0.
//! […] The intersection point can then be transformed back". A translation and a rotation keep all lengths
//! and angles, so shapes stay what they are and t stays what it was.

use glam::DVec3;

use crate::geometry::{Axis, Ray};

/// The transformation that puts a ray's origin to (0, 0, 0) and its direction along z:
/// p′ = (x·(p − o), y·(p − o), z·(p − o)).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alignment {
    /// o: the ray's origin.
    pub origin: DVec3,
    /// The first row of the rotation, of unit length.
    pub x: DVec3,
    /// The second row of the rotation: the unit vector z × x.
    pub y: DVec3,
    /// The third row: the ray's direction.
    pub z: DVec3,
}

/// A ray, and the frame in which it is (0, 0, 0) + t·(0, 0, |Δ|).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlignedRay {
    /// The ray in world coordinates.
    pub world: Ray,
    /// The frame in which the ray starts at the origin and runs along z.
    pub frame: Alignment,
    /// |Δ|: z = t·|Δ|. Exactly 1 for a unit ray: then z is t.
    pub length: f64,
}

/// A direction is of unit length if the square of its length is 1 within this: a normalised one is off by
/// some four roundings.
const UNIT: f64 = 8.0 * f64::EPSILON;

impl Alignment {
    /// Which rotation turns the ray's direction to z?
    ///
    /// z = Δ/|Δ|,  x = (e − (e·z)z)/s,  y = (z × e)/s = z × x,  s = |z × e| = |e − (e·z)z|
    ///
    /// e is the axis along which Δ is shortest, the first of equals. The rows are of unit length, at right
    /// angles and right-handed, within rounding; for a ray along an axis they are axes themselves, exactly. A
    /// unit direction is the row z as it is, bit for bit; one of any other length is normalised, and then
    /// t = z/|Δ|. A direction of length 0 is taken for (0, 0, 1).
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Alignment, Ray};
    ///
    /// let frame = Alignment::of(&Ray::new(DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.6, 0.0, 0.8)));
    /// assert_eq!((frame.x, frame.y), (DVec3::Y, DVec3::new(-0.8, 0.0, 0.6)));
    /// // p − o = (3, 7, 4): 7 along x, −2.4 + 2.4 along y, 1.8 + 3.2 along z
    /// assert_eq!(frame.point(DVec3::new(4.0, 7.0, 4.0)).z, 5.0);
    /// ```
    #[inline]
    pub fn of(ray: &Ray) -> Self {
        let z = if is_unit(ray.direction) {
            ray.direction
        } else {
            ray.normalised()
                .map_or(DVec3::Z, |(unit, _)| unit.direction)
        };
        let e = shortest(z);
        // |e·z| ≤ 1/√3: never short
        let across = z.cross(e);
        let sine = across.length();
        let x = (e - e.dot(z) * z) / sine;
        let y = across / sine;
        // −0 + 0 = 0: a 0 carries no sign
        Self {
            origin: ray.origin,
            x: x + DVec3::ZERO,
            y: y + DVec3::ZERO,
            z: z + DVec3::ZERO,
        }
    }

    /// e: the axis along which the ray's direction is shortest, the first of equals.
    pub fn shortest(&self) -> DVec3 {
        shortest(self.z)
    }

    /// Where a point lies in the frame: it is moved and turned.
    #[inline]
    pub fn point(&self, p: DVec3) -> DVec3 {
        self.vector(p - self.origin)
    }

    /// What a vector is in the frame: it is turned alone.
    #[inline]
    pub fn vector(&self, v: DVec3) -> DVec3 {
        DVec3::new(self.x.dot(v), self.y.dot(v), self.z.dot(v))
    }

    /// Where a point of the frame lies in the world: p = o + p′ₓ·x + p′_y·y + p′_z·z, since the inverse of a
    /// rotation is its transpose.
    #[inline]
    pub fn back(&self, p: DVec3) -> DVec3 {
        self.origin + p.x * self.x + p.y * self.y + p.z * self.z
    }
}

impl AlignedRay {
    /// The ray in a frame of its own.
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let length = if is_unit(ray.direction) {
            1.0
        } else {
            ray.direction.length()
        };
        Self {
            world: *ray,
            frame: Alignment::of(ray),
            length,
        }
    }

    /// (0, 0, 0) + t·(0, 0, |Δ|).
    #[inline]
    pub fn in_frame(&self) -> Ray {
        Ray::new(DVec3::ZERO, DVec3::new(0.0, 0.0, self.length))
    }
}

#[inline]
fn is_unit(direction: DVec3) -> bool {
    (direction.length_squared() - 1.0).abs() <= UNIT
}

#[inline]
fn shortest(direction: DVec3) -> DVec3 {
    match Axis::of_smallest(direction) {
        Axis::X => DVec3::X,
        Axis::Y => DVec3::Y,
        Axis::Z => DVec3::Z,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_along_an_axis_has_axes_for_rows_and_no_signed_zeros() {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for direction in [axis, -axis] {
                let frame = Alignment::of(&Ray::new(DVec3::ONE, direction));
                assert_eq!(frame.z, direction);
                for row in [frame.x, frame.y, frame.z] {
                    let sizes = row.abs().to_array();
                    assert_eq!(sizes.iter().filter(|&&s| s == 1.0).count(), 1, "{frame:?}");
                    assert_eq!(sizes.iter().filter(|&&s| s == 0.0).count(), 2, "{frame:?}");
                    let signed = row.to_array().iter().any(|v| v.to_bits() == 1 << 63);
                    assert!(!signed, "{frame:?}");
                }
                assert_eq!(frame.x.cross(frame.y), frame.z, "right-handed");
            }
        }
    }

    #[test]
    fn a_ray_along_z_stays_as_it_is() {
        let frame = Alignment::of(&Ray::new(DVec3::ZERO, DVec3::Z));
        assert_eq!([frame.x, frame.y, frame.z], DVec3::AXES);
    }

    #[test]
    fn a_longer_direction_is_normalised_and_its_length_kept() {
        let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, DVec3::new(0.0, 3.0, 4.0)));
        assert_eq!(ray.length, 5.0);
        assert_eq!(ray.frame.z, DVec3::new(0.0, 0.6, 0.8));
        assert_eq!(ray.in_frame().at(2.0), DVec3::new(0.0, 0.0, 10.0));
    }

    #[test]
    fn a_direction_of_zero_gives_the_world_turned_by_nothing() {
        let ray = AlignedRay::new(&Ray::new(DVec3::ONE, DVec3::ZERO));
        assert_eq!([ray.frame.x, ray.frame.y, ray.frame.z], DVec3::AXES);
        assert_eq!(ray.in_frame().direction, DVec3::ZERO);
    }

    /// From (1, 0, 0) along (0.6, 0, 0.8): x′ = y, y′ = −0.8(x − 1) + 0.6z, z′ = 0.6(x − 1) + 0.8z.
    fn slanted() -> Alignment {
        Alignment::of(&Ray::new(DVec3::X, DVec3::new(0.6, 0.0, 0.8)))
    }

    #[test]
    fn a_point_is_moved_and_turned_and_brought_back() {
        let inside = slanted().point(DVec3::new(4.0, 7.0, 4.0));
        assert!((inside - DVec3::new(7.0, 0.0, 5.0)).length() <= 1e-14);
        // (1, 0, 0) + 7·(0, 1, 0) + 10·(−0.8, 0, 0.6) + 5·(0.6, 0, 0.8)
        let back = slanted().back(DVec3::new(7.0, 10.0, 5.0));
        assert!((back - DVec3::new(-4.0, 7.0, 10.0)).length() <= 1e-14);
    }

    #[test]
    fn the_rows_of_an_oblique_frame_are_of_unit_length_at_right_angles_and_right_handed() {
        // 0.48² + 0.6² + 0.64² = 1
        for direction in [[0.48, 0.6, 0.64], [-0.64, 0.48, -0.6], [0.6, -0.64, 0.48]] {
            let frame = Alignment::of(&Ray::new(DVec3::ZERO, direction.into()));
            for row in [frame.x, frame.y, frame.z] {
                assert!((row.length() - 1.0).abs() <= 1e-15, "{frame:?}");
            }
            assert!((frame.x.cross(frame.y) - frame.z).length() <= 1e-15);
            assert!((frame.y.cross(frame.z) - frame.x).length() <= 1e-15);
        }
    }

    #[test]
    fn a_direction_within_the_rounding_of_unit_length_is_taken_as_it_is() {
        // (1 + 4ε)² is 1 + 8ε, just within 8ε; (1 + 5ε)² is 1 + 10ε
        for (off, length, row) in [
            (4.0, 1.0, 1.0 + 4.0 * f64::EPSILON),
            (5.0, 1.0 + 5.0 * f64::EPSILON, 1.0),
        ] {
            let direction = (1.0 + off * f64::EPSILON) * DVec3::X;
            let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, direction));
            assert_eq!((ray.length, ray.frame.z.x), (length, row));
        }
    }

    #[test]
    fn a_zero_of_the_direction_gives_no_row_its_sign() {
        let frame = Alignment::of(&Ray::new(DVec3::ZERO, DVec3::new(-0.0, 0.0, 1.0)));
        for row in [frame.x, frame.y, frame.z] {
            let signed = row.to_array().iter().any(|v| v.to_bits() == 1 << 63);
            assert!(!signed, "{frame:?}");
        }
    }
}
