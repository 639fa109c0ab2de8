//! What a stepper costs: the index of a log, its first step, each move, and the memory.
//!
//! ```text
//! cargo bench -p bench --bench stepping
//! ```
//!
//! The log is one pixel of the 7 382 balls in NFF, traced against every object: 44 329 events. A move is timed with all that a
//! face shows of the step behind it: the title, the words, what changed. The table has the median and the longest of each kind
//! of move, in milliseconds, beside what a reader does not notice. Below are the keys of the terminal, each with the frame that
//! follows it, without the terminal itself.

use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use raystep::step::{Command, Cursor, Level, Move, StepLog, StepWords, commands, headline};
use raystep::tui::{App, Kept, Look, Titles, draw};
use raystep::{Chosen, Record, Scene, Settings, Tracer, load, record_pixel};

/// The pixel, and how many events it has.
const PIXEL: [u32; 2] = [256, 256];
const EVENTS: usize = 44_329;

/// What a reader does not notice: 300 ms before the first step, 50 ms for a move.
const FIRST: Duration = Duration::from_millis(300);
const EACH: Duration = Duration::from_millis(50);

/// The most memory, in MB.
const MEMORY: f64 = 200.0;

/// How many moves of a kind.
const MOVES: usize = 40;

/// The events of the pixel.
fn traced(scene: &Scene, settings: &Settings) -> Option<Vec<Record>> {
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure).ok()?;
    let tracer = Tracer::new(scene, &strategy, settings.transport);
    record_pixel(&tracer, PIXEL, settings.through, false, 1_000_000).ok()
}

/// The memory of the process in MB, now and at most, where the system tells it.
fn memory() -> Option<[f64; 2]> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let of = |key: &str| -> Option<f64> {
        let line = status.lines().find(|line| line.starts_with(key))?;
        let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
        Some(kilobytes / 1000.0)
    };
    Some([of("VmRSS:")?, of("VmHWM:")?])
}

/// Everything that a face shows of a step.
fn shown(log: &StepLog, words: &StepWords, step: usize) -> usize {
    let mut text = headline(log, step);
    for line in words.of(log, step) {
        text.push_str(&line.text);
    }
    for change in log.changes(step) {
        text.push_str(&change.text(log.scene));
    }
    text.len()
}

fn row(table: &mut String, what: &str, mut times: Vec<Duration>, limit: Duration) {
    times.sort_unstable();
    let (Some(median), Some(longest)) = (times.get(times.len() / 2), times.last()) else {
        return;
    };
    let ms = |time: Duration| time.as_secs_f64() * 1e3;
    let fits = if *longest <= limit { "" } else { "  too long" };
    let _ = writeln!(
        table,
        "{what:34} {:9.3} {:9.3} {:9.0}{fits}",
        ms(*median),
        ms(*longest),
        ms(limit)
    );
}

/// Keys of the terminal: into the search, along its leaves, to targets and ends, and what lies over the screen.
const KEYS: [&str; 24] = [
    "→",
    "↓",
    "→",
    "↓",
    "↓",
    "→",
    "Space",
    "Space",
    "PgDn",
    "n",
    "n",
    "n",
    "w",
    "End",
    "PgUp",
    "Home",
    "↓",
    "v",
    "Esc",
    "?",
    "Esc",
    "5",
    "End",
    "Backspace",
];

/// The first frame of the terminal, and each key with its frame.
fn in_terminal(table: &mut String, log: &StepLog, [width, height]: [u16; 2]) {
    let Some(start) = Cursor::at_start(log) else {
        return;
    };
    // drawing into memory cannot fail
    let Ok(mut terminal) = Terminal::new(TestBackend::new(width, height));
    let started = Instant::now();
    let mut app = App::new(log, start, Kept::new(false), Titles::default());
    let mut show = |app: &mut App| {
        app.resize([width, height]);
        let shown = terminal.draw(|frame| draw(app, Look::default(), frame));
        assert!(shown.is_ok());
    };
    show(&mut app);
    let what = format!("terminal {width} × {height}");
    row(
        table,
        &format!("{what}, first frame"),
        vec![started.elapsed()],
        FIRST,
    );
    let mut times = Vec::new();
    for key in KEYS {
        let started = Instant::now();
        let _ = app.press(key);
        show(&mut app);
        times.push(started.elapsed());
    }
    row(table, &format!("{what}, keys"), times, EACH);
}

