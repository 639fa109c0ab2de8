//! A ray and an ellipsoid, and both in the space in which the ellipsoid is the unit sphere: t stays what it was, but Δ′ has
//! another length, so a = |Δ′|² is not 1 (slides, "Computing Intersection"; erratum 11).
//!
//! Both panels have one scale. The drawing is exact if the ray and the center lie in a plane across the line of sight.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::{parabola, scenery};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::{Ellipsoid, QuadraticTest, Ray, Sphere};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[],
    more: &[],
};

/// A ray and what it is tested against, in one of the two spaces.
struct Panel {
    shape: Shape,
    ray: Ray,
    /// What the shape is, and how long the direction is.
    heading: Text,
    /// Δ or Δ′.
    direction: &'static str,
}

/// The stages, in their order.
struct Argument {
    world: StageId,
    unit: StageId,
    coefficients: StageId,
    roots: StageId,
    wrong: StageId,
}

/// A test with the ellipsoid, and the step at which it was.
struct Found {
    id: PrimitiveId,
    ellipsoid: Ellipsoid,
    ray: Ray,
    test: QuadraticTest,
    step: u32,
}

impl Found {
    fn of(figure: &Figure) -> Result<Self, FigureError> {
        let drawn = figure.ray()?;
        let asked = figure.object()?;
        let found = drawn.events.iter().find_map(|record| {
            let Event::EllipsoidTest { object, test } = record.event else {
                return None;
            };
            let Shape::Ellipsoid(ellipsoid) = figure.scene.primitive(object).shape else {
                return None;
            };
            let has_two = 0.0 < test.a && 0.0 < test.discriminant;
            (has_two && asked.is_none_or(|asked| asked == object)).then_some((
                object,
                ellipsoid,
                test,
                record.step,
            ))
        });
        let (Some((id, ellipsoid, test, step)), Some(start)) = (found, drawn.node.start) else {
            return Err(FigureError::new(
                "pixel",
                "the ray of this pixel has no two roots with an ellipsoid",
                "name a pixel in which it passes through an ellipsoid with axes along x, y and z",
            ));
        };
        Ok(Self {
            id,
            ellipsoid,
            ray: start.ray,
            test,
            step,
        })
    }

    /// The ellipsoid and its ray, and the unit sphere with the stretched one.
    fn panels(&self) -> [Panel; 2] {
        let Ellipsoid { center, radii } = self.ellipsoid;
        let stretched = Ray::new(
            (self.ray.origin - center) / radii,
            self.ray.direction / radii,
        );
        let length = |of: &Ray| quantity(of.direction.length());
        let unit = Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        };
        [
            Panel {
                heading: Text::from("the ellipsoid, ") + formula("|Δ| = ") + length(&self.ray),
                shape: Shape::Ellipsoid(self.ellipsoid),
                ray: self.ray,
                direction: "Δ",
            },
            Panel {
                heading: Text::from("the unit sphere, ") + formula("|Δ′| = ") + length(&stretched),
                shape: Shape::Sphere(unit),
                ray: stretched,
                direction: "Δ′",
            },
        ]
    }

    /// The discriminant of one who takes a for 1.
    fn with_one(&self) -> f64 {
        self.test.b * self.test.b - 4.0 * self.test.c
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let found = Found::of(figure)?;
    let QuadraticTest { a, b, c, .. } = found.test;
    let [a, b, c] = [a, b, c].map(quantity);
    let roots: Vec<(&str, f64)> = parabola::roots(&found.test)
        .into_iter()
        .map(|(name, root)| (name, root.t))
        .collect();
    let told: Vec<String> = roots
        .iter()
        .map(|(name, t)| format!("{name} = {}", quantity(*t)))
        .collect();
    let told = told.join(", ");
    let wrong = found.with_one();
    let so = if wrong < 0.0 {
        "no root"
    } else {
        "other roots"
    };
    let name = scenery::name_of(figure.scene, found.id);
    let sentences = [
        format!("The ray with |Δ| = 1 passes through the ellipsoid {name}."),
        "Everything is divided by the radii, from the center on: the ellipsoid becomes the unit sphere, and Δ gets another length.".into(),
        format!("So a = |Δ′|² = {a} is not 1; b = {b}, c = {c}."),
        format!("The roots {told} are the same in both spaces."),
        format!("With a = 1 the discriminant is {}: {so}.", quantity(wrong)),
    ];
    let step = found.step;
    let [world, unit, coefficients, root, end] = &sentences;
    let argument = Argument {
        world: sheet.stage(Part::Ray, step, world.as_str()),
        unit: sheet.stage("unit sphere", step, unit.as_str()),
        coefficients: sheet.stage(Part::Coefficients, step, coefficients.as_str()),
        roots: sheet.stage(Part::Roots, step, root.as_str()),
        wrong: sheet.stage("a = 1", step, end.as_str()),
    };
    let line = sheet.line_height();
    let [above, below] = body.split_top(body.size().y - 3.6 * line);
    panels(figure, sheet, above, &found, &roots, &argument);
    let below = sheet.at(argument.coefficients, |sheet| {
        let text = formula("a = |Δ′|² = ") + a + formula(",  b = ") + b + formula(",  c = ") + c;
        sheet.lines(below, &[text])
    });
    let below = sheet.at(argument.roots, |sheet| {
        sheet.lines(below, &[formula(&told) + " in both spaces"])
    });
    sheet.at(argument.wrong, |sheet| {
        let text = Text::from("with ") + formula("a = 1: b² - 4c = ") + quantity(wrong) + ", " + so;
        sheet.lines(below, &[text]);
    });
    Ok(sentences.join(" "))
}

