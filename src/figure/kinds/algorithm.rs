//! The pseudocode of Fig. 15.56 beside the scene, line by line: what each line does with the eye ray of one pixel.
//!
//! The lines are those at the top of `tracer/simple.rs`, which a test compares.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::{Colour, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::Text;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::Ray;
use crate::scene::PrimitiveId;
use crate::trace::{Event, Record};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Eye, Layer::Window],
    more: &[],
};

/// Fig. 15.56.
const LINES: [&str; 11] = [
    "select center of projection and window on viewplane;",
    "for (each scan line in image) {",
    "  for (each pixel in scan line) {",
    "    determine ray from center of projection through pixel;",
    "    for (each object in scene) {",
    "      if (object is intersected and is closest considered thus far)",
    "        record intersection and object name;",
    "    }",
    "    set pixel's color to that at closest object intersection;",
    "  }",
    "}",
];

/// The lines that a figure lights, by their places.
const SELECT: usize = 0;
const PIXEL: usize = 2;
const DETERMINE: usize = 3;
const IF: usize = 5;
const RECORD: usize = 6;
const SET: usize = 8;

/// An object that the eye ray is tested against.
struct Tested {
    object: PrimitiveId,
    step: u32,
    /// The t of the hit that is recorded; none if it is not the closest.
    recorded: Option<f64>,
}

/// A stage, and the line that runs.
struct Running {
    line: usize,
    stage: StageId,
}

#[expect(clippy::too_many_lines, reason = "the drawing from top to bottom")]
fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let [x, y] = figure.pixel()?;
    let records = figure.records()?;
    let drawn = figure.ray()?;
    let Some(start) = drawn.node.start else {
        return Err(FigureError::new(
            "pixel",
            "the log has no eye ray of this pixel",
            "trace it again",
        ));
    };
    let tested = tested(&drawn.events);
    let step_of = |is: fn(&Event) -> bool| {
        let found = records.iter().find(|record| is(&record.event));
        found.map(|record| record.step)
    };
    let [starts, _] = figure.steps_of(&drawn)?;
    let mut running = Vec::new();
    let mut run = |sheet: &mut Sheet, line, name: &'static str, step: Option<u32>, said: String| {
        let stage = sheet.stage(name, step, said);
        running.push(Running { line, stage });
        stage
    };
    let window = run(
        sheet,
        SELECT,
        "window",
        None,
        "The eye and the window are chosen.".into(),
    );
    let pixel = run(
        sheet,
        PIXEL,
        "pixel",
        step_of(|event| matches!(event, Event::Pixel(_))),
        format!("The two loops select scan line {y} and pixel {x} in it."),
    );
    let ray = run(
        sheet,
        DETERMINE,
        Part::Ray.name(),
        starts,
        format!("The ray of pixel ({x}, {y}) starts at the COP and passes the pixel's centre."),
    );
    let mut tests = Vec::new();
    for test in &tested {
        let name = scenery::name_of(figure.scene, test.object);
        let (line, said) = match test.recorded {
            Some(t) => (
                RECORD,
                format!(
                    "{name} is hit at t = {}, the closest thus far: it is recorded.",
                    quantity(t)
                ),
            ),
            None => (
                IF,
                format!("{name} is not hit, or not closer: nothing is recorded."),
            ),
        };
        tests.push(run(
            sheet,
            line,
            Part::Nearest.name(),
            Some(test.step),
            said,
        ));
    }
    let closest = drawn.node.end.and_then(|end| end.object);
    let set = run(
        sheet,
        SET,
        Part::PixelColour.name(),
        step_of(|event| matches!(event, Event::PixelColour(_))),
        match closest {
            Some(id) => format!(
                "The pixel has the colour at the closest intersection, on {}.",
                scenery::name_of(figure.scene, id)
            ),
            None => "No object is hit: the pixel has the colour of the background.".into(),
        },
    );

    let share = match sheet.width {
        Width::Book => 0.56,
        Width::Slide => 0.58,
    };
    let [left, right] = body.split(share, sheet.letters);
    code(sheet, left, &running);
    let space = figure.space(right, scenery::points_of(figure));
    scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    scenery::names(figure, sheet, &space);
    sheet.at(window, |sheet| {
        scenery::camera_and_lights(figure, sheet, &space);
    });
    the_ray(sheet, &space, &start.ray, ray);
    for (test, stage) in tested.iter().zip(&tests) {
        sheet.at(*stage, |sheet| {
            let look = if test.recorded.is_some() {
                Look::MET
            } else {
                Look::REJECTED
            };
            scenery::some_objects(figure, sheet, &space, &[test.object], look.outline());
            if let Some(t) = test.recorded {
                let at = space.place(start.ray.at(t));
                sheet.line(Look::RAY, space.place(start.ray.origin), at);
                sheet.small_dot(Look::RAY, at);
            }
        });
    }
    if let Some(t) = drawn.node.end.and_then(|end| end.t) {
        sheet.at(set, |sheet| {
            sheet.dot(Look::ANSWER, space.place(start.ray.at(t)));
        });
    }
    colour(figure, sheet, &space, records, [pixel, set]);
    let told: Vec<String> = sheet
        .stages
        .iter()
        .map(|stage| stage.sentence.clone())
        .collect();
    Ok(format!(
        "The pseudocode of Fig. 15.56 beside the scene. {}",
        told.join(" ")
    ))
}

