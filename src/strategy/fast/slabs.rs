//! Bounds of slabs against a ray, with the two planes of a slab side by side.
//!
//! Near and far are the smaller and the larger of both t, and so the test has neither a branch nor an index that
//! depends on the ray's direction. [`SlabBound::steps`] and [`Inside::and`] say the same slab by slab; this one stands apart
//! for speed.

use crate::geometry::{Inside, PARALLEL, Ray, larger, smaller};
use crate::structure::{SlabBound, SlabSet};

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

/// The number of slabs that make a box.
const BOX: usize = 3;

impl<const N: usize> BothPlanes<N> {
    /// S and T of the ray for each direction.
    #[inline]
    pub(super) fn new(ray: &Ray, set: &SlabSet<N>, room: f64) -> Self {
        let s = set.products(ray.origin);
        let products = set.products(ray.direction);
        let mut planes = Self {
            s_min: [0.0; N],
            s_max: [0.0; N],
            t_scale: [0.0; N],
        };
        for slab in 0..N {
            planes.s_min[slab] = s[slab] - room;
            planes.s_max[slab] = s[slab] + room;
            // a parallel ray is far beyond every other slab, or before it
            let t_scale = -1.0 / products[slab];
            planes.t_scale[slab] = smaller(larger(t_scale, -PARALLEL), PARALLEL);
        }
        planes
    }

    /// t of the planes of a slab, the nearer one first.
    #[inline]
    fn between(&self, bound: &SlabBound<N>, slab: usize) -> Inside {
        let at_min = (self.s_min[slab] + bound.d_min[slab]) * self.t_scale[slab];
        let at_max = (self.s_max[slab] + bound.d_max[slab]) * self.t_scale[slab];
        Inside {
            near: smaller(at_min, at_max),
            far: larger(at_min, at_max),
        }
    }

    /// Where is the ray inside the bound? Nowhere if near and far have crossed.
    ///
    /// A parallel ray is inside its slab from some −10²⁰⁰ to 10²⁰⁰, or only beyond that. The first three slabs are
    /// computed before any of them is joined to another, and those behind them in two rows: so the processor does two at
    /// once. Whether near and far have crossed is asked once, behind the third slab: a jump costs more than a slab.
    #[inline]
    pub(super) fn inside(&self, bound: &SlabBound<N>) -> Inside {
        let (x, y, z) = (
            self.between(bound, 0),
            self.between(bound, 1),
            self.between(bound, 2),
        );
        let inside = join(join(x, y), z);
        if N == BOX || inside.is_empty() {
            return inside;
        }
        // an odd one at the end is joined twice, which changes nothing
        let mut both = [inside; 2];
        for slab in (BOX..N).step_by(2) {
            let next = (slab + 1).min(N - 1);
            both[0] = join(both[0], self.between(bound, slab));
            both[1] = join(both[1], self.between(bound, next));
        }
        join(both[0], both[1])
    }
}

/// What two slabs have in common.
#[inline]
fn join(a: Inside, b: Inside) -> Inside {
    Inside {
        near: larger(a.near, b.near),
        far: smaller(a.far, b.far),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    /// The box from (1, 2, 3) to (5, 4, 9): D = −p.
    const BOX_OFF_THE_ORIGIN: SlabBound<3> = SlabBound {
        d_min: [-5.0, -4.0, -9.0],
        d_max: [-1.0, -2.0, -3.0],
    };

    fn inside(origin: [f64; 3], direction: [f64; 3], room: f64) -> [f64; 2] {
        let ray = Ray::new(origin.into(), direction.into());
        let Inside { near, far } =
            BothPlanes::new(&ray, &SlabSet::AXES, room).inside(&BOX_OFF_THE_ORIGIN);
        [near, far]
    }

    #[test]
    fn a_ray_is_inside_from_the_largest_near_to_the_smallest_far() {
        // x = 1 … 5 at t = 1 … 5, y = 2 … 4 at 2 … 4, z = 3 … 9 at ¼ … 3¼
        assert_eq!(inside([0.0, 0.0, 2.5], [1.0, 1.0, 2.0], 0.0), [2.0, 3.25]);
        // the same backwards, and with the numbers turned round
        assert_eq!(
            inside([0.0, 0.0, 2.5], [-1.0, -1.0, -2.0], 0.0),
            [-3.25, -2.0]
        );
        assert_eq!(
            inside([6.0, 6.0, 9.5], [-1.0, -1.0, -2.0], 0.0),
            [2.0, 3.25]
        );
    }

    #[test]
    fn room_moves_both_planes_of_a_slab_outwards() {
        // y = 1½ … 4½ at 1½ … 4½, z = 2½ … 9½ at 0 … 3½
        assert_eq!(inside([0.0, 0.0, 2.5], [1.0, 1.0, 2.0], 0.5), [1.5, 3.5]);
        assert_eq!(inside([6.0, 6.0, 9.5], [-1.0, -1.0, -2.0], 0.5), [1.5, 3.5]);
    }

    #[test]
    fn near_and_far_of_a_missed_box_have_crossed() {
        // y = 4 at t = ½, before x = 1 at t = 1
        let [near, far] = inside([0.0, 3.5, 2.5], [1.0, 1.0, 2.0], 0.0);
        assert_eq!([near, far], [1.0, 0.5]);
    }

    #[test]
    fn a_parallel_ray_is_inside_between_the_planes_alone() {
        for zero in [0.0, -0.0] {
            assert_eq!(inside([0.0, 3.0, 6.0], [1.0, zero, 0.0], 0.0), [1.0, 5.0]);
            for y in [1.9, 4.1] {
                let [near, far] = inside([0.0, y, 6.0], [1.0, zero, 0.0], 0.0);
                assert!(far < near, "{y}: {near} {far}");
            }
        }
    }

    #[test]
    fn a_slab_behind_the_first_three_cuts_off_a_corner() {
        // of the cube from −1 to 1 what lies within ½ of the plane x + y + z = 0
        let half = 0.5;
        let mut bound = SlabBound {
            d_min: [-1.0; 7],
            d_max: [1.0; 7],
        };
        (bound.d_min[3], bound.d_max[3]) = (-half, half);
        let ray = Ray::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X);
        let found = BothPlanes::new(&ray, &SlabSet::SEVEN, 0.0).inside(&bound);
        // x/√3 from −½ to ½: t = 3 ∓ √3/2
        let half = 0.75_f64.sqrt();
        assert!((found.near - (3.0 - half)).abs() <= 1e-15, "{found:?}");
        assert!((found.far - (3.0 + half)).abs() <= 1e-15, "{found:?}");
    }
}
