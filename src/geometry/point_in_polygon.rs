//! Does the point p where the ray hits the plane lie inside the polygon? (Fig. 15.57)
//!
//! The polygon and p are projected along the dropped axis. From p′ a half-line runs in the direction
//! of the first remaining coordinate, u; p′ is inside if an odd number of edges crosses it
//! (E. Haines 1994).
//!
//! **Near an edge** p′ alone would not do. It is rounded, each polygon rounds it in its own way, and two
//! neighbours could both refuse a ray that passes their common edge: the surface would leak. So p′
//! decides where it is clear of every edge by a stated bound on its error. Nearer than that, the *ray*
//! decides: on which side of it the edge passes is the sign of a volume, computed exactly
//! (J. Shewchuk 1997, the crate `robust`) from the ray and the edge's end points in an order of their
//! own. Neighbours ask the same question about the same edge and get the same answer. One uncertain
//! edge hands all edges of the polygon to the ray, because a count of crossings means something only if
//! all of them are counted along one half-line.
//!
//! The rule for a ray exactly through an edge or a vertex: the ray counts as shifted by less than any
//! number, first along the axis on which its direction is shortest and then, by less still, so that a
//! vertex in the counting half-plane comes to lie above it. All polygons shift the same ray the same
//! way, so exactly one of those around an edge or a vertex of a smooth surface takes it.

use glam::{DVec2, DVec3};
use robust::{Coord, Coord3D, orient2d, orient3d};

use crate::geometry::corners::Corners;
use crate::geometry::plane::FLAT;
use crate::geometry::polygon::OUTLINE_ROUNDING;
use crate::geometry::{Axis, Polygon, Ray};

/// What decided about the edges of a polygon?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecidedBy {
    /// The projected point p′: it is clear of every edge.
    #[default]
    Point,
    /// The ray itself: p′ is too near to an edge.
    Ray,
}

/// What one edge of the outline adds to the count of crossings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EdgeTest {
    /// The edge runs from vertex `index` to the next one.
    pub index: u32,
    /// The first end point, projected.
    pub from: DVec2,
    /// The second end point, projected.
    pub to: DVec2,
    /// Do the end points lie on different sides of the line through p′ along u? (Decided by the ray:
    /// of the plane through the ray along its shortest axis.)
    pub straddles: bool,
    /// Where the edge passes the ray or p′. Decided by the point: twice the area of the triangle
    /// from, to, p′; by the ray: six times the volume of the ray and the edge. Only the sign matters.
    pub side: f64,
    /// Does the edge count as a crossing?
    pub counts: bool,
    /// Whether the 2D test of p′ or the exact test of the ray decided.
    pub decided_by: DecidedBy,
}

/// What the containment test gave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PolygonTest {
    /// The coordinate that was dropped.
    pub dropped: Axis,
    /// Its coefficient in (iv), the largest in absolute value.
    pub coefficient: f64,
    /// p: where the ray hits the plane.
    pub point: DVec3,
    /// p′: p without the dropped coordinate.
    pub projected: DVec2,
    /// How many edges count.
    pub crossings: u32,
    /// An odd number of crossings.
    pub inside: bool,
    /// Whether the 2D test of p′ or the exact test of the ray decided.
    pub decided_by: DecidedBy,
}

