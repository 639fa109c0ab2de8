//! Scenes and lessons from files.

use std::path::Path;

use crate::files::folder::Folder;
use crate::files::read::read_file;
use crate::lesson::{LessonError, Library};
use crate::scene::{LoadError, Loaded, load_bytes};

/// Reads a scene file, and the mesh files of its folder that it names.
///
/// # Errors
/// A file that cannot be read or has not the right form, with the line; a mesh file outside of the folder.
pub fn load(path: &Path) -> Result<Loaded, LoadError> {
    let file = path.display().to_string();
    let bytes = read_file(path)?;
    let mut loaded = load_bytes(&file, &bytes, &Folder::of(path))?;
    loaded.files.push(path.into());
    Ok(loaded)
}

/// Reads every lesson of a folder: the folders in it that have a `lesson.json`. The scenes of a lesson, and their meshes,
/// lie in its own folder.
///
/// # Errors
/// A folder that cannot be read or has no lesson, or a lesson with a mistake.
pub fn open_lessons(folder: &Path) -> Result<Library, LessonError> {
    Library::open(&Folder::new(folder))
}
