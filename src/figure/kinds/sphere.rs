//! A ray and a sphere: the roots of equation (iii), the parabola that they are the zeros of, the normal
//! (slides, "Computing Intersection").
//!
//! The left part is exact if the ray and the center lie in the plane that the view shows.

use glam::{DVec2, DVec3};

use crate::explain::MINUS;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::parabola;
use crate::figure::parts::scenery;
use crate::figure::parts::turn::at_angle;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure};
use crate::figure::view::Space;
use crate::geometry::{QuadraticTest, Ray, Root, RootVerdict, Roots, Sphere};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::{Event, Shade};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 380.0,
    usual: &[Layer::Parabola, Layer::Numbers],
    more: &[Layer::Normals],
};

/// The test that is drawn.
struct Solved {
    id: PrimitiveId,
    sphere: Sphere,
    ray: Ray,
    test: QuadraticTest,
    /// The step of the ray's start.
    starts: Option<u32>,
    /// The step of the test.
    step: u32,
    /// The shade where the sphere was hit, and its step.
    shade: Option<(Shade, u32)>,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let solved = Solved::find(figure)?;
    let mut left = body;
    if figure.shows(Layer::Parabola) {
        /// Of the width: the picture in space comes first.
        const SHARE: f64 = 0.56;
        let [space, plot] = body.split(SHARE, 2.0 * sheet.letters);
        quadratic(figure, sheet, plot, &solved);
        left = space;
    }
    if figure.shows(Layer::Normals) {
        left = working_of_normal(figure, sheet, left, &solved)?;
    }
    in_space(figure, sheet, left, &solved);
    Ok(in_words(figure, &solved))
}

impl Solved {
    fn find(figure: &Figure) -> Result<Self, FigureError> {
        let DrawnRay { node, events } = figure.ray()?;
        let asked = figure.object()?;
        let none = || {
            FigureError::new(
                "object",
                "this ray is not tested against such a sphere",
                "name a sphere that the ray is tested against, or omit \"object\" for the first one",
            )
        };
        let is_asked = |object| asked.is_none_or(|asked| asked == object);
        let found = events.iter().find_map(|record| match record.event {
            Event::SphereTest { object, test } if is_asked(object) && 0.0 < test.a => {
                Some((record.step, object, test))
            }
            _ => None,
        });
        let (step, id, test) = found.ok_or_else(none)?;
        let (Some(start), Shape::Sphere(sphere)) = (node.start, &figure.scene.primitive(id).shape)
        else {
            return Err(none());
        };
        let shade = events.iter().find_map(|record| match record.event {
            Event::Shade(shade) if shade.object == id => Some((shade, record.step)),
            _ => None,
        });
        let records = figure.records()?;
        let starts = node.ends_at[0].map(|at| records[at].step);
        Ok(Self {
            id,
            sphere: *sphere,
            ray: start.ray,
            test,
            starts,
            step,
            shade,
        })
    }

    /// r as a difference of t.
    fn radius_in_t(&self) -> f64 {
        self.sphere.radius / self.test.a.sqrt()
    }

    /// What became of a root.
    fn why(&self, root: Root) -> &'static str {
        match root.verdict {
            RootVerdict::Chosen => "the hit",
            RootVerdict::Behind => "behind the origin",
            RootVerdict::BelowEpsilon => "0 within ε",
            RootVerdict::BeyondNearest if self.test.roots.chosen().is_some() => "farther",
            RootVerdict::BeyondNearest => "beyond the nearest hit",
            RootVerdict::BackFace => "on the back",
            RootVerdict::FrontFace => "on the front",
            RootVerdict::BeyondEnds => "beyond the ends",
        }
    }
}

