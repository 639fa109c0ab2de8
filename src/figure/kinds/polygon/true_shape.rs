//! The projected polygon in true shape: the half-line from p′ and the edges that it crosses, or two projections
//! beside each other.

use glam::{DVec2, DVec3};

use crate::figure::kinds::polygon::argument::Argument;
use crate::figure::kinds::polygon::tested::{Tested, mark, verdict};
use crate::figure::parts::axes;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Sheet, Width};
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
        let [sizes, largest] = choice(tested, test.dropped);
        match sheet.width {
            Width::Book => sheet.lines(frame, &[sizes, largest]),
            // the sizes stand beside the projections
            Width::Slide => sheet.lines(frame, &[largest]),
        }
    });
    let of_area = match sheet.width {
        Width::Book => " of the area",
        Width::Slide => "",
    };
    let half = 0.5 * frame.size().y;
    let parts = [test.dropped, other].into_iter().zip(frame.split_top(half));
    sheet.at(argument.projection, |sheet| {
        let panels: Vec<(Axis, Frame, Space)> = parts
            .map(|(axis, part)| {
                let (letter, name) = (axes::letter(axis), axes::coefficient(axis));
                let share = quantity(axis.of(normal).abs());
                let text = formula(letter) + " dropped: " + formula(&format!("|{name}| = "));
                let rest = sheet.lines(part, &[text + share + of_area]);
                let flat = Flat::of(tested, axis, test.point);
                let distance = formula("p′") + " is " + quantity(flat.to_edge()) + " from an edge";
                let panel = sheet.at(argument.verdict, |sheet| sheet.lines(rest, &[distance]));
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
            if sheet.width == Width::Book {
                let below = DVec2::new(1.5, -1.4) * sheet.letters;
                let corner = DVec2::new(panel.min.x, panel.max.y);
                // an axis that points down starts higher
                let down = space.direction(DVec3::Y) + space.direction(DVec3::Z);
                let start = axes::SMALL * sheet.letters * down.max(DVec2::ZERO);
                axes::draw_small(sheet, &space, corner + below - start);
            }
            sheet.polygon(Look::OBJECT, tested.polygon.vertices().map(place).collect());
            let p = place(test.point);
            sheet.small_dot(Look::RAY, p);
            sheet.label(panel, p, DVec2::NEG_X, formula("p′"));
            let flat = Flat::of(tested, axis, test.point);
            let crossings = flat.crossings().into_iter().map(|at| space.place_flat(at));
            let crossings: Vec<DVec2> = crossings.collect();
            let beyond = DVec2::new(2.0 * sheet.letters, 0.0);
            sheet.at(argument.verdict, |sheet| {
                if let Some(last) = crossings.last() {
                    sheet.arrow(Look::RAY.wide(1.25), p, *last + beyond);
                }
                for (number, at) in crossings.iter().enumerate() {
                    sheet.dot(Look::VISITED, *at);
                    let towards = DVec2::new(1.0, 1.0);
                    sheet.label(panel, *at, towards, (number + 1).to_string());
                }
                mark(sheet, test.inside, p);
            });
        }
    });
}

/// The projection along any axis: the polygon and p′, to the right and upwards.
struct Flat {
    outline: Vec<DVec2>,
    p: DVec2,
}

impl Flat {
    fn of(tested: &Tested, axis: Axis, point: DVec3) -> Self {
        let view = axes::view_along(axis);
        let flat = |point| view.of(axes::foot(axis, point));
        Self {
            outline: tested.polygon.vertices().map(flat).collect(),
            p: flat(point),
        }
    }

    fn edges(&self) -> impl Iterator<Item = [DVec2; 2]> {
        let next = self.outline.iter().cycle().skip(1);
        self.outline.iter().zip(next).map(|(a, b)| [*a, *b])
    }

    /// Where the half-line from p′ to the right crosses edges, from the nearest on.
    fn crossings(&self) -> Vec<DVec2> {
        let crossed = self.edges().filter_map(|[a, b]| {
            let share = (self.p.y - a.y) / (b.y - a.y);
            let is_crossed = (a.y <= self.p.y) != (b.y <= self.p.y);
            let at = is_crossed.then(|| a + share * (b - a))?;
            (self.p.x < at.x).then_some(at)
        });
        let mut crossed: Vec<DVec2> = crossed.collect();
        crossed.sort_by(|a, b| a.x.total_cmp(&b.x));
        crossed
    }

    /// How far p′ is from the nearest edge.
    fn to_edge(&self) -> f64 {
        let distance = |[a, b]: [DVec2; 2]| {
            let along = b - a;
            let share = (self.p - a).dot(along) / along.length_squared();
            let share = if share.is_finite() {
                share.clamp(0.0, 1.0)
            } else {
                0.0
            };
            self.p.distance(a + share * along)
        };
        self.edges().map(distance).fold(f64::INFINITY, f64::min)
    }
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

    #[test]
    fn the_half_line_crosses_the_right_edge_and_the_nearest_edge_is_below() {
        // a triangle of 4 × 3: p is 1 above its base, and the slanted edge x/4 + y/3 = 1 is at x = 8/3 there
        let flat = Flat {
            outline: [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(DVec2::from).into(),
            p: DVec2::new(1.2, 1.0),
        };
        let [at] = flat.crossings()[..] else {
            panic!("{:?}", flat.crossings());
        };
        assert!(at.distance(DVec2::new(8.0 / 3.0, 1.0)) < 1e-12, "{at}");
        // 1.2 from the left, and (12 − 3.6 − 4)/5 = 0.88 from the slanted edge
        assert!((flat.to_edge() - 0.88).abs() < 1e-12);
    }
}
