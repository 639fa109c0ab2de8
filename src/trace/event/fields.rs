//! The fields of a log line: one list for writing, reading and the schema.
//!
//! Each kind of event lists its fields once, in [`Fields::fields`], each with its key and what it means. The list is
//! walked by visitors: a writer puts the values into a line, a reader takes them out of one, the schema describes them.
//! So they cannot disagree. What the values themselves are made of, numbers, flags, words and lists, stands in [`Field`],
//! again once for writing and reading.

use glam::{DVec2, DVec3};
use serde_json::{Value, json};

use crate::scene::PrimitiveId;

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

/// A value of a field, in JSON a scalar or a short list of numbers.
pub(in crate::trace) trait Field: Copy + Default {
    /// Writes the value; `false` if it has no JSON (a number that is not finite).
    fn write(&self, to: &mut impl ValueWriter) -> bool;

    /// Reads the value.
    ///
    /// # Errors
    /// There is another value; what the reader says of it.
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong>;

    /// Its JSON Schema.
    fn schema() -> Value;
}

/// Takes the parts of values: into a line of JSON.
pub(in crate::trace) trait ValueWriter {
    /// A number; `false` and nothing if it is not finite.
    fn number(&mut self, value: f64) -> bool;
    /// A whole number.
    fn whole(&mut self, value: u32);
    /// true or false.
    fn flag(&mut self, value: bool);
    /// One of a few words.
    fn word<W: Word>(&mut self, value: W);
    /// A list, or `false` and nothing if one of its items has no JSON.
    fn list(&mut self, items: &[impl Field]) -> bool;
}

/// Gives the parts of values: out of a line of JSON.
pub(in crate::trace) trait ValueReader {
    /// What it says of a value that is another than the one asked for.
    type Wrong;
    /// A finite number.
    fn number(&mut self) -> Result<f64, Self::Wrong>;
    /// A whole number below 2³².
    fn whole(&mut self) -> Result<u32, Self::Wrong>;
    /// true or false.
    fn flag(&mut self) -> Result<bool, Self::Wrong>;
    /// One of a few words.
    fn word<W: Word>(&mut self) -> Result<W, Self::Wrong>;
    /// A list of N items.
    fn list<T: Field, const N: usize>(&mut self) -> Result<[T; N], Self::Wrong>;
    /// The value is none of those that were expected.
    fn wrong(&mut self, expected: &'static str) -> Self::Wrong;
}

impl Field for f64 {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.number(*self)
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.number()
    }

    fn schema() -> Value {
        json!({ "type": "number" })
    }
}

impl Field for u32 {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.whole(*self);
        true
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.whole()
    }

    fn schema() -> Value {
        json!({ "type": "integer", "minimum": 0, "maximum": Self::MAX })
    }
}

impl Field for u8 {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.whole(u32::from(*self));
        true
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        let whole = from.whole()?;
        Self::try_from(whole).map_err(|_| from.wrong("a whole number from 0 to 255"))
    }

    fn schema() -> Value {
        json!({ "type": "integer", "minimum": 0, "maximum": Self::MAX })
    }
}

impl Field for bool {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.flag(*self);
        true
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.flag()
    }

    fn schema() -> Value {
        json!({ "type": "boolean" })
    }
}

/// A pixel, a cell, or a few numbers.
impl<T: Field, const N: usize> Field for [T; N]
where
    [T; N]: Default,
{
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.list(self)
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.list()
    }

    fn schema() -> Value {
        json!({ "type": "array", "items": T::schema(), "minItems": N, "maxItems": N })
    }
}

impl Field for DVec3 {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.list(&self.to_array())
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.list::<f64, 3>().map(Self::from)
    }

    fn schema() -> Value {
        <[f64; 3]>::schema()
    }
}

impl Field for DVec2 {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.list(&self.to_array())
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.list::<f64, 2>().map(Self::from)
    }

    fn schema() -> Value {
        <[f64; 2]>::schema()
    }
}

/// A value that is one of a few words.
pub(in crate::trace) trait Word: Copy + Default + PartialEq + 'static {
    /// Each value with its word and what it means, in the order in which the values are declared.
    const WORDS: &'static [(Self, &'static str, &'static str)];

    /// Its place in [`Word::WORDS`].
    fn place(self) -> usize;
}

impl<W: Word> Field for W {
    #[inline]
    fn write(&self, to: &mut impl ValueWriter) -> bool {
        to.word(*self);
        true
    }

    #[inline]
    fn read<R: ValueReader>(from: &mut R) -> Result<Self, R::Wrong> {
        from.word()
    }

    fn schema() -> Value {
        let value = |&(_, word, meaning): &(Self, &str, &str)| json!({ "const": word, "description": meaning.trim() });
        let values: Vec<_> = W::WORDS.iter().map(value).collect();
        json!({ "type": "string", "oneOf": values })
    }
}
