//! `raystep trace`: the log of a picture or a part of it; a log is filtered again.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::time::Instant;

use raystep::trace::{
    Budget, Filter, Kind, Kinds, LineSink, LogNames, PathSieve, Region, Sink, write_log_head,
    write_of_pixels,
};
use raystep::tracer::{LogOptions, LogStopped, LoggedPaths, paths_behind_region};
use raystep::{Chosen, ChosenTracer, Counts, Record, Scene, Settings, Tracer, record_log};

use crate::cli::Error;
use crate::cli::args::{Format, TraceArgs};
use crate::cli::input::{self, Input, Log, Ready};
use crate::cli::light::light_pass;
use crate::cli::output::{self, Output};
use crate::cli::progress::{bar, on_threads};
use crate::cli::same_file::Taken;
use crate::cli::stats::{self, LogCounts, Report, Times};
use crate::cli::usual::Usual;

/// How many bytes of a filtered log are kept before they are written.
const BUFFER: usize = 1 << 16;

/// Writes the log.
pub(crate) fn run(args: &TraceArgs) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) && output::is_standard(&args.output) {
        return Err(Error::StandardOutputTwice {
            fix: "name a file with -o, or use --stats, which writes to standard error",
        });
    }
    let started = Instant::now();
    match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => {
            let ready = input::ready(*loaded, &args.tracing, Usual::BySize, started)?;
            trace(ready, args)
        }
        Input::Log(log) => {
            input::refuse_tracing(&args.scene, &args.tracing)?;
            filter_again(*log, args, started)
        }
    }
}

fn trace(mut ready: Ready, args: &TraceArgs) -> Result<(), Error> {
    let settings = &mut ready.settings;
    settings.region = args.region;
    settings.only = (!args.only.is_empty()).then(|| names(&args.only));
    let options = LogOptions {
        region: region(args.region, &ready.scene)?,
        kinds: match settings.only {
            Some(_) => Kinds::of(&args.only),
            None => Kinds::ALL,
        },
        budget: args.budget,
        paths: LoggedPaths::None,
    };
    let out = Output::create(&args.output, &Taken::by_reading(&args.scene, &ready.files))?;
    let started = Instant::now();
    let strategy = ready.strategy()?;
    let times = Times {
        loading: ready.loading,
        building: started.elapsed(),
        ..Times::default()
    };
    trace_with(&strategy, &ready, args, options, out, times)
}

fn trace_with(
    strategy: &Chosen<'_>,
    ready: &Ready,
    args: &TraceArgs,
    mut options: LogOptions,
    mut out: Output,
    mut times: Times,
) -> Result<(), Error> {
    let started = Instant::now();
    let region = args.region;
    let light = light_pass(&args.scene, ready, strategy, region, args.threads, None)?;
    let tracer = Tracer::new(&ready.scene, strategy, ready.settings.transport);
    let tracer = tracer
        .with_light(light.as_ref())
        .with_max_rays(ready.max_rays);
    options.paths = match region {
        None => LoggedPaths::All(ready.settings.light_paths(ready.scene.camera.pixels)),
        Some(region) => {
            let paths = paths_behind_region(&tracer, region, ready.settings.through)
                .map_err(|stopped| ready.stopped(stopped))?;
            LoggedPaths::Some(paths.into_iter().collect())
        }
    };
    let mut counts = args.tracing.stats.map(|_| Counts::default());
    write(&tracer, ready, args, &options, &mut out, counts.as_mut())?;
    times.tracing = started.elapsed();
    out.finish()?;
    match (args.tracing.stats, counts) {
        (Some(format), Some(counts)) => {
            stats::tell(format, &ready.report(strategy, &counts, times))
        }
        _ => Ok(()),
    }
}

/// Writes the log.
fn write(
    tracer: &ChosenTracer<'_, '_>,
    ready: &Ready,
    args: &TraceArgs,
    options: &LogOptions,
    out: &mut Output,
    counts: Option<&mut Counts>,
) -> Result<(), Error> {
    let bar = bar(u64::from(options.region.to[1] - options.region.from[1]) + 1);
    let done = |lines: usize| bar.set_position(lines as u64);
    let written = on_threads(args.threads, || {
        record_log(tracer, &ready.settings, options, &mut *out, counts, &done)
    });
    bar.finish_and_clear();
    written?.map_err(|stopped| match stopped {
        LogStopped::Output(error) => out.failed(error),
        LogStopped::Budget => Error::Budget {
            budget: args.budget,
        },
        LogStopped::Trace(stopped) => ready.stopped(stopped),
    })
}

/// What of a log is written again, and counted.
struct Wanted<'a> {
    filter: Filter<Budget<WrittenLines<'a>>>,
    counts: Option<LogCounts>,
}

impl Sink for Wanted<'_> {
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        self.filter.record(record)?;
        let inside = self.filter.region.zip(record.pixel);
        if let Some(counts) = &mut self.counts
            && inside.is_none_or(|(region, pixel)| region.contains(pixel))
        {
            counts.add(record);
        }
        ControlFlow::Continue(())
    }
}

/// Writes lines to an output, many at once, until it fails.
struct WrittenLines<'a> {
    kept: LineSink<'a>,
    out: &'a mut Output,
    failed: Option<io::Error>,
}

