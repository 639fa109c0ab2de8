//! What can be wrong with a lesson or a figure of it.

use std::fmt;
use std::io;

use crate::figure::FigureError;
use crate::scene::{LoadError, Place, printable};
use crate::trace::LogError;
use crate::tracer::Stopped;

/// Why a lesson's figure cannot be had.
#[derive(Debug)]
pub enum LessonError {
    /// The folder of the lessons cannot be read, or holds none.
    Folder {
        /// The folder.
        folder: String,
        /// Why, if the system says so.
        source: Option<io::Error>,
    },
    /// A lesson's file, or the scene of one of its figures.
    Load(LoadError),
    /// A log that a figure was to be drawn from.
    Log(LogError),
    /// There is no such lesson or figure.
    Unknown {
        /// What was looked for.
        name: String,
        /// `lesson`, `figure` or `question`.
        what: &'static str,
        /// A name that is there and like it.
        near: Option<String>,
        /// What is there.
        known: Vec<String>,
    },
    /// A figure that cannot be drawn as its lesson says.
    Figure {
        /// Where the lesson says it.
        place: Box<Place>,
        /// What is wrong.
        error: FigureError,
    },
    /// A question that cannot be asked as its lesson says.
    Question {
        /// Where the lesson says it.
        place: Box<Place>,
        /// What is wrong.
        what: String,
        /// What to do.
        fix: String,
    },
}

impl fmt::Display for LessonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Folder {
                folder,
                source: Some(source),
            } => write!(
                f,
                "{}: the lessons cannot be read: {source}\n  name their folder",
                printable(folder)
            ),
            Self::Folder {
                folder,
                source: None,
            } => write!(
                f,
                "{}: there is no lesson in this folder\n  a lesson is a folder with a lesson.json; name \
                 the folder around them",
                printable(folder)
            ),
            Self::Load(error) => error.fmt(f),
            Self::Log(error) => error.fmt(f),
            Self::Unknown {
                name,
                what,
                near,
                known,
            } => {
                write!(f, "there is no {what} {name:?}")?;
                match near {
                    Some(near) => write!(f, "\n  did you mean {}?", printable(near)),
                    None if known.is_empty() => write!(f, "\n  there is none here"),
                    None => write!(f, "\n  there are {}", printable(&known.join(", "))),
                }
            }
            Self::Figure { place, error } => write!(f, "{place}: {error}"),
            Self::Question { place, what, fix } => write!(
                f,
                "{place}: {}\n  {}",
                what.replace(char::is_control, " "),
                fix.replace(char::is_control, " ")
            ),
        }
    }
}

impl std::error::Error for LessonError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Folder { source, .. } => source.as_ref().map(|source| source as _),
            Self::Load(error) => Some(error),
            Self::Log(error) => Some(error),
            Self::Unknown { .. } | Self::Question { .. } => None,
            Self::Figure { error, .. } => Some(error),
        }
    }
}

impl From<LoadError> for LessonError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

impl From<LogError> for LessonError {
    fn from(error: LogError) -> Self {
        Self::Log(error)
    }
}

/// A tree of rays that does not end, as a mistake in the figure.
pub(super) fn too_many_rays(stopped: &Stopped) -> FigureError {
    FigureError::new(
        "scene",
        stopped.to_string(),
        "lower the scene's \"max_depth\", or its reflection and transmission",
    )
}
