//! The shadow ray: is the light blocked, and by what?

use crate::explain::name::light_title;
use crate::geometry::TRange;
use crate::mistake::{Wrong, mistake, mistakes};
use crate::scene::PrimitiveId;
use crate::step::quantity::{Quantity, Value};
use crate::step::question::at::{At, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::step::question::object_hit::object_hit;
use crate::trace::{Event, Purpose, RayVerdict};

/// So many objects are tried as wrong answers: a question names three.
const MOST_TRIED: usize = 64;

/// Is the light blocked, and by what?
pub(super) fn blocked(at: &At) -> Option<Question> {
    let Event::Ray(start) = at.record().event else {
        return None;
    };
    if start.purpose != Purpose::Shadow {
        return None;
    }
    let Event::RayEnd(end) = at.events().last()?.event else {
        return None;
    };
    let blocker = match end.verdict {
        RayVerdict::Blocked => Some(end.object?),
        RayVerdict::ReachesLight => None,
        _ => return None,
    };
    let light = light_title(at.log.scene, start.light?);
    let distance = number(start.range.max);
    let free_text = "not blocked";
    let text_of = |object: PrimitiveId| format!("blocked by {}", at.name(object));
    let right = match blocker {
        None => Choice::new(
            free_text,
            format!("No object is hit at a t up to {distance}, where the light is."),
        ),
        Some(object) => Choice::new(
            text_of(object),
            match end.t {
                Some(t) => format!(
                    "It is hit at t = {}, before the light at t = {distance}.",
                    number(t)
                ),
                None => format!("It is hit before the light at t = {distance}."),
            },
        ),
    };
    let mut beyond = Vec::new();
    let mut started = Vec::new();
    let mut beside = Vec::new();
    let objects = (0..).map(PrimitiveId).zip(&at.log.scene.primitives);
    let objects: Vec<_> = objects.take(MOST_TRIED).collect();
    let own = own_surface(at);
    for (object, primitive) in objects {
        // another object in between blocks the light, too
        if object_hit(primitive, &start.ray, start.range).is_some() {
            continue;
        }
        let endless = TRange {
            max: f64::INFINITY,
            ..start.range
        };
        match object_hit(primitive, &start.ray, endless) {
            Some(t) => {
                let reason = format!(
                    "It is hit at t = {}, beyond the light at t = {distance}.",
                    number(t)
                );
                let choice = Choice::new(text_of(object), reason);
                beyond.push(match mistake("any hit counts") {
                    Some(mistake) => choice.by(mistake),
                    None => choice,
                });
            }
            None if own == Some(object) => {
                let choice = Choice::new(
                    text_of(object),
                    "The ray starts on it and does not hit it again.",
                );
                started.push(match mistake("offset to the wrong side") {
                    Some(mistake) => choice.by(mistake),
                    None => choice,
                });
            }
            None => beside.push(Choice::new(
                text_of(object),
                "The ray does not hit it in front of its origin.",
            )),
        }
    }
    let scene = at.log.scene;
    let free = blocker.map(|object| {
        let choice = Choice::new(free_text, format!("{} stands in between.", at.name(object)));
        let is_small = scene.primitives.len() <= MOST_TRIED;
        let made = mistakes().find(|mistake| match mistake.wrong {
            Wrong::Blocked(wrong) => is_small && !wrong(scene, &start.ray, start.range),
            _ => false,
        });
        match made {
            Some(mistake) => choice.by(mistake),
            None => choice,
        }
    });
    let wrong = free.into_iter().chain(beyond).chain(started).chain(beside);
    let [x, y, z] = start.ray.origin.to_array().map(number);
    let text = format!(
        "A shadow ray runs from ({x}, {y}, {z}) to {light}, which is {distance} away. Is the light blocked, and by what?"
    );
    Question::new(Asks::Blocked, text, at.step(), right, wrong)
}

/// The surface that a ray starts on: what the ray that spawned it has hit.
fn own_surface(at: &At) -> Option<PrimitiveId> {
    let parent = at.state.innermost()?;
    match parent.quantities.get(&Quantity::Nearest)?.value {
        Value::Hit(object, _) if Some(parent.id) == at.record().parent => Some(object),
        _ => None,
    }
}
