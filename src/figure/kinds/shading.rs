//! Where a ray hits a surface: N, L, R and V, and the terms of the shade that a light adds there.
//!
//! I = ambient + light·[colour·diffuse·max(0, N·L) + specular·max(0, R·V)^shininess]

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::angle::{Angle, degrees};
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::trace::{Event, LightTerm, Shade, Visibility};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 340.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Angles, Layer::Numbers],
    more: &[],
};

/// What was recorded at the point, and what follows from it.
struct Point<'a> {
    shade: &'a Shade,
    shade_step: u32,
    light: &'a LightTerm,
    light_step: u32,
    /// V: back along the ray.
    to_viewer: DVec3,
    /// R = 2(N·L)N − L.
    mirrored: DVec3,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    /// Of the width at most; the rest is for the numbers.
    const SHARE: f64 = 0.55;
    let point = find(figure)?;
    let rows = rows(&point);
    let [left, right] = if figure.shows(Layer::Numbers) {
        let numbers = values_begin(sheet, &rows) + widest(sheet, rows.iter().map(|row| &*row.1));
        let gap = sheet.letters;
        let rest = 1.0 - numbers / (body.size().x - gap);
        body.split(rest.clamp(0.0, SHARE), gap)
    } else {
        [body; 2]
    };
    let length = length(figure, &point);
    let space = figure.space(left, around(&point, length));
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |id| {
            if id == point.shade.object {
                Look::ANSWER
            } else {
                Look::OBJECT
            }
        });
    }
    vectors(figure, sheet, &space, &point, length);
    if figure.shows(Layer::Numbers) {
        numbers(sheet, right, rows);
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    Ok(in_words(figure, &point))
}

fn find<'a>(figure: &Figure<'a>) -> Result<Point<'a>, FigureError> {
    let drawn = figure.ray()?;
    let shade = drawn.events.iter().find_map(|record| match &record.event {
        Event::Shade(shade) => Some((shade, record.step)),
        _ => None,
    });
    let (Some((shade, shade_step)), Some(start)) = (shade, drawn.node.start) else {
        return Err(FigureError::new(
            "pixel",
            "the ray hits no object, so no point is shaded",
            "name a pixel, or a \"ray\" of it, that hits an object",
        ));
    };
    let terms = drawn
        .events
        .iter()
        .filter_map(|record| match &record.event {
            Event::LightTerm(term) => Some((term, record.step)),
            _ => None,
        });
    let terms: Vec<_> = terms.collect();
    let counts = |(term, _): &&(&LightTerm, u32)| counts(term);
    let Some(&(light, light_step)) = terms.iter().find(counts).or(terms.first()) else {
        return Err(FigureError::new(
            "scene",
            "the scene has no light, so the shade has no terms to draw",
            "add a light to the scene",
        ));
    };
    let to_light = light.term.to_light;
    Ok(Point {
        shade,
        shade_step,
        light,
        light_step,
        to_viewer: -start.ray.direction,
        mirrored: 2.0 * light.term.n_dot_l * shade.normal - to_light,
    })
}

/// Do the terms of the light count?
fn counts(light: &LightTerm) -> bool {
    matches!(
        light.visibility,
        Visibility::Visible | Visibility::NotTested
    )
}

/// How long a unit vector is drawn: a little more than half the largest side of the object that was hit.
fn length(figure: &Figure, point: &Point) -> f64 {
    const SHARE: f64 = 0.57;
    let shape = &figure.scene.primitive(point.shade.object).shape;
    let sides = DVec3::AXES.map(|axis| {
        let [low, high] = crate::structure::extent(shape, axis);
        high - low
    });
    SHARE * sides.into_iter().fold(0.0, f64::max)
}

/// The ends of the vectors, and some of what is below the surface.
fn around(point: &Point, length: f64) -> [DVec3; 6] {
    let normal = point.shade.normal;
    let below = -0.6 * normal;
    let to_light = point.light.term.to_light;
    // as much of the surface on the other side of N: L and R mirror each other, V has no counterpart
    let opposite = 2.0 * normal.dot(point.to_viewer) * normal - point.to_viewer;
    let ends = [
        normal,
        to_light,
        point.mirrored,
        point.to_viewer,
        opposite,
        below,
    ];
    ends.map(|end| point.shade.point + length * end)
}

