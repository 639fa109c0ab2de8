//! What stays while strategies and pixels change: what was asked for, and how another pixel is traced.

use std::path::Path;
use std::time::{Duration, Instant};

use clap::ArgMatches;
use raystep::explain::strategy_title;
use raystep::step::{AddressError, StepLog};
use raystep::{Settings, StrategyName};

use crate::cli::Error;
use crate::cli::args::StepArgs;
use crate::cli::input::{self, Input, Ready};
use crate::cli::pixel::{self, Traced};
use crate::cli::step::address::Words;
use crate::cli::step::next::Next;
use crate::cli::usual::Usual;
use crate::cli::word::Word;

/// What comes of going to another pixel or strategy.
pub(crate) enum Another {
    /// It is traced, with what is said of it.
    Traced(Box<Traced>, String),
    /// There is none: why. The step before is still there.
    None(String),
}

/// What stays while strategies and pixels change.
pub(crate) struct Session<'a> {
    args: &'a StepArgs,
    /// The pixel that is stepped through.
    pub(crate) pixel: [u32; 2],
    /// Can it be traced again?
    is_scene: bool,
    max_rays: u64,
    pub(crate) words: Words,
}

impl<'a> Session<'a> {
    /// Traces the pixel, or reads it from a log.
    pub(crate) fn open(args: &'a StepArgs, matches: &ArgMatches) -> Result<(Self, Traced), Error> {
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
            words: Words::new(args, matches, pixel, strategy),
        };
        Ok((session, traced))
    }

    /// The step that `--at` names.
    pub(crate) fn start(&self, args: &StepArgs, traced: &Traced) -> Result<Option<usize>, Error> {
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

    /// The pixel with the next strategy, or the pixel beside.
    pub(crate) fn another(&mut self, next: Next, traced: &Traced) -> Another {
        let mut settings = traced.settings.clone();
        let mut pixel = self.pixel;
        match next {
            Next::Strategy if !self.is_scene => {
                let error = input::needs_scene(&self.args.scene, "another strategy asks for");
                return Another::None(error.to_string());
            }
            Next::Strategy => settings.strategy = following(settings.strategy),
            Next::Pixel(shift) => {
                let size = traced.scene.camera.pixels;
                let Some(beside) = shift.from(pixel, size) else {
                    return Another::None("the picture ends here".into());
                };
                pixel = beside;
            }
            Next::Here | Next::Quit => return Another::None(String::new()),
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
                let text = format!("pixel {x},{y}, strategy {strategy}");
                Another::Traced(Box::new(traced), text)
            }
            Err(error) => Another::None(error.to_string()),
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
}

/// The strategy behind one in the list of the command line; behind the last the first.
fn following(strategy: StrategyName) -> StrategyName {
    let all = StrategyName::WORDS.iter().map(|(strategy, ..)| *strategy);
    let behind = all.clone().cycle().skip_while(|known| *known != strategy);
    behind.take(2).last().unwrap_or(strategy)
}
