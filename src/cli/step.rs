//! `raystep step`: through one pixel step by step, as text: commands in, one step after the other out.
//!
//! This is the face for screen readers, scripts and tests, and what there is until a terminal has one of its own.

mod address;
mod plain;
mod save;

use std::io::{self, BufRead, IsTerminal, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use clap::ArgMatches;
use raystep::explain::strategy_title;
use raystep::scene::{ReadEnd, read_up_to};
use raystep::step::{
    Address, AddressError, Command, Cursor, Filter, StepLog, commands, same_place,
};
use raystep::{LoadError, Settings, StrategyName};

use crate::cli::Error;
use crate::cli::args::{Format, StepArgs};
use crate::cli::input::{self, Input, Ready};
use crate::cli::output::Output;
use crate::cli::pixel::{self, Traced};
use crate::cli::step::address::Words;
use crate::cli::step::plain::{Face, Next};
use crate::cli::usual::Usual;
use crate::cli::word::Word;

/// The most bytes of a line of commands.
const LONGEST_LINE: u64 = 1 << 16;

/// Steps through a pixel.
pub(crate) fn run(args: &StepArgs, matches: &ArgMatches) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) {
        return Err(Error::StandardOutputTwice {
            fix: "use --stats, which writes to standard error",
        });
    }
    let script = match &args.script {
        Some(script) => Some(commands(script).map_err(|error| Error::Script { error })?),
        None => None,
    };
    let (mut session, mut traced) = Session::open(args, matches)?;
    traced.tell_stats(&args.scene, args.tracing.stats)?;

    let mut at = session.start(args, &traced)?;
    let mut input = Commands::new(script);
    loop {
        let (next, place) = {
            let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
            let Some(cursor) = Cursor::at_start(&log) else {
                return Ok(());
            };
            let cursor = at.map_or(cursor, |step| Cursor::at(&log, step));
            let mut face = Face::new(&log, cursor, session.filter.clone(), session.predicts);
            face.arrive(&mut session.out)?;
            let next = loop {
                let Some(command) = input.next(&mut session.out)? else {
                    return session.out.finish();
                };
                match face.obey(command, &session.words, &mut session.out)? {
                    Next::Here => {}
                    Next::Quit => return session.out.finish(),
                    next => {
                        if let Some(traced) = session.another(next, &traced)? {
                            break traced;
                        }
                    }
                }
            };
            session.filter = face.filter;
            session.predicts = face.predicts;
            let other = StepLog::new(&next.scene, &next.settings, &next.records);
            let place = same_place(&log, face.cursor.here, &other);
            (next, place)
        };
        (traced, at) = (next, place);
    }
}

/// What stays while strategies and pixels change.
struct Session<'a> {
    args: &'a StepArgs,
    /// The pixel that is stepped through.
    pixel: [u32; 2],
    /// Can it be traced again?
    is_scene: bool,
    max_rays: u64,
    filter: Option<Filter>,
    /// Are questions asked?
    predicts: bool,
    words: Words,
    out: Output,
}

impl<'a> Session<'a> {
    /// Traces the pixel, or reads it from a log.
    fn open(args: &'a StepArgs, matches: &ArgMatches) -> Result<(Self, Traced), Error> {
        let started = Instant::now();
        let (pixel, is_scene, max_rays, traced) = match input::open(&args.scene, &args.reading)? {
            Input::Scene(loaded) => {
                let ready = input::ready(*loaded, &args.tracing, Usual::BySize, started)?;
                let pixel = pixel::inside(args.pixel, &ready.scene)?;
                let max_rays = ready.max_rays;
                let traced = pixel::trace(&args.scene, ready, pixel, args.budget)?;
                (pixel, true, max_rays, traced)
            }
            Input::Log(log) => {
                input::refuse_tracing(&args.scene, &args.tracing)?;
                let pixel = pixel::inside(args.pixel, log.scene())?;
                let traced = pixel::from_log(*log, &args.scene, args.pixel, &[], started)?;
                (pixel, false, 0, traced)
            }
        };
        let strategy = is_scene.then_some(traced.settings.strategy);
        let session = Self {
            args,
            pixel,
            is_scene,
            max_rays,
            filter: None,
            predicts: args.predict,
            words: Words::new(args, matches, pixel, strategy),
            out: Output::standard(),
        };
        Ok((session, traced))
    }

    /// The step that `--at` names.
    fn start(&self, args: &StepArgs, traced: &Traced) -> Result<Option<usize>, Error> {
        let Some(address) = args.at else {
            return Ok(None);
        };
        let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
        let event = match address.pixel {
            Some(pixel) if pixel != self.pixel => Err(AddressError::NoSection(address)),
            _ => log.event_at(address),
        };
        let event = event.map_err(|error| Error::Address { error })?;
        Ok(Some(log.leaf(event)))
    }

