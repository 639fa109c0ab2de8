//! The state at each step, against what a reader collects from the events before it, from the start on.

use std::collections::BTreeMap;

use raystep::explain::Section;
use raystep::scene::PrimitiveId;
use raystep::step::{Quantity, State, StepLog, Value};
use raystep::trace::{BoundVerdict, Bounded, NodeVerdict, Purpose, QueueAction, Visibility};
use raystep::{Event, Record, StrategyName};

use super::{each_of_few, each_random};

/// What is known of a ray, collected in another way: each from the last event that says it.
#[derive(Clone, Debug, Default, PartialEq)]
struct Known {
    id: u32,
    nearest: Option<(PrimitiveId, f64)>,
    waiting: Vec<u32>,
    stamped: Vec<PrimitiveId>,
    cell: Option<[u32; 3]>,
    node: Option<u32>,
    lights: BTreeMap<u32, [f64; 3]>,
    reflected: Option<[f64; 3]>,
    refracted: Option<[f64; 3]>,
}

/// The rays that are open before an event: a ray's events lie between its start and its end.
fn open_rays(records: &[Record], event: usize) -> Vec<u32> {
    let Some(at) = event.checked_sub(1) else {
        return Vec::new();
    };
    let section = Section::of(&records[at]);
    let own = records[..event]
        .iter()
        .filter(|record| Section::of(record) == section);
    let mut open = Vec::new();
    for record in own {
        match record.event {
            Event::Ray(_) => open.extend(record.ray),
            Event::RayEnd(_) => open.retain(|&ray| Some(ray) != record.ray),
            _ => {}
        }
    }
    open
}

/// What the events of a ray say, up to an event.
fn known(log: &StepLog, id: u32, event: usize) -> Known {
    let section = Section::of(&log.records[event - 1]);
    let before = log.records[..event]
        .iter()
        .filter(|record| Section::of(record) == section);
    let has_mailboxes =
        log.settings.strategy == StrategyName::Grid && log.settings.structure.grid.mailboxes;
    let mut known = Known {
        id,
        ..Known::default()
    };
    let mut children: BTreeMap<u32, Purpose> = BTreeMap::new();
    for record in before {
        if record.parent == Some(id)
            && let (Event::Ray(start), Some(child)) = (&record.event, record.ray)
        {
            children.insert(child, start.purpose);
        }
        if let (Event::RayEnd(end), Some(child)) = (&record.event, record.ray) {
            let colour = end.colour.map(|colour| colour.to_array());
            match children.get(&child) {
                Some(Purpose::Reflected) => known.reflected = colour,
                Some(Purpose::Refracted) => known.refracted = colour,
                _ => {}
            }
        }
        if record.ray != Some(id) {
            continue;
        }
        let mut tested = None;
        match record.event {
            Event::Nearest(hit) => known.nearest = Some((hit.object, hit.t)),
            Event::BoundTest(test) => {
                if let (Bounded::Node(node), BoundVerdict::Hit) = (test.of, test.verdict) {
                    known.waiting.push(node);
                }
            }
            Event::Queue(step) => match step.action {
                QueueAction::Push => {
                    assert!(known.waiting.contains(&step.node));
                    assert_eq!(known.waiting.len(), step.size as usize);
                }
                QueueAction::Pop | QueueAction::Stop => {
                    known.waiting.retain(|&node| node != step.node);
                    assert_eq!(known.waiting.len(), step.size as usize);
                }
            },
            Event::Node(visit) => {
                known.waiting.retain(|&node| node != visit.node);
                if visit.verdict == NodeVerdict::Entered {
                    known.node = Some(visit.node);
                }
            }
            Event::Cell(visit) => known.cell = Some(visit.step.cell),
            Event::SphereTest { object, .. }
            | Event::EllipsoidTest { object, .. }
            | Event::ConeTest { object, .. }
            | Event::BoxTest { object, .. }
            | Event::PlaneTest { object, .. } => tested = Some(object),
            Event::LightTerm(light) => {
                let shines = matches!(
                    light.visibility,
                    Visibility::Visible | Visibility::NotTested
                );
                let colour = light.term.diffuse + light.term.specular;
                let colour = if shines { colour } else { 0.0 * colour };
                known.lights.insert(light.light, colour.to_array());
            }
            _ => {}
        }
        known.stamped.extend(tested.filter(|_| has_mailboxes));
    }
    known.waiting.sort_unstable();
    known.stamped.sort_unstable();
    known.stamped.dedup();
    known
}

