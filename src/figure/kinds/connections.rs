//! A path of light and a path from the eye, each vertex of one joined to each of the other by a line (slides, "Type
//! of Ray Tracing Algorithm": hybrid with connecting lines).

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Section;
use crate::figure::view::Space;
use crate::scene::PrimitiveId;
use crate::trace::{Connection, Event, Purpose, Record};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 460.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Eye,
        Layer::Window,
        Layer::Lights,
        Layer::LightPaths,
        Layer::Ray,
        Layer::Connections,
        Layer::Numbers,
        Layer::Legend,
    ],
    more: &[],
};

/// A path with its vertices, from the light or from the eye.
#[derive(Default)]
struct Walk {
    /// Where it begins, then each surface that it hits, with the step at which it does.
    vertices: Vec<(Option<u32>, DVec3)>,
    objects: Vec<PrimitiveId>,
}

/// A line between two vertices.
struct Line<'a> {
    step: u32,
    connection: &'a Connection,
    /// What stands between, and where.
    blocked: Option<(PrimitiveId, DVec3)>,
}

impl Walk {
    /// The path in some records of a section.
    fn of(section: &Section, records: &[Record]) -> Self {
        let mut walk = Self::default();
        for record in records {
            match &record.event {
                Event::Ray(start) if walk.vertices.is_empty() => {
                    walk.vertices.push((None, start.ray.origin));
                }
                Event::Photon(photon) => {
                    walk.vertices
                        .push((Some(section.step(record)), photon.point));
                    walk.objects.push(photon.object);
                }
                _ => {}
            }
        }
        walk
    }
}

impl<'a> Line<'a> {
    /// The lines in some records of a section.
    fn all(section: &Section<'a>, records: &'a [Record]) -> Vec<Self> {
        let mut lines = Vec::new();
        let mut ray = None;
        let mut blocked = None;
        for record in records {
            match &record.event {
                Event::Ray(start) => {
                    blocked = None;
                    ray = (start.purpose == Purpose::Connection).then_some(start.ray);
                }
                Event::RayEnd(end) => {
                    let at = ray.zip(end.t).map(|(ray, t)| ray.at(t));
                    blocked = end.object.zip(at);
                }
                Event::Connection(connection) => lines.push(Self {
                    step: section.step(record),
                    connection,
                    blocked,
                }),
                _ => {}
            }
        }
        lines
    }
}

/// What is drawn.
struct Both<'a> {
    light: Walk,
    eye: Walk,
    lines: Vec<Line<'a>>,
}

impl<'a> Both<'a> {
    fn of(figure: &Figure<'a>) -> Result<Self, FigureError> {
        let pixel = figure.section_of(figure.pixel()?)?;
        let begins = |_: &Record, next: &Record| !matches!(next.event, Event::Pixel(_));
        let of_pixel = |records: &'a [Record]| Some((records, path_of(records)?));
        let found = pixel.records.chunk_by(begins).find_map(of_pixel);
        let paths = figure.first.paths();
        let light = found.and_then(|(_, number)| {
            let is_it = |of: &&Section| of.records[0].path == Some(number);
            paths.iter().find(is_it)
        });
        let (Some((records, _)), Some(light)) = (found, light) else {
            return Err(FigureError::new(
                "pixel",
                "no path of light was connected with a path from the eye at this pixel",
                "add \"transport\": \"hybrid-connected\", and name a pixel that shows a diffuse surface",
            ));
        };
        let mut lines = Line::all(light, light.records);
        lines.extend(Line::all(&pixel, records));
        Ok(Self {
            light: Walk::of(light, light.records),
            eye: Walk::of(&pixel, records),
            lines,
        })
    }

    /// The line whose working is shown: of those between two surfaces the one that adds most.
    fn worked(&self) -> Option<&Line<'a>> {
        let adds = |line: &&Line| line.connection.contribution.max_element();
        let is_between = |line: &&Line| {
            let ends = [line.connection.light_vertex, line.connection.eye_vertex];
            line.connection.visible && ends.iter().all(|vertex| 0 < *vertex)
        };
        let mut between = self.lines.iter().filter(is_between);
        let first = between.next()?;
        Some(between.fold(first, |most, line| {
            if adds(&most) < adds(&line) {
                line
            } else {
                most
            }
        }))
    }
}

/// The stages, in their order.
struct Argument {
    light: StageId,
    eye: StageId,
    free: Option<StageId>,
    blocked: Option<StageId>,
    worked: Option<StageId>,
}

