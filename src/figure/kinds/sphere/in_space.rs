//! The ray and the sphere, with the roots on the ray.

use glam::DVec3;

use crate::figure::kinds::sphere::argument::Argument;
use crate::figure::kinds::sphere::solved::Solved;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::turn::at_angle;
use crate::figure::parts::{parabola, right_angle};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::{Root, RootVerdict};

/// How the ray and the sphere lie in a frame.
pub(super) fn space(figure: &Figure, frame: Frame, solved: &Solved) -> Space {
    let Solved { sphere, ray, .. } = solved;
    let [first, last] = stretch(solved);
    let around = DVec3::AXES.map(|axis| sphere.radius * axis);
    let points = around
        .iter()
        .flat_map(|r| [sphere.center - *r, sphere.center + *r])
        .chain([ray.origin, ray.at(first), ray.at(last + room(solved))]);
    figure.space(frame, points)
}

/// So far the line of the ray is followed beyond what lies on it, in t.
fn room(solved: &Solved) -> f64 {
    0.4 * solved.radius_in_t()
}

/// From the first t that lies on the line of the ray to the last.
fn stretch(solved: &Solved) -> [f64; 2] {
    let roots = parabola::roots(&solved.test);
    let on_line = |of: fn(f64, f64) -> f64| {
        let t = roots.iter().map(|(_, root)| root.t);
        t.fold(solved.nearest(), of)
    };
    [on_line(f64::min).min(0.0), on_line(f64::max).max(0.0)]
}

/// The ray and the sphere, with the roots on the ray.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    solved: &Solved,
    argument: &Argument,
) {
    let Solved { sphere, ray, .. } = solved;
    let frame = space.frame;
    let of_normal = figure.shows(Layer::Normals);
    let [first, last] = stretch(solved);
    sheet.within(frame, |sheet| {
        let at = |t: f64| space.place(ray.at(t));
        let [origin, center] = [ray.origin, sphere.center].map(|point| space.place(point));
        let foot = at(solved.nearest());
        let shape = &figure.scene.primitive(solved.id).shape;
        let outline = Outline::of(shape, &space.projection);
        outline::draw(sheet, space, &outline, Look::OBJECT);
        let edge = space.leaves(ray).unwrap_or(last);
        let hit = solved.test.roots.chosen();
        let half = 0.5 * hit.unwrap_or(solved.nearest().abs()).min(edge);

        sheet.at(argument.ray, |sheet| {
            sheet.arrow(Look::RAY, origin, at(half));
            if !of_normal {
                sheet.line(Look::LINE_OF_RAY, at(half), at(edge));
            }
            sheet.dot(Look::RAY, origin);
            let across = (at(half) - origin).perp();
            let away = across * -across.dot(center - origin).signum();
            sheet.label(
                frame,
                origin,
                away - (at(half) - origin),
                formula("(x₀, y₀, z₀)"),
            );
            sheet.label(frame, origin.lerp(at(half), 0.6), away, formula("R"));
        });
        sheet.at(argument.roots, |sheet| {
            if first < 0.0 && !of_normal {
                let behind = at(first - room(solved));
                sheet.line(Look::LINE_OF_RAY, behind, origin);
            }
        });
        sheet.at(argument.choice, |sheet| match hit {
            Some(t) => {
                sheet.line(Look::RAY, at(half), at(t));
                outline::draw(sheet, space, &outline, Look::MET.outline());
            }
            None => sheet.arrow(Look::RAY, at(half), at(edge)),
        });
        roots(figure, sheet, space, solved, argument);
        if figure.shows(Layer::Parabola) && !solved.starts_inside() {
            distance(figure, sheet, space, solved, argument);
        }

        radius(figure, sheet, space, solved, argument);
        sheet.dot(Look::THIN, center);
        sheet.label(frame, center, center - foot, formula("(a, b, c)"));
    });
}

