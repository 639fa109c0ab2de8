//! Which step set a value?

use crate::scene::PrimitiveId;
use crate::step::address::Address;
use crate::step::quantity::{Held, Quantity, Value};
use crate::step::tree::StepLog;
use crate::trace::{BoundVerdict, Event, RayVerdict, WalkEnd};

/// The words by which a reader asks for a quantity.
pub(in crate::step) const WORDS: [(&str, &[Quantity]); 16] = [
    ("t", &[Quantity::Nearest]),
    ("nearest", &[Quantity::Nearest]),
    ("near", &[Quantity::MaxNear]),
    ("far", &[Quantity::MinFar]),
    ("crossings", &[Quantity::Crossings]),
    ("node", &[Quantity::Node]),
    ("cell", &[Quantity::Cell]),
    ("heap", &[Quantity::Waiting]),
    ("waiting", &[Quantity::Waiting]),
    ("mailboxes", &[Quantity::Mailboxes]),
    ("ambient", &[Quantity::Ambient]),
    ("lights", &[Quantity::LightSum]),
    ("reflected", &[Quantity::Reflected]),
    ("refracted", &[Quantity::Refracted]),
    ("carried", &[Quantity::Carried]),
    ("colour", COLOURS),
];

/// The terms of a colour; each light has one, too.
const COLOURS: &[Quantity] = &[
    Quantity::Contribution,
    Quantity::EyeColour,
    Quantity::PixelColour,
    Quantity::Gathered,
    Quantity::Ambient,
    Quantity::LightSum,
    Quantity::Reflected,
    Quantity::Refracted,
];

/// What a reader asks for: one of several quantities, the one that was set last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asked(&'static [Quantity]);

impl Asked {
    /// The quantity with a word.
    pub fn named(word: &str) -> Option<Self> {
        let known = WORDS.iter().find(|(name, _)| *name == word);
        known.map(|(_, quantities)| Self(quantities))
    }

    /// The words, for a message.
    pub fn words() -> impl Iterator<Item = &'static str> {
        WORDS.iter().map(|(word, _)| *word)
    }

    /// Is it one of them?
    pub(crate) fn holds(self, quantity: Quantity) -> bool {
        let is_light = self.0 == COLOURS && matches!(quantity, Quantity::Light(_));
        is_light || self.0.contains(&quantity)
    }
}

/// Who set a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Setter {
    /// The quantity.
    pub quantity: Quantity,
    /// Its value before the step that asks.
    pub value: Value,
    /// The event that set it.
    pub event: usize,
}

impl Setter {
    /// What is said of it: `nearest hit: A at t = 7.92, set by step 3`.
    pub fn text(&self, log: &StepLog) -> String {
        format!(
            "{}: {}, set by step {}",
            self.quantity.name(log.scene),
            self.value.text(log.scene),
            Address::of(log, self.event)
        )
    }
}

impl StepLog<'_> {
    /// Who set a quantity that had its value when a step began? On the ray of the step, or on a ray that holds it.
    ///
    /// Where nothing is asked for, it is what the step itself has looked at: the nearest t, where something lies beyond it; the
    /// interval of a slab; the test that left the mark in a mailbox; a term of the colour. `None` if nothing is set.
    pub fn who_set(&self, step: usize, asked: Option<Asked>) -> Option<Setter> {
        let Some(asked) = asked else {
            return self.who_set_what_it_looks_at(step);
        };
        let state = self.state_before(self.step(step).events.start);
        let rays = state.rays.iter().rev().map(|ray| &ray.quantities);
        let mut levels = rays.chain([&state.quantities]);
        levels.find_map(|quantities| {
            let wanted = quantities
                .iter()
                .filter(|(quantity, _)| asked.holds(**quantity));
            let last = wanted.max_by_key(|(_, held)| held.by)?;
            let (quantity, Held { value, by }) = last;
            Some(Setter {
                quantity: *quantity,
                value: value.clone(),
                event: *by,
            })
        })
    }

    fn who_set_what_it_looks_at(&self, step: usize) -> Option<Setter> {
        let lead = self.step(step).lead;
        if let Event::Mailbox { object } = self.records[lead].event {
            return self.who_stamped(lead, object);
        }
        let nearest = Asked(&[Quantity::Nearest]);
        let interval = Asked(&[Quantity::MaxNear, Quantity::MinFar]);
        let first = match &self.records[lead].event {
            Event::SlabTest(_) => interval,
            Event::BoundTest(test) if test.verdict != BoundVerdict::Beyond => interval,
            Event::Edge { .. } | Event::PolygonTest { .. } => Asked(&[Quantity::Crossings]),
            Event::GridExit(exit) if exit.end != WalkEnd::HitInCell => Asked(&[Quantity::Cell]),
            Event::Cell(_) => Asked(&[Quantity::Cell]),
            Event::LightTerm(_)
            | Event::Shade(_)
            | Event::PixelColour(_)
            | Event::Gathered(_)
            | Event::Arrival(_)
            | Event::Connection(_) => Asked(COLOURS),
            Event::RayEnd(end) if end.verdict == RayVerdict::Hit => Asked(COLOURS),
            Event::Photon(_) => Asked(&[Quantity::Carried]),
            _ => nearest,
        };
        [first, nearest, Asked(COLOURS), interval]
            .into_iter()
            .find_map(|asked| self.who_set(step, Some(asked)))
    }

    /// The test of an object on the ray of an event, before it.
    fn who_stamped(&self, event: usize, object: PrimitiveId) -> Option<Setter> {
        let state = self.state_before(event);
        let held = state.innermost()?.quantities.get(&Quantity::Mailboxes)?;
        let ray = self.records[event].ray;
        let is_its_test = |&at: &usize| {
            let record = &self.records[at];
            record.ray == ray && tests(&record.event, object)
        };
        Some(Setter {
            quantity: Quantity::Mailboxes,
            value: held.value.clone(),
            event: (0..event).rev().find(is_its_test)?,
        })
    }
}

/// Is an object tested?
fn tests(event: &Event, tested: PrimitiveId) -> bool {
    match event {
        Event::SphereTest { object, .. }
        | Event::EllipsoidTest { object, .. }
        | Event::ConeTest { object, .. }
        | Event::BoxTest { object, .. }
        | Event::PlaneTest { object, .. } => *object == tested,
        _ => false,
    }
}
