//! The parametric ray, equation (i): which t belongs to which point of the line. Below it two scales: with Δ as it is
//! from the COP to the pixel's centre, where t is 1 on the window; and with |Δ| = 1, where t is a distance (erratum 4).
//!
//! The view is chosen so that the ray goes straight to the right.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{Outline, Rim, draw as draw_outline, hull, rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};
use crate::geometry::Ray;
use crate::trace::{Event, RayEnd, RayStart};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 320.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Window, Layer::Numbers],
    more: &[],
};

/// How far the line is shown behind the COP and beyond the last point, in lengths of Δ.
const BEYOND: f64 = 1.3;

/// The ray twice, and what it hits.
struct Line {
    /// With Δ from the COP to the window.
    to_window: Ray,
    window_step: u32,
    /// With |Δ| = 1.
    unit: RayStart,
    unit_step: u32,
    end: RayEnd,
    end_step: u32,
}

/// A point of the line with its t on both scales.
struct Stop {
    t: [f64; 2],
    point: DVec3,
    name: &'static str,
    step: Option<u32>,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    /// How high the line's own part is at most, of the width.
    const SHARE: f64 = 0.3;
    let line = find(figure)?;
    let stops = stops(&line);
    let scales = 2.0 * scale_height(sheet) + sheet.line_height();
    let height = (body.size().y - scales).min(SHARE * body.size().x);
    let top = body.middle().y - 0.5 * (height + scales);
    let body = Frame {
        min: DVec2::new(body.min.x, top),
        max: DVec2::new(body.max.x, top + height + scales),
    };
    let [above, below] = body.split_top(height);
    // the scales have their names at the left
    let left = sheet.width_of("|Δ| = 0.0000") + sheet.letters;
    let above = Frame {
        min: DVec2::new(above.min.x + left, above.min.y),
        ..above
    };

    let projection = Projection::new(line.unit.ray.direction, figure.scene.camera.up);
    let last = stops.iter().map(|stop| stop.t[0]).fold(1.0, f64::max);
    let ends = [-BEYOND, last + BEYOND].map(|t| line.to_window.at(t));
    let mut shown: Vec<DVec2> = ends.iter().map(|&end| projection.of(end)).collect();
    let met = line.end.object.map(|id| {
        let shape = &figure.scene.primitive(id).shape;
        Outline::of(shape, &projection)
    });
    if let Some(outline) = &met {
        let (start, length) = (shown[0], shown[1].x - shown[0].x);
        // of a large object the part that is at the line is enough
        let most = 0.5 * length * above.size().y / above.size().x;
        let heights = outline.rim.points().into_iter();
        let heights = heights.map(|at| at.y.clamp(start.y - most, start.y + most));
        shown.extend(heights.map(|y| DVec2::new(start.x, y)));
    }
    let space = Space::fitted_flat(projection, above, shown);

    if figure.shows(Layer::Objects)
        && let Some(outline) = &met
    {
        sheet.step(line.end_step, |sheet| {
            draw_outline(sheet, &space, outline, Look::ANSWER);
        });
    }
    if figure.shows(Layer::Window) {
        let corners = scenery::window_corners(figure.scene).map(|of| projection.of(of));
        let look = Look::OBJECT.wide(1.5);
        rim(sheet, &space, &Rim::Points(corners.into()), look);
    }
    the_line(sheet, &space, &line, &stops, ends);
    labels(figure, sheet, &space, &line, &stops);
    scales_below(sheet, &space, below, &stops, &line);
    regions(sheet, &space, below, &stops);
    if figure.shows(Layer::Objects) && figure.shows(Layer::Names) {
        names(figure, sheet, &space, &line, met.as_ref());
    }
    Ok(in_words(figure, &line))
}

fn find(figure: &Figure) -> Result<Line, FigureError> {
    let drawn = figure.ray()?;
    let steps = drawn.node.ends_at;
    let records = figure.records()?;
    let sample = records.iter().find_map(|record| match &record.event {
        Event::Pixel(sample) => Some((sample, record.step)),
        _ => None,
    });
    let step = |end: Option<usize>| end.map(|at| records[at].step);
    match (sample, drawn.node.start, drawn.node.end, steps.map(step)) {
        (Some((sample, window_step)), Some(unit), Some(end), [Some(unit_step), Some(end_step)])
            if unit.window_t.is_some() =>
        {
            Ok(Line {
                to_window: Ray::through(unit.ray.origin, sample.point),
                window_step,
                unit,
                unit_step,
                end,
                end_step,
            })
        }
        _ => Err(FigureError::new(
            "ray",
            "this kind of figure draws an eye ray, and this ray is not one",
            "omit \"ray\", or name an eye ray",
        )),
    }
}

