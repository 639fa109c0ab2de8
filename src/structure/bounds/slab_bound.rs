//! A bound after Kay and Kajiya: the intersection of slabs, kept as the D_min and D_max of each.
//!
//! Slides, "Optimizing Intersection Calculations" (Fig. 15.58): each bound is described "compactly by the
//! D_min and D_max of each of its slabs"; S and T are "calculated once for a given ray and parameterized
//! slab"; the ray is inside the bound from the maximum of the near values of t to the minimum of the far
//! ones, both "updated as each of its slabs is processed, and the processing of the bound terminated if the
//! former ever exceeds the latter".
//!
//! **Room for rounding.** A bound must not cut off a hit that the object's own test finds, and that hit is rounded.
//! So every slab is tested a little wider than it is: either plane is moved outwards by the [`room`](crate::structure::room) of the ray. A
//! bound is kept as the objects have it, without room.

use glam::DVec3;

use crate::geometry::{AxisBox, Inside, larger, smaller};
use crate::scene::Shape;
use crate::structure::bounds::extent::box_around;
use crate::structure::{RaySlabs, SlabSet, SlabStep, extent};

/// D_min and D_max of each slab. A, B and C are those of the structure's [`SlabSet`].
#[doc(alias = "k-DOP")]
#[doc(alias = "bounding volume")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabBound<const N: usize> {
    /// D_min for each direction of the set: minus the furthest place along the normal.
    pub d_min: [f64; N],
    /// D_max for each direction.
    pub d_max: [f64; N],
}

/// The number of slabs that make a box.
const BOX: usize = 3;

impl<const N: usize> SlabBound<N> {
    /// Nothing: every D_min above every D_max.
    pub const EMPTY: Self = Self {
        d_min: [f64::INFINITY; N],
        d_max: [f64::NEG_INFINITY; N],
    };

    /// The bound of a shape.
    pub fn of(shape: &Shape, set: &SlabSet<N>) -> Self {
        // a direction that the set does not have bounds nothing
        let mut bound = Self {
            d_min: [f64::NEG_INFINITY; N],
            d_max: [f64::INFINITY; N],
        };
        let mut first = 0;
        if set.begins_with_axes() {
            let around = box_around(shape);
            first = BOX;
            for slab in 0..BOX {
                bound.d_min[slab] = 0.0 - around.max[slab];
                bound.d_max[slab] = 0.0 - around.min[slab];
            }
        }
        for (slab, &normal) in set.directions().iter().enumerate().skip(first) {
            let [smallest, largest] = extent(shape, normal);
            // a difference, for −0 would have a sign in the log
            bound.d_min[slab] = 0.0 - largest;
            bound.d_max[slab] = 0.0 - smallest;
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

    /// Slab by slab: near and far t of each, the largest near and the smallest far up to it, and whether these have
    /// crossed. The step at which the ray misses the bound is the last.
    ///
    /// t = (S ∓ room + D)·T; near = max nearᵢ, far = min farᵢ.
    pub fn steps<'a>(
        &'a self,
        ray: &'a RaySlabs<N>,
        set: &'a SlabSet<N>,
    ) -> impl Iterator<Item = SlabStep> + 'a {
        let mut so_far = Some(Inside::EVERYWHERE);
        let slabs = 0..set.directions().len();
        slabs.map_while(move |slab| {
            let step = self.step(slab, ray, so_far?);
            so_far = step.inside();
            Some(step)
        })
    }

    /// Where is the ray inside the bound? `None` if it misses it. The last of the [`SlabBound::steps`] says so.
    pub fn inside(&self, ray: &RaySlabs<N>, set: &SlabSet<N>) -> Option<Inside> {
        self.steps(ray, set).last()?.inside()
    }

    /// One slab, where the ray is inside the ones before from `so_far.near` to `so_far.far`.
    fn step(&self, slab: usize, ray: &RaySlabs<N>, so_far: Inside) -> SlabStep {
        let step = SlabStep {
            slab: slab as u32,
            d_min: self.d_min[slab],
            d_max: self.d_max[slab],
            ..SlabStep::default()
        };
        step.decided(&ray.lines[slab], ray.room, so_far)
    }
}

