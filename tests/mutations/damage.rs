//! How a file is damaged.

use std::ops::{Range, RangeInclusive};

use crate::seeded::Seeded;

/// How many times a file is damaged, at most: half of them once, few more than three times.
const MOST: usize = 6;

/// What stands in files and makes trouble: numbers at the ends of what numbers can be, marks of each format, and
/// characters that a terminal, a shell or a browser would obey.
const WORDS: [&str; 44] = [
    "0",
    "-0",
    "-1",
    "1",
    "2",
    "0.5",
    "1e-51",
    "1e50",
    "1e51",
    "1e308",
    "1e999",
    "-1e50",
    "NaN",
    "Infinity",
    "null",
    "true",
    "[]",
    "{}",
    "\"\"",
    "\"A\"",
    "\"\\n\"",
    "\"\\u0000\"",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "99999999999999999999999",
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "\\",
    "{{",
    "}}",
    "#raystep",
    "\n",
    "\0",
    "\u{1b}[2J",
    "\u{202e}",
    "é",
    "s",
    "f",
];

/// One of the files, damaged.
pub(crate) fn damaged(files: &[&[u8]], random: &mut Seeded) -> Vec<u8> {
    let mut bytes = files[random.index(files.len())].to_vec();
    for _ in 0..MOST {
        damage_once(&mut bytes, files, random);
        if random.index(2) == 0 {
            break;
        }
    }
    bytes
}

fn damage_once(bytes: &mut Vec<u8>, files: &[&[u8]], random: &mut Seeded) {
    match random.index(10) {
        // a byte
        0 => {
            if let Some(at) = place(bytes, random) {
                bytes[at] = random.bits() as u8;
            }
        }
        // a bit
        1 => {
            if let Some(at) = place(bytes, random) {
                bytes[at] ^= 1 << random.index(8);
            }
        }
        // a piece is lost
        2 => {
            let piece = piece(bytes, random, 1..=60);
            bytes.drain(piece);
        }
        // a piece comes twice
        3 => {
            let copy = bytes[piece(bytes, random, 1..=60)].to_vec();
            let at = random.index(bytes.len() + 1);
            bytes.splice(at..at, copy);
        }
        // the end is lost
        4 => {
            if random.index(4) == 0 {
                let at = random.index(bytes.len() + 1);
                bytes.truncate(at);
            }
        }
        // a piece of another file
        5 => {
            let other = files[random.index(files.len())];
            let copy = other[piece(other, random, 1..=200)].to_vec();
            let into = piece(bytes, random, 0..=20);
            bytes.splice(into, copy);
        }
        // a word comes in
        6 => {
            let at = random.index(bytes.len() + 1);
            bytes.splice(at..at, WORDS[random.index(WORDS.len())].bytes());
        }
        // a word or a number becomes another one
        _ => {
            let into = word(bytes, random);
            let by = if random.index(3) == 0 {
                bytes[word(bytes, random)].to_vec()
            } else {
                WORDS[random.index(WORDS.len())].into()
            };
            bytes.splice(into, by);
        }
    }
}

fn place(bytes: &[u8], random: &mut Seeded) -> Option<usize> {
    (!bytes.is_empty()).then(|| random.index(bytes.len()))
}

/// A piece of the file with so many bytes, or up to its end.
fn piece(bytes: &[u8], random: &mut Seeded, lengths: RangeInclusive<usize>) -> Range<usize> {
    let start = random.index(bytes.len() + 1);
    let length = lengths.start() + random.index(lengths.end() - lengths.start() + 1);
    start..bytes.len().min(start + length)
}

/// The letters, or the digits, around a place.
fn word(bytes: &[u8], random: &mut Seeded) -> Range<usize> {
    let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || b"_.-+".contains(byte);
    let at = random.index(bytes.len() + 1);
    let length = bytes[at..].iter().take_while(|byte| is_part(byte)).count();
    let before = bytes[..at].iter().rev();
    at - before.take_while(|byte| is_part(byte)).count()..at + length
}