impl Polygon {
    /// Is the point at t of the ray, which lies on the plane, inside the polygon?
    ///
    /// Source: slides, "Computing Intersection (Polygon)", Fig. 15.57. Any finite ray and t.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Axis, Polygon, Ray};
    ///
    /// let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [0.0, 4.0, 5.0]].map(DVec3::from_array);
    /// let triangle = Polygon::new(corners.to_vec(), None).unwrap();
    /// let test = triangle.contains(&Ray::new(DVec3::new(1.0, 1.0, 0.0), DVec3::Z), 5.0);
    /// assert_eq!((test.dropped, test.inside), (Axis::Z, true));
    /// assert_eq!(test.crossings, 1); // only the slanted edge lies to the right of p′ = (1, 1)
    /// ```
    #[inline(always)]
    #[expect(
        clippy::inline_always,
        reason = "a search wants `inside` alone: in place, the rest of the working is not put together"
    )]
    pub fn contains(&self, ray: &Ray, t: f64) -> PolygonTest {
        let dropped = self.dropped();
        let point = ray.at(t);
        let projected = dropped.drop_from(point);
        let counted = if self.plane.is_flat(ray) {
            None
        } else {
            let clear = self.clear_tolerance(ray, t);
            // the same for three corners as for many, but three are counted without a loop
            match &self.corners {
                Corners::Triangle { outline, .. } => clear_crossings(outline, projected, clear),
                Corners::Many { outline, .. } => clear_crossings_of_many(outline, projected, clear),
            }
        };
        let (crossings, decided_by) = match counted {
            Some(crossings) => (crossings, DecidedBy::Point),
            None => self.crossings_near_an_edge(ray, t, projected),
        };
        PolygonTest {
            dropped,
            coefficient: dropped.of(self.plane.normal),
            point,
            projected,
            crossings,
            inside: crossings % 2 == 1,
            decided_by,
        }
    }

    /// The working of `test`, edge by edge: what each added to its crossings.
    pub fn edges<'a>(
        &'a self,
        ray: &Ray,
        test: PolygonTest,
    ) -> impl Iterator<Item = EdgeTest> + 'a {
        let line = RayLine::new(ray);
        (0..self.outline().len()).filter_map(move |index| match test.decided_by {
            // a tolerance of 0 leaves no edge uncertain but those through p′, and there are none
            DecidedBy::Point => self.edge_by_point(index, test.projected, 0.0),
            DecidedBy::Ray => Some(self.edge_by_ray(index, &line)),
        })
    }

    /// How far may p′ lie from where the exact ray would hit the polygon?
    ///
    /// Three errors add up, the first two relative to the numbers that enter (v), and all are
    /// stretched by how flatly the ray hits the plane, |Δ|/|A·Δx + B·Δy + C·Δz|: the rounding of t,
    /// the rounding of o + t·Δ, and the vertices' distance from the plane. 32ε covers the some twenty
    /// roundings of the first two. The third has the rounding of the largest vertex in it, and with that
    /// the sign of `side` for an edge that p′ is level with but not near.
    pub(super) fn tolerance(&self, ray: &Ray, t: f64) -> f64 {
        let spread = ray.direction.abs().element_sum();
        let flatness = spread / self.plane.normal.dot(ray.direction).abs();
        self.upright_tolerance(ray, t) * flatness
    }

    /// The same for a ray along the normal: the errors before they are stretched.
    #[inline]
    fn upright_tolerance(&self, ray: &Ray, t: f64) -> f64 {
        let spread = ray.direction.abs().element_sum();
        let reach = ray.origin.abs().element_sum() + t.abs() * spread + self.plane.d.abs();
        OUTLINE_ROUNDING * reach + self.off_plane
    }

    /// Further than this from the line of an edge, a ray that is not flat is clear of it: four times the tolerance of the
    /// flattest such ray, which is stretched by 64.
    #[inline]
    fn clear_tolerance(&self, ray: &Ray, t: f64) -> f64 {
        4.0 / FLAT * self.upright_tolerance(ray, t)
    }

    /// Does the edge cross the half-line from p′ along u? `None` if p′ is within `tolerance` of the edge.
    fn edge_by_point(&self, index: usize, p: DVec2, tolerance: f64) -> Option<EdgeTest> {
        let outline = self.outline();
        let (from, to) = (outline[index], outline[self.next(index)]);
        let along = to - from;
        let straddles = (p.y < from.y) != (p.y < to.y);
        // twice the area of (from, to, p′); over along.y it is how far to the right the edge passes
        let side = along.x * (p.y - from.y) - along.y * (p.x - from.x);

        let (low, high) = (from.min(to) - tolerance, from.max(to) + tolerance);
        let near = low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
        if near {
            let rounding = 16.0
                * f64::EPSILON
                * ((along.x * (p.y - from.y)).abs() + (along.y * (p.x - from.x)).abs());
            if side.abs() <= tolerance * (along.x.abs() + along.y.abs()) + rounding {
                return None;
            }
        }
        Some(EdgeTest {
            index: index as u32,
            from,
            to,
            straddles,
            side,
            counts: straddles && ((0.0 < side) == (0.0 < along.y)),
            decided_by: DecidedBy::Point,
        })
    }

    /// The crossings, and who decides about them, where p′ is near the line of an edge: perhaps not near
    /// the edge itself.
    #[cold]
    fn crossings_near_an_edge(&self, ray: &Ray, t: f64, p: DVec2) -> (u32, DecidedBy) {
        // a flat ray's t may have been moved by as much as its error is
        let moved = if self.plane.is_flat(ray) { 2.0 } else { 1.0 };
        let tolerance = moved * self.tolerance(ray, t);
        let mut crossings = 0;
        for index in 0..self.outline().len() {
            match self.edge_by_point(index, p, tolerance) {
                Some(edge) => crossings += u32::from(edge.counts),
                None => return (self.crossings_by_ray(ray), DecidedBy::Ray),
            }
        }
        (crossings, DecidedBy::Point)
    }

    fn crossings_by_ray(&self, ray: &Ray) -> u32 {
        let line = RayLine::new(ray);
        let counts = |index| u32::from(self.edge_by_ray(index, &line).counts);
        (0..self.outline().len()).map(counts).sum()
    }

    /// Does the edge cross the half-plane that the ray sweeps along its shortest axis?
    fn edge_by_ray(&self, index: usize, line: &RayLine) -> EdgeTest {
        let next = self.next(index);
        let (from, to) = (self.vertex(index), self.vertex(next));
        let (from_above, to_above) = (line.has_above(from), line.has_above(to));
        let straddles = from_above != to_above;
        // one canonical order: from the end below to the end above, whichever polygon asks
        let (below, above) = if from_above { (to, from) } else { (from, to) };
        let side = line.volume(below, above);
        EdgeTest {
            index: index as u32,
            from: self.outline()[index],
            to: self.outline()[next],
            straddles,
            side,
            counts: straddles && 0.0 <= side,
            decided_by: DecidedBy::Ray,
        }
    }

    fn next(&self, index: usize) -> usize {
        if index + 1 == self.outline().len() {
            0
        } else {
            index + 1
        }
    }
}

