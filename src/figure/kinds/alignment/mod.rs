//! A ray laid along the z axis, and the z sort (slides, "Optimizing Intersection Calculations"): the scene in world
//! coordinates, the same in the frame of the ray, and the hits in the order of their z.
//!
//! In its own frame the scene is drawn from the transformed points of the events; radii stay what they are.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{self, Outline, Rim, hull};
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure};
use crate::figure::view::{Projection, Space};
use crate::geometry::{Alignment, Cone, Ray, Sphere};
use crate::scene::{PrimitiveId, Shape};
use crate::structure::extent;
use crate::trace::{Aligned, AlignedPart, Event, ZSort};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[Layer::Names],
    more: &[],
};

/// What was recorded on the ray.
struct Laid {
    ray: Ray,
    starts: Option<u32>,
    frame: Alignment,
    /// When it was laid along the axis.
    step: u32,
    /// The transformed points, with their steps.
    points: Vec<(Aligned, u32)>,
    /// The hits, nearest first.
    sorted: Vec<(ZSort, u32)>,
}

impl Laid {
    fn find(figure: &Figure) -> Result<Self, FigureError> {
        let DrawnRay { node, events } = figure.ray()?;
        let none = || {
            FigureError::new(
                "strategy",
                "the trace of this ray has no ray that is turned into the z axis",
                "add \"strategy\": \"z-aligned\"",
            )
        };
        let frame = events.iter().find_map(|record| match record.event {
            Event::Align(frame) => Some((frame, record.step)),
            _ => None,
        });
        let (Some((frame, step)), Some(start)) = (frame, node.start) else {
            return Err(none());
        };
        let points = events.iter().filter_map(|record| match record.event {
            Event::Aligned(point) => Some((point, record.step)),
            _ => None,
        });
        let sorted = events.iter().filter_map(|record| match record.event {
            Event::ZSort(hit) => Some((hit, record.step)),
            _ => None,
        });
        let records = figure.records()?;
        Ok(Self {
            ray: start.ray,
            starts: node.ends_at[0].map(|at| records[at].step),
            frame,
            step,
            points: points.collect(),
            sorted: sorted.collect(),
        })
    }

