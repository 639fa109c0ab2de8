//! A bound after Kay and Kajiya: the intersection of slabs, kept as the D_min and D_max of each.
//!
//! Slides, "Optimizing Intersection Calculations" (Fig. 15.58): each bound is described "compactly by the
//! D_min and D_max of each of its slabs"; S and T are "calculated once for a given ray and parameterized
//! slab"; the ray is inside the bound from the maximum of the near values of t to the minimum of the far
//! ones, both "updated as each of its slabs is processed, and the processing of the bound terminated if the
//! former ever exceeds the latter".

use glam::DVec3;

use crate::geometry::{PARALLEL, Ray, SlabInterval, SlabRay, TRange};
use crate::scene::Shape;
use crate::structure::{SlabSet, extent};

/// D_min and D_max of each slab. A, B and C are those of the structure's [`SlabSet`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabBound<const N: usize> {
    /// [D_min, D_max] for each direction of the set.
    pub d: [[f64; 2]; N],
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
    /// (A, B, C), of unit length.
    pub normal: DVec3,
    /// S = A·x₀ + B·y₀ + C·z₀
    pub s: f64,
    /// T = −1/(A·Δx + B·Δy + C·Δz); infinite for a parallel ray.
    pub t_scale: f64,
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

/// The larger of two numbers: one instruction, unlike `f64::max`, which must look out for NaN.
#[inline]
fn larger(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// The smaller of two numbers.
#[inline]
fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// S and T of a ray for each direction of a set: computed once for all bounds.
///
/// Each slab is met with a little room on both sides, so that rounding cuts off no hit that an object's own
/// test finds: S is shifted by [`SHIFT`] of the origin's coordinates, and T is stretched by [`STRETCH`].
#[derive(Clone, Copy, Debug)]
pub struct RaySlabs<const N: usize> {
    lines: [SlabLine; N],
}

/// S and T of one direction, for the near plane and for the far one.
///
/// T of the far plane is negated, so that both are treated alike: the smallest far is the largest −far.
#[derive(Clone, Copy, Debug)]
struct SlabLine {
    s: [f64; 2],
    t_scale: [f64; 2],
    /// Whether the near plane is that of D_min, 0, or that of D_max, 1 (erratum 5).
    near_is: usize,
}

/// A t beyond this comes from a parallel slab: a scene's numbers end at 10⁵⁰, a parallel T begins at 10²⁰⁰.
const FARTHEST: f64 = 1e120;

/// The first slabs are looked at together: to leave between them costs more than it saves.
const BOX: usize = 2;

/// Room for the rounding of S and D: a ten-thousandfold of ε.
const SHIFT: f64 = 1e-11;
/// Room for the error of an object's own t: a sphere's root is good to 10⁻¹⁰ of itself.
const STRETCH: f64 = 1e-9;

impl<const N: usize> RaySlabs<N> {
    /// S and T of the ray for each direction.
    #[inline]
    pub fn new(ray: &Ray, set: &SlabSet<N>) -> Self {
        let shift = SHIFT * ray.origin.abs().element_sum();
        let lines = set.padded().map(|normal| {
            let SlabRay { s, t_scale } = SlabRay::new(ray, normal);
            // a parallel ray needs no division: it is far beyond every other slab, or before it
            let t_scale = t_scale.clamp(-PARALLEL, PARALLEL);
            let towards = shift.copysign(t_scale);
            SlabLine {
                s: [s - towards, s + towards],
                t_scale: [t_scale * (1.0 - STRETCH), -t_scale * (1.0 + STRETCH)],
                near_is: usize::from(t_scale < 0.0),
            }
        });
        Self { lines }
    }
}

impl<const N: usize> SlabBound<N> {
    /// Nothing: every D_min above every D_max.
    pub const EMPTY: Self = Self {
        d: [[f64::INFINITY, f64::NEG_INFINITY]; N],
    };

    /// The bound of a shape, widened for rounding.
    pub fn of(shape: &Shape, set: &SlabSet<N>) -> Self {
        let mut bound = Self {
            d: [[f64::NEG_INFINITY, f64::INFINITY]; N],
        };
        for (d, &normal) in bound.d.iter_mut().zip(set.directions()) {
            let [smallest, largest] = extent(shape, normal);
            *d = [-largest, -smallest];
        }
        bound
    }

    /// The bound of two bounds: "the minimum D_min and the maximum D_max of the values for each child
    /// volume" (Fig. 15.58(b)).
    #[must_use]
    #[inline]
    pub fn union(&self, other: &Self) -> Self {
        let mut joined = *self;
        for (d, [d_min, d_max]) in joined.d.iter_mut().zip(other.d) {
            *d = [d[0].min(d_min), d[1].max(d_max)];
        }
        joined
    }

    /// How wide the bound is in each direction: D_max − D_min.
    #[inline]
    pub fn widths(&self) -> [f64; N] {
        self.d.map(|[d_min, d_max]| d_max - d_min)
    }

    /// Where is the ray inside the bound?
    ///
    /// near = max (S + D_near)·T, far = min (S + D_far)·T, without a division. Left as soon as they have
    /// crossed. A parallel ray is inside its slab from some −10²⁰⁰ to 10²⁰⁰, or only beyond that. `tell`
    /// hears of each slab with the largest near and the smallest far up to it.
    #[inline]
    pub fn inside(&self, ray: &RaySlabs<N>, mut tell: impl FnMut(usize, f64, f64)) -> Inside {
        let mut largest = [f64::NEG_INFINITY; 2];
        for (slab, (d, line)) in self.d.iter().zip(&ray.lines).enumerate() {
            // the mask tells the compiler that there is no third
            let planes = [d[line.near_is & 1], d[!line.near_is & 1]];
            let t = [0, 1].map(|end| (line.s[end] + planes[end]) * line.t_scale[end]);
            largest = [0, 1].map(|end| larger(largest[end], t[end]));
            let [near, minus_far] = largest;
            tell(slab, near, -minus_far);
            if BOX <= slab && -minus_far < near {
                break;
            }
        }
        let [near, minus_far] = largest;
        Inside {
            near,
            far: -minus_far,
        }
    }

    /// The working of one slab, for a ray of which `max_near` and `min_far` are known up to it.
    pub fn step(
        &self,
        slab: usize,
        ray: &Ray,
        set: &SlabSet<N>,
        [max_near, min_far]: [f64; 2],
    ) -> SlabStep {
        // what lies beyond a parallel slab has no bound
        let limited = |t: f64| {
            if t.abs() < FARTHEST {
                t
            } else {
                t * f64::INFINITY
            }
        };
        let (max_near, min_far) = (limited(max_near), limited(min_far));
        let normal = set.padded()[slab];
        let line = SlabRay::new(ray, normal);
        let [d_min, d_max] = self.d[slab];
        let interval = line.interval(d_min, d_max);
        let crossed =
            min_far < max_near || max_near == f64::INFINITY || min_far == f64::NEG_INFINITY;
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
            normal,
            s: line.s,
            t_scale: line.t_scale,
            d_min,
            d_max,
            interval,
            max_near,
            min_far,
            outcome,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let found = bound.inside(&RaySlabs::new(&ray, &set), |_, _, _| {});
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
        let mut steps = Vec::new();
        bound.inside(&RaySlabs::new(&ray, &set), |slab, near, far| {
            steps.push(bound.step(slab, &ray, &set, [near, far]));
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
        let a = SlabBound {
            d: [[-1.0, 2.0], [0.0, 5.0], [-3.0, -2.0]],
        };
        let b = SlabBound {
            d: [[-2.0, 1.0], [1.0, 4.0], [0.0, 7.0]],
        };
        let joined = [[-2.0, 2.0], [0.0, 5.0], [-3.0, 7.0]];
        assert_eq!(a.union(&b), SlabBound { d: joined });
        assert_eq!(SlabBound::EMPTY.union(&a), a);
    }
}