    /// The pixel with the next strategy, or the pixel beside; `None` if there is none, which is said.
    fn another(&mut self, next: Next, traced: &Traced) -> Result<Option<Traced>, Error> {
        let mut settings = traced.settings.clone();
        let mut pixel = self.pixel;
        match next {
            Next::Strategy if !self.is_scene => {
                let error = input::needs_scene(&self.args.scene, "another strategy asks for");
                return self.say(&error.to_string());
            }
            Next::Strategy => settings.strategy = following(settings.strategy),
            Next::Pixel(shift) => {
                let size = traced.scene.camera.pixels;
                let Some(beside) = shift.from(pixel, size) else {
                    return self.say("the picture ends here");
                };
                pixel = beside;
            }
            Next::Here | Next::Quit => return Ok(None),
        }
        let again = if self.is_scene {
            self.trace_again(settings, pixel, traced)
        } else {
            self.read_again(pixel)
        };
        match again {
            Ok(traced) => {
                self.pixel = pixel;
                let strategy = self.is_scene.then_some(traced.settings.strategy);
                self.words.moved(pixel, strategy);
                let strategy = strategy_title(&traced.settings);
                let [x, y] = pixel;
                self.say::<()>(&format!("pixel {x},{y}, strategy {strategy}"))?;
                Ok(Some(traced))
            }
            // the step before is still there
            Err(error) => self.say(&error.to_string()),
        }
    }

    fn trace_again(
        &self,
        settings: Settings,
        pixel: [u32; 2],
        traced: &Traced,
    ) -> Result<Traced, Error> {
        let ready = Ready {
            scene: traced.scene.clone(),
            settings,
            max_rays: self.max_rays,
            files: Vec::new(),
            is_usual: false,
            loading: Duration::ZERO,
        };
        pixel::trace(&self.args.scene, ready, pixel, self.args.budget)
    }

    fn read_again(&self, pixel: [u32; 2]) -> Result<Traced, Error> {
        let file: &Path = &self.args.scene;
        let started = Instant::now();
        match input::open(file, &self.args.reading)? {
            Input::Log(log) => pixel::from_log(*log, file, pixel.map(u64::from), &[], started),
            Input::Scene(_) => Err(Error::NotInLog {
                file: input::name_of(file),
                what: "this is no log any more".into(),
                fix: "start again",
            }),
        }
    }

    fn say<T>(&mut self, text: &str) -> Result<Option<T>, Error> {
        plain::say(text, &mut self.out)?;
        Ok(None)
    }
}

/// The strategy behind one in the list of the command line; behind the last the first.
fn following(strategy: StrategyName) -> StrategyName {
    let all = StrategyName::WORDS.iter().map(|(strategy, ..)| *strategy);
    let behind = all.clone().cycle().skip_while(|known| *known != strategy);
    behind.take(2).last().unwrap_or(strategy)
}

/// Where the commands come from: a script, or standard input line by line.
struct Commands {
    waiting: std::vec::IntoIter<Command>,
    /// Is there more to be read?
    reads: bool,
}

impl Commands {
    fn new(script: Option<Vec<Command>>) -> Self {
        let reads = script.is_none();
        Self {
            waiting: script.unwrap_or_default().into_iter(),
            reads,
        }
    }

    /// The next command; `None` at the end. A line that makes no sense is said, and the next one is read.
    fn next(&mut self, out: &mut Output) -> Result<Option<Command>, Error> {
        loop {
            if let Some(command) = self.waiting.next() {
                return Ok(Some(command));
            }
            if !self.reads {
                return Ok(None);
            }
            let mut input = io::stdin().lock();
            if input.is_terminal() {
                plain::write("> ", out)?;
            }
            out.flush().map_err(|error| out.failed(error))?;
            match read_line(&mut input)? {
                Line::Text(line) => match commands(&line) {
                    Ok(commands) => self.waiting = commands.into_iter(),
                    Err(error) => plain::say(&error.to_string(), out)?,
                },
                Line::TooLong => plain::say("this line of commands is too long", out)?,
                Line::End => return Ok(None),
            }
        }
    }
}

/// A line of standard input.
enum Line {
    Text(String),
    TooLong,
    /// There is none.
    End,
}

fn read_line(input: &mut impl BufRead) -> Result<Line, Error> {
    let unreadable = |source| {
        Error::Load(LoadError::Read {
            file: "standard input".into(),
            source,
        })
    };
    let mut line = Vec::new();
    let mut end = read_up_to(input, b'\n', LONGEST_LINE, &mut line).map_err(unreadable)?;
    if end == ReadEnd::Limit {
        while end == ReadEnd::Limit {
            line.clear();
            end = read_up_to(input, b'\n', LONGEST_LINE, &mut line).map_err(unreadable)?;
        }
        return Ok(Line::TooLong);
    }
    if line.is_empty() {
        return Ok(Line::End);
    }
    Ok(Line::Text(String::from_utf8_lossy(&line).into_owned()))
}

/// The address of a step as `--at` takes it.
fn address_of(log: &StepLog, event: usize) -> String {
    Address::of(log, event).to_string()
}
