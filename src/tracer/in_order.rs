//! Tiles over threads, one output: the bytes come out in the order of the tiles whatever the threads
//! do, and memory stays small.
//!
//! Tiles are handed out in order, and each hands its lines over in pieces. Whoever hands one over while
//! nobody writes is the writer until no piece is left whose turn it is; the others go on tracing. Pieces
//! whose turn it is not are kept, up to [`KEPT`] of them: then whoever hands over one more waits.

use std::collections::{BTreeMap, VecDeque};
use std::io::{self, Write};
use std::mem;
use std::ops::{AddAssign, ControlFlow};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use crate::parallel;
use crate::tracer::stopped::Stopped;

/// How many bytes a tile hands over at once: a thousand lines of a log, which a second-level cache holds.
const PIECE: usize = 1 << 18;

/// More than most lines take: the one that fills a piece finds room in it.
const LONG_LINE: usize = 1 << 12;

/// How many pieces are kept: 16 MB.
const KEPT: usize = 64;

/// An output that tiles share, and the sum of what they leave behind.
pub(super) struct InOrder<W, S> {
    state: Mutex<State<W, S>>,
    turn: Condvar,
}

struct State<W, S> {
    /// Gone while somebody writes.
    out: Option<W>,
    /// The lowest tile that is not written to its end.
    next: usize,
    /// What tiles have handed over.
    waiting: BTreeMap<usize, Waiting<S>>,
    /// How many pieces wait or are being written.
    kept: usize,
    /// Empty buffers: fresh memory for every piece would cost as much as its lines.
    spare: Vec<Vec<u8>>,
    /// Lines that may still be written.
    budget: u64,
    sum: S,
    ended: Option<Ended>,
}

/// What a tile has handed over, and at its end what it leaves behind, or why it was stopped.
struct Waiting<S> {
    pieces: VecDeque<Piece>,
    left: Option<Result<S, Stopped>>,
}

fn new_buffer() -> Vec<u8> {
    Vec::with_capacity(PIECE + LONG_LINE)
}

/// Some lines, and how many.
struct Piece {
    lines: Vec<u8>,
    count: u64,
}

/// Why no more is written.
#[derive(Debug)]
pub(super) enum Ended {
    /// The output failed.
    Output(io::Error),
    /// The budget is spent.
    Budget,
    /// A tile was stopped.
    Tile(Stopped),
}

/// What one tile has to say.
pub(super) struct Tile<'a, W: Write, S: Default + AddAssign> {
    number: usize,
    shared: &'a InOrder<W, S>,
    /// Lines that are not handed over yet, and how many.
    lines: &'a mut Vec<u8>,
    count: u64,
    finished: bool,
}

impl<W: Write + Send, S: Default + AddAssign + Send> InOrder<W, S> {
    /// An output that takes up to a number of lines.
    pub(super) fn new(out: W, budget: u64) -> Self {
        Self {
            state: Mutex::new(State {
                out: Some(out),
                next: 0,
                waiting: BTreeMap::new(),
                kept: 0,
                spare: Vec::new(),
                budget,
                sum: S::default(),
                ended: None,
            }),
            turn: Condvar::new(),
        }
    }

