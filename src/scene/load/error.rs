//! Why a scene could not be loaded: what, where, and what to do about it.

use std::fmt;
use std::io;

use crate::scene::fault::Fault;
use crate::scene::printable;

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
                "{place}: the file {name:?} is outside the folder of the file that names it\n  move it there, or \
                 allow files outside of it"
            ),
            Self::Fault { place, fault } => write!(f, "{place}: {fault}\n  {}", fault.fix()),
        }
    }
}

impl std::error::Error for LoadError {}
