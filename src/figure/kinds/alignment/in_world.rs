//! The objects and the ray in world coordinates.

use glam::{DVec2, DVec3};

use crate::figure::kinds::alignment::argument::Argument;
use crate::figure::kinds::alignment::laid::{Laid, furthest};
use crate::figure::kinds::alignment::marks::{mark, name_beside};
use crate::figure::parts::axes;
use crate::figure::parts::outline::Outline;
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::coordinates;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;

/// The objects and the ray before, and where the hits are when they are transformed back.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    laid: &Laid,
    argument: &Argument,
) {
    let far = furthest(figure, laid);
    let points = scenery::points_of(figure).into_iter();
    let room = frame.wider(-sheet.letters);
    let space = figure.space(room, points.chain([laid.ray.origin, laid.ray.at(far)]));
    world_axes(sheet, &space);
    let [from, to] = [laid.ray.origin, laid.ray.at(far)].map(|at| space.place(at));
    sheet.within(frame, |sheet| {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        sheet.at(argument.ray, |sheet| {
            sheet.arrow(Look::RAY.in_front(), from, to);
            sheet.dot(Look::RAY, from);
            sheet.label(frame, from, from - to, formula("(x₀, y₀, z₀)"));
        });
        sheet.at(argument.nearest, |sheet| {
            for (hit, step) in &laid.sorted {
                let point = laid.frame.back(DVec3::new(0.0, 0.0, hit.z));
                sheet.step(*step, |sheet| {
                    mark(sheet, hit.place == 0, space.place(point));
                });
                if hit.place == 0 {
                    let across = (to - from).perp();
                    sheet.label(frame, space.place(point), across, coordinates(point));
                }
            }
        });
    });
    if figure.shows(Layer::Names) {
        for object in figure.scene.objects.iter().filter(|of| 0 < of.count) {
            let shape = &figure.scene.primitive(object.first).shape;
            let rim = Outline::of(shape, &space.projection).rim;
            let name = scenery::short(&object.name);
            name_beside(sheet, &space, &rim, &name, [from, to]);
        }
    }
}

/// The world's axes, in a corner.
fn world_axes(sheet: &mut Sheet, space: &Space) {
    // the letter of an axis that points down stands below it
    let below = (axes::SMALL + 1.2) * sheet.letters;
    let corner = DVec2::new(space.frame.min.x, space.frame.max.y - below);
    axes::draw_small(sheet, space, corner);
}
