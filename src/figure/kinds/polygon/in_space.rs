//! The polygon, the ray and its point p on the plane, in space, and what is projected (Fig. 15.57).

use glam::{DVec2, DVec3};

use crate::figure::kinds::polygon::tested::{Tested, mark};
use crate::figure::parts::axes;
use crate::figure::parts::outline::{self, Rim};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::geometry::{Axis, PlaneTest, PlaneVerdict, Root};

/// The polygon, the ray and p, with their projections along an axis.
pub(super) fn draw(figure: &Figure, sheet: &mut Sheet, frame: Frame, tested: &Tested, along: Axis) {
    let Tested { ray, polygon, .. } = tested;
    let (PlaneTest { verdict, .. }, plane_step) = tested.plane;
    let (PlaneVerdict::Meets(Root { t, .. }), Some((test, step))) = (verdict, tested.point) else {
        return;
    };
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
            axes::draw_plane(sheet, &space, along, reach);
            axes::draw(sheet, &space, along, reach);
        }
        outline::rim(sheet, &space, &rim, Look::OBJECT);

        let (from, to) = (space.place(ray.origin), space.place(p));
        sheet.step(tested.starts, |sheet| {
            sheet.dot(Look::RAY, from);
            sheet.label(frame, from, from - to, "COP");
            sheet.label(frame, from.lerp(to, 0.5), (from - to).perp(), "R");
        });

        sheet.step(plane_step, |sheet| {
            sheet.arrow(Look::RAY, from, to);
            if !test.inside {
                // it goes on, below the plane
                sheet.line(Look::LINE_OF_RAY, to, space.place(beyond));
            }
            sheet.label(frame, to, DVec2::new(1.0, -0.4), "p");
        });

        sheet.step(step, |sheet| {
            if figure.shows(Layer::Projection) {
                let help = Look::HELP.wide(0.75);
                for vertex in polygon.vertices() {
                    let foot = axes::foot(along, vertex);
                    sheet.line(help, space.place(vertex), space.place(foot));
                }
                let shadow = shape(&mut polygon.vertices().map(|vertex| axes::foot(along, vertex)));
                outline::rim(sheet, &space, &shadow, Look::OBJECT.wide(1.0));
                let foot = space.place(axes::foot(along, p));
                sheet.line(Look::HELP.wide(1.5), to, foot);
                mark(sheet, test.inside, foot);
                sheet.label(frame, foot, DVec2::new(1.0, 0.4), "p′");
            }
            if test.inside {
                outline::rim(sheet, &space, &rim, Look::HIT.outline());
            }
            mark(sheet, test.inside, to);
        });
    });
}