/// The same of the state.
fn shown(state: &State) -> Vec<Known> {
    let of_ray = |ray: &raystep::step::RayState| {
        let mut known = Known {
            id: ray.id,
            ..Known::default()
        };
        for (quantity, held) in &ray.quantities {
            match (quantity, &held.value) {
                (Quantity::Nearest, Value::Hit(object, t)) => known.nearest = Some((*object, *t)),
                (Quantity::Waiting, Value::Nodes(nodes)) => {
                    assert!(nodes.is_sorted_by(|one, next| one.1 <= next.1), "{nodes:?}");
                    known.waiting = nodes.iter().map(|&(node, _)| node).collect();
                    known.waiting.sort_unstable();
                }
                (Quantity::Mailboxes, Value::Objects(objects)) => known.stamped.clone_from(objects),
                (Quantity::Cell, Value::Cell(cell, _)) => known.cell = Some(*cell),
                (Quantity::Node, Value::Node(node)) => known.node = Some(*node),
                (Quantity::Light(light), Value::Colour(colour)) => {
                    known.lights.insert(*light, colour.to_array());
                }
                (Quantity::Reflected, Value::Colour(colour)) => {
                    known.reflected = Some(colour.to_array());
                }
                (Quantity::Refracted, Value::Colour(colour)) => {
                    known.refracted = Some(colour.to_array());
                }
                _ => {}
            }
        }
        known
    };
    state.rays.iter().map(of_ray).collect()
}

/// Each event that set a value lies before, on the ray whose value it is or at the end of one that this spawned.
fn check_setters(name: &str, log: &StepLog, state: &State, event: usize) {
    for ray in &state.rays {
        for (quantity, held) in &ray.quantities {
            let by = &log.records[held.by];
            assert!(held.by < event, "{name}: {quantity:?} {held:?}");
            let is_child = matches!(by.event, Event::RayEnd(_));
            assert!(
                by.ray == Some(ray.id) || is_child,
                "{name}: {quantity:?} {held:?}"
            );
            // each bound has an interval of its own, though it begin as another did
            if matches!(quantity, Quantity::MaxNear | Quantity::MinFar) {
                assert!(
                    matches!(by.event, Event::SlabTest(_) | Event::BoundTest(_)),
                    "{name}: {quantity:?} {held:?}"
                );
                continue;
            }
            // before it, the value was another
            let before = log.state_before(held.by);
            let known = before.rays.iter().find(|known| known.id == ray.id);
            let old = known.and_then(|known| known.quantities.get(quantity));
            assert_ne!(
                old.map(|old| &old.value),
                Some(&held.value),
                "{name}: {quantity:?}"
            );
        }
    }
}

fn check(name: &str, log: &StepLog) {
    let events = log.records.len();
    // each event of a short log, and some of a long one; around a state that is kept in any case
    let apart = (events / 150).max(1);
    let all = (0..=events).step_by(apart).chain([64, 65, 128, events]);
    for event in all.filter(|&event| event <= events) {
        let state = log.state_before(event);
        let rays = open_rays(log.records, event);
        let expected: Vec<Known> = rays.iter().map(|&id| known(log, id, event)).collect();
        assert_eq!(shown(&state), expected, "{name}, before event {event}");
        if event.is_multiple_of(5) {
            check_setters(name, log, &state, event);
        }
    }
}

#[test]
fn the_state_is_what_the_events_from_the_start_on_say() {
    let logs = each_of_few(check) + each_random(check);
    assert!(200 < logs, "{logs} logs");
}

/// A state that is kept saves the way from the start, and no more: the states of a log cut off behind an event end with the
/// state before the next.
#[test]
fn the_state_before_an_event_is_the_last_state_of_the_log_up_to_there() {
    let mut compared = 0;
    let mut check = |name: &str, log: &StepLog| {
        let events = log.records.len();
        for event in (1..events).step_by((events / 12).max(1)) {
            let cut = StepLog::new(log.scene, log.settings, &log.records[..event]);
            assert_eq!(
                log.state_before(event),
                cut.state_before(event),
                "{name}, {event}"
            );
            compared += 1;
        }
    };
    each_of_few(&mut check);
    assert!(1000 < compared, "{compared}");
}