/// The ray and the sphere, with the roots on the ray.
fn in_space(figure: &Figure, sheet: &mut Sheet, frame: Frame, solved: &Solved) {
    let Solved { sphere, ray, .. } = solved;
    let numbers = figure.shows(Layer::Numbers);
    let roots = parabola::roots(&solved.test);
    let nearest = parabola::vertex(&solved.test).x;
    // the line of the ray is followed so far beyond what lies on it
    let room = 0.4 * solved.radius_in_t();
    let on_line = |of: fn(f64, f64) -> f64| roots.iter().map(|(_, root)| root.t).fold(nearest, of);
    let (first, last) = (on_line(f64::min).min(0.0), on_line(f64::max).max(0.0));
    let around = DVec3::AXES.map(|axis| sphere.radius * axis);
    let points = around
        .iter()
        .flat_map(|r| [sphere.center - *r, sphere.center + *r])
        .chain([ray.origin, ray.at(first), ray.at(last + room)]);
    let space = figure.space(frame, points);
    sheet.within(space.frame, |sheet| {
        let [origin, center, foot] =
            [ray.origin, sphere.center, ray.at(nearest)].map(|point| space.place(point));

        let is_hit = solved.test.roots.chosen();
        let shape = &figure.scene.primitive(solved.id).shape;
        let outline = Outline::of(shape, &space.projection);
        outline::draw(sheet, &space, &outline, Look::OBJECT);
        let edge = space.leaves(ray).unwrap_or(last);
        sheet.step(solved.starts, |sheet| {
            sheet.dot(Look::RAY, origin);
            sheet.label(frame, origin, DVec2::NEG_Y, "(x₀, y₀, z₀)");
            if !figure.shows(Layer::Normals) {
                sheet.line(Look::LINE_OF_RAY, origin, space.place(ray.at(edge)));
            }
        });

        sheet.step(solved.step, |sheet| {
            if is_hit.is_some() {
                outline::draw(sheet, &space, &outline, Look::ANSWER.outline());
            }
            if first < 0.0 {
                let behind = space.place(ray.at(first - room));
                sheet.line(Look::LINE_OF_RAY, behind, origin);
            }
            sheet.arrow(
                Look::RAY,
                origin,
                space.place(ray.at(is_hit.unwrap_or(edge))),
            );
            for (name, root) in &roots {
                let at = space.place(ray.at(root.t));
                let text = match (figure.shows(Layer::Normals), root.verdict) {
                    (true, RootVerdict::Chosen) => "(x, y, z)".into(),
                    (true, _) => continue,
                    _ if numbers => format!("{name} = {}, {}", quantity(root.t), solved.why(*root)),
                    _ => format!("{name}, {}", solved.why(*root)),
                };
                parabola::mark_root(sheet, *root, at);
                sheet.label(frame, at, at - center, text);
            }
            if roots.is_empty() {
                sheet.line(Look::HELP, center, foot);
                let text = if numbers {
                    format!("t = {}, nearest", quantity(nearest))
                } else {
                    "nearest".into()
                };
                sheet.label(frame, foot, foot - center, text);
            }
        });

        radius(figure, sheet, &space, solved, foot);
        sheet.dot(Look::THIN, center);
        sheet.label(frame, center, center - foot, "(a, b, c)");
        normal(figure, sheet, &space, solved);
    });
}

/// r, from the center away from the ray; to the point of contact if the ray grazes the sphere.
fn radius(figure: &Figure, sheet: &mut Sheet, space: &Space, solved: &Solved, foot: DVec2) {
    let center = space.place(solved.sphere.center);
    let along = space.direction(solved.ray.direction);
    // rounding is no direction
    let away = if (center - foot).length() < 1.0 {
        along.perp()
    } else {
        center - foot
    };
    let length = space.scale * solved.sphere.radius;
    let towards = match (solved.test.roots, solved.shade) {
        (_, Some((shade, _))) if figure.shows(Layer::Normals) => space.place(shade.point) - center,
        (Roots::Graze(_), _) => -away,
        // to the side, so that the name of the center has room
        _ => away.rotate(at_angle(0.6)),
    };
    let to = center + length * towards.normalize_or_zero();
    sheet.line(Look::THIN, center, to);
    sheet.label(space.frame, center.midpoint(to), towards.perp(), "r");
}

/// The normal at the hit, as it was computed for the shade.
fn normal(figure: &Figure, sheet: &mut Sheet, space: &Space, solved: &Solved) {
    let Some((shade, step)) = solved.shade.filter(|_| figure.shows(Layer::Normals)) else {
        return;
    };
    let (at, along) = (space.place(shade.point), space.direction(shade.normal));
    let tip = at + space.scale * along;
    sheet.step(step, |sheet| {
        sheet.arrow(Look::ANSWER.outline(), at, tip);
        sheet.label(space.frame, tip, along, "N");
    });
}

