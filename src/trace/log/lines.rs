//! The lines of a log, one after the other, without copying those that lie whole in the input's buffer.

use std::io::{self, BufRead};

use memchr::memchr;

use crate::scene::{LONGEST_LINE, ReadEnd, gibibytes, read_up_to};
use crate::trace::LogError;
use crate::trace::log::line_reader::Damage;

/// The lines of an input, and where it stands.
#[derive(Debug)]
pub(super) struct LogLines<R> {
    file: String,
    input: R,
    /// The number of the line that was read last, from 1.
    number: usize,
    last: LastLine,
    /// The next line is the last one again.
    again: bool,
    /// A line that did not lie whole in the buffer.
    copied: Vec<u8>,
}

/// Where the line lies that was read last.
#[derive(Clone, Copy, Debug)]
enum LastLine {
    /// In the input's buffer: the number of its bytes, the line end included.
    Buffered(usize),
    /// In a copy.
    Copied,
}

impl<R: BufRead> LogLines<R> {
    /// The lines of this input; its name is for errors.
    pub(super) fn new(file: &str, input: R) -> Self {
        Self {
            file: file.into(),
            input,
            number: 0,
            last: LastLine::Buffered(0),
            again: false,
            copied: Vec::new(),
        }
    }

    /// The name of the input.
    pub(super) fn file(&self) -> &str {
        &self.file
    }

    /// The next line without its end; `None` behind the last. A last line without an end was cut off.
    ///
    /// # Errors
    /// An input that cannot be read, and a line that was cut off.
    #[inline]
    pub(super) fn next(&mut self) -> Result<Option<&[u8]>, LogError> {
        if !std::mem::take(&mut self.again) {
            if let LastLine::Buffered(length) = self.last {
                self.input.consume(length);
            }
            self.number += 1;
            self.last = match self.input.fill_buf() {
                Ok(buffer) => match memchr(b'\n', buffer) {
                    Some(end) => LastLine::Buffered(end + 1),
                    None => return self.copy_line(),
                },
                // interrupted, or a true error: reading on shows which
                Err(_) => return self.copy_line(),
            };
        }
        match self.last {
            LastLine::Buffered(length) => {
                let buffer = self.input.fill_buf();
                let buffer = buffer.map_err(|error| unreadable(&self.file, error))?;
                Ok(Some(&buffer[..length - 1]))
            }
            LastLine::Copied => Ok(Some(&self.copied)),
        }
    }

    /// Gives the last line again as the next one.
    pub(super) fn put_back(&mut self) {
        self.again = true;
    }

    /// The error that the last line is damaged.
    pub(super) fn damaged(&self, damage: Damage) -> LogError {
        damage.at(&self.file, self.number)
    }

    /// A line that goes beyond the buffer.
    #[cold]
    fn copy_line(&mut self) -> Result<Option<&[u8]>, LogError> {
        self.last = LastLine::Copied;
        self.copied.clear();
        let read = read_up_to(&mut self.input, b'\n', LONGEST_LINE, &mut self.copied);
        let what = match read.map_err(|error| unreadable(&self.file, error))? {
            ReadEnd::Stop => {
                self.copied.pop();
                return Ok(Some(&self.copied));
            }
            ReadEnd::Input if self.copied.is_empty() => return Ok(None),
            ReadEnd::Input => "the line has no end: the log was cut off here".into(),
            ReadEnd::Zero => "the line has a byte 0, which text never has".into(),
            ReadEnd::Limit => format!("the line has more than {}", gibibytes(LONGEST_LINE)),
        };
        Err(self.damaged(Damage::new(what)))
    }
}

fn unreadable(file: &str, source: io::Error) -> LogError {
    let file = file.into();
    LogError::Read { file, source }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::BufReader;

    #[test]
    fn the_lines_are_the_same_whatever_the_buffer_holds() {
        let text = "one\n\nthree is longer\nx\n";
        for capacity in 1..=text.len() {
            let input = BufReader::with_capacity(capacity, text.as_bytes());
            let mut lines = LogLines::new("log", input);
            for line in ["one", "", "three is longer", "x"] {
                for _ in 0..2 {
                    let read = lines.next().unwrap();
                    assert_eq!(read, Some(line.as_bytes()), "capacity {capacity}");
                    lines.put_back();
                }
                lines.next().unwrap();
            }
            for _ in 0..2 {
                assert_eq!(lines.next().unwrap(), None, "capacity {capacity}");
            }
        }
    }

    #[test]
    fn a_line_without_an_end_is_told_with_its_number() {
        for capacity in 1..12 {
            let input = BufReader::with_capacity(capacity, "one\ntwo".as_bytes());
            let mut lines = LogLines::new("log", input);
            assert!(lines.next().is_ok());
            let error = lines.next().unwrap_err().to_string();
            let expected = "log, line 2: the line has no end: the log was cut off here";
            assert!(error.starts_with(expected), "{error}");
        }
    }

    #[test]
    fn a_line_that_goes_on_for_ever_is_told() {
        let input = BufReader::new(io::Read::chain(&b"one\n"[..], io::repeat(0)));
        let mut lines = LogLines::new("log", input);
        assert!(lines.next().is_ok());
        let error = lines.next().unwrap_err().to_string();
        let expected = "log, line 2: the line has a byte 0, which text never has\n";
        assert!(error.starts_with(expected), "{error}");
    }
}
