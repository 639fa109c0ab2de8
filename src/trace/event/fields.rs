//! The fields of a log line: one list for writing, reading and the schema.
//!
//! Each kind of event lists its fields once, in [`Fields::fields`], each with its key and what it
//! means. The list is walked by three visitors: the writer puts the values into a line, the reader
//! takes them out of one, the schema describes them. So the three cannot disagree.

use glam::{DVec2, DVec3};
use serde_json::{Value, json};

use crate::scene::PrimitiveId;
use crate::trace::event::kind::KindPlace;
use crate::trace::log::fast::number_texts::NumberTexts;
use crate::trace::log::fast::scanner::Scanner;
use crate::trace::log::fast::short_text::ShortText;
use crate::trace::log::fast::small_numbers::append_whole;
use crate::trace::log::flat_json::Json;
use crate::trace::{Event, Record};

/// Something with fields in a log line.
pub(in crate::trace) trait Fields {
    /// Shows each field to the visitor, in the order of the line.
    fn fields<V: Visitor>(&mut self, visitor: &mut V);
}

/// Sees each field of an event: writes it, fills it or describes it.
pub(in crate::trace) trait Visitor {
    /// A value that is always there.
    fn field<T: Field>(&mut self, key: &'static str, meaning: &'static str, value: &mut T);

    /// A value that may be absent: an unbounded quantity, or one that does not apply.
    fn optional<T: Field>(
        &mut self,
        key: &'static str,
        meaning: &'static str,
        value: &mut Option<T>,
    );