    /// Works through all tiles on the threads of the current pool, each with tools of its own, and sums up in
    /// their order what they leave behind. The work stops early once the output has, or at the first tile that does
    /// not come to its end.
    pub(super) fn run<T>(
        self,
        tiles: usize,
        tools: impl Fn() -> T + Sync,
        work: impl Fn(&mut Tile<'_, W, S>, &mut T) -> Result<S, Stopped> + Sync,
    ) -> Result<S, Ended> {
        let handed_out = AtomicUsize::new(0);
        parallel::on_each_thread(|| {
            let mut tools = tools();
            let mut lines = new_buffer();
            loop {
                let number = handed_out.fetch_add(1, Ordering::Relaxed);
                if tiles <= number || self.lock().ended.is_some() {
                    return;
                }
                let mut tile = Tile {
                    number,
                    shared: &self,
                    lines: &mut lines,
                    count: 0,
                    finished: false,
                };
                let left = work(&mut tile, &mut tools);
                tile.finish(left);
            }
        });
        let state = self.state.into_inner();
        let state = state.unwrap_or_else(PoisonError::into_inner);
        state.ended.map_or(Ok(state.sum), Err)
    }
}

impl<W, S> InOrder<W, S> {
    /// The state; a thread that panicked while holding it left it whole.
    fn lock(&self) -> MutexGuard<'_, State<W, S>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<W: Write, S: Default + AddAssign> InOrder<W, S> {
    /// Takes a tile's lines and gives it an empty buffer for them; at its end also takes what it leaves behind.
    /// `Break` once the output has stopped.
    fn take(
        &self,
        tile: usize,
        lines: &mut Vec<u8>,
        count: u64,
        left: Option<Result<S, Stopped>>,
    ) -> ControlFlow<()> {
        let must_wait = |state: &mut State<W, S>| {
            // the lowest tile writes itself if nobody else does: somebody always goes on
            let is_writer = state.next == tile && state.out.is_some();
            state.is_full() && !is_writer && state.ended.is_none()
        };
        let state = self.turn.wait_while(self.lock(), must_wait);
        let mut state = state.unwrap_or_else(PoisonError::into_inner);
        if state.ended.is_some() {
            return ControlFlow::Break(());
        }
        let all = &mut *state;
        let waiting = all.waiting.entry(tile).or_insert_with(|| Waiting {
            pieces: VecDeque::new(),
            left: None,
        });
        waiting.left = left;
        if 0 < count {
            let empty = all.spare.pop().unwrap_or_else(new_buffer);
            let lines = mem::replace(lines, empty);
            waiting.pieces.push_back(Piece { lines, count });
            all.kept += 1;
        }
        self.write_ready(state)
    }

    /// Writes all pieces whose turn it is, unless somebody else does. `Break` once the output has stopped.
    fn write_ready<'a>(&'a self, mut state: MutexGuard<'a, State<W, S>>) -> ControlFlow<()> {
        let Some(mut out) = state.out.take() else {
            return ControlFlow::Continue(());
        };
        while let Some(mut piece) = state.next_piece() {
            drop(state);
            let written = out.write_all(&piece.lines);
            piece.lines.clear();
            state = self.lock();
            if let Err(error) = written {
                state.end(Ended::Output(error));
            }
            self.wake(&state);
            state.kept -= 1;
            state.spare.push(piece.lines);
        }
        state.out = Some(out);
        self.wake(&state);
        match state.ended {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        }
    }

    /// Wakes those who wait, if anybody does.
    fn wake(&self, state: &State<W, S>) {
        if state.is_full() || state.ended.is_some() {
            self.turn.notify_all();
        }
    }
}

impl<W, S: AddAssign> State<W, S> {
    /// The next piece in the order, if it is there and the budget has room for it.
    fn next_piece(&mut self) -> Option<Piece> {
        if self.ended.is_some() {
            return None;
        }
        let piece = loop {
            let lowest = self.waiting.get_mut(&self.next)?;
            if let Some(piece) = lowest.pieces.pop_front() {
                break piece;
            }
            match lowest.left.take()? {
                Ok(left) => self.sum += left,
                Err(stopped) => {
                    self.end(Ended::Tile(stopped));
                    return None;
                }
            }
            self.waiting.remove(&self.next);
            self.next += 1;
        };
        match self.budget.checked_sub(piece.count) {
            Some(left) => self.budget = left,
            None => {
                self.end(Ended::Budget);
                return None;
            }
        }
        Some(piece)
    }
}

impl<W, S> State<W, S> {
    fn is_full(&self) -> bool {
        KEPT <= self.kept
    }

    fn end(&mut self, why: Ended) {
        self.ended = Some(why);
        self.waiting.clear();
    }
}

