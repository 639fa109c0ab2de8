//! Files are written whole or not at all.
//!
//! What is written goes to a temporary file beside the target, which takes the target's name at the end.
//! On an error it is removed, and when a signal ends the program. So an existing file stays until the new one is whole.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use tempfile::TempPath;

use crate::cli::Error;
use crate::cli::same_file::Taken;
use crate::cli::signals::before_the_end;

/// How many bytes are written at once: with less, calls of the system add up.
const AT_ONCE: usize = 1 << 18;

/// The temporary file that is to be removed when a signal ends the program.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Something to write to.
pub(crate) struct Output {
    /// The target, as it was given.
    file: String,
    to: To,
}

enum To {
    Standard(BufWriter<io::Stdout>),
    /// A device or a pipe: it cannot be replaced.
    Direct(BufWriter<File>),
    Replacing {
        out: BufWriter<File>,
        /// Removed when it is dropped.
        temporary: TempPath,
        target: PathBuf,
    },
}

/// Is this standard output?
pub(crate) fn is_standard(path: &Path) -> bool {
    path == Path::new("-") || path == Path::new("/dev/stdout")
}

/// Refuses a file whose ending is that of another format: programs would take it for that. Without an ending, a file may
/// hold anything.
pub(crate) fn refuse_ending(path: &Path, what: &str, written: &[&str]) -> Result<(), Error> {
    let Some(ending) = path.extension() else {
        return Ok(());
    };
    if written
        .iter()
        .any(|known| ending.eq_ignore_ascii_case(known))
    {
        return Ok(());
    }
    let known: Vec<String> = written.iter().map(|known| format!(".{known}")).collect();
    let known = known.join(" or ");
    Err(Error::Target {
        file: path.display().to_string(),
        what: format!("{what} is not written as .{}", ending.to_string_lossy()),
        fix: format!("name a file that ends in {known}"),
    })
}

impl Output {
    /// Standard output.
    pub(crate) fn standard() -> Self {
        Self {
            file: "standard output".into(),
            to: To::Standard(BufWriter::with_capacity(AT_ONCE, io::stdout())),
        }
    }

    /// Makes sure that the target can be written, and that nothing else that matters is lost by it, before any work is
    /// done for it.
    pub(crate) fn create(path: &Path, taken: &Taken) -> Result<Self, Error> {
        taken.refuse(path)?;
        if is_standard(path) {
            return Ok(Self::standard());
        }
        let file = path.display().to_string();
        let bad = |what: String, fix: &str| Error::Target {
            file: file.clone(),
            what,
            fix: fix.into(),
        };
        let unwritable = |source: io::Error| {
            let fix = "check the permissions, or choose another folder";
            bad(format!("cannot be written: {source}"), fix)
        };
        let target = match fs::metadata(path) {
            Ok(meta) if meta.is_dir() => {
                return Err(bad("this is a folder".into(), "name a file inside it"));
            }
            Ok(meta) if !meta.is_file() || path.starts_with("/dev/fd") => {
                let opened = OpenOptions::new().append(true).open(path);
                let to = To::Direct(BufWriter::with_capacity(
                    AT_ONCE,
                    opened.map_err(unwritable)?,
                ));
                return Ok(Self { file, to });
            }
            Ok(_) => {
                // a file that may not be written is not replaced either
                OpenOptions::new()
                    .write(true)
                    .open(path)
                    .map_err(unwritable)?;
                fs::canonicalize(path).map_err(unwritable)?
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                if path
                    .as_os_str()
                    .to_string_lossy()
                    .ends_with(std::path::is_separator)
                {
                    let fix = "create it first, and name a file inside it";
                    return Err(bad("there is no such folder".into(), fix));
                }
                behind_links(path)
            }
            Err(error) => return Err(unwritable(error)),
        };

        let folder = match target.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        if !folder.is_dir() {
            let what = format!("there is no folder {}", folder.display());
            return Err(bad(what, "create it first, or choose another one"));
        }
        let (out, temporary) = make_temporary(folder, &target).map_err(unwritable)?;
        Ok(Self {
            file,
            to: To::Replacing {
                out: BufWriter::with_capacity(AT_ONCE, out),
                temporary,
                target,
            },
        })
    }

    /// The error of a write, with the target's name.
    pub(crate) fn failed(&self, source: io::Error) -> Error {
        Error::Write {
            file: self.file.clone(),
            source,
        }
    }

    /// Writes all of it and ends.
    pub(crate) fn write_whole(mut self, bytes: &[u8]) -> Result<(), Error> {
        self.write_all(bytes).map_err(|error| self.failed(error))?;
        self.finish()
    }

    /// All is written: the file takes its place.
    pub(crate) fn finish(mut self) -> Result<(), Error> {
        self.flush().map_err(|error| self.failed(error))?;
        let Self { file, to } = self;
        let To::Replacing {
            out,
            temporary,
            target,
        } = to
        else {
            return Ok(());
        };
        let failed = |source| Error::Write { file, source };
        // some file systems report only now that there was no space
        if let Err(error) = out.get_ref().sync_all() {
            return Err(failed(error));
        }
        let mut unfinished = unfinished();
        temporary
            .persist(target)
            .map_err(|error| failed(error.error))?;
        *unfinished = None;
        Ok(())
    }

    fn writer(&mut self) -> &mut dyn Write {
        match &mut self.to {
            To::Standard(out) => out,
            To::Direct(out) | To::Replacing { out, .. } => out,
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer().flush()
    }
}

/// An empty file beside the target, which a signal that ends the program removes.
fn make_temporary(folder: &Path, target: &Path) -> io::Result<(File, TempPath)> {
    static HANDLER: Once = Once::new();
    HANDLER.call_once(|| {
        before_the_end(|| {
            if let Some(path) = unfinished().take() {
                let _ = fs::remove_file(path);
            }
        });
    });

    let mut builder = tempfile::Builder::new();
    builder.prefix(".raystep-").suffix(".part");
    #[cfg(unix)]
    let permissions: fs::Permissions = {
        use std::os::unix::fs::PermissionsExt;
        // as for any new file: the system takes the umask away
        PermissionsExt::from_mode(0o666)
    };
    #[cfg(unix)]
    builder.permissions(permissions);

    let mut unfinished = unfinished();
    let temporary = builder
        .tempfile_in(folder)
        .map_err(|error| match error.get_ref() {
            // without the temporary file's own name, which nobody knows
            Some(_) => error.kind().into(),
            None => error,
        })?;
    if let Ok(meta) = fs::metadata(target) {
        temporary.as_file().set_permissions(meta.permissions())?;
    }
    *unfinished = Some(temporary.path().into());
    // apart, since together they put the temporary name into every message
    Ok(temporary.into_parts())
}

/// The path that a new file gets: symbolic links that lead nowhere yet are followed.
pub(crate) fn behind_links(path: &Path) -> PathBuf {
    let mut target = path.to_path_buf();
    // a loop of links was refused before; so many in a row no system follows
    for _ in 0..40 {
        let Ok(link) = fs::read_link(&target) else {
            break;
        };
        target = target.parent().unwrap_or(Path::new("")).join(link);
    }
    target
}

/// The name of the unfinished file; a thread that panicked while holding it left it whole.
fn unfinished() -> MutexGuard<'static, Option<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}
