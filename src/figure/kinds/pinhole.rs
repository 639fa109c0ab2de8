//! The pinhole camera (Fig. 12-1): a closed box with a tiny hole in its front panel, and on its back panel the negative
//! with the inverted image. The pinhole is the COP; as far before it as the negative is behind it stands the window,
//! with the same image upright.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::line_on;
use crate::figure::parts::{depth, scenery};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Space, View};
use crate::scene::{Camera, Primitive, PrimitiveId};
use crate::trace::{Event, RayTree};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 360.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Window,
        Layer::Pixels,
        Layer::Ray,
        Layer::Numbers,
    ],
    more: &[],
};

/// A point of an object, and its images.
struct Seen {
    pixel: [u32; 2],
    object: PrimitiveId,
    point: DVec3,
    on_window: DVec3,
    on_negative: DVec3,
    step: u32,
}

/// The stages, in their order.
struct Argument {
    /// Of each point the light through the pinhole, and the eye ray.
    points: Vec<[StageId; 2]>,
    images: StageId,
}

impl Argument {
    fn new(figure: &Figure, sheet: &mut Sheet, seen: &[Seen]) -> Self {
        sheet.stage(
            "camera",
            None,
            "The camera is a closed box with a tiny hole in its front panel: the COP.",
        );
        let last = seen.iter().map(|of| of.step).max();
        let has_window = figure.shows(Layer::Window);
        let points = seen.iter().zip(NAMES).map(|(of, name)| {
            let object = scenery::name_of(figure.scene, of.object);
            let light = format!(
                "Light from the point {name} of {object} passes the pinhole and hits the negative at {name}″."
            );
            let on_window = if has_window {
                format!(" and passes the window at {name}′")
            } else {
                String::new()
            };
            let eye = format!("The eye ray runs along the same line in the other direction{on_window}.");
            [
                sheet.stage("light", last, light),
                sheet.stage("eye ray", last, eye),
            ]
        });
        let points = points.collect();
        let images = sheet.stage(
            "images",
            last,
            if has_window {
                "The image on the negative is upside down, and that on the window is upright and equally large."
            } else {
                "The image on the negative is upside down."
            },
        );
        Self { points, images }
    }
}

/// What the points are called, in the order of the pixels.
const NAMES: [&str; 6] = ["P", "Q", "S", "U", "G", "H"];

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let camera = &figure.scene.camera;
    let seen = find(figure)?;
    let case = Case::around(camera);
    let mut points = scenery::points_of(figure);
    points.extend(case.corners);
    points.push(camera.cop);
    let has_distances = figure.shows(Layer::Numbers) && figure.spec.view == View::Along;
    let room = if has_distances {
        1.7 * sheet.line_height()
    } else {
        0.0
    };
    let [body, _] = body.split_top(body.size().y - room);
    let space = figure.space(body, points);
    let is_edge_on = is_edge_on(&space, camera);
    let argument = Argument::new(figure, sheet, &seen);

    case.draw(sheet, &space, camera.cop, is_edge_on);
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    }
    if figure.shows(Layer::Pixels) && !is_edge_on {
        sheet.at(argument.images, |sheet| picture(figure, sheet, &space));
    }
    panels(figure, sheet, &space);
    if figure.shows(Layer::Ray) {
        for ((of, name), stages) in seen.iter().zip(NAMES).zip(&argument.points) {
            line(figure, sheet, &space, (of, name), *stages);
        }
    }
    sheet.at(argument.images, |sheet| {
        images(sheet, &space, &seen, is_edge_on);
        if has_distances {
            distances(sheet, &space, camera, &case);
        }
    });
    words(figure, sheet, &space, camera, &case);
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    let sentences: Vec<String> = seen.iter().map(|of| in_words(figure, of)).collect();
    Ok(sentences.join(" "))
}

