//! Lesson 10: bounding volumes.
//!
//! - bounding volume: around an object, so that most rays need not be tested against it
//! - S, T: of a ray and a direction of slabs, once for all slabs
//! - near, far: where the ray enters a slab and leaves it
//! - interval: from the largest near to the smallest far

use glam::DVec3;
use raystep::geometry::{AxisBox, Inside, Ray, SlabInterval, SlabRay, Sphere, TRange};
use raystep::trace::BoundVerdict;

/// The smallest sphere around a box. `around.min` and `around.max` are its corners.
pub fn sphere_around(around: &AxisBox) -> Sphere {
    todo!()
}

/// [D_min, D_max] of the slab around an object, across the unit normal n = (A, B, C).
///
/// The plane through a vertex v is A·x + B·y + C·z + D = 0, so D = −n·v.
pub fn slab_of(vertices: &[DVec3], n: DVec3) -> [f64; 2] {
    todo!()
}

/// S = A·x₀ + B·y₀ + C·z₀ and T = −1/(A·Δx + B·Δy + C·Δz), so that t = (S + D)·T.
///
/// A `SlabRay` has `s` and `t_scale`, which is T. T of a parallel ray is infinite.
pub fn slab_ray(ray: &Ray, normal: DVec3) -> SlabRay {
    todo!()
}

/// near and far of one slab: t = (S + D)·T for D_min and D_max.
///
/// The results are `SlabInterval::Between { near, far }`, `SlabInterval::ParallelInside` (in a face counts as inside) and
/// `SlabInterval::ParallelOutside`. `line.s` is S, `line.t_scale` is T.
pub fn slab_interval(line: &SlabRay, d_min: f64, d_max: f64) -> SlabInterval {
    todo!()
}

/// What is left of an interval inside one more slab: near = max(near, nearᵢ), far = min(far, farᵢ).
///
/// An `Inside` has `near` and `far`; it is empty where far < near. `Inside::NOWHERE` is an empty one.
pub fn interval(so_far: Inside, slab: SlabInterval) -> Inside {
    todo!()
}

/// Must what is inside a bounding volume be tested?
///
/// `inside` is [near, far], or None if the ray passes by. `BoundVerdict::Missed`, `Behind` (it ends before the range),
/// `Beyond` (it begins after the range) or `Hit`; equality counts as a hit.
pub fn bound_verdict(inside: Option<[f64; 2]>, range: TRange) -> BoundVerdict {
    todo!()
}

/// The bounding volume of two bounding volumes. Each is [D_min, D_max] of each slab; the directions are the same.
pub fn union(one: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<[f64; 2]> {
    todo!()
}
