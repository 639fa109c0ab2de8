//! Sets the quantities of a ray or a section, and remembers which event did.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::scene::PrimitiveId;
use crate::step::quantity::{Changed, Held, Quantity, Value};
use crate::trace::{Event, Visibility};

/// Sets quantities, and remembers which.
pub(in crate::step) struct Setter<'a> {
    pub(in crate::step) quantities: &'a mut BTreeMap<Quantity, Held>,
    pub(in crate::step) changed: &'a mut Changed,
    pub(in crate::step) by: usize,
}

impl Setter<'_> {
    /// A quantity has a value. One that it had already stays with the event that set it.
    pub(in crate::step) fn set(&mut self, quantity: Quantity, value: Value) {
        let old = self.quantities.get(&quantity);
        if old.is_none_or(|old| old.value != value) {
            let by = self.by;
            self.quantities.insert(quantity, Held { value, by });
            self.mark(quantity);
        }
    }

    /// A quantity has no value.
    pub(in crate::step) fn clear(&mut self, quantity: Quantity) {
        if self.quantities.remove(&quantity).is_some() {
            self.mark(quantity);
        }
    }

    /// A list changes in its place.
    fn edit<T>(&mut self, quantity: Quantity, empty: Value, edit: impl FnOnce(&mut Value) -> T) {
        let by = self.by;
        let held = self.quantities.entry(quantity);
        let held = held.or_insert(Held { value: empty, by });
        edit(&mut held.value);
        held.by = by;
        self.mark(quantity);
    }

    fn mark(&mut self, quantity: Quantity) {
        *self.changed = self.changed.and(Changed::of(&[quantity]));
    }

    fn waits(&self, node: u32) -> bool {
        match self
            .quantities
            .get(&Quantity::Waiting)
            .map(|held| &held.value)
        {
            Some(Value::Nodes(nodes)) => nodes.iter().any(|&(waiting, _)| waiting == node),
            _ => false,
        }
    }

    /// A node waits, behind those with a smaller t.
    pub(in crate::step) fn wait(&mut self, node: u32, key: f64) {
        if self.waits(node) {
            return;
        }
        self.edit(Quantity::Waiting, Value::Nodes(Vec::new()), |value| {
            if let Value::Nodes(nodes) = value {
                let place = nodes.partition_point(|&(_, before)| before <= key);
                nodes.insert(place, (node, key));
            }
        });
    }

    /// A node waits no more.
    pub(in crate::step) fn leave(&mut self, node: u32) {
        if !self.waits(node) {
            return;
        }
        self.edit(Quantity::Waiting, Value::Nodes(Vec::new()), |value| {
            if let Value::Nodes(nodes) = value {
                nodes.retain(|&(waiting, _)| waiting != node);
            }
        });
    }

    /// The object's mailbox has the number of the ray.
    pub(in crate::step) fn stamp(&mut self, object: PrimitiveId) {
        let known = match self
            .quantities
            .get(&Quantity::Mailboxes)
            .map(|held| &held.value)
        {
            Some(Value::Objects(objects)) => objects.binary_search(&object),
            _ => Err(0),
        };
        let Err(place) = known else {
            return;
        };
        self.edit(Quantity::Mailboxes, Value::Objects(Vec::new()), |value| {
            if let Value::Objects(objects) = value {
                objects.insert(place, object);
            }
        });
    }

    /// One end of an interval, which may be open. The first slab of a bound sets it, though it be what it was for another.
    pub(in crate::step) fn bound(&mut self, quantity: Quantity, t: f64, is_first: bool) {
        if !t.is_finite() {
            self.clear(quantity);
            return;
        }
        self.set(quantity, Value::Number(t));
        if let Some(held) = self.quantities.get_mut(&quantity).filter(|_| is_first) {
            held.by = self.by;
        }
    }
}

/// What the search for an object sets, but for bounds.
pub(in crate::step) fn take_search(event: &Event, has_mailboxes: bool, own: &mut Setter) {
    match *event {
        Event::Cell(visit) => {
            let ends = [visit.step.t_in, visit.step.t_out];
            own.set(Quantity::Cell, Value::Cell(visit.step.cell, ends));
        }
        Event::SphereTest { object, .. }
        | Event::EllipsoidTest { object, .. }
        | Event::ConeTest { object, .. }
        | Event::BoxTest { object, .. }
            if has_mailboxes =>
        {
            own.stamp(object);
        }
        Event::PlaneTest { object, .. } => {
            own.clear(Quantity::Crossings);
            if has_mailboxes {
                own.stamp(object);
            }
        }
        Event::Edge { edge, .. } if edge.counts => {
            let known = own.quantities.get(&Quantity::Crossings);
            let before = match known.map(|held| &held.value) {
                Some(Value::Count(count)) => *count,
                _ => 0,
            };
            own.set(Quantity::Crossings, Value::Count(before + 1));
        }
        Event::Nearest(hit) => own.set(Quantity::Nearest, Value::Hit(hit.object, hit.t)),
        _ => {}
    }
}

/// What the shade of a point sets.
pub(in crate::step) fn take_shade(event: &Event, own: &mut Setter) {
    match *event {
        Event::LightTerm(light) => {
            let colour = match light.visibility {
                Visibility::Visible | Visibility::NotTested => {
                    light.term.diffuse + light.term.specular
                }
                Visibility::Shadowed | Visibility::FacesAway => DVec3::ZERO,
            };
            own.set(Quantity::Light(light.light), Value::Colour(colour));
        }
        Event::Gathered(found) => own.set(Quantity::Gathered, Value::Colour(found.radiance)),
        Event::Shade(shade) => {
            own.set(Quantity::Ambient, Value::Colour(shade.ambient));
            own.set(Quantity::LightSum, Value::Colour(shade.direct));
            for (quantity, weight) in [
                (Quantity::Reflection, shade.reflection),
                (Quantity::Transmission, shade.transmission),
            ] {
                if 0.0 < weight {
                    own.set(quantity, Value::Number(weight));
                }
            }
        }
        _ => {}
    }
}
