//! The log of a picture or a part of it, streamed while it is traced.

use std::io::{self, Write};
use std::ops::AddAssign;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::strategy::Strategy;
use crate::trace::{
    EventWriter, Filter, Kinds, LogNames, Record, Recorder, Recording, Region, Settings, Sink,
    write_log_head,
};
use crate::tracer::in_order::{InOrder, Stopped, Tile};
use crate::tracer::light_pass::PIECE as PATHS;
use crate::tracer::{Tracer, trace_pixel};

/// What of the trace is written.
#[derive(Clone, Debug)]
pub struct LogOptions {
    /// The pixels.
    pub region: Region,
    /// The kinds of event.
    pub kinds: Kinds,
    /// How many events at most.
    pub budget: u64,
    /// The paths of light, where the transport follows any.
    pub paths: LoggedPaths,
}

/// Which paths of light are written, before the pixels.
#[derive(Clone, Debug, Default)]
pub enum LoggedPaths {
    /// None.
    #[default]
    None,
    /// The first so many: all.
    All(u64),
    /// These.
    Some(Vec<u32>),
}

impl LoggedPaths {
    fn len(&self) -> usize {
        match self {
            Self::None => 0,
            Self::All(count) => *count as usize,
            Self::Some(paths) => paths.len(),
        }
    }

    /// The number of the path at a place in the order.
    fn get(&self, place: usize) -> u32 {
        match self {
            Self::None | Self::All(_) => place as u32,
            Self::Some(paths) => paths[place],
        }
    }
}

/// Why a log was not written to its end.
#[derive(Debug)]
pub enum LogStopped {
    /// The output failed.
    Output(io::Error),
    /// There are more events than the budget allows.
    Budget,
}

/// Writes the log of a region: the head, how the structure was built if that is wanted, the paths of light,
/// then every pixel's events, scan line by scan line.
///
/// Pieces of the paths and the pixels are traced on the threads of the current pool and written in order: the same
/// bytes on any number of threads, in memory that does not grow with the picture. `done` hears how many
/// scan lines' worth of pixels is finished. A pixel's eye rays are its own here, also through the corners, so that
/// each pixel of the log stands alone.
///
/// What else shall hear of the trace (`Counts`, or `Off`) is given back, summed up in the same order.
///
/// # Errors
/// A failing output, or more events than the budget.
pub fn write_log<S: Strategy, R: Recorder + Default + AddAssign + Send>(
    tracer: &Tracer<'_, S>,
    settings: &Settings,
    options: &LogOptions,
    mut out: impl Write + Send,
    done: impl Fn(usize) + Sync,
) -> Result<R, LogStopped> {
    write_log_head(tracer.scene, settings, &mut out).map_err(LogStopped::Output)?;
    let names = LogNames::new(tracer.scene);
    let mut budget = options.budget;
    if settings.building {
        let mut building = Recording::new(Filter {
            kinds: options.kinds,
            region: None,
            sink: Building {
                writer: EventWriter::new(&names),
                lines: Vec::new(),
                out: &mut out,
                budget: &mut budget,
                stopped: None,
            },
        });
        tracer.strategy.note_building(&mut building);
        building.into_sink().sink.finish()?;
    }
    let ([left, top], [right, bottom]) = (options.region.from, options.region.to);
    let width = (right - left + 1) as usize;
    let pixels = width * (bottom - top + 1) as usize;
    let finished = AtomicUsize::new(0);

    // paths of light come before the pixels
    let pieces = options.paths.len().div_ceil(PATHS as usize);
    let trace = |tile: Tile<'_, _, R>, writer: &mut EventWriter<'_>| {
        let number = tile.number();
        let recording = Recording::new(Filter {
            kinds: options.kinds,
            region: None,
            sink: TileSink { writer, tile },
        });
        let mut both = (recording, R::default());
        match number.checked_sub(pieces) {
            None => {
                let first = number * PATHS as usize;
                let last = (first + PATHS as usize).min(options.paths.len());
                for place in first..last {
                    tracer.trace_path(options.paths.get(place), &mut both);
                    if both.0.sink().sink.tile.is_stopped() {
                        break;
                    }
                }
            }
            Some(pixel) => {
                let pixel = [left + (pixel % width) as u32, top + (pixel / width) as u32];
                trace_pixel(tracer, pixel, settings.through, &mut both);
                let finished = finished.fetch_add(1, Ordering::Relaxed) + 1;
                if finished.is_multiple_of(width) {
                    done(finished / width);
                }
            }
        }
        let (recording, heard) = both;
        recording.into_sink().sink.tile.finish(heard);
    };
    let shared = InOrder::new(&mut out, budget);
    let heard = shared.run(pieces + pixels, || EventWriter::new(&names), trace);
    let heard = heard.map_err(|stopped| match stopped {
        Stopped::Output(error) => LogStopped::Output(error),
        Stopped::Budget => LogStopped::Budget,
    })?;
    out.flush().map_err(LogStopped::Output)?;
    Ok(heard)
}

/// Writes how a structure was built, piece by piece.
struct Building<'a, W> {
    writer: EventWriter<'a>,
    lines: Vec<u8>,
    out: W,
    budget: &'a mut u64,
    stopped: Option<LogStopped>,
}

/// How many bytes of it are kept before they are written.
const PIECE: usize = 1 << 16;

impl<W: Write> Building<'_, W> {
    fn write(&mut self) {
        if let Err(error) = self.out.write_all(&self.lines) {
            self.stopped = Some(LogStopped::Output(error));
        }
        self.lines.clear();
    }

    fn finish(mut self) -> Result<(), LogStopped> {
        if self.stopped.is_none() {
            self.write();
        }
        self.stopped.map_or(Ok(()), Err)
    }
}

impl<W: Write> Sink for Building<'_, W> {
    fn record(&mut self, record: &Record) {
        if self.stopped.is_some() {
            return;
        }
        match self.budget.checked_sub(1) {
            None => self.stopped = Some(LogStopped::Budget),
            Some(left) => {
                *self.budget = left;
                self.writer.line(record, &mut self.lines);
                if PIECE <= self.lines.len() {
                    self.write();
                }
            }
        }
    }
}

/// Makes lines of the records of one tile.
struct TileSink<'a, 'n, W: Write, R: Default + AddAssign> {
    writer: &'a mut EventWriter<'n>,
    tile: Tile<'a, W, R>,
}

impl<W: Write + Send, R: Default + AddAssign> Sink for TileSink<'_, '_, W, R> {
    #[inline]
    fn record(&mut self, record: &Record) {
        let writer = &mut *self.writer;
        self.tile.line(|lines| writer.line(record, lines));
    }
}
