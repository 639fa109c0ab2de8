//! Why a log could not be read: what, where, and what to do about it.

use std::fmt;
use std::io;

use crate::scene::{SceneFault, printable};
use crate::trace::log::head::LOG_VERSION;

/// Why a log could not be read: what, where, and what to do about it.
#[derive(Debug)]
pub enum LogError {
    /// The file could not be read.
    Read {
        /// The file, as it was given.
        file: String,
        /// What the system said.
        source: io::Error,
    },
    /// The file is no log.
    NoLog {
        /// The file, as it was given.
        file: String,
    },
    /// The log was written by another version of the program.
    Version {
        /// The file, as it was given.
        file: String,
        /// The version that it says.
        found: u32,
    },
    /// A line is damaged.
    Line {
        /// The file, as it was given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1, if the JSON itself is broken.
        column: Option<usize>,
        /// What is wrong there.
        what: String,
    },
    /// The scene in the head makes no sense.
    Scene {
        /// The file, as it was given.
        file: String,
        /// What is wrong there.
        fault: SceneFault,
    },
}

impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { file, source } => write!(
                f,
                "{}: cannot be read: {source}\n  check that it is a file you may read",
                printable(file)
            ),
            Self::NoLog { file } => write!(
                f,
                "{}: this is not a log: the first line has no \"kind\":\"trace\"\n  \
                 make one",
                printable(file)
            ),
            Self::Version { file, found } => write!(
                f,
                "{}, line 1: the log has version {found}, and this program reads version \
                 {LOG_VERSION}\n  make the log again with this program",
                printable(file)
            ),
            Self::Line {
                file,
                line,
                column,
                what,
            } => {
                write!(f, "{}, line {line}", printable(file))?;
                if let Some(column) = column {
                    write!(f, ", column {column}")?;
                }
                write!(
                    f,
                    ": {}\n  the log is damaged: make it again",
                    printable(what)
                )
            }
            Self::Scene { file, fault } => write!(
                f,
                "{}: the scene in the log: {}: {}\n  {}",
                printable(file),
                printable(&fault.path),
                fault.fault,
                fault.fault.fix()
            ),
        }
    }
}

impl std::error::Error for LogError {}
