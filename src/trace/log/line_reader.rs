//! One line of a log back into a record, or the first thing that is wrong with it.

use crate::scene::{PrimitiveId, nearest_name};
use crate::trace::event::fields::{Field, Fields, ValueReader, Visitor, Word};
use crate::trace::log::fast::scan_event;
use crate::trace::log::flat_json::{FlatJson, Json};
use crate::trace::log::name_table::NameTable;
use crate::trace::{Kind, LogError, Record};

/// What is wrong in a line.
pub(super) struct Damage {
    pub(super) column: Option<usize>,
    pub(super) what: String,
}

impl Damage {
    /// Damage to a line that is JSON.
    pub(super) fn new(what: impl Into<String>) -> Self {
        Self {
            column: None,
            what: what.into(),
        }
    }

    /// What `serde_json` said, with its place taken out of the sentence.
    pub(super) fn json(error: &serde_json::Error) -> Self {
        let message = error.to_string();
        let end = message.rfind(" at line ").unwrap_or(message.len());
        Self {
            column: (0 < error.column()).then(|| error.column()),
            what: message[..end].into(),
        }
    }

    /// The error, with its place.
    pub(super) fn at(self, file: &str, line: usize) -> LogError {
        LogError::Line {
            file: file.into(),
            line,
            column: self.column,
            what: self.what,
        }
    }
}

/// Fills in the record that a line holds: in its place, for to copy a record takes as long as to read a number.
#[inline]
pub(super) fn parse_event(
    line: &[u8],
    names: &NameTable,
    record: &mut Record,
) -> Result<(), Damage> {
    if scan_event(line, names, record).is_none() {
        *record = read_event(line, names)?;
    }
    Ok(())
}

/// The same for a line whose keys stand in any order, and in whatever form JSON allows.
pub(super) fn read_event(line: &[u8], names: &NameTable) -> Result<Record, Damage> {
    if line.trim_ascii().is_empty() {
        return Err(Damage::new("the line is empty"));
    }
    let fields: FlatJson<'_> = serde_json::from_slice(line).map_err(|e| Damage::json(&e))?;
    let kind = match fields.peek("kind") {
        Some(Json::Text(name)) => Kind::named(name).ok_or_else(|| {
            let known = Kind::ALL.into_iter().map(Kind::name);
            let hint = nearest_name(name, known).map(|near| format!(", did you mean {near:?}?"));
            Damage::new(format!(
                "there is no kind {name:?}{}",
                hint.unwrap_or_default()
            ))
        })?,
        _ => return Err(Damage::new("the line has no \"kind\"")),
    };
    let mut reader = LineReader {
        names,
        fields,
        damage: None,
    };
    let mut record = Record::blank(kind);
    reader.fields.take("kind");
    record.fields(&mut reader);
    reader.finish(kind)?;
    Ok(record)
}

/// Takes each field out of the line; keeps the first thing that is wrong.
struct LineReader<'a> {
    names: &'a NameTable,
    fields: FlatJson<'a>,
    damage: Option<String>,
}

impl LineReader<'_> {
    fn finish(self, kind: Kind) -> Result<(), Damage> {
        if let Some(what) = self.damage {
            return Err(Damage::new(what));
        }
        if self.fields.all_taken() {
            return Ok(());
        }
        // something is left over: ask for the key that the kind does not have
        let known = crate::trace::log::event_schema::keys_of(kind);
        let extra = self
            .fields
            .keys()
            .find(|key| !known.iter().any(|k| k == key));
        let extra = extra.unwrap_or_default();
        let what = format!("the key {extra:?} does not belong to {:?}", kind.name());
        Err(Damage::new(what))
    }

    fn expect<T>(&mut self, key: &str, value: Result<T, String>) -> Option<T> {
        value
            .map_err(|expected| self.wrong(format!("{key:?} must be {expected}")))
            .ok()
    }

    fn wrong(&mut self, what: String) {
        self.damage.get_or_insert(what);
    }
}

