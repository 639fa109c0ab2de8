//! Bounds of slabs against a ray, with the two planes of a slab side by side.
//!
//! Near and far are the smaller and the larger of both t, and so the test has neither a branch nor an index that
//! depends on the ray's direction. [`SlabBound::steps`] says the same slab by slab.

use crate::geometry::{PARALLEL, Ray};
use crate::structure::extremes::{larger, smaller};
use crate::structure::{Inside, SlabBound, SlabSet};

/// S and T of a ray for each direction of a set, S with its room for either plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct BothPlanes<const N: usize> {
    /// S, less the room: for the plane of D_min.
    s_min: [f64; N],
    /// S and the room: for the plane of D_max.
    s_max: [f64; N],
    /// T.
    t_scale: [f64; N],
}

/// So many slabs make a box.
const BOX: usize = 3;

impl<const N: usize> BothPlanes<N> {
    /// S and T of the ray for each direction.
    #[inline]
    pub(super) fn new(ray: &Ray, set: &SlabSet<N>, room: f64) -> Self {
        let s = set.products(ray.origin);
        let t_scale = set.products(ray.direction).map(|product| -1.0 / product);
        Self {
            s_min: s.map(|s| s - room),
            s_max: s.map(|s| s + room),
            // a parallel ray is far beyond every other slab, or before it
            t_scale: t_scale.map(|t| smaller(larger(t, -PARALLEL), PARALLEL)),
        }
    }

    /// Where is the ray inside the bound? Nowhere if near and far have crossed.
    ///
    /// A parallel ray is inside its slab from some −10²⁰⁰ to 10²⁰⁰, or only beyond that. Whether near and far have
    /// crossed is asked once, behind the third slab: a jump costs more than a slab.
    #[inline]
    pub(super) fn inside(&self, bound: &SlabBound<N>) -> Inside {
        let Inside { mut near, mut far } = Inside::EVERYWHERE;
        for slab in 0..N {
            let at_min = (self.s_min[slab] + bound.d_min[slab]) * self.t_scale[slab];
            let at_max = (self.s_max[slab] + bound.d_max[slab]) * self.t_scale[slab];
            near = larger(near, smaller(at_min, at_max));
            far = smaller(far, larger(at_min, at_max));
            if slab + 1 == BOX && far < near {
                break;
            }
        }
        Inside { near, far }
    }
}