/// Behind the COP, the COP, the window, the hit: in the order in which the line passes them.
fn stops(line: &Line) -> Vec<Stop> {
    let window_t = line.unit.window_t.unwrap_or(1.0);
    let stop = |t: f64, name, step| Stop {
        t: [t, t * window_t],
        point: line.to_window.at(t),
        name,
        step,
    };
    let mut stops = vec![
        stop(-1.0, "", None),
        stop(0.0, "COP", None),
        stop(1.0, "pixel centre", Some(line.window_step)),
    ];
    if let Some(t) = line.end.t {
        stops.push(Stop {
            t: [t / window_t, t],
            point: line.unit.ray.at(t),
            name: "hit",
            step: Some(line.end_step),
        });
    }
    stops
}

fn the_line(sheet: &mut Sheet, space: &Space, line: &Line, stops: &[Stop], ends: [DVec3; 2]) {
    let at = |t: f64| space.place(line.to_window.at(t));
    let [from, to] = ends.map(|end| space.place(end));
    sheet.line(Look::LINE_OF_RAY, from, at(0.0));
    match line.end.t {
        Some(t) => {
            let hit = space.place(line.unit.ray.at(t));
            sheet.line(Look::LINE_OF_RAY, hit, to);
            sheet.step(line.end_step, |sheet| {
                sheet.line(Look::RAY, at(1.0), hit);
            });
        }
        None => sheet.line(Look::RAY, at(1.0), to),
    }
    sheet.step(line.window_step, |sheet| {
        sheet.arrow(Look::VISITED.wide(2.5), at(0.0), at(1.0));
        for stop in stops {
            sheet.step(stop.step, |sheet| {
                let look = if stop.name == "hit" {
                    Look::ANSWER
                } else {
                    Look::RAY
                };
                let place = space.place(stop.point);
                if stop.t[0] < 0.0 {
                    sheet.ring(look.wide(1.5), place);
                } else {
                    sheet.dot(look, place);
                }
            });
        }
    });
}

fn labels(figure: &Figure, sheet: &mut Sheet, space: &Space, line: &Line, stops: &[Stop]) {
    // the point behind the COP, which has no name, makes way for the others
    let behind = stops.len().min(1);
    for stop in stops[behind..].iter().chain(&stops[..behind]) {
        let place = space.place(stop.point);
        let text = match (figure.shows(Layer::Numbers), stop.name) {
            (true, "") => coordinates(stop.point),
            (true, name) => format!("{name} {}", coordinates(stop.point)),
            (false, "") => continue,
            (false, name) => name.into(),
        };
        sheet.step(stop.step, |sheet| {
            sheet.label(space.frame, place, DVec2::NEG_Y, text);
        });
    }
    sheet.step(line.window_step, |sheet| {
        let middle = space.place(line.to_window.at(0.5));
        let [from, to] = [0.0, 1.0].map(|t| space.place(line.to_window.at(t)));
        // between the lines down from the COP and the pixel's centre, or else without the numbers; the letters of a page are
        // narrower than those that are measured
        let room = from.distance(to);
        let text = format!("Δ = {}", coordinates(line.to_window.direction));
        let is_told = figure.shows(Layer::Numbers) && sheet.width_of(&text) <= room;
        let text = if is_told { text } else { "Δ".into() };
        sheet.label(space.frame, middle, DVec2::Y, text);
    });
    if figure.shows(Layer::Window) {
        let corners = scenery::window_corners(figure.scene).map(|of| space.projection.of(of));
        let around = hull(corners.into()).into_iter();
        let around: Vec<DVec2> = around.map(|at| space.place_flat(at)).collect();
        // of a window larger than the frame its highest point that is seen
        let seen = space.frame.cut_polygon(&around);
        if let Some(&top) = seen.iter().min_by(|a, b| a.y.total_cmp(&b.y)) {
            sheet.label(space.frame, top, DVec2::NEG_Y, "window");
        }
    }
}

/// A line for the ticks' numbers, and air.
fn scale_height(sheet: &Sheet) -> f64 {
    2.6 * sheet.letters
}

