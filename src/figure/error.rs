//! Why a figure cannot be drawn.

use std::fmt;

use crate::scene::printable;

/// What is wrong with a figure's specification, or with the log it is to be drawn from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureError {
    /// The key of the specification that it is about, such as `pixel`.
    pub key: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub what: String,
    /// What to do about it.
    pub fix: String,
    /// Whether the log is at fault that the figure is drawn from, and not the specification.
    pub is_of_log: bool,
}

impl FigureError {
    /// A mistake in the specification, at this key; an empty key is the specification as a whole.
    pub(crate) fn new(key: &'static str, what: impl Into<String>, fix: impl Into<String>) -> Self {
        Self {
            key,
            what: what.into(),
            fix: fix.into(),
            is_of_log: false,
        }
    }

    /// A log that the figure cannot be drawn from.
    pub(crate) fn of_log(what: impl Into<String>) -> Self {
        Self {
            is_of_log: true,
            ..Self::new("", what, "write the figure's log again")
        }
    }
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n  {}", printable(&self.what), printable(&self.fix))
    }
}

impl std::error::Error for FigureError {}
