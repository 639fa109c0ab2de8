//! Files that ought to be text.

use crate::scene::load::error::{LoadError, Place};

/// The bytes as text, without a byte order mark; binary files are reported by the line of the first byte
/// that is none.
pub(crate) fn text_of<'a>(file: &str, bytes: &'a [u8], fix: &str) -> Result<&'a str, LoadError> {
    let at = match std::str::from_utf8(bytes) {
        Ok(text) => match text.find('\0') {
            Some(at) => at,
            None => return Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        },
        Err(error) => error.valid_up_to(),
    };
    let line = 1 + bytes[..at].iter().filter(|&&b| b == b'\n').count();
    Err(LoadError::Form {
        place: Place {
            file: file.into(),
            line: Some(line),
            path: String::new(),
        },
        what: "this is not a text file".into(),
        fix: fix.into(),
        schema: None,
    })
}