/// How many edges cross the half-line from p′ along u? `None` if p′ is not further than `clear` from the line of each:
/// four times its tolerance or more.
///
/// Clear of it, an edge counts as in the working (`edge_by_point`). That doubts an edge where p′ is within
/// its tolerance and the rounding of `side`; the latter is
/// 16ε(|Δu·(p_v − v)| + |Δv·(p_u − u)|) ≤ 16ε(|Δu| + |Δv|)(|p′| + |vertex|), and so no more than twice
/// (|Δu| + |Δv|)·tolerance, since the tolerance has 32ε|p′| and 8ε|vertex| in it.
#[inline]
pub(crate) fn clear_crossings(outline: &[DVec2], p: DVec2, clear: f64) -> Option<u32> {
    let mut crossings = 0;
    let mut is_clear = true;
    let mut from = *outline.last()?;
    for &to in outline {
        let along = to - from;
        let (from_above, to_above) = (p.y < from.y, p.y < to.y);
        let side = along.x * (p.y - from.y) - along.y * (p.x - from.x);
        is_clear &= clear * (along.x.abs() + along.y.abs()) < side.abs();
        // an edge that straddles rises if its second end is above
        crossings += u32::from(from_above != to_above && (0.0 < side) == to_above);
        from = to;
    }
    is_clear.then_some(crossings)
}

/// The same for any other number of corners: apart, so that the code for three is short enough to be inlined.
#[inline(never)]
fn clear_crossings_of_many(outline: &[DVec2], p: DVec2, clear: f64) -> Option<u32> {
    clear_crossings(outline, p, clear)
}

/// The line of a ray, given by two points so that the exact predicates can be asked about it.
struct RayLine {
    origin: DVec3,
    /// A second point, far enough out that its rounding turns the line by no more than ε.
    ahead: DVec3,
    /// The axis along which the ray sweeps the counting half-plane.
    swept: Axis,
}

impl RayLine {
    fn new(ray: &Ray) -> Self {
        let size = ray.direction.abs().max_element();
        let far = (ray.origin.abs().max_element() / size).max(1.0);
        let far = if far.is_finite() { far } else { 1.0 };
        Self {
            origin: ray.origin,
            ahead: ray.at(far),
            swept: Axis::of_smallest(ray.direction),
        }
    }