/// The objects that the ray is tested against, each with the last event of its test.
fn tested(events: &[&Record]) -> Vec<Tested> {
    let mut all: Vec<Tested> = Vec::new();
    for record in events {
        let object = match record.event {
            Event::SphereTest { object, .. }
            | Event::EllipsoidTest { object, .. }
            | Event::ConeTest { object, .. }
            | Event::BoxTest { object, .. }
            | Event::PlaneTest { object, .. }
            | Event::PolygonTest { object, .. } => object,
            Event::Nearest(nearest) => nearest.object,
            _ => continue,
        };
        if all.last().is_none_or(|last| last.object != object) {
            all.push(Tested {
                object,
                step: record.step,
                recorded: None,
            });
        }
        if let Some(last) = all.last_mut() {
            last.step = record.step;
            if let Event::Nearest(nearest) = record.event {
                last.recorded = Some(nearest.t);
            }
        }
    }
    // a figure has a dozen stages at most
    const MOST: usize = 7;
    all.truncate(MOST);
    all
}

/// The ray as far as nothing is known: to the window and a little beyond.
fn the_ray(sheet: &mut Sheet, space: &Space, ray: &Ray, stage: StageId) {
    let edge = space.leaves(ray).unwrap_or(1.0);
    let [from, to] = [ray.origin, ray.at(0.45 * edge)].map(|at| space.place(at));
    sheet.at(stage, |sheet| {
        sheet.arrow(Look::RAY, from, to);
        sheet.dot(Look::RAY, from);
    });
}

/// A square below the window: empty as long as the pixel has no colour.
fn colour(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    records: &[Record],
    [pixel, set]: [StageId; 2],
) {
    let corners = scenery::window_corners(figure.scene).map(|corner| space.place(corner));
    let lowest = corners.into_iter().max_by(|a, b| a.y.total_cmp(&b.y));
    let found = records.iter().find_map(|record| match record.event {
        Event::PixelColour(colour) => Some(colour.clamped),
        _ => None,
    });
    let (Some(low), Some(colour)) = (lowest, found) else {
        return;
    };
    let half = 0.6 * sheet.letters;
    let middle = low + DVec2::new(0.0, 2.0 * half);
    let square = Frame {
        min: middle - half,
        max: middle + half,
    };
    sheet.at(pixel, |sheet| {
        sheet.rectangle(Look::THIN, square);
        let beside = middle + DVec2::new(half, 0.0);
        sheet.label(space.frame, beside, DVec2::X, "pixel");
    });
    sheet.at(set, |sheet| {
        let rgb = (colour.clamp(DVec3::ZERO, DVec3::ONE) * 255.0).round();
        let rgb = rgb.to_array().map(|of| of as u8);
        let colour = Image::new([1, 1], vec![Some(rgb)]).in_squares();
        sheet.image(square, colour);
        sheet.rectangle(Look::THIN, square);
    });
}

