//! A scene file that was read, and where each of its values stands.

use std::path::PathBuf;

use crate::scene::file::SceneFile;
use crate::scene::load::error::{LoadError, Place};
use crate::scene::load::locate;
use crate::scene::{Scene, SceneFault};

/// A scene file that has the right form. It may still be changed before [`Loaded::build`] checks it.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// What the file says.
    pub scene: SceneFile,
    /// Notes of what was ignored or corrected while reading; they do not stop the loading.
    pub notes: Vec<String>,
    /// The files that were read for it: those of its meshes, and its own where it was read from a file.
    pub files: Vec<PathBuf>,
    /// Where each value stands.
    pub(super) source: Source,
}

impl Loaded {
    /// The scene, checked.
    ///
    /// # Errors
    /// A value that makes no sense, with its file, line and path.
    pub fn build(self) -> Result<Scene, LoadError> {
        Scene::new(self.scene).map_err(|fault| self.source.fault(fault))
    }
}

/// The file that a scene came from, to find the line of a mistake again.
#[derive(Clone, Debug)]
pub(super) struct Source {
    pub(super) file: String,
    pub(super) lines: Lines,
}

/// How a path leads to a line.
#[derive(Clone, Debug)]
pub(super) enum Lines {
    /// By reading the JSON text again.
    Json(String),
    /// By the lines that were noted while reading.
    Table(Table),
}

/// Where the parts of a scene begin.
#[derive(Clone, Debug, Default)]
pub(super) struct Table {
    /// The line of each object: there may be a million of them, and a path for each would be long.
    pub(super) objects: Vec<usize>,
    /// Of all else the beginnings of paths, such as `lights[2]`, and their lines.
    pub(super) others: Vec<(String, usize)>,
}

impl Table {
    fn line_of(&self, path: &str) -> Option<usize> {
        if let Some(rest) = path.strip_prefix("objects[") {
            let (index, _) = rest.split_once(']')?;
            return self.objects.get(index.parse::<usize>().ok()?).copied();
        }
        let known = self.others.iter();
        let beginnings = known.filter(|(start, _)| is_beginning(start, path));
        let longest = beginnings.max_by_key(|(start, _)| start.len());
        longest.map(|(_, line)| *line)
    }
}

impl Source {
    fn fault(&self, SceneFault { path, fault }: SceneFault) -> LoadError {
        let line = match &self.lines {
            Lines::Json(text) => locate::line_of(text, &path),
            Lines::Table(table) => table.line_of(&path),
        };
        let place = Place {
            file: self.file.clone(),
            line,
            path,
        };
        LoadError::Fault { place, fault }
    }
}

/// Does the path begin with these whole keys and indices?
fn is_beginning(start: &str, path: &str) -> bool {
    path.strip_prefix(start)
        .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
