//! The log of a picture or a part of it, streamed while it is traced.

use std::io::{self, Write};
use std::ops::{AddAssign, ControlFlow, Range};
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::strategy::Strategy;
use crate::trace::{
    EventWriter, Filter, Kinds, LogNames, Record, Recorder, Recording, Region, Settings, Sink,
    write_log_head,
};
use crate::tracer::eye::pixel::trace_pixel;
use crate::tracer::in_order::{Ended, InOrder, Tile};
use crate::tracer::light::all_paths::PIECE as PATHS;
use crate::tracer::stopped::Stopped;
use crate::tracer::tracer::Tracer;

/// What of the trace is written.
#[derive(Clone, Debug)]
pub struct LogOptions {
    /// The pixels that the log is about.
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
    /// The number of the first ones, which are all written.
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
    /// A pixel takes more rays than it may, or what else hears of the trace has enough.
    Trace(Stopped),
}

/// A part of a log: parts are traced by whichever thread is free, and written in their order.
enum Part {
    /// How the structure was built.
    Building,
    /// The paths of light at these places in the order.
    Paths(Range<usize>),
    /// A pixel.
    Pixel([u32; 2]),
}

/// Which parts a log has.
struct Parts {
    /// How the structure was built is the first part, if it is wanted.
    building: bool,
    /// How many paths of light there are.
    paths: usize,
    region: Region,
}

impl Parts {
    /// How many parts come before the pixels: the building, and the paths of light in pieces.
    fn before_pixels(&self) -> usize {
        usize::from(self.building) + self.paths.div_ceil(PATHS as usize)
    }

    /// How many pixels a scan line has.
    fn width(&self) -> usize {
        (self.region.to[0] - self.region.from[0] + 1) as usize
    }

    fn len(&self) -> usize {
        let rows = (self.region.to[1] - self.region.from[1] + 1) as usize;
        self.before_pixels() + self.width() * rows
    }

    /// The part of this number.
    fn get(&self, number: usize) -> Part {
        if let Some(pixel) = number.checked_sub(self.before_pixels()) {
            let [left, top] = self.region.from;
            let [column, row] = [pixel % self.width(), pixel / self.width()];
            return Part::Pixel([left + column as u32, top + row as u32]);
        }
        match number.checked_sub(usize::from(self.building)) {
            None => Part::Building,
            Some(piece) => {
                let first = piece * PATHS as usize;
                Part::Paths(first..(first + PATHS as usize).min(self.paths))
            }
        }
    }
}

/// Writes the log of a region: the head, how the structure was built if that is wanted, the paths of light,
/// then every pixel's events, scan line by scan line.
///
/// Pieces of the paths and the pixels are traced on the threads of the current pool and written in order: the same
/// bytes on any number of threads, in memory that does not grow with the picture. `done` hears how many
/// scan lines' worth of pixels is finished. A pixel's eye rays are its own here, also through the corners, so that
/// each pixel of the log stands alone.
///
/// What else shall hear of the rays (`Counts`, or `Off`) is given back, summed up in the same order.
///
/// # Errors
/// A failing output, more events than the budget, or a pixel that takes more rays than the tracer allows.
pub fn write_log<S: Strategy, R: Recorder + Default + AddAssign + Send>(
    tracer: &Tracer<'_, S>,
    settings: &Settings,
    options: &LogOptions,
    mut out: impl Write + Send,
    done: impl Fn(usize) + Sync,
) -> Result<R, LogStopped> {
    write_log_head(tracer.scene, settings, &mut out).map_err(LogStopped::Output)?;
    let names = LogNames::new(tracer.scene);
    let parts = Parts {
        building: settings.building,
        paths: options.paths.len(),
        region: options.region,
    };
    let finished = AtomicUsize::new(0);
    let trace = |tile: &mut Tile<'_, _, R>, writer: &mut EventWriter<'_>| -> Result<R, Stopped> {
        let part = parts.get(tile.number());
        let recording = Recording::new(Filter {
            kinds: options.kinds,
            region: None,
            sink: TileSink { writer, tile },
        });
        let mut both = (recording, R::default());
        match part {
            Part::Building => tracer.strategy.note_building(&mut both.0),
            Part::Paths(places) => {
                for place in places {
                    tracer.trace_path(options.paths.get(place), &mut both)?;
                }
            }
            Part::Pixel(pixel) => {
                trace_pixel(tracer, pixel, settings.through, &mut both)?;
                let finished = finished.fetch_add(1, Ordering::Relaxed) + 1;
                if finished.is_multiple_of(parts.width()) {
                    done(finished / parts.width());
                }
            }
        }
        Ok(both.1)
    };
    let shared = InOrder::new(&mut out, options.budget);
    let heard = shared.run(parts.len(), || EventWriter::new(&names), trace);
    let heard = heard.map_err(|ended| match ended {
        Ended::Output(error) => LogStopped::Output(error),
        Ended::Budget => LogStopped::Budget,
        Ended::Tile(stopped) => LogStopped::Trace(stopped),
    })?;
    out.flush().map_err(LogStopped::Output)?;
    Ok(heard)
}

