//! The lesson file: a title, the figures by name, and the questions.

use std::collections::BTreeMap;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
#[cfg(feature = "schema")]
use serde_json::Value;

use crate::figure::FigureSpec;
use crate::lesson::question::QuestionSpec;
#[cfg(feature = "schema")]
use crate::trace::generator;

/// A whole lesson file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LessonFile {
    /// What the lesson is about.
    pub title: String,
    /// Its figures by name, drawn in the order of the names.
    #[serde(default)]
    pub figures: BTreeMap<String, FigureSpec>,
    /// Its questions, in the order in which they are asked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<QuestionSpec>,
}

/// The JSON Schema (draft 2020-12) of a lesson file.
#[cfg(feature = "schema")]
pub fn lesson_schema() -> Value {
    let mut schema = generator().into_root_schema_for::<LessonFile>().to_value();
    schema["title"] = "raystep lesson".into();
    schema
}
