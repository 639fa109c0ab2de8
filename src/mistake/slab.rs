//! The slab: near and far, and what slabs have in common.

use crate::geometry::{Inside, PARALLEL, SlabInterval, SlabRay};
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "divides by zero",
        sentence: "T of a parallel ray is infinite and is used all the same, so 0·∞ has no value and a slab that the ray misses has an interval.",
        spoils: "near and far",
        wrong: Wrong::SlabInterval(divides_by_zero),
    },
    Mistake {
        name: "no swap",
        sentence: "t of D_min is taken for near and t of D_max for far, whichever way the ray goes.",
        spoils: "near and far",
        wrong: Wrong::SlabInterval(no_swap),
    },
    Mistake {
        name: "running interval thrown away",
        sentence: "The last slab's own near and far decide, and those of the slabs before it are forgotten.",
        spoils: "max near and min far",
        wrong: Wrong::SlabsSoFar(running_interval_thrown_away),
    },
];

fn divides_by_zero(line: &SlabRay, d_min: f64, d_max: f64) -> SlabInterval {
    let [at_min, at_max] = [d_min, d_max].map(|d| (line.s + d) * line.t_scale);
    let (near, far) = if line.t_scale < 0.0 {
        (at_max, at_min)
    } else {
        (at_min, at_max)
    };
    SlabInterval::Between { near, far }
}

fn no_swap(line: &SlabRay, d_min: f64, d_max: f64) -> SlabInterval {
    if PARALLEL < line.t_scale.abs() {
        return line.interval(d_min, d_max);
    }
    SlabInterval::Between {
        near: (line.s + d_min) * line.t_scale,
        far: (line.s + d_max) * line.t_scale,
    }
}

fn running_interval_thrown_away(so_far: Inside, slab: SlabInterval) -> Inside {
    match slab {
        SlabInterval::Between { near, far } => Inside { near, far },
        SlabInterval::ParallelInside | SlabInterval::ParallelOutside => so_far.and(slab),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::Ray;

    /// The slab 1 ≤ x ≤ 3, so D_min = −3 and D_max = −1, and a ray from this x.
    fn of(
        interval: fn(&SlabRay, f64, f64) -> SlabInterval,
        x: f64,
        direction: [f64; 2],
    ) -> SlabInterval {
        let [dx, dy] = direction;
        let ray = Ray::new(DVec3::new(x, 0.0, 0.0), DVec3::new(dx, dy, 0.0));
        interval(&SlabRay::new(&ray, DVec3::X), -3.0, -1.0)
    }

    fn between(near: f64, far: f64) -> SlabInterval {
        SlabInterval::Between { near, far }
    }

    #[test]
    fn near_is_the_smaller_t_for_either_direction() {
        // upwards from 0 at half speed: 2 and 6; downwards from 5: 4 and 8
        assert_eq!(of(SlabRay::interval, 0.0, [0.5, 0.0]), between(2.0, 6.0));
        assert_eq!(of(no_swap, 0.0, [0.5, 0.0]), between(6.0, 2.0));
        assert_eq!(of(SlabRay::interval, 5.0, [-0.5, 0.0]), between(4.0, 8.0));
        assert_eq!(of(no_swap, 5.0, [-0.5, 0.0]), between(4.0, 8.0));
    }

    #[test]
    fn a_parallel_ray_has_no_t() {
        let up = [0.0, 1.0];
        // beside the slab: (0 − 3)·(−∞) and (0 − 1)·(−∞)
        let beside = of(SlabRay::interval, 0.0, up);
        assert_eq!(beside, SlabInterval::ParallelOutside);
        let endless = f64::INFINITY;
        assert_eq!(of(divides_by_zero, 0.0, up), between(endless, endless));
        // in a plane: 0·∞
        let within = of(SlabRay::interval, 1.0, up);
        assert_eq!(within, SlabInterval::ParallelInside);
        let SlabInterval::Between { near, .. } = of(divides_by_zero, 1.0, up) else {
            panic!("an interval");
        };
        assert!(near.is_nan());
        // a ray that is not parallel
        assert_eq!(of(divides_by_zero, 0.0, [0.5, 0.0]), between(2.0, 6.0));
    }

    #[test]
    fn the_interval_runs_through_all_slabs() {
        let x = Inside {
            near: 2.0,
            far: 6.0,
        };
        // [2, 6] and [7, 9] have nothing in common
        assert!(x.and(between(7.0, 9.0)).is_empty());
        let wrong = running_interval_thrown_away(x, between(7.0, 9.0));
        assert_eq!(wrong.ends(), Some([7.0, 9.0]));
        let inner = between(3.0, 4.0);
        assert_eq!(x.and(inner), running_interval_thrown_away(x, inner));
    }
}
