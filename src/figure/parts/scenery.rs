//! What many kinds of figure show of a scene: objects with their names, the eye, the window, lights.

use glam::{DVec2, DVec3};

use crate::explain::printable;
use crate::figure::parts::outline::{self, Outline, Rim};
use crate::figure::parts::turn::at_angle;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::{Polygon, Sides};
use crate::scene::{Object, Primitive, PrimitiveId, Scene, Shape};

/// The points that show a scene: outlines of all objects, the eye, the window.
pub(in crate::figure) fn points_of(figure: &Figure) -> Vec<DVec3> {
    let mut points = Vec::new();
    for id in &figure.near {
        points.extend(corners(figure.scene.primitive(*id)));
    }
    let camera = &figure.scene.camera;
    if figure.shows(Layer::Eye) || figure.shows(Layer::Ray) {
        points.push(camera.cop);
    }
    if figure.shows(Layer::Window) {
        points.extend(window_corners(figure.scene));
    }
    if figure.shows(Layer::Lights) {
        points.extend(figure.scene.lights.iter().map(|light| light.position));
    }
    points
}

/// The corners of the box around a primitive.
fn corners(primitive: &Primitive) -> [DVec3; 8] {
    let bounds = DVec3::AXES.map(|axis| crate::structure::extent(&primitive.shape, axis));
    std::array::from_fn(|bits| {
        let [x, y, z] = [0, 1, 2].map(|axis| bounds[axis][bits >> axis & 1]);
        DVec3::new(x, y, z)
    })
}

/// All objects, each with the look that is asked for it.
pub(in crate::figure) fn objects(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    look: impl Fn(PrimitiveId) -> Look,
) {
    for id in figure.near.iter().copied() {
        let shape = &figure.scene.primitive(id).shape;
        let outline = Outline::of(shape, &space.projection);
        outline::draw(sheet, space, &outline, look(id));
    }
}

/// Some objects with one look.
pub(in crate::figure) fn some_objects(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    ids: &[PrimitiveId],
    look: Look,
) {
    for id in ids {
        let shape = &figure.scene.primitive(*id).shape;
        outline::draw(sheet, space, &Outline::of(shape, &space.projection), look);
    }
}

/// The names of all objects, each once, in or beside its outline.
pub(in crate::figure) fn names(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    names_of(figure, sheet, space, |_| true);
}

/// The window, the eye and the lights, as far as they are shown.
pub(in crate::figure) fn camera_and_lights(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    if figure.shows(Layer::Window) {
        window(figure, sheet, space);
    }
    if figure.shows(Layer::Eye) {
        eye(figure, sheet, space);
    }
    if figure.shows(Layer::Lights) {
        lights(figure, sheet, space);
    }
}

/// The names of some objects.
pub(in crate::figure) fn names_of(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    is_named: impl Fn(&Object) -> bool,
) {
    for object in &figure.scene.objects {
        let is_drawn = figure.near.binary_search(&object.first).is_ok();
        if object.count == 0 || !is_drawn || !is_named(object) {
            continue;
        }
        let shape = &figure.scene.primitive(object.first).shape;
        let outline = Outline::of(shape, &space.projection);
        name_at(sheet, space, &outline.rim, &short(&object.name));
    }
}

/// A name in the middle of an outline, or at its rim if there is no room.
pub(in crate::figure) fn name_at(sheet: &mut Sheet, space: &Space, rim: &Rim, name: &str) {
    if let Some(middle) = middle_of(space, rim) {
        name_around(sheet, space, (rim, middle), name);
    }
}

/// The middle of what is seen of an outline.
pub(in crate::figure) fn middle_of(space: &Space, rim: &Rim) -> Option<DVec2> {
    let points: Vec<DVec2> = rim
        .points()
        .into_iter()
        .map(|point| space.place_flat(point))
        .collect();
    let seen = space.frame.cut_polygon(&points);
    (!seen.is_empty()).then(|| seen.iter().sum::<DVec2>() / seen.len() as f64)
}

