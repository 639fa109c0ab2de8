//! The files of the lessons, in the program itself.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use raystep::scene::IsOutside;
use raystep::{Files, LoadError};

include!(concat!(env!("OUT_DIR"), "/files.rs"));

/// A folder of the lessons: empty for that around them, or `04-sphere/`.
#[derive(Clone, Debug, Default)]
pub struct Embedded {
    folder: String,
}

impl Embedded {
    /// The folder that a file is in.
    pub fn around_name(&self, name: &str) -> Arc<dyn Files> {
        self.around(Path::new(name))
    }
}

impl Files for Embedded {
    fn name(&self) -> String {
        self.folder.clone()
    }

    fn path_of(&self, name: &str) -> Result<PathBuf, IsOutside> {
        Ok(format!("{}{name}", self.folder).into())
    }

    fn read(&self, path: &Path) -> Result<Vec<u8>, LoadError> {
        let file = path.display().to_string();
        let known = FILES.iter().find(|(name, _)| *name == file);
        known
            .map(|(_, bytes)| bytes.to_vec())
            .ok_or_else(|| LoadError::Read {
                file,
                source: io::ErrorKind::NotFound.into(),
            })
    }

    fn around(&self, path: &Path) -> Arc<dyn Files> {
        let folder = path.parent().map(|folder| folder.display().to_string());
        let folder = folder.filter(|folder| !folder.is_empty());
        Arc::new(Self {
            folder: folder.map_or(String::new(), |folder| format!("{folder}/")),
        })
    }

    fn folders(&self) -> io::Result<Vec<String>> {
        let mut names: Vec<String> = FILES
            .iter()
            .filter_map(|(name, _)| Some(name.split_once('/')?.0.to_owned()))
            .collect();
        names.dedup();
        Ok(names)
    }
}
