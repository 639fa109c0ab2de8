//! What exists for speed alone in writing and reading a line: a writer and a scanner of events.
//!
//! Both do what the plain [`line_writer`](super::line_writer) and [`line_reader`](super::line_reader) do.

mod line_scanner;
mod line_writer;
mod number_texts;
mod quoted;
#[cfg(test)]
pub(super) mod samples;
mod scanner;
mod short_text;
mod small_numbers;

pub(super) use line_scanner::scan_event;
pub(crate) use line_writer::EventWriter;
