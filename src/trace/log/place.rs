//! What a record adds to its event in a line: which step it is, and where it belongs.

use crate::trace::event::fields::{Field, Fields, Visitor};
use crate::trace::event::place::KindPlace;
use crate::trace::event::{Event, Kind};
use crate::trace::record::Record;

impl Fields for Record {
    #[inline]
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        self.step_field(v);
        self.place_fields(v);
        self.event_fields(v);
    }
}

impl Record {
    /// A record of this kind with nothing in it, for a reader to fill.
    #[inline]
    pub(super) fn blank(kind: Kind) -> Self {
        Self {
            pixel: None,
            path: None,
            step: 0,
            ray: None,
            parent: None,
            event: kind.blank(),
        }
    }

    /// Which step it is.
    #[inline]
    pub(super) fn step_field<V: Visitor>(&mut self, v: &mut V) {
        v.field("step", "", &mut self.step);
    }

    /// What the step belongs to: the same for all steps along a ray but its start.
    #[inline]
    pub(super) fn place_fields<V: Visitor>(&mut self, v: &mut V) {
        match self.event.kind().place() {
            KindPlace::Building => {}
            KindPlace::Pixel => required(&mut self.pixel, "pixel", v),
            KindPlace::Path => required(&mut self.path, "path", v),
            KindPlace::Either => {
                v.optional("pixel", "", &mut self.pixel);
                v.optional("path", "", &mut self.path);
                if self.pixel.is_some() == self.path.is_some() {
                    v.fail("an event belongs to either a \"pixel\" or a \"path\"");
                }
            }
        }
        v.optional("ray", "", &mut self.ray);
        if let Event::Ray(_) = self.event {
            v.optional("parent", "", &mut self.parent);
        }
    }

    /// What happened in it.
    #[inline]
    pub(super) fn event_fields<V: Visitor>(&mut self, v: &mut V) {
        self.event.fields(v);
        match &mut self.event {
            Event::Pixel(sample) => sample.pixel = self.pixel.unwrap_or_default(),
            Event::Path(start) => start.path = self.path.unwrap_or_default(),
            _ => {}
        }
    }
}

/// What is always there, though it is kept as an option.
#[inline]
fn required<T: Field, V: Visitor>(value: &mut Option<T>, key: &'static str, v: &mut V) {
    let mut there = value.unwrap_or_default();
    v.field(key, "", &mut there);
    *value = Some(there);
}
