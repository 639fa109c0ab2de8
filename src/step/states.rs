//! The state at each event: some are kept, and those between are made from the one before them.

use crate::step::quantity::Changed;
use crate::step::state::{Entered, State};
use crate::trace::Record;

/// The most states that are kept: a state may hold as many mailboxes as the scene has objects, so their number must not
/// grow with the log.
const MOST_KEPT: usize = 256;

/// The fewest events between two states that are kept: to take so many is faster than to find out what they set.
const LEAST_APART: usize = 64;

/// The states of a log.
#[derive(Clone, Debug)]
pub(in crate::step) struct States {
    /// How many events lie between two states that are kept.
    apart: usize,
    /// The state before each `apart`-th event.
    kept: Vec<State>,
    /// The state after the last event that was taken.
    now: State,
}

impl States {
    /// Those of a log of this many events, none of which has been taken.
    pub(in crate::step) fn new(start: State, events: usize) -> Self {
        Self {
            apart: events.div_ceil(MOST_KEPT).max(LEAST_APART),
            kept: Vec::new(),
            now: start,
        }
    }

    /// Enters the ray of the next event.
    pub(in crate::step) fn enter(&mut self, at: usize, record: &Record) -> Entered {
        if at.is_multiple_of(self.apart) {
            self.kept.push(self.now.clone());
        }
        self.now.enter(record)
    }

    /// Takes the event that was entered.
    pub(in crate::step) fn take(&mut self, at: usize, record: &Record) -> Changed {
        self.now.take(at, record)
    }

    /// The state before an event; behind the last one, the state after all.
    pub(in crate::step) fn before(&self, event: usize, records: &[Record]) -> State {
        let event = event.min(records.len());
        let place = event / self.apart;
        let Some(kept) = self.kept.get(place) else {
            return self.now.clone();
        };
        let mut state = kept.clone();
        let first = place * self.apart;
        for (at, record) in (first..event).zip(&records[first..event]) {
            state.enter(record);
            state.take(at, record);
        }
        state
    }
}
