//! All cases of equation (v), each in a panel: the plane ahead of the ray, behind its origin, parallel beside it, and with the
//! ray in it (slides, "Computing Intersection"; erratum 12).
//!
//! The planes are seen from their edge if they contain the direction of view: across the ray and the camera's up.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};
use crate::geometry::{PlaneTest, PlaneVerdict, Polygon, Ray, RootVerdict};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 430.0,
    usual: &[],
    more: &[],
};

/// A polygon whose plane is tested.
struct Case<'a> {
    polygon: &'a Polygon,
    test: PlaneTest,
    step: u32,
    name: String,
}

impl Case<'_> {
    /// Numerator and denominator, 0 where they are 0 but for rounding.
    fn numbers(&self) -> [String; 2] {
        let PlaneTest {
            numerator,
            denominator,
            ..
        } = self.test;
        let [numerator, denominator] = [numerator, denominator].map(quantity);
        match self.test.verdict {
            PlaneVerdict::Meets(_) => [numerator, denominator],
            PlaneVerdict::ParallelBeside => [numerator, "0".into()],
            PlaneVerdict::ParallelWithin => ["0".into(), "0".into()],
        }
    }

    /// t with its verdict.
    fn verdict(&self) -> Text {
        match self.test.verdict {
            PlaneVerdict::Meets(root) => {
                let so = match root.verdict {
                    RootVerdict::Chosen => " > 0: the hit",
                    RootVerdict::Behind => " < 0: behind the origin",
                    _ => ": does not count",
                };
                formula("t = ") + quantity(root.t) + so
            }
            PlaneVerdict::ParallelBeside => {
                Text::from("no ") + formula("t") + ": parallel, beside it"
            }
            PlaneVerdict::ParallelWithin => {
                Text::from("each ") + formula("t") + ": the ray lies in it"
            }
        }
    }

    fn sentence(&self) -> String {
        let [numerator, denominator] = self.numbers();
        let so = match self.test.verdict {
            PlaneVerdict::Meets(root) => {
                let so = match root.verdict {
                    RootVerdict::Chosen => "the ray hits the plane",
                    RootVerdict::Behind => {
                        "the line hits the plane behind the origin, and the ray does not"
                    }
                    _ => "the hit does not count",
                };
                format!("t = {}: {so}", quantity(root.t))
            }
            PlaneVerdict::ParallelBeside => "no t: the ray is parallel, beside the plane".into(),
            PlaneVerdict::ParallelWithin => "the ray lies in the plane: no single t".into(),
        };
        format!(
            "{}: numerator {numerator}, denominator {denominator}; {so}.",
            self.name
        )
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    /// More would be too small.
    const MOST: usize = 4;
    let drawn = figure.ray()?;
    let polygon = |id: PrimitiveId| match &figure.scene.primitive(id).shape {
        Shape::Polygon(polygon) => Some(polygon),
        _ => None,
    };
    let cases = drawn.events.iter().filter_map(|record| match record.event {
        Event::PlaneTest { object, test } => Some(Case {
            polygon: polygon(object)?,
            test,
            step: record.step,
            name: scenery::name_of(figure.scene, object),
        }),
        _ => None,
    });
    let cases: Vec<Case> = cases.take(MOST).collect();
    let (Some(start), false) = (drawn.node.start, cases.is_empty()) else {
        return Err(FigureError::new(
            "pixel",
            "the ray of this pixel is tested against no polygon",
            "name a pixel of a scene that has polygons",
        ));
    };
    let [starts, _] = figure.steps_of(&drawn)?;
    let first = sheet.stage(
        Part::Ray,
        starts,
        "The same ray R is tested against the planes of several polygons.",
    );
    let stages: Vec<StageId> = cases
        .iter()
        .map(|case| sheet.stage(Part::PlaneT, case.step, case.sentence()))
        .collect();
    let rest = sheet.lines(body, &[header(sheet)]);
    let points = extent(&cases, &start.ray);
    let projection = Projection::new(start.ray.direction, figure.scene.camera.up);
    for (number, (case, stage)) in cases.iter().zip(stages).enumerate() {
        let frame = panel(sheet, rest, number, cases.len());
        one(
            sheet,
            frame,
            (case, &start.ray),
            (projection, &points),
            [first, stage],
        );
    }
    let sentences: Vec<String> = cases.iter().map(Case::sentence).collect();
    Ok(sentences.join(" "))
}