impl Visitor for LineReader<'_> {
    #[inline]
    fn field<T: Field>(&mut self, key: &'static str, meaning: &'static str, value: &mut T) {
        let mut found = None;
        self.optional(key, meaning, &mut found);
        match found {
            Some(found) => *value = found,
            None => self.wrong(format!("the key {key:?} is missing")),
        }
    }

    #[inline]
    fn optional<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut Option<T>) {
        let found = self.fields.take(key).map(|mut json| T::read(&mut json));
        *value = found.and_then(|found| self.expect(key, found));
    }

    fn object(
        &mut self,
        [name_key, face_key]: [&'static str; 2],
        _: &'static str,
        value: &mut Option<PrimitiveId>,
        required: bool,
    ) {
        *value = None;
        let name = match self.fields.take(name_key) {
            Some(Json::Text(name)) => name.clone(),
            Some(_) => return self.wrong(format!("{name_key:?} must be a string")),
            None if required => return self.wrong(format!("the key {name_key:?} is missing")),
            None => return,
        };
        let mut face: Option<u32> = None;
        self.optional(face_key, "", &mut face);
        let Some(object) = self.names.objects.get(&*name) else {
            return self.wrong(format!("there is no object {name:?}"));
        };
        *value = object.primitive(face);
        if value.is_none() {
            self.wrong(format!("{face_key:?} does not fit the object {name:?}"));
        }
    }

    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        *value = None;
        match self.fields.take(key) {
            Some(Json::Text(name)) => match self.names.objects.get(&**name) {
                Some(object) => *value = Some(object.place),
                None => {
                    let what = format!("there is no object {name:?}");
                    self.wrong(what);
                }
            },
            Some(_) => self.wrong(format!("{key:?} must be a string")),
            None => {}
        }
    }

    fn light(&mut self, _: &'static str, value: &mut Option<u32>, required: bool) {
        *value = None;
        match self.fields.take("light") {
            Some(Json::Text(name)) => match self.names.lights.get(&**name) {
                Some(&light) => *value = Some(light),
                None => {
                    let what = format!("there is no light {name:?}");
                    self.wrong(what);
                }
            },
            Some(_) => self.wrong("\"light\" must be a string".into()),
            None if required => self.wrong("the key \"light\" is missing".into()),
            None => {}
        }
    }

    fn fail(&mut self, why: &'static str) {
        self.wrong(why.into());
    }
}

/// What was expected is said in words.
impl ValueReader for &Json<'_> {
    type Wrong = String;

    fn number(&mut self) -> Result<f64, String> {
        match self {
            Json::Number(value) => Ok(*value),
            _ => Err("a number".into()),
        }
    }

    fn whole(&mut self) -> Result<u32, String> {
        match **self {
            Json::Number(value)
                if (0.0..=f64::from(u32::MAX)).contains(&value) && value.fract() == 0.0 =>
            {
                Ok(value as u32)
            }
            _ => Err("a whole number of 0 or more".into()),
        }
    }

    fn flag(&mut self) -> Result<bool, String> {
        match self {
            Json::Flag(value) => Ok(*value),
            _ => Err("true or false".into()),
        }
    }

    fn word<W: Word>(&mut self) -> Result<W, String> {
        let found = match self {
            Json::Text(text) => W::WORDS.iter().find(|(_, word, _)| *word == *text),
            _ => None,
        };
        found.map(|(value, ..)| *value).ok_or_else(|| {
            let words: Vec<_> = W::WORDS.iter().map(|(_, word, _)| *word).collect();
            format!("one of {}", words.join(", "))
        })
    }

    fn list<T: Field, const N: usize>(&mut self) -> Result<[T; N], String> {
        let values = match self {
            Json::List(values) if values.len() == N => values,
            _ => return Err(format!("a list of {N} numbers")),
        };
        let mut items = [T::default(); N];
        for (item, value) in items.iter_mut().zip(values) {
            *item = T::read(&mut &Json::Number(*value))?;
        }
        Ok(items)
    }

    fn wrong(&mut self, expected: &'static str) -> String {
        expected.into()
    }
}
