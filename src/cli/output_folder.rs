//! A folder is written whole or not at all, as a file is.
//!
//! What is written goes to a temporary folder beside the target, which takes the target's name at the end. On an error it is
//! removed, and when a signal ends the program.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::cli::Error;
use crate::cli::signals::before_the_end;

/// A folder that is being written.
pub(crate) struct OutputFolder {
    target: PathBuf,
    temporary: TempDir,
}

impl OutputFolder {
    /// Makes sure that the target can be written, before any work is done for it: it is new or empty, or may be replaced.
    pub(crate) fn create(
        target: &Path,
        may_be_replaced: impl FnOnce(&Path) -> bool,
    ) -> Result<Self, Error> {
        let bad = |what: &str, fix: &str| Error::Target {
            file: target.display().to_string(),
            what: what.into(),
            fix: fix.into(),
        };
        match fs::read_dir(target) {
            Ok(mut entries) => {
                if entries.next().is_some() && !may_be_replaced(target) {
                    return Err(bad(
                        "is there already, and not empty",
                        "choose a new folder: nothing is written over what is not known",
                    ));
                }
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(bad(&error.to_string(), "choose another folder")),
        }
        let target = std::path::absolute(target).map_err(|error| failed(target, error))?;
        let parent = target.parent().unwrap_or(&target);
        fs::create_dir_all(parent).map_err(|error| failed(parent, error))?;
        let temporary = tempfile::Builder::new()
            .prefix(".raystep-")
            .suffix(".part")
            .tempdir_in(parent);
        let temporary = temporary.map_err(|error| failed(parent, error))?;
        let path = temporary.path().to_path_buf();
        before_the_end(move || {
            let _ = fs::remove_dir_all(path);
        });
        Ok(Self { target, temporary })
    }

    /// Where to write.
    pub(crate) fn path(&self) -> PathBuf {
        // a folder in it: the temporary one is for its owner alone
        self.temporary.path().join("new")
    }

    /// Writes a file into it, by its path inside.
    pub(crate) fn write(&self, file: &str, bytes: &[u8]) -> Result<(), Error> {
        let path = self.path().join(file);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(|error| failed(folder, error))?;
        }
        fs::write(&path, bytes).map_err(|error| failed(&self.target.join(file), error))
    }

    /// All is written: the folder takes its place.
    pub(crate) fn finish(self) -> Result<(), Error> {
        let failed = |error| failed(&self.target, error);
        let old = self.temporary.path().join("old");
        let is_there = self.target.exists();
        if is_there {
            fs::rename(&self.target, &old).map_err(failed)?;
        }
        if let Err(error) = fs::rename(self.path(), &self.target) {
            if is_there {
                // what was there stays
                let _ = fs::rename(&old, &self.target);
            }
            return Err(failed(error));
        }
        Ok(())
    }
}

pub(crate) fn failed(path: &Path, source: io::Error) -> Error {
    Error::Write {
        file: path.display().to_string(),
        source,
    }
}
