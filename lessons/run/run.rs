//! Checks exercises, each in a process of its own, and prints what came out.

use std::env;
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, ExitStatus, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use raystep::lesson::exercise::{
    About, Attempt, CaseSaid, Commands, Outcome, Report, See, exercises, junit, message,
};

use crate::hand_in::{HAS_OTHERS, SECRET};
use crate::limits::MEMORY;
use crate::{child, files};

/// The variable that says which exercise a process checks.
const EXERCISE: &str = "LESSONS_EXERCISE";
/// The variable that says how many seconds of CPU time it may take.
const SECONDS: &str = "LESSONS_SECONDS";
/// A right function takes far less than one.
const USUAL_SECONDS: u64 = 10;
/// A process that waits takes no CPU time: it ends when this many times its limit have passed.
const WAITS: u32 = 3;
/// More bytes of output than this are a flood.
const FLOOD: usize = 8 << 20;
/// What is kept of your own output, in bytes.
const SHOWN: usize = 4000;
/// And how many lines of it are shown, up to which column.
const LINES: usize = 20;
const COLUMNS: usize = 120;

/// What a check of one exercise writes.
#[derive(Debug)]
pub struct Files {
    /// The result.
    pub report: PathBuf,
    /// The picture with both answers.
    pub picture: PathBuf,
    /// Where the check is.
    pub progress: PathBuf,
}

impl Files {
    /// In a folder.
    pub fn of(id: &str, folder: &Path) -> Self {
        let file = |extension: &str| folder.join(format!("{id}.{extension}"));
        Self {
            report: file("json"),
            picture: file("svg"),
            progress: file("progress"),
        }
    }
}

/// How results are printed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Text,
    Json,
    Junit,
}

/// What the command line asks for.
struct Asked {
    words: Vec<String>,
    exact: bool,
    list: bool,
    seconds: u64,
    format: Format,
}

impl Asked {
    /// What other test programs understand and this one does not need is passed over.
    fn of(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut asked = Self {
            words: Vec::new(),
            exact: false,
            list: false,
            seconds: USUAL_SECONDS,
            format: Format::Text,
        };
        while let Some(word) = words.next() {
            let (flag, mut value) = match word.split_once('=') {
                Some((flag, value)) => (flag.to_owned(), Some(value.to_owned())),
                None => (word, None),
            };
            match flag.as_str() {
                "--exact" => asked.exact = true,
                "--list" => asked.list = true,
                "--limit" => {
                    let value = value.take().or_else(|| words.next()).unwrap_or_default();
                    let seconds = value
                        .parse()
                        .ok()
                        .filter(|seconds| (1..=3600).contains(seconds));
                    asked.seconds =
                        seconds.ok_or("--limit takes seconds of CPU time, from 1 to 3600")?;
                }
                "--format" => {
                    let value = value.take().or_else(|| words.next()).unwrap_or_default();
                    asked.format = match value.as_str() {
                        "json" => Format::Json,
                        "junit" => Format::Junit,
                        _ => Format::Text,
                    };
                }
                "--test-threads" | "--color" | "--skip" | "-Z" => {
                    value.take().or_else(|| words.next());
                }
                flag if flag.starts_with('-') => {}
                word => asked.words.push(word.to_owned()),
            }
        }
        Ok(asked)
    }

    fn wants(&self, id: &str) -> bool {
        let is = |word: &String| {
            if self.exact {
                id == word
            } else {
                id.contains(word.as_str())
            }
        };
        self.words.is_empty() || self.words.iter().any(is)
    }
}

/// All functions that are checked.
pub type Attempts = fn() -> Vec<Box<dyn Attempt>>;

/// The program `check`.
pub fn main(words: impl Iterator<Item = String>, attempts: Attempts) -> ExitCode {
    if be_child(attempts) {
        return ExitCode::SUCCESS;
    }
    let asked = match Asked::of(words) {
        Ok(asked) => asked,
        Err(what) => {
            eprintln!("error: {what}");
            return ExitCode::from(2);
        }
    };
    let ids: Vec<String> = attempts()
        .iter()
        .map(|attempt| attempt.about().id())
        .collect();
    let wanted: Vec<String> = ids.into_iter().filter(|id| asked.wants(id)).collect();
    if asked.list {
        wanted.iter().for_each(|id| say(&format!("{id}: test")));
        return ExitCode::SUCCESS;
    }
    if wanted.is_empty() {
        eprintln!(
            "error: no exercise is called {:?}\n  see all: cargo test -p lessons -- --list",
            asked.words.join(" ")
        );
        return ExitCode::from(2);
    }
    let print = |report: &Report| {
        if asked.format == Format::Text {
            say("");
            report.message().for_each(say);
        }
    };
    let reports = check(&wanted, asked.seconds, print);
    let of_state = |state: &str| {
        reports
            .iter()
            .filter(|report| report.state() == state)
            .count()
    };
    let right = of_state("right");
    match asked.format {
        Format::Text => {
            let [not, broken, wrong] = ["not written", "broken", "wrong"].map(of_state);
            say(&format!(
                "\n● {right} right, ◐ {wrong} wrong, ◐ {broken} broken, ○ {not} not written"
            ));
            if let Some(note) = hand_in_note() {
                say(note);
            }
        }
        Format::Json => {
            let all: Vec<String> = reports.iter().map(Report::to_string).collect();
            say(&format!("[{}]", all.join(",\n")));
        }
        Format::Junit => say(junit(&reports).trim_end()),
    }
    if right == reports.len() {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(101)
    }
}

