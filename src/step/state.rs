//! What is known after an event: the rays, and of each its nearest hit, interval, nodes, mailboxes and terms.
//!
//! Each quantity knows the event that set it last. Nothing is computed here: values are those of the events, but the
//! interval, which is shown without the padding for rounding, as in the worked solution.

use std::collections::BTreeMap;

use crate::explain::Section;
use crate::geometry::SlabRay;
use crate::step::quantity::{Changed, Held, Quantity, Value};
use crate::step::setter::{Setter, take_search, take_shade};
use crate::structure::SlabStep;
use crate::trace::{
    BoundVerdict, Bounded, Event, NodeVerdict, Purpose, QueueAction, RaySlab, RayStart, Record,
    Settings, StrategyName,
};

/// The quantities of a ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RayState {
    /// Its number in the section.
    pub id: u32,
    /// Its start; `None` if the log was filtered.
    pub start: Option<RayStart>,
    /// What is known on it.
    pub quantities: BTreeMap<Quantity, Held>,
    /// S and T of the slabs that its bounds are tested with.
    slab_rays: Vec<RaySlab>,
    /// The bound whose slabs are tested, and its last slab without padding.
    slab: Option<(Bounded, SlabStep)>,
}

/// What is known after an event.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// The section that is open; `None` before the first event.
    pub section: Option<Section>,
    /// What is known beside the rays.
    pub quantities: BTreeMap<Quantity, Held>,
    /// The rays that have started and not ended, the innermost last.
    pub rays: Vec<RayState>,
    /// Does each test leave a mark in the object's mailbox?
    has_mailboxes: bool,
}

/// What an event finds open, and what begins with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::step) struct Entered {
    /// A section begins.
    pub(in crate::step) is_new_section: bool,
    /// How many rays stay open.
    pub(in crate::step) kept: usize,
    /// A ray begins, inside those.
    pub(in crate::step) is_new: bool,
    /// Has another ray ended?
    has_ended: bool,
}

impl Entered {
    pub(in crate::step) fn changed(self) -> Changed {
        if self.is_new || self.has_ended {
            Changed::of(&[Quantity::Rays])
        } else {
            Changed::default()
        }
    }
}

impl State {
    /// Before the first event of a log.
    pub(in crate::step) fn new(settings: &Settings) -> Self {
        Self {
            has_mailboxes: settings.strategy == StrategyName::Grid
                && settings.structure.grid.mailboxes,
            ..Self::default()
        }
    }

    /// The ray that events belong to now.
    pub fn innermost(&self) -> Option<&RayState> {
        self.rays.last()
    }

    /// The ray of the next event becomes the innermost, and its section the open one.
    ///
    /// In a whole log that is nothing new but for a start. In a filtered one a ray without its end ends when an event of
    /// another one follows, and a ray without its start begins with its first event.
    pub(in crate::step) fn enter(&mut self, record: &Record) -> Entered {
        let open = self.rays.len();
        let section = Some(Section::of(record));
        let is_new_section = self.section != section;
        if is_new_section {
            let has_mailboxes = self.has_mailboxes;
            *self = Self {
                section,
                has_mailboxes,
                ..Self::default()
            };
        }
        // a start is the first event of its ray, and inside the ray that spawned it
        let is_start = matches!(record.event, Event::Ray(_));
        let inside = if is_start { record.parent } else { record.ray };
        let place = inside.map(|id| self.rays.iter().rposition(|ray| ray.id == id));
        let (kept, is_known) = match place {
            None => (0, true),
            Some(Some(place)) => (place + 1, true),
            Some(None) => (0, false),
        };
        self.rays.truncate(kept);
        let new = record.ray.filter(|_| is_start || !is_known);
        self.rays.extend(new.map(|id| RayState {
            id,
            ..RayState::default()
        }));
        Entered {
            is_new_section,
            kept,
            is_new: new.is_some(),
            has_ended: kept < open,
        }
    }

    /// Takes one more event, after [`State::enter`].
    pub(in crate::step) fn take(&mut self, at: usize, record: &Record) -> Changed {
        let mut changed = Changed::default();
        self.of_section(at, record, &mut changed);
        if let Event::RayEnd(end) = record.event {
            let ended = self.rays.pop();
            changed = changed.and(Changed::of(&[Quantity::Rays]));
            let start = ended.and_then(|ray| ray.start);
            let purpose = start.map(|start| start.purpose);
            if let Some(colour) = end.colour {
                let value = Value::Colour(colour);
                match (purpose, self.rays.last_mut()) {
                    (Some(Purpose::Reflected), Some(ray)) => {
                        ray.setter(at, &mut changed).set(Quantity::Reflected, value);
                    }
                    (Some(Purpose::Refracted), Some(ray)) => {
                        ray.setter(at, &mut changed).set(Quantity::Refracted, value);
                    }
                    (Some(Purpose::Eye), None) => {
                        self.setter(at, &mut changed)
                            .set(Quantity::EyeColour, value);
                    }
                    _ => {}
                }
            }
        } else if let Some(ray) = self.rays.last_mut() {
            ray.take(at, &record.event, self.has_mailboxes, &mut changed);
        }
        changed
    }

