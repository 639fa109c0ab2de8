//! JSON Schemas of the scene file and of a line of the log (feature `schema`).

use schemars::SchemaGenerator;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

use crate::scene::SceneFile;
use crate::trace::Kind;
use crate::trace::log::event_schema::event_schema;
use crate::trace::log::head::{Header, LOG_VERSION, ObjectLine};
use crate::trace::log::of_pixels::{MistakeLine, PictureLine, TestsLine, TotalsLine};

/// The JSON Schema (draft 2020-12) of a scene file.
pub fn scene_schema() -> Value {
    let mut schema = generator().into_root_schema_for::<SceneFile>().to_value();
    schema["title"] = "raystep scene".into();
    schema
}

/// The JSON Schema (draft 2020-12) of one line of a log.
pub fn trace_schema() -> Value {
    let mut generator = generator();
    let header = generator.subschema_for::<Header>().to_value();
    let object = generator.subschema_for::<ObjectLine>().to_value();
    let picture = generator.subschema_for::<PictureLine>().to_value();
    let mistake = generator.subschema_for::<MistakeLine>().to_value();
    let totals = generator.subschema_for::<TotalsLine>().to_value();
    let tests = generator.subschema_for::<TestsLine>().to_value();
    let mut lines = vec![
        of_kind(
            "trace",
            json!({ "version": { "const": LOG_VERSION } }),
            &header,
        ),
        of_kind("object", json!({}), &object),
        of_kind("picture", json!({}), &picture),
        of_kind("mistake", json!({}), &mistake),
        of_kind("totals", json!({}), &totals),
        of_kind("pixel_tests", json!({}), &tests),
    ];
    lines.extend(Kind::ALL.map(event_schema));
    let definitions: Map<String, Value> = generator.take_definitions(true);
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "one line of a raystep log",
        "description": "JSON Lines: the line of kind trace comes first, then one line for each object, \
                        in the log of a figure its picture, what a mistake makes of it, what its rays took and a line for each row of tests, then one line for each event, in the order in which it happened.",
        "oneOf": lines,
        "$defs": definitions,
    })
}

pub(crate) fn generator() -> SchemaGenerator {
    SchemaSettings::draft2020_12().into_generator()
}

/// A line whose form is a type of the head, and whose kind is fixed.
fn of_kind(kind: &str, mut properties: Value, form: &Value) -> Value {
    properties["kind"] = json!({ "const": kind });
    json!({ "allOf": [form, { "properties": properties }] })
}