/// N = (p - center)/r with its numbers, below the drawing; gives back the frame that is left.
fn working_of_normal(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    solved: &Solved,
) -> Result<Frame, FigureError> {
    let (shade, step) = solved.shade.ok_or_else(|| {
        FigureError::new(
            "show",
            format!(
                "{} is not shaded by this ray, so it has no normal there",
                scenery::name_of(figure.scene, solved.id)
            ),
            "name a pixel in which it is the nearest object, or omit normals",
        )
    })?;
    let [drawing, lines] = frame.split_top(frame.size().y - 2.0 * sheet.line_height());
    let height = sheet.line_height();
    let place = |line: f64| DVec2::new(lines.min.x, lines.min.y + (line + 0.75) * height);
    sheet.step(step, |sheet| {
        let turned = if shade.back { "−" } else { "" };
        let formula = format!("N = {turned}((x − a)/r, (y − b)/r, (z − c)/r)");
        sheet.text(Anchor::Start, place(0.0), formula);
        if figure.shows(Layer::Numbers) {
            let (p, center) = (shade.point.to_array(), solved.sphere.center.to_array());
            let r = quantity(solved.sphere.radius);
            let parts = [0, 1, 2].map(|i| {
                let sign = if center[i] < 0.0 { '+' } else { MINUS };
                format!(
                    "({} {sign} {})/{r}",
                    quantity(p[i]),
                    quantity(center[i].abs())
                )
            });
            let text = format!(
                "= {turned}({}) = {}",
                parts.join(", "),
                coordinates(shade.normal)
            );
            let indent = DVec2::new(sheet.width_of("N "), 0.0);
            sheet.text(Anchor::Start, place(1.0) + indent, text);
        }
    });
    Ok(drawing)
}

/// The parabola of equation (iii), and its zeros.
fn quadratic(figure: &Figure, sheet: &mut Sheet, frame: Frame, solved: &Solved) {
    let QuadraticTest {
        a,
        b,
        c,
        discriminant,
        ..
    } = solved.test;
    let numbers = figure.shows(Layer::Numbers);
    let count = match solved.test.roots {
        Roots::None => "no root",
        Roots::Graze(_) | Roots::Linear(_) => "one root",
        Roots::Two { .. } => "two roots",
    };
    sheet.step(solved.step, |sheet| {
        // 0 but for rounding is 0
        let value = match solved.test.roots {
            Roots::Graze(_) => 0.0,
            _ => discriminant,
        };
        let texts = if numbers {
            let Sphere { center, radius } = solved.sphere;
            let (a, b, c) = (
                times(a, "t²"),
                further(&times(b, "t")),
                further(&quantity(c)),
            );
            vec![
                format!(
                    "(a, b, c) = {}, r = {}",
                    coordinates(center),
                    quantity(radius)
                ),
                format!("y = {a} {b} {c} … (iii)"),
                format!("discriminant {}: {count}", quantity(value)),
            ]
        } else {
            vec!["y = a·t² + b·t + c … (iii)".into(), count.into()]
        };
        let plot = sheet.lines(frame, &texts);
        parabola::draw(
            sheet,
            plot,
            &solved.test,
            0.8 * solved.radius_in_t(),
            numbers,
        );
    });
}

/// A coefficient with its variable, which stands alone if the coefficient is 1.
fn times(value: f64, variable: &str) -> String {
    match quantity(value).as_str() {
        "1" => variable.into(),
        "−1" => format!("{MINUS}{variable}"),
        number => format!("{number}·{variable}"),
    }
}

/// A further term of a sum.
fn further(term: &str) -> String {
    match term.strip_prefix(MINUS) {
        Some(positive) => format!("{MINUS} {positive}"),
        None => format!("+ {term}"),
    }
}

/// The test in words.
fn in_words(figure: &Figure, solved: &Solved) -> String {
    let name = scenery::name_of(figure.scene, solved.id);
    let roots: Vec<String> = parabola::roots(&solved.test)
        .into_iter()
        .map(|(name, root)| format!("{name} = {}, {}", quantity(root.t), solved.why(root)))
        .collect();
    let discriminant = quantity(solved.test.discriminant);
    let found = match solved.test.roots {
        Roots::None => format!(
            "The discriminant is {discriminant}: no real root, the parabola does not reach the axis, \
             and the ray misses the sphere."
        ),
        Roots::Graze(_) | Roots::Linear(_) => format!(
            "The discriminant is 0 within rounding: one root, the parabola touches the axis. {}.",
            roots.join("; ")
        ),
        Roots::Two { .. } => format!(
            "The discriminant is {discriminant}: two roots. {}.",
            roots.join("; ")
        ),
    };
    let normal = solved.shade.filter(|_| figure.shows(Layer::Normals));
    let normal = normal.map(|(shade, _)| format!(" The normal is {}.", coordinates(shade.normal)));
    format!(
        "A ray and the sphere {name}, center {}, radius {}. {found}{}",
        coordinates(solved.sphere.center),
        quantity(solved.sphere.radius),
        normal.unwrap_or_default()
    )
}
