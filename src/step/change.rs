//! What a step changed: each quantity, old → new.

use std::collections::BTreeMap;

use crate::explain::name::{light_title, primitive_name};
use crate::explain::{cell_name, grouped, shown};
use crate::scene::Scene;
use crate::step::quantity::{Held, Quantity, Value};
use crate::step::state::State;
use crate::step::tree::StepLog;
use crate::trace::Record;

/// Significant digits, as in the worked solution.
const DIGITS: u32 = 6;

/// So many nodes or objects of a list are named: a line has room for no more.
const NAMED: usize = 6;

/// A quantity that a step changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The ray whose quantity it is; `None` of one beside the rays.
    pub ray: Option<u32>,
    /// The quantity.
    pub quantity: Quantity,
    /// Its value before the step; `None` if it had none.
    pub old: Option<Value>,
    /// Its value after the step; `None` if it has none.
    pub new: Option<Value>,
}

impl StepLog<'_> {
    /// What is known after a step.
    pub fn state_after(&self, step: usize) -> State {
        self.state_before(self.step(step).events.end)
    }

    /// What a step changed, of the rays that go on after it; of a ray that it ends only that it ended.
    pub fn changes(&self, step: usize) -> Vec<Change> {
        let events = &self.step(step).events;
        changes(
            &self.state_before(events.start),
            &self.state_before(events.end),
        )
    }
}

impl StepLog<'_> {
    /// What each event changed, in one pass: as [`StepLog::changes`] of its leaf.
    pub fn changes_by_event(&self) -> Vec<Vec<Change>> {
        let mut state = self.state_before(0);
        let of_event = |(at, record): (usize, &Record)| {
            let before = state.clone();
            state.enter(record);
            state.take(at, record);
            changes(&before, &state)
        };
        self.records.iter().enumerate().map(of_event).collect()
    }
}

/// What is another in the second state.
fn changes(before: &State, after: &State) -> Vec<Change> {
    let mut changes = Vec::new();
    let ids = |state: &State| -> Vec<u32> { state.rays.iter().map(|ray| ray.id).collect() };
    let nothing = BTreeMap::new();
    // the sections of a log have nothing in common
    let same_section = before.section == after.section;
    let (old, new) = (ids(before), ids(after));
    if old != new {
        let rays = |ids: Vec<u32>| Some(Value::Rays(ids)).filter(|_| same_section);
        changes.push(Change {
            ray: None,
            quantity: Quantity::Rays,
            old: rays(old),
            new: Some(Value::Rays(new)),
        });
    }
    let old = if same_section {
        &before.quantities
    } else {
        &nothing
    };
    of_each(None, old, &after.quantities, &mut changes);
    for ray in &after.rays {
        let known = before.rays.iter().find(|known| known.id == ray.id);
        let known = known.filter(|_| same_section);
        let old = known.map_or(&nothing, |known| &known.quantities);
        of_each(Some(ray.id), old, &ray.quantities, &mut changes);
    }
    changes
}

fn of_each(
    ray: Option<u32>,
    old: &BTreeMap<Quantity, Held>,
    new: &BTreeMap<Quantity, Held>,
    changes: &mut Vec<Change>,
) {
    let value = |quantities: &BTreeMap<Quantity, Held>, quantity: &Quantity| {
        quantities.get(quantity).map(|held| held.value.clone())
    };
    let mut all: Vec<Quantity> = old.keys().chain(new.keys()).copied().collect();
    all.sort_unstable();
    all.dedup();
    for quantity in all {
        let (old, new) = (value(old, &quantity), value(new, &quantity));
        if old != new {
            changes.push(Change {
                ray,
                quantity,
                old,
                new,
            });
        }
    }
}

impl Change {
    /// `nearest hit: B at t = 9 → A at t = 7.92`.
    pub fn text(&self, scene: &Scene) -> String {
        let value = |value: &Option<Value>| match value {
            None => "none".into(),
            Some(value) => value.text(scene),
        };
        format!(
            "{}: {} → {}",
            self.quantity.name(scene),
            value(&self.old),
            value(&self.new)
        )
    }
}

impl Quantity {
    /// What people call it.
    pub fn name(self, scene: &Scene) -> String {
        match self {
            Self::Rays => "open rays",
            Self::Carried => "carried",
            Self::Contribution => "contribution",
            Self::EyeColour => "colour of the eye ray",
            Self::PixelColour => "colour of the pixel",
            Self::Nearest => "nearest hit",
            Self::MaxNear => "max near",
            Self::MinFar => "min far",
            Self::Crossings => "crossings",
            Self::Node => "node",
            Self::Cell => "cell",
            Self::Waiting => "waiting nodes",
            Self::Mailboxes => "mailboxes with this ray",
            Self::Light(light) => return light_title(scene, light),
            Self::Gathered => "gathered light",
            Self::Ambient => "ambient",
            Self::LightSum => "sum over the visible lights",
            Self::Reflection => "reflection",
            Self::Transmission => "transmission",
            Self::Reflected => "I_reflected",
            Self::Refracted => "I_refracted",
        }
        .into()
    }
}

impl Value {
    /// The value as people read it.
    pub fn text(&self, scene: &Scene) -> String {
        let number = |x: f64| shown(x, DIGITS);
        match self {
            Self::Hit(object, t) => {
                format!("{} at t = {}", primitive_name(scene, *object), number(*t))
            }
            Self::Number(x) => number(*x),
            Self::Count(count) => grouped(u64::from(*count)),
            Self::Node(node) => node.to_string(),
            Self::Cell(cell, [t_in, t_out]) => {
                let name = cell_name(*cell);
                if t_out.is_finite() {
                    format!("{name}, t in [{}, {}]", number(*t_in), number(*t_out))
                } else {
                    format!("{name}, t from {}", number(*t_in))
                }
            }
            Self::Nodes(nodes) => {
                let name = |&(node, t): &(u32, f64)| format!("{node} at t = {}", number(t));
                list(nodes, name)
            }
            Self::Objects(objects) => list(objects, |&object| primitive_name(scene, object)),
            Self::Rays(rays) => list(rays, u32::to_string),
            Self::Colour(colour) => {
                let [r, g, b] = colour.to_array().map(number);
                format!("({r}, {g}, {b})")
            }
        }
    }
}

/// The first items of a list, and how many more there are.
fn list<T>(items: &[T], name: impl Fn(&T) -> String) -> String {
    if items.is_empty() {
        return "none".into();
    }
    let names: Vec<String> = items.iter().take(NAMED).map(name).collect();
    let text = names.join(", ");
    match items.len().saturating_sub(NAMED) {
        0 => text,
        more => format!("{text} and {} more", grouped(more as u64)),
    }
}