/// The lines of the code. Beside each that has run stand the numbers of its stages; the arrow stands at the one that runs.
fn code(sheet: &mut Sheet, frame: Frame, running: &[Running]) {
    let indent = match sheet.width {
        Width::Book => 0.6,
        Width::Slide => 0.45,
    } * sheet.letters;
    let gutter = 1.6 * sheet.letters;
    let mut rows: Vec<(usize, f64, Text)> = Vec::new();
    for (place, line) in LINES.iter().enumerate() {
        let text = line.trim_start();
        // a slide has no room for lines of a bracket alone
        if sheet.width == Width::Slide && text == "}" {
            continue;
        }
        let depth = (line.len() - text.len()) as f64 * indent;
        let room = (frame.size().x - gutter - depth) / sheet.letters;
        for (part, text) in Text::from(text).wrapped(room).into_iter().enumerate() {
            let hanging = if part == 0 { 0.0 } else { sheet.letters };
            rows.push((place, depth + hanging, text));
        }
    }
    let height = (frame.size().y / rows.len() as f64).min(sheet.line_height());
    let y = |row: usize| frame.min.y + (row as f64 + 0.5) * height;
    let row_of = |line: usize| rows.iter().position(|(place, ..)| *place == line);
    for (row, (_, depth, text)) in rows.iter().enumerate() {
        let at = DVec2::new(frame.min.x + gutter + depth, y(row));
        sheet.text(Anchor::Start, at, text);
    }
    let mut before: Option<f64> = None;
    for of in running {
        let Some(row) = row_of(of.line) else { continue };
        let tip = DVec2::new(frame.min.x + gutter - 0.3 * sheet.letters, y(row));
        sheet.at(of.stage, |sheet| {
            if let Some(y) = before {
                // the arrow has gone on from here
                let half = DVec2::new(0.0, 0.45 * height);
                let left = DVec2::new(frame.min.x - 1.0, y);
                let right = DVec2::new(tip.x + 1.0, y);
                let (min, max) = (left - half, right + half);
                let paper = Look {
                    colour: Colour::Paper,
                    ..Look::OBJECT.inside().full()
                };
                sheet.rectangle(paper, Frame { min, max });
                sheet.small_dot(Look::THIN, DVec2::new(tip.x - 0.3 * sheet.letters, y));
            }
            sheet.arrow(
                Look::VISITED.outline().wide(3.0),
                DVec2::new(frame.min.x, tip.y),
                tip,
            );
        });
        before = Some(tip.y);
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::LINES;
    use crate::figure::read_back::{ReadBack, ball};

    #[test]
    fn the_lines_are_those_of_the_simple_tracer() {
        let source = include_str!("../../tracer/simple.rs");
        let block = source.split("//! ```").nth(1).unwrap();
        let lines = block.lines().filter_map(|line| line.strip_prefix("//! "));
        let lines: Vec<&str> = lines.collect();
        assert_eq!(lines, LINES);
    }

    #[test]
    fn each_object_is_a_stage_and_the_last_one_sets_the_colour() {
        // A is hit at t = 9; B lies behind it, and C beside the ray
        let objects = json!([
            ball("A", [0.0, 0.0, 0.0], 1.0),
            ball("B", [5.0, 0.0, 0.0], 1.0),
            ball("C", [0.0, 2.0, 0.0], 1.0)
        ]);
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, json!({"kind": "algorithm"}));
        // one arrow for each of the three lines before, the three objects, and the last line
        let heads = drawn.paths("visited");
        let heads: Vec<_> = heads.iter().filter(|points| points.len() == 3).collect();
        assert_eq!(heads.len(), 7);
        let y = |number: usize| heads[number][0].y;
        // A at the line below the `if`, the others at the `if`
        assert!(y(4) < y(3) && y(4) == y(5) && y(3) < y(6));
        assert_eq!(drawn.dots("answer").len(), 1);
    }
}
