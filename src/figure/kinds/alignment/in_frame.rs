//! The same in the frame of the ray, drawn from the transformed points of the events.

use glam::{DVec2, DVec3};

use crate::figure::kinds::alignment::argument::Argument;
use crate::figure::kinds::alignment::laid::{Laid, furthest};
use crate::figure::kinds::alignment::marks::{mark, name_beside};
use crate::figure::parts::outline::{self, Outline, Rim, hull};
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};
use crate::geometry::{Alignment, Cone, Sphere};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::{Aligned, AlignedPart};

/// The objects and the ray after: hits at x = y = 0.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    laid: &Laid,
    argument: &Argument,
) {
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

    sheet.at(argument.frame, |sheet| {
        let [origin, tip] = ends.map(|end| space.place_flat(end));
        sheet.arrow(Look::RAY, origin, tip);
        sheet.small_dot(Look::RAY, origin);
        sheet.label(frame, tip, tip - origin, formula("z"));
        let positive = space.direction(if letter == "x" { DVec3::X } else { DVec3::Y });
        let short = origin + 2.6 * sheet.letters * positive;
        sheet.arrow(Look::THIN, origin, short);
        sheet.label(frame, short, positive, formula(letter));
        axis_on_end(sheet, &space, frame, (origin, letter));
    });
    sheet.at(argument.points, |sheet| {
        for (_, outline, step) in &outlines {
            sheet.step(*step, |sheet| {
                outline::draw(sheet, &space, outline, Look::OBJECT);
            });
        }
        if !figure.shows(Layer::Names) {
            return;
        }
        for object in &figure.scene.objects {
            let first = outlines.iter().find(|(id, _, _)| *id == object.first);
            if let Some((_, outline, _)) = first {
                let name = scenery::short(&object.name);
                let ends = ends.map(|end| space.place_flat(end));
                name_beside(sheet, &space, &outline.rim, &name, ends);
            }
        }
    });
    for (hit, step) in &laid.sorted {
        let at = space.place(DVec3::new(0.0, 0.0, hit.z));
        sheet.at(argument.sort, |sheet| {
            sheet.step(*step, |sheet| mark(sheet, false, at));
        });
        if hit.place == 0 {
            sheet.at(argument.nearest, |sheet| mark(sheet, true, at));
        }
    }
}

/// The axis that points to who looks, as a point in a circle, or away from him, as a cross in it.
fn axis_on_end(sheet: &mut Sheet, space: &Space, frame: Frame, (origin, up): (DVec2, &str)) {
    let (axis, letter) = if up == "x" {
        (DVec3::Y, "y")
    } else {
        (DVec3::X, "x")
    };
    let radius = 6.5 * sheet.unit();
    sheet.circle(Look::THIN, origin, radius);
    if axis.dot(space.projection.towards()) < 0.0 {
        let arm = DVec2::splat(radius * std::f64::consts::FRAC_1_SQRT_2);
        sheet.line(Look::THIN, origin - arm, origin + arm);
        sheet.line(Look::THIN, origin - arm.perp(), origin + arm.perp());
    }
    sheet.label(frame, origin, DVec2::new(-1.0, -1.0), formula(letter));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ellipsoid;
    use crate::geometry::Ray;

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
