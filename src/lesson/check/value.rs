//! The fields of a line: keys with numbers, words, flags or lists of numbers.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use crate::explain::shown;
use crate::trace::{Event, LogNames, Record, write_event};

/// How many digits of a number are shown: more than those that are compared.
const DIGITS: u32 = 8;

/// What stands behind a key.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Number(f64),
    Flag(bool),
    Text(String),
    List(Vec<f64>),
    /// `null`: as if the key were absent.
    Nothing,
    /// A list or an object in a list: never the value of a field.
    Deep,
}

/// The fields of a line in their order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Fields(pub(super) Vec<(String, Value)>);

impl Fields {
    /// Those of an event, as the log has them.
    pub(super) fn of(record: &Record, names: &LogNames) -> Self {
        let mut line = Vec::new();
        write_event(record, names, &mut line);
        serde_json::from_slice(&line).unwrap_or_default()
    }

    /// Those of an event that is in no log: of some pixel and ray.
    pub(super) fn of_event(event: Event, names: &LogNames) -> Self {
        let record = Record {
            pixel: Some([0, 0]),
            path: None,
            step: 0,
            ray: Some(0),
            parent: None,
            event,
        };
        Self::of(&record, names)
    }

    pub(super) fn get(&self, key: &str) -> Option<&Value> {
        let found = self.0.iter().find(|(name, _)| name == key);
        found.map(|(_, value)| value)
    }

    pub(super) fn number(&self, key: &str) -> Option<f64> {
        match self.get(key)? {
            Value::Number(number) => Some(*number),
            _ => None,
        }
    }

    pub(super) fn text(&self, key: &str) -> Option<&str> {
        match self.get(key)? {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    pub(super) fn list(&self, key: &str) -> Option<&[f64]> {
        match self.get(key)? {
            Value::List(list) => Some(list),
            _ => None,
        }
    }

    /// A point or a direction.
    pub(super) fn vector(&self, key: &str) -> Option<glam::DVec3> {
        let list: [f64; 3] = self.list(key)?.try_into().ok()?;
        Some(list.into())
    }
}

impl Value {
    /// Are both the same? Numbers within the tolerance, relative to the larger of 1 and the expected one.
    pub(super) fn is(&self, expected: &Self, tolerance: f64) -> bool {
        match (self, expected) {
            (Self::Number(yours), Self::Number(expected)) => close(*yours, *expected, tolerance),
            (Self::List(yours), Self::List(expected)) => {
                let size = expected
                    .iter()
                    .fold(1.0, |size: f64, of| size.max(of.abs()));
                yours.len() == expected.len()
                    && yours
                        .iter()
                        .zip(expected)
                        .all(|(yours, expected)| (yours - expected).abs() <= tolerance * size)
            }
            _ => self == expected,
        }
    }

    /// Do two lists differ by at most this in each number?
    pub(super) fn is_within(&self, other: &Self, most: f64) -> bool {
        match (self, other) {
            (Self::List(one), Self::List(other)) => {
                one.len() == other.len()
                    && one.iter().zip(other).all(|(a, b)| (a - b).abs() <= most)
            }
            _ => false,
        }
    }

    /// As the log has it.
    pub(super) fn json(&self) -> String {
        match self {
            Self::Number(number) => serde_json::Value::from(*number).to_string(),
            Self::Flag(flag) => flag.to_string(),
            Self::Text(text) => serde_json::Value::from(text.as_str()).to_string(),
            Self::List(list) => serde_json::Value::from(list.clone()).to_string(),
            Self::Nothing | Self::Deep => "null".into(),
        }
    }

    /// What kind of value it is, in words.
    pub(super) fn what(&self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::Flag(_) => "true or false",
            Self::Text(_) => "a word",
            Self::List(_) => "a list of numbers",
            Self::Nothing => "nothing",
            Self::Deep => "a list of other things than numbers",
        }
    }
}

/// Do two numbers differ by at most the tolerance, relative to the larger of 1 and the expected one?
pub(super) fn close(yours: f64, expected: f64, tolerance: f64) -> bool {
    (yours - expected).abs() <= tolerance * expected.abs().max(1.0)
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => f.write_str(&shown(*number, DIGITS)),
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::Text(text) => f.write_str(&text.replace(char::is_control, " ")),
            Self::List(list) => {
                let items: Vec<String> = list.iter().map(|of| shown(*of, DIGITS)).collect();
                write!(f, "({})", items.join(", "))
            }
            Self::Nothing | Self::Deep => f.write_str("nothing"),
        }
    }
}

impl<'de> Deserialize<'de> for Fields {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct Object;
        impl<'de> Visitor<'de> for Object {
            type Value = Fields;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object, as in {\"kind\": \"ray\", …}")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Fields, A::Error> {
                let mut fields: Vec<(String, Value)> = Vec::new();
                while let Some((key, value)) = map.next_entry::<String, Value>()? {
                    if fields.iter().any(|(known, _)| *known == key) {
                        return Err(A::Error::custom(format_args!(
                            "the key {key:?} comes twice"
                        )));
                    }
                    fields.push((key, value));
                }
                Ok(Fields(fields))
            }
        }
        input.deserialize_map(Object)
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = Value;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value")
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
                Ok(Value::Number(value))
            }
            fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
                Ok(Value::Number(value as f64))
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
                Ok(Value::Number(value as f64))
            }
            fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
                Ok(Value::Flag(value))
            }
            fn visit_unit<E: Error>(self) -> Result<Value, E> {
                Ok(Value::Nothing)
            }
            fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
                Ok(Value::Text(value.into()))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
                let mut values = Vec::new();
                let mut is_flat = true;
                while let Some(item) = list.next_element::<Value>()? {
                    match item {
                        Value::Number(number) => values.push(number),
                        _ => is_flat = false,
                    }
                }
                Ok(if is_flat {
                    Value::List(values)
                } else {
                    Value::Deep
                })
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
                while map.next_entry::<String, Value>()?.is_some() {}
                Ok(Value::Deep)
            }
        }
        input.deserialize_any(Any)
    }
}
