//! The coordinate axes and planes in a drawing, and what is projected onto them.

use glam::{DVec2, DVec3};

use crate::figure::parts::depth;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::view::{Projection, Space};
use crate::geometry::Axis;
use crate::scene::Primitive;

/// The letter of an axis.
pub(in crate::figure) fn letter(axis: Axis) -> &'static str {
    match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    }
}

/// What the coefficient of a coordinate is called in (iv).
pub(in crate::figure) fn coefficient(axis: Axis) -> &'static str {
    match axis {
        Axis::X => "A",
        Axis::Y => "B",
        Axis::Z => "C",
    }
}

fn unit(axis: Axis) -> DVec3 {
    match axis {
        Axis::X => DVec3::X,
        Axis::Y => DVec3::Y,
        Axis::Z => DVec3::Z,
    }
}

/// The foot of a point on the coordinate plane across an axis: the coordinate is dropped.
pub(in crate::figure) fn foot(axis: Axis, point: DVec3) -> DVec3 {
    point - axis.of(point) * unit(axis)
}

/// The point of the coordinate plane across an axis that is left of another without that coordinate.
pub(in crate::figure) fn on_plane(axis: Axis, p: DVec2) -> DVec3 {
    match axis {
        Axis::X => DVec3::new(0.0, p.x, p.y),
        Axis::Y => DVec3::new(p.x, 0.0, p.y),
        Axis::Z => DVec3::new(p.x, p.y, 0.0),
    }
}

/// The view along an axis, in which what is projected along it has its true shape.
pub(in crate::figure) fn view_along(axis: Axis) -> Projection {
    match axis {
        Axis::X => Projection::new(DVec3::NEG_Z, DVec3::Y),
        Axis::Y => Projection::new(DVec3::X, DVec3::NEG_Z),
        Axis::Z => Projection::new(DVec3::X, DVec3::Y),
    }
}

/// Draws an axis from the origin to its place in `reach`, with its letter at the end. Dotted is what lies behind something.
pub(in crate::figure) fn draw_behind(
    sheet: &mut Sheet,
    space: &Space,
    axis: Axis,
    reach: DVec3,
    covers: &[&Primitive],
) {
    let ends = [DVec3::ZERO, axis.of(reach) * unit(axis)];
    let [from, to] = ends.map(|end| space.place(end));
    depth::arrow(sheet, space, Look::THIN, ends, covers);
    sheet.label(space.frame, to, to - from, formula(letter(axis)));
}

/// Draws the coordinate plane across an axis as far as `reach`: its two axes, and two thin lines.
pub(in crate::figure) fn draw_plane(sheet: &mut Sheet, space: &Space, across: Axis, reach: DVec3) {
    draw_plane_behind(sheet, space, across, reach, &[]);
}

/// The same behind something.
pub(in crate::figure) fn draw_plane_behind(
    sheet: &mut Sheet,
    space: &Space,
    across: Axis,
    reach: DVec3,
    covers: &[&Primitive],
) {
    let corner = foot(across, reach);
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        if axis == across {
            continue;
        }
        let end = axis.of(reach) * unit(axis);
        // a little shorter than the axis, whose arrow begins there
        let edge = 0.9;
        let other = corner - end;
        sheet.line(
            Look::THIN.wide(0.6),
            space.place(edge * other),
            space.place(edge * corner),
        );
        draw_behind(sheet, space, axis, reach, covers);
    }
}

/// Draws the world's axes small, from a corner: those that are seen from their side.
pub(in crate::figure) fn draw_small(sheet: &mut Sheet, space: &Space, corner: DVec2) {
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let along = space.direction(unit(axis));
        // one that points to who looks is no arrow
        if 0.3 < along.length() {
            let tip = corner + SMALL * sheet.letters * along;
            sheet.arrow(Look::THIN, corner, tip);
            sheet.label(space.frame, tip, along, formula(letter(axis)));
        }
    }
}

/// How long a small axis is, in sizes of letters.
pub(in crate::figure) const SMALL: f64 = 2.6;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dropped_coordinate_becomes_0_and_the_others_stay() {
        let p = DVec3::new(1.0, 2.0, 3.0);
        for (axis, expected) in [
            (Axis::X, [0.0, 2.0, 3.0]),
            (Axis::Y, [1.0, 0.0, 3.0]),
            (Axis::Z, [1.0, 2.0, 0.0]),
        ] {
            assert_eq!(foot(axis, p), expected.into());
            assert_eq!(on_plane(axis, axis.drop_from(p)), expected.into());
        }
    }

    #[test]
    fn seen_along_an_axis_the_two_others_have_their_lengths() {
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let p = foot(axis, DVec3::new(1.0, 2.0, 2.0));
            let seen = view_along(axis).of(p);
            assert!((seen.length() - p.length()).abs() < 1e-12, "{axis:?}");
            assert_eq!(view_along(axis).of(unit(axis)).length(), 0.0);
        }
    }
}
