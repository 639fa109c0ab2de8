//! Where a question is asked, and what is known there.

use crate::explain::name::primitive_name;
use crate::explain::{printable, shown};
use crate::geometry::TRange;
use crate::scene::PrimitiveId;
use crate::step::quantity::{Quantity, Value};
use crate::step::state::{RayState, State};
use crate::step::tree::StepLog;
use crate::trace::{Bounded, Record};

/// Significant digits of the numbers in a question, as in the worked solution.
const DIGITS: u32 = 6;

/// Two numbers are not told apart within this share of them: the sixth digit is rounded.
const ALIKE: f64 = 1e-5;

/// Where a question is asked.
pub(super) struct At<'a, 'l> {
    pub(super) log: &'a StepLog<'l>,
    /// The step that asks.
    pub(super) number: usize,
    /// The event before which it is asked.
    pub(super) event: usize,
    /// What is known before that event.
    pub(super) state: State,
}

impl<'a, 'l> At<'a, 'l> {
    pub(super) fn new(log: &'a StepLog<'l>, number: usize, event: usize) -> Self {
        Self {
            log,
            number,
            event,
            state: log.state_before(event),
        }
    }

    pub(super) fn record(&self) -> &Record {
        &self.log.records[self.event]
    }

    /// The number of the event in the log.
    pub(super) fn step(&self) -> u32 {
        self.record().step
    }

    /// The events of the step.
    pub(super) fn events(&self) -> &[Record] {
        &self.log.records[self.log.step(self.number).events.clone()]
    }

    /// The ray that the event is on, unless the log was filtered.
    pub(super) fn ray(&self) -> Option<&RayState> {
        let ray = self.state.innermost()?;
        (Some(ray.id) == self.record().ray).then_some(ray)
    }

    /// The nearest hit so far.
    pub(super) fn nearest(&self) -> Option<(PrimitiveId, f64)> {
        match self.ray()?.quantities.get(&Quantity::Nearest)?.value {
            Value::Hit(object, t) => Some((object, t)),
            _ => None,
        }
    }

    /// Which t count here: those of the ray, up to the nearest hit.
    pub(super) fn range(&self) -> Option<TRange> {
        let range = self.ray()?.start?.range;
        Some(match self.nearest() {
            Some((_, t)) => range.up_to(t),
            None => range,
        })
    }

    pub(super) fn name(&self, object: PrimitiveId) -> String {
        primitive_name(self.log.scene, object)
    }

    pub(super) fn bound_name(&self, of: Bounded) -> String {
        match of {
            Bounded::Node(node) => format!("node {node}"),
            Bounded::Object(object) => {
                let object = self.log.scene.objects.get(object as usize);
                object.map_or("an object".into(), |object| printable(&object.name))
            }
        }
    }

    /// `t counts from 0 to 7.92, the nearest hit so far`
    pub(super) fn range_text(&self, range: TRange) -> String {
        let is_start = range.min <= 0.0;
        let from = if is_start {
            "0".to_owned()
        } else {
            format!("ε = {}", number(range.min))
        };
        match self.nearest() {
            Some((_, t)) if t <= range.max => {
                format!(
                    "t counts from {from} to {}, the nearest hit so far",
                    number(t)
                )
            }
            _ if range.max < f64::INFINITY => {
                format!("t counts from {from} to {}", number(range.max))
            }
            _ if is_start => "every t above 0 counts".into(),
            _ => format!("every t from {from} on counts"),
        }
    }
}

/// A number as a question shows it.
pub(super) fn number(x: f64) -> String {
    if x == f64::INFINITY {
        "∞".into()
    } else if x == f64::NEG_INFINITY {
        "−∞".into()
    } else {
        shown(x, DIGITS)
    }
}

/// Are two numbers so near each other that those that are shown do not decide between them?
pub(super) fn alike(a: f64, b: f64) -> bool {
    let size = a.abs().max(b.abs());
    a == b || (size.is_finite() && (a - b).abs() <= ALIKE * size)
}

/// `a`, `a and b`, `a, b and c`
pub(super) fn listed(words: &[String]) -> String {
    match words {
        [] => "none".into(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
