//! The window, divided into pixels, and the eye ray from the COP through the centre of one of them (slides, "Ray
//! Tracing/ Ray Casting"). The view plane is arbitrary: it may be tilted, and the window off the axis.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{Rim, line_on, rim};
use crate::figure::parts::{depth, right_angle, scenery};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::Ray;
use crate::scene::{Camera, Primitive, PrimitiveId};
use crate::trace::{Event, RayTree};

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

/// The eye ray through a pixel, with the events of the pixel.
struct EyeRay<'a> {
    pixel: [u32; 2],
    /// Where it passes the window.
    point: DVec3,
    ray: Ray,
    /// The t of what it hits, and what that is.
    hit: Option<(f64, PrimitiveId)>,
    /// The stages of its place on the window, of the ray and of its hit.
    stages: [StageId; 3],
    figure: &'a Figure<'a>,
}

impl<'a> EyeRay<'a> {
    /// The ray, and the stages of its argument.
    fn of(
        figure: &'a Figure<'a>,
        sheet: &mut Sheet,
        pixel: [u32; 2],
    ) -> Result<Option<Self>, FigureError> {
        let records = figure.records_of(pixel)?;
        let point = records.iter().find_map(|record| match &record.event {
            Event::Pixel(sample) => Some((sample.point, record.step)),
            _ => None,
        });
        let tree = RayTree::new(records);
        let (Some((point, step)), Some(node)) = (point, tree.rays.first()) else {
            return Ok(None);
        };
        let (Some(start), Some(end)) = (node.start, node.end) else {
            return Ok(None);
        };
        let hit = end.t.zip(end.object);
        let [starts, ends] = node.ends_at.map(|at| at.map(|at| records[at].step));
        let [x, y] = pixel;
        let so = match hit {
            Some((t, object)) => format!(
                "It hits {} at t = {}.",
                scenery::name_of(figure.scene, object),
                quantity(t)
            ),
            None => "It misses all objects.".into(),
        };
        let through = format!(
            "The ray of pixel ({x}, {y}) passes the window at {}, the centre of the pixel.",
            coordinates(point)
        );
        let stages = [
            sheet.stage(Part::WindowPoint, step, through),
            sheet.stage(
                Part::Ray,
                starts,
                "The eye ray leaves the COP through this point.",
            ),
            sheet.stage(Part::Nearest, ends, so),
        ];
        Ok(Some(Self {
            pixel,
            point,
            ray: start.ray,
            hit,
            stages,
            figure,
        }))
    }

    /// The pixel on the window, with its centre and its number.
    fn mark(&self, sheet: &mut Sheet, space: &Space) {
        let [x, y] = self.pixel;
        let camera = &self.figure.scene.camera;
        let [left, top] = self.pixel.map(f64::from);
        let corners = [
            [left, top],
            [left + 1.0, top],
            [left + 1.0, top + 1.0],
            [left, top + 1.0],
        ];
        let corners = corners.map(|[x, y]| space.projection.of(camera.window_point(x, y)));
        sheet.at(self.stages[0], |sheet| {
            let around = Rim::Points(corners.into());
            rim(sheet, space, &around, Look::VISITED.wide(2.0));
            let at = space.place(self.point);
            let radius = 3.0 * sheet.unit();
            sheet.circle(Look::PAPER_LINE.full(), at, radius);
            sheet.circle(Look::THIN.outline(), at, radius);
            sheet.label(space.frame, at, DVec2::NEG_Y, format!("pixel ({x}, {y})"));
        });
    }

