//! Reading scenes: JSON, NFF and OBJ, by the file's ending, or by its content from standard input.

mod bounded;
pub(crate) mod error;
pub(crate) mod files;
mod json;
mod loaded;
mod locate;
mod nff;
mod obj;
mod text;
mod words;

pub(crate) use bounded::gibibytes;
pub use bounded::{LARGEST_FILE, LONGEST_LINE, ReadEnd, read_up_to};
pub(crate) use error::LoadError;
pub use error::{Place, SchemaOf};
pub(crate) use files::Files;
pub use files::IsOutside;
pub(crate) use json::parse_json;
pub use loaded::Loaded;
pub(crate) use locate::line_of;
pub(crate) use text::text_of;

use std::path::Path;

/// What a file is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Json,
    Nff,
    Obj,
}

impl Format {
    /// By the ending; by the content where there is none that we know.
    fn of(name: &str, text: &str) -> Self {
        let ending = Path::new(name).extension().and_then(|e| e.to_str());
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("json" | "jsonl") => Self::Json,
            Some("nff") => Self::Nff,
            Some("obj") => Self::Obj,
            _ if text.trim_start().starts_with('{') => Self::Json,
            _ if text
                .lines()
                .any(|line| line.split_whitespace().next() == Some("from")) =>
            {
                Self::Nff
            }
            _ => Self::Obj,
        }
    }
}

/// Reads a scene in JSON, NFF or OBJ from memory. `file` is its name in messages, and its ending says the format; the
/// mesh files that it names come from `files`.
///
/// # Errors
/// A text that has not the right form, with the line; a mesh file that cannot be read or lies outside of the folder.
pub fn load_bytes(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Loaded, LoadError> {
    let text = text_of(file, bytes, "give a scene in JSON, NFF or OBJ")?;
    match Format::of(file, text) {
        Format::Json => json::read_json(file, text, files),
        Format::Nff => nff::read_nff(file, text),
        Format::Obj => obj::read_obj_scene(file, text),
    }
}