impl SlabBound<BOX> {
    /// The box that slabs across x, y and z make: D_max and D_min are minus its smallest and its largest coordinates.
    pub fn as_box(&self) -> AxisBox {
        AxisBox {
            min: -DVec3::from(self.d_max),
            max: -DVec3::from(self.d_min),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Ray, SlabRay, Sphere};
    use crate::structure::SlabVerdict;

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

    /// The steps of a ray through the bound, with this room.
    fn steps(origin: [f64; 3], direction: [f64; 3], room: f64) -> Vec<SlabStep> {
        let (set, bound) = four_and_one();
        let ray = RaySlabs::new(&Ray::new(origin.into(), direction.into()), &set, room);
        bound.steps(&ray, &set).collect()
    }

    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], expected: Option<[f64; 2]>) {
        let steps = steps(origin, direction, 0.0);
        let found = steps.last().unwrap().inside();
        let rounded = |ends: [f64; 2]| ends.map(|t| (t * 1e6).round() / 1e6);
        assert_eq!(found.and_then(|found| found.ends()).map(rounded), expected);
        assert!(expected.is_none() || steps.len() == 5);
    }

    #[test]
    fn a_ray_along_x_is_inside_from_the_near_plane_of_x_to_its_far_plane() {
        check([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], Some([2.0, 4.0]));
    }

    #[test]
    fn a_corner_of_the_box_is_cut_off_by_the_diagonal_slab() {
        // x + y ≤ √2 at the ray y = 0.9 along x: x from −1 … √2 − 0.9 = 0.514214
        let expected = Some([2.485_786, 3.514_214]);
        check([-3.0, 0.9, 0.0], [1.0, 0.0, 0.0], expected);
        // through (0.95, 0.95), which lies in the box alone
        check([-0.05, 1.95, 0.0], [1.0, -1.0, 0.0], None);
    }

    #[test]
    fn a_parallel_ray_outside_is_refused_at_that_slab_in_either_direction() {
        for delta in [1.0, -1.0] {
            check([0.0, 1.5, 0.0], [delta, 0.0, 0.0], None);
            check([0.0, 0.0, 1.5], [delta, -0.0, 0.0], None);
        }
    }

    #[test]
    fn the_steps_of_a_missed_bound_end_where_near_and_far_cross() {
        let steps = steps([-0.05, 1.95, 0.0], [1.0, -1.0, 0.0], 0.0);
        let verdicts: Vec<_> = steps.iter().map(|step| step.verdict).collect();
        use SlabVerdict::{GoesOn, ParallelOutside};
        assert_eq!(verdicts, [GoesOn, GoesOn, ParallelOutside]);
        // x: −1 − (−0.05) = −0.95 … 1.05; y: 1.95 − 1 = 0.95 … 2.95
        assert!((steps[1].max_near - 0.95).abs() <= 1e-15);
        assert!((steps[1].min_far - 1.05).abs() <= 1e-15);
    }

    #[test]
    fn a_step_is_decided_with_its_room_and_says_what_it_would_be_without() {
        // 0.1 above the sphere: past the slab of y, which with room of a quarter it is in
        let steps = steps([-3.0, 1.1, 0.0], [1.0, 0.0, 0.0], 0.25);
        let [x, y] = [steps[0], steps[1]];
        assert_eq!((x.max_near, x.min_far), (1.75, 4.25));
        assert_eq!(y.verdict, SlabVerdict::ParallelInside);
        let ray = Ray::new(DVec3::new(-3.0, 1.1, 0.0), DVec3::X);
        let lines = [DVec3::X, DVec3::Y].map(|normal| SlabRay::new(&ray, normal));
        let bare_x = x.without_room(&lines[0], None);
        assert_eq!((bare_x.max_near, bare_x.min_far), (2.0, 4.0));
        let bare_y = y.without_room(&lines[1], Some(&bare_x));
        assert_eq!(bare_y.verdict, SlabVerdict::ParallelOutside);
        assert_eq!(bare_y.inside(), None);
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

    #[test]
    fn a_bound_is_missed_at_the_slab_where_near_passes_far() {
        // x: −1 … 1 at t = −6 … −4; y: at 4 … 6
        let steps = steps([5.0, -5.0, 0.0], [1.0, 1.0, 0.0], 0.0);
        let verdicts: Vec<_> = steps.iter().map(|step| step.verdict).collect();
        assert_eq!(verdicts, [SlabVerdict::GoesOn, SlabVerdict::Null]);
        assert_eq!((steps[1].max_near, steps[1].min_far), (4.0, -4.0));
        assert_eq!(steps[1].inside(), None);
    }
}
