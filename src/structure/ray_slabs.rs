//! What a ray has in common with all bounds of a structure: S and T of each direction, and the room for rounding.

use crate::geometry::{Ray, SlabRay};
use crate::structure::SlabSet;
use crate::structure::extent::ROUNDING;

/// S and T of a ray for each direction of a set: computed once for all bounds.
#[derive(Clone, Copy, Debug)]
pub struct RaySlabs<const N: usize> {
    pub(super) lines: [SlabRay; N],
    pub(super) room: f64,
}

impl<const N: usize> RaySlabs<N> {
    /// S and T of the ray for each direction, with this [`room`] for the slabs.
    pub fn new(ray: &Ray, set: &SlabSet<N>, room: f64) -> Self {
        Self {
            lines: set.padded().map(|normal| SlabRay::new(ray, normal)),
            room,
        }
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
