//! What can be wrong with a log before anything is compared.

use std::fmt;
use std::io;

use crate::tracer::Stopped;

/// A log that cannot be checked.
#[derive(Debug)]
pub enum CheckError {
    /// The input cannot be read.
    Read {
        /// The name of the log.
        file: String,
        /// Why.
        source: io::Error,
    },
    /// A line makes no sense.
    Line {
        /// The name of the log.
        file: String,
        /// The number of the line, from 1.
        line: u64,
        /// What is wrong.
        what: String,
        /// What to do.
        fix: String,
    },
    /// The scene takes too many rays in a pixel of the log.
    Stopped(Stopped),
}

impl fmt::Display for CheckError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { file, source } => {
                write!(
                    f,
                    "{file}: cannot be read: {source}\n  check the name and the folder"
                )
            }
            Self::Line {
                file,
                line,
                what,
                fix,
            } => write!(f, "{file}, line {line}: {what}\n  {fix}"),
            Self::Stopped(stopped) => write!(f, "{stopped}"),
        }
    }
}

impl std::error::Error for CheckError {}

impl From<Stopped> for CheckError {
    fn from(stopped: Stopped) -> Self {
        Self::Stopped(stopped)
    }
}
