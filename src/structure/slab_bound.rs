//! A bound after Kay and Kajiya: the intersection of slabs, kept as the D_min and D_max of each.
//!
//! Slides, "Optimizing Intersection Calculations" (Fig. 15.58): each bound is described "compactly by the
//! D_min and D_max of each of its slabs"; S and T are "calculated once for a given ray and parameterized
//! slab"; the ray is inside the bound from the maximum of the near values of t to the minimum of the far
//! ones, both "updated as each of its slabs is processed, and the processing of the bound terminated if the
//! former ever exceeds the latter".

use crate::geometry::{PARALLEL, Ray, SlabInterval, SlabRay, TRange};
use crate::scene::Shape;
use crate::structure::extent::box_around;
use crate::structure::extremes::{larger, smaller};
use crate::structure::{SlabSet, extent};

/// D_min and D_max of each slab. A, B and C are those of the structure's [`SlabSet`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabBound<const N: usize> {
    /// D_min for each direction of the set: minus the furthest place along the normal.
    pub d_min: [f64; N],
    /// D_max for each direction.
    pub d_max: [f64; N],
}

/// What became of a bound at one of its slabs?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SlabOutcome {
    /// Near and far have not crossed: the next slab is looked at.
    #[default]
    GoesOn,
    /// The largest near is above the smallest far: the ray misses the bound.
    Null,
    /// The ray is parallel to the slab and inside it.
    ParallelInside,
    /// The ray is parallel to the slab and outside of it: it misses the bound.
    ParallelOutside,
}

/// One slab of a bound against a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlabStep {
    /// Which direction of the set, from 0.
    pub slab: u32,
    /// D of the plane that is furthest along the normal.
    pub d_min: f64,
    /// D of the plane that is furthest back.
    pub d_max: f64,
    /// The near and the far t of this slab.
    pub interval: SlabInterval,
    /// The largest near of the slabs up to this one; −∞ if the ray is parallel to all of them.
    pub max_near: f64,
    /// The smallest far of the slabs up to this one; ∞ if the ray is parallel to all of them.
    pub min_far: f64,
    /// Whether the next slab is looked at.
    pub outcome: SlabOutcome,
}

/// Where a ray is inside a bound: from the largest near to the smallest far; nowhere if these have crossed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// The largest of the near values.
    pub near: f64,
    /// The smallest of the far values.
    pub far: f64,
}

impl Inside {
    /// Is any of it in the range? Equality counts.
    #[inline]
    pub fn meets(&self, range: TRange) -> bool {
        self.begins(range) <= smaller(self.far, range.max)
    }

    /// Where the ray comes into it: not before its own range begins.
    #[inline]
    pub fn begins(&self, range: TRange) -> f64 {
        larger(self.near, range.min)
    }

    /// Both ends, unless they have crossed.
    pub fn ends(&self) -> Option<[f64; 2]> {
        (self.near <= self.far).then_some([self.near, self.far])
    }
}

/// S and T of a ray for each direction of a set: computed once for all bounds.
///
/// Every slab is met a little wider than it is, so that rounding cuts off no hit that an object's own test
/// finds: S has room for either plane, 2·10⁻¹⁰ of the coordinates.
#[derive(Clone, Copy, Debug)]
pub struct RaySlabs<const N: usize> {
    /// S, less the room: for the plane of D_min.
    s_min: [f64; N],
    /// S and the room: for the plane of D_max.
    s_max: [f64; N],
    /// T.
    t_scale: [f64; N],
}

/// The room that a slab is given on either side, as a share of the coordinates of the ray's origin and of the
/// bounds: a millionfold of ε, for a sphere's root is good to 10⁻¹⁰ of itself, and where a ray meets a
/// surface flatly hits lie off the surface by a hundredfold of ε.
pub(super) const ROOM: f64 = 2e-10;

/// A t beyond this comes from a parallel slab: a scene's numbers end at 10⁵⁰, a parallel T begins at 10²⁰⁰.
const FARTHEST: f64 = 1e120;

/// So many slabs make a box.
const BOX: usize = 3;

impl<const N: usize> RaySlabs<N> {
    /// S and T of the ray for each direction; `reach` is the largest coordinate of what the bounds are around.
    #[inline]
    pub fn new(ray: &Ray, set: &SlabSet<N>, reach: f64) -> Self {
        let room = ROOM * (ray.origin.abs().element_sum() + reach);
        let s = set.products(ray.origin);
        let t_scale = set.products(ray.direction).map(|product| -1.0 / product);
        Self {
            s_min: s.map(|s| s - room),
            s_max: s.map(|s| s + room),
            // a parallel ray is far beyond every other slab, or before it
            t_scale: t_scale.map(|t| smaller(larger(t, -PARALLEL), PARALLEL)),
        }
    }
}

