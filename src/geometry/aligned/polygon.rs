//! The polygon with the ray along z: every projection is along the ray itself, and p′ is (0, 0).

use glam::{DVec2, DVec3};

use crate::geometry::{
    AlignedRay, Axis, DecidedBy, EdgeTest, Plane, PlaneTest, Polygon, PolygonTest, Sides, TRange,
};

/// A vertex of the transformed outline, without its z.
#[derive(Clone, Copy)]
struct Corner {
    at: DVec2,
    /// How far it may lie from where the exact transformation puts it.
    tolerance: f64,
}

/// Of a vertex' distance from the origin, the sum of its coordinates: p − o, three products and two sums
/// round, the rows are at right angles within some roundings, and so is the second point by which the exact
/// predicates are told the ray.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Polygon {
    /// Where does the z axis meet the transformed plane?
    ///
    /// A′·x + B′·y + C′·z + D′ = 0 at x = y = 0: z = −D′/C′.
    ///
    /// D′ = A·x₀ + B·y₀ + C·z₀ + D and C′·|Δ| = A·Δx + B·Δy + C·Δz are the numerator and the denominator of
    /// (v), the same numbers in both frames; they and t are those of [`Polygon::plane_test`], bit for bit.
    #[inline]
    pub fn plane_test_aligned(&self, ray: &AlignedRay, range: TRange, sides: Sides) -> PlaneTest {
        let test = self.plane_test(&ray.world, range, sides);
        let plane = Plane {
            normal: ray.frame.vector(test.plane.normal),
            d: test.numerator,
        };
        PlaneTest { plane, ..test }
    }

    /// Is the point at t of the ray, which lies on the plane, inside the polygon?
    ///
    /// The outline is what the ray sees of the polygon: its vertices without their z. p′ = (0, 0) is inside if
    /// an odd number of edges crosses the half-line from it along x. As in [`Polygon::contains`], the ray
    /// decides where p′ is too near to an edge, by the same exact predicates on the same numbers, so that
    /// both find the same polygons inside.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{AlignedRay, Polygon, Ray};
    ///
    /// let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [0.0, 4.0, 5.0]].map(DVec3::from_array);
    /// let triangle = Polygon::new(corners.to_vec(), None).unwrap();
    /// let ray = AlignedRay::new(&Ray::new(DVec3::new(1.0, 1.0, 0.0), DVec3::Z));
    /// let test = triangle.contains_aligned(&ray, 5.0);
    /// assert_eq!((test.point, test.crossings), (DVec3::new(0.0, 0.0, 5.0), 1));
    /// assert!(test.inside);
    /// ```
    #[inline]
    pub fn contains_aligned(&self, ray: &AlignedRay, t: f64) -> PolygonTest {
        let mut crossings = 0;
        let mut decided_by = DecidedBy::Point;
        let count = self.vertices().len();
        let first = self.corner(0, ray);
        let mut from = first;
        for index in 0..count {
            let to = if index + 1 == count {
                first
            } else {
                self.corner(index + 1, ray)
            };
            let Some(edge) = edge_past_origin(index, from, to) else {
                decided_by = DecidedBy::Ray;
                crossings = self.aligned_crossings_by_ray(ray);
                break;
            };
            crossings += u32::from(edge.counts);
            from = to;
        }
        PolygonTest {
            dropped: Axis::Z,
            coefficient: ray.frame.z.dot(self.plane().normal),
            point: DVec3::new(0.0, 0.0, t * ray.length),
            projected: DVec2::ZERO,
            crossings,
            inside: crossings % 2 == 1,
            decided_by,
        }
    }

    /// The working of `test`, edge by edge: what each added to its crossings.
    pub fn edges_aligned<'a>(
        &'a self,
        ray: &'a AlignedRay,
        test: PolygonTest,
    ) -> impl Iterator<Item = EdgeTest> + 'a {
        self.edges_by_ray(ray).map(move |by_ray| {
            let index = by_ray.index as usize;
            let next = (index + 1) % self.vertices().len();
            let [from, to] = [index, next].map(|vertex| self.corner(vertex, ray));
            let by_point = || edge_past_origin(index, from, to);
            let decided = Some(by_ray).filter(|_| test.decided_by == DecidedBy::Ray);
            EdgeTest {
                from: from.at,
                to: to.at,
                ..decided.or_else(by_point).unwrap_or(by_ray)
            }
        })
    }

    /// A vertex as the ray sees it.
    #[inline]
    fn corner(&self, vertex: usize, ray: &AlignedRay) -> Corner {
        let from_origin = self.vertex(vertex) - ray.frame.origin;
        Corner {
            at: ray.frame.vector(from_origin).truncate(),
            tolerance: ROUNDING * from_origin.abs().element_sum(),
        }
    }

    #[cold]
    fn aligned_crossings_by_ray(&self, ray: &AlignedRay) -> u32 {
        self.edges_by_ray(ray)
            .map(|edge| u32::from(edge.counts))
            .sum()
    }

    /// What the ray decides about each edge, in world coordinates.
    fn edges_by_ray<'a>(&'a self, ray: &AlignedRay) -> impl Iterator<Item = EdgeTest> + 'a {
        let by_ray = PolygonTest {
            decided_by: DecidedBy::Ray,
            ..PolygonTest::default()
        };
        self.edges(&ray.world, by_ray)
    }
}

