//! What a ray has in common with all bounds of a structure: S and T of each direction, and the room for rounding.

use crate::geometry::{Ray, SlabRay};
use crate::structure::SlabSet;
use crate::structure::bounds::extent::ROUNDING;

/// S and T of a ray for each direction of a set: computed once for all bounds.
#[derive(Clone, Copy, Debug)]
pub struct RaySlabs<const N: usize> {
    pub(in crate::structure) lines: [SlabRay; N],
    pub(in crate::structure) room: f64,
}

impl<const N: usize> RaySlabs<N> {
    /// S and T of the ray for each direction, with this [`room`] for the slabs.
    pub fn new(ray: &Ray, set: &SlabSet<N>, room: f64) -> Self {
        Self {
            lines: set.padded().map(|normal| SlabRay::new(ray, normal)),
            room,
        }
    }

    /// S and T for each direction of the set that it was made for, and beyond those for directions of zero.
    pub fn lines(&self) -> &[SlabRay; N] {
        &self.lines
    }

    /// By how much either plane of a slab is moved outwards: a length.
    pub fn room(&self) -> f64 {
        self.room
    }
}

/// The room that a slab is given on either side for the rounding of a ray's own test, as a share of the coordinates of
/// its origin and of the objects: some millionfold of ε, for a sphere's root is good to 10⁻¹⁰ of itself, and where a ray
/// meets a surface flatly hits lie off the surface by a hundredfold of ε.
const ROOM: f64 = 2e-10;

/// The room for rounding that volumes are given around a ray: a length, 2·10⁻¹⁰ of the coordinates and another 10⁻¹⁰ of
/// the objects' for the rounding of their own.
///
/// `reach` is the largest coordinate of what the volumes are around.
#[inline]
pub fn room(ray: &Ray, reach: f64) -> f64 {
    ROOM * (ray.origin.abs().element_sum() + reach) + ROUNDING * reach
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn room_is_two_ten_billionths_of_all_coordinates_and_half_as_much_of_the_objects() {
        // 2·10⁻¹⁰·(1 + 2 + 3 + 4) + 10⁻¹⁰·4
        let ray = Ray::new(DVec3::new(1.0, -2.0, 3.0), DVec3::X);
        assert!((room(&ray, 4.0) - 24e-10).abs() <= 1e-23);
        assert_eq!(room(&Ray::new(DVec3::ZERO, DVec3::X), 0.0), 0.0);
        let slabs = RaySlabs::new(&ray, &SlabSet::AXES, 0.25);
        assert_eq!(slabs.room(), 0.25);
    }
}
