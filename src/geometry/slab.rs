//! The slab: the space between two parallel planes, in the slides' own form.
//!
//! Both planes are A·x + B·y + C·z + D = 0 with the same normal (A, B, C); D is `D_min` on one and `D_max`
//! on the other. A larger D is a plane further *back* along the normal (erratum 5).

use glam::DVec3;

use crate::geometry::Ray;

/// The part of (v) that a ray and a direction of slabs have in common, computed once for both.
///
/// S = A·x₀ + B·y₀ + C·z₀,  T = −1/(A·Δx + B·Δy + C·Δz)
///
/// The slides print t = (S + D)/T; (v) gives a product: t = (S + D)·T (erratum 2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabRay {
    /// S: where the origin lies along the normal.
    pub s: f64,
    /// The slides' T; beyond [`PARALLEL`] either way if the ray is parallel to the slab.
    pub t_scale: f64,
}

/// A ray counts as parallel to a slab if it needs a t of 10²⁰⁰ to cross one unit of it: so far out the
/// products (S + D)·T of allowed coordinates would leave f64.
pub const PARALLEL: f64 = 1e200;

/// Which t of a ray lie inside one slab?
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum SlabInterval {
    /// From the near plane to the far one.
    Between {
        /// The smaller t.
        near: f64,
        /// The larger t.
        far: f64,
    },
    /// The ray is parallel to the planes, and between them or in one of them: every t.
    #[default]
    ParallelInside,
    /// The ray is parallel to the planes and passes outside: no t.
    ParallelOutside,
}

impl SlabInterval {
    /// Which t lie between two planes across an axis, `low` not above `high`, for a ray that starts at the coordinate
    /// `origin` and moves by `direction` along that axis while t grows by 1?
    ///
    /// t = (plane − origin)/direction; parallel if `direction` is 0. One division for each plane and no T: the form for
    /// a box whose slabs a ray hits once.
    ///
    /// ```
    /// use raystep::geometry::SlabInterval;
    ///
    /// let back = SlabInterval::across_axis(5.0, -0.5, [1.0, 3.0]);
    /// assert_eq!(back, SlabInterval::Between { near: 4.0, far: 8.0 });
    /// ```
    #[inline]
    pub fn across_axis(origin: f64, direction: f64, [low, high]: [f64; 2]) -> Self {
        if direction == 0.0 {
            return if low <= origin && origin <= high {
                Self::ParallelInside
            } else {
                Self::ParallelOutside
            };
        }
        let [a, b] = [low, high].map(|plane| (plane - origin) / direction);
        Self::Between {
            near: a.min(b),
            far: a.max(b),
        }
    }
}

impl SlabRay {
    /// S and T for a ray and a normal (A, B, C).
    #[inline]
    pub fn new(ray: &Ray, normal: DVec3) -> Self {
        Self {
            s: normal.dot(ray.origin),
            t_scale: -1.0 / normal.dot(ray.direction),
        }
    }

    /// t = (S + D)·T for `D_min` and `D_max`; without a division.
    ///
    /// Parallel (T infinite, or beyond [`PARALLEL`]): inside if S + `D_min` ≤ 0 ≤ S + `D_max`.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Ray, SlabInterval, SlabRay};
    ///
    /// // 1 ≤ x ≤ 3 is the slab with normal (1, 0, 0), D_min = −3 and D_max = −1
    /// let ray = Ray::new(DVec3::ZERO, DVec3::new(0.5, 0.5, 0.0));
    /// let slab = SlabRay::new(&ray, DVec3::X);
    /// assert_eq!((slab.s, slab.t_scale), (0.0, -2.0));
    /// let interval = slab.interval(-3.0, -1.0);
    /// assert_eq!(interval, SlabInterval::Between { near: 2.0, far: 6.0 });
    /// ```
    #[inline]
    pub fn interval(&self, d_min: f64, d_max: f64) -> SlabInterval {
        self.interval_with_room(d_min, d_max, 0.0)
    }

