//! What follows a command that a face alone cannot do.

use raystep::step::{Command, Shift};

/// What follows a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Next {
    /// More commands.
    Here,
    /// The same pixel with the next strategy.
    Strategy,
    /// The pixel beside.
    Pixel(Shift),
    /// The end.
    Quit,
}

impl Next {
    /// What follows a command that a reader has left to others.
    pub(crate) fn of(command: &Command) -> Self {
        match command {
            Command::Strategy => Self::Strategy,
            Command::Pixel(shift) => Self::Pixel(*shift),
            Command::Quit => Self::Quit,
            _ => Self::Here,
        }
    }
}