/// (v) with its two parts.
fn header(sheet: &Sheet) -> Text {
    let of = formula("t = ") + "−numerator/denominator";
    match sheet.width {
        Width::Book => {
            of + " = " + formula("-(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz)") + " … (v)"
        }
        Width::Slide => of + " … (v)",
    }
}

/// The frame of a panel, two in a row.
fn panel(sheet: &Sheet, frame: Frame, number: usize, count: usize) -> Frame {
    let gap = DVec2::new(2.0, 0.6) * sheet.letters;
    let rows = count.div_ceil(2) as f64;
    let size = (frame.size() + gap) / DVec2::new(2.0, rows) - gap;
    let place = DVec2::new((number % 2) as f64, (number / 2) as f64);
    let min = frame.min + place * (size + gap);
    Frame {
        min,
        max: min + size,
    }
}

/// What all panels show, so that they have one scale.
fn extent(cases: &[Case], ray: &Ray) -> Vec<DVec3> {
    let vertices = cases.iter().flat_map(|case| case.polygon.vertices());
    let along = vertices
        .clone()
        .map(|at| (at - ray.origin).dot(ray.direction));
    let last = along.fold(0.0, f64::max);
    vertices.chain([ray.origin, ray.at(1.25 * last)]).collect()
}

/// A panel: the two numbers and their verdict, and the ray with the plane.
fn one(
    sheet: &mut Sheet,
    frame: Frame,
    (case, ray): (&Case, &Ray),
    (projection, points): (Projection, &[DVec3]),
    [first, stage]: [StageId; 2],
) {
    let line = sheet.line_height();
    let [words, drawing] = frame.split_top(2.0 * line);
    let [numerator, denominator] = case.numbers();
    let name = format!("{}: ", case.name);
    let numbers = match sheet.width {
        Width::Book => {
            Text::from(name + "numerator " + &numerator + ", denominator " + &denominator)
        }
        Width::Slide => {
            Text::from(name + "−" + &in_brackets(&numerator) + "/" + &in_brackets(&denominator))
        }
    };
    sheet.at(stage, |sheet| {
        for (row, text) in [numbers, case.verdict()].into_iter().enumerate() {
            let at = words.min + DVec2::new(0.0, (row as f64 + 0.5) * line);
            sheet.text(Anchor::Start, at, text);
        }
    });
    let space = Space::fitted(projection, drawing, points.iter().copied());
    let place = |point: DVec3| space.place(point);
    let edge = space.leaves(ray).unwrap_or(1.0);
    let hit = match case.test.verdict {
        PlaneVerdict::Meets(root) => Some(root),
        _ => None,
    };
    sheet.within(drawing, |sheet| {
        plane(sheet, &space, case, ray);
        sheet.at(first, |sheet| {
            sheet.dot(Look::RAY, place(ray.origin));
            let half = hit.filter(|root| 0.0 < root.t).map_or(edge, |root| root.t);
            sheet.arrow(
                Look::RAY,
                place(ray.origin),
                place(ray.at(0.5 * half.min(edge))),
            );
            sheet.label(
                drawing,
                place(ray.at(0.25 * half.min(edge))),
                DVec2::NEG_Y,
                formula("R"),
            );
        });
        sheet.at(stage, |sheet| {
            let Some(root) = hit else {
                sheet.arrow(Look::RAY, place(ray.origin), place(ray.at(edge)));
                return;
            };
            let at = place(ray.at(root.t));
            if root.verdict == RootVerdict::Chosen {
                sheet.line(Look::RAY, place(ray.origin), at);
                sheet.dot(Look::ANSWER, at);
            } else {
                sheet.arrow(Look::RAY, place(ray.origin), place(ray.at(edge)));
                sheet.line(Look::LINE_OF_RAY, place(ray.origin), at);
                sheet.cross(Look::REJECTED, at);
            }
            sheet.label(
                drawing,
                at,
                DVec2::new(1.0, 1.0),
                formula("t = ") + quantity(root.t),
            );
        });
    });
}

