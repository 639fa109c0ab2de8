//! Where things are: the course, and what a check writes.

use std::env;
use std::path::{Path, PathBuf};

/// The folder of the course, which holds `01-pinhole` and its like.
pub fn lessons() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}

/// The folder in which cargo is called: where Cargo.lock lies.
fn root() -> &'static Path {
    let above = lessons().ancestors();
    let mut with_lock = above.filter(|folder| folder.join("Cargo.lock").exists());
    with_lock.next().unwrap_or(lessons())
}

/// `target/lessons`: all that a check writes is in there.
///
/// Cargo marks its target folder with a file, wherever that folder is.
pub fn written() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    let mut above = program.ancestors().skip(1);
    let target = above.find(|folder| folder.join("CACHEDIR.TAG").exists());
    target
        .map_or_else(|| root().join("target"), PathBuf::from)
        .join("lessons")
}

/// A path as you would type it in the folder in which cargo is called.
pub fn typed(path: &Path) -> String {
    path.strip_prefix(root())
        .unwrap_or(path)
        .display()
        .to_string()
}

/// A file of the course as you would type it.
pub fn of_course(file: &str) -> String {
    typed(&lessons().join(file))
}

/// The folder of a lesson: `04-sphere`.
pub fn folder_of(lesson: u8) -> String {
    let number = format!("{lesson:02}-");
    let entries = lessons().read_dir().into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    names
        .into_iter()
        .find(|name| name.starts_with(&number))
        .unwrap_or(number)
}