    /// The transformed points of one object, and the step of the last one.
    fn of(&self, id: PrimitiveId) -> (Vec<Aligned>, Option<u32>) {
        let own = self.points.iter().filter(|(point, _)| point.object == id);
        let steps = own.clone().map(|(_, step)| *step);
        (own.map(|(point, _)| *point).collect(), steps.max())
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let laid = Laid::find(figure)?;
    let [left, right] = body.split(0.47, 2.0 * sheet.letters);
    let height = sheet.line_height();
    let [before, left] = left.split_top(height);
    let [after, right] = right.split_top(height);
    sheet.text(Anchor::Middle, before.middle(), "before: world coordinates");
    sheet.text(
        Anchor::Middle,
        after.middle(),
        "after: the ray is the z axis",
    );
    let rows = laid.sorted.len().max(1) as f64 + 1.4;
    let [panel, list] = right.split_top(right.size().y - rows * height);
    in_world(figure, sheet, left, &laid);
    in_frame(figure, sheet, panel, &laid);
    z_sort(figure, sheet, list, &laid);
    Ok(in_words(figure, &laid))
}

/// The nearest hit is a point, those behind it are rings.
fn mark(sheet: &mut Sheet, place: u32, at: DVec2) {
    if place == 0 {
        sheet.dot(Look::ANSWER, at);
    } else {
        sheet.ring(Look::THIN.wide(1.5), at);
    }
}

/// The objects and the ray before.
fn in_world(figure: &Figure, sheet: &mut Sheet, frame: Frame, laid: &Laid) {
    let far = furthest(figure, laid);
    let points = scenery::points_of(figure).into_iter();
    let room = frame.wider(-sheet.letters);
    let space = figure.space(room, points.chain([laid.ray.origin, laid.ray.at(far)]));
    world_axes(sheet, &space);
    sheet.within(frame, |sheet| {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        sheet.step(laid.starts, |sheet| {
            let (from, to) = (space.place(laid.ray.origin), space.place(laid.ray.at(far)));
            sheet.arrow(Look::RAY, from, to);
            sheet.dot(Look::RAY, from);
            sheet.label(frame, from, from - to, "(x₀, y₀, z₀)");
            for (hit, step) in &laid.sorted {
                sheet.step(*step, |sheet| {
                    // transformed back
                    let point = laid.frame.back(DVec3::new(0.0, 0.0, hit.z));
                    mark(sheet, hit.place, space.place(point));
                    if hit.place == 0 {
                        let across = (to - from).perp();
                        sheet.label(frame, space.place(point), across, coordinates(point));
                    }
                });
            }
        });
    });
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
}

/// The t to which the ray is drawn: a little beyond the last object that it hits, or beyond all if it hits none.
fn furthest(figure: &Figure, laid: &Laid) -> f64 {
    let Ray { origin, direction } = laid.ray;
    let is_met = |id: PrimitiveId| laid.sorted.iter().any(|(hit, _)| hit.object == id);
    let all = (0..).map(PrimitiveId).zip(&figure.scene.primitives);
    let ends = all
        .filter(|(id, _)| laid.sorted.is_empty() || is_met(*id))
        .map(|(_, primitive)| extent(&primitive.shape, direction)[1] - origin.dot(direction));
    1.06 * ends.fold(0.0, f64::max)
}

/// The world's axes, in a corner.
fn world_axes(sheet: &mut Sheet, space: &Space) {
    let length = 2.6 * sheet.letters;
    // the letter of an axis that points down stands below it
    let below = length + 1.2 * sheet.letters;
    let corner = DVec2::new(space.frame.min.x, space.frame.max.y - below);
    let axes = DVec3::AXES.into_iter().zip(["x", "y", "z"]);
    for (axis, letter) in axes {
        let along = space.direction(axis);
        // one that points to who looks is no arrow
        if 0.3 < along.length() {
            let tip = corner + length * along;
            sheet.arrow(Look::THIN, corner, tip);
            sheet.label(space.frame, tip, along, letter);
        }
    }
}

/// A shape in the frame of the ray, from its transformed points; `None` if the trace has not all of them.
fn outline_of(shape: &Shape, points: &[Aligned], projection: &Projection) -> Option<Outline> {
    let of = |part| points.iter().filter(move |point| point.part == part);
    let one = |part| of(part).next().map(|point| point.to);
    let half_axes = || -> Option<[DVec3; 3]> {
        let all: Vec<DVec3> = of(AlignedPart::HalfAxis).map(|point| point.to).collect();
        all.try_into().ok()
    };
    Some(match shape {
        Shape::Sphere(sphere) => {
            let center = one(AlignedPart::Center)?;
            let moved = Shape::Sphere(Sphere { center, ..*sphere });
            Outline::of(&moved, projection)
        }
        Shape::Ellipsoid(_) => {
            Outline::of_half_axes(one(AlignedPart::Center)?, half_axes()?, projection)
        }
        Shape::Box(_) => {
            let (center, [x, y, z]) = (one(AlignedPart::Center)?, half_axes()?);
            let corners = (0..8_u8).map(|bits| {
                let sign = |bit: u8| if bits & bit == 0 { -1.0 } else { 1.0 };
                projection.of(center + sign(1) * x + sign(2) * y + sign(4) * z)
            });
            Outline {
                rim: Rim::Points(hull(corners.collect())),
                ..Outline::default()
            }
        }
        Shape::Cone(cone) => {
            let [base, apex] = cone.radii();
            let (from, to) = (one(AlignedPart::Base)?, one(AlignedPart::Apex)?);
            Outline::of(&Shape::Cone(Cone::new(from, base, to, apex)?), projection)
        }
        Shape::Polygon(_) => {
            let vertices = of(AlignedPart::Vertex).map(|point| projection.of(point.to));
            Outline {
                rim: Rim::Points(vertices.collect()),
                ..Outline::default()
            }
        }
    })
}

/// The frame's axis that goes up, with its sign and its letter: z goes to the right, and the scene is seen from
/// the side from which the world is, so that it is turned and not mirrored.
fn upwards(frame: &Alignment, towards: DVec3) -> (DVec3, &'static str) {
    let [x, y] = [frame.x, frame.y].map(|row| row.dot(towards));
    // who looks sees the axis that points to him least; across × up is where he stands: z × x = y, z × y = -x
    if x.abs() <= y.abs() {
        (DVec3::X * y.signum(), "x")
    } else {
        (DVec3::Y * -x.signum(), "y")
    }
}

/// The objects and the ray after: hits at x = y = 0.
fn in_frame(figure: &Figure, sheet: &mut Sheet, frame: Frame, laid: &Laid) {
    let (up, letter) = upwards(&laid.frame, figure.projection().towards());
    let projection = Projection::new(DVec3::Z, up);
    let far = furthest(figure, laid);
    let mut outlines = Vec::new();
    for (id, primitive) in (0..).map(PrimitiveId).zip(&figure.scene.primitives) {
        let (points, step) = laid.of(id);
        let outline = outline_of(&primitive.shape, &points, &projection);
        outlines.extend(outline.map(|outline| (id, outline, step)));
    }
    let ends = [DVec3::ZERO, DVec3::new(0.0, 0.0, far)].map(|point| projection.of(point));
    let rims = outlines
        .iter()
        .flat_map(|(_, outline, _)| outline.rim.points());
    let room = frame.wider(-0.8 * sheet.letters);
    let space = Space::fitted_flat(projection, room, rims.chain(ends));

    for (_, outline, step) in &outlines {
        sheet.step(*step, |sheet| {
            outline::draw(sheet, &space, outline, Look::OBJECT);
        });
    }
    sheet.step(laid.step, |sheet| {
        let [origin, tip] = ends.map(|end| space.place_flat(end));
        sheet.arrow(Look::RAY, origin, tip);
        sheet.dot(Look::RAY, origin);
        sheet.label(frame, tip, tip - origin, "z");
        let positive = space.direction(if letter == "x" { DVec3::X } else { DVec3::Y });
        let short = origin + 2.6 * sheet.letters * positive;
        sheet.arrow(Look::THIN, origin, short);
        sheet.label(frame, short, positive, letter);
        for (hit, step) in &laid.sorted {
            sheet.step(*step, |sheet| {
                let at = space.place(DVec3::new(0.0, 0.0, hit.z));
                mark(sheet, hit.place, at);
            });
        }
    });
    if !figure.shows(Layer::Names) {
        return;
    }
    for object in &figure.scene.objects {
        let first = outlines.iter().find(|(id, _, _)| *id == object.first);
        if let Some((_, outline, _)) = first {
            scenery::name_at(sheet, &space, &outline.rim, &scenery::short(&object.name));
        }
    }
}

/// The hits in the order of z.
fn z_sort(figure: &Figure, sheet: &mut Sheet, frame: Frame, laid: &Laid) {
    let height = sheet.line_height();
    let line = |row: f64| frame.min + DVec2::new(0.0, (row + 0.9) * height);
    if laid.sorted.is_empty() {
        sheet.text(Anchor::Start, line(0.0), "z sort: no hit at x = y = 0");
        return;
    }
    let head = "z sort of the hits at x = y = 0";
    sheet.text(Anchor::Start, line(0.0), head);
    let indent = 1.2 * sheet.letters;
    let names = laid
        .sorted
        .iter()
        .map(|(hit, _)| scenery::name_of(figure.scene, hit.object));
    let names: Vec<String> = names.collect();
    let widths = names.iter().map(|name| sheet.width_of(name));
    let column = widths.fold(0.0, f64::max) + indent;
    for (row, ((hit, step), name)) in laid.sorted.iter().zip(&names).enumerate() {
        sheet.step(*step, |sheet| {
            let at = line(row as f64 + 1.0);
            mark(sheet, hit.place, at + DVec2::new(0.5 * indent, 0.0));
            let mut place = at + DVec2::new(1.5 * indent, 0.0);
            sheet.text(Anchor::Start, place, name.as_str());
            place.x += column;
            let nearest = if hit.place == 0 { ", nearest" } else { "" };
            let text = format!("z = {}{nearest}", quantity(hit.z));
            sheet.text(Anchor::Start, place, text);
        });
    }
}

fn in_words(figure: &Figure, laid: &Laid) -> String {
    let origin = coordinates(laid.frame.origin);
    let laid_along = format!(
        "The scene before, and moved and turned so that the ray from {origin} is the z axis."
    );
    let hits = laid.sorted.iter().map(|(hit, _)| {
        let name = scenery::name_of(figure.scene, hit.object);
        format!("{name} at z = {}", quantity(hit.z))
    });
    let hits: Vec<String> = hits.collect();
    if hits.is_empty() {
        format!("{laid_along} No object is hit at x = y = 0.")
    } else {
        format!("{laid_along} The z sort: {}.", hits.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ellipsoid;

    #[test]
    fn the_scene_is_turned_and_not_mirrored() {
        // in the plane y = 0, seen from above: x goes to the right, z down
        let ray = Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8));
        let frame = Alignment::of(&ray);
        let (up, letter) = upwards(&frame, DVec3::Y);
        let after = Projection::new(DVec3::Z, up);
        // to the left of the ray, which goes down to the right, is (0.8, 0, -0.6)
        let left = frame.vector(DVec3::new(0.8, 0.0, -0.6));
        assert!((after.of(left) - DVec2::Y).length() < 1e-12, "{letter}");
        let along = frame.vector(ray.direction);
        assert!((after.of(along) - DVec2::X).length() < 1e-12);
    }

    #[test]
    fn an_ellipsoid_is_drawn_from_its_transformed_half_axes() {
        let egg = Shape::Ellipsoid(Ellipsoid {
            center: DVec3::new(5.0, 5.0, 5.0),
            radii: DVec3::new(3.0, 2.0, 1.0),
        });
        let point = |part, index, to: [f64; 3]| Aligned {
            part,
            index,
            to: to.into(),
            ..Aligned::default()
        };
        // turned by 90°: x becomes z
        let points = [
            point(AlignedPart::Center, 0, [0.0, 1.0, 7.0]),
            point(AlignedPart::HalfAxis, 0, [0.0, 0.0, 3.0]),
            point(AlignedPart::HalfAxis, 1, [0.0, 2.0, 0.0]),
            point(AlignedPart::HalfAxis, 2, [-1.0, 0.0, 0.0]),
        ];
        let projection = Projection::new(DVec3::Z, DVec3::Y);
        let outline = outline_of(&egg, &points, &projection).unwrap();
        let Rim::Ellipse { center, axes } = outline.rim else {
            panic!("no ellipse");
        };
        assert_eq!(center, DVec2::new(7.0, 1.0));
        assert_eq!(axes.map(DVec2::length), [3.0, 2.0]);
        assert_eq!(outline_of(&egg, &points[..2], &projection), None);
    }
}
