//! The projected polygon in true shape: the half-line from p′ and the edges that it crosses, or two projections
//! beside each other.

use glam::{DVec2, DVec3};

use crate::figure::kinds::polygon::argument::Argument;
use crate::figure::kinds::polygon::tested::{Tested, mark, verdict};
use crate::figure::parts::axes;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::view::Space;
use crate::geometry::{Axis, EdgeTest};

/// The projected polygon in true shape, the half-line from p′, and the edges that count.
pub(super) fn draw(sheet: &mut Sheet, frame: Frame, tested: &Tested, argument: &Argument) {
    let Some((test, _)) = tested.point else {
        return;
    };
    let axis = test.dropped;
    let rest = sheet.at(argument.axis, |sheet| {
        sheet.lines(frame, &choice(tested, axis))
    });
    let panel = sheet.at(argument.verdict, |sheet| {
        sheet.lines(rest, &[verdict(&test)])
    });

    let reach = tested.reach();
    let p = test.projected;
    let outline = tested.polygon.outline();
    let (low, high) = outline.iter().fold((p.x, p.x), |(low, high), at| {
        (low.min(at.x), high.max(at.x))
    });
    let end = DVec2::new(high + 0.15 * (high - low), p.y);
    let flat = outline.iter().chain([&p, &end]);
    let points = flat
        .map(|at| axes::on_plane(axis, *at))
        .chain([DVec3::ZERO, axes::foot(axis, reach)]);
    let space = Space::fitted(
        axes::view_along(axis),
        panel.wider(-0.8 * sheet.letters),
        points,
    );
    let place = |at: DVec2| space.place(axes::on_plane(axis, at));

    let along = place(end) - place(p);
    sheet.at(argument.projection, |sheet| {
        axes::draw_plane(sheet, &space, axis, reach);
        sheet.polygon(Look::OBJECT, outline.iter().map(|at| place(*at)).collect());
        sheet.small_dot(Look::RAY, place(p));
        sheet.label(panel, place(p), -along, formula("p′"));
    });
    sheet.at(argument.crossing(0), |sheet| {
        sheet.arrow(Look::RAY.wide(1.25), place(p), place(end));
    });
    let counted = tested.edges.iter().filter(|(edge, _)| edge.counts);
    let mut crossings: Vec<(DVec2, EdgeTest, u32)> = counted
        .filter_map(|(edge, step)| Some((level_with(edge, p)?, *edge, *step)))
        .collect();
    // counted from p′ on, not in the order of the edges
    crossings.sort_by(|(a, ..), (b, ..)| a.x.total_cmp(&b.x));
    for (number, (at, edge, step)) in crossings.into_iter().enumerate() {
        sheet.at(argument.crossing(number), |sheet| {
            sheet.step(step, |sheet| {
                let line = Look::VISITED.outline().wide(3.0);
                sheet.line(line, place(edge.from), place(edge.to));
                sheet.dot(Look::VISITED, place(at));
            });
            // which number it is shows when all edges are looked at
            let number = format!("{}", number + 1);
            sheet.label(panel, place(at), along + along.perp(), number);
        });
    }
    sheet.at(argument.verdict, |sheet| {
        mark(sheet, test.inside, place(p));
    });
}

/// |A|, |B| and |C|, and which coordinate that drops.
fn choice(tested: &Tested, dropped: Axis) -> [Text; 2] {
    let normal = tested.plane.0.plane.normal.abs();
    let [a, b, c] = normal.to_array().map(quantity);
    let (letter, name) = (axes::letter(dropped), axes::coefficient(dropped));
    [
        formula("|A|, |B|, |C| = ") + format!("{a}, {b}, {c}"),
        formula(&format!("|{name}|")) + " is the largest: drop " + formula(letter),
    ]
}

/// The point of an edge that the half-line from p′ runs through; none on an edge that is parallel to it.
fn level_with(edge: &EdgeTest, p: DVec2) -> Option<DVec2> {
    let along = edge.to - edge.from;
    let share = (p.y - edge.from.y) / along.y;
    share.is_finite().then(|| edge.from + share * along)
}

/// The projection along the axis that the test chose, and along another one, equally large.
pub(super) fn draw_two(
    sheet: &mut Sheet,
    frame: Frame,
    tested: &Tested,
    other: Axis,
    argument: &Argument,
) {
    let Some((test, _)) = tested.point else {
        return;
    };
    let normal = tested.plane.0.plane.normal;
    let frame = sheet.at(argument.axis, |sheet| {
        sheet.lines(frame, &choice(tested, test.dropped))
    });
    let half = 0.5 * frame.size().y;
    let parts = [test.dropped, other].into_iter().zip(frame.split_top(half));
    sheet.at(argument.projection, |sheet| {
        let panels: Vec<(Axis, Frame, Space)> = parts
            .map(|(axis, part)| {
                let (letter, name) = (axes::letter(axis), axes::coefficient(axis));
                let share = quantity(axis.of(normal).abs());
                let text = formula(letter) + " dropped: " + formula(&format!("|{name}| = "));
                let panel = sheet.lines(part, &[text + share + " of the area"]);
                let feet = tested.polygon.vertices().map(|v| axes::foot(axis, v));
                (
                    axis,
                    panel,
                    Space::fitted(axes::view_along(axis), panel, feet),
                )
            })
            .collect();
        let scales = panels.iter().map(|(_, _, space)| space.scale);
        let scale = scales.fold(f64::INFINITY, f64::min);
        for (axis, panel, mut space) in panels {
            space.scale = scale;
            let place = |point| space.place(axes::foot(axis, point));
            sheet.polygon(Look::OBJECT, tested.polygon.vertices().map(place).collect());
            let p = place(test.point);
            sheet.small_dot(Look::RAY, p);
            sheet.label(panel, p, DVec2::X, formula("p′"));
            sheet.at(argument.verdict, |sheet| mark(sheet, test.inside, p));
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_half_line_meets_an_edge_at_its_own_height() {
        let edge = EdgeTest {
            from: DVec2::new(1.0, 0.0),
            to: DVec2::new(3.0, 4.0),
            ..EdgeTest::default()
        };
        // a quarter of the way up
        let at = level_with(&edge, DVec2::new(-5.0, 1.0));
        assert_eq!(at, Some(DVec2::new(1.5, 1.0)));
        let level = EdgeTest {
            to: DVec2::new(3.0, 0.0),
            ..edge
        };
        assert_eq!(level_with(&level, DVec2::ZERO), None);
    }
}
