//! The fields of a log line: one list for writing, reading and the schema.
//!
//! Each kind of event lists its fields once, in [`Fields::fields`], each with its key and what it
//! means. The list is walked by three visitors: the writer puts the values into a line, the reader
//! takes them out of one, the schema describes them. So the three cannot disagree.

use glam::{DVec2, DVec3};
use serde_json::{Value, json};

use crate::scene::PrimitiveId;
use crate::trace::flat_json::Json;

/// Something with fields in a log line.
pub(super) trait Fields {
    /// Shows each field to the visitor, in the order of the line.
    fn fields<V: Visitor>(&mut self, visitor: &mut V);
}

/// Sees each field of an event: writes it, fills it or describes it.
pub(super) trait Visitor {
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

/// A value of a field, in JSON a scalar or a short list of numbers.
pub(super) trait Field: Copy + Default {
    /// Appends the value as JSON; `false` if it has none (a number that is not finite).
    fn write(&self, line: &mut Vec<u8>) -> bool;

    /// Takes the value from JSON; `Err` says what was expected.
    fn read(json: &Json<'_>) -> Result<Self, String>;

    /// Its JSON Schema.
    fn schema() -> Value;
}

impl Field for f64 {
    #[inline]
    fn write(&self, line: &mut Vec<u8>) -> bool {
        if !self.is_finite() {
            return false;
        }
        // writing to a Vec cannot fail
        serde_json::to_writer(line, self).is_ok()
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        match json {
            Json::Number(value) => Ok(*value),
            _ => Err("a number".into()),
        }
    }

    fn schema() -> Value {
        json!({ "type": "number" })
    }
}

impl Field for u32 {
    #[inline]
    fn write(&self, line: &mut Vec<u8>) -> bool {
        serde_json::to_writer(line, self).is_ok()
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

    fn schema() -> Value {
        json!({ "type": "integer", "minimum": 0, "maximum": Self::MAX })
    }
}

impl Field for bool {
    fn write(&self, line: &mut Vec<u8>) -> bool {
        line.extend_from_slice(if *self { b"true" } else { b"false" });
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        match json {
            Json::Flag(value) => Ok(*value),
            _ => Err("true or false".into()),
        }
    }

    fn schema() -> Value {
        json!({ "type": "boolean" })
    }
}

impl<const N: usize> Field for [f64; N]
where
    [f64; N]: Default,
{
    fn write(&self, line: &mut Vec<u8>) -> bool {
        let start = line.len();
        for (i, value) in self.iter().enumerate() {
            line.push(if i == 0 { b'[' } else { b',' });
            if !value.write(line) {
                line.truncate(start);
                return false;
            }
        }
        line.push(b']');
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        let expected = || format!("a list of {N} numbers");
        match json {
            Json::List(values) => values.as_slice().try_into().map_err(|_| expected()),
            _ => Err(expected()),
        }
    }

    fn schema() -> Value {
        json!({ "type": "array", "items": { "type": "number" }, "minItems": N, "maxItems": N })
    }
}

impl Field for [u32; 3] {
    fn write(&self, line: &mut Vec<u8>) -> bool {
        for (i, value) in self.iter().enumerate() {
            line.push(if i == 0 { b'[' } else { b',' });
            value.write(line);
        }
        line.push(b']');
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        let expected = || "a list of 3 whole numbers of 0 or more".to_string();
        let values = <[f64; 3]>::read(json).map_err(|_| expected())?;
        let mut whole = [0; 3];
        for (to, value) in whole.iter_mut().zip(values) {
            *to = u32::read(&Json::Number(value)).map_err(|_| expected())?;
        }
        Ok(whole)
    }

    fn schema() -> Value {
        json!({ "type": "array", "items": u32::schema(), "minItems": 3, "maxItems": 3 })
    }
}

impl Field for DVec3 {
    fn write(&self, line: &mut Vec<u8>) -> bool {
        self.to_array().write(line)
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        <[f64; 3]>::read(json).map(Self::from)
    }

    fn schema() -> Value {
        <[f64; 3]>::schema()
    }
}

impl Field for DVec2 {
    fn write(&self, line: &mut Vec<u8>) -> bool {
        self.to_array().write(line)
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        <[f64; 2]>::read(json).map(Self::from)
    }

    fn schema() -> Value {
        <[f64; 2]>::schema()
    }
}

/// A value that is one of a few words.
pub(super) trait Word: Copy + Default + PartialEq + 'static {
    /// Each value with its word.
    const WORDS: &'static [(Self, &'static str)];
}

impl<W: Word> Field for W {
    fn write(&self, line: &mut Vec<u8>) -> bool {
        let word = W::WORDS.iter().find(|(value, _)| value == self);
        let Some((_, word)) = word else {
            return false;
        };
        line.push(b'"');
        line.extend_from_slice(word.as_bytes());
        line.push(b'"');
        true
    }

    fn read(json: &Json<'_>) -> Result<Self, String> {
        let found = match json {
            Json::Text(text) => W::WORDS.iter().find(|(_, word)| *word == *text),
            _ => None,
        };
        found.map(|(value, _)| *value).ok_or_else(|| {
            let words: Vec<_> = W::WORDS.iter().map(|(_, word)| *word).collect();
            format!("one of {}", words.join(", "))
        })
    }

    fn schema() -> Value {
        let words: Vec<_> = W::WORDS.iter().map(|(_, word)| *word).collect();
        json!({ "enum": words })
    }
}
