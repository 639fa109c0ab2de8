//! Tiles over threads, one output: the bytes come out in the order of the tiles whatever the threads
//! do, and memory stays small.
//!
//! Tiles are handed out in order, so the lowest unfinished one is always being worked on: it writes
//! through. Later ones keep up to [`KEPT`] bytes and then wait for their turn.

use std::io::{self, Write};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// How much a tile keeps before it waits: some thousand lines of a log.
const KEPT: usize = 1 << 20;

/// More than most lines take: the one that fills a buffer finds room in it.
const LONG_LINE: usize = 1 << 12;

/// An output that tiles share.
pub(super) struct InOrder<W> {
    state: Mutex<State<W>>,
    turn: Condvar,
}

struct State<W> {
    out: W,
    /// The lowest tile that is not finished.
    next: usize,
    /// Lines that may still be written.
    budget: u64,
    stopped: Option<Stopped>,
}

/// Why no more is written.
#[derive(Debug)]
pub(super) enum Stopped {
    /// The output failed.
    Output(io::Error),
    /// The budget is spent.
    Budget,
}

/// What one tile has to say.
pub(super) struct Tile<'a, W> {
    number: usize,
    shared: &'a InOrder<W>,
    /// Lines that were not written yet, and how many.
    lines: &'a mut Vec<u8>,
    count: u64,
    stopped: bool,
}

impl<W: Write + Send> InOrder<W> {
    /// An output that takes up to a number of lines.
    pub(super) fn new(out: W, budget: u64) -> Self {
        Self {
            state: Mutex::new(State {
                out,
                next: 0,
                budget,
                stopped: None,
            }),
            turn: Condvar::new(),
        }
    }

    /// Works through all tiles on the threads of the current pool. The work stops early once the
    /// output has.
    pub(super) fn run(&self, tiles: usize, work: impl Fn(Tile<'_, W>) + Sync) -> Option<Stopped> {
        let handed_out = AtomicUsize::new(0);
        let threads = rayon::current_num_threads();
        rayon::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|_| {
                    // one buffer a thread: fresh memory for every tile would cost as much as its lines
                    let mut lines = Vec::with_capacity(KEPT + LONG_LINE);
                    loop {
                        let number = handed_out.fetch_add(1, Ordering::Relaxed);
                        if tiles <= number || self.lock().stopped.is_some() {
                            return;
                        }
                        work(Tile {
                            number,
                            shared: self,
                            lines: &mut lines,
                            count: 0,
                            stopped: false,
                        });
                    }
                });
            }
        });
        self.lock().stopped.take()
    }
}

impl<W> InOrder<W> {
    /// The state; a thread that panicked while holding it left it whole.
    fn lock(&self) -> MutexGuard<'_, State<W>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<W: Write + Send> Tile<'_, W> {
    /// The tile's place in the order.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Adds a line, which is kept until it is worth writing.
    #[inline]
    pub(super) fn line(&mut self, append: impl FnOnce(&mut Vec<u8>)) {
        if self.stopped {
            return;
        }
        append(self.lines);
        self.count += 1;
        if KEPT <= self.lines.len() {
            self.write();
        }
    }

    /// Has the output stopped taking lines?
    pub(super) fn is_stopped(&self) -> bool {
        self.stopped
    }

    /// Writes the last lines, and lets the next tile have its turn.
    pub(super) fn finish(mut self) {
        self.write();
    }

    /// Waits for the tile's turn and writes.
    fn write(&mut self) {
        let waits = |state: &mut State<W>| state.next < self.number;
        let state = self.shared.lock();
        let state = self.shared.turn.wait_while(state, waits);
        let mut state = state.unwrap_or_else(PoisonError::into_inner);
        if state.stopped.is_none() {
            if state.budget < self.count {
                state.stopped = Some(Stopped::Budget);
            } else {
                state.budget -= self.count;
                state.stopped = state.out.write_all(self.lines).err().map(Stopped::Output);
            }
        }
        self.stopped = state.stopped.is_some();
        self.lines.clear();
        self.count = 0;
    }
}

/// Whatever ends a tile, the next one gets its turn: none waits for one that is gone.
impl<W> Drop for Tile<'_, W> {
    fn drop(&mut self) {
        self.lines.clear();
        self.shared.lock().next += 1;
        self.shared.turn.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 40 tiles of which the first take longest, each with more than one buffer full.
    fn run(threads: usize, budget: u64) -> (Vec<u8>, Option<Stopped>) {
        let mut out = Vec::new();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let stopped = {
            let shared = InOrder::new(&mut out, budget);
            pool.build().unwrap().install(|| {
                shared.run(40, |mut tile| {
                    let number = tile.number;
                    for _ in 0..(40 - number) {
                        tile.line(|lines| lines.resize(lines.len() + KEPT / 8, number as u8));
                    }
                    tile.finish();
                })
            })
        };
        (out, stopped)
    }

    #[test]
    fn the_tiles_come_out_in_order_on_any_number_of_threads() {
        let (one, stopped) = run(1, u64::MAX);
        assert!(stopped.is_none());
        assert!(one.is_sorted());
        assert_eq!(one.len(), (1..=40).sum::<usize>() * KEPT / 8);
        for threads in [2, 3, 8] {
            assert!(run(threads, u64::MAX).0 == one, "{threads} threads");
        }
    }

    #[test]
    fn a_spent_budget_stops_all_tiles() {
        assert!(matches!(run(2, 100).1, Some(Stopped::Budget)));
        assert!(run(2, 820).1.is_none());
        assert!(matches!(run(2, 819).1, Some(Stopped::Budget)));
    }
}
