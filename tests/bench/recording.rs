//! What recording costs for each event: into memory, as JSON Lines into a file, and read back.
//!
//! ```text
//! cargo bench -p bench --bench recording               # all of the table
//! cargo bench -p bench --bench recording -- memory     # the lines whose names hold this word
//! ```
//!
//! The events are those of some pixels of five scenes in NFF: spheres, cones, polygons, their edges,
//! and what follows a hit. They are traced once, beforehand, and replayed through [`Recording`], so that
//! no tracing is measured. What is measured takes turns, round after round, so that a busy machine slows all
//! alike; the table has the medians, and the least. One line is otherwise: pixels of one scene with
//! [`MANY`] events, traced and written by all threads as `raystep trace` does it, head and tracing included.
//! Two others write the same events into a file of the same kind: `serde_json`, from values built beforehand,
//! and the crate `tracing` with its JSON subscriber ([`with_tracing`]).

#[path = "recording/with_tracing.rs"]
mod with_tracing;

use std::fs::File;
use std::hint::black_box;
use std::io::{self, BufRead, BufReader, BufWriter, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use raystep::strategy::Exhaustive;
use raystep::trace::{Kinds, LineSink, LogNames, Region, write_log_head};
use raystep::tracer::{LogOptions, LogStopped, LoggedPaths, trace_pixel, write_log};
use raystep::{Event, LogReader, Off, Record, Recorder, Recording, Scene, Settings, Tracer, load};
use serde_json::Value;

/// The scenes, each as a picture of 512 by 512 pixels, with pixels in which there is much to see.
const SCENES: [&str; 5] = ["balls-2", "gears-1", "mount-3", "teapot-2", "tree-4"];
const SIDE: u32 = 512;
const ROW: u32 = 250;

/// The scene that is traced and written on all threads.
const LARGE: &str = "mount-3";

/// Events of each scene: its pixels are added until there are as many. Together 10 MB of lines.
const EVENTS: usize = 8_000;

/// Events that are replayed into memory: some pixels' worth, which a second-level cache holds together
/// with their records, as it holds what a tracer has just worked out.
const IN_CACHE: usize = 500;

/// How many rounds, of which the median counts.
const ROUNDS: usize = 21;

/// How much is written at once, by each of the three: with less, calls of the system add up.
const PIECE: usize = 1 << 18;

/// What one scene adds to the mix.
pub struct Part {
    scene: Scene,
    names: LogNames,
    events: Vec<Event>,
    records: Vec<Record>,
    /// Its log, read back whole.
    log: Vec<u8>,
    /// The lines of its events as values of `serde_json`.
    values: Vec<Value>,
}

impl Part {
    fn of(name: &str) -> Self {
        let scene = scene(name);
        let names = LogNames::new(&scene);
        let settings = Settings::default();
        let lines = Recording::new(LineSink::new(&names));
        let mut both = (Recording::new(Vec::new()), lines);
        trace_pixels(&scene, &mut both, |both| EVENTS <= both.0.sink().len());
        let records: Vec<Record> = both.0.into_sink();
        let lines = both.1.into_sink().lines;
        let values = lines.split_inclusive(|&byte| byte == b'\n');
        let values = values.map(|line| serde_json::from_slice(line).expect("a line is JSON"));
        let values = values.collect();
        let mut log = Vec::new();
        write_log_head(&scene, &settings, &mut log).expect("a list takes all");
        log.extend_from_slice(&lines);
        Self {
            names: LogNames::new(&scene),
            events: records.iter().map(|record| record.event).collect(),
            records,
            log,
            values,
            scene,
        }
    }
}

fn scene(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/nff");
    let mut loaded = load(&folder.join(name).with_extension("nff")).expect(PRESENT);
    loaded.scene.camera.pixels = [SIDE, SIDE];
    loaded.build().expect(PRESENT)
}

/// Traces pixels of a row until there are enough events, and says which.
fn trace_pixels<R: Recorder>(
    scene: &Scene,
    recorder: &mut R,
    enough: impl Fn(&R) -> bool,
) -> Region {
    let settings = Settings::default();
    let strategy = Exhaustive::new(scene);
    let tracer = Tracer::new(scene, &strategy, settings.transport);
    let mut region = Region::pixel([SIDE / 2, ROW]);
    while !enough(recorder) {
        trace_pixel(&tracer, region.to, settings.through, recorder).unwrap();
        region.to[0] += 1;
    }
    region.to[0] -= 1;
    region
}

/// A log as `raystep trace` makes it: traced and written on all threads.
struct Whole {
    scene: Scene,
    region: Region,
    events: usize,
}

/// How many events it has: the lines of its objects are few beside them, and pixels enough for all threads.
const MANY: u64 = 1_000_000;

impl Whole {
    fn of(name: &str) -> Self {
        let scene = scene(name);
        let names = LogNames::new(&scene);
        let mut lines = Recording::new(LineSink::new(&names));
        let region = trace_pixels(&scene, &mut lines, |lines| MANY <= lines.sink().count);
        let events = lines.into_sink().count as usize;
        Self {
            scene,
            region,
            events,
        }
    }

    fn write(&self, out: &mut File) -> io::Result<()> {
        let settings = Settings::default();
        let strategy = Exhaustive::new(&self.scene);
        let tracer = Tracer::new(&self.scene, &strategy, settings.transport);
        let options = LogOptions {
            region: self.region,
            kinds: Kinds::ALL,
            budget: u64::MAX,
            paths: LoggedPaths::None,
        };
        match write_log(&tracer, &settings, &options, out, |_| {}) {
            Ok(Off) => Ok(()),
            Err(LogStopped::Output(error)) => Err(error),
            Err(stopped) => unreachable!("there is no limit: {stopped:?}"),
        }
    }
}

/// Makes ready what it needs, does its work, and says how long the work alone took.
type Measured<'a> = Box<dyn FnMut() -> Duration + 'a>;

const PRESENT: &str = "the scene is part of the project";

fn main() -> io::Result<()> {
    let parts: Vec<Part> = SCENES.into_iter().map(Part::of).collect();
    let events: usize = parts.iter().map(|part| part.events.len()).sum();
    let bytes: usize = parts.iter().map(|part| part.log.len()).sum();

    let few = few_of_each(&parts);
    let mut kept = Kept::default();
    let sinks = parts.iter().map(|part| LineSink::new(&part.names));
    let mut recordings: Vec<_> = sinks.map(Recording::new).collect();
    let mut unwritten = recordings.clone();
    let whole = Whole::of(LARGE);
    let tracing = with_tracing::Subscribed::new()?;
    let mut measured: Vec<(&str, Measured<'_>)> = vec![
        (
            "JSON Lines into a file",
            Box::new(|| into_new_file(|file| into_lines(&parts, &mut recordings, file))),
        ),
        (
            "JSON Lines, not written",
            Box::new(|| {
                timed(|| into_lines(&parts, &mut unwritten, &mut io::sink()).expect(WRITES))
            }),
        ),
        (
            "traced and written by all threads",
            Box::new(|| {
                let all = into_new_file(|file| whole.write(file));
                all.mul_f64(events as f64 / whole.events as f64)
            }),
        ),
        (
            "serde_json's values into a file",
            Box::new(|| into_new_file(|file| values_into(&parts, file))),
        ),
        (
            "tracing's JSON into a file",
            Box::new(|| {
                tracing.empty().expect(WRITES);
                timed(|| tracing.write(&parts).expect(WRITES))
            }),
        ),
        ("read back", Box::new(|| timed(|| read_back(&parts)))),
        (
            "into memory that is used again",
            Box::new(|| timed(|| into_memory(&few, events, &mut kept))),
        ),
        (
            "into fresh memory",
            Box::new(|| timed(|| into_fresh_memory(&parts))),
        ),
    ];
    // words after `--` choose
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    measured.retain(|(name, _)| {
        let mut words = chosen.iter().filter(|word| *word != "--bench").peekable();
        words.peek().is_none() || words.any(|word| name.contains(word.as_str()))
    });

    let mut times = vec![Vec::new(); measured.len()];
    for _ in 0..ROUNDS {
        for ((_, work), times) in measured.iter_mut().zip(&mut times) {
            times.push(work().as_nanos() as f64 / events as f64);
        }
    }
    println!("{events} events, {} bytes a line", bytes / events);
    println!(
        "{:<34}{:>12}{:>10}{:>10}",
        "", "ns an event", "least", "ratio"
    );
    let [medians, least] = [ROUNDS / 2, 0].map(|place| -> Vec<f64> {
        let sorted = |times: &Vec<f64>| {
            let mut sorted = times.clone();
            sorted.sort_by(f64::total_cmp);
            sorted
        };
        times.iter().map(|times| sorted(times)[place]).collect()
    });
    for (((name, _), time), least) in measured.iter().zip(&medians).zip(least) {
        println!(
            "{name:<34}{time:>12.1}{least:>10.1}{:>10.2}",
            time / medians[0]
        );
    }
    Ok(())
}

const WRITES: &str = "a file for a while can be written";

fn timed(work: impl FnOnce()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}

/// How long it takes to fill a new file.
fn into_new_file(work: impl FnOnce(&mut File) -> io::Result<()>) -> Duration {
    let mut file = tempfile::tempfile().expect(WRITES);
    timed(|| work(&mut file).expect(WRITES))
}

/// The first events of each scene, as many as a cache holds.
fn few_of_each(parts: &[Part]) -> Vec<Event> {
    let each = IN_CACHE / parts.len();
    let some = parts.iter().flat_map(|part| &part.events[..each]);
    some.copied().collect()
}

/// Keeps events in a list that is emptied and filled again.
#[derive(Default)]
struct Kept(Vec<Event>);

impl Recorder for Kept {
    const ENABLED: bool = true;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        self.0.push(event());
    }
}

