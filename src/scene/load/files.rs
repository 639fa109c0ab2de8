//! Where the files come from that a scene or a lesson names: meshes, lessons, their scenes.
//!
//! The core reads no file itself. Whoever calls it hands in a reader: a folder of the file system
//! (`Folder`, feature `files`), the files that a program has in itself, or none ([`NoFiles`]).

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::scene::load::error::LoadError;

/// A name leads out of the folder, which is not allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IsOutside;

/// A folder that can be read.
pub trait Files: fmt::Debug + Send + Sync {
    /// The folder in messages.
    fn name(&self) -> String;

    /// The path of a file of this folder. `name` is counted from the folder, as in `meshes/teapot.obj`.
    ///
    /// # Errors
    /// A name that leads out of the folder, if the folder does not allow it.
    fn path_of(&self, name: &str) -> Result<PathBuf, IsOutside>;

    /// The bytes of a file, by its path.
    ///
    /// # Errors
    /// A file that cannot be read.
    fn read(&self, path: &Path) -> Result<Vec<u8>, LoadError>;

    /// The folder that a file lies in, by the file's path.
    fn around(&self, path: &Path) -> Arc<dyn Files>;

    /// The names of the folders in this one.
    ///
    /// # Errors
    /// A folder that cannot be read.
    fn folders(&self) -> io::Result<Vec<String>>;
}

/// No files: a scene that names one is refused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoFiles;

impl Files for NoFiles {
    fn name(&self) -> String {
        String::new()
    }

    fn path_of(&self, name: &str) -> Result<PathBuf, IsOutside> {
        Ok(name.into())
    }

    fn read(&self, path: &Path) -> Result<Vec<u8>, LoadError> {
        Err(LoadError::Read {
            file: path.display().to_string(),
            source: io::Error::new(io::ErrorKind::NotFound, "no files can be read here"),
        })
    }

    fn around(&self, _: &Path) -> Arc<dyn Files> {
        Arc::new(Self)
    }

    fn folders(&self) -> io::Result<Vec<String>> {
        Ok(Vec::new())
    }
}