/// Which cases these are, if there are others.
fn hand_in_note() -> Option<&'static str> {
    match (SECRET, HAS_OTHERS) {
        (Some(_), _) => {
            Some("These are the cases of the hand-in: they are made from the secret alone.")
        }
        (None, true) => {
            Some("What you hand in is checked with other cases too, which are not in this folder.")
        }
        (None, false) => None,
    }
}

/// Whoever reads no further does not want to hear that the pipe is closed.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// Checks an exercise in this process, if it was started for that.
pub fn be_child(attempts: Attempts) -> bool {
    let Ok(id) = env::var(EXERCISE) else {
        return false;
    };
    let seconds = env::var(SECONDS)
        .ok()
        .and_then(|seconds| seconds.parse().ok());
    child::check(
        attempts,
        &id,
        seconds.unwrap_or(USUAL_SECONDS),
        &files::written(),
    );
    true
}

/// Checks exercises on all cores; hears of each result in their order.
pub fn check(ids: &[String], seconds: u64, mut done: impl FnMut(&Report)) -> Vec<Report> {
    let folder = files::written();
    if let Err(error) = fs::create_dir_all(&folder) {
        eprintln!("error: cannot create {}: {error}", folder.display());
    }
    let threads = thread::available_parallelism()
        .map_or(1, usize::from)
        .min(ids.len());
    let next = AtomicUsize::new(0);
    let results: Vec<Mutex<Option<Report>>> = ids.iter().map(|_| Mutex::new(None)).collect();
    let mut reports = Vec::new();
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(id) = ids.get(place) else {
                        return;
                    };
                    let report = check_one(id, seconds, &folder);
                    *results[place]
                        .lock()
                        .unwrap_or_else(PoisonError::into_inner) = Some(report);
                }
            });
        }
        for result in &results {
            let report = loop {
                let taken = result.lock().unwrap_or_else(PoisonError::into_inner).take();
                match taken {
                    Some(report) => break report,
                    None => thread::sleep(Duration::from_millis(5)),
                }
            };
            done(&report);
            reports.push(report);
        }
    });
    reports
}

/// What a process prints: the beginning, and how much there is.
#[derive(Default)]
struct Heard {
    beginning: Mutex<Vec<u8>>,
    bytes: AtomicUsize,
}

impl Heard {
    fn listen(self: &Arc<Self>, mut pipe: impl Read + Send + 'static) {
        let heard = Arc::clone(self);
        // it ends with the pipe, at the latest with this program
        thread::spawn(move || {
            let mut buffer = [0; 1 << 16];
            while let Ok(count) = pipe.read(&mut buffer) {
                if count == 0 {
                    break;
                }
                heard.bytes.fetch_add(count, Ordering::Relaxed);
                let mut beginning = heard
                    .beginning
                    .lock()
                    .unwrap_or_else(PoisonError::into_inner);
                let room = SHOWN.saturating_sub(beginning.len());
                beginning.extend(&buffer[..count.min(room)]);
            }
        });
    }

    fn text(&self) -> String {
        let beginning = self
            .beginning
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        String::from_utf8_lossy(&beginning).into_owned()
    }
}

/// Why a process ended.
enum End {
    Itself(ExitStatus),
    Waited,
    Flood,
    NotStarted(String),
}

fn check_one(id: &str, seconds: u64, folder: &Path) -> Report {
    let files = Files::of(id, folder);
    for file in [&files.report, &files.picture, &files.progress] {
        // what is not there needs no removing
        let _ = fs::remove_file(file);
    }
    let [printed, complained] = [Arc::new(Heard::default()), Arc::new(Heard::default())];
    let end = match start(id, seconds, folder) {
        Err(error) => End::NotStarted(error.to_string()),
        Ok(mut process) => {
            if let Some(pipe) = process.stdout.take() {
                printed.listen(pipe);
            }
            if let Some(pipe) = process.stderr.take() {
                complained.listen(pipe);
            }
            wait(&mut process, seconds, [&printed, &complained])
        }
    };
    let report = fs::read_to_string(&files.report)
        .ok()
        .and_then(|text| Report::parse(&text));
    let report = report.unwrap_or_else(|| broken(id, &files, &end, seconds, &complained.text()));
    let _ = fs::write(&files.report, report.to_string());
    let _ = fs::remove_file(&files.progress);
    for heard in [printed, complained] {
        // what a student prints to look for a mistake
        let text = heard.text();
        if !text.is_empty() && report.state() != "right" {
            eprintln!("{id} printed:");
            for line in text.lines().take(LINES) {
                let beginning: String = line.chars().take(COLUMNS).collect();
                eprintln!("  {beginning}");
            }
        }
    }
    report
}