impl<const N: usize> SlabBound<N> {
    /// Nothing: every D_min above every D_max.
    pub const EMPTY: Self = Self {
        d_min: [f64::INFINITY; N],
        d_max: [f64::NEG_INFINITY; N],
    };

    /// The bound of a shape, widened for rounding.
    pub fn of(shape: &Shape, set: &SlabSet<N>) -> Self {
        // a direction that the set does not have bounds nothing
        let mut bound = Self {
            d_min: [f64::NEG_INFINITY; N],
            d_max: [f64::INFINITY; N],
        };
        let mut first = 0;
        if set.begins_with_axes() {
            let [smallest, largest] = box_around(shape);
            first = BOX;
            for slab in 0..BOX {
                (bound.d_min[slab], bound.d_max[slab]) = (-largest[slab], -smallest[slab]);
            }
        }
        for (slab, &normal) in set.directions().iter().enumerate().skip(first) {
            let [smallest, largest] = extent(shape, normal);
            (bound.d_min[slab], bound.d_max[slab]) = (-largest, -smallest);
        }
        bound
    }

    /// The bound of two bounds: "the minimum D_min and the maximum D_max of the values for each child
    /// volume" (Fig. 15.58(b)).
    #[must_use]
    #[inline]
    pub fn union(&self, other: &Self) -> Self {
        let mut joined = *self;
        for slab in 0..N {
            joined.d_min[slab] = smaller(self.d_min[slab], other.d_min[slab]);
            joined.d_max[slab] = larger(self.d_max[slab], other.d_max[slab]);
        }
        joined
    }

    /// Where is the ray inside the bound?
    ///
    /// With t = (S + D)·T for both planes of a slab, the smaller is its near and the larger its far value;
    /// near = max nearᵢ, far = min farᵢ. No division, and left as soon as they have crossed. A parallel ray
    /// is inside its slab from some −10²⁰⁰ to 10²⁰⁰, or only beyond that. `tell` hears of each slab with the
    /// largest near and the smallest far up to it, and says whether anybody listens: if not, it is asked once
    /// only whether they have crossed, behind the third slab, since a jump costs more than a slab.
    #[inline]
    pub fn inside(
        &self,
        ray: &RaySlabs<N>,
        mut tell: impl FnMut(usize, f64, f64) -> bool,
    ) -> Inside {
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        for slab in 0..N {
            let at_min = (ray.s_min[slab] + self.d_min[slab]) * ray.t_scale[slab];
            let at_max = (ray.s_max[slab] + self.d_max[slab]) * ray.t_scale[slab];
            near = larger(near, smaller(at_min, at_max));
            far = smaller(far, larger(at_min, at_max));
            if tell(slab, near, far) {
                if crossed(near, far) {
                    far = f64::NEG_INFINITY;
                    break;
                }
            } else if slab + 1 == BOX && far < near {
                break;
            }
        }
        Inside { near, far }
    }

    /// The working of one slab; `so_far` is the largest near and the smallest far of the slabs before it, and
    /// `crossed` whether the bound is left here.
    ///
    /// The numbers are those of the slab itself, without the room of [`RaySlabs`].
    pub fn step(
        &self,
        slab: usize,
        ray: &Ray,
        set: &SlabSet<N>,
        so_far: [f64; 2],
        crossed: bool,
    ) -> SlabStep {
        let line = SlabRay::new(ray, set.padded()[slab]);
        let (d_min, d_max) = (self.d_min[slab], self.d_max[slab]);
        let interval = line.interval(d_min, d_max);
        let [mut max_near, mut min_far] = so_far;
        if let SlabInterval::Between { near, far } = interval {
            (max_near, min_far) = (larger(max_near, near), smaller(min_far, far));
        }
        let outcome = match interval {
            SlabInterval::ParallelOutside if crossed => SlabOutcome::ParallelOutside,
            _ if crossed => SlabOutcome::Null,
            SlabInterval::ParallelInside | SlabInterval::ParallelOutside => {
                SlabOutcome::ParallelInside
            }
            SlabInterval::Between { .. } => SlabOutcome::GoesOn,
        };
        SlabStep {
            slab: slab as u32,
            d_min,
            d_max,
            interval,
            max_near,
            min_far,
            outcome,
        }
    }
}

