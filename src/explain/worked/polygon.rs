//! The polygon: its plane, equations (iv) and (v), and whether p lies inside (Fig. 15.57).

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::worked::quadratic::fate;
use crate::explain::worked::steps::Course;
use crate::explain::worked::{Solution, count};
use crate::geometry::{Axis, DecidedBy, EdgeTest, PlaneTest, PlaneVerdict, PolygonTest};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Kind;

/// An outline with more edges than this shows only those that cross the level of p′.
const EDGES_SHOWN: usize = 8;

/// What a log says of a polygon: its plane, its edges, the verdict.
type Working<'w> = (
    Option<&'w PlaneTest>,
    &'w [EdgeTest],
    Option<&'w PolygonTest>,
);

impl Solution<'_> {
    /// Plane, point, edges and verdict.
    pub(super) fn polygon(
        &mut self,
        object: PrimitiveId,
        (plane, edges, inside): Working<'_>,
        course: &Course,
        full: bool,
    ) {
        let Shape::Polygon(polygon) = &self.scene.primitive(object).shape else {
            return;
        };
        let vertices = polygon.vertices().len();
        let what = format!("polygon of {vertices} vertices");
        self.object_line(object, &what);
        self.page.indent();
        if let Some(plane) = plane.filter(|_| self.shows(Kind::PlaneTest)) {
            self.plane(plane, course, full);
        }
        if let Some(inside) = inside {
            if self.shows(Kind::PolygonTest) {
                self.projection(inside, course);
            }
            if self.shows(Kind::Edge) && (full || inside.decided_by == DecidedBy::Ray) {
                self.edges(edges, inside);
            }
            if self.shows(Kind::PolygonTest) {
                let number = count(inside.crossings as usize, "crossing");
                if inside.inside {
                    self.page.line(
                        Tone::Found,
                        format!("{number}, an odd number: p lies inside, a hit"),
                    );
                } else {
                    self.page.line(
                        Tone::Refused,
                        format!("{number}, an even number: p lies outside, missed"),
                    );
                }
            }
        }
        self.page.outdent();
    }

    /// t = −(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz) … (v)
    fn plane(&mut self, test: &PlaneTest, course: &Course, full: bool) {
        let plane = test.plane;
        let [x, y, z] = plane.normal.to_array();
        let terms = |o: glam::DVec3| {
            let parts = plane.normal.abs() * o.abs();
            parts.element_sum()
        };
        let d = match course.ray() {
            Some(ray) => {
                Digits::for_difference(terms(ray.origin) + plane.d.abs(), test.numerator).or(
                    Digits::for_difference(terms(ray.direction), test.denominator),
                )
            }
            None => Digits::USUAL,
        };
        let equation = format!(
            "{}·x {}·y {}·z {} = 0 … (iv)",
            d.number(x),
            d.term(y),
            d.term(z),
            d.term(plane.d)
        );
        let PlaneVerdict::Meets(root) = test.verdict else {
            self.page.plain(equation);
            let within = test.verdict == PlaneVerdict::ParallelWithin;
            let verdict = if within {
                "numerator and denominator of (v) are 0: the ray lies in the plane, no intersection"
            } else {
                "the denominator of (v) is 0: the ray is parallel to the plane, no intersection"
            };
            self.page.line(Tone::Refused, verdict);
            return;
        };
        self.page.plain(equation);
        // a flat ray's t may have been moved from here, most often by less than is printed
        let quotient = -test.numerator / test.denominator;
        match course.ray().filter(|_| full) {
            Some(ray) => {
                self.page
                    .plain("t = -(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz) … (v)");
                self.page.plain(format!(
                    "  = -({} {})/({})",
                    d.dot(plane.normal, ray.origin),
                    d.term(plane.d),
                    d.dot(plane.normal, ray.direction)
                ));
                self.page.plain(format!(
                    "  = -{}/{} = {}",
                    d.factor(test.numerator),
                    d.factor(test.denominator),
                    d.number(quotient)
                ));
            }
            None => self.page.plain(format!(
                "t = -{}/{} = {} … (v)",
                d.factor(test.numerator),
                d.factor(test.denominator),
                d.number(quotient)
            )),
        }
        if d.number(quotient) != d.number(root.t) {
            self.page.plain(format!(
                "so flat a ray stretches the rounding: the nearest t within the outline is {}",
                d.number(root.t)
            ));
        }
        if test.chosen().is_none() {
            let text = format!("{}: missed", fate(root, None, course));
            self.page.line(Tone::Refused, text);
        }
    }

    /// p, the dropped coordinate and p′.
    fn projection(&mut self, test: &PolygonTest, course: &Course) {
        let d = Digits::USUAL;
        if course.aligned.is_some() {
            self.page.plain(format!(
                "p = {} lies on the z axis; z is dropped, along the ray: p' = {}",
                d.vector(test.point),
                d.point(test.projected)
            ));
            return;
        }
        let (letter, coefficient) = match test.dropped {
            Axis::X => ("x", "A"),
            Axis::Y => ("y", "B"),
            Axis::Z => ("z", "C"),
        };
        self.page.plain(format!(
            "p = o + t·Δ = {}; |{coefficient}| = {} is the largest, so {letter} is dropped: p' = {}",
            d.vector(test.point),
            d.number(test.coefficient.abs()),
            d.point(test.projected)
        ));
    }

    /// Each edge and whether it counts.
    fn edges(&mut self, edges: &[EdgeTest], test: &PolygonTest) {
        let d = Digits::USUAL;
        let by_ray = test.decided_by == DecidedBy::Ray;
        if by_ray {
            self.page.plain(
                "p' is within its rounding of an edge, so the side on which the ray itself passes each \
                 edge decides: an edge counts if ray and edge span a volume of 0 or more (exact)",
            );
        }
        let many = !self.options.all && EDGES_SHOWN < edges.len();
        let mut left_out = 0;
        for edge in edges {
            if many && !edge.straddles {
                left_out += 1;
                continue;
            }
            let ends = format!(
                "edge {} from {} to {}",
                edge.index,
                d.point(edge.from),
                d.point(edge.to)
            );
            let verdict = match (edge.straddles, by_ray) {
                (false, false) => level(edge, test),
                (false, true) => "both ends lie on one side of the ray: does not count".into(),
                (true, false) => crossing(edge, test, d),
                (true, true) => format!(
                    "6 times the volume is {}: {}",
                    d.number(edge.side),
                    counts(edge.counts)
                ),
            };
            self.page.plain(format!("{ends}: {verdict}"));
        }
        if 0 < left_out {
            let text = format!(
                "… {} lie wholly above or below p' (--all lists them)",
                count(left_out, "more edge")
            );
            self.page.line(Tone::Aside, text);
        }
    }
}

fn counts(counts: bool) -> &'static str {
    if counts { "counts" } else { "does not count" }
}

/// An edge that does not reach the level of p′.
fn level(edge: &EdgeTest, test: &PolygonTest) -> String {
    let place = if test.projected.y < edge.from.y {
        "above"
    } else {
        "below"
    };
    format!("lies {place} p', does not count")
}

/// An edge that crosses the level of p′: to the right of it, where the half-line runs, or to the left.
fn crossing(edge: &EdgeTest, test: &PolygonTest, d: Digits) -> String {
    let along = edge.to - edge.from;
    let at = edge.from.x + along.x * (test.projected.y - edge.from.y) / along.y;
    let side = if edge.counts { "right" } else { "left" };
    format!(
        "crosses the level of p' at {}, to the {side} of {}: {}",
        d.number(at),
        d.number(test.projected.x),
        counts(edge.counts)
    )
}
