//! The axis-aligned box: three slabs, and what is inside all of them.

use glam::DVec3;

use crate::geometry::root::{hidden_side, judged, two_roots};
use crate::geometry::{Inside, Ray, Roots, Sides, SlabInterval, SlabRay, TRange, larger, smaller};

/// min ≤ (x, y, z) ≤ max, in each coordinate: an object of a scene, what is around one, a cell of a grid.
#[doc(alias = "AABB")]
#[doc(alias = "bounding box")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisBox {
    /// The smallest coordinates, in world coordinates.
    pub min: DVec3,
    /// The largest coordinates, none below that of `min`; an object's are above.
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
    /// Around nothing: together with another box it is that box.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// The smallest box around points; [`AxisBox::EMPTY`] around none.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        let at = |point| Self {
            min: point,
            max: point,
        };
        let join = |sum: Self, point| sum.union(&at(point));
        points.into_iter().fold(Self::EMPTY, join)
    }

    /// The smallest box around both.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::AxisBox;
    ///
    /// let a = AxisBox { min: DVec3::ZERO, max: DVec3::ONE };
    /// let b = AxisBox { min: DVec3::new(2.0, -1.0, 0.5), max: DVec3::new(3.0, 0.0, 0.5) };
    /// let both = AxisBox { min: DVec3::new(0.0, -1.0, 0.0), max: DVec3::new(3.0, 1.0, 1.0) };
    /// assert_eq!(a.union(&b), both);
    /// ```
    #[inline]
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        // not by the least of vectors, which looks out for NaN
        Self {
            min: DVec3::new(
                smaller(a.min.x, b.min.x),
                smaller(a.min.y, b.min.y),
                smaller(a.min.z, b.min.z),
            ),
            max: DVec3::new(
                larger(a.max.x, b.max.x),
                larger(a.max.y, b.max.y),
                larger(a.max.z, b.max.z),
            ),
        }
    }

    /// Larger on every side by a length.
    #[must_use]
    pub fn with_room(&self, room: f64) -> Self {
        Self {
            min: self.min - room,
            max: self.max + room,
        }
    }

    /// How long it is along x, y and z.
    #[inline]
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    /// From the smallest to the largest coordinate along x (0), y (1) or z (2).
    #[inline]
    pub fn along(&self, axis: usize) -> [f64; 2] {
        [self.min[axis], self.max[axis]]
    }

    /// Half its surface: the share of random rays that hit it grows with that. 0 around nothing.
    #[inline]
    pub fn half_area(&self) -> f64 {
        let side = self.size();
        if side.x < 0.0 {
            return 0.0;
        }
        side.x * side.y + side.y * side.z + side.z * side.x
    }

    /// Twice its center: enough to compare places.
    #[inline]
    pub(crate) fn doubled_center(&self) -> DVec3 {
        self.min + self.max
    }

    /// Where is the ray inside the box: from the largest near to the smallest far? `None` if it passes by, or has no
    /// direction.
    ///
    /// Both t can be negative. [`AxisBox::test`] says the same of an object, with its working.
    pub fn inside(&self, ray: &Ray) -> Option<[f64; 2]> {
        let slab = |axis: usize| {
            SlabInterval::across_axis(ray.origin[axis], ray.direction[axis], self.along(axis))
        };
        let inside = [0, 1, 2]
            .map(slab)
            .into_iter()
            .fold(Inside::EVERYWHERE, Inside::and);
        inside
            .ends()
            .filter(|ends| ends.iter().all(|t| t.is_finite()))
    }

    /// Where does the ray hit the box?
    ///
    /// near = max(nearₓ, near_y, near_z), far = min(farₓ, far_y, far_z); the ray hits the box if
    /// near ≤ far. Slides: "the intersection of the ray's intersections with each of the slabs".
    ///
    /// A ray parallel to a slab is inside it for all t or for none; in a face counts as inside.
    /// near = far (along an edge, through a corner) is one root, a graze. A direction of zero gives
    /// no root.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{AxisBox, Ray, Sides, TRange};
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
        let Inside { near, far } = slabs.into_iter().fold(Inside::EVERYWHERE, Inside::and);
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
    use crate::geometry::{Root, RootVerdict};

    const CUBE: AxisBox = AxisBox {
        min: DVec3::new(1.0, 0.0, 0.0),
        max: DVec3::new(3.0, 1.0, 1.0),
    };

    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], roots: &[(f64, RootVerdict)]) {
        let ray = Ray::new(origin.into(), direction.into());
        let test = CUBE.test(&ray, TRange::FORWARD, Sides::Both);
        let found: Vec<_> = test
            .roots
            .iter()
            .map(|Root { t, verdict }| (t, verdict))
            .collect();
        assert_eq!(found, roots, "{test:?}");
    }

    #[test]
    fn a_ray_along_x_meets_the_faces_across_x() {
        let roots = [
            (1.0, RootVerdict::Chosen),
            (3.0, RootVerdict::BeyondNearest),
        ];
        check([0.0, 0.5, 0.5], [1.0, 0.0, 0.0], &roots);
        check([0.0, 0.5, 0.5], [1.0, -0.0, -0.0], &roots);
    }

    #[test]
    fn a_ray_from_inside_hits_where_it_leaves() {
        let roots = [(-1.0, RootVerdict::Behind), (1.0, RootVerdict::Chosen)];
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
        check(
            [0.0, 3.0, 4.0],
            [1.0, -1.0, -1.0],
            &[(3.0, RootVerdict::Chosen)],
        );
    }

    #[test]
    fn a_box_around_points_holds_them_and_one_around_nothing_adds_nothing() {
        let points = [[3.0, 0.0, 0.5], [1.0, 1.0, 0.0], [2.0, 0.5, 1.0]].map(DVec3::from);
        let around = AxisBox::around(points);
        assert_eq!(around, CUBE);
        assert_eq!(AxisBox::around([]), AxisBox::EMPTY);
        assert_eq!(AxisBox::EMPTY.union(&CUBE), CUBE);
        assert_eq!(CUBE.union(&AxisBox::EMPTY), CUBE);
    }

    #[test]
    fn the_surface_of_two_by_one_by_one_is_ten() {
        assert_eq!(CUBE.half_area(), 5.0);
        assert_eq!(AxisBox::EMPTY.half_area(), 0.0);
        // a quarter more on every side: 2.5 by 1.5 by 1.5
        let wider = CUBE.with_room(0.25);
        assert_eq!(wider.half_area(), 2.5 * 1.5 + 1.5 * 1.5 + 1.5 * 2.5);
        assert_eq!(wider.along(0), [0.75, 3.25]);
        assert_eq!(wider.doubled_center(), CUBE.doubled_center());
    }

    #[test]
    fn a_ray_is_inside_from_the_largest_near_to_the_smallest_far() {
        let inside = |origin: [f64; 3], direction: [f64; 3]| {
            CUBE.inside(&Ray {
                origin: origin.into(),
                direction: direction.into(),
            })
        };
        // x from t = 1 to 3, y from 0.5 to 1.5
        assert_eq!(inside([0.0, -0.5, 0.5], [1.0, 1.0, 0.0]), Some([1.0, 1.5]));
        // from inside one t is behind
        assert_eq!(inside([2.0, 0.5, 0.5], [0.0, -0.5, 0.0]), Some([-1.0, 1.0]));
        // along an edge, and past it
        assert_eq!(inside([0.0, 1.0, 1.0], [1.0, 0.0, 0.0]), Some([1.0, 3.0]));
        assert_eq!(inside([0.0, 1.5, 1.0], [1.0, 0.0, 0.0]), None);
        // y leaves before x enters
        assert_eq!(inside([0.0, 0.5, 0.5], [0.25, 1.0, 0.0]), None);
        // inside all three, for ever
        assert_eq!(inside([2.0, 0.5, 0.5], [0.0; 3]), None);
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

    #[test]
    fn half_the_surface_of_a_box_with_sides_2_3_5_is_31() {
        // 2·3 + 3·5 + 5·2, wherever it lies
        for corner in [DVec3::ZERO, DVec3::new(1.0, -7.0, 4.0)] {
            let solid = AxisBox {
                min: corner,
                max: corner + DVec3::new(2.0, 3.0, 5.0),
            };
            assert_eq!(solid.half_area(), 31.0);
            assert_eq!(
                solid.doubled_center(),
                2.0 * corner + DVec3::new(2.0, 3.0, 5.0)
            );
        }
    }

    #[test]
    fn a_flat_box_has_the_area_of_its_two_faces() {
        let flat = AxisBox {
            min: DVec3::new(1.0, 1.0, 1.0),
            max: DVec3::new(1.0, 3.0, 4.0),
        };
        assert_eq!(flat.half_area(), 6.0);
    }

    #[test]
    fn the_box_of_two_boxes_has_the_smaller_and_the_larger_corner_of_both() {
        let a = AxisBox {
            min: DVec3::new(1.0, 5.0, 3.0),
            max: DVec3::new(4.0, 6.0, 9.0),
        };
        let b = AxisBox {
            min: DVec3::new(2.0, 2.0, 2.0),
            max: DVec3::new(3.0, 8.0, 7.0),
        };
        let both = AxisBox {
            min: DVec3::new(1.0, 2.0, 2.0),
            max: DVec3::new(4.0, 8.0, 9.0),
        };
        assert_eq!(a.union(&b), both);
        assert_eq!(b.union(&a), both);
        let corners = [a.min, b.max, DVec3::new(4.0, 2.0, 9.0)];
        let around = AxisBox {
            min: DVec3::new(1.0, 2.0, 3.0),
            max: DVec3::new(4.0, 8.0, 9.0),
        };
        assert_eq!(AxisBox::around(corners), around);
    }
}