/// The name of an outline with its middle there, or near there if there is no room.
pub(in crate::figure) fn name_around(
    sheet: &mut Sheet,
    space: &Space,
    (rim, middle): (&Rim, DVec2),
    name: &str,
) {
    // a label begins beside its point; from a little left of the middle it comes to stand on it
    let start = middle - DVec2::new(0.5 * sheet.width_of(name) + 0.55 * sheet.letters, 0.0);
    let outline = rim.points().into_iter().map(|at| space.place_flat(at));
    sheet.name(space.frame, start, DVec2::X, (name, outline.collect()));
}

/// A name as a figure has room for it: no control characters, at most some twenty letters.
pub(in crate::figure) fn short(name: &str) -> String {
    /// More would be no label.
    const MOST: usize = 22;
    let name = printable(name);
    if name.chars().count() <= MOST {
        return name;
    }
    let start: String = name.chars().take(MOST - 1).collect();
    format!("{start}…")
}

/// A primitive's name in a sentence: that of its object, and the number of the face in a mesh.
pub(in crate::figure) fn name_of(scene: &Scene, id: PrimitiveId) -> String {
    let (name, face) = scene.name_of(id);
    match face {
        None => short(name),
        Some(face) => format!("{} face {face}", short(name)),
    }
}

/// The eye: a point with the name that the slides give it.
pub(in crate::figure) fn eye(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    let at = space.place(figure.scene.camera.cop);
    if !space.frame.contains(at) {
        return;
    }
    sheet.dot(Look::RAY, at);
    sheet.label(space.frame, at, DVec2::NEG_X, "COP");
}

pub(in crate::figure) fn window_corners(scene: &Scene) -> [DVec3; 4] {
    let camera = &scene.camera;
    let corner = camera.corner();
    [
        corner,
        corner + camera.right,
        corner + camera.right + camera.up,
        corner + camera.up,
    ]
}

/// The window as something that hides what is behind it; `None` where it has no area.
pub(in crate::figure) fn window_pane(scene: &Scene) -> Option<Primitive> {
    let pane = Polygon::new(window_corners(scene).into(), None).ok()?;
    Some(Primitive {
        shape: Shape::Polygon(pane),
        object: 0,
        sides: Sides::Both,
    })
}

/// The window, with its pixels if they are shown: an area, or a line where it is seen from its edge.
pub(in crate::figure) fn window(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    let corners = window_corners(figure.scene).map(|corner| space.projection.of(corner));
    let rim = Rim::Points(corners.into());
    outline::rim(sheet, space, &rim, Look::OBJECT.wide(1.75).outline());
    /// More lines would be an area.
    const MOST: u32 = 64;
    let [width, height] = figure.scene.camera.pixels;
    if figure.shows(Layer::Pixels) && width.max(height) <= MOST {
        let camera = &figure.scene.camera;
        let mut line = |from: [u32; 2], to: [u32; 2]| {
            let ends = [from, to].map(|[x, y]| {
                space
                    .projection
                    .of(camera.window_point(f64::from(x), f64::from(y)))
            });
            outline::line_on(sheet, space, Look::THIN.wide(0.6), &ends);
        };
        for x in 1..width {
            line([x, 0], [x, height]);
        }
        for y in 1..height {
            line([0, y], [width, y]);
        }
    }
    let at = corners.map(|corner| space.place_flat(corner));
    // at its upper end, away from the rays that pass its middle
    let top = at.into_iter().min_by(|a, b| a.y.total_cmp(&b.y));
    if let Some(top) = top.filter(|top| space.frame.contains(*top)) {
        sheet.label(space.frame, top, DVec2::NEG_Y, "window");
    }
}

/// The lights: points with rays around them.
pub(in crate::figure) fn lights(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    for light in &figure.scene.lights {
        let at = space.place(light.position);
        if !space.frame.contains(at) {
            continue;
        }
        let (inner, outer) = (5.0 * sheet.unit(), 9.0 * sheet.unit());
        sheet.circle(Look::THIN.wide(1.5), at, inner);
        for eighth in 0..8 {
            let along = at_angle(f64::from(eighth) * std::f64::consts::FRAC_PI_4);
            sheet.line(Look::THIN.wide(1.5), at + inner * along, at + outer * along);
        }
        let above = at - DVec2::new(0.0, outer);
        sheet.label(space.frame, above, DVec2::NEG_Y, short(&light.name));
    }
}
