//! A flat JSON object: keys with scalars and lists of numbers, as one line of the log has them.

use std::borrow::Cow;
use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};

/// A value of a flat object.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Json<'a> {
    Number(f64),
    Flag(bool),
    Text(Cow<'a, str>),
    List(Vec<f64>),
}

/// The fields of a line, in their order. No key comes twice.
#[derive(Clone, Debug, Default)]
pub(super) struct FlatJson<'a> {
    fields: Vec<(Cow<'a, str>, Json<'a>)>,
    /// Where the next key is looked for first: the lines are read in the order they are written in.
    next: usize,
    taken: usize,
}

impl<'a> FlatJson<'a> {
    /// The value of a key; each is asked for once.
    pub(super) fn take(&mut self, key: &str) -> Option<&Json<'a>> {
        let count = self.fields.len();
        let at = (0..count)
            .map(|offset| (self.next + offset) % count)
            .find(|&at| self.fields[at].0 == key)?;
        self.next = at + 1;
        self.taken += 1;
        Some(&self.fields[at].1)
    }

    /// The value of a key, without counting it as asked for.
    pub(super) fn peek(&self, key: &str) -> Option<&Json<'a>> {
        let found = self.fields.iter().find(|(name, _)| name == key);
        found.map(|(_, value)| value)
    }

    /// Were all fields asked for?
    pub(super) fn all_taken(&self) -> bool {
        self.taken == self.fields.len()
    }

    /// The keys.
    pub(super) fn keys(&self) -> impl Iterator<Item = &str> {
        self.fields.iter().map(|(key, _)| &**key)
    }
}

impl<'de> Deserialize<'de> for FlatJson<'de> {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct Object;
        impl<'de> Visitor<'de> for Object {
            type Value = FlatJson<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a flat JSON object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<FlatJson<'de>, A::Error> {
                let mut fields: Vec<(Cow<'de, str>, Json<'de>)> = Vec::with_capacity(20);
                while let Some((Text(key), value)) = map.next_entry::<Text<'de>, Json<'de>>()? {
                    if fields.iter().any(|(known, _)| *known == key) {
                        return Err(A::Error::custom(format_args!(
                            "the key {key:?} comes twice"
                        )));
                    }
                    fields.push((key, value));
                }
                Ok(FlatJson {
                    fields,
                    next: 0,
                    taken: 0,
                })
            }
        }
        input.deserialize_map(Object)
    }
}

/// A string, borrowed where it has no escapes.
struct Text<'a>(Cow<'a, str>);

impl<'de> Deserialize<'de> for Text<'de> {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        match Json::deserialize(input)? {
            Json::Text(text) => Ok(Self(text)),
            _ => Err(D::Error::custom("expected a string")),
        }
    }
}

impl<'de> Deserialize<'de> for Json<'de> {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct Flat;
        impl<'de> Visitor<'de> for Flat {
            type Value = Json<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, a string, true, false or a list of numbers")
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<Json<'de>, E> {
                Ok(Json::Number(value))
            }
            fn visit_u64<E: Error>(self, value: u64) -> Result<Json<'de>, E> {
                Ok(Json::Number(value as f64))
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Json<'de>, E> {
                Ok(Json::Number(value as f64))
            }
            fn visit_bool<E: Error>(self, value: bool) -> Result<Json<'de>, E> {
                Ok(Json::Flag(value))
            }
            fn visit_borrowed_str<E: Error>(self, value: &'de str) -> Result<Json<'de>, E> {
                Ok(Json::Text(Cow::Borrowed(value)))
            }
            fn visit_str<E: Error>(self, value: &str) -> Result<Json<'de>, E> {
                Ok(Json::Text(Cow::Owned(value.into())))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Json<'de>, A::Error> {
                let mut values = Vec::with_capacity(4);
                while let Some(value) = list.next_element()? {
                    values.push(value);
                }
                Ok(Json::List(values))
            }
        }
        input.deserialize_any(Flat)
    }
}
