//! A ray parallel to the polygon's plane, and the distance that it keeps.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::kinds::polygon::tested::Tested;
use crate::figure::parts::depth;
use crate::figure::parts::outline::{self, Rim};
use crate::figure::parts::right_angle;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::formula;
use crate::figure::subject::Figure;
use crate::geometry::PlaneVerdict;

/// A ray that keeps its distance from the plane: (v) has no t.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    tested: &Tested,
    name: &str,
) -> String {
    let Tested { ray, polygon, .. } = tested;
    let (test, _) = tested.plane;
    let normal = test.plane.normal;
    let is_beside = test.verdict == PlaneVerdict::ParallelBeside;
    let numerator = if is_beside {
        quantity(test.numerator)
    } else {
        "0".into()
    };
    let [starts, argument] = stages(sheet, tested, name);
    let equations = [
        formula("A·Δx + B·Δy + C·Δz = 0"),
        formula("A·x₀ + B·y₀ + C·z₀ + D = ") + &numerator,
        formula("no t ")
            + if is_beside {
                "in (v): the ray is parallel to the plane, and beside it"
            } else {
                "in (v): the ray lies in the plane"
            },
    ];
    let drawing = sheet.at(argument, |sheet| sheet.lines(frame, &equations));

    // the foot of the ray's origin on the plane, and of the last point of the ray that is drawn
    let down = -test.numerator * normal;
    let middle = polygon.vertices().sum::<DVec3>() / polygon.vertices().len() as f64;
    let cover = [figure.scene.primitive(tested.id)];
    let furthest = polygon
        .vertices()
        .map(|vertex| (vertex - ray.origin).dot(ray.direction))
        .fold(0.0, f64::max);
    let end = ray.at(1.15 * furthest);
    let plane = sheet_of_plane(tested, [ray.origin + down, end + down]);
    let points = [ray.origin, end, middle + normal];
    let points = points.into_iter().chain(plane);
    let space = figure.space(drawing, polygon.vertices().chain(points));
    sheet.within(drawing, |sheet| {
        let place = |point| space.place(point);
        let seen = |point| space.projection.of(point);

        let rim = Rim::Points(polygon.vertices().map(seen).collect());
        let plane = Rim::Points(plane.map(seen).into());
        outline::rim(sheet, &space, &plane, Look::HELP.wide(0.75));
        outline::rim(sheet, &space, &rim, Look::OBJECT);
        let tip = place(middle + normal);
        sheet.arrow(Look::THIN, place(middle), tip);
        // beside it: beyond its tip is the ray
        let beside = DVec2::new(-1.0, -0.3);
        sheet.label(
            drawing,
            place(middle).midpoint(tip),
            beside,
            formula("(A, B, C)"),
        );
        right_angle::draw(sheet, &space, middle, [normal, ray.direction]);
        sheet.at(starts, |sheet| {
            depth::arrow(
                sheet,
                &space,
                Look::RAY.in_front(),
                [ray.origin, end],
                &cover,
            );
            sheet.dot(Look::RAY, place(ray.origin));
            sheet.label(drawing, place(ray.origin), DVec2::NEG_Y, "COP");
            let third = place(ray.origin).lerp(place(end), 0.3);
            sheet.label(drawing, third, DVec2::NEG_Y, formula("R"));
        });
        sheet.at(argument, |sheet| {
            if is_beside {
                let feet = [ray.origin + down, end + down];
                sheet.line(Look::LINE_OF_RAY, place(feet[0]), place(feet[1]));
                for (from, foot, along) in [
                    (ray.origin, feet[0], ray.direction),
                    (end, feet[1], -ray.direction),
                ] {
                    depth::line(sheet, &space, Look::HELP, [from, foot], &cover);
                    right_angle::draw(
                        sheet,
                        &space,
                        foot,
                        [normal * test.numerator.signum(), along],
                    );
                }
                let half = place(ray.origin).midpoint(place(feet[0]));
                sheet.label(drawing, half, DVec2::NEG_X, numerator);
            }
        });
    });
    let distance = quantity(test.numerator.abs());
    if is_beside {
        format!(
            "The ray is parallel to the plane of {name}, at the distance {distance}, and does not hit it."
        )
    } else {
        format!("The ray lies in the plane of {name} and does not hit it in one point.")
    }
}

/// The stages: the ray, and why there is no t.
fn stages(sheet: &mut Sheet, tested: &Tested, name: &str) -> [StageId; 2] {
    let (test, step) = tested.plane;
    let so = if test.verdict == PlaneVerdict::ParallelBeside {
        let distance = quantity(test.numerator.abs());
        format!(
            "R keeps the same distance from the plane, {distance}: the denominator of (v) is 0, and there is no t."
        )
    } else {
        "R lies in the plane: the denominator of (v) is 0, and there is no t.".into()
    };
    let starts = format!("The ray R starts at the COP and goes past the polygon {name}.");
    [
        sheet.stage(Part::Ray, tested.starts, starts),
        sheet.stage(Part::PlaneT, step, so),
    ]
}

/// The plane as a parallelogram along the ray, around the polygon and the feet of the ray's ends.
fn sheet_of_plane(tested: &Tested, [start, end]: [DVec3; 2]) -> [DVec3; 4] {
    /// Beyond the outermost corner, of the width.
    const ROOM: f64 = 0.08;
    let normal = tested.plane.0.plane.normal;
    let across = normal.cross(tested.ray.direction).normalize_or_zero();
    let aside = |point: DVec3| (point - start).dot(across);
    let sides = tested.polygon.vertices().chain([start]).map(aside);
    let [low, high] = sides.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
        [low.min(at), high.max(at)]
    });
    let room = ROOM * (high - low);
    let corner = |foot: DVec3, at: f64| foot + at * across;
    [
        corner(start, low - room),
        corner(end, low - room),
        corner(end, high + room),
        corner(start, high + room),
    ]
}