    /// The ray: from the COP a little past the window, then to what it hits. Dotted is what lies behind something.
    fn draw(&self, sheet: &mut Sheet, space: &Space, covers: &[&Primitive]) {
        /// So far past the window, of the way to it.
        const PAST: f64 = 1.3;
        let Some(t) = self.hit.map(|(t, _)| t).or_else(|| space.leaves(&self.ray)) else {
            return;
        };
        let from = self.ray.origin;
        let past = from.lerp(self.point, PAST);
        // not beyond the hit
        let end = self.ray.at(t);
        let past = if from.distance(end) < from.distance(past) {
            end
        } else {
            past
        };
        let look = Look::RAY.in_front();
        sheet.at(self.stages[1], |sheet| {
            depth::arrow(sheet, space, look, [from, past], covers);
            let [at, to] = [past, end].map(|of| space.place(of));
            let across = (to - at).perp();
            let up = if 0.0 < across.y { -across } else { across };
            sheet.label(space.frame, at, up, "eye ray");
        });
        sheet.at(self.stages[2], |sheet| {
            depth::line(sheet, space, look, [past, end], covers);
            if self.hit.is_some() && self.figure.shows(Layer::Hits) {
                sheet.dot(Look::ANSWER, space.place(end));
            }
        });
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let camera = &figure.scene.camera;
    let mut points = scenery::points_of(figure);
    if figure.shows(Layer::Projection) {
        points.extend(plane_corners(camera));
    }
    let space = figure.space(body, points);
    let pixels = figure.pixels();
    if pixels.is_empty() {
        figure.pixel()?;
    }
    let [width, height] = camera.pixels;
    let stands = format!("The window of {width} × {height} pixels stands before the COP.");
    sheet.stage("eye and window", None, stands);
    let mut rays = Vec::new();
    for pixel in pixels {
        rays.extend(EyeRay::of(figure, sheet, pixel)?);
    }
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        for ray in rays.iter().filter(|_| figure.shows(Layer::Hits)) {
            let Some((_, object)) = ray.hit else { continue };
            sheet.at(ray.stages[2], |sheet| {
                scenery::some_objects(figure, sheet, &space, &[object], Look::MET.outline());
            });
        }
    }
    if figure.shows(Layer::Projection) {
        view_plane(sheet, &space, camera);
    }
    if figure.shows(Layer::Window) {
        scenery::window(figure, sheet, &space);
        if figure.shows(Layer::Numbers) {
            numbers(sheet, &space, camera);
        }
    }
    if figure.shows(Layer::Eye) {
        scenery::eye(figure, sheet, &space);
        // beside the perpendicular they would compete with it
        if !figure.shows(Layer::Projection) {
            pyramid(figure, sheet, &space);
        }
    }
    let pane = scenery::window_pane(figure.scene);
    let near = figure.near.iter().map(|id| figure.scene.primitive(*id));
    let covers: Vec<&Primitive> = near.chain(&pane).collect();
    let mut sentences = Vec::new();
    for ray in &rays {
        ray.mark(sheet, &space);
        if figure.shows(Layer::Ray) {
            ray.draw(sheet, &space, &covers);
        }
        sentences.push(in_words(figure, ray));
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

/// The view plane around the window, and the perpendicular on it from the COP.
fn view_plane(sheet: &mut Sheet, space: &Space, camera: &Camera) {
    let corners = plane_corners(camera);
    let flat = corners.map(|of| space.projection.of(of));
    rim(
        sheet,
        space,
        &Rim::Points(flat.into()),
        Look::HELP.wide(0.75),
    );
    let foot = foot(camera);
    let ends = [camera.cop, foot].map(|of| space.projection.of(of));
    line_on(sheet, space, Look::THIN.wide(1.25), &ends);
    sheet.small_dot(Look::RAY, space.place(foot));
    let towards = (camera.corner() + 0.5 * (camera.right + camera.up) - foot).normalize_or_zero();
    // so much of the plane that the right angle has its second side
    let side = 1.6 * sheet.letters / space.scale * towards;
    let ends = [foot, foot + side].map(|of| space.projection.of(of));
    line_on(sheet, space, Look::THIN.wide(1.25), &ends);
    right_angle::draw(sheet, space, foot, [camera.cop - foot, towards]);
    let [cop, at] = [camera.cop, foot].map(|of| space.place(of));
    sheet.label(space.frame, at, at - cop, "foot of the perpendicular");
    let lowest = corners.map(|of| space.place(of));
    if let Some(low) = lowest.into_iter().max_by(|a, b| a.y.total_cmp(&b.y)) {
        sheet.label(space.frame, low, DVec2::Y, "view plane");
    }
}

fn in_words(figure: &Figure, ray: &EyeRay) -> String {
    let [width, height] = figure.scene.camera.pixels;
    let [x, y] = ray.pixel;
    let so = ray.hit.map_or("misses all objects".into(), |(_, id)| {
        format!("hits {}", scenery::name_of(figure.scene, id))
    });
    format!(
        "The window has {width} × {height} pixels. The eye ray from the COP through the centre of pixel ({x}, {y}) \
         {so}."
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::figure::read_back::{ReadBack, traced};
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::trace::{PixelSample, RayEnd, RayStart};

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
    #[test]
    fn the_hit_lies_four_times_as_far_from_the_cop_as_the_pixel() {
        let scene = scene_of(&[sphere([2.0, 0.0, -5.0], 1.0)]);
        // through a point of the window, which lies 1 ahead, to one that is four times as far away
        let point = DVec3::new(0.5, 0.0, -1.0);
        let sample = PixelSample {
            point,
            ..PixelSample::default()
        };
        let start = RayStart {
            ray: Ray::new(DVec3::ZERO, point),
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
        let spec = json!({"kind": "window", "pixel": [0, 0], "view": "axonometric"});
        let drawn = ReadBack::of(spec, traced(scene, events));
        let near = |at: DVec2| drawn.dots("ink").iter().any(|of| of.distance(at) < 0.05);
        let [hit] = drawn.dots("answer")[..] else {
            panic!("{:?}", drawn.dots("answer"));
        };
        // the pixel's ring has ground inside; a parallel projection keeps the shares of a line
        let pixels = drawn.dots("paper");
        let [pixel] = pixels[..] else {
            panic!("{pixels:?}");
        };
        let cop = pixel + (pixel - hit) / 3.0;
        assert!(near(cop), "no COP at {cop}");
    }
}
