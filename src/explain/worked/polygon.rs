//! The polygon: its plane, equations (iv) and (v), and whether p lies inside (Fig. 15.57).

use crate::explain::number::Digits;
use crate::explain::number::count;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::quadratic;
use crate::explain::worked::roots::sentence;
use crate::explain::worked::steps::{Course, Noted};
use crate::geometry::{Axis, DecidedBy, EdgeTest, PlaneTest, PlaneVerdict, PolygonTest};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Kind;

/// An outline with more edges than this shows only those that cross the level of p′.
const EDGES_SHOWN: usize = 8;

/// What a log says of a polygon: its plane, its edges, the verdict.
type Working<'w> = (
    Option<&'w Noted<PlaneTest>>,
    &'w [Noted<EdgeTest>],
    Option<&'w Noted<PolygonTest>>,
);

/// Plane, point, edges and verdict.
pub(super) fn polygon(
    context: &Context,
    object: PrimitiveId,
    (of_plane, of_edges, inside): Working<'_>,
    course: &Course,
    full: bool,
    page: &mut Pen,
) {
    let Shape::Polygon(polygon) = &context.scene.primitive(object).shape else {
        return;
    };
    let vertices = polygon.vertices().len();
    let what = format!("polygon of {vertices} vertices");
    quadratic::object_line(context, object, &what, page);
    page.indented(|page| {
        if let Some(test) = of_plane.filter(|_| context.shows(Kind::PlaneTest)) {
            page.telling(test.extent, |page| {
                plane(&test.working, course, full, page);
            });
        }
        let Some(inside) = inside else { return };
        page.telling(inside.extent, |page| {
            let inside = &inside.working;
            if context.shows(Kind::PolygonTest) {
                projection(inside, course, page);
            }
            if context.shows(Kind::Edge) && (full || inside.decided_by == DecidedBy::Ray) {
                page.of_part(Part::Crossings, |page| {
                    edges(context, of_edges, inside, page);
                });
            }
            if context.shows(Kind::PolygonTest) {
                verdict(inside, page);
            }
        });
    });
}

/// How many edges count, and what follows from that.
fn verdict(test: &PolygonTest, page: &mut Pen) {
    let number = count(test.crossings as usize, "crossing");
    let (tone, verdict) = if test.inside {
        (Tone::Found, "an odd number, so p lies inside: a hit")
    } else {
        (Tone::Refused, "an even number, so p lies outside: missed")
    };
    page.headed_line(tone, Part::InsideOut, format!(": {number}, {verdict}"));
}

/// t = −(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz) … (v)
fn plane(test: &PlaneTest, course: &Course, full: bool, page: &mut Pen) {
    let plane = test.plane;
    let [x, y, z] = plane.normal.to_array();
    let terms = |o: glam::DVec3| {
        let parts = plane.normal.abs() * o.abs();
        parts.element_sum()
    };
    let d = match course.ray() {
        Some(ray) => Digits::for_difference(terms(ray.origin) + plane.d.abs(), test.numerator).or(
            Digits::for_difference(terms(ray.direction), test.denominator),
        ),
        None => Digits::USUAL,
    };
    let equation = format!(
        ": {} {} {} {} = 0 … (iv)",
        d.times(x, "x"),
        d.term_times(y, "y"),
        d.term_times(z, "z"),
        d.term(plane.d)
    );
    let PlaneVerdict::Meets(root) = test.verdict else {
        page.headed(Part::Plane, equation);
        let within = test.verdict == PlaneVerdict::ParallelWithin;
        let verdict = if within {
            ": none, numerator and denominator of (v) are 0: the ray lies in the plane, missed"
        } else {
            ": none, the denominator of (v) is 0: the ray is parallel to the plane, missed"
        };
        page.headed_line(Tone::Refused, Part::PlaneT, verdict);
        return;
    };
    page.headed(Part::Plane, equation);
    // a flat ray's t may have been moved from here, most often by less than is printed
    let quotient = -test.numerator / test.denominator;
    match course.ray().filter(|_| full) {
        Some(ray) => {
            let formula = " = −(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz) … (v)";
            page.headed(Part::PlaneT, formula);
            page.part(Part::PlaneT).plain(format!(
                "  = −({} {})/({})",
                d.dot(plane.normal, ray.origin),
                d.term(plane.d),
                d.dot(plane.normal, ray.direction)
            ));
            page.part(Part::PlaneT).plain(format!(
                "  = −{}/{} = {}",
                d.factor(test.numerator),
                d.factor(test.denominator),
                d.number(quotient)
            ));
        }
        None => {
            let text = format!(
                " = −{}/{} = {} … (v)",
                d.factor(test.numerator),
                d.factor(test.denominator),
                d.number(quotient)
            );
            page.headed(Part::PlaneT, text);
        }
    }
    if d.number(quotient) != d.number(root.t) {
        page.part(Part::PlaneT).plain(format!(
            "the ray is nearly parallel to the plane, which magnifies the rounding of t: the nearest t inside the \
             outline is {}",
            d.number(root.t)
        ));
    }
    if test.chosen().is_none() {
        let text = format!("{}: missed", sentence(root, None, course));
        page.part(Part::PlaneT).line(Tone::Refused, text);
    }
}

