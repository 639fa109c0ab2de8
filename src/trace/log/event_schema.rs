//! What a line of each kind of event may contain: its keys, what they mean, and which values they take.

use serde_json::{Map, Value, json};

use crate::scene::PrimitiveId;
use crate::trace::event::fields::{Field, Fields, Visitor};
use crate::trace::event::place::KindPlace;
use crate::trace::{Event, Kind};

/// The JSON Schema of a line for an event.
#[cfg(feature = "schema")]
pub(super) fn event_schema(kind: Kind) -> Value {
    let described = described(kind);
    let mut schema = json!({
        "title": kind.name(),
        "description": kind.meaning().trim(),
        "type": "object",
        "properties": described.properties,
        "required": described.required,
        "additionalProperties": false,
    });
    if kind.place() == KindPlace::Either {
        schema["oneOf"] = json!([{ "required": ["pixel"] }, { "required": ["path"] }]);
    }
    schema
}

/// The keys that a line of this kind may have.
pub(crate) fn keys_of(kind: Kind) -> Vec<String> {
    described(kind)
        .properties
        .into_iter()
        .map(|(key, _)| key)
        .collect()
}

/// The fields that a line of this kind may have: each key, and its words if its value is one of a few.
pub fn fields_of(kind: Kind) -> Vec<(String, Vec<String>)> {
    let word = |value: &Value| value["const"].as_str().map(str::to_owned);
    described(kind)
        .properties
        .into_iter()
        .map(|(key, schema)| {
            let values = schema["oneOf"].as_array();
            let words = values.into_iter().flatten().filter_map(word).collect();
            (key, words)
        })
        .collect()
}

fn described(kind: Kind) -> Description {
    let mut description = Description::default();
    description.add(
        "kind",
        "the kind of event",
        json!({ "const": kind.name() }),
        true,
    );
    let mut step = 0_u32;
    description.field(
        "step",
        "the number of the event in the pixel or on the path, from 0",
        &mut step,
    );
    let pair = json!({
        "type": "array", "items": u32::schema(), "minItems": 2, "maxItems": 2
    });
    let of_path = u32::schema();
    let place = kind.place();
    let always = place != KindPlace::Either;
    if matches!(place, KindPlace::Pixel | KindPlace::Either) {
        description.add("pixel", "column and row from the top left", pair, always);
    }
    if matches!(place, KindPlace::Path | KindPlace::Either) {
        let meaning = "the number of the path of light, from 0";
        description.add("path", meaning, of_path, always);
    }
    let mut ray = Some(0_u32);
    let of_no_ray = matches!(kind, Kind::Pixel | Kind::PixelColour | Kind::Path);
    if !(place == KindPlace::Building || of_no_ray) {
        let meaning = "the ray, numbered in the pixel or on the path from 0";
        description.optional("ray", meaning, &mut ray);
    }
    let mut event = kind.blank();
    if let Event::Ray(_) = event {
        description.optional("parent", "the ray that spawned it", &mut ray);
    }
    event.fields(&mut description);
    description
}

/// Describes each field.
#[derive(Default)]
struct Description {
    properties: Map<String, Value>,
    required: Vec<&'static str>,
}

impl Description {
    fn add(&mut self, key: &'static str, meaning: &str, mut schema: Value, required: bool) {
        schema["description"] = meaning.trim().into();
        self.properties.insert(key.into(), schema);
        if required {
            self.required.push(key);
        }
    }
}

impl Visitor for Description {
    fn field<T: Field>(&mut self, key: &'static str, meaning: &'static str, _: &mut T) {
        self.add(key, meaning, T::schema(), true);
    }

    fn optional<T: Field>(&mut self, key: &'static str, meaning: &'static str, _: &mut Option<T>) {
        self.add(key, meaning, T::schema(), false);
    }

    fn object(
        &mut self,
        [name, face]: [&'static str; 2],
        meaning: &'static str,
        _: &mut Option<PrimitiveId>,
        required: bool,
    ) {
        self.add(name, meaning, json!({ "type": "string" }), required);
        let number = "the number of the face, if the object is a mesh";
        self.add(face, number, u32::schema(), false);
    }

    fn whole_object(&mut self, key: &'static str, meaning: &'static str, _: &mut Option<u32>) {
        self.add(key, meaning, json!({ "type": "string" }), false);
    }

    fn light(&mut self, meaning: &'static str, _: &mut Option<u32>, required: bool) {
        self.add("light", meaning, json!({ "type": "string" }), required);
    }

    // a blank event says nothing about its fields
    fn fail(&mut self, _: &'static str) {}
}
