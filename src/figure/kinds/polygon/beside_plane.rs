//! A ray parallel to the polygon's plane, and the distance that it keeps.

use glam::{DVec2, DVec3};

use crate::figure::kinds::polygon::tested::Tested;
use crate::figure::parts::outline::{self, Rim};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
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
    let (test, step) = tested.plane;
    let normal = test.plane.normal;
    let is_beside = test.verdict == PlaneVerdict::ParallelBeside;
    let numerator = if is_beside {
        quantity(test.numerator)
    } else {
        "0".into()
    };
    let so = if is_beside {
        "no t in (v): the ray is parallel, beside the plane"
    } else {
        "no t in (v): the ray lies in the plane"
    };
    let equations = [
        "A·Δx + B·Δy + C·Δz = 0".into(),
        format!("A·x₀ + B·y₀ + C·z₀ + D = {numerator}"),
        so.into(),
    ];
    let drawing = sheet.step(step, |sheet| sheet.lines(frame, &equations));

    // the foot of the ray's origin on the plane, and of the last point of the ray that is drawn
    let down = -test.numerator * normal;
    let middle = polygon.vertices().sum::<DVec3>() / polygon.vertices().len() as f64;
    let furthest = polygon
        .vertices()
        .map(|vertex| (vertex - ray.origin).dot(ray.direction))
        .fold(0.0, f64::max);
    let end = ray.at(1.15 * furthest);
    let points = [
        ray.origin,
        ray.origin + down,
        end,
        end + down,
        middle + normal,
    ];
    let space = figure.space(drawing, polygon.vertices().chain(points));
    sheet.within(drawing, |sheet| {
        let place = |point| space.place(point);
        let seen = |point| space.projection.of(point);

        let rim = Rim::Points(polygon.vertices().map(seen).collect());
        outline::rim(sheet, &space, &rim, Look::OBJECT);
        let tip = place(middle + normal);
        sheet.arrow(Look::THIN, place(middle), tip);
        sheet.label(drawing, tip, tip - place(middle), "(A, B, C)");
        sheet.step(tested.starts, |sheet| {
            sheet.arrow(Look::RAY, place(ray.origin), place(end));
            sheet.dot(Look::RAY, place(ray.origin));
            sheet.label(drawing, place(ray.origin), DVec2::NEG_Y, "COP");
            let third = place(ray.origin).lerp(place(end), 0.3);
            sheet.label(drawing, third, DVec2::NEG_Y, "R");
        });
        sheet.step(step, |sheet| {
            if is_beside {
                let feet = [ray.origin + down, end + down].map(place);
                sheet.line(Look::LINE_OF_RAY, feet[0], feet[1]);
                sheet.line(Look::HELP, place(ray.origin), feet[0]);
                sheet.line(Look::HELP, place(end), feet[1]);
                let half = place(ray.origin).midpoint(feet[0]);
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