/// Is nothing left between the largest near and the smallest far? Beyond a parallel slab there never is, which
/// its neighbours would show a slab later.
pub(crate) fn crossed(near: f64, far: f64) -> bool {
    far < near || FARTHEST < near || far < -FARTHEST
}

/// Nothing is known of a ray before its first slab: every t.
pub(crate) const NO_SLAB: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    use crate::geometry::Sphere;

    /// The unit sphere between the four directions of Fig. 15.58 and one across them.
    fn four_and_one() -> (SlabSet<16>, SlabBound<16>) {
        let directions = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, -1.0, 0.0],
        ];
        let mut directions = directions.map(DVec3::from).to_vec();
        directions.push(DVec3::Z);
        let set = SlabSet::of(&directions).unwrap();
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        });
        (set, SlabBound::of(&sphere, &set))
    }

    #[track_caller]
    fn inside(origin: [f64; 3], direction: [f64; 3]) -> Option<[f64; 2]> {
        let (set, bound) = four_and_one();
        let ray = Ray::new(origin.into(), direction.into());
        let found = bound.inside(&RaySlabs::new(&ray, &set, 1.0), |_, _, _| true);
        let ends = found.ends().filter(|_| found.meets(TRange::FORWARD));
        ends.map(|ends| ends.map(|t| (t * 1e6).round() / 1e6))
    }

    #[test]
    fn a_ray_along_x_is_inside_from_the_near_plane_of_x_to_its_far_plane() {
        assert_eq!(inside([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Some([2.0, 4.0]));
    }

    #[test]
    fn a_corner_of_the_box_is_cut_off_by_the_diagonal_slab() {
        // x + y ≤ √2 at the ray y = 0.9 along x: x from −1 … √2 − 0.9 = 0.514214
        assert_eq!(
            inside([-3.0, 0.9, 0.0], [1.0, 0.0, 0.0]),
            Some([2.485_786, 3.514_214])
        );
        // through (0.95, 0.95), which lies in the box alone
        assert_eq!(inside([-0.05, 1.95, 0.0], [1.0, -1.0, 0.0]), None);
    }

    #[test]
    fn a_parallel_ray_outside_is_refused_at_that_slab_in_either_direction() {
        for delta in [1.0, -1.0] {
            assert_eq!(inside([0.0, 1.5, 0.0], [delta, 0.0, 0.0]), None);
            assert_eq!(inside([0.0, 0.0, 1.5], [delta, -0.0, 0.0]), None);
        }
    }

    #[test]
    fn the_steps_of_a_missed_bound_end_where_near_and_far_cross() {
        let (set, bound) = four_and_one();
        let ray = Ray::new(DVec3::new(-0.05, 1.95, 0.0), DVec3::new(1.0, -1.0, 0.0));
        let mut steps: Vec<SlabStep> = Vec::new();
        bound.inside(&RaySlabs::new(&ray, &set, 1.0), |slab, near, far| {
            let so_far = steps
                .last()
                .map_or(NO_SLAB, |step| [step.max_near, step.min_far]);
            steps.push(bound.step(slab, &ray, &set, so_far, crossed(near, far)));
            true
        });
        let outcomes: Vec<_> = steps.iter().map(|step| step.outcome).collect();
        use SlabOutcome::{GoesOn, ParallelOutside};
        assert_eq!(outcomes, [GoesOn, GoesOn, ParallelOutside]);
        // x: −1 − (−0.05) = −0.95 … 1.05; y: 1.95 − 1 = 0.95 … 2.95
        assert!((steps[1].max_near - 0.95).abs() <= 1e-8);
        assert!((steps[1].min_far - 1.05).abs() <= 1e-8);
    }

    #[test]
    fn the_bound_of_two_bounds_takes_the_smaller_d_min_and_the_larger_d_max() {
        let bound = |d_min, d_max| SlabBound { d_min, d_max };
        let a = bound([-1.0, 0.0, -3.0], [2.0, 5.0, -2.0]);
        let b = bound([-2.0, 1.0, 0.0], [1.0, 4.0, 7.0]);
        let joined = bound([-2.0, 0.0, -3.0], [2.0, 5.0, 7.0]);
        assert_eq!(a.union(&b), joined);
        assert_eq!(SlabBound::EMPTY.union(&a), a);
    }
}
