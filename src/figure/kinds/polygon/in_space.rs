//! The polygon, the ray and its point p on the plane, in space, and what is projected (Fig. 15.57).

use glam::{DVec2, DVec3};

use crate::figure::kinds::polygon::argument::Argument;
use crate::figure::kinds::polygon::tested::{Tested, mark};
use crate::figure::parts::outline::{self, Rim};
use crate::figure::parts::{axes, depth};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::geometry::{Axis, PlaneTest, PlaneVerdict, Root};

/// The polygon, the ray and p, with their projections along an axis.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    tested: &Tested,
    along: Axis,
    argument: &Argument,
) {
    let Tested { ray, polygon, .. } = tested;
    let (PlaneTest { verdict, .. }, _) = tested.plane;
    let (PlaneVerdict::Meets(Root { t, .. }), Some((test, _))) = (verdict, tested.point) else {
        return;
    };
    let cover = [figure.scene.primitive(tested.id)];
    let (p, reach) = (test.point, tested.reach());
    // so far an outside ray is drawn
    let beyond = ray.at(1.3 * t);
    let corners = DVec3::AXES.map(|axis| axis * reach);
    let points = polygon.vertices().chain(corners);
    let points = points.chain([DVec3::ZERO, ray.origin, p, axes::foot(along, reach)]);
    let space = figure.space(frame.wider(-sheet.letters), points);
    sheet.within(frame, |sheet| {
        let shape = |of: &mut dyn Iterator<Item = DVec3>| {
            Rim::Points(of.map(|point| space.projection.of(point)).collect())
        };

        let rim = shape(&mut polygon.vertices());
        if figure.shows(Layer::Projection) {
            axes::draw_plane_behind(sheet, &space, along, reach, &cover);
            axes::draw_behind(sheet, &space, along, reach, &cover);
        }
        outline::rim(sheet, &space, &rim, Look::OBJECT);

        let (from, to) = (space.place(ray.origin), space.place(p));
        sheet.at(argument.ray, |sheet| {
            // the arrow goes nowhere yet: half of the way to p
            let half = ray.at(0.5 * t);
            depth::arrow(
                sheet,
                &space,
                Look::RAY.in_front(),
                [ray.origin, half],
                &cover,
            );
            sheet.dot(Look::RAY, from);
            sheet.label(frame, from, from - to, "COP");
            sheet.label(frame, from.lerp(to, 0.4), (from - to).perp(), formula("R"));
        });

        sheet.at(argument.point, |sheet| {
            depth::line(
                sheet,
                &space,
                Look::RAY.in_front(),
                [ray.at(0.5 * t), p],
                &cover,
            );
            if !test.inside {
                // it goes on, below the plane
                depth::line(sheet, &space, Look::LINE_OF_RAY, [p, beyond], &cover);
            }
            sheet.small_dot(Look::RAY, to);
            sheet.label(frame, to, DVec2::new(1.0, -0.4), formula("p"));
        });

        if figure.shows(Layer::Projection) {
            let foot = space.place(axes::foot(along, p));
            sheet.at(argument.projection, |sheet| {
                let help = Look::HELP.wide(0.75);
                for vertex in polygon.vertices() {
                    let ends = [vertex, axes::foot(along, vertex)];
                    depth::line(sheet, &space, help, ends, &cover);
                }
                let shadow = shape(&mut polygon.vertices().map(|vertex| axes::foot(along, vertex)));
                outline::rim(sheet, &space, &shadow, Look::OBJECT.wide(1.0));
                let ends = [p, axes::foot(along, p)];
                depth::line(sheet, &space, Look::HELP.wide(1.5), ends, &cover);
                sheet.small_dot(Look::RAY, foot);
                sheet.label(frame, foot, DVec2::new(1.0, 0.4), formula("p′"));
            });
            sheet.at(argument.verdict, |sheet| mark(sheet, test.inside, foot));
        }
        sheet.at(argument.verdict, |sheet| mark(sheet, test.inside, to));
    });
}
