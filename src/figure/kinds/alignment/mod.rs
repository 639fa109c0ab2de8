//! A ray laid along the z axis, and the z sort (slides, "Optimizing Intersection Calculations"): the scene in world
//! coordinates, the same in the frame of the ray, and the hits in the order of their z.
//!
//! In its own frame the scene is drawn from the transformed points of the events; radii stay what they are.

mod argument;
mod in_frame;
mod in_world;
mod laid;
mod marks;
mod z_sort;

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::alignment::argument::Argument;
use crate::figure::kinds::alignment::laid::Laid;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[Layer::Names],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let laid = Laid::find(figure)?;
    let argument = Argument::new(figure, sheet, &laid);
    let [left, right] = body.split(0.45, 5.5 * sheet.letters);
    let height = sheet.line_height();
    let [before, left] = left.split_top(height);
    let [after, right] = right.split_top(height);
    let at = before.middle();
    sheet.text(Anchor::Middle, at, "world coordinates");
    sheet.at(argument.frame, |sheet| {
        sheet.text(
            Anchor::Middle,
            after.middle(),
            formula("the ray is the z axis"),
        );
    });
    let list = (z_sort::rows(figure, &laid) + 0.4) * height;
    let [panel, list] = right.split_top(right.size().y - list);
    in_world::draw(figure, sheet, left, &laid, &argument);
    in_frame::draw(figure, sheet, panel, &laid, &argument);
    z_sort::draw(figure, sheet, list, &laid, &argument);
    let between = Frame {
        min: DVec2::new(left.max.x, panel.min.y),
        max: DVec2::new(panel.min.x, panel.max.y),
    };
    transformations(sheet, between, &argument);
    Ok(in_words(figure, &laid))
}

/// M to the right, and M⁻¹ back.
fn transformations(sheet: &mut Sheet, between: Frame, argument: &Argument) {
    // the letters of the axes stand before the panel
    let (from, to) = (between.min.x, between.max.x - 1.2 * sheet.letters);
    let ways = [
        (argument.frame, "M", [from, to], -0.7),
        (argument.nearest, "M⁻¹", [to, from], 0.7),
    ];
    for (stage, name, ends, down) in ways {
        let y = between.middle().y + down * sheet.letters;
        sheet.at(stage, |sheet| {
            let [from, to] = ends.map(|x| DVec2::new(x, y));
            sheet.arrow(Look::THIN.wide(1.5), from, to);
            let above = DVec2::new(f64::midpoint(from.x, to.x), y + 1.2 * down * sheet.letters);
            sheet.text(Anchor::Middle, above, formula(name));
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
    use glam::{DVec2, DVec3};
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, traced};
    use crate::geometry::{Alignment, Ray};
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::trace::{
        Aligned, AlignedPart, Event, PixelSample, RayEnd, RayStart, StrategyName, ZSort,
    };

    #[test]
    fn a_hit_lies_on_the_ray_in_both_drawings_at_its_z() {
        // a ball of radius 1 around (3, 0, 4): the ray from the origin along (0.6, 0, 0.8) hits it at z = 4
        let scene = scene_of(&[sphere([3.0, 0.0, 4.0], 1.0)]);
        let ray = Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8));
        let frame = Alignment::of(&ray);
        let object = PrimitiveId(0);
        let center = Aligned {
            object,
            part: AlignedPart::Center,
            to: DVec3::new(0.0, 0.0, 5.0),
            ..Aligned::default()
        };
        let start = RayStart {
            ray,
            ..RayStart::default()
        };
        let hit = ZSort {
            place: 0,
            object,
            z: 4.0,
        };
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(start)),
            (Some(0), Event::Align(frame)),
            (Some(0), Event::Aligned(center)),
            (Some(0), Event::ZSort(hit)),
            (Some(0), Event::RayEnd(RayEnd::default())),
        ];
        let mut traced = traced(scene, events);
        traced.settings.strategy = StrategyName::ZAligned;
        let drawn = ReadBack::of(
            json!({"kind": "alignment", "pixel": [0, 0], "show": ["names"]}),
            traced,
        );
        let mut hits = drawn.dots("answer");
        hits.sort_by(|a, b| a.x.total_cmp(&b.x));
        // before, after, and in the list
        let (before, after) = (hits[0], hits[hits.len() - 1]);
        assert_eq!(hits.len(), 3, "{hits:?}");
        let is_there = |at: DVec2| drawn.dots("ink").iter().any(|of| of.distance(at) < 0.05);
        // a ball is 5 − 4 = 1 in radius: its circle gives the scale
        let radii = drawn.circles("ink");
        let radius = |near: DVec2, away: f64| {
            let is_it = |(middle, radius): &&(DVec2, f64)| {
                (middle.distance(near) - radius).abs() < 0.05 && away < *radius
            };
            radii.iter().find(is_it).copied()
        };
        let (ball, one) = radius(before, 10.0).expect("no ball around the hit before");
        let origin = ball - (ball - before) * 5.0;
        assert!(
            (ball.distance(before) - one).abs() < 0.05 && is_there(origin),
            "{origin}"
        );
        let (ball, one) = radius(after, 10.0).expect("no ball around the hit after");
        assert!((ball.y - after.y).abs() < 0.02, "the ray is level");
        assert!(
            is_there(after - DVec2::new(4.0 * one, 0.0)),
            "{after} {ball}"
        );
    }
}
