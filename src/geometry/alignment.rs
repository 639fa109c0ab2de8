//! A frame in which a ray lies along the z axis.

use glam::DVec3;

/// The transformation that puts a ray's origin to (0, 0, 0) and its direction along z:
/// p′ = (x·(p − o), y·(p − o), z·(p − o)).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alignment {
    /// o: the ray's origin.
    pub origin: DVec3,
    /// The first row of the rotation, of unit length.
    pub x: DVec3,
    /// The second row.
    pub y: DVec3,
    /// The third row: the ray's direction.
    pub z: DVec3,
}