fn in_brackets(number: &str) -> String {
    if number.starts_with('−') {
        format!("({number})")
    } else {
        number.into()
    }
}

/// The polygon from its edge, its plane beyond it, and its normal.
fn plane(sheet: &mut Sheet, space: &Space, case: &Case, ray: &Ray) {
    let flat: Vec<DVec3> = case.polygon.vertices().collect();
    let normal = case.test.plane.normal;
    let along = normal.cross(space.projection.towards()).normalize_or_zero();
    let middle = flat.iter().sum::<DVec3>() / flat.len() as f64;
    let reach = flat.iter().map(|at| (at - middle).dot(along).abs());
    let reach = reach.fold(0.0, f64::max);
    let far = 100.0 * (reach + middle.distance(ray.origin));
    let end = |by: f64| space.place(middle + by * along);
    sheet.line(Look::HELP.wide(0.75), end(-far), end(far));
    sheet.line(Look::MET.outline().wide(4.0), end(-reach), end(reach));
    let at = middle + 0.6 * reach * along;
    let tip = space.place(at) + 2.2 * sheet.letters * space.direction(normal);
    sheet.arrow(Look::THIN, space.place(at), tip);
    // a slide has room for one of them
    let is_hit = matches!(case.test.verdict, PlaneVerdict::Meets(root) if root.verdict == RootVerdict::Chosen);
    if sheet.width == Width::Slide && !is_hit {
        return;
    }
    // beside it: beyond its tip may be the ray
    let beside = -space.direction(normal).perp();
    sheet.label(
        space.frame,
        space.place(at).midpoint(tip),
        beside,
        formula("(A, B, C)"),
    );
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::figure::read_back::{DRAWN, ReadBack};

    fn polygon(name: &str, vertices: &Value) -> Value {
        json!({ "name": name, "material": "m", "shape": { "polygon": { "vertices": vertices } } })
    }

    #[test]
    fn each_case_has_its_two_numbers_and_its_place_on_the_ray() {
        // the ray starts in (−10, 0, 0) and goes along x
        let objects = json!([
            polygon(
                "A",
                &json!([[-6, -1, -1], [-6, 1, -1], [-6, 1, 1], [-6, -1, 1]])
            ),
            polygon(
                "B",
                &json!([[-12, -1, -1], [-12, 1, -1], [-12, 1, 1], [-12, -1, 1]])
            ),
            polygon(
                "C",
                &json!([[-9, -1, -1], [-7, -1, -1], [-7, -1, 1], [-9, -1, 1]])
            ),
            polygon(
                "D",
                &json!([[-9, 0, -1], [-7, 0, -1], [-7, 0, 1], [-9, 0, 1]])
            ),
        ]);
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, json!({"kind": "plane-cases"}));
        let texts = drawn.texts();
        // A: x = −6 with (A, B, C) = (1, 0, 0), so numerator −10 + 6 and denominator 1; C faces down: −(0 − −1)
        for part in [
            "A: numerator −4, denominator 1",
            "t = 4 > 0: the hit",
            "B: numerator 2, denominator 1",
            "t = −2 < 0: behind the origin",
            "C: numerator −1, denominator 0",
            "D: numerator 0, denominator 0",
        ] {
            assert!(texts.iter().any(|text| text == part), "{part}: {texts:?}");
        }
        let [hit] = drawn.dots("answer")[..] else {
            panic!("one hit");
        };
        let [behind] = drawn.crosses("rejected")[..] else {
            panic!("one behind");
        };
        // both panels have one scale: from their origins 4 ahead and 2 behind
        let origins = drawn.dots("ink");
        let first = origins[0];
        let second = origins.iter().find(|at| first.x + 1.0 < at.x).unwrap();
        let [ahead, back] = [hit.x - first.x, second.x - behind.x];
        assert!((ahead - 2.0 * back).abs() < 3.0 * DRAWN, "{ahead} {back}");
    }
}