    /// A primitive: the name of its object, and in a mesh the number of the face.
    fn object(
        &mut self,
        keys: [&'static str; 2],
        meaning: &'static str,
        value: &mut Option<PrimitiveId>,
        required: bool,
    );

    /// An object of the scene by its name, a mesh as a whole.
    fn whole_object(&mut self, key: &'static str, meaning: &'static str, value: &mut Option<u32>);

    /// A light by its name.
    fn light(&mut self, meaning: &'static str, value: &mut Option<u32>, required: bool);

    /// The fields are there and do not fit together.
    fn fail(&mut self, why: &'static str);
}

/// What a record adds to its event: where it belongs.
impl Fields for Record {
    #[inline]
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        self.step_field(v);
        self.place_fields(v);
        self.event_fields(v);
    }
}

impl Record {
    /// Which step it is.
    #[inline]
    pub(in crate::trace) fn step_field<V: Visitor>(&mut self, v: &mut V) {
        v.field("step", "", &mut self.step);
    }

    /// What the step belongs to: the same for all steps along a ray but its start.
    #[inline]
    pub(in crate::trace) fn place_fields<V: Visitor>(&mut self, v: &mut V) {
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
    pub(in crate::trace) fn event_fields<V: Visitor>(&mut self, v: &mut V) {
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

/// A value of a field, in JSON a scalar or a short list of numbers.
pub(in crate::trace) trait Field: Copy + Default {
    /// Appends the value as JSON; `false` if it has none (a number that is not finite).
    fn write(&self, texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool;

    /// Takes the value from JSON; `Err` says what was expected.
    fn read(json: &Json<'_>) -> Result<Self, String>;

    /// Takes the value from where the scanner stands; `None` if there is no such value as
    /// [`Field::write`] writes.
    fn scan(scanner: &mut Scanner<'_>) -> Option<Self>;

    /// Its JSON Schema.
    fn schema() -> Value;
}

impl Field for f64 {
    // apart, so that what is around it is small enough to stand where its key is known
    #[inline(never)]
    fn write(&self, texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        if !self.is_finite() {
            return false;
        }
        texts.append(*self, line);
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        match json {
            Json::Number(value) => Ok(*value),
            _ => Err("a number".into()),
        }
    }

    #[inline]
    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        scanner.number()
    }

    fn schema() -> Value {
        json!({ "type": "number" })
    }
}

impl Field for u32 {
    #[inline]
    fn write(&self, _: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        append_whole(*self, line);
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        match *json {
            Json::Number(value)
                if (0.0..=f64::from(Self::MAX)).contains(&value) && value.fract() == 0.0 =>
            {
                Ok(value as Self)
            }
            _ => Err("a whole number of 0 or more".into()),
        }
    }

    #[inline]
    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        scanner.whole_number()
    }

    fn schema() -> Value {
        json!({ "type": "integer", "minimum": 0, "maximum": Self::MAX })
    }
}

impl Field for bool {
    fn write(&self, _: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        line.extend_from_slice(if *self { b"true" } else { b"false" });
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        match json {
            Json::Flag(value) => Ok(*value),
            _ => Err("true or false".into()),
        }
    }

    #[inline]
    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        if scanner.take("true") {
            return Some(true);
        }
        scanner.take("false").then_some(false)
    }

    fn schema() -> Value {
        json!({ "type": "boolean" })
    }
}

/// Writes a list, or nothing and `false` if an item cannot be written.
#[inline]
fn write_list(items: &[impl Field], texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
    let start = line.len();
    for (i, item) in items.iter().enumerate() {
        line.push(if i == 0 { b'[' } else { b',' });
        if !item.write(texts, line) {
            line.truncate(start);
            return false;
        }
    }
    line.push(b']');
    true
}

/// Takes a list of that many items.
#[inline]
fn scan_list<T: Field, const N: usize>(scanner: &mut Scanner<'_>) -> Option<[T; N]> {
    let mut items = [T::default(); N];
    for (i, item) in items.iter_mut().enumerate() {
        if !scanner.take(if i == 0 { "[" } else { "," }) {
            return None;
        }
        *item = T::scan(scanner)?;
    }
    scanner.take("]").then_some(items)
}

/// A pixel or a cell.
impl<const N: usize> Field for [u32; N]
where
    [u32; N]: Default,
    [f64; N]: Default,
{
    fn write(&self, texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        write_list(self, texts, line)
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        let mut whole = Self::default();
        for (to, value) in whole.iter_mut().zip(<[f64; N]>::read(json)?) {
            *to = u32::read(&Json::Number(value))?;
        }
        Ok(whole)
    }

    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        scan_list(scanner)
    }

    fn schema() -> Value {
        json!({ "type": "array", "items": u32::schema(), "minItems": N, "maxItems": N })
    }
}

impl<const N: usize> Field for [f64; N]
where
    [f64; N]: Default,
{
    fn write(&self, texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        write_list(self, texts, line)
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        let expected = || format!("a list of {N} numbers");
        match json {
            Json::List(values) => values.as_slice().try_into().map_err(|_| expected()),
            _ => Err(expected()),
        }
    }

    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        scan_list(scanner)
    }

    fn schema() -> Value {
        json!({ "type": "array", "items": { "type": "number" }, "minItems": N, "maxItems": N })
    }
}

impl Field for DVec3 {
    fn write(&self, texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        self.to_array().write(texts, line)
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        <[f64; 3]>::read(json).map(Self::from)
    }

    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        <[f64; 3]>::scan(scanner).map(Self::from)
    }

    fn schema() -> Value {
        <[f64; 3]>::schema()
    }
}

impl Field for DVec2 {
    fn write(&self, texts: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        self.to_array().write(texts, line)
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        <[f64; 2]>::read(json).map(Self::from)
    }

    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        <[f64; 2]>::scan(scanner).map(Self::from)
    }

    fn schema() -> Value {
        <[f64; 2]>::schema()
    }
}

/// A value that is one of a few words.
pub(in crate::trace) trait Word: Copy + Default + PartialEq + 'static {
    /// Each value with its word, and what it means.
    const WORDS: &'static [(Self, &'static str, &'static str)];

    /// The word of this value between quotation marks.
    fn quoted(self) -> &'static QuotedWord;
}

/// A word and its quotation marks, as a line takes them.
pub(in crate::trace) type QuotedWord = ShortText<23>;

impl<W: Word> Field for W {
    fn write(&self, _: &mut NumberTexts, line: &mut Vec<u8>) -> bool {
        self.quoted().append_to(line);
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        let found = match json {
            Json::Text(text) => W::WORDS.iter().find(|(_, word, _)| *word == *text),
            _ => None,
        };
        found.map(|(value, ..)| *value).ok_or_else(|| {
            let words: Vec<_> = W::WORDS.iter().map(|(_, word, _)| *word).collect();
            format!("one of {}", words.join(", "))
        })
    }

    #[inline]
    fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        let text = scanner.plain_text()?;
        let found = W::WORDS.iter().find(|(_, word, _)| *word == text);
        found.map(|(value, ..)| *value)
    }

    fn schema() -> Value {
        let value = |&(_, word, meaning): &(Self, &str, &str)| json!({ "const": word, "description": meaning.trim() });
        let values: Vec<_> = W::WORDS.iter().map(value).collect();
        json!({ "type": "string", "oneOf": values })
    }
}