impl Argument {
    fn new(figure: &Figure, sheet: &mut Sheet, both: &Both) -> Self {
        let last = |walk: &Walk| walk.vertices.iter().filter_map(|(step, _)| *step).max();
        let light = sheet.stage(
            "path of light",
            last(&both.light),
            format!("A path of light from x₀ hits {}.", met(figure, &both.light)),
        );
        let eye_step = last(&both.eye);
        let eye = sheet.stage(
            "path from the eye",
            eye_step,
            format!("A path from the eye y₀ hits {}.", met(figure, &both.eye)),
        );
        let of = |visible: bool| {
            let lines = both
                .lines
                .iter()
                .filter(move |line| line.connection.visible == visible);
            let told: Vec<String> = lines
                .clone()
                .map(|line| line_in_words(figure, line))
                .collect();
            // no line is there before both of its paths
            let step = lines.map(|line| line.step).max().max(eye_step);
            (!told.is_empty()).then(|| (step, told.join("; ")))
        };
        let mut latest = eye_step;
        let mut stage = |name: &'static str, told: Option<(Option<u32>, String)>| {
            let (step, told) = told?;
            latest = step.max(latest);
            Some(sheet.stage(name, latest, format!("{told}.")))
        };
        let free = stage("connecting lines", of(true));
        let blocked = stage("blocked lines", of(false));
        let worked = both.worked().map(|line| {
            let [geometry, weight] = working(line.connection);
            let step = Some(line.step).max(latest);
            sheet.stage("geometry term", step, format!("{geometry}; {weight}."))
        });
        Self {
            light,
            eye,
            free,
            blocked,
            worked,
        }
    }
}

/// The objects that a path hits, in order.
fn met(figure: &Figure, walk: &Walk) -> String {
    let names = walk
        .objects
        .iter()
        .map(|id| scenery::name_of(figure.scene, *id));
    names.collect::<Vec<_>>().join(", then ")
}

/// The path of light that a path from the eye was connected to.
fn path_of(records: &[Record]) -> Option<u32> {
    records.iter().find_map(|record| match &record.event {
        Event::Connection(connection) => Some(connection.path),
        _ => None,
    })
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let both = Both::of(figure)?;
    let worked = both.worked();
    let argument = Argument::new(figure, sheet, &both);
    let body = match (worked, argument.worked) {
        (Some(line), Some(stage)) if figure.shows(Layer::Numbers) => sheet.at(stage, |sheet| {
            let [geometry, weight] = working(line.connection);
            let [prose, value] = weight.split_at(weight.find("w(").unwrap_or(0)).into();
            sheet.lines(
                body,
                &[formula(&geometry), Text::from(prose) + formula(value)],
            )
        }),
        _ => body,
    };
    let body = if figure.shows(Layer::Legend) {
        let mut entries = vec![
            (Some(argument.light), Look::LIGHT_RAY, "path of light"),
            (Some(argument.eye), Look::RAY, "path from the eye"),
        ];
        if argument.free.is_some() {
            entries.push((argument.free, Look::CONNECTION, "connecting line"));
        }
        if argument.blocked.is_some() {
            entries.push((argument.blocked, Look::BLOCKED_CONNECTION, "blocked"));
        }
        sheet.staged_legend(body, &entries)
    } else {
        body
    };
    let vertices = both.light.vertices.iter().chain(&both.eye.vertices);
    let mut points = scenery::points_of(figure);
    points.extend(vertices.map(|(_, at)| *at));
    let space = figure.space(body, points);
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    }
    scenery::camera_and_lights(figure, sheet, &space);
    sheet.within(space.frame, |sheet| {
        if figure.shows(Layer::LightPaths) {
            sheet.at(argument.light, |sheet| {
                walk(sheet, &space, &both.light, Look::LIGHT_RAY, "x");
            });
        }
        if figure.shows(Layer::Ray) {
            sheet.at(argument.eye, |sheet| {
                walk(sheet, &space, &both.eye, Look::RAY, "y");
            });
        }
        if figure.shows(Layer::Connections) {
            for line in &both.lines {
                let stage = if line.connection.visible {
                    argument.free
                } else {
                    argument.blocked
                };
                if let Some(stage) = stage {
                    sheet.at(stage, |sheet| connecting_line(sheet, &space, line));
                }
            }
        }
        if let (Some(line), Some(stage)) = (worked, argument.worked) {
            sheet.at(stage, |sheet| {
                let [from, to] =
                    [line.connection.from, line.connection.to].map(|at| space.place(at));
                let across = (to - from).perp().normalize_or_zero();
                // in the place of the line that was there
                sheet.line(Look::PAPER_LINE.wide(4.0), from, to);
                sheet.line(WORKED, from, to);
                sheet.label(space.frame, from.lerp(to, 0.4), across, formula("G"));
            });
        }
    });
    // after the vertices, which stand where they stand
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    Ok(in_words(figure, &both))
}

