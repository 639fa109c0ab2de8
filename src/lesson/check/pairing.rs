//! Which line is which event: rays by their purpose and their place in space, events by what they are about.

use crate::lesson::check::foreign::ForeignRay;
use crate::lesson::check::line::Line;
use crate::lesson::check::on_ray::OnRay;
use crate::lesson::check::reference::{Expected, ExpectedPixel, ExpectedRay, Reference};
use crate::lesson::check::value::{Fields, Value};
use crate::trace::{Kind, Purpose};

/// By how much the origin of a ray may lie beside the hit that it starts from, relative to the larger of 1 and its
/// distance from 0: whoever moves it by ε along the normal does so.
pub(super) const OFFSET: f64 = 2e-3;

/// The ray that each ray of the log is.
///
/// The purposes agree, the light of a shadow ray, and the ray before if the log has it. Of several, the one that lies where
/// the log's ray lies; else the first that is left.
pub(super) fn match_rays(expected: &ExpectedPixel, foreign: &[ForeignRay]) -> Vec<Option<usize>> {
    let mut matched = vec![None; foreign.len()];
    let mut is_taken = vec![false; expected.rays.len()];
    for by_place in [true, false] {
        for (number, ray) in foreign.iter().enumerate() {
            if matched[number].is_some() {
                continue;
            }
            let parent = ray.parent.and_then(|of| {
                let parent = foreign.iter().position(|other| other.number == Some(of))?;
                matched[parent]
            });
            let fits = |(place, of): &(usize, &ExpectedRay)| {
                let start = ray.start();
                let purpose = ray.purpose.unwrap_or(Purpose::Eye);
                let light = start.and_then(|line| line.fields.text("light"));
                let expected_light = of
                    .events
                    .first()
                    .and_then(|first| first.fields.text("light"));
                !is_taken[*place]
                    && of.start.purpose == purpose
                    && light.is_none_or(|light| expected_light == Some(light))
                    && parent.is_none_or(|parent| of.parent == Some(parent))
                    && (!by_place || lies_there(ray, of))
            };
            let place = expected
                .rays
                .iter()
                .enumerate()
                .find(fits)
                .map(|(place, _)| place);
            if let Some(place) = place {
                matched[number] = Some(place);
                is_taken[place] = true;
            }
        }
    }
    matched
}

/// Does a ray of the log start where this one starts, and go where it goes?
fn lies_there(ray: &ForeignRay, expected: &ExpectedRay) -> bool {
    let Some(start) = ray.start() else {
        return false;
    };
    let own = &expected.start.ray;
    let is_near = start
        .fields
        .vector("origin")
        .is_some_and(|origin| origin.distance(own.origin) <= OFFSET * own.origin.length().max(1.0));
    let direction = start
        .fields
        .vector("direction")
        .map(glam::DVec3::normalize_or_zero);
    is_near && direction.is_some_and(|direction| direction.distance(own.direction) <= 2.0 * OFFSET)
}

/// The event that a line tells, on a ray.
pub(super) fn event_of(
    reference: &Reference<'_, '_>,
    line: &Line,
    expected: &ExpectedRay,
    on: &OnRay,
    nth: usize,
) -> Option<Expected> {
    let of_kind = |of: &&Expected| {
        of.kind() == line.kind && subject(&of.fields, line.kind) == subject(&line.fields, line.kind)
    };
    match line.kind {
        Kind::SphereTest
        | Kind::EllipsoidTest
        | Kind::ConeTest
        | Kind::BoxTest
        | Kind::PlaneTest
        | Kind::PolygonTest => {
            let mut found = on.tests.iter().find(of_kind)?.clone();
            // the step is that of the log that one can look at
            if let Some(logged) = expected.events.iter().find(of_kind) {
                found.step = logged.step;
            } else if let Some(end) = expected.events.last() {
                found.step = end.step;
            }
            Some(found)
        }
        Kind::Nearest => {
            let last = |kind| expected.events.iter().rfind(move |of| of.kind() == kind);
            let mut found = last(Kind::Nearest).or(last(Kind::RayEnd))?.clone();
            found.fields = Fields::default();
            with_hit(&mut found.fields, reference, on);
            Some(found)
        }
        Kind::RayEnd => {
            let mut found = expected.events.iter().find(of_kind)?.clone();
            if found.fields.get("t").is_some() {
                found
                    .fields
                    .0
                    .retain(|(key, _)| !["object", "t"].contains(&key.as_str()));
                with_hit(&mut found.fields, reference, on);
            }
            Some(found)
        }
        _ => expected.events.iter().filter(of_kind).nth(nth).cloned(),
    }
}

/// What the ray hits first: the object and t.
fn with_hit(fields: &mut Fields, reference: &Reference<'_, '_>, on: &OnRay) {
    let Some(hit) = on.nearest else {
        return;
    };
    let name = reference.name(hit.object).to_owned();
    fields.0.push(("object".into(), Value::Text(name)));
    fields.0.push(("t".into(), Value::Number(hit.t)));
}

/// A ray as a message names it.
pub(super) fn in_words(ray: &ExpectedRay, reference: &Reference<'_, '_>) -> String {
    let purpose = ray.start.purpose.word();
    let light = ray
        .start
        .light
        .and_then(|light| reference.scene.lights.get(light as usize));
    match light {
        Some(light) => format!("{purpose} ray to {}", light.name),
        None => format!("{purpose} ray"),
    }
}

/// What a line is about, among those of its kind.
pub(super) fn subject(fields: &Fields, kind: Kind) -> String {
    let key = match kind {
        Kind::LightTerm => "light",
        Kind::SphereTest
        | Kind::EllipsoidTest
        | Kind::ConeTest
        | Kind::BoxTest
        | Kind::PlaneTest
        | Kind::PolygonTest
        | Kind::Listed
        | Kind::Mailbox
        | Kind::HitOutsideCell
        | Kind::BoundTest => "object",
        _ => return String::new(),
    };
    let name = fields.text(key).unwrap_or_default();
    match fields.number("face") {
        Some(face) => format!("{name}, face {face}"),
        None => name.into(),
    }
}