/// Does the edge cross the half-line from (0, 0) along x? `None` if (0, 0) is within the rounding of the edge.
#[inline]
fn edge_past_origin(index: usize, from: Corner, to: Corner) -> Option<EdgeTest> {
    let tolerance = from.tolerance.max(to.tolerance);
    let (from, to) = (from.at, to.at);
    let straddles = (0.0 < from.y) != (0.0 < to.y);
    // twice the area of (from, to, 0); over the rise of the edge it is how far to the right it passes
    let side = from.x * to.y - from.y * to.x;

    let (low, high) = (from.min(to) - tolerance, from.max(to) + tolerance);
    let near = low.x <= 0.0 && 0.0 <= high.x && low.y <= 0.0 && 0.0 <= high.y;
    if near {
        let along = (to - from).abs().element_sum();
        let rounding = 4.0 * f64::EPSILON * ((from.x * to.y).abs() + (from.y * to.x).abs());
        if side.abs() <= tolerance * along + rounding {
            return None;
        }
    }
    Some(EdgeTest {
        index: index as u32,
        from,
        to,
        straddles,
        side,
        counts: straddles && ((0.0 < side) == (from.y < to.y)),
        decided_by: DecidedBy::Point,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;

    /// A square of 6 with a notch from x = 2 to 4, open at the top, down to y = 2.
    fn u_shape() -> Polygon {
        let outline = [
            (0.0, 0.0),
            (6.0, 0.0),
            (6.0, 6.0),
            (4.0, 6.0),
            (4.0, 2.0),
            (2.0, 2.0),
            (2.0, 6.0),
            (0.0, 6.0),
        ];
        let vertices = outline.map(|(x, y)| DVec3::new(x, y, 5.0)).to_vec();
        Polygon::new(vertices, None).unwrap()
    }

    #[test]
    fn what_lies_inside_is_the_same_in_both_frames_also_on_edges_and_vertices() {
        let polygon = u_shape();
        for direction in [
            DVec3::Z,
            DVec3::new(0.6, 0.0, 0.8),
            DVec3::new(0.48, 0.6, 0.64),
        ] {
            for (x, y) in (-1..=7).flat_map(|x| (-1..=7).map(move |y| (x, y))) {
                let p = DVec3::new(f64::from(x), f64::from(y), 5.0);
                let ray = AlignedRay::new(&Ray::new(p - 5.0 * direction, direction));
                let plane = polygon.plane_test_aligned(&ray, TRange::FORWARD, Sides::Both);
                let t = plane.chosen().unwrap();
                let aligned = polygon.contains_aligned(&ray, t);
                let world = polygon.contains(&ray.world, t);
                assert_eq!(aligned.inside, world.inside, "{direction} at ({x}, {y})");
                let counted = polygon.edges_aligned(&ray, aligned);
                let counted = counted.filter(|edge| edge.counts).count();
                assert_eq!(counted, aligned.crossings as usize, "({x}, {y})");
            }
        }
    }

    #[test]
    fn the_edges_that_count_lie_to_the_right() {
        let polygon = u_shape();
        for (x, y, crossings) in [
            (1.0, 4.0, 3),
            (3.0, 4.0, 2),
            (5.0, 4.0, 1),
            (7.0, 4.0, 0),
            (-1.0, 4.0, 4),
        ] {
            // along z the frame's x and y are those of the world; half the t of a ray twice as long
            let ray = AlignedRay::new(&Ray::new(DVec3::new(x, y, 0.0), 2.0 * DVec3::Z));
            let test = polygon.contains_aligned(&ray, 2.5);
            assert_eq!(test.crossings, crossings, "({x}, {y})");
            assert_eq!(test.decided_by, DecidedBy::Point);
            assert_eq!(test.point, DVec3::new(0.0, 0.0, 5.0));
        }
    }

    #[test]
    fn within_the_blur_of_an_edge_the_ray_decides() {
        let is_near = |from: [f64; 2], to: [f64; 2], tolerance: f64| {
            let corner = |at: [f64; 2]| Corner {
                at: at.into(),
                tolerance,
            };
            edge_past_origin(0, corner(from), corner(to)).is_none()
        };
        // six long, ¼ around it: level, and upright
        for (from, to, near) in [
            ([-3.0, 0.25], [3.0, 0.25], true),
            ([-3.0, -0.25], [3.0, -0.25], true),
            ([-3.0, 0.26], [3.0, 0.26], false),
            ([0.25, 0.0], [6.25, 0.0], true),
            ([-6.25, 0.0], [-0.25, 0.0], true),
            ([0.26, 0.1], [6.26, 0.1], false),
            ([-6.26, 0.1], [-0.26, 0.1], false),
            ([0.0, 0.25], [0.0, 6.25], true),
            ([0.0, -6.25], [0.0, -0.25], true),
            ([0.1, 0.26], [0.1, 6.26], false),
            ([0.1, -6.26], [0.1, -0.26], false),
        ] {
            assert_eq!(is_near(from, to, 0.25), near, "{from:?} {to:?}");
        }
        // without tolerance: an end in the origin, and then 4ε(|x₁y₂| + |y₁x₂|) = 4ε·6·10⁵ = 5.3·10⁻¹⁰ against
        // (−300 + d)·200 + 100·600, which is 200d
        assert!(is_near([0.0, 0.0], [6.0, 1.0], 0.0));
        let slanted = |d: f64| is_near([-300.0 + d, -100.0], [600.0, 200.0], 0.0);
        assert!(slanted(0.0) && slanted(4e-13));
        assert!(!slanted(1e-12));
        assert!(!is_near([-300.0, -200.0], [600.0, 200.0], 0.0));
    }

    #[test]
    fn the_blur_of_a_corner_is_16_eps_of_the_sum_of_its_coordinates() {
        // (6, 6, 5) from (1, 2, 0): 16·(5 + 4 + 5)
        let ray = AlignedRay::new(&Ray::new(DVec3::new(1.0, 2.0, 0.0), DVec3::Z));
        let corner = u_shape().corner(2, &ray);
        assert_eq!(corner.at, DVec2::new(5.0, 4.0));
        assert_eq!(corner.tolerance, 224.0 * f64::EPSILON);
        // (0, 0, 5): 16·(1 + 2 + 5)
        assert_eq!(u_shape().corner(0, &ray).tolerance, 128.0 * f64::EPSILON);
    }

    #[test]
    fn an_edge_is_as_uncertain_as_its_worse_end_and_alike_from_both() {
        let is_near = |(from, from_blur): ([f64; 2], f64), (to, to_blur): ([f64; 2], f64)| {
            let corner = |at: [f64; 2], tolerance| Corner {
                at: at.into(),
                tolerance,
            };
            edge_past_origin(0, corner(from, from_blur), corner(to, to_blur)).is_none()
        };
        // ¼ above the origin, between ends that are uncertain by nothing and by a little more or less than that
        for (tolerance, near) in [(0.26, true), (0.24, false)] {
            let (clear, uncertain) = (([-3.0, 0.25], 0.0), ([3.0, 0.25], tolerance));
            assert_eq!(is_near(clear, uncertain), near, "{tolerance}");
            assert_eq!(is_near(uncertain, clear), near, "{tolerance}");
        }
        // within its extent but far from its line, on either side of it
        for y in [-200.0, 200.0] {
            let (one, other) = (([-300.0, y], 0.0), ([600.0, -y], 0.0));
            assert!(!is_near(one, other) && !is_near(other, one), "{y}");
        }
    }
}
