//! How a value is shown under its key: always there or perhaps absent, by a name of the scene, unbounded, derived.

use crate::scene::PrimitiveId;
use crate::trace::event::fields::{Field, Visitor};

/// A value that has a key of its own in a line.
pub(in crate::trace) trait Column {
    /// Shows the value to the visitor.
    fn column<V: Visitor>(&mut self, key: &'static str, meaning: &'static str, v: &mut V);
}

impl<T: Field> Column for T {
    #[inline]
    fn column<V: Visitor>(&mut self, key: &'static str, meaning: &'static str, v: &mut V) {
        v.field(key, meaning, self);
    }
}

impl<T: Field> Column for Option<T> {
    #[inline]
    fn column<V: Visitor>(&mut self, key: &'static str, meaning: &'static str, v: &mut V) {
        v.optional(key, meaning, self);
    }
}

impl Column for PrimitiveId {
    #[inline]
    fn column<V: Visitor>(&mut self, key: &'static str, meaning: &'static str, v: &mut V) {
        let mut some = Some(*self);
        v.object([key, "face"], meaning, &mut some, true);
        *self = some.unwrap_or_default();
    }
}

impl Column for Option<PrimitiveId> {
    #[inline]
    fn column<V: Visitor>(&mut self, key: &'static str, meaning: &'static str, v: &mut V) {
        v.object([key, "face"], meaning, self, false);
    }
}

/// A vertex of a path: no path has more surfaces than a `u16` holds.
impl Column for u16 {
    fn column<V: Visitor>(&mut self, key: &'static str, meaning: &'static str, v: &mut V) {
        let mut whole = u32::from(*self);
        v.field(key, meaning, &mut whole);
        match Self::try_from(whole) {
            Ok(vertex) => *self = vertex,
            Err(_) => v.fail("no path has this many vertices"),
        }
    }
}

/// A light that is always there.
#[inline]
pub(super) fn light<V: Visitor>(
    light: &mut u32,
    _: &'static str,
    meaning: &'static str,
    v: &mut V,
) {
    let mut some = Some(*light);
    v.light(meaning, &mut some, true);
    *light = some.unwrap_or_default();
}

/// A light that may be absent.
#[inline]
pub(super) fn light_if_any<V: Visitor>(
    light: &mut Option<u32>,
    _: &'static str,
    meaning: &'static str,
    v: &mut V,
) {
    v.light(meaning, light, false);
}

/// A primitive beside another one: its face has a key of its own.
#[inline]
pub(super) fn replaced<V: Visitor>(
    object: &mut Option<PrimitiveId>,
    key: &'static str,
    meaning: &'static str,
    v: &mut V,
) {
    v.object([key, "replaced_face"], meaning, object, false);
}

/// A quantity that is ∞, and absent, if it has no bound.
#[inline]
pub(super) fn unbounded<V: Visitor>(
    value: &mut f64,
    key: &'static str,
    meaning: &'static str,
    v: &mut V,
) {
    let mut finite = value.is_finite().then_some(*value);
    v.optional(key, meaning, &mut finite);
    *value = finite.unwrap_or(f64::INFINITY);
}

/// A quantity that is −∞, and absent, if it has no bound.
#[inline]
pub(super) fn unbounded_below<V: Visitor>(
    value: &mut f64,
    key: &'static str,
    meaning: &'static str,
    v: &mut V,
) {
    let mut finite = value.is_finite().then_some(*value);
    v.optional(key, meaning, &mut finite);
    *value = finite.unwrap_or(f64::NEG_INFINITY);
}

/// A quantity that follows from others in the line, and stands in it for whoever looks for it alone.
#[inline]
pub(super) fn derived<T: Column + Copy + PartialEq, V: Visitor>(
    key: &'static str,
    meaning: &'static str,
    value: T,
    why: &'static str,
    v: &mut V,
) {
    let mut found = value;
    found.column(key, meaning, v);
    if found != value {
        v.fail(why);
    }
}
