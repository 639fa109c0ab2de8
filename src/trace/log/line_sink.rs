//! Records as lines in a buffer, for whoever writes them to take.

use std::ops::ControlFlow;

use crate::trace::log::fast::EventWriter;
use crate::trace::log::names::LogNames;
use crate::trace::record::{Record, Sink};

/// Makes lines of records and keeps them in one buffer, for their taker to empty.
#[derive(Clone, Debug)]
pub struct LineSink<'a> {
    writer: EventWriter<'a>,
    /// Whole lines, each with its end.
    pub lines: Vec<u8>,
    /// How many lines were made.
    pub count: u64,
}

impl<'a> LineSink<'a> {
    /// An empty buffer.
    pub fn new(names: &'a LogNames) -> Self {
        Self {
            writer: EventWriter::new(names),
            lines: Vec::new(),
            count: 0,
        }
    }
}

impl Sink for LineSink<'_> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        self.writer.line(record, &mut self.lines);
        self.count += 1;
        ControlFlow::Continue(())
    }
}
