//! What of a line lies behind a solid or a polygon, as a drawing in space shows it: solid in front, dotted behind.
//!
//! A point is hidden if a ray from it towards who looks hits something: the mathematics of the lectures, asked by the drawing.

use glam::{DVec2, DVec3};

use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;
use crate::figure::view::Space;
use crate::geometry::{Ray, TRange};
use crate::scene::{Primitive, Shape};

/// A part of a line, from one share of it to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::figure) struct Piece {
    pub(in crate::figure) from: f64,
    pub(in crate::figure) to: f64,
    pub(in crate::figure) hidden: bool,
}

/// The parts of a line that are seen and those that are hidden by some primitives, in order.
pub(in crate::figure) fn pieces(
    ends: [DVec3; 2],
    towards: DVec3,
    covers: &[&Primitive],
) -> Vec<Piece> {
    /// A part that is shorter than one of so many is not found.
    const SAMPLES: u32 = 128;
    /// Halvings of such a part: a millionth of the line is left.
    const HALVINGS: u32 = 14;
    let [from, to] = ends;
    let at = |share: f64| from.lerp(to, share);
    let hidden = |share: f64| {
        // what touches the line does not hide it: a thousandth of its length is left free
        let range = TRange {
            min: 1e-3 * from.distance(to),
            ..TRange::FORWARD
        };
        let ray = Ray::new(at(share), towards);
        covers
            .iter()
            .any(|cover| hit_at(cover, &ray, range).is_some())
    };
    let mut pieces = Vec::new();
    // in the middle of its part, so that no sample lies on an end
    let middle = |sample: u32| (f64::from(sample) + 0.5) / f64::from(SAMPLES);
    let mut now = hidden(middle(0));
    let mut start = 0.0;
    for sample in 1..SAMPLES {
        if hidden(middle(sample)) == now {
            continue;
        }
        let (mut low, mut high) = (middle(sample - 1), middle(sample));
        for _ in 0..HALVINGS {
            let half = f64::midpoint(low, high);
            if hidden(half) == now {
                low = half;
            } else {
                high = half;
            }
        }
        let to = f64::midpoint(low, high);
        pieces.push(Piece {
            from: start,
            to,
            hidden: now,
        });
        start = to;
        now = !now;
    }
    pieces.push(Piece {
        from: start,
        to: 1.0,
        hidden: now,
    });
    pieces
}

/// Where does the ray hit it?
pub(in crate::figure) fn hit_at(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let sides = primitive.sides;
    match &primitive.shape {
        Shape::Sphere(sphere) => sphere.test(ray, range, sides).roots.chosen(),
        Shape::Ellipsoid(ellipsoid) => ellipsoid.test(ray, range, sides).roots.chosen(),
        Shape::Box(solid) => solid.test(ray, range, sides).roots.chosen(),
        Shape::Cone(cone) => cone.test(ray, range, sides).roots.chosen(),
        Shape::Polygon(polygon) => {
            let t = polygon.plane_test(ray, range, sides).chosen();
            t.filter(|t| polygon.contains(ray, *t).inside)
        }
    }
}

/// A straight line whose hidden parts are dotted.
pub(in crate::figure) fn line(
    sheet: &mut Sheet,
    space: &Space,
    look: Look,
    ends: [DVec3; 2],
    covers: &[&Primitive],
) {
    draw(sheet, space, look, ends, covers, Sheet::line);
}

/// The same with an arrowhead at its end, if its end is seen.
pub(in crate::figure) fn arrow(
    sheet: &mut Sheet,
    space: &Space,
    look: Look,
    ends: [DVec3; 2],
    covers: &[&Primitive],
) {
    draw(sheet, space, look, ends, covers, Sheet::arrow);
}

fn draw(
    sheet: &mut Sheet,
    space: &Space,
    look: Look,
    ends: [DVec3; 2],
    covers: &[&Primitive],
    last: fn(&mut Sheet, Look, DVec2, DVec2),
) {
    let [from, to] = ends;
    let place = |share: f64| space.place(from.lerp(to, share));
    for piece in pieces(ends, space.projection.towards(), covers) {
        let (start, end) = (place(piece.from), place(piece.to));
        if piece.hidden {
            let dotted = Look {
                colour: look.colour,
                ..Look::HIDDEN
            };
            sheet.line(dotted, start, end);
        } else if piece.to == 1.0 {
            last(sheet, look, start, end);
        } else {
            sheet.line(look, start, end);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{PrimitiveId, small_scene};

    #[test]
    fn behind_a_ball_a_line_is_hidden_where_the_ball_covers_it() {
        let scene = small_scene::scene_of(&[small_scene::sphere([0.0; 3], 1.0)]);
        let ball = scene.primitive(PrimitiveId(0));
        // seen along −z: the ball covers −1 < x < 1 of a line behind it
        let behind = [DVec3::new(-2.0, 0.0, -3.0), DVec3::new(2.0, 0.0, -3.0)];
        let found = pieces(behind, DVec3::Z, &[ball]);
        let expected = [(0.0, 0.25, false), (0.25, 0.75, true), (0.75, 1.0, false)];
        assert_eq!(found.len(), 3, "{found:?}");
        for (piece, (from, to, hidden)) in found.iter().zip(expected) {
            assert!(
                (piece.from - from).abs() < 1e-5 && (piece.to - to).abs() < 1e-5,
                "{piece:?}"
            );
            assert_eq!(piece.hidden, hidden);
        }
        // in front of it nothing is hidden
        let front = behind.map(|at| at + DVec3::new(0.0, 0.0, 6.0));
        assert_eq!(pieces(front, DVec3::Z, &[ball]).len(), 1);
    }
}
