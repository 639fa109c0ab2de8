//! Which file a path leads to, through whatever links: what a command reads is not replaced by what it writes.

use std::fs::{self, Metadata};
use std::path::{Path, PathBuf};

use crate::cli::Error;
use crate::cli::output::{behind_links, is_standard};

/// The files that the outputs of a command must not replace, each with what else happens to it.
#[derive(Debug, Default)]
pub(crate) struct Taken(Vec<(FileId, String, &'static str)>);

/// Paths with the same id lead to the same file.
#[derive(Debug, PartialEq, Eq)]
enum FileId {
    /// Standard output.
    StandardOutput,
    /// A file that is there: its device and its number on it.
    #[cfg(unix)]
    Node(u64, u64),
    /// A file that is not there yet, and on systems without such numbers any file: its folder without links, and its
    /// name.
    Path(PathBuf),
}

impl Taken {
    /// Nothing, where an output may replace its input.
    pub(crate) fn nothing() -> Self {
        Self::default()
    }

    /// What a command reads: a path or `-`, and what that names in turn.
    pub(crate) fn by_reading<'a>(
        input: &Path,
        others: impl IntoIterator<Item = &'a PathBuf>,
    ) -> Self {
        let mut taken = Self::nothing();
        taken.read(input);
        for other in others {
            taken.read(other);
        }
        taken
    }

    /// One more file that is read, or `-`.
    pub(crate) fn read(&mut self, path: &Path) {
        const READ: &str = "which is read";
        if path == Path::new("-") {
            let id = standard_input();
            self.0
                .extend(id.map(|id| (id, "on standard input".into(), READ)));
        } else {
            self.take(path, READ);
        }
    }

    /// One more file that is written, by this option.
    pub(crate) fn write(&mut self, path: &Path, by: &'static str) {
        self.take(path, by);
    }

    fn take(&mut self, path: &Path, what: &'static str) {
        let id = id_of(path);
        self.0
            .extend(id.map(|id| (id, path.display().to_string(), what)));
    }

    /// Refuses an output that would replace one of these files.
    pub(crate) fn refuse(&self, output: &Path) -> Result<(), Error> {
        let Some(id) = id_of(output) else {
            return Ok(());
        };
        match self.0.iter().find(|(taken, ..)| *taken == id) {
            None => Ok(()),
            Some((_, name, what)) => Err(Error::Target {
                file: output.display().to_string(),
                what: format!("this is the file {name}, {what}"),
                fix: "write to another file".into(),
            }),
        }
    }
}

/// The file behind a path; `None` for a device or a pipe, which nothing replaces, and where there can be no file.
fn id_of(path: &Path) -> Option<FileId> {
    if is_standard(path) {
        return Some(FileId::StandardOutput);
    }
    match fs::metadata(path) {
        Ok(meta) => id_of_file(&meta, path),
        Err(_) => {
            let target = behind_links(path);
            let folder = match target.parent() {
                Some(folder) if folder != Path::new("") => folder,
                _ => Path::new("."),
            };
            let folder = fs::canonicalize(folder).ok()?;
            Some(FileId::Path(folder.join(target.file_name()?)))
        }
    }
}

#[cfg(unix)]
fn id_of_file(meta: &Metadata, _: &Path) -> Option<FileId> {
    use std::os::unix::fs::MetadataExt;
    meta.is_file().then(|| FileId::Node(meta.dev(), meta.ino()))
}

#[cfg(not(unix))]
fn id_of_file(meta: &Metadata, path: &Path) -> Option<FileId> {
    let path = fs::canonicalize(path).ok()?;
    meta.is_file().then_some(FileId::Path(path))
}

/// The file that a shell has put on standard input.
#[cfg(unix)]
fn standard_input() -> Option<FileId> {
    use std::os::fd::AsFd;
    let file = std::io::stdin().as_fd().try_clone_to_owned().ok()?;
    let meta = fs::File::from(file).metadata().ok()?;
    id_of_file(&meta, Path::new("-"))
}

#[cfg(not(unix))]
fn standard_input() -> Option<FileId> {
    None
}