    /// Does the point lie on or above the plane through the ray along the swept axis?
    fn has_above(&self, point: DVec3) -> bool {
        let flat = |p: DVec3| {
            let DVec2 { x, y } = self.swept.drop_from(p);
            Coord { x, y }
        };
        0.0 <= orient2d(flat(self.origin), flat(self.ahead), flat(point))
    }

    /// Six times the signed volume of the ray's two points and the edge's; the sign is exact.
    fn volume(&self, below: DVec3, above: DVec3) -> f64 {
        let coord = |DVec3 { x, y, z }| Coord3D { x, y, z };
        orient3d(
            coord(self.origin),
            coord(self.ahead),
            coord(below),
            coord(above),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(outline: &[(f64, f64)]) -> Polygon {
        let vertices = outline.iter().map(|&(x, y)| DVec3::new(x, y, 5.0));
        Polygon::new(vertices.collect(), None).unwrap()
    }

    /// Straight down the z axis at (x, y).
    fn at(polygon: &Polygon, x: f64, y: f64) -> PolygonTest {
        polygon.contains(&Ray::new(DVec3::new(x, y, 0.0), DVec3::Z), 5.0)
    }

    /// A U: a square of 6 with a notch from x = 2 to 4, open at the top, down to y = 2.
    fn u_shape() -> Polygon {
        polygon(&[
            (0.0, 0.0),
            (6.0, 0.0),
            (6.0, 6.0),
            (4.0, 6.0),
            (4.0, 2.0),
            (2.0, 2.0),
            (2.0, 6.0),
            (0.0, 6.0),
        ])
    }

    #[test]
    fn a_concave_outline_counts_crossings_in_each_arm() {
        let u = u_shape();
        for (x, y, crossings) in [
            (1.0, 4.0, 3),
            (3.0, 4.0, 2),
            (5.0, 4.0, 1),
            (7.0, 4.0, 0),
            (3.0, 1.0, 1),
            (-1.0, 4.0, 4),
        ] {
            let test = at(&u, x, y);
            assert_eq!(
                (test.crossings, test.inside),
                (crossings, crossings % 2 == 1),
                "({x}, {y})"
            );
            assert_eq!(test.decided_by, DecidedBy::Point);
        }
    }

    #[test]
    fn the_edges_add_up_to_the_crossings_whoever_decides() {
        let u = u_shape();
        for (x, y) in [
            (1.0, 4.0),
            (3.0, 2.0),
            (2.0, 2.0),
            (6.0, 6.0),
            (2.0, 4.0),
            (0.5, 6.0),
        ] {
            let ray = Ray::new(DVec3::new(x, y, 0.0), DVec3::Z);
            let test = u.contains(&ray, 5.0);
            let edges: Vec<_> = u.edges(&ray, test).collect();
            assert_eq!(edges.len(), 8);
            assert_eq!(
                edges.iter().filter(|e| e.counts).count(),
                test.crossings as usize
            );
            assert!(edges.iter().all(|e| e.decided_by == test.decided_by));
        }
    }

    #[test]
    fn a_point_level_with_a_vertex_counts_it_once() {
        // the half-line from (1, 2) runs along the notch's floor and through both of its vertices
        let test = at(&u_shape(), 1.0, 2.0);
        assert!(test.inside);
        // and level with the tip of a diamond
        let diamond = polygon(&[(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)]);
        assert_eq!(at(&diamond, -0.5, 0.0).crossings, 1);
        assert_eq!(at(&diamond, -2.0, 0.0).crossings % 2, 0);
    }

    #[test]
    fn neighbours_share_their_common_edge_without_gap_or_overlap() {
        let (a, b, c, d) = ((0.0, 0.0), (4.0, 1.0), (3.0, 5.0), (-1.0, 3.0));
        let (left, right) = (polygon(&[a, c, d]), polygon(&[a, b, c]));
        for step in 1..1000 {
            let s = f64::from(step) / 1000.0;
            let (x, y) = (3.0 * s, 5.0 * s);
            let takers = [&left, &right].map(|p| at(p, x, y));
            assert_eq!(
                takers.iter().filter(|test| test.inside).count(),
                1,
                "at {s}"
            );
            assert!(
                takers.iter().all(|test| test.decided_by == DecidedBy::Ray),
                "at {s}"
            );
        }
    }

    #[test]
    fn triangles_around_a_vertex_take_a_ray_through_it_exactly_once() {
        let rim: Vec<_> = (0..7)
            .map(|k| f64::from(k) * std::f64::consts::TAU / 7.0)
            .map(|angle| (angle.cos(), angle.sin()))
            .collect();
        let fan: Vec<_> = (0..7)
            .map(|k| polygon(&[(0.0, 0.0), rim[k], rim[(k + 1) % 7]]))
            .collect();
        let takers = fan.iter().filter(|p| at(p, 0.0, 0.0).inside).count();
        assert_eq!(takers, 1);
    }

    #[test]
    fn the_blur_adds_the_roundings_of_t_of_the_point_and_of_the_plane() {
        // ε of 32(|o| + |t||Δ| + |D|) + 8·17, the last for the vertex (6, 6, 5): 32(3 + 5 + 5) + 136 = 552
        let (u, eps) = (u_shape(), f64::EPSILON);
        let upright = Ray::new(DVec3::new(1.0, 2.0, 0.0), DVec3::new(0.0, 0.0, 2.0));
        assert_eq!(u.tolerance(&upright, 2.5), 552.0 * eps);
        assert_eq!(u.clear_tolerance(&upright, 2.5), 4.0 * 64.0 * 552.0 * eps);
        // (3, 0, 1) has |Δ| = 4 for 1 along the normal: 32(3 + 20 + 5) + 136, four times
        let slanted = Ray::new(DVec3::new(1.0, 2.0, 0.0), DVec3::new(3.0, 0.0, 1.0));
        assert_eq!(u.tolerance(&slanted, 5.0), 4.0 * 1032.0 * eps);
        // whichever signs the numbers have
        let behind = Ray::new(DVec3::new(-1.0, -2.0, 0.0), DVec3::new(-3.0, 0.0, -1.0));
        assert_eq!(u.tolerance(&behind, -5.0), 4.0 * 1032.0 * eps);
    }

    #[test]
    fn within_the_blur_of_an_edge_the_point_does_not_decide() {
        let near = |polygon: &Polygon, index, (x, y), tolerance| {
            polygon
                .edge_by_point(index, DVec2::new(x, y), tolerance)
                .is_none()
        };
        // the bottom from (0, 0) to (6, 0), the right side from (6, 0) to (6, 6), ¼ around them
        let u = u_shape();
        for (index, p, uncertain) in [
            (0, (3.0, 0.25), true),
            (0, (3.0, -0.25), true),
            (0, (3.0, 0.26), false),
            (0, (-0.25, 0.0), true),
            (0, (6.25, 0.0), true),
            (0, (-0.26, 0.0), false),
            (0, (6.26, 0.0), false),
            (1, (6.0, -0.25), true),
            (1, (6.0, 6.25), true),
            (1, (6.1, -0.26), false),
            (1, (6.1, 6.26), false),
        ] {
            assert_eq!(near(&u, index, p, 0.25), uncertain, "{p:?}");
        }
        // (0, 0) to (4, 2) and its mirror images: side is ±(4·y − 2·x), and ¼ allows (4 + 2)/4
        for (u, v) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let slanted = polygon(&[(0.0, 0.0), (4.0 * u, 2.0 * v), (0.0, 4.0 * v)]);
            for (y, uncertain) in [(1.375, true), (1.385, false), (0.625, true), (0.615, false)] {
                let p = (2.0 * u, y * v);
                assert_eq!(near(&slanted, 0, p, 0.25), uncertain, "{p:?}");
            }
        }
    }

    #[test]
    fn on_an_edge_without_blur_only_the_rounding_of_its_side_is_in_doubt() {
        let near =
            |polygon: &Polygon, (x, y)| polygon.edge_by_point(0, DVec2::new(x, y), 0.0).is_none();
        assert!(near(&u_shape(), (0.0, 0.0)));
        // from (1, 2) by (3000, 1000): both terms of side are 3·10⁵ at (301, 102), and 16ε·6·10⁵ is 2.1·10⁻⁹
        for (u, v) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let long = polygon(&[(u, 2.0 * v), (3001.0 * u, 1002.0 * v), (u, 4002.0 * v)]);
            for (y, doubt) in [
                (102.0, true),
                (102.0 + 5e-13, true),
                (102.0 + 1e-12, false),
                (900.0, false),
            ] {
                assert_eq!(near(&long, (301.0 * u, y * v)), doubt, "{u} {v} {y}");
            }
        }
        // 0.1·3 − 0.3·1 leaves a rounding of 5.6·10⁻¹⁷
        let short = polygon(&[(0.0, 0.0), (3.0, 1.0), (0.0, 4.0)]);
        assert!(near(&short, (0.3, 0.1)));
        assert!(!near(&short, (0.3, 0.1 + 1e-14)));
        // the terms count from the first end: 3·2⁻⁴⁰ is far beyond 16ε·1.5, and within 16ε·2000
        let far_off = polygon(&[(1000.0, 1000.0), (1003.0, 1001.0), (1000.0, 1004.0)]);
        assert!(near(&far_off, (1000.75, 1000.25)));
        assert!(!near(&far_off, (1000.75, 1000.25 + 0.5_f64.powi(40))));
    }