fn scales_below(sheet: &mut Sheet, space: &Space, below: Frame, stops: &[Stop], line: &Line) {
    let height = scale_height(sheet);
    let lengths = [line.to_window.direction.length(), 1.0];
    let tick = 5.0 * sheet.unit();
    for (scale, length) in lengths.into_iter().enumerate() {
        let step = [None, Some(line.unit_step)][scale];
        let y = below.min.y + (scale as f64 + 0.4) * height;
        let [left, right] = [space.frame.min.x, space.frame.max.x].map(|x| DVec2::new(x, y));
        sheet.step(step, |sheet| {
            sheet.arrow(Look::THIN.wide(1.25), left, right);
            let name = DVec2::new(below.min.x, y);
            sheet.text(Anchor::Start, name, format!("|Δ| = {}", quantity(length)));
            let end = right - DVec2::new(0.0, 0.9 * sheet.letters);
            sheet.text(Anchor::End, end, "t");
            for stop in stops {
                let x = space.place(stop.point).x;
                sheet.step(step.max(stop.step), |sheet| {
                    let [from, to] = [-tick, tick].map(|by| DVec2::new(x, y + by));
                    sheet.line(Look::THIN.wide(1.5), from, to);
                    let place = DVec2::new(x, y + tick + 0.75 * sheet.letters);
                    sheet.text(Anchor::Middle, place, quantity(stop.t[scale]));
                });
            }
        });
    }
    // from the points down to the first scale
    for stop in stops {
        let from = space.place(stop.point);
        let y = below.min.y + 0.4 * height - tick;
        sheet.step(stop.step, |sheet| {
            sheet.line(Look::HELP.wide(0.75), from, DVec2::new(from.x, y));
        });
    }
}

/// What the parts of the line are, below the scales.
fn regions(sheet: &mut Sheet, space: &Space, below: Frame, stops: &[Stop]) {
    let y = below.max.y - 0.5 * sheet.line_height();
    let x = |stop: &Stop| space.place(stop.point).x;
    let [_, cop, window, ..] = stops else {
        return;
    };
    let parts = [
        (space.frame.min.x, x(cop), "behind the COP"),
        (x(window), space.frame.max.x, "beyond the window"),
    ];
    for (from, to, text) in parts {
        let middle = DVec2::new(f64::midpoint(from, to), y);
        sheet.text(Anchor::Middle, middle, text);
    }
}

fn names(figure: &Figure, sheet: &mut Sheet, space: &Space, line: &Line, met: Option<&Outline>) {
    let (Some(id), Some(outline)) = (line.end.object, met) else {
        return;
    };
    let points = outline.rim.points();
    let middle = points.iter().sum::<DVec2>() / points.len().max(1) as f64;
    sheet.step(line.end_step, |sheet| {
        let name = scenery::name_of(figure.scene, id);
        sheet.label(space.frame, space.place_flat(middle), DVec2::Y, name);
    });
}

fn in_words(figure: &Figure, line: &Line) -> String {
    let window_t = line.unit.window_t.unwrap_or(1.0);
    let (origin, delta) = (line.to_window.origin, line.to_window.direction);
    let start = format!(
        "The ray starts at the COP {} with Δ = {} of length {}. t is 0 at the COP, negative behind it, and 1 on the \
         window if Δ is not normalised; with |Δ| = 1 the window is at t = {}.",
        coordinates(origin),
        coordinates(delta),
        quantity(delta.length()),
        quantity(window_t),
    );
    match (line.end.t, line.end.object) {
        (Some(t), Some(id)) => format!(
            "{start} It hits {} at t = {}, or {}.",
            scenery::name_of(figure.scene, id),
            quantity(t / window_t),
            quantity(t),
        ),
        _ => format!("{start} It misses all objects."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stop_has_its_t_on_both_scales() {
        // Δ = (2, 1, −2) of length 3; the hit at a distance of 9
        let to_window = Ray::through(DVec3::new(1.0, 0.0, 6.0), DVec3::new(3.0, 1.0, 4.0));
        let (unit, window_t) = to_window.normalised().unwrap();
        let line = Line {
            to_window,
            window_step: 0,
            unit: RayStart {
                ray: unit,
                window_t: Some(window_t),
                ..RayStart::default()
            },
            unit_step: 1,
            end: RayEnd {
                t: Some(9.0),
                ..RayEnd::default()
            },
            end_step: 2,
        };
        let stops = stops(&line);
        let expected = [
            ([-1.0, -3.0], [-1.0, -1.0, 8.0]),
            ([0.0, 0.0], [1.0, 0.0, 6.0]),
            ([1.0, 3.0], [3.0, 1.0, 4.0]),
            ([3.0, 9.0], [7.0, 3.0, 0.0]),
        ];
        assert_eq!(stops.len(), expected.len());
        for (stop, (t, point)) in stops.iter().zip(expected) {
            assert_eq!(stop.t, t, "{}", stop.name);
            let off = (stop.point - DVec3::from(point)).length();
            assert!(off < 1e-12, "{}: {}", stop.name, stop.point);
        }
    }
}
