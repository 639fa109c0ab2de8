//! Reading a whole file, up to a limit.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use crate::scene::{LARGEST_FILE, LoadError, Place, ReadEnd, gibibytes, read_up_to};

/// Reads a file that ought to be text: up to its end, or to the first byte that no text has.
///
/// # Errors
/// A file that cannot be read, or is larger than any scene.
pub(super) fn read_file(path: &Path) -> Result<Vec<u8>, LoadError> {
    /// How many bytes are read at once.
    const AT_ONCE: usize = 1 << 16;
    let file = path.display().to_string();
    let unreadable = |source| LoadError::Read {
        file: file.clone(),
        source,
    };
    let opened = File::open(path).map_err(unreadable)?;
    let length = opened.metadata().map_or(0, |meta| meta.len());
    let mut bytes = Vec::with_capacity(length.min(LARGEST_FILE) as usize);
    let mut input = BufReader::with_capacity(AT_ONCE, opened);
    match read_up_to(&mut input, 0, LARGEST_FILE, &mut bytes).map_err(unreadable)? {
        ReadEnd::Limit => Err(too_large(&file)),
        ReadEnd::Stop | ReadEnd::Zero | ReadEnd::Input => Ok(bytes),
    }
}

/// The error that a file is larger than any scene.
fn too_large(file: &str) -> LoadError {
    LoadError::Form {
        place: Place {
            file: file.into(),
            ..Place::default()
        },
        what: format!("this file has more than {}", gibibytes(LARGEST_FILE)),
        fix: "give a smaller scene".into(),
        schema: None,
    }
}