    #[test]
    fn a_flat_ray_is_in_doubt_twice_as_far_from_an_edge() {
        let u = u_shape();
        let upright = Ray::new(DVec3::new(3.0, 1.0, 0.0), DVec3::Z);
        let flat = Ray::new(DVec3::new(3.0, 1.0, 0.0), DVec3::new(1.0, 0.0, 1.0 / 128.0));
        // this many tolerances below the bottom
        for (ray, tolerances, decided_by) in [
            (upright, 0.5, DecidedBy::Ray),
            (upright, 1.5, DecidedBy::Point),
            (flat, 1.5, DecidedBy::Ray),
            (flat, 2.5, DecidedBy::Point),
        ] {
            let p = DVec2::new(3.0, -tolerances * u.tolerance(&ray, 5.0));
            assert_eq!(
                u.crossings_near_an_edge(&ray, 5.0, p).1,
                decided_by,
                "{tolerances}"
            );
        }
    }

    #[test]
    fn a_ray_exactly_through_an_edge_or_a_corner_is_taken_by_the_side_that_the_rule_names() {
        // Along z the shortest axis is x. The half-plane sweeps towards +x, and an edge in it counts, as if the
        // ray had been shifted to −x; a vertex in it lies above it, which along z is towards −y, as if to +y.
        let square =
            |x: f64, y: f64| polygon(&[(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)]);
        for (x, y, takes) in [
            (0.0, 0.0, false),
            (-1.0, 0.0, true),
            (-1.0, -1.0, false),
            (0.0, -1.0, false),
        ] {
            let test = at(&square(x, y), 0.0, 0.0);
            assert_eq!(
                (test.inside, test.decided_by),
                (takes, DecidedBy::Ray),
                "({x}, {y})"
            );
        }
        assert!(at(&square(-1.0, 0.0), 0.0, 0.5).inside);
        // both sides of this one lie in the half-plane: the left one on its rim
        assert_eq!(at(&square(0.0, 0.0), 0.0, 0.5).crossings, 2);
    }

