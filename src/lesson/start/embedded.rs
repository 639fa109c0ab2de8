//! Files that the program has in itself.

use std::collections::BTreeSet;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::scene::{Files, IsOutside, LoadError};

/// A folder among embedded files.
#[derive(Clone, Debug)]
pub(super) struct Embedded {
    /// All files, with their paths.
    pub(super) files: &'static [(&'static str, &'static [u8])],
    /// The folder.
    pub(super) folder: PathBuf,
}

impl Files for Embedded {
    fn name(&self) -> String {
        "the course".into()
    }

    fn path_of(&self, name: &str) -> Result<PathBuf, IsOutside> {
        let parts = Path::new(name).components();
        let is_inside =
            |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
        if parts.into_iter().all(is_inside) {
            Ok(self.folder.join(name))
        } else {
            Err(IsOutside)
        }
    }

    fn read(&self, path: &Path) -> Result<Vec<u8>, LoadError> {
        let found = self
            .files
            .iter()
            .find(|(known, _)| Path::new(known) == path);
        found
            .map(|(_, bytes)| bytes.to_vec())
            .ok_or_else(|| LoadError::Read {
                file: path.display().to_string(),
                source: io::Error::new(io::ErrorKind::NotFound, "the course has no such file"),
            })
    }

    fn around(&self, path: &Path) -> Arc<dyn Files> {
        Arc::new(Self {
            files: self.files,
            folder: path.parent().unwrap_or(Path::new("")).into(),
        })
    }

    fn folders(&self) -> io::Result<Vec<String>> {
        let inside = self.files.iter().filter_map(|(path, _)| {
            let rest = Path::new(path).strip_prefix(&self.folder).ok()?;
            let mut parts = rest.components();
            let first = parts.next()?.as_os_str().to_string_lossy().into_owned();
            parts.next().is_some().then_some(first)
        });
        Ok(inside.collect::<BTreeSet<_>>().into_iter().collect())
    }
}
