//! The folders of a book: its own, that of the lessons, and the project's root around the lessons, where commands run and
//! from which the paths of shown files count.

use std::path::{Path, PathBuf};

use crate::scene::quoted;

/// Where the folders are.
#[derive(Clone, Debug)]
pub struct Project {
    /// The folder of `book.toml`.
    pub book: PathBuf,
    /// The folder of the lessons.
    pub lessons: PathBuf,
    /// The folder that holds that of the lessons.
    pub root: PathBuf,
}

impl Project {
    /// The folders of a book, from that of `book.toml` and that of the lessons as seen from there.
    pub(super) fn new(book: &Path, lessons: &Path) -> Self {
        let real = |path: PathBuf| path.canonicalize().unwrap_or(path);
        let lessons = real(book.join(lessons));
        let root = lessons
            .parent()
            .map_or_else(|| lessons.clone(), Path::to_path_buf);
        Self {
            book: real(book.to_path_buf()),
            lessons,
            root,
        }
    }

    /// The folder of the lessons as a command in the root names it; `None` where that is what commands look for anyway.
    pub(super) fn lessons_word(&self, usual: &str) -> Option<String> {
        let name = self.lessons.file_name()?.to_string_lossy().into_owned();
        (name != usual).then_some(name)
    }

    /// A file of the project, by its path from the root.
    ///
    /// # Errors
    /// There is no such file, or it lies outside of the root.
    pub(super) fn file(&self, path: &str) -> Result<PathBuf, String> {
        let real = self.root.join(path).canonicalize().map_err(|error| {
            format!(
                "{} cannot be read: {error}\n  its path counts from the folder that holds the lessons, {}",
                quoted(path),
                self.root.display()
            )
        })?;
        if !real.starts_with(&self.root) {
            return Err(format!(
                "{} lies outside of the project\n  show files below {}",
                quoted(path),
                self.root.display()
            ));
        }
        Ok(real)
    }

    /// Does a command in the root read what belongs to the course when it reads this: the lessons, or the book?
    pub fn is_of_course(&self, path: &Path) -> bool {
        let real = self.root.join(path).canonicalize();
        real.is_ok_and(|real| real.starts_with(&self.lessons) || real.starts_with(&self.book))
    }
}
