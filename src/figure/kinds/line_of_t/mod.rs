//! The parametric ray, equation (i): which t belongs to which point of the line. Below it two scales: with Δ as it is
//! from the COP to the pixel's centre, where t is 1 on the window; and with |Δ| = 1, where t is a distance (erratum 4).
//!
//! The view is chosen so that the ray goes straight to the right.

mod argument;
mod scales;
mod stops;

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::line_of_t::argument::Argument;
use crate::figure::kinds::line_of_t::stops::{Line, Place, Stop};
use crate::figure::parts::outline::{Outline, Rim, draw as draw_outline, hull, rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 340.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Window, Layer::Numbers],
    more: &[],
};

/// How far the line is shown behind the COP and beyond the last point, in lengths of Δ.
const BEYOND: f64 = 1.3;

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    /// How high the line's own part is at most, of the width.
    const SHARE: f64 = 0.3;
    let line = Line::find(figure)?;
    let name = line.end.object.map(|id| scenery::name_of(figure.scene, id));
    let argument = Argument::new(sheet, &line, name.as_deref());
    let stops = line.stops();
    let equation = formula("(x, y, z) = ")
        + coordinates(line.to_window.origin)
        + formula(" + t·")
        + coordinates(line.to_window.direction)
        + " … (i)";
    let mut body = body;
    if figure.shows(Layer::Numbers) {
        body = sheet.at(argument.ray, |sheet| sheet.lines(body, &[equation]));
    }
    let scales = scales::height(sheet);
    let height = (body.size().y - scales).min(SHARE * body.size().x);
    let top = body.middle().y - 0.5 * (height + scales);
    let body = Frame {
        min: DVec2::new(body.min.x, top),
        max: DVec2::new(body.max.x, top + height + scales),
    };
    let [above, below] = body.split_top(height);

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
        draw_outline(sheet, &space, outline, Look::OBJECT);
        sheet.at(argument.hit, |sheet| {
            draw_outline(sheet, &space, outline, Look::MET.outline());
        });
    }
    if figure.shows(Layer::Window) {
        let corners = scenery::window_corners(figure.scene).map(|of| projection.of(of));
        let look = Look::OBJECT.wide(1.5);
        rim(sheet, &space, &Rim::Points(corners.into()), look);
    }
    the_line(sheet, &space, &line, &stops, ends, &argument);
    labels(figure, sheet, &space, &line, &stops, &argument);
    scales::draw(sheet, &space, below, (&line, &stops), &argument);
    if figure.shows(Layer::Objects)
        && figure.shows(Layer::Names)
        && let (Some(name), Some(outline)) = (&name, &met)
    {
        scenery::name_at(sheet, &space, &outline.rim, name);
    }
    Ok(in_words(&line, name.as_deref()))
}

fn the_line(
    sheet: &mut Sheet,
    space: &Space,
    line: &Line,
    stops: &[Stop],
    ends: [DVec3; 2],
    argument: &Argument,
) {
    let at = |t: f64| space.place(line.to_window.at(t));
    let [from, to] = ends.map(|end| space.place(end));
    sheet.at(argument.window, |sheet| {
        sheet.line(Look::LINE_OF_RAY, from, to);
    });
    sheet.at(argument.direction, |sheet| {
        sheet.arrow(Look::RAY.wide(3.0), at(0.0), at(1.0));
    });
    sheet.at(argument.hit, |sheet| {
        let hit = line.end.t.map(|t| space.place(line.unit.ray.at(t)));
        sheet.line(Look::RAY, at(1.0), hit.unwrap_or(to));
    });
    for stop in stops {
        let place = space.place(stop.point);
        sheet.at(argument.of(stop), |sheet| match stop.place {
            Place::BehindCop => sheet.ring(Look::RAY.wide(1.5), place),
            Place::Cop | Place::PixelCentre => sheet.dot(Look::RAY, place),
            Place::Hit => sheet.dot(Look::ANSWER, place),
        });
    }
}

