//! Reading with a limit: an input that never ends is refused, before it fills the memory.

use std::io::{self, BufRead};

use memchr::memchr2;

/// The longest line of a scene or a log, in bytes: 1 GiB. The faces of ten million triangles, written on one line, take
/// as much.
pub const LONGEST_LINE: u64 = 1 << 30;

/// The largest scene file, in bytes: 4 GiB. What it says takes several times as much memory.
pub const LARGEST_FILE: u64 = 1 << 32;

/// Where a reading ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadEnd {
    /// Behind the byte that it was to stop at.
    Stop,
    /// Behind a byte 0, which no text has: the rest may go on for ever.
    Zero,
    /// At the end of the input.
    Input,
    /// At the limit: more bytes follow.
    Limit,
}

/// Appends the input's bytes up to and with the first byte `stop`, or the first 0, as long as all bytes together are no
/// more than the limit.
///
/// # Errors
/// An input that cannot be read.
pub fn read_up_to(
    input: &mut impl BufRead,
    stop: u8,
    limit: u64,
    bytes: &mut Vec<u8>,
) -> io::Result<ReadEnd> {
    loop {
        let buffer = match input.fill_buf() {
            Ok(buffer) => buffer,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        if buffer.is_empty() {
            return Ok(ReadEnd::Input);
        }
        let found = memchr2(stop, 0, buffer);
        let taken = &buffer[..found.map_or(buffer.len(), |at| at + 1)];
        if limit < (bytes.len() + taken.len()) as u64 {
            return Ok(ReadEnd::Limit);
        }
        bytes.extend_from_slice(taken);
        let (count, last) = (taken.len(), taken.last().copied());
        input.consume(count);
        if found.is_some() {
            let is_zero = last == Some(0);
            return Ok(if is_zero {
                ReadEnd::Zero
            } else {
                ReadEnd::Stop
            });
        }
    }
}

/// A limit in words.
pub(crate) fn gibibytes(limit: u64) -> String {
    format!("{} GiB", limit >> 30)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{BufReader, Read, repeat};

    /// What is read of an input through a buffer of each size up to 12 bytes.
    #[track_caller]
    fn reads(input: &[u8], limit: u64, end: ReadEnd, read: &[u8]) {
        for capacity in 1..12 {
            let mut input = BufReader::with_capacity(capacity, input);
            let mut bytes = Vec::new();
            let ended = read_up_to(&mut input, b'\n', limit, &mut bytes).unwrap();
            assert_eq!(ended, end, "capacity {capacity}");
            // of what is over the limit a part may be there
            assert!(read.starts_with(&bytes), "capacity {capacity}");
            assert!(
                end == ReadEnd::Limit || bytes == read,
                "capacity {capacity}"
            );
        }
    }

    #[test]
    fn a_line_ends_at_its_end_at_a_zero_or_at_the_end_of_the_input() {
        reads(b"one\ntwo\n", 9, ReadEnd::Stop, b"one\n");
        reads(b"one\0two\n", 9, ReadEnd::Zero, b"one\0");
        reads(b"one", 9, ReadEnd::Input, b"one");
        reads(b"", 9, ReadEnd::Input, b"");
    }

    #[test]
    fn a_line_may_have_as_many_bytes_as_the_limit_and_no_more() {
        reads(b"123\n", 4, ReadEnd::Stop, b"123\n");
        reads(b"1234\n", 4, ReadEnd::Limit, b"1234");
        reads(b"1234", 4, ReadEnd::Input, b"1234");
    }

    #[test]
    fn an_input_without_an_end_is_read_up_to_the_limit() {
        let mut bytes = Vec::new();
        let mut letters = BufReader::new(repeat(b'a').take(u64::MAX));
        let ended = read_up_to(&mut letters, 0, 100_000, &mut bytes).unwrap();
        assert_eq!((ended, bytes.len() <= 100_000), (ReadEnd::Limit, true));

        bytes.clear();
        let ended = read_up_to(&mut BufReader::new(repeat(0)), 0, LARGEST_FILE, &mut bytes);
        assert_eq!((ended.unwrap(), bytes.len()), (ReadEnd::Zero, 1));
    }
}
