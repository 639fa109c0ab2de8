//! The fast way to write a line: what the plain writer writes, byte for byte, with fewer instructions.
//!
//! Numbers are remembered with their digits, a key and a word are put together while compiling, and the place of an event
//! is copied from the line before. [`line_writer`](crate::trace::log::line_writer) is the plain way, and the test below
//! holds both equal.

use crate::scene::PrimitiveId;
use crate::trace::event::Kind;
use crate::trace::event::fields::{Field, ValueWriter, Visitor, Word};
use crate::trace::log::fast::number_texts::NumberTexts;
use crate::trace::log::fast::quoted::Quoted;
use crate::trace::log::fast::short_text::ShortText;
use crate::trace::log::fast::small_numbers::append_whole;
use crate::trace::log::names::LogNames;
use crate::trace::record::Record;

/// Writes the events of a scene, one after the other.
#[derive(Clone, Debug)]
pub(crate) struct EventWriter<'a> {
    names: &'a LogNames,
    texts: NumberTexts,
    place: PlaceText,
}

impl<'a> EventWriter<'a> {
    /// A writer for the scene of these names.
    pub(crate) fn new(names: &'a LogNames) -> Self {
        Self {
            names,
            texts: NumberTexts::remembering(),
            place: PlaceText::default(),
        }
    }

    /// Appends a record as a line.
    #[inline]
    pub(crate) fn line(&mut self, record: &Record, lines: &mut Vec<u8>) {
        self.object(record, lines);
        lines.push(b'\n');
    }

    /// Appends a record as a JSON object.
    fn object(&mut self, record: &Record, line: &mut Vec<u8>) {
        let mut record = *record;
        LINE_STARTS[record.event.kind() as usize].append_to(line);
        let mut writer = LineWriter {
            names: self.names,
            texts: &mut self.texts,
            line,
        };
        record.step_field(&mut writer);
        self.place.append(&mut record, &mut writer);
        record.event_fields(&mut writer);
        line.push(b'}');
    }
}

/// How the lines of each kind begin, by its number.
static LINE_STARTS: [ShortText<31>; Kind::ALL.len()] = {
    let mut starts = [ShortText::EMPTY; Kind::ALL.len()];
    let mut at = 0;
    while at < starts.len() {
        let kind = Kind::ALL[at];
        let start = ShortText::EMPTY.with(b"{\"kind\":\"").expect("room");
        let start = start.with(kind.name().as_bytes()).expect("room");
        starts[kind as usize] = start.with(b"\"").expect("room");
        at += 1;
    }
    starts
};

/// The fields of a line that say where its event belongs: the next line mostly has the same.
#[derive(Clone, Debug, Default)]
struct PlaceText {
    /// Pixel, path, ray and parent of the line before.
    of: (Option<[u32; 2]>, Option<u32>, Option<u32>, Option<u32>),
    text: Vec<u8>,
}

impl PlaceText {
    /// Appends the fields of a record's place.
    #[inline]
    fn append(&mut self, record: &mut Record, writer: &mut LineWriter<'_>) {
        let of = (record.pixel, record.path, record.ray, record.parent);
        if self.of == of {
            writer.line.extend_from_slice(&self.text);
            return;
        }
        let start = writer.line.len();
        record.place_fields(writer);
        self.of = of;
        self.text.clear();
        self.text.extend_from_slice(&writer.line[start..]);
    }
}

/// Puts each field into the line.
struct LineWriter<'a> {
    names: &'a LogNames,
    texts: &'a mut NumberTexts,
    line: &'a mut Vec<u8>,
}

/// No key is longer.
const LONGEST_KEY: usize = 28;

#[expect(
    clippy::inline_always,
    reason = "where its key is known, a key is a few stores; elsewhere it is three calls"
)]
impl LineWriter<'_> {
    #[inline(always)]
    fn key(&mut self, key: &'static str) {
        // put together while compiling, and one copy into the line
        let mut text = [0; LONGEST_KEY + 4];
        let end = 2 + key.len();
        text[..2].copy_from_slice(b",\"");
        text[2..end].copy_from_slice(key.as_bytes());
        text[end..end + 2].copy_from_slice(b"\":");
        self.line.extend_from_slice(&text[..end + 2]);
    }
}

#[expect(
    clippy::inline_always,
    reason = "where its key is known, a key is a few stores; elsewhere it is three calls"
)]
impl Visitor for LineWriter<'_> {
    #[inline(always)]
    fn field<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut T) {
        let start = self.line.len();
        self.key(key);
        // infinity has no JSON: the field is absent
        if !value.write(self) {
            self.line.truncate(start);
        }
    }

    #[inline(always)]
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

    #[inline(always)]
    fn object(
        &mut self,
        [name, face]: [&'static str; 2],
        _: &'static str,
        value: &mut Option<PrimitiveId>,
        _: bool,
    ) {
        if let Some(id) = value {
            let (object, number) = self.names.primitives[id.0 as usize];
            self.key(name);
            let quoted = &self.names.objects[object as usize];
            self.line.extend_from_slice(quoted.as_bytes());
            self.optional(face, "", &mut { number });
        }
    }

    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        if let Some(object) = value {
            self.key(key);
            let quoted = &self.names.objects[*object as usize];
            self.line.extend_from_slice(quoted.as_bytes());
        }
    }

    fn light(&mut self, _: &'static str, value: &mut Option<u32>, _: bool) {
        if let Some(light) = value {
            self.key("light");
            let quoted = &self.names.lights[*light as usize];
            self.line.extend_from_slice(quoted.as_bytes());
        }
    }

    fn fail(&mut self, why: &'static str) {
        debug_assert!(false, "an event of the tracer contradicts itself: {why}");
    }
}

impl ValueWriter for LineWriter<'_> {
    // apart, so that what is around it is small enough to stand where its key is known
    #[inline(never)]
    fn number(&mut self, value: f64) -> bool {
        if !value.is_finite() {
            return false;
        }
        self.texts.append(value, self.line);
        true
    }

    #[inline]
    fn whole(&mut self, value: u32) {
        append_whole(value, self.line);
    }

    fn flag(&mut self, value: bool) {
        self.line
            .extend_from_slice(if value { b"true" } else { b"false" });
    }

    #[inline]
    fn word<W: Word>(&mut self, value: W) {
        W::QUOTED[value.place()].append_to(self.line);
    }

    #[inline]
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::log::fast::samples::{records, scene};
    use crate::trace::write_event;

    /// Each record twice in a row and all of them again, so that numbers and places are remembered.
    #[test]
    fn a_line_is_that_of_the_plain_writer_whatever_was_written_before() {
        let names = LogNames::new(&scene());
        let mut writer = EventWriter::new(&names);
        let records = records();
        let twice = records.iter().flat_map(|record| [record, record]);
        for record in twice.chain(&records) {
            let (mut fast, mut plain) = (Vec::new(), Vec::new());
            writer.line(record, &mut fast);
            write_event(record, &names, &mut plain);
            plain.push(b'\n');
            assert_eq!(String::from_utf8(fast), String::from_utf8(plain));
        }
    }
}