fn labels(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    line: &Line,
    stops: &[Stop],
    argument: &Argument,
) {
    // the larger letters of a slide have no room for the coordinates
    let numbers = figure.shows(Layer::Numbers) && sheet.width == Width::Book;
    // the point behind the COP, which has no name, makes way for the others
    let behind = stops.len().min(1);
    for stop in stops[behind..].iter().chain(&stops[..behind]) {
        let place = space.place(stop.point);
        let text = match (numbers, stop.name()) {
            (true, "") => coordinates(stop.point),
            (true, name) => format!("{name} {}", coordinates(stop.point)),
            (false, "") => continue,
            (false, name) => name.into(),
        };
        sheet.at(argument.of(stop), |sheet| {
            // to the right of the hit is the object
            let aside = if stop.place == Place::Hit { -0.4 } else { 0.0 };
            sheet.label(space.frame, place, DVec2::new(aside, -1.0), text);
        });
    }
    sheet.at(argument.direction, |sheet| {
        let middle = space.place(line.to_window.at(0.5));
        let [from, to] = [0.0, 1.0].map(|t| space.place(line.to_window.at(t)));
        // between the lines down from the COP and the pixel's centre, or else without the numbers; the letters of a page are
        // narrower than those that are measured
        let room = from.distance(to);
        let text = formula("Δ = ") + coordinates(line.to_window.direction);
        let is_told = figure.shows(Layer::Numbers) && sheet.width_of(&text) <= room;
        let text = if is_told { text } else { formula("Δ") };
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

fn in_words(line: &Line, name: Option<&str>) -> String {
    let (origin, delta) = (line.to_window.origin, line.to_window.direction);
    let start = format!(
        "The ray starts at the COP {} with Δ = {} of length {}. t is 0 at the COP, negative behind it, and 1 on the \
         window if Δ is not normalised; with |Δ| = 1 the window is at t = {}.",
        coordinates(origin),
        coordinates(delta),
        quantity(delta.length()),
        quantity(line.window_t()),
    );
    match (line.end.t, name) {
        (Some(t), Some(name)) => format!(
            "{start} It hits {name} at t = {}, or {}.",
            quantity(t / line.window_t()),
            quantity(t),
        ),
        _ => format!("{start} It misses all objects."),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, traced};
    use crate::geometry::Ray;
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::trace::{Event, PixelSample, RayEnd, RayStart};

    #[test]
    fn the_points_of_the_line_are_as_far_apart_as_their_t() {
        // Δ = (0, 0, −1): a window at a distance of 1, and a hit at 4
        let scene = scene_of(&[sphere([0.0, 0.0, -5.0], 1.0)]);
        let ray = Ray::new(DVec3::ZERO, DVec3::NEG_Z);
        let sample = PixelSample {
            point: DVec3::NEG_Z,
            ..PixelSample::default()
        };
        let start = RayStart {
            ray,
            window_t: Some(1.0),
            ..RayStart::default()
        };
        let end = RayEnd {
            t: Some(4.0),
            object: Some(PrimitiveId(0)),
            ..RayEnd::default()
        };
        let events = [
            (None, Event::Pixel(sample)),
            (Some(0), Event::Ray(start)),
            (Some(0), Event::RayEnd(end)),
        ];
        let spec = json!({"kind": "line-of-t", "pixel": [0, 0]});
        let drawn = ReadBack::of(spec, traced(scene, events));
        let hits = drawn.dots("answer");
        let [hit] = hits[..] else {
            panic!("{hits:?}");
        };
        // the COP and the pixel's centre are full, −1 is a ring
        let mut dots: Vec<f64> = drawn.dots("ink").iter().map(|at| at.x).collect();
        dots.sort_by(f64::total_cmp);
        let [behind, cop, window] = dots[..] else {
            panic!("{dots:?}");
        };
        let unit = window - cop;
        assert!((hit.x - cop - 4.0 * unit).abs() < 0.05, "{dots:?} {hit}");
        assert!((cop - behind - unit).abs() < 0.03, "{dots:?}");
    }
}