/// The connecting line whose working is shown: its pattern tells it from a path where there are no colours.
const WORKED: Look = Look {
    dash: Dash::TwoDots,
    ..Look::ANSWER.outline()
};

/// A path from vertex to vertex, each with its name.
fn walk(sheet: &mut Sheet, space: &Space, walk: &Walk, look: Look, name: &str) {
    let mut before: Option<DVec2> = None;
    for (number, (step, at)) in walk.vertices.iter().enumerate() {
        sheet.step(*step, |sheet| {
            let at = space.place(*at);
            let head = 4.0 * sheet.unit();
            let mut along = DVec2::ZERO;
            if let Some(before) = before {
                along = (at - before).normalize_or_zero();
                sheet.arrow(look, before, at - head * along);
            }
            sheet.dot(look, at);
            let towards = if along == DVec2::ZERO {
                DVec2::NEG_X
            } else {
                along
            };
            sheet.label(space.frame, at, towards, formula(&vertex(name, number)));
            before = Some(at);
        });
    }
}

/// x₀, x₁, … as the slides write indices.
fn vertex(name: &str, number: usize) -> String {
    let digit = |digit: char| digit.to_digit(10).and_then(|d| char::from_u32(0x2080 + d));
    let index: String = number.to_string().chars().filter_map(digit).collect();
    format!("{name}{index}")
}

fn connecting_line(sheet: &mut Sheet, space: &Space, line: &Line) {
    sheet.step(line.step, |sheet| {
        let ends = [line.connection.from, line.connection.to].map(|at| space.place(at));
        match line.blocked {
            Some((_, at)) if !line.connection.visible => {
                sheet.line(Look::BLOCKED_CONNECTION, ends[0], ends[1]);
                sheet.cross(Look::REJECTED, space.place(at));
            }
            _ => sheet.line(Look::CONNECTION, ends[0], ends[1]),
        }
    });
}

/// The names of the ends of a line.
fn ends(connection: &Connection) -> [String; 2] {
    let light = vertex("x", connection.light_vertex.into());
    let eye = vertex("y", connection.eye_vertex.into());
    [light, eye]
}

/// The geometry term of a line, and what comes of it.
fn working(connection: &Connection) -> [String; 2] {
    let [x, y] = ends(connection);
    let [cos_x, cos_y] = connection.cosines.map(quantity);
    let distance = quantity(connection.from.distance(connection.to));
    [
        format!(
            "G({x}, {y}) = cos θ · cos θ′ / d² = {cos_x} · {cos_y} / {distance}² = {}",
            quantity(connection.geometry())
        ),
        format!(
            "weight by the balance heuristic: w({x}, {y}) = {}",
            quantity(connection.weight)
        ),
    ]
}

fn in_words(figure: &Figure, both: &Both) -> String {
    let blocked = both.lines.iter().filter(|line| !line.connection.visible);
    let mut sentences = vec![
        format!("A path of light from x₀ hits {}.", met(figure, &both.light)),
        format!("A path from the eye y₀ hits {}.", met(figure, &both.eye)),
        format!(
            "Connecting lines between their vertices: {}, of which {} blocked.",
            both.lines.len(),
            blocked.count()
        ),
    ];
    let each: Vec<String> = both
        .lines
        .iter()
        .map(|line| line_in_words(figure, line))
        .collect();
    sentences.push(format!("{}.", each.join("; ")));
    if let Some(line) = both.worked() {
        let [geometry, weight] = working(line.connection);
        sentences.push(format!("{geometry}; {weight}."));
    }
    sentences.join(" ")
}

fn line_in_words(figure: &Figure, line: &Line) -> String {
    let [x, y] = ends(line.connection);
    match line.blocked {
        Some((object, _)) if !line.connection.visible => {
            let object = scenery::name_of(figure.scene, object);
            format!("{x} to {y} is blocked by {object}")
        }
        _ => format!("{x} to {y} is free"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_has_its_number_below_the_line() {
        assert_eq!(vertex("x", 0), "x₀");
        assert_eq!(vertex("y", 12), "y₁₂");
    }

    #[test]
    fn the_working_of_a_line_is_that_of_its_event() {
        // two surfaces at a right angle, 2 apart: 0.6 · 0.8 / 4 = 0.12
        let connection = Connection {
            light_vertex: 1,
            eye_vertex: 2,
            from: DVec3::ZERO,
            to: DVec3::new(0.0, 2.0, 0.0),
            cosines: [0.6, 0.8],
            visible: true,
            weight: 0.25,
            ..Connection::default()
        };
        assert_eq!(
            working(&connection),
            [
                "G(x₁, y₂) = cos θ · cos θ′ / d² = 0.6 · 0.8 / 2² = 0.12",
                "weight by the balance heuristic: w(x₁, y₂) = 0.25"
            ]
        );
    }
}