    /// [`SlabRay::interval`] of a slab that is wider by `room` on either side, which is a length.
    ///
    /// The plane furthest along the normal has t = (S − room + `D_min`)·T, the one furthest back
    /// t = (S + room + `D_max`)·T.
    #[inline]
    pub fn interval_with_room(&self, d_min: f64, d_max: f64, room: f64) -> SlabInterval {
        let from_min = self.s - room + d_min;
        let from_max = self.s + room + d_max;
        if PARALLEL < self.t_scale.abs() {
            return if from_min <= 0.0 && 0.0 <= from_max {
                SlabInterval::ParallelInside
            } else {
                SlabInterval::ParallelOutside
            };
        }
        let (at_min, at_max) = (from_min * self.t_scale, from_max * self.t_scale);
        // n·d > 0 makes T negative: then the near plane is that of D_max (erratum 5)
        if self.t_scale < 0.0 {
            SlabInterval::Between {
                near: at_max,
                far: at_min,
            }
        } else {
            SlabInterval::Between {
                near: at_min,
                far: at_max,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interval(origin: [f64; 3], direction: [f64; 3], normal: [f64; 3]) -> SlabInterval {
        let ray = Ray::new(origin.into(), direction.into());
        SlabRay::new(&ray, normal.into()).interval(-3.0, -1.0)
    }

    #[test]
    fn the_near_plane_is_that_of_d_max_along_the_normal_and_of_d_min_against_it() {
        let between = |near, far| SlabInterval::Between { near, far };
        assert_eq!(
            interval([0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
            between(1.0, 3.0)
        );
        assert_eq!(
            interval([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
            between(2.0, 4.0)
        );
    }

    #[test]
    fn across_an_axis_the_interval_is_that_of_the_slab() {
        let between = |near, far| SlabInterval::Between { near, far };
        for (origin, direction, expected) in [
            (0.0, 1.0, between(1.0, 3.0)),
            (5.0, -1.0, between(2.0, 4.0)),
            (2.0, 0.5, between(-2.0, 2.0)),
            (1.0, 0.0, SlabInterval::ParallelInside),
            (3.0, -0.0, SlabInterval::ParallelInside),
            (3.25, 0.0, SlabInterval::ParallelOutside),
            (0.75, -0.0, SlabInterval::ParallelOutside),
        ] {
            let found = SlabInterval::across_axis(origin, direction, [1.0, 3.0]);
            assert_eq!(found, expected, "{origin} {direction}");
            // −3 ≤ D ≤ −1 along x
            let slab = interval([origin, 0.0, 0.0], [direction, 1.0, 0.0], [1.0, 0.0, 0.0]);
            assert_eq!(slab, expected, "{origin} {direction}");
        }
    }

    #[test]
    fn a_slanted_slab_is_met_where_its_planes_are() {
        // x + y between 1 and 3, ray along (1, 1, 0): x + y = 2t
        let found = interval([0.0; 3], [1.0, 1.0, 0.0], [1.0, 1.0, 0.0]);
        assert_eq!(
            found,
            SlabInterval::Between {
                near: 0.5,
                far: 1.5
            }
        );
    }

    #[test]
    fn room_moves_both_planes_outwards_and_t_with_them() {
        // 1 ≤ x ≤ 3, a quarter wider: 0.75 … 3.25, met at half a unit for each t
        let ray = Ray::new(DVec3::ZERO, DVec3::new(0.5, 0.5, 0.0));
        let wider = SlabRay::new(&ray, DVec3::X).interval_with_room(-3.0, -1.0, 0.25);
        let between = |near, far| SlabInterval::Between { near, far };
        assert_eq!(wider, between(1.5, 6.5));
        // back from x = 4
        let back = Ray::new(DVec3::new(4.0, 0.0, 0.0), DVec3::NEG_X);
        let wider = SlabRay::new(&back, DVec3::X).interval_with_room(-3.0, -1.0, 0.25);
        assert_eq!(wider, between(0.75, 3.25));
        // along y, beside the slab by less than the room, and by more
        for (x, expected) in [
            (3.25, SlabInterval::ParallelInside),
            (3.5, SlabInterval::ParallelOutside),
        ] {
            let along = Ray::new(DVec3::new(x, 0.0, 0.0), DVec3::Y);
            let found = SlabRay::new(&along, DVec3::X).interval_with_room(-3.0, -1.0, 0.25);
            assert_eq!(found, expected, "{x}");
        }
    }

    #[test]
    fn a_parallel_ray_is_inside_or_outside_and_a_plane_belongs_to_the_slab() {
        for (x, expected) in [
            (0.999, SlabInterval::ParallelOutside),
            (1.0, SlabInterval::ParallelInside),
            (2.0, SlabInterval::ParallelInside),
            (3.0, SlabInterval::ParallelInside),
            (3.001, SlabInterval::ParallelOutside),
        ] {
            for direction in [[0.0, 1.0, 0.0], [-0.0, 1.0, 0.0]] {
                assert_eq!(
                    interval([x, 0.0, 0.0], direction, [1.0, 0.0, 0.0]),
                    expected
                );
            }
        }
    }

    #[test]
    fn a_ray_that_needs_ten_to_the_200_for_a_unit_is_not_yet_parallel() {
        // (0 − 3)·10²⁰⁰ and (0 − 1)·10²⁰⁰: far behind, but two numbers
        let slab = SlabRay {
            s: 0.0,
            t_scale: PARALLEL,
        };
        let (near, far) = (-3.0 * PARALLEL, -PARALLEL);
        assert_eq!(
            slab.interval(-3.0, -1.0),
            SlabInterval::Between { near, far }
        );
        // the next number is, and x = 0 lies outside of 1 ≤ x ≤ 3
        let slab = SlabRay {
            s: 0.0,
            t_scale: PARALLEL.next_up(),
        };
        assert_eq!(slab.interval(-3.0, -1.0), SlabInterval::ParallelOutside);
    }
}
