//! A ray as a line, and where it ends.

use glam::{DVec2, DVec3};

use crate::figure::kinds::rays::words;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::Ray;
use crate::trace::{Purpose, RayNode, RayVerdict};

pub(super) fn look(purpose: Purpose) -> Look {
    match purpose {
        Purpose::Eye => Look::RAY,
        Purpose::Shadow => Look::SHADOW_RAY,
        Purpose::Reflected | Purpose::Scattered => Look::REFLECTED_RAY,
        Purpose::Refracted => Look::REFRACTED_RAY,
        Purpose::Light => Look::LIGHT_RAY,
        Purpose::Connection => Look::CONNECTION,
    }
}

/// Where a ray ends, if it ends anywhere.
pub(super) fn end_of(node: &RayNode) -> Option<DVec3> {
    let (start, end) = (node.start?, node.end?);
    let t = end.t.or_else(|| {
        // a ray to a light ends there, a connecting line at its other end
        matches!(end.verdict, RayVerdict::ReachesLight | RayVerdict::Connects)
            .then_some(start.range.max)
    })?;
    t.is_finite().then(|| start.ray.at(t))
}

/// Draws a ray: with its first half and its head it leaves, with the other it ends. Of the rays that are called the same
/// the first has the name beside it.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    node: &RayNode,
    ([leaves_at, ends_at], sends_on): ([StageId; 2], bool),
    named: &mut Vec<&'static str>,
) {
    /// Of the way: beyond the window, and off what marks the end.
    const HEAD: f64 = 0.55;
    let (Some(start), Some(end)) = (node.start, node.end) else {
        return;
    };
    let from = space.place(start.ray.origin);
    let to = match end_of(node) {
        Some(end) => space.place(end),
        None => match leaves(space, &start.ray) {
            Some(edge) => edge,
            None => return,
        },
    };
    let Some([from, to]) = space.frame.cut_line([from, to]) else {
        return;
    };
    let along = (to - from).normalize_or_zero();
    let has_mark = figure.shows(Layer::Hits) && end.t.is_some();
    let look = look(start.purpose);
    let half = from.lerp(to, HEAD);
    sheet.at(leaves_at, |sheet| sheet.arrow(look, from, half));
    sheet.at(ends_at, |sheet| {
        if end.verdict == RayVerdict::ReachesLight && figure.shows(Layer::Lights) {
            sheet.line(look, half, to - 11.0 * sheet.unit() * along);
        } else if end.t.is_none() {
            sheet.arrow(look, half, to);
        } else {
            sheet.line(look, half, to);
        }
        if end.verdict == RayVerdict::Blocked {
            // where it would have gone
            let light = space.place(start.ray.at(start.range.max));
            if let Some([from, to]) = space.frame.cut_line([to, light]) {
                sheet.line(Look::LINE_OF_RAY, from, to);
            }
        }
        if has_mark && end.verdict == RayVerdict::Blocked {
            sheet.cross(Look::REJECTED, to);
        } else if has_mark && sends_on {
            sheet.dot(Look::RAY, to);
        } else if has_mark {
            sheet.dot(Look::ANSWER, to);
        }
    });
    if figure.shows(Layer::Legend) {
        return;
    }
    let mut name = |sheet: &mut Sheet, stage, at, towards, text: &'static str| {
        if !named.contains(&text) {
            named.push(text);
            sheet.at(stage, |sheet| sheet.label(space.frame, at, towards, text));
        }
    };
    let across = upwards(along.perp());
    let text = words::of_purpose(start.purpose);
    // two of them are often in one corner of a small slide
    let text = match (sheet.width, start.purpose) {
        (Width::Slide, Purpose::Reflected | Purpose::Refracted) => text.trim_end_matches(" ray"),
        _ => text,
    };
    name(sheet, leaves_at, from.lerp(to, 0.4), across, text);
    match (start.purpose, end.verdict) {
        (Purpose::Shadow, RayVerdict::Blocked) => {
            name(sheet, ends_at, to, across, "blocked");
        }
        (Purpose::Eye, RayVerdict::Miss) => {
            name(
                sheet,
                ends_at,
                to - 3.0 * sheet.letters * along,
                across,
                "misses",
            );
        }
        _ => {}
    }
}

/// Of the two directions across a line the one that goes up.
fn upwards(across: DVec2) -> DVec2 {
    if 0.0 < across.y { -across } else { across }
}

/// Where a ray that hits nothing leaves the frame.
fn leaves(space: &Space, ray: &Ray) -> Option<DVec2> {
    let t = space.leaves(ray)?;
    Some(space.place(ray.at(t)))
}