impl<W: Write, S: Default + AddAssign> Tile<'_, W, S> {
    /// The tile's place in the order.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Adds a line, which is kept until it is worth handing over. `Break` once the output has stopped.
    #[inline]
    pub(super) fn line(&mut self, append: impl FnOnce(&mut Vec<u8>)) -> ControlFlow<()> {
        append(self.lines);
        self.count += 1;
        if PIECE <= self.lines.len() {
            return self.hand_over(None);
        }
        ControlFlow::Continue(())
    }

    /// Hands over the last lines and what the tile leaves behind.
    fn finish(mut self, left: Result<S, Stopped>) {
        // whether the output has stopped is asked before the next tile
        let _ = self.hand_over(Some(left));
        self.finished = true;
    }

    fn hand_over(&mut self, left: Option<Result<S, Stopped>>) -> ControlFlow<()> {
        let count = mem::take(&mut self.count);
        let taken = self.shared.take(self.number, self.lines, count, left);
        self.lines.clear();
        taken
    }
}

/// Whatever ends a tile, the next one gets its turn: none waits for one that is gone.
impl<W: Write, S: Default + AddAssign> Drop for Tile<'_, W, S> {
    fn drop(&mut self) {
        if !self.finished {
            let _ = self.hand_over(Some(Ok(S::default())));
        }
    }
}

#[cfg(all(test, feature = "threads"))]
mod tests {
    use super::*;

    /// A sum that tells the order in which it was made.
    #[derive(Default)]
    struct Order(Vec<usize>);

    impl AddAssign for Order {
        fn add_assign(&mut self, other: Self) {
            self.0.extend(other.0);
        }
    }

    /// 40 tiles of which the first take longest, with up to 10 pieces each.
    fn run(threads: usize, out: impl Write + Send, budget: u64) -> Result<Vec<usize>, Ended> {
        run_up_to(40, threads, out, budget)
    }