fn main() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/nff/full/balls.nff");
    let scene = load(&file).and_then(raystep::scene::Loaded::build);
    let scene = scene.unwrap_or_else(|error| panic!("{error}"));
    let settings = Settings::default();
    let Some(records) = traced(&scene, &settings) else {
        panic!("the pixel cannot be traced");
    };
    assert_eq!(records.len(), EVENTS);
    let before = memory();

    let started = Instant::now();
    let log = StepLog::new(&scene, &settings, &records);
    let index = started.elapsed();
    let words = StepWords::new(&log);
    let Some(start) = Cursor::at_start(&log) else {
        return;
    };
    let mut length = shown(&log, &words, start.here);
    let first = started.elapsed();

    let mut table = String::new();
    row(&mut table, "index", vec![index], FIRST);
    row(&mut table, "index and first step", vec![first], FIRST);
    let mut timed = |what: &str, from: Cursor, step: &dyn Fn(Cursor) -> Option<Cursor>| {
        let mut here = from;
        let mut times = Vec::new();
        while times.len() < MOVES {
            let started = Instant::now();
            let Some(next) = step(here) else {
                break;
            };
            length += shown(&log, &words, next.here);
            times.push(started.elapsed());
            here = next;
        }
        row(&mut table, what, times, EACH);
    };
    let middle = Cursor::at(&log, log.leaf(records.len() / 2));
    let last = Cursor::at(&log, log.leaf(records.len() - 1));
    let tests = middle.at_level(&log, Level::Test);
    timed("over, tests", tests, &|here| here.moved(&log, Move::Over));
    timed("back, tests", tests, &|here| here.moved(&log, Move::Back));
    timed("next leaf", middle, &|here| {
        here.moved(&log, Move::NextLeaf)
    });
    timed("previous leaf", middle, &|here| {
        here.moved(&log, Move::PreviousLeaf)
    });
    timed("previous leaf, from the end", last, &|here| {
        here.moved(&log, Move::PreviousLeaf)
    });
    timed("out, to the pixel", middle, &|here| {
        here.moved(&log, Move::Out)
    });
    timed("into, from the pixel", start, &|here| {
        here.moved(&log, Move::Into)
    });
    let targets = log.targets();
    timed("next target", start, &|here| here.next_of(&log, &targets));
    timed("previous target", last, &|here| {
        here.previous_of(&log, &targets)
    });
    timed("who set this", last, &|here| {
        let setter = log.who_set(here.here, None)?;
        Some(Cursor::at(&log, log.landing(setter.event)))
    });
    for text in [
        "/rejected",
        "/kind=ray outcome=blocked",
        "/object=sphere-77",
        "/sphere-7",
    ] {
        let mut found = 0;
        let mut times = Vec::new();
        for _ in 0..3 {
            let started = Instant::now();
            if let Ok([Command::Filter(Some(filter))]) = commands(text).as_deref() {
                found = filter.targets(&log).len();
            }
            times.push(started.elapsed());
        }
        row(&mut table, &format!("{text} ({found} found)"), times, EACH);
    }

    in_terminal(&mut table, &log, [80, 24]);
    in_terminal(&mut table, &log, [200, 60]);

    println!(
        "pixel {PIXEL:?}: {} events, {} steps, {length} bytes shown\n",
        records.len(),
        log.steps().len()
    );
    println!(
        "{:34} {:>9} {:>9} {:>9}",
        "ms", "median", "longest", "at most"
    );
    print!("{table}");
    if let (Some([before, _]), Some([now, most])) = (before, memory()) {
        println!(
            "\nmemory: {before:.0} MB before with the scene and its records, {now:.0} MB after, {most:.0} MB at most, of {MEMORY:.0} MB"
        );
    }
}
