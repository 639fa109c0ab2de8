//! Where the commands of the text come from: a script, or standard input line by line.

use std::io::{self, BufRead, IsTerminal, Write};

use raystep::LoadError;
use raystep::scene::{ReadEnd, read_up_to};
use raystep::step::{Command, commands};

use crate::cli::Error;
use crate::cli::output::Output;
use crate::cli::step::plain;

/// The most bytes of a line of commands.
const LONGEST_LINE: u64 = 1 << 16;

/// Where the commands come from: a script, or standard input line by line.
pub(crate) struct Commands {
    waiting: std::vec::IntoIter<Command>,
    /// Is there more to be read?
    reads: bool,
}

impl Commands {
    pub(crate) fn new(script: Option<Vec<Command>>) -> Self {
        let reads = script.is_none();
        Self {
            waiting: script.unwrap_or_default().into_iter(),
            reads,
        }
    }

    /// The next command; `None` at the end. A line that makes no sense is said, and the next one is read.
    pub(crate) fn next(&mut self, out: &mut Output) -> Result<Option<Command>, Error> {
        loop {
            if let Some(command) = self.waiting.next() {
                return Ok(Some(command));
            }
            if !self.reads {
                return Ok(None);
            }
            let mut input = io::stdin().lock();
            if input.is_terminal() {
                plain::write("> ", out)?;
            }
            out.flush().map_err(|error| out.failed(error))?;
            match read_line(&mut input)? {
                Line::Text(line) => match commands(&line) {
                    Ok(commands) => self.waiting = commands.into_iter(),
                    Err(error) => plain::say(&error.to_string(), out)?,
                },
                Line::TooLong => plain::say("this line of commands is too long", out)?,
                Line::End => return Ok(None),
            }
        }
    }
}

/// A line of standard input.
enum Line {
    Text(String),
    TooLong,
    /// There is none.
    End,
}

fn read_line(input: &mut impl BufRead) -> Result<Line, Error> {
    let unreadable = |source| {
        Error::Load(LoadError::Read {
            file: "standard input".into(),
            source,
        })
    };
    let mut line = Vec::new();
    let mut end = read_up_to(input, b'\n', LONGEST_LINE, &mut line).map_err(unreadable)?;
    if end == ReadEnd::Limit {
        while end == ReadEnd::Limit {
            line.clear();
            end = read_up_to(input, b'\n', LONGEST_LINE, &mut line).map_err(unreadable)?;
        }
        return Ok(Line::TooLong);
    }
    if line.is_empty() {
        return Ok(Line::End);
    }
    Ok(Line::Text(String::from_utf8_lossy(&line).into_owned()))
}
