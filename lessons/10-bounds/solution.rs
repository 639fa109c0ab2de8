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
    // BEGIN SOLUTION
    Sphere {
        center: 0.5 * (around.min + around.max),
        radius: 0.5 * (around.max - around.min).length(),
    }
    // END SOLUTION
}

/// [D_min, D_max] of the slab around an object, across the unit normal n = (A, B, C).
///
/// The plane through a vertex v is A·x + B·y + C·z + D = 0, so D = −n·v.
pub fn slab_of(vertices: &[DVec3], n: DVec3) -> [f64; 2] {
    // BEGIN SOLUTION
    let mut slab = [f64::INFINITY, f64::NEG_INFINITY];
    for vertex in vertices {
        let d = -n.dot(*vertex);
        slab = [slab[0].min(d), slab[1].max(d)];
    }
    slab
    // END SOLUTION
}

/// S = A·x₀ + B·y₀ + C·z₀ and T = −1/(A·Δx + B·Δy + C·Δz), so that t = (S + D)·T.
///
/// A `SlabRay` has `s` and `t_scale`, which is T. T of a parallel ray is infinite.
pub fn slab_ray(ray: &Ray, normal: DVec3) -> SlabRay {
    // BEGIN SOLUTION
    SlabRay {
        s: normal.dot(ray.origin),
        t_scale: -1.0 / normal.dot(ray.direction),
    }
    // END SOLUTION
}

/// near and far of one slab: t = (S + D)·T for D_min and D_max.
///
/// The results are `SlabInterval::Between { near, far }`, `SlabInterval::ParallelInside` (in a face counts as inside) and
/// `SlabInterval::ParallelOutside`. `line.s` is S, `line.t_scale` is T.
pub fn slab_interval(line: &SlabRay, d_min: f64, d_max: f64) -> SlabInterval {
    // BEGIN SOLUTION
    if line.t_scale.is_infinite() {
        let is_inside = line.s + d_min <= 0.0 && 0.0 <= line.s + d_max;
        return if is_inside {
            SlabInterval::ParallelInside
        } else {
            SlabInterval::ParallelOutside
        };
    }
    let [a, b] = [d_min, d_max].map(|d| (line.s + d) * line.t_scale);
    SlabInterval::Between {
        near: a.min(b),
        far: a.max(b),
    }
    // END SOLUTION
}

/// What is left of an interval inside one more slab: near = max(near, nearᵢ), far = min(far, farᵢ).
///
/// An `Inside` has `near` and `far`; it is empty where far < near. `Inside::NOWHERE` is an empty one.
pub fn interval(so_far: Inside, slab: SlabInterval) -> Inside {
    // BEGIN SOLUTION
    match slab {
        SlabInterval::Between { near, far } => Inside {
            near: so_far.near.max(near),
            far: so_far.far.min(far),
        },
        SlabInterval::ParallelInside => so_far,
        SlabInterval::ParallelOutside => Inside::NOWHERE,
    }
    // END SOLUTION
}

/// Must what is inside a bounding volume be tested?
///
/// `inside` is [near, far], or None if the ray passes by. `BoundVerdict::Missed`, `Behind` (it ends before the range),
/// `Beyond` (it begins after the range) or `Hit`; equality counts as a hit.
pub fn bound_verdict(inside: Option<[f64; 2]>, range: TRange) -> BoundVerdict {
    // BEGIN SOLUTION
    let Some([near, far]) = inside else {
        return BoundVerdict::Missed;
    };
    if far < range.min {
        BoundVerdict::Behind
    } else if range.max < near {
        BoundVerdict::Beyond
    } else {
        BoundVerdict::Hit
    }
    // END SOLUTION
}

/// The bounding volume of two bounding volumes. Each is [D_min, D_max] of each slab; the directions are the same.
pub fn union(one: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<[f64; 2]> {
    // BEGIN SOLUTION
    let slabs = one.iter().zip(other);
    slabs
        .map(|(a, b)| [a[0].min(b[0]), a[1].max(b[1])])
        .collect()
    // END SOLUTION
}
