//! A value of a line without the line: what a search through many records looks at.
//!
//! The fields are those of [`line_writer`](crate::trace::log::line_writer), shown to another visitor.

use crate::scene::PrimitiveId;
use crate::trace::event::fields::{Field, Fields, ValueWriter, Visitor, Word};
use crate::trace::log::names::LogNames;
use crate::trace::record::Record;

/// Writes the value of a key as it stands in the record's line; `false` if the line has no such key.
pub(crate) fn value_of(record: &Record, names: &LogNames, key: &str, text: &mut Vec<u8>) -> bool {
    text.clear();
    if key == "kind" {
        quote(record.event.kind().name(), text);
        return true;
    }
    look(record, names, Wanted::Key(key), text)
}

/// Is a text, between its quotation marks as in JSON, a value of the record's line: its kind, a word or a name?
pub(crate) fn has_text(record: &Record, names: &LogNames, quoted: &str) -> bool {
    is_quoted(record.event.kind().name(), quoted)
        || look(record, names, Wanted::Text(quoted), &mut Vec::new())
}

fn look(record: &Record, names: &LogNames, wanted: Wanted<'_>, text: &mut Vec<u8>) -> bool {
    let mut record = *record;
    let mut values = LineValues {
        names,
        wanted,
        found: false,
        text,
    };
    record.fields(&mut values);
    values.found
}

/// What is looked for.
#[derive(Clone, Copy)]
enum Wanted<'a> {
    /// The value of a key.
    Key(&'a str),
    /// A text that is the whole value of any key.
    Text(&'a str),
}

struct LineValues<'a> {
    names: &'a LogNames,
    wanted: Wanted<'a>,
    found: bool,
    /// The value of the key.
    text: &'a mut Vec<u8>,
}

fn quote(word: &str, text: &mut Vec<u8>) {
    text.push(b'"');
    text.extend_from_slice(word.as_bytes());
    text.push(b'"');
}

/// Is this what stands between the quotation marks? A word has no letters that JSON escapes.
fn is_quoted(word: &str, quoted: &str) -> bool {
    quoted.get(1..quoted.len() - 1) == Some(word)
}

impl LineValues<'_> {
    /// A name that stands between its quotation marks already.
    fn name(&mut self, key: &str, quoted: &str) {
        match self.wanted {
            Wanted::Key(wanted) if wanted == key => {
                self.text.extend_from_slice(quoted.as_bytes());
                self.found = true;
            }
            Wanted::Text(wanted) if wanted == quoted => self.found = true,
            Wanted::Key(_) | Wanted::Text(_) => {}
        }
    }
}

impl Visitor for LineValues<'_> {
    fn field<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut T) {
        match self.wanted {
            Wanted::Key(wanted) if wanted == key => {
                // infinity has no JSON: the field is absent
                self.found = value.write(self);
            }
            Wanted::Key(_) => {}
            Wanted::Text(_) => {
                value.write(self);
            }
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
            let names = self.names;
            self.name(name, &names.objects[object as usize]);
            self.optional(face, "", &mut { number });
        }
    }

    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        if let Some(object) = value {
            let names = self.names;
            self.name(key, &names.objects[*object as usize]);
        }
    }

    fn light(&mut self, _: &'static str, value: &mut Option<u32>, _: bool) {
        if let Some(light) = value {
            let names = self.names;
            self.name("light", &names.lights[*light as usize]);
        }
    }

    fn fail(&mut self, why: &'static str) {
        debug_assert!(false, "an event of the tracer contradicts itself: {why}");
    }
}

impl ValueWriter for LineValues<'_> {
    fn number(&mut self, value: f64) -> bool {
        if matches!(self.wanted, Wanted::Key(_)) && value.is_finite() {
            let digits = zmij::Buffer::new().format(value).to_owned();
            self.text.extend_from_slice(digits.as_bytes());
        }
        value.is_finite()
    }

    fn whole(&mut self, value: u32) {
        if matches!(self.wanted, Wanted::Key(_)) {
            self.text.extend_from_slice(value.to_string().as_bytes());
        }
    }

    fn flag(&mut self, value: bool) {
        if matches!(self.wanted, Wanted::Key(_)) {
            self.text.extend_from_slice(value.to_string().as_bytes());
        }
    }

    fn word<W: Word>(&mut self, value: W) {
        let word = W::WORDS[value.place()].1;
        match self.wanted {
            Wanted::Key(_) => quote(word, self.text),
            Wanted::Text(quoted) => self.found |= is_quoted(word, quoted),
        }
    }

    fn list(&mut self, items: &[impl Field]) -> bool {
        if matches!(self.wanted, Wanted::Text(_)) {
            // no list of the log has texts
            return true;
        }
        let start = self.text.len();
        for (i, item) in items.iter().enumerate() {
            self.text.push(if i == 0 { b'[' } else { b',' });
            if !item.write(self) {
                self.text.truncate(start);
                return false;
            }
        }
        self.text.push(b']');
        true
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Map, Value};

    use super::*;
    use crate::trace::log::fast::samples::{records, scene};
    use crate::trace::write_event;

    #[test]
    fn a_value_is_the_one_that_json_reads_from_the_line() {
        let names = LogNames::new(&scene());
        let mut text = Vec::new();
        let (mut values, mut texts) = (0, 0);
        for record in records() {
            let mut line = Vec::new();
            write_event(&record, &names, &mut line);
            let line: Map<String, Value> = serde_json::from_slice(&line).unwrap();
            for (key, value) in &line {
                assert!(value_of(&record, &names, key, &mut text), "{key}");
                assert_eq!(serde_json::from_slice::<Value>(&text).unwrap(), *value);
                values += 1;
                if value.is_string() {
                    assert!(has_text(&record, &names, &value.to_string()), "{value}");
                    texts += 1;
                }
            }
            for key in ["", "no_such_key", "t_ma"] {
                assert!(!value_of(&record, &names, key, &mut text));
            }
            for word in ["no such word", "", "kin"] {
                assert!(!has_text(&record, &names, &Value::from(word).to_string()));
            }
        }
        assert!(300 < values && 100 < texts, "{values} {texts}");
    }
}