fn find(figure: &Figure) -> Result<Vec<Seen>, FigureError> {
    figure.pixel()?;
    let mut seen = Vec::new();
    for pixel in figure.pixels() {
        let [x, y] = pixel;
        if seen.len() == NAMES.len() {
            return Err(FigureError::new(
                "pixels",
                format!(
                    "more than {} lines through one pinhole cannot be told apart",
                    NAMES.len()
                ),
                "name fewer pixels",
            ));
        }
        let records = figure.records_of(pixel)?;
        let tree = RayTree::new(records);
        let sample = records.iter().find_map(|record| match &record.event {
            Event::Pixel(sample) => Some(sample.point),
            _ => None,
        });
        let node = tree.rays.first();
        let met = node.and_then(|node| {
            let (start, end) = (node.start?, node.end?);
            let point = start.ray.at(end.t?);
            Some((end.object?, point, records[node.ends_at[1]?].step))
        });
        let (Some(on_window), Some((object, point, step))) = (sample, met) else {
            return Err(FigureError::new(
                "pixels",
                format!(
                    "the eye ray through pixel {x},{y} hits no object, so there is no point whose image can be drawn"
                ),
                "name a pixel that shows an object",
            ));
        };
        seen.push(Seen {
            pixel,
            object,
            point,
            on_window,
            on_negative: behind(&figure.scene.camera, on_window),
            step,
        });
    }
    Ok(seen)
}

/// Where the line from a point of the window through the pinhole meets the negative, which is as far behind the
/// pinhole as the window is before it: at the point's mirror image in the pinhole.
fn behind(camera: &Camera, on_window: DVec3) -> DVec3 {
    2.0 * camera.cop - on_window
}

/// Is the window seen from its edge?
fn is_edge_on(space: &Space, camera: &Camera) -> bool {
    let normal = camera.right.cross(camera.up).normalize_or_zero();
    // less than a degree from it
    normal.dot(space.projection.towards()).abs() < 0.017
}

/// The closed box: its back panel around the negative, the pinhole in the middle of its front panel.
struct Case {
    /// The back panel's, then the front panel's, in the same order around.
    corners: [DVec3; 8],
}

impl Case {
    fn around(camera: &Camera) -> Self {
        /// Around the negative, of its sides.
        const ROOM: f64 = 0.15;
        let mirrored = |x: f64, y: f64| {
            let at = camera.to_corner + x * camera.right + y * camera.up;
            camera.cop - at
        };
        let (low, high) = (-ROOM, 1.0 + ROOM);
        let back = [(low, low), (high, low), (high, high), (low, high)];
        let back = back.map(|(x, y)| mirrored(x, y));
        let depth = camera.cop - mirrored(0.5, 0.5);
        let corners = std::array::from_fn(|i| match back.get(i) {
            Some(corner) => *corner,
            None => back[i - 4] + depth,
        });
        Self { corners }
    }

    /// The three edges that lie behind the box are dotted; the front panel has a hole.
    fn draw(&self, sheet: &mut Sheet, space: &Space, pinhole: DVec3, is_edge_on: bool) {
        let towards = space.projection.towards();
        let far = (0..8).min_by(|&a, &b| {
            let depth = |i: usize| towards.dot(self.corners[i]);
            depth(a).total_cmp(&depth(b))
        });
        let at = self.corners.map(|corner| space.projection.of(corner));
        let look = Look::OBJECT.outline().wide(1.75);
        let mut edges: Vec<[usize; 2]> = Vec::with_capacity(12);
        for i in 0..4 {
            edges.extend([[i, (i + 1) % 4], [i, i + 4]]);
            // seen from its edge the front panel has a gap at the pinhole
            if !is_edge_on {
                edges.push([i + 4, (i + 1) % 4 + 4]);
            }
        }
        for [from, to] in edges {
            let is_hidden = !is_edge_on && (Some(from) == far || Some(to) == far);
            let look = if is_hidden { Look::HIDDEN } else { look };
            line_on(sheet, space, look, &[at[from], at[to]]);
        }
        let hole = space.place(pinhole);
        if !is_edge_on {
            let front = self.corners[4..].iter().map(|of| space.place(*of));
            sheet.polygon(Look::OBJECT.inside(), front.collect());
            sheet.circle(Look::THIN.wide(1.5), hole, 3.5 * sheet.unit());
            return;
        }
        let gap = 3.5 * sheet.unit();
        for corner in &self.corners[4..] {
            let end = space.place(*corner);
            let along = (end - hole).normalize_or_zero();
            sheet.line(look, end, hole + gap * along);
        }
    }
}

/// The picture on the window, and upside down on the negative.
fn picture(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    let Some(image) = figure.first.picture() else {
        return;
    };
    let camera = &figure.scene.camera;
    let [width, height] = camera.pixels.map(f64::from);
    let corners = [(0.0, 0.0), (width, 0.0), (0.0, height)];
    let window = corners.map(|(x, y)| camera.window_point(x, y));
    let negative = window.map(|corner| behind(camera, corner));
    let place = |corners: [DVec3; 3]| corners.map(|corner| space.place(corner));
    sheet.image_in(place(negative), image.clone());
    if figure.shows(Layer::Window) {
        sheet.image_in(place(window), image);
    }
}

