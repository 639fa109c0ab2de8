//! Reading scenes: JSON, NFF and OBJ, by the file's ending, or by its content from standard input.

mod bounded;
mod files;
mod json;
mod locate;
mod nff;
mod obj;
mod words;

pub(crate) use bounded::gibibytes;
pub use bounded::{LARGEST_FILE, LONGEST_LINE, ReadEnd, read_up_to};
pub use files::{Files, IsOutside, NoFiles};
pub(crate) use json::parse_json;
pub(crate) use locate::line_of;

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::scene::fault::Fault;
use crate::scene::file::SceneFile;
use crate::scene::{Scene, SceneFault, printable};

/// A scene file that has the right form. It may still be changed before [`Loaded::build`] checks it.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// What the file says.
    pub scene: SceneFile,
    /// What was left out or mended while reading: to be told, not to be stopped by.
    pub notes: Vec<String>,
    /// The files that were read for it: those of its meshes, and its own where it was read from a file.
    pub files: Vec<PathBuf>,
    /// Where each value stands.
    source: Source,
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
struct Source {
    file: String,
    lines: Lines,
}

/// How a path leads to a line.
#[derive(Clone, Debug)]
enum Lines {
    /// By reading the JSON text again.
    Json(String),
    /// By the lines that were noted while reading.
    Table(Table),
}

/// Where the parts of a scene begin.
#[derive(Clone, Debug, Default)]
struct Table {
    /// The line of each object: there may be a million of them, and a path for each would be long.
    objects: Vec<usize>,
    /// Of all else the beginnings of paths, such as `lights[2]`, and their lines.
    others: Vec<(String, usize)>,
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

/// Where a mistake is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Place {
    /// The file, as it was given.
    pub file: String,
    /// The line, counted from 1.
    pub line: Option<usize>,
    /// Keys and indices, `objects[0].shape.sphere.radius`; empty in formats that have none.
    pub path: String,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.file))?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        if !self.path.is_empty() && self.path != "." {
            write!(f, ", at {}", printable(&self.path))?;
        }
        Ok(())
    }
}

/// The files that have a JSON Schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SchemaOf {
    /// A scene in JSON.
    Scene,
    /// A lesson.
    Lesson,
}

impl SchemaOf {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Lesson => "lesson",
        }
    }
}

/// Why a scene could not be loaded: what, where, and what to do about it.
#[derive(Debug)]
pub enum LoadError {
    /// The file could not be read.
    Read {
        /// The file, as it was given.
        file: String,
        /// What the system said.
        source: io::Error,
    },
    /// The file is not what its format asks for.
    Form {
        /// Where.
        place: Place,
        /// What is wrong there.
        what: String,
        /// What to do about it.
        fix: Box<str>,
        /// The schema that lists what the file may contain, if the mistake is against it.
        schema: Option<SchemaOf>,
    },
    /// A file is named that lies outside of the folder, which is not allowed.
    Outside {
        /// Where it is named.
        place: Place,
        /// Its name there.
        name: String,
    },
    /// The file has the right form, and a value makes no sense.
    Fault {
        /// Where.
        place: Place,
        /// What is wrong there.
        fault: Fault,
    },
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { file, source } => {
                let fix = match source.kind() {
                    io::ErrorKind::NotFound => "check the name and the folder",
                    io::ErrorKind::IsADirectory => "name a file inside the folder",
                    _ => "check that it is a file you may read",
                };
                write!(f, "{}: cannot be read: {source}\n  {fix}", printable(file))
            }
            Self::Form {
                place, what, fix, ..
            } => {
                write!(f, "{place}: {}\n  {}", printable(what), printable(fix))
            }
            Self::Outside { place, name } => write!(
                f,
                "{place}: the file {name:?} lies outside of the folder of the file that names it\n  move it there, or \
                 allow files outside of it"
            ),
            Self::Fault { place, fault } => write!(f, "{place}: {fault}\n  {}", fault.fix()),
        }
    }
}

impl std::error::Error for LoadError {}

/// What a file is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Json,
    Nff,
    Obj,
}

impl Format {
    /// By the ending; by the content where there is none that we know.
    fn of(name: &str, text: &str) -> Self {
        let ending = Path::new(name).extension().and_then(|e| e.to_str());
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("json" | "jsonl") => Self::Json,
            Some("nff") => Self::Nff,
            Some("obj") => Self::Obj,
            _ if text.trim_start().starts_with('{') => Self::Json,
            _ if text
                .lines()
                .any(|line| line.split_whitespace().next() == Some("from")) =>
            {
                Self::Nff
            }
            _ => Self::Obj,
        }
    }
}

/// Reads a scene in JSON, NFF or OBJ from memory. `file` is its name in messages, and its ending says the format; the
/// mesh files that it names come from `files`.
///
/// # Errors
/// A text that has not the right form, with the line; a mesh file that cannot be read or lies outside of the folder.
pub fn load_bytes(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Loaded, LoadError> {
    let text = text_of(file, bytes, "give a scene in JSON, NFF or OBJ")?;
    match Format::of(file, text) {
        Format::Json => json::read_json(file, text, files),
        Format::Nff => nff::read_nff(file, text),
        Format::Obj => obj::read_obj_scene(file, text),
    }
}

/// The bytes as text, without a byte order mark; binary files are told by the line of the first byte
/// that is none.
pub(crate) fn text_of<'a>(file: &str, bytes: &'a [u8], fix: &str) -> Result<&'a str, LoadError> {
    let at = match std::str::from_utf8(bytes) {
        Ok(text) => match text.find('\0') {
            Some(at) => at,
            None => return Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        },
        Err(error) => error.valid_up_to(),
    };
    let line = 1 + bytes[..at].iter().filter(|&&b| b == b'\n').count();
    Err(LoadError::Form {
        place: Place {
            file: file.into(),
            line: Some(line),
            path: String::new(),
        },
        what: "this is not a text file".into(),
        fix: fix.into(),
        schema: None,
    })
}