    /// The same, where the tiles from this one on do not come to their end.
    fn run_up_to(
        fails: usize,
        threads: usize,
        out: impl Write + Send,
        budget: u64,
    ) -> Result<Vec<usize>, Ended> {
        let work = |tile: &mut Tile<'_, _, Order>, (): &mut ()| {
            let number = tile.number();
            for _ in number..40 {
                let line = |lines: &mut Vec<u8>| {
                    lines.resize(lines.len() + PIECE / 4, number as u8);
                };
                if tile.line(line).is_break() {
                    return Err(Stopped::Recorder);
                }
            }
            if fails <= number {
                let pixel = [number as u32, 0];
                return Err(Stopped::Rays { pixel, max_rays: 7 });
            }
            Ok(Order(vec![number]))
        };
        let shared = InOrder::new(out, budget);
        let run = || shared.run(40, || (), work);
        parallel::with_threads(threads, run).map(|order| order.0)
    }

    const LINES: usize = 40 * 41 / 2;

    #[test]
    fn the_tiles_come_out_in_order_on_any_number_of_threads() {
        let bytes = |number: usize| vec![number as u8; (40 - number) * PIECE / 4];
        let expected: Vec<u8> = (0..40).flat_map(bytes).collect();
        for threads in [1, 2, 3, 8] {
            let mut out = Vec::new();
            let order = run(threads, &mut out, u64::MAX).unwrap();
            assert!(out == expected, "{threads} threads");
            assert!(order.into_iter().eq(0..40), "{threads} threads");
        }
    }

    #[test]
    fn a_spent_budget_stops_all_tiles() {
        for threads in [1, 2, 8] {
            let run = |budget| run(threads, io::sink(), budget as u64);
            assert!(matches!(run(100), Err(Ended::Budget)));
            assert!(run(LINES).is_ok());
            assert!(matches!(run(LINES - 1), Err(Ended::Budget)));
        }
    }

    #[test]
    fn of_tiles_that_do_not_come_to_their_end_the_first_in_the_order_ends_the_run() {
        for threads in [1, 2, 8] {
            let mut out = Vec::new();
            let ended = run_up_to(5, threads, &mut out, u64::MAX);
            let pixel = [5, 0];
            assert!(
                matches!(ended, Err(Ended::Tile(stopped))
                    if stopped == Stopped::Rays { pixel, max_rays: 7 }),
                "{ended:?}, {threads} threads"
            );
            // its own lines are written, and those of no later one
            assert_eq!(out.last(), Some(&5), "{threads} threads");
        }
    }

    /// Takes some bytes and no more.
    struct Full(usize);

    impl Write for Full {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            match self.0.checked_sub(bytes.len()) {
                Some(left) => self.0 = left,
                None => return Err(io::ErrorKind::StorageFull.into()),
            }
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn an_output_that_fails_stops_all_tiles() {
        for threads in [1, 2, 8] {
            let ended = run(threads, Full(LINES * PIECE / 8), u64::MAX);
            match ended {
                Err(Ended::Output(error)) => {
                    assert_eq!(error.kind(), io::ErrorKind::StorageFull);
                }
                _ => panic!("it must stop, on {threads} threads"),
            }
        }
    }

    /// The lowest tile waits until another one has handed over more than is kept.
    #[test]
    fn what_waits_for_the_lowest_tile_is_bounded() {
        let made = AtomicUsize::new(0);
        let shared: InOrder<_, Order> = InOrder::new(io::sink(), u64::MAX);
        let work = |tile: &mut Tile<'_, _, Order>, (): &mut ()| {
            if tile.number() == 0 {
                while made.load(Ordering::SeqCst) < KEPT {
                    std::thread::yield_now();
                }
                // the other one has no more room, however long it has
                std::thread::sleep(std::time::Duration::from_millis(50));
                assert_eq!(made.load(Ordering::SeqCst), KEPT);
            } else {
                for _ in 0..3 * KEPT {
                    assert!(tile.line(|lines| lines.resize(PIECE, 0)).is_continue());
                    made.fetch_add(1, Ordering::SeqCst);
                }
            }
            Ok(Order::default())
        };
        parallel::with_threads(2, || shared.run(2, || (), work)).unwrap();
        assert_eq!(made.load(Ordering::SeqCst), 3 * KEPT);
    }

    /// What is written makes room for more: once the lowest tile has handed over more than is kept, another is let in.
    #[test]
    fn what_is_written_is_kept_no_longer() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build();
        let (written, let_in) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let wait_for = |number: &AtomicUsize| {
            while number.load(Ordering::SeqCst) == 0 {
                std::thread::yield_now();
            }
        };
        let shared: InOrder<_, Order> = InOrder::new(io::sink(), u64::MAX);
        let work = |tile: &mut Tile<'_, _, Order>, (): &mut ()| {
            let piece = |tile: &mut Tile<'_, _, Order>| tile.line(|lines| lines.resize(PIECE, 0));
            if tile.number() == 0 {
                for _ in 0..2 * KEPT {
                    assert!(piece(tile).is_continue());
                }
                written.store(1, Ordering::SeqCst);
                wait_for(&let_in);
            } else {
                wait_for(&written);
                assert!(piece(tile).is_continue());
                let_in.store(1, Ordering::SeqCst);
            }
            Ok(Order::default())
        };
        pool.unwrap()
            .install(|| shared.run(2, || (), work))
            .unwrap();
        assert_eq!(let_in.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn a_tile_that_is_gone_keeps_no_other_waiting() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build();
        let made = AtomicUsize::new(0);
        let mut out = Vec::new();
        let shared: InOrder<_, Order> = InOrder::new(&mut out, u64::MAX);
        let work = |tile: &mut Tile<'_, _, Order>, (): &mut ()| {
            if tile.number() == 0 {
                // without the message of a panic
                std::panic::resume_unwind(Box::new("gone"));
            }
            for _ in 0..2 * KEPT {
                let _ = tile.line(|lines| lines.resize(PIECE, 7));
                made.fetch_add(1, Ordering::SeqCst);
            }
            Ok(Order::default())
        };
        let run = || pool.unwrap().install(|| shared.run(2, || (), work));
        let run = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run));
        assert!(run.is_err());
        assert_eq!(made.load(Ordering::SeqCst), 2 * KEPT);
        assert_eq!(out.len(), 2 * KEPT * PIECE);
    }
}