/// The rims of the negative and the window.
fn panels(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    let camera = &figure.scene.camera;
    let window = scenery::window_corners(figure.scene);
    let negative = window.map(|corner| behind(camera, corner));
    let place = |corners: [DVec3; 4]| corners.map(|corner| space.place(corner)).to_vec();
    sheet.polygon(Look::THIN.wide(1.25), place(negative));
    if figure.shows(Layer::Window) {
        sheet.polygon(Look::THIN.wide(1.75), place(window));
    }
}

/// The line through the pinhole: first the light from the point to the negative, then the eye ray to the point.
fn line(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    (of, name): (&Seen, &str),
    [light, eye]: [StageId; 2],
) {
    let pane = scenery::window_pane(figure.scene).filter(|_| figure.shows(Layer::Window));
    let near = figure.near.iter().map(|id| figure.scene.primitive(*id));
    let covers: Vec<&Primitive> = near.chain(&pane).collect();
    let cop = figure.scene.camera.cop;
    let [point, window, pinhole, negative] =
        [of.point, of.on_window, cop, of.on_negative].map(|at| space.place(at));
    let along = (point - pinhole).normalize_or_zero();
    let label = |sheet: &mut Sheet, at: DVec2, towards: DVec2, prime: &str| {
        sheet.label(space.frame, at, towards, formula(&format!("{name}{prime}")));
    };
    sheet.at(light, |sheet| {
        // the heads stand where the light is on its way
        let half = of.point.lerp(cop, 0.3);
        depth::arrow(sheet, space, Look::LIGHT_RAY, [of.point, half], &covers);
        depth::line(sheet, space, Look::LIGHT_RAY, [half, cop], &covers);
        sheet.arrow(Look::LIGHT_RAY, pinhole, negative);
        sheet.dot(Look::RAY, point);
        // beside the object, on the side from which its ray comes
        let beside = DVec2::new(-along.x, along.y.signum());
        label(sheet, point, beside, "");
        label(sheet, negative, -along, "″");
    });
    sheet.at(eye, |sheet| {
        depth::arrow(sheet, space, Look::RAY, [cop, of.point], &covers);
        if figure.shows(Layer::Window) {
            sheet.dot(Look::RAY, window);
            label(sheet, window, DVec2::new(1.0, along.y.signum()), "′");
        }
    });
}

/// From the image of the first point to that of the last, where the image itself is seen from its edge.
fn images(sheet: &mut Sheet, space: &Space, seen: &[Seen], is_edge_on: bool) {
    let ([first, .., last], true) = (seen, is_edge_on) else {
        return;
    };
    let look = Look::RAY.wide(4.0);
    let images = [
        ([last, first].map(|of| of.on_window), "upright"),
        ([last, first].map(|of| of.on_negative), "upside down"),
    ];
    for (ends, word) in images {
        let [from, to] = ends.map(|end| space.place(end));
        sheet.arrow(look, from, to);
        let aside = DVec2::new((to - from).y.signum(), 0.0);
        sheet.label(space.frame, from.midpoint(to), -aside, word);
    }
}

/// Below the box and the window: both are at the same distance from the pinhole.
fn distances(sheet: &mut Sheet, space: &Space, camera: &Camera, case: &Case) {
    let normal = camera.right.cross(camera.up).normalize_or_zero();
    let distance = camera.to_corner.dot(normal).abs();
    let lowest = case.corners.map(|corner| space.place(corner).y);
    let y = lowest.into_iter().fold(f64::NEG_INFINITY, f64::max) + 1.2 * sheet.letters;
    let offset = camera.to_corner.dot(normal) * normal;
    let x = [-1.0, 0.0, 1.0].map(|side| space.place(camera.cop + side * offset).x);
    let tick = 4.0 * sheet.unit();
    let text = quantity(distance);
    let has_room = sheet.width_of(&text) + 0.5 * sheet.letters <= (x[2] - x[0]).abs() / 2.0;
    for pair in x.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(|x| DVec2::new(x, y));
        sheet.line(Look::THIN, from, to);
        if has_room {
            let below = from.lerp(to, 0.5) + DVec2::new(0.0, 0.9 * sheet.letters);
            sheet.text(Anchor::Middle, below, text.as_str());
        }
    }
    if !has_room {
        // once, and beside both
        let end = DVec2::new(x[0].max(x[2]), y);
        sheet.label(sheet.body(), end, DVec2::X, format!("{text} each"));
    }
    for x in x {
        let [from, to] = [-tick, tick].map(|by| DVec2::new(x, y + by));
        sheet.line(Look::THIN, from, to);
    }
}

