//! The lesson file: a title, and the figures by name.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::figure::FigureSpec;
use crate::trace::generator;

/// A whole lesson file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LessonFile {
    /// What the lesson is about.
    pub title: String,
    /// Its figures by name, drawn in the order of the names.
    #[serde(default)]
    pub figures: BTreeMap<String, FigureSpec>,
}

/// The JSON Schema (draft 2020-12) of a lesson file.
pub fn lesson_schema() -> Value {
    let mut schema = generator().into_root_schema_for::<LessonFile>().to_value();
    schema["title"] = "raystep lesson".into();
    schema
}