/// The same few events again and again into the same list, which is emptied each time.
fn into_memory(few: &[Event], events: usize, kept: &mut Kept) {
    for _ in 0..events / few.len() {
        kept.0.clear();
        for event in few {
            kept.note(|| *event);
        }
        black_box(&*kept);
    }
}

/// All events into a list that grows.
fn into_fresh_memory(parts: &[Part]) {
    let mut kept = Recording::new(Vec::new());
    for event in parts.iter().flat_map(|part| &part.events) {
        kept.note(|| *event);
    }
    black_box(kept.sink());
}

/// The lines, a piece at a time.
fn into_lines(
    parts: &[Part],
    recordings: &mut [Recording<LineSink<'_>>],
    out: &mut impl Write,
) -> io::Result<()> {
    for (part, recording) in parts.iter().zip(recordings) {
        for event in &part.events {
            recording.note(|| *event);
            if PIECE <= recording.sink().lines.len() {
                write_out(recording, out)?;
            }
        }
        write_out(recording, out)?;
    }
    Ok(())
}

fn write_out(recording: &mut Recording<LineSink<'_>>, out: &mut impl Write) -> io::Result<()> {
    let lines = &mut recording.sink_mut().lines;
    out.write_all(lines)?;
    lines.clear();
    Ok(())
}

fn values_into(parts: &[Part], file: &mut File) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(PIECE, file);
    for value in parts.iter().flat_map(|part| &part.values) {
        serde_json::to_writer(&mut out, value)?;
        out.write_all(b"\n")?;
    }
    out.flush()
}

/// Every line of the logs, from memory: what a disk takes is not ours.
fn read_back(parts: &[Part]) {
    for part in parts {
        let input = BufReader::new(part.log.as_slice());
        let mut reader = opened(input);
        while let Some(record) = reader.next_record().expect("the log is good") {
            black_box(record);
        }
    }
}

fn opened(input: impl BufRead) -> LogReader<impl BufRead> {
    LogReader::open("log", input).expect("the log is good")
}