fn words(figure: &Figure, sheet: &mut Sheet, space: &Space, camera: &Camera, case: &Case) {
    let top = |corners: &[DVec3]| {
        let places = corners.iter().map(|corner| space.place(*corner));
        places
            .min_by(|a, b| a.y.total_cmp(&b.y))
            .unwrap_or_default()
    };
    let pinhole = space.place(camera.cop);
    // below the eye rays, beside the box
    sheet.label(space.frame, pinhole, DVec2::new(0.5, 1.0), "pinhole = COP");
    sheet.label(
        space.frame,
        top(&case.corners[..4]),
        DVec2::NEG_Y,
        "negative",
    );
    if figure.shows(Layer::Window) {
        let window = scenery::window_corners(figure.scene);
        sheet.label(space.frame, top(&window), DVec2::NEG_Y, "window");
    }
}

fn in_words(figure: &Figure, of: &Seen) -> String {
    let [x, y] = of.pixel;
    let object = scenery::name_of(figure.scene, of.object);
    let [_, height] = figure.scene.camera.pixels;
    // rows are counted from the top; on the negative the first is the lowest
    let [here, there] = if 2 * y < height {
        ["upper", "lower"]
    } else {
        ["lower", "upper"]
    };
    format!(
        "A point of {object} is in the {here} half of the window, in pixel ({x}, {y}); the same line hits the \
         negative in its {there} half."
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::figure::read_back::{ReadBack, traced};
    use crate::geometry::Ray;
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::trace::{PixelSample, RayEnd, RayStart};

    fn camera() -> Camera {
        // the window z = 3 before a COP at (0, 1, 5), 2 × 1
        Camera {
            cop: DVec3::new(0.0, 1.0, 5.0),
            to_corner: DVec3::new(-1.0, -0.5, -2.0),
            right: DVec3::new(2.0, 0.0, 0.0),
            up: DVec3::new(0.0, 1.0, 0.0),
            pixels: [4, 2],
        }
    }

    #[test]
    fn the_image_behind_the_pinhole_is_turned_round() {
        // upper left on the window, lower right on the negative, as seen from behind it
        let upper_left = camera().window_point(0.0, 0.0);
        assert_eq!(upper_left, DVec3::new(-1.0, 1.5, 3.0));
        assert_eq!(behind(&camera(), upper_left), DVec3::new(1.0, 0.5, 7.0));
    }

    #[test]
    fn the_pinhole_is_in_the_middle_of_the_front_panel() {
        let case = Case::around(&camera());
        let middle = case.corners[4..].iter().sum::<DVec3>() / 4.0;
        assert!((middle - camera().cop).length() < 1e-12, "{middle}");
        assert!(
            case.corners[..4]
                .iter()
                .all(|corner| (corner.z - 7.0).abs() < 1e-12)
        );
    }
    #[test]
    fn the_image_of_a_point_is_as_far_behind_the_pinhole_as_its_pixel_is_before_it() {
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
        let spec =
            json!({"kind": "pinhole", "pixel": [0, 0], "show": ["objects", "window", "ray"]});
        let drawn = ReadBack::of(spec, traced(scene, events));
        let near = |at: DVec2| drawn.dots("ink").iter().any(|of| of.distance(at) < 0.05);
        // the light's last head has its tip in P″
        let heads = drawn.paths("light");
        let heads: Vec<_> = heads.iter().filter(|points| points.len() == 3).collect();
        let ends: Vec<DVec2> = heads.iter().map(|head| head[0]).collect();
        // P is 4 from the pinhole, P′ 1, and P″ −1: five halves of the way from P″ to P′ lead to P
        let is_image = |&end: &DVec2| {
            drawn.dots("ink").iter().any(|&on_window| {
                let way = on_window - end;
                30.0 < way.length() && near(end + 2.5 * way)
            })
        };
        assert!(
            ends.iter().any(is_image),
            "{ends:?}: {:?}",
            drawn.dots("ink")
        );
    }
}