    /// What an event says beside its ray.
    fn of_section(&mut self, at: usize, record: &Record, changed: &mut Changed) {
        let mut own = self.setter(at, changed);
        match record.event {
            Event::Path(start) => own.set(Quantity::Carried, Value::Colour(start.power)),
            Event::Photon(photon) => own.set(Quantity::Carried, Value::Colour(photon.leaving())),
            Event::Arrival(arrival) => {
                own.set(Quantity::Contribution, Value::Colour(arrival.radiance));
            }
            Event::Connection(line) => {
                own.set(Quantity::Contribution, Value::Colour(line.contribution));
            }
            Event::Pixel(_) => {
                own.clear(Quantity::Carried);
                own.clear(Quantity::Contribution);
            }
            Event::PixelColour(colour) => {
                own.set(Quantity::PixelColour, Value::Colour(colour.raw));
            }
            _ => {}
        }
    }

    fn setter<'a>(&'a mut self, by: usize, changed: &'a mut Changed) -> Setter<'a> {
        Setter {
            quantities: &mut self.quantities,
            changed,
            by,
        }
    }
}

impl RayState {
    /// S and T of a slab, if they are known.
    pub(in crate::step) fn slab_line(&self, slab: u32) -> Option<SlabRay> {
        let line = self.slab_rays.iter().find(|line| line.slab == slab);
        line.map(RaySlab::line)
    }

    fn setter<'a>(&'a mut self, by: usize, changed: &'a mut Changed) -> Setter<'a> {
        Setter {
            quantities: &mut self.quantities,
            changed,
            by,
        }
    }

    /// What an event on the ray sets.
    fn take(&mut self, at: usize, event: &Event, has_mailboxes: bool, changed: &mut Changed) {
        match event {
            Event::Ray(start) => self.start = Some(*start),
            Event::SlabRay(line) => self.slab_rays.push(*line),
            Event::SlabTest(_) | Event::BoundTest(_) | Event::Node(_) | Event::Queue(_) => {
                self.take_bound(at, event, changed);
            }
            _ => {
                let mut own = self.setter(at, changed);
                take_search(event, has_mailboxes, &mut own);
                take_shade(event, &mut own);
            }
        }
    }

    /// The interval of a bound, and the nodes that wait.
    fn take_bound(&mut self, at: usize, event: &Event, changed: &mut Changed) {
        match event {
            Event::SlabTest(test) => {
                let before = self
                    .slab
                    .filter(|(of, _)| *of == test.of && 0 < test.step.slab);
                let line = self
                    .slab_rays
                    .iter()
                    .find(|line| line.slab == test.step.slab);
                let bare = line.map_or(test.step, |line| {
                    let before = before.as_ref().map(|(_, step)| step);
                    test.step.without_room(&line.line(), before)
                });
                self.slab = Some((test.of, bare));
                let is_first = before.is_none();
                let mut own = self.setter(at, changed);
                own.bound(Quantity::MaxNear, bare.max_near, is_first);
                own.bound(Quantity::MinFar, bare.min_far, is_first);
            }
            Event::BoundTest(test) => {
                let has_slabs = self.slab.is_some_and(|(of, _)| of == test.of);
                let min = self.start.map_or(0.0, |start| start.range.min);
                let mut own = self.setter(at, changed);
                if !has_slabs {
                    let none = [f64::NEG_INFINITY, f64::INFINITY];
                    let [near, far] = test.inside.unwrap_or(none);
                    own.bound(Quantity::MaxNear, near, true);
                    own.bound(Quantity::MinFar, far, true);
                }
                if let (Bounded::Node(node), BoundVerdict::Hit) = (test.of, test.verdict) {
                    let near = test.inside.map_or(min, |[near, _]| near.max(min));
                    own.wait(node, near);
                }
            }
            Event::Node(visit) => {
                let mut own = self.setter(at, changed);
                own.leave(visit.node);
                if visit.verdict == NodeVerdict::Entered {
                    own.set(Quantity::Node, Value::Node(visit.node));
                }
            }
            Event::Queue(step) => {
                let mut own = self.setter(at, changed);
                match step.action {
                    QueueAction::Push => own.wait(step.node, step.key),
                    QueueAction::Pop | QueueAction::Stop => own.leave(step.node),
                }
            }
            _ => {}
        }
    }
}