/// p, the axis whose coordinate is dropped, and p′.
fn projection(test: &PolygonTest, course: &Course, page: &mut Pen) {
    let d = Digits::USUAL;
    let (letter, coefficient) = match test.dropped {
        Axis::X => ("x", "A"),
        Axis::Y => ("y", "B"),
        Axis::Z => ("z", "C"),
    };
    let (of_point, of_axis) = if course.aligned.is_some() {
        let of_axis = ": z, along which the ray runs, is dropped".into();
        (
            format!(" = {}, on the z axis", d.vector(test.point)),
            of_axis,
        )
    } else {
        let size = d.number(test.coefficient.abs());
        let of_axis = format!(
            ": |{coefficient}| = {size} is the largest coefficient, so {letter} is dropped"
        );
        (format!(" = o + t·Δ = {}", d.vector(test.point)), of_axis)
    };
    page.headed(Part::PlanePoint, of_point);
    page.headed(Part::Axis, of_axis);
    page.headed(Part::Projection, format!(" = {}", d.point(test.projected)));
}

/// Each edge and whether it counts. Where some are left out, all edges are one step.
fn edges(context: &Context, edges: &[Noted<EdgeTest>], test: &PolygonTest, page: &mut Pen) {
    let by_ray = test.decided_by == DecidedBy::Ray;
    let many = !context.options.all && EDGES_SHOWN < edges.len();
    let is_shown = |edge: &&Noted<EdgeTest>| !many || edge.working.straddles;
    let left_out = edges.len() - edges.iter().filter(is_shown).count();
    let all = Extent::around(edges.iter().map(|edge| edge.extent)).filter(|_| 0 < left_out);
    let head = if by_ray {
        ": p′ is closer to an edge than its rounding, so the edges are tested against the ray itself; an edge \
         counts if the ray and the edge span a volume of 0 or more (exact)"
    } else {
        ": an edge counts if it crosses the half-line that runs from p′ to the right"
    };
    if let Some(first) = edges.first() {
        page.telling(all.unwrap_or(first.extent), |page| {
            page.headed(Part::Crossings, head);
        });
    }
    page.indented(|page| {
        for edge in edges.iter().filter(is_shown) {
            page.telling(all.unwrap_or(edge.extent), |page| {
                page.plain(edge_text(&edge.working, test, by_ray));
            });
        }
        if 0 < left_out {
            let lie = if left_out == 1 { "lies" } else { "lie" };
            let text = format!("… {} {lie} above or below p′", count(left_out, "more edge"));
            page.telling(all, |page| page.folded(left_out, text));
        }
    });
}

/// An edge and whether it counts.
fn edge_text(edge: &EdgeTest, test: &PolygonTest, by_ray: bool) -> String {
    let d = Digits::USUAL;
    let verdict = match (edge.straddles, by_ray) {
        (false, false) => level(edge, test),
        (false, true) => "both ends are on one side of the ray, does not count".into(),
        (true, false) => crossing(edge, test, d),
        (true, true) => format!(
            "spans a volume of {}/6, {}",
            d.number(edge.side),
            counts(edge.counts)
        ),
    };
    format!(
        "edge {} from {} to {}: {verdict}",
        edge.index,
        d.point(edge.from),
        d.point(edge.to)
    )
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
    format!("lies {place} p′, does not count")
}

/// An edge that crosses the level of p′: to the right of it, where the half-line runs, or to the left.
fn crossing(edge: &EdgeTest, test: &PolygonTest, d: Digits) -> String {
    let along = edge.to - edge.from;
    let at = edge.from.x + along.x * (test.projected.y - edge.from.y) / along.y;
    let side = if edge.counts { "right" } else { "left" };
    format!(
        "crosses the level of p′ at {}, to the {side} of {}, {}",
        d.number(at),
        d.number(test.projected.x),
        counts(edge.counts)
    )
}