    #[test]
    fn the_second_point_of_a_ray_is_as_far_out_as_its_origin() {
        let line = RayLine::new(&Ray::new(DVec3::new(1000.0, 0.0, 0.0), 0.125 * DVec3::Z));
        assert_eq!(line.ahead, DVec3::new(1000.0, 0.0, 1000.0));
        let line = RayLine::new(&Ray::new(DVec3::X, 8.0 * DVec3::Z));
        assert_eq!(line.ahead, DVec3::new(1.0, 0.0, 8.0));
        let line = RayLine::new(&Ray::new(DVec3::new(-1000.0, 0.0, 0.0), -0.125 * DVec3::Z));
        assert_eq!(line.ahead, DVec3::new(-1000.0, 0.0, -1000.0));
    }

    #[test]
    fn a_point_is_clear_of_the_edges_that_are_further_off_than_the_margin() {
        // |side|/(|Δu| + |Δv|) from (1, 1) is 4/4, 8/8 and 4/4 for the edges of this triangle, and of its mirror images
        for (u, v) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let mirror = DVec2::new(u, v);
            let outline = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(|p| mirror * DVec2::from(p));
            let crossings = |clear| clear_crossings(&outline, mirror, clear);
            assert_eq!(crossings(1.0_f64.next_down()), Some(1));
            assert_eq!((crossings(1.0), crossings(1.01)), (None, None));
        }
    }
}
