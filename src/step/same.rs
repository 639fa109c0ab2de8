//! The same place in another log of the same scene: with another strategy, or of another pixel.

use crate::explain::Section;
use crate::scene::PrimitiveId;
use crate::step::level::Level;
use crate::step::tree::StepLog;
use crate::trace::{Event, Record};

/// The step of a log that is most like a step of another one: the test of the same object on the same ray, or the first event
/// of the same kind on it, or the ray, or the section. `None` if the log is empty.
pub fn same_place(from: &StepLog, number: usize, to: &StepLog) -> Option<usize> {
    let step = from.step(number);
    let lead = &from.records[step.lead];
    let wanted = Section::of(lead);
    let of_section = |&section: &usize| {
        let first = &to.records[to.step(section).events.start];
        Section::of(first) == wanted
    };
    let section = to.sections().find(of_section).or(to.sections().last())?;
    if step.level == Level::Section || lead.ray.is_none() && !step.is_leaf() {
        return Some(section);
    }
    let events = to.step(section).events.clone();
    let own = |event: &usize| to.records[*event].ray == lead.ray;
    let of_ray: Vec<usize> = events.filter(own).collect();
    let Some(&first) = of_ray.first() else {
        return Some(section);
    };
    let ray = to.above(to.leaf(first)).find(|&above| {
        let above = to.step(above);
        above.level == Level::Ray && to.records[above.lead].ray == lead.ray
    });
    if step.level == Level::Ray {
        return Some(ray.unwrap_or(section));
    }
    let object = object_of(lead);
    let same_object =
        |event: &&usize| object.is_some() && object_of(&to.records[**event]) == object;
    let same_kind = |event: &&usize| to.records[**event].event.kind() == lead.event.kind();
    let found = of_ray.iter().find(same_object);
    let found = found.or_else(|| of_ray.iter().find(same_kind));
    Some(found.map_or(ray.unwrap_or(section), |&event| to.landing(event)))
}

/// The object that an event tests.
fn object_of(record: &Record) -> Option<PrimitiveId> {
    match record.event {
        Event::SphereTest { object, .. }
        | Event::EllipsoidTest { object, .. }
        | Event::ConeTest { object, .. }
        | Event::BoxTest { object, .. }
        | Event::PlaneTest { object, .. } => Some(object),
        _ => None,
    }
}
