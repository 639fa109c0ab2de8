//! The file system: scenes, meshes and lessons in folders (feature `files`). Nothing below reads a file itself.

pub(crate) mod folder;
pub(crate) mod load;
mod read;

pub(crate) use folder::Folder;
