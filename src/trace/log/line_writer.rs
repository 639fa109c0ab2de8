//! One record as a line of JSON: the kind, where it belongs, and each field of the table in its order.
//!
//! This is the plain way, and what a line is is said here. [`fast`](crate::trace::log::fast) writes the same for logs of
//! many lines.

use crate::scene::PrimitiveId;
use crate::trace::event::fields::{Field, Fields, ValueWriter, Visitor, Word};
use crate::trace::log::names::LogNames;
use crate::trace::record::Record;

/// Appends a single record as one JSON object, without a line's end.
pub(crate) fn write_event(record: &Record, names: &LogNames, line: &mut Vec<u8>) {
    let mut record = *record;
    line.extend_from_slice(b"{\"kind\":\"");
    line.extend_from_slice(record.event.kind().name().as_bytes());
    line.push(b'"');
    record.fields(&mut LineWriter { names, line });
    line.push(b'}');
}

/// Puts each field into the line.
struct LineWriter<'a> {
    names: &'a LogNames,
    line: &'a mut Vec<u8>,
}

impl LineWriter<'_> {
    fn key(&mut self, key: &str) {
        self.line.extend_from_slice(b",\"");
        self.line.extend_from_slice(key.as_bytes());
        self.line.extend_from_slice(b"\":");
    }

    /// A name that stands between its quotation marks already.
    fn name(&mut self, key: &str, quoted: &str) {
        self.key(key);
        self.line.extend_from_slice(quoted.as_bytes());
    }
}

impl Visitor for LineWriter<'_> {
    fn field<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut T) {
        let start = self.line.len();
        self.key(key);
        // infinity has no JSON: the field is absent
        if !value.write(self) {
            self.line.truncate(start);
        }
    }

    fn optional<T: Field>(
        &mut self,
        key: &'static str,
        meaning: &'static str,
        value: &mut Option<T>,
    ) {
        if let Some(value) = value {
            self.field(key, meaning, value);
        }
    }

    fn object(
        &mut self,
        [name, face]: [&'static str; 2],
        _: &'static str,
        value: &mut Option<PrimitiveId>,
        _: bool,
    ) {
        if let Some(id) = value {
            let (object, number) = self.names.primitives[id.0 as usize];
            self.name(name, &self.names.objects[object as usize]);
            self.optional(face, "", &mut { number });
        }
    }

    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        if let Some(object) = value {
            self.name(key, &self.names.objects[*object as usize]);
        }
    }

    fn light(&mut self, _: &'static str, value: &mut Option<u32>, _: bool) {
        if let Some(light) = value {
            self.name("light", &self.names.lights[*light as usize]);
        }
    }

    fn fail(&mut self, why: &'static str) {
        debug_assert!(false, "an event of the tracer contradicts itself: {why}");
    }
}

impl ValueWriter for LineWriter<'_> {
    /// The shortest digits that read back as the number, and `.0` behind a whole one.
    fn number(&mut self, value: f64) -> bool {
        let digits = zmij::Buffer::new().format(value).to_owned();
        if value.is_finite() {
            self.line.extend_from_slice(digits.as_bytes());
        }
        value.is_finite()
    }

    fn whole(&mut self, value: u32) {
        self.line.extend_from_slice(value.to_string().as_bytes());
    }

    fn flag(&mut self, value: bool) {
        self.line.extend_from_slice(value.to_string().as_bytes());
    }

    fn word<W: Word>(&mut self, value: W) {
        self.line.push(b'"');
        self.line
            .extend_from_slice(W::WORDS[value.place()].1.as_bytes());
        self.line.push(b'"');
    }

    fn list(&mut self, items: &[impl Field]) -> bool {
        let start = self.line.len();
        for (i, item) in items.iter().enumerate() {
            self.line.push(if i == 0 { b'[' } else { b',' });
            if !item.write(self) {
                self.line.truncate(start);
                return false;
            }
        }
        self.line.push(b']');
        true
    }
}
