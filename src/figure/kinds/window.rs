//! The window, divided into pixels, and the eye ray from the COP through the centre of one of them (slides, "Ray
//! Tracing/ Ray Casting"). The view plane is arbitrary: it may be tilted, and the window off the axis.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{Rim, line_on, rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::scene::Camera;
use crate::trace::{Event, RayNode, RayTree, Record};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Eye,
        Layer::Window,
        Layer::Pixels,
        Layer::Ray,
        Layer::Hits,
        Layer::Numbers,
    ],
    more: &[Layer::Projection],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let mut points = scenery::points_of(figure);
    if figure.shows(Layer::Projection) {
        points.extend(plane_corners(&figure.scene.camera));
    }
    let space = figure.space(body, points);
    let pixels = figure.pixels();
    if pixels.is_empty() {
        figure.pixel()?;
    }
    let mut rays = Vec::new();
    for [x, y] in pixels {
        let records = figure.records_of([x, y])?;
        rays.push(([x, y], records, RayTree::new(records)));
    }
    let met = rays
        .iter()
        .filter_map(|(_, _, tree)| tree.rays.first()?.end?.object);
    let met: Vec<_> = met.collect();

    if figure.shows(Layer::Objects) {
        scenery::objects_met(figure, sheet, &space, &met);
    }
    if figure.shows(Layer::Projection) {
        view_plane(sheet, &space, &figure.scene.camera);
    }
    if figure.shows(Layer::Window) {
        scenery::window(figure, sheet, &space);
        if figure.shows(Layer::Numbers) {
            numbers(sheet, &space, &figure.scene.camera);
        }
    }
    if figure.shows(Layer::Eye) {
        scenery::eye(figure, sheet, &space);
        pyramid(figure, sheet, &space);
    }
    let mut sentences = Vec::new();
    for (pixel, records, tree) in &rays {
        mark(figure, sheet, &space, *pixel, records);
        if let Some(eye_ray) = tree.rays.first()
            && figure.shows(Layer::Ray)
        {
            sheet.step(eye_ray.ends_at[0].map(|at| records[at].step), |sheet| {
                ray(figure, sheet, &space, records, eye_ray);
            });
        }
        sentences.push(in_words(figure, *pixel, tree));
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    Ok(sentences.join(" "))
}

/// Lines from the COP to the window's corners: all eye rays run between them.
fn pyramid(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    for corner in scenery::window_corners(figure.scene) {
        let ends = [figure.scene.camera.cop, corner].map(|of| space.projection.of(of));
        line_on(sheet, space, Look::HELP.wide(0.75), &ends);
    }
}

/// The place on the window that is looked through, as it was recorded.
fn place_on_window(records: &[Record]) -> Option<(DVec3, u32)> {
    records.iter().find_map(|record| match &record.event {
        Event::Pixel(sample) => Some((sample.point, record.step)),
        _ => None,
    })
}

/// Marks a pixel on the window, its centre and its number.
fn mark(figure: &Figure, sheet: &mut Sheet, space: &Space, [x, y]: [u32; 2], records: &[Record]) {
    let Some((point, step)) = place_on_window(records) else {
        return;
    };
    let camera = &figure.scene.camera;
    let [left, top] = [x, y].map(f64::from);
    let corners = [
        [left, top],
        [left + 1.0, top],
        [left + 1.0, top + 1.0],
        [left, top + 1.0],
    ];
    let corners = corners.map(|[x, y]| space.projection.of(camera.window_point(x, y)));
    sheet.step(step, |sheet| {
        rim(
            sheet,
            space,
            &Rim::Points(corners.into()),
            Look::VISITED.wide(2.0),
        );
        let at = space.place(point);
        sheet.circle(Look::VISITED.inside().full(), at, 3.0 * sheet.unit());
        sheet.label(space.frame, at, DVec2::NEG_Y, format!("pixel ({x}, {y})"));
    });
}

fn ray(figure: &Figure, sheet: &mut Sheet, space: &Space, records: &[Record], node: &RayNode) {
    let (Some(start), Some(end)) = (node.start, node.end) else {
        return;
    };
    let from = space.place(start.ray.origin);
    let Some(t) = end.t.or_else(|| space.leaves(&start.ray)) else {
        return;
    };
    let to = space.place(start.ray.at(t));
    let Some([from, to]) = space.frame.cut_line([from, to]) else {
        return;
    };
    let is_hit = figure.shows(Layer::Hits) && end.t.is_some();
    let head = if is_hit { 4.0 * sheet.unit() } else { 0.0 };
    sheet.arrow(Look::RAY, from, to - head * (to - from).normalize_or_zero());
    if is_hit {
        sheet.dot(Look::ANSWER, to);
    }
    // beyond the window, where the lines to its corners end
    let window = place_on_window(records).map_or(from, |(point, _)| space.place(point));
    let across = (to - from).perp();
    let up = if 0.0 < across.y { -across } else { across };
    sheet.label(space.frame, window.lerp(to, 0.6), up, "eye ray");
}