fn start(id: &str, seconds: u64, folder: &Path) -> std::io::Result<Child> {
    Command::new(env::current_exe()?)
        .env(EXERCISE, id)
        .env(SECONDS, seconds.to_string())
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
}

fn wait(process: &mut Child, seconds: u64, heard: [&Arc<Heard>; 2]) -> End {
    let started = Instant::now();
    // without a limit of CPU time the time on the clock is all there is
    let longest = Duration::from_secs(seconds) * if cfg!(unix) { WAITS } else { 1 };
    loop {
        match process.try_wait() {
            Ok(Some(status)) => {
                // what it printed last
                thread::sleep(Duration::from_millis(5));
                return End::Itself(status);
            }
            Ok(None) => {}
            Err(error) => return End::NotStarted(error.to_string()),
        }
        let is_flood = heard
            .iter()
            .any(|heard| FLOOD < heard.bytes.load(Ordering::Relaxed));
        if is_flood || longest < started.elapsed() {
            let _ = process.kill();
            let _ = process.wait();
            return if is_flood { End::Flood } else { End::Waited };
        }
        thread::sleep(Duration::from_millis(2));
    }
}

/// The signal that ended a process.
fn signal(status: ExitStatus) -> Option<i32> {
    #[cfg(unix)]
    return std::os::unix::process::ExitStatusExt::signal(&status);
    #[cfg(not(unix))]
    return None;
}

/// SIGXCPU and SIGXFSZ, the same on Linux and macOS; SIGKILL follows the first if it is ignored.
const XCPU: i32 = 24;
const XFSZ: i32 = 25;
const KILL: i32 = 9;

/// The result of a check that left none.
fn broken(id: &str, files: &Files, end: &End, seconds: u64, complained: &str) -> Report {
    let what = match end {
        End::NotStarted(error) => format!("the check could not be started: {error}"),
        End::Waited => {
            format!("it did not return within {seconds} s: does it wait, or loop without end?")
        }
        End::Flood => format!(
            "it printed more than {} MB: does it print in an endless loop?",
            FLOOD >> 20
        ),
        End::Itself(status) => match signal(*status) {
            Some(XCPU | KILL) => {
                format!("it did not return within {seconds} s of CPU time: an endless loop?")
            }
            Some(XFSZ) => "it wrote a file without end".into(),
            _ if complained.contains("overflowed its stack") => {
                "the stack overflowed: the function calls itself without end".into()
            }
            _ if complained.contains("memory allocation of") => {
                format!("it asked for more than {} GB of memory", MEMORY >> 30)
            }
            Some(signal) => format!("the program was ended by signal {signal}"),
            None => {
                let code = status.code().unwrap_or_default();
                format!(
                    "the program ended inside the function, with exit code {code}: a function returns and does not exit"
                )
            }
        },
    };
    let progress = fs::read_to_string(&files.progress).unwrap_or_default();
    let mut lines = progress.lines();
    let number = lines.next().and_then(|number| number.parse().ok());
    let note = lines.next().unwrap_or_default();
    let case = number.map(|number| CaseSaid {
        number,
        note: note.to_owned(),
        given: "the function was called and did not return".into(),
    });
    let outcome = Outcome::Broken {
        what,
        case,
        place: lines.next().map(str::to_owned),
    };
    let all = exercises();
    let about = all
        .iter()
        .map(|of| of.about())
        .find(|about| about.id() == id);
    match about {
        Some(about) => {
            let lines = message(about, &outcome, &commands(about, None));
            Report::new(about, &outcome, &lines, None)
        }
        None => unreachable!("{id} is an exercise"),
    }
}

/// What a student can do next.
pub fn commands(about: &About, picture: Option<&PathBuf>) -> Commands {
    let see = match about.see {
        See::Step {
            scene,
            pixel: [x, y],
            strategy,
            at,
            ..
        } => {
            let scene = files::of_course(scene);
            let strategy = match strategy {
                "" => String::new(),
                name => format!(" --strategy {name}"),
            };
            format!("raystep step {scene} {x},{y}{strategy} --at {at}")
        }
        See::Figure(name) => format!("raystep figure {name} -o figure.svg"),
    };
    let file = format!("{}/exercise.rs", files::folder_of(about.lesson));
    Commands {
        see,
        hint: format!("raystep lesson hint {:02} {}", about.lesson, about.name),
        file: files::of_course(&file),
        picture: picture.map(|file| files::typed(file)),
    }
}