/// Both spaces beside each other, on one scale.
fn panels(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    found: &Found,
    roots: &[(&str, f64)],
    argument: &Argument,
) {
    let projection = figure.projection();
    let line = sheet.line_height();
    let last = roots.iter().map(|(_, t)| *t).fold(0.0, f64::max);
    let frames = frame.split(0.58, 2.0 * sheet.letters);
    let panels = found.panels().into_iter().zip(frames);
    let mut laid: Vec<(Panel, Frame, Outline, Space)> = panels
        .map(|(panel, frame)| {
            let [_, room] = frame.split_top(1.3 * line);
            let outline = Outline::of(&panel.shape, &projection);
            let ends = [panel.ray.origin, panel.ray.at(BEYOND * last)];
            let points = ends.map(|at| projection.of(at)).into_iter();
            let points = points.chain(outline.rim.points());
            let room = room.wider(-1.5 * sheet.letters);
            let space = Space::fitted_flat(projection, room, points);
            (panel, frame, outline, space)
        })
        .collect();
    let scales = laid.iter().map(|(.., space)| space.scale);
    let scale = scales.fold(f64::INFINITY, f64::min);
    let stages = [argument.world, argument.unit];
    for ((panel, frame, outline, space), stage) in laid.iter_mut().zip(stages) {
        space.scale = scale;
        sheet.at(stage, |sheet| {
            sheet.lines(*frame, std::slice::from_ref(&panel.heading));
            outline::draw(sheet, space, outline, Look::OBJECT);
            let at = |t: f64| space.place(panel.ray.at(t));
            sheet.line(Look::RAY.wide(1.0), at(0.0), at(BEYOND * last));
            sheet.arrow(Look::RAY.wide(3.0), at(0.0), at(1.0));
            sheet.dot(Look::RAY, at(0.0));
            let across = (at(1.0) - at(0.0)).perp();
            let above = if 0.0 < across.y { -across } else { across };
            sheet.label(*frame, at(0.5), above, formula(panel.direction));
        });
        sheet.at(argument.roots, |sheet| {
            for (place, (name, t)) in roots.iter().enumerate() {
                let at = space.place(panel.ray.at(*t));
                if place == 0 {
                    sheet.dot(Look::ANSWER, at);
                } else {
                    sheet.ring(Look::RAY, at);
                }
                let towards = space.direction(panel.ray.direction).perp();
                let outwards = if towards.y < 0.0 { towards } else { -towards };
                let text = formula(&format!("{name} = ")) + quantity(*t);
                sheet.label(*frame, at, outwards, text);
            }
        });
    }
}

/// The ray is drawn up to this times the last root.
const BEYOND: f64 = 1.15;

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::ReadBack;

    #[test]
    fn a_ray_along_the_long_axis_has_half_its_length_in_the_unit_sphere() {
        // the ray comes along x: (1/2)² = 0.25, whatever its distance
        let objects = json!([{ "name": "A", "material": "m",
            "shape": { "ellipsoid": { "center": [0, 0, 0], "radii": [2, 1, 1] } } }]);
        let spec = json!({ "kind": "stretched", "view": "front" });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        let texts = drawn.texts();
        for part in ["|Δ| = 1", "|Δ′| = 0.5", "a = |Δ′|2 = 0.25"] {
            assert!(
                texts.iter().any(|text| text.contains(part)),
                "{part}: {texts:?}"
            );
        }
    }
}