/// How pixels are counted: the first is at the upper left, the last at the lower right.
fn numbers(sheet: &mut Sheet, space: &Space, camera: &Camera) {
    let [right, bottom] = camera.pixels.map(|side| side - 1);
    for (x, y, towards) in [(0, 0, DVec2::NEG_Y), (right, bottom, DVec2::Y)] {
        let middle = camera.window_point(f64::from(x) + 0.5, f64::from(y) + 0.5);
        sheet.label(
            space.frame,
            space.place(middle),
            towards,
            format!("({x}, {y})"),
        );
    }
}

/// The foot of the perpendicular from the COP to the view plane.
fn foot(camera: &Camera) -> DVec3 {
    let normal = camera.right.cross(camera.up).normalize_or_zero();
    camera.cop + camera.to_corner.dot(normal) * normal
}

/// A part of the view plane that holds the window and the foot of the perpendicular from the COP.
fn plane_corners(camera: &Camera) -> [DVec3; 4] {
    /// Around them, of the window's sides.
    const ROOM: f64 = 0.2;
    let foot = foot(camera) - camera.corner();
    // the foot in shares of the window's sides, which need not be at right angles
    let (right, up) = (camera.right, camera.up);
    let (rr, ru, uu) = (right.dot(right), right.dot(up), up.dot(up));
    let (fr, fu) = (foot.dot(right), foot.dot(up));
    let area = rr * uu - ru * ru;
    let shares = [(fr * uu - fu * ru) / area, (fu * rr - fr * ru) / area];
    let [[left, rightmost], [low, high]] =
        shares.map(|share| [share.min(0.0) - ROOM, share.max(1.0) + ROOM]);
    [
        [left, low],
        [rightmost, low],
        [rightmost, high],
        [left, high],
    ]
    .map(|[a, b]| camera.corner() + a * right + b * up)
}

/// The view plane around the window, and how the COP lies before it.
fn view_plane(sheet: &mut Sheet, space: &Space, camera: &Camera) {
    let corners = plane_corners(camera);
    let flat = corners.map(|of| space.projection.of(of));
    rim(sheet, space, &Rim::Points(flat.into()), Look::HELP);
    let foot = foot(camera);
    let ends = [camera.cop, foot].map(|of| space.projection.of(of));
    line_on(sheet, space, Look::HELP, &ends);
    right_angle(sheet, space, camera, foot);
    let lowest = corners.map(|of| space.place(of));
    if let Some(low) = lowest.into_iter().max_by(|a, b| a.y.total_cmp(&b.y)) {
        sheet.label(space.frame, low, DVec2::Y, "view plane");
    }
}

/// The sign of a right angle between the view plane and the perpendicular.
fn right_angle(sheet: &mut Sheet, space: &Space, camera: &Camera, foot: DVec3) {
    /// How long its sides are, in letters.
    const SIDE: f64 = 0.7;
    let length = SIDE * sheet.letters / space.scale;
    let middle = camera.corner() + 0.5 * (camera.right + camera.up);
    let back = length * (camera.cop - foot).normalize_or_zero();
    let along = length * (middle - foot).normalize_or_zero();
    let corners = [foot + back, foot + back + along, foot + along];
    sheet.path(Look::THIN, corners.map(|of| space.place(of)).into());
}

fn in_words(figure: &Figure, [x, y]: [u32; 2], tree: &RayTree) -> String {
    let [width, height] = figure.scene.camera.pixels;
    let met = tree.rays.first().and_then(|node| node.end?.object);
    let met = met.map_or("misses all objects".into(), |id| {
        format!("hits {}", scenery::name_of(figure.scene, id))
    });
    format!(
        "The window has {width} × {height} pixels. The eye ray from the COP through the centre of pixel ({x}, {y}) \
         {met}."
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_view_plane_holds_the_window_and_the_foot_of_the_cop() {
        // the plane z = 2 before a COP at the origin: the foot (0, 0, 2) is one width left of the window, and in the
        // middle of its height
        let camera = Camera {
            cop: DVec3::ZERO,
            to_corner: DVec3::new(2.0, -1.0, 2.0),
            right: DVec3::new(2.0, 0.0, 0.0),
            up: DVec3::new(0.0, 2.0, 0.0),
            pixels: [2, 2],
        };
        assert_eq!(foot(&camera), DVec3::new(0.0, 0.0, 2.0));
        // from −1 − 0.2 to 1.2 widths, from −0.2 to 1.2 heights
        let corners = plane_corners(&camera);
        let close = |a: DVec3, b: [f64; 3]| (a - DVec3::from(b)).length() < 1e-12;
        assert!(close(corners[0], [-0.4, -1.4, 2.0]), "{}", corners[0]);
        assert!(close(corners[2], [4.4, 1.4, 2.0]), "{}", corners[2]);
    }
}