impl WrittenLines<'_> {
    /// Writes the lines that are kept.
    fn write(&mut self) -> ControlFlow<()> {
        let written = self.out.write_all(&self.kept.lines);
        self.kept.lines.clear();
        self.failed = written.err();
        match self.failed {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        }
    }
}

impl Sink for WrittenLines<'_> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        self.kept.record(record)?;
        if BUFFER <= self.kept.lines.len() {
            self.write()?;
        }
        ControlFlow::Continue(())
    }
}

/// Reads a log and writes what is wanted of it, line by line.
///
/// With a region, a path of light is omitted if its own events and its number show that it led elsewhere; of light
/// that was stored nothing is known before the pixels are read, and all paths stay.
fn filter_again(mut log: Log, args: &TraceArgs, started: Instant) -> Result<(), Error> {
    let file = input::name_of(&args.scene);
    let missing = |what: String| Error::NotInLog {
        file: file.clone(),
        what,
        fix: "choose among them, or trace the scene again",
    };
    let mut settings: Settings = log.settings().clone();
    if let Some(wanted) = args.region {
        region(args.region, log.scene())?;
        let kept = settings.region.unwrap_or(wanted);
        settings.region = Some(overlap(wanted, kept).ok_or_else(|| {
            missing(format!(
                "this log has only the pixels {kept}, none of them in {wanted}"
            ))
        })?);
    }
    let mut kinds: Vec<Kind> = args.only.clone();
    if kinds.is_empty() {
        kinds = Kind::ALL.into();
    }
    if let Some(kept) = &settings.only {
        kinds.retain(|kind| kept.iter().any(|name| name == kind.name()));
        if kinds.is_empty() {
            return Err(missing(format!("this log has only {}", kept.join(", "))));
        }
    }
    if settings.only.is_some() || !args.only.is_empty() {
        settings.only = Some(names(&kinds));
    }
    let counts = match args.tracing.stats {
        Some(_) => Some(LogCounts::new(&file, log.settings())?),
        None => None,
    };

    // a log may take its own place: it is read to its end first
    let mut out = Output::create(&args.output, &Taken::nothing())?;
    let written = write_log_head(log.scene(), &settings, &mut out)
        .and_then(|()| write_of_pixels(log.of_pixels(), &mut out));
    written.map_err(|error| out.failed(error))?;
    let names = LogNames::new(log.scene());
    let wanted = Wanted {
        filter: Filter {
            kinds: Kinds::of(&kinds),
            region: settings.region,
            sink: Budget {
                left: args.budget,
                sink: WrittenLines {
                    kept: LineSink::new(&names),
                    out: &mut out,
                    failed: None,
                },
            },
        },
        counts,
    };
    let width = log.scene().camera.pixels[0];
    let mut sieve = PathSieve::new(log.settings(), width, args.region, wanted);
    let written = filtered(&mut log, &mut sieve)?;
    let Wanted { filter, counts } = sieve.sink;
    match (written, filter.sink.sink.failed) {
        (_, Some(error)) => return Err(out.failed(error)),
        (ControlFlow::Break(()), None) => {
            return Err(Error::Budget {
                budget: args.budget,
            });
        }
        (ControlFlow::Continue(()), None) => out.finish()?,
    }

    if let (Some(format), Some(counts)) = (args.tracing.stats, counts) {
        let times = Times {
            loading: started.elapsed(),
            ..Times::default()
        };
        let report = Report {
            scene: log.scene(),
            settings: log.settings(),
            is_usual: false,
            crowded: None,
            counts: counts.counts(),
            times,
        };
        stats::tell(format, &report)?;
    }
    Ok(())
}

/// Reads a log into a sieve, until what is behind it wants no more.
fn filtered(log: &mut Log, sieve: &mut PathSieve<Wanted<'_>>) -> Result<ControlFlow<()>, Error> {
    while let Some(record) = log.next_record()? {
        if sieve.record(&record).is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    if sieve.finish().is_break() {
        return Ok(ControlFlow::Break(()));
    }
    Ok(sieve.sink.filter.sink.sink.write())
}

/// The region, or the whole picture.
fn region(region: Option<Region>, scene: &Scene) -> Result<Region, Error> {
    let pixels = scene.camera.pixels;
    let whole = Region::whole(pixels);
    match region {
        None => Ok(whole),
        Some(region) if whole.contains(region.from) && whole.contains(region.to) => Ok(region),
        Some(region) => Err(Error::RegionOutside { region, pixels }),
    }
}

/// The pixels that lie in both regions.
fn overlap(a: Region, b: Region) -> Option<Region> {
    let from = [0, 1].map(|i| a.from[i].max(b.from[i]));
    let to = [0, 1].map(|i| a.to[i].min(b.to[i]));
    (from[0] <= to[0] && from[1] <= to[1]).then_some(Region { from, to })
}

/// The names of kinds and of those that they need, each once and always in the same order.
fn names(kinds: &[Kind]) -> Vec<String> {
    let kept = Kinds::of(kinds);
    let wanted = Kind::ALL.into_iter().filter(|kind| kept.contains(*kind));
    wanted.map(|kind| kind.name().into()).collect()
}