/// Makes lines of the records of one tile.
struct TileSink<'t, 'a, 'n, W: Write, R: Default + AddAssign> {
    writer: &'t mut EventWriter<'n>,
    tile: &'t mut Tile<'a, W, R>,
}

impl<W: Write + Send, R: Default + AddAssign> Sink for TileSink<'_, '_, '_, W, R> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        let writer = &mut *self.writer;
        self.tile.line(|lines| writer.line(record, lines))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(building: bool, paths: usize) -> Parts {
        let region = Region {
            from: [3, 5],
            to: [6, 9],
        };
        Parts {
            building,
            paths,
            region,
        }
    }

    #[test]
    fn a_log_has_the_building_then_the_paths_in_pieces_then_the_pixels_row_by_row() {
        // 4 × 5 pixels; 2049 paths take three pieces of up to 1024
        let parts = parts(true, 2049);
        assert_eq!(
            (parts.before_pixels(), parts.width(), parts.len()),
            (4, 4, 24)
        );
        assert!(matches!(parts.get(0), Part::Building));
        let pieces = [1, 2, 3].map(|number| match parts.get(number) {
            Part::Paths(places) => places,
            _ => 0..0,
        });
        assert_eq!(pieces, [0..1024, 1024..2048, 2048..2049]);
        let pixels = [4, 7, 8, 11].map(|number| match parts.get(number) {
            Part::Pixel(pixel) => pixel,
            _ => [0, 0],
        });
        assert_eq!(pixels, [[3, 5], [6, 5], [3, 6], [6, 6]]);
    }

    #[test]
    fn without_building_and_paths_the_first_part_is_the_first_pixel() {
        let none = parts(false, 0);
        assert_eq!((none.before_pixels(), none.len()), (0, 20));
        assert!(matches!(none.get(0), Part::Pixel([3, 5])));
        let paths = parts(false, 1024);
        assert_eq!(paths.before_pixels(), 1);
        assert!(matches!(paths.get(0), Part::Paths(places) if places == (0..1024)));
    }

    #[test]
    fn logged_paths_are_the_first_or_those_of_a_list() {
        let numbers = |paths: LoggedPaths| {
            (0..paths.len())
                .map(|place| paths.get(place))
                .collect::<Vec<_>>()
        };
        assert!(numbers(LoggedPaths::None).is_empty());
        assert_eq!(numbers(LoggedPaths::All(3)), [0, 1, 2]);
        assert_eq!(numbers(LoggedPaths::Some(vec![9, 4])), [9, 4]);
    }

    #[test]
    fn a_log_has_a_head_and_a_line_for_each_event_and_says_when_a_scan_line_is_done() {
        use crate::scene::small_scene::scene_of;
        use crate::strategy::Exhaustive;
        use crate::trace::{Counts, Purpose, Transport};
        use std::sync::Mutex;

        // 2 × 2 pixels of an empty scene: pixel, ray, ray_end and pixel_colour
        let scene = scene_of(&[]);
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
        let options = |budget| LogOptions {
            region: Region::whole([2, 2]),
            kinds: Kinds::ALL,
            budget,
            paths: LoggedPaths::None,
        };
        let settings = Settings::default();
        let lines_done = Mutex::new(Vec::new());
        let mut out = Vec::new();
        let done = |lines| lines_done.lock().unwrap().push(lines);
        let counts: Counts = write_log(&tracer, &settings, &options(16), &mut out, done).unwrap();
        assert_eq!(counts.of(Purpose::Eye).traced, 4);
        let mut lines_done = lines_done.into_inner().unwrap();
        lines_done.sort_unstable();
        assert_eq!(lines_done, [1, 2]);
        let text = String::from_utf8(out).unwrap();
        assert_eq!(text.lines().count(), 1 + 16, "{text}");
        let stopped = write_log::<_, Counts>(&tracer, &settings, &options(15), io::sink(), |_| {});
        assert!(matches!(stopped, Err(LogStopped::Budget)));
    }
}