/// The roots on the ray, and what becomes of them.
fn roots(figure: &Figure, sheet: &mut Sheet, space: &Space, solved: &Solved, argument: &Argument) {
    let center = space.place(solved.sphere.center);
    let of_normal = figure.shows(Layer::Normals);
    for (name, root) in parabola::roots(&solved.test) {
        let at = space.place(solved.ray.at(root.t));
        let text: Text = match (of_normal, root.verdict) {
            (true, RootVerdict::Chosen) => formula("(x, y, z)"),
            (true, _) => continue,
            _ => formula(name) + value(figure, root),
        };
        sheet.at(argument.roots, |sheet| {
            sheet.small_dot(Look::RAY, at);
            let (within, towards) = (space.frame, at - center);
            if of_normal {
                sheet.label(within, at, towards, text);
            } else {
                let why = match (sheet.width, root.verdict) {
                    // what it is behind of is to be seen
                    (Width::Slide, RootVerdict::Behind) => "behind",
                    _ => solved.why(root),
                };
                let why = (argument.choice, format!(", {why}"));
                sheet.label_that_goes_on(within, at, towards, text, why);
            }
        });
        sheet.at(argument.choice, |sheet| {
            parabola::mark_root(sheet, root, at);
        });
    }
}

fn value(figure: &Figure, root: Root) -> String {
    if figure.shows(Layer::Numbers) {
        format!(" = {}", quantity(root.t))
    } else {
        String::new()
    }
}

/// d, from the center at a right angle to the line of the ray.
fn distance(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    solved: &Solved,
    argument: &Argument,
) {
    let [center, foot] = [solved.sphere.center, solved.ray.at(solved.nearest())];
    let ends = [center, foot].map(|point| space.place(point));
    // a center on the line has no distance to be seen
    if ends[0].distance(ends[1]) < 2.0 * sheet.letters {
        return;
    }
    let compared = solved.compared();
    let d = quantity(solved.distance());
    let text = if figure.shows(Layer::Numbers) && compared != "=" {
        formula("d = ") + format!("{d} {compared} ") + formula("r")
    } else {
        formula(&format!("d {compared} r"))
    };
    sheet.at(argument.discriminant, |sheet| {
        sheet.line(Look::HELP.wide(1.25), ends[0], ends[1]);
        right_angle::draw(sheet, space, foot, [center - foot, -solved.ray.direction]);
        let beside = space.direction(solved.ray.direction);
        sheet.label(space.frame, ends[0].lerp(ends[1], 0.5), beside, text);
    });
}

/// r, from the center away from the ray, or to the hit whose normal is drawn.
fn radius(figure: &Figure, sheet: &mut Sheet, space: &Space, solved: &Solved, argument: &Argument) {
    let center = space.place(solved.sphere.center);
    let to_hit = solved.shade.filter(|_| figure.shows(Layer::Normals));
    let towards = if let Some((shade, _)) = to_hit {
        space.place(shade.point) - center
    } else {
        let from_ray = center - space.place(solved.ray.at(solved.nearest()));
        // rounding is no direction
        let away = if from_ray.length() < 1.0 {
            space.direction(solved.ray.direction).perp()
        } else {
            from_ray
        };
        // to the side, so that the name of the center has room
        away.rotate(at_angle(0.6))
    };
    let length = space.scale * solved.sphere.radius;
    let to = center + length * towards.normalize_or_zero();
    // the larger letters of a slide have no room for its value
    let text = if figure.shows(Layer::Numbers) && sheet.width == Width::Book {
        formula("r = ") + quantity(solved.sphere.radius)
    } else {
        formula("r")
    };
    let line = |sheet: &mut Sheet| {
        sheet.line(Look::THIN, center, to);
        sheet.label(
            space.frame,
            center.midpoint(to),
            towards.perp(),
            text.clone(),
        );
    };
    match to_hit {
        Some(_) => sheet.at(argument.choice, line),
        None => line(sheet),
    }
}
