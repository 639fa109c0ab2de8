//! The axis-aligned box: three slabs, and what is inside all of them.

use glam::DVec3;

use crate::geometry::root::{hidden_side, judged, two_roots};
use crate::geometry::{Ray, Roots, Sides, SlabInterval, SlabRay, TRange};

/// min ≤ (x, y, z) ≤ max, in each coordinate.
#[doc(alias = "AABB")]
#[doc(alias = "bounding box")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisBox {
    /// The smallest coordinates, in world coordinates.
    pub min: DVec3,
    /// The largest coordinates, each above that of `min`.
    pub max: DVec3,
}

/// What the three slabs of a box gave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoxTest {
    /// Which t are inside the slabs across x, y and z.
    pub slabs: [SlabInterval; 3],
    /// Where the ray enters (the largest near) and leaves (the smallest far), and what became of both.
    pub roots: Roots,
}

impl AxisBox {
    /// Where does the ray meet the box?
    ///
    /// near = max(nearₓ, near_y, near_z), far = min(farₓ, far_y, far_z); the ray meets the box if
    /// near ≤ far. Slides: "the intersection of the ray's intersections with each of the slabs".
    ///
    /// A ray parallel to a slab is inside it for all t or for none; in a face counts as inside.
    /// near = far (along an edge, through a corner) is one root, a graze. A direction of zero gives
    /// no root.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::{AxisBox, Ray, Sides, TRange};
    ///
    /// let cube = AxisBox { min: DVec3::ZERO, max: DVec3::ONE };
    /// let ray = Ray::new(DVec3::new(-1.0, 0.5, -0.5), DVec3::new(1.0, 0.0, 1.0));
    /// let test = cube.test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!(test.roots.chosen(), Some(1.0)); // nearₓ = 1, near_z = 0.5, y parallel inside
    /// ```
    #[inline]
    pub fn test(&self, ray: &Ray, range: TRange, sides: Sides) -> BoxTest {
        // each slab is −max ≤ D ≤ −min along its axis
        let slab = |axis: DVec3, low: f64, high: f64| SlabRay::new(ray, axis).interval(-high, -low);
        let slabs = [
            slab(DVec3::X, self.min.x, self.max.x),
            slab(DVec3::Y, self.min.y, self.max.y),
            slab(DVec3::Z, self.min.z, self.max.z),
        ];
        BoxTest::of(slabs, range, sides)
    }

    /// The unit normal of the face that a point of the surface lies on, outwards.
    ///
    /// On an edge or a corner: of the first such face in the order x, y, z.
    pub fn normal(&self, point: DVec3) -> DVec3 {
        let half = 0.5 * (self.max - self.min);
        let from_center = (point - 0.5 * (self.min + self.max)) / half;
        let [x, y, z] = from_center.abs().to_array();
        let axis = if y <= x && z <= x {
            DVec3::X
        } else if z <= y {
            DVec3::Y
        } else {
            DVec3::Z
        };
        axis * from_center.dot(axis).signum()
    }
}

impl BoxTest {
    /// What three slabs have in common: from the largest near to the smallest far.
    #[inline]
    pub(super) fn of(slabs: [SlabInterval; 3], range: TRange, sides: Sides) -> Self {
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        for interval in slabs {
            match interval {
                SlabInterval::Between { near: n, far: f } => {
                    near = near.max(n);
                    far = far.min(f);
                }
                SlabInterval::ParallelInside => {}
                SlabInterval::ParallelOutside => far = f64::NEG_INFINITY,
            }
        }
        let judge = |t, entering| judged(t, range, |_| hidden_side(entering, sides));
        let roots = if !(near.is_finite() && far.is_finite()) || far < near {
            Roots::None
        } else if near == far {
            Roots::Graze(judge(near, true))
        } else {
            two_roots(judge(near, true), judge(far, false))
        };
        Self { slabs, roots }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Fate, Root};

    const CUBE: AxisBox = AxisBox {
        min: DVec3::new(1.0, 0.0, 0.0),
        max: DVec3::new(3.0, 1.0, 1.0),
    };

    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], roots: &[(f64, Fate)]) {
        let ray = Ray::new(origin.into(), direction.into());
        let test = CUBE.test(&ray, TRange::FORWARD, Sides::Both);
        let found: Vec<_> = test
            .roots
            .iter()
            .map(|Root { t, fate }| (t, fate))
            .collect();
        assert_eq!(found, roots, "{test:?}");
    }

    #[test]
    fn a_ray_along_x_meets_the_faces_across_x() {
        let roots = [(1.0, Fate::Chosen), (3.0, Fate::BeyondNearest)];
        check([0.0, 0.5, 0.5], [1.0, 0.0, 0.0], &roots);
        check([0.0, 0.5, 0.5], [1.0, -0.0, -0.0], &roots);
    }

    #[test]
    fn a_ray_from_inside_hits_where_it_leaves() {
        let roots = [(-1.0, Fate::Behind), (1.0, Fate::Chosen)];
        check([2.0, 0.5, 0.5], [1.0, 0.0, 0.0], &roots);
    }

    #[test]
    fn a_parallel_ray_outside_one_slab_misses() {
        check([0.0, 2.0, 0.5], [1.0, 0.0, 0.0], &[]);
    }

    #[test]
    fn a_ray_whose_intervals_do_not_overlap_misses() {
        // x: [1, 3], y: y = 3 − t in [0, 1] for t in [2, 3], z: z = 4 − t in [0, 1] for t in [3, 4];
        // moved back by 1/2 in z nothing is left
        check([0.0, 3.0, 4.5], [1.0, -1.0, -1.0], &[]);
    }

    #[test]
    fn a_ray_through_a_corner_grazes() {
        check([0.0, 3.0, 4.0], [1.0, -1.0, -1.0], &[(3.0, Fate::Chosen)]);
    }

    #[test]
    fn the_normal_is_that_of_the_face() {
        assert_eq!(CUBE.normal(DVec3::new(1.0, 0.5, 0.5)), -DVec3::X);
        assert_eq!(CUBE.normal(DVec3::new(2.0, 1.0, 0.5)), DVec3::Y);
        assert_eq!(CUBE.normal(DVec3::new(2.9, 0.5, 0.0)), -DVec3::Z);
        assert_eq!(CUBE.normal(CUBE.max), DVec3::X);
    }

    #[test]
    fn on_an_edge_the_normal_is_that_of_the_first_face() {
        assert_eq!(CUBE.normal(DVec3::new(2.0, 1.0, 1.0)), DVec3::Y);
        assert_eq!(CUBE.normal(DVec3::new(2.0, 0.0, 1.0)), -DVec3::Y);
        assert_eq!(CUBE.normal(DVec3::new(1.0, 0.5, 1.0)), -DVec3::X);
    }
}