fn vectors(figure: &Figure, sheet: &mut Sheet, space: &Space, point: &Point, length: f64) {
    let length = length * space.scale;
    let at = space.place(point.shade.point);
    let (normal, to_light) = (point.shade.normal, point.light.term.to_light);
    let all = [
        (normal, "N", Look::RAY, point.shade_step),
        (to_light, "L", Look::SHADOW_RAY, point.light_step),
        (point.mirrored, "R", Look::REFLECTED_RAY, point.light_step),
        (point.to_viewer, "V", Look::RAY, point.shade_step),
    ];
    for (direction, name, look, step) in all {
        let along = space.direction(direction);
        let end = at + length * along;
        sheet.step(step, |sheet| {
            sheet.arrow(look, at, end);
            sheet.label(space.frame, end, along, name);
        });
    }
    if figure.shows(Layer::Angles) {
        let angle = |sheet: &mut Sheet, between: [DVec3; 2], share: f64, name: &str| {
            let angle = Angle {
                at,
                between: between.map(|of| space.direction(of)),
                radius: share * length / sheet.unit(),
            };
            angle.draw(sheet, space.frame, name);
        };
        // the last of the vectors is there with the shade
        sheet.step(point.shade_step, |sheet| {
            angle(sheet, [normal, to_light], 0.3, "θ");
            angle(sheet, [normal, point.mirrored], 0.3, "θ");
            angle(sheet, [point.mirrored, point.to_viewer], 0.75, "α");
        });
    }
    sheet.dot(Look::ANSWER, at);
}

/// A name, its value, and the step that makes it.
type Row = (&'static str, String, u32);

/// The numbers of the events.
fn rows(point: &Point) -> Vec<Row> {
    let (term, shade) = (&point.light.term, point.shade);
    let (light_step, shade_step) = (point.light_step, point.shade_step);
    let cosine = |name: &str, of: f64| format!("cos {name} = {}", quantity(of));
    let mut rows = vec![
        ("N", "normal".into(), shade_step),
        ("L", "to the light".into(), light_step),
        ("R", "L reflected at N".into(), light_step),
        ("V", "to the viewer".into(), shade_step),
        ("", String::new(), light_step),
        ("N·L", cosine("θ", term.n_dot_l), light_step),
        ("R·V", cosine("α", term.r_dot_v), light_step),
        ("", String::new(), light_step),
        ("ambient", coordinates(shade.ambient), shade_step),
        ("diffuse", coordinates(term.diffuse), light_step),
        ("specular", coordinates(term.specular), light_step),
    ];
    if !counts(point.light) {
        rows.push(("", "in shadow: only ambient".into(), light_step));
    }
    let sum = coordinates(shade.ambient + shade.direct);
    rows.push(("I", sum, shade_step));
    rows
}

fn widest<'a>(sheet: &Sheet, texts: impl Iterator<Item = &'a str>) -> f64 {
    texts.map(|text| sheet.width_of(text)).fold(0.0, f64::max)
}

/// How far from the left the values are, behind the longest name.
fn values_begin(sheet: &Sheet, rows: &[Row]) -> f64 {
    widest(sheet, rows.iter().map(|row| row.0)) + sheet.letters
}

/// The numbers in two columns.
fn numbers(sheet: &mut Sheet, frame: Frame, rows: Vec<Row>) {
    let line = 1.15 * sheet.line_height();
    let column = frame.min.x + values_begin(sheet, &rows);
    let top = frame.middle().y - 0.5 * line * (rows.len() as f64 - 1.0);
    for (i, (name, value, step)) in rows.into_iter().enumerate() {
        let middle = top + i as f64 * line;
        sheet.step(step, |sheet| {
            if name == "I" {
                let rule = middle - 0.5 * line;
                let [from, to] = [frame.min.x, frame.max.x].map(|x| DVec2::new(x, rule));
                sheet.line(Look::THIN, from, to);
            }
            for (x, text) in [(frame.min.x, name.to_owned()), (column, value)] {
                if !text.is_empty() {
                    sheet.text(Anchor::Start, DVec2::new(x, middle), text);
                }
            }
        });
    }
}

fn in_words(figure: &Figure, point: &Point) -> String {
    let (term, shade) = (&point.light.term, point.shade);
    let object = scenery::name_of(figure.scene, shade.object);
    let light = figure.scene.lights.get(point.light.light as usize);
    let light = light.map_or(String::new(), |light| {
        format!(" \"{}\"", scenery::short(&light.name))
    });
    let seen = match point.light.visibility {
        Visibility::Visible => "The light is visible.",
        Visibility::Shadowed => "The light is blocked: the point is in shadow.",
        Visibility::FacesAway => "The surface faces away from the light.",
        Visibility::NotTested => "No shadow ray is cast.",
    };
    format!(
        "On {object} the vector L to light{light} is at {} to the normal: N·L = {}. {seen} \
         The reflected R is at {} to the viewer: R·V = {}. \
         Ambient {}, diffuse {}, specular {}; in sum {}.",
        degrees(term.n_dot_l),
        quantity(term.n_dot_l),
        degrees(term.r_dot_v),
        quantity(term.r_dot_v),
        coordinates(shade.ambient),
        coordinates(term.diffuse),
        coordinates(term.specular),
        coordinates(shade.ambient + shade.direct),
    )
}
