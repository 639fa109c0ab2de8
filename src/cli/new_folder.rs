//! A new folder with files: it is there with all of them, or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process;

use raystep::lesson::CourseFile;

use crate::cli::Error;

/// Refuses a folder that has anything in it.
pub(crate) fn refuse_taken(dir: &Path) -> Result<(), Error> {
    let is_taken = match fs::read_dir(dir) {
        Ok(mut entries) => entries.next().is_some(),
        Err(_) => dir.exists(),
    };
    if is_taken {
        return Err(Error::Exercise {
            what: format!("{} is there already, and not empty", dir.display()),
            fix: "choose a new folder: nothing is written over what you have written".into(),
        });
    }
    Ok(())
}

/// Writes the files into a new or an empty folder.
///
/// They are written into a folder beside it, which then gets its name: who is stopped on the way leaves nothing half-written.
pub(crate) fn write(dir: &Path, files: &[CourseFile]) -> Result<(), Error> {
    refuse_taken(dir)?;
    let beside = beside(dir);
    let written = write_all(&beside, files).and_then(|()| {
        // an empty folder may be there; a rename takes the place of none on every system
        if dir.exists() {
            fs::remove_dir(dir)?;
        }
        fs::rename(&beside, dir)
    });
    written.map_err(|source| {
        // what cannot be removed is no worse than what could not be written
        let _ = fs::remove_dir_all(&beside);
        Error::Write {
            file: dir.display().to_string(),
            source,
        }
    })
}

/// A folder of this process beside another one, on the same disk.
fn beside(dir: &Path) -> PathBuf {
    let name = dir
        .file_name()
        .map_or("course".into(), |name| name.to_string_lossy());
    dir.with_file_name(format!(".{name}.{}.part", process::id()))
}

fn write_all(dir: &Path, files: &[CourseFile]) -> io::Result<()> {
    for (path, bytes) in files {
        let file = dir.join(path);
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&file, bytes)?;
    }
    Ok(())
}
