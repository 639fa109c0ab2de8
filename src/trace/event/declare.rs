//! The macros that the table of events is written with: `events!` for the kinds, `fields!` for what a step of a layer
//! below has in a line.
//!
//! A field stands on a line of its own below what it means, which is its documentation in Rust and in the schema. In a
//! struct that the table declares:
//!
//! | written | means |
//! |---|---|
//! | `t: f64,` | the key `t` |
//! | `path: u32 as from_path,` | another key in the log |
//! | `light: u32 = by light,` | a function that shows the field to the visitor |
//! | `range: TRange = flat,` | the fields of the value itself |
//! | `pixel: [u32; 2] = apart,` | no field of the line: its place says it |
//! | `rgb => PixelColour::rgb,` | no field of the struct: follows from it, and is in the line for whoever looks for it alone |
//!
//! In `fields!` there are no types: `t,` `edge: index,` `first_d_min: d_min[0],` `t_max: max = by unbounded,` `flat roots,`
//! `d_min => joined_d_min,`, and `verdict => of_polygon,` for the verdict of a test with its reason.

/// Declares `Event`, `Kind` and the structs of events, from one paragraph for each kind: what happened, the name in the
/// log, where it can happen, and its fields in the order of the line.
macro_rules! events {
    ($(
        $(#[doc = $doc:literal])+
        $kind:ident $shape:tt = $name:literal, $place:ident $body:tt
    )+) => {
        /// One step of the working. `Copy` and at most 128 bytes, so that a record of many is one block.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[expect(missing_docs, reason = "an object, and the working of its test")]
        pub enum Event { $($(#[doc = $doc])+ $kind $shape),+ }

        /// The name of each event.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Kind { $($(#[doc = $doc])+ $kind),+ }

        impl Event {
            /// The name of the event.
            #[inline]
            pub const fn kind(&self) -> Kind {
                match self { $(Self::$kind { .. } => Kind::$kind),+ }
            }
        }

        impl Kind {
            /// All kinds, in the order in which they happen on a ray.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$kind),+];

            /// The name in the log.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$kind => $name),+ }
            }

            /// What happened.
            #[cfg(feature = "schema")]
            pub(in crate::trace) const fn meaning(self) -> &'static str {
                match self { $(Self::$kind => concat!($($doc),+)),+ }
            }

            /// Where it can happen.
            pub(in crate::trace) const fn place(self) -> KindPlace {
                match self { $(Self::$kind => KindPlace::$place),+ }
            }

            /// An event of this kind with nothing in it, for a reader to fill.
            pub(in crate::trace) fn blank(self) -> Event {
                match self { $(Self::$kind => variant!(blank $kind $shape)),+ }
            }
        }

        impl Fields for Event {
            #[inline]
            fn fields<V: Visitor>(&mut self, v: &mut V) {
                match self { $(Self::$kind { .. } => variant!(fields self v $kind $shape)),+ }
            }
        }

        $(payload! { $shape $body $(#[doc = $doc])+ })+
    };
}

/// What `events!` needs of one variant: with a struct of its own, or with an object and the working of its test.
macro_rules! variant {
    (blank $kind:ident ($payload:ident)) => {
        Event::$kind($payload::default())
    };
    (blank $kind:ident { $($field:ident: $type:ident),+ }) => {
        Event::$kind { $($field: $type::default()),+ }
    };
    (fields $self:ident $v:ident $kind:ident ($payload:ident)) => {
        if let Event::$kind(payload) = $self {
            payload.fields($v);
        }
    };
    (fields $self:ident $v:ident $kind:ident { object: PrimitiveId $(, $working:ident: $type:ident)? }) => {
        if let Event::$kind { object $(, $working)? } = $self {
            object.column("object", "The object.", $v);
            $($working.fields($v);)?
        }
    };
}

/// The struct of an event, if it is declared in the table, with its fields.
macro_rules! payload {
    ($shape:tt ; $(#[doc = $doc:literal])+) => {};
    (($name:ident) { $($body:tt)+ } $(#[doc = $doc:literal])+) => {
        payload! { @each ($(#[doc = $doc])+ $name) {} {} $($body)+ }
    };
    (@each ($(#[doc = $doc:literal])+ $name:ident) { $($member:tt)+ } { $($shown:tt)+ }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct $name { $($member)+ }

        fields! { $name { $($shown)+ } }
    };
    (@each $of:tt { $($member:tt)* } { $($shown:tt)* }
        $(#[doc = $doc:literal])+ $field:ident: $type:ty, $($rest:tt)*) => {
        payload! { @each $of
            { $($member)* $(#[doc = $doc])+ pub $field: $type, }
            { $($shown)* $(#[doc = $doc])+ $field, } $($rest)* }
    };
    (@each $of:tt { $($member:tt)* } { $($shown:tt)* }
        $(#[doc = $doc:literal])+ $field:ident: $type:ty as $key:ident, $($rest:tt)*) => {
        payload! { @each $of
            { $($member)* $(#[doc = $doc])+ pub $field: $type, }
            { $($shown)* $(#[doc = $doc])+ $key: $field, } $($rest)* }
    };
    (@each $of:tt { $($member:tt)* } { $($shown:tt)* }
        $(#[doc = $doc:literal])+ $field:ident: $type:ty = by $by:path, $($rest:tt)*) => {
        payload! { @each $of
            { $($member)* $(#[doc = $doc])+ pub $field: $type, }
            { $($shown)* $(#[doc = $doc])+ $field: $field = by $by, } $($rest)* }
    };
    (@each $of:tt { $($member:tt)* } { $($shown:tt)* }
        $(#[doc = $doc:literal])+ $field:ident: $type:ty = flat, $($rest:tt)*) => {
        payload! { @each $of
            { $($member)* $(#[doc = $doc])+ pub $field: $type, }
            { $($shown)* flat $field, } $($rest)* }
    };
    (@each $of:tt { $($member:tt)* } $shown:tt
        $(#[doc = $doc:literal])+ $field:ident: $type:ty = apart, $($rest:tt)*) => {
        payload! { @each $of { $($member)* $(#[doc = $doc])+ pub $field: $type, } $shown $($rest)* }
    };
    (@each $of:tt $member:tt { $($shown:tt)* }
        $(#[doc = $doc:literal])+ $key:ident => $from:path, $($rest:tt)*) => {
        payload! { @each $of $member { $($shown)* $(#[doc = $doc])+ $key => $from, } $($rest)* }
    };
}

/// What a value has in a line of the log: each field with what it means, in the order of the line.
macro_rules! fields {
    ($type:ident { $($body:tt)+ }) => {
        impl Fields for $type {
            #[inline]
            fn fields<V: Visitor>(&mut self, v: &mut V) {
                fields!(@each self v $($body)+);
            }
        }
    };
    (@each $self:ident $v:ident) => {};
    (@each $self:ident $v:ident flat $field:ident, $($rest:tt)*) => {
        $self.$field.fields($v);
        fields!(@each $self $v $($rest)*);
    };
    (@each $self:ident $v:ident verdict => $from:path, $($rest:tt)*) => {
        Judged::derived($from($self), $v);
        fields!(@each $self $v $($rest)*);
    };
    (@each $self:ident $v:ident $(#[doc = $doc:literal])+ $key:ident, $($rest:tt)*) => {
        $self.$key.column(stringify!($key), concat!($($doc),+), $v);
        fields!(@each $self $v $($rest)*);
    };
    (@each $self:ident $v:ident
        $(#[doc = $doc:literal])+ $key:ident: $field:ident $([$at:literal])?, $($rest:tt)*) => {
        $self.$field$([$at])?.column(stringify!($key), concat!($($doc),+), $v);
        fields!(@each $self $v $($rest)*);
    };
    (@each $self:ident $v:ident
        $(#[doc = $doc:literal])+ $key:ident: $field:ident $([$at:literal])? = by $by:path, $($rest:tt)*) => {
        $by(&mut $self.$field$([$at])?, stringify!($key), concat!($($doc),+), $v);
        fields!(@each $self $v $($rest)*);
    };
    (@each $self:ident $v:ident $(#[doc = $doc:literal])+ $key:ident => $from:path, $($rest:tt)*) => {
        derived(
            stringify!($key),
            concat!($($doc),+),
            $from($self),
            concat!("\"", stringify!($key), "\" does not follow from the rest of the line"),
            $v,
        );
        fields!(@each $self $v $($rest)*);
    };
}

pub(super) use {events, fields, payload, variant};
