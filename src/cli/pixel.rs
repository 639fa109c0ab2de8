//! `raystep pixel`: the worked solution of one pixel, from a scene or from a log.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;
use std::time::Instant;

use anstream::{AutoStream, ColorChoice};
use raystep::explain::render;
use raystep::explain::{CrowdedCell, Unfold, pixel_json};
use raystep::trace::{Kind, Kinds, Region};
use raystep::{
    Record, Scene, Settings, Stopped, Tracer, WorkedOptions, record_pixel, worked_solution,
};

use crate::cli::Error;
use crate::cli::args::{Format, PixelArgs, PixelFormat};
use crate::cli::input::{self, Input, Log, Ready};
use crate::cli::light::light_pass;
use crate::cli::output::Output;
use crate::cli::stats::{self, LogCounts, Report, Times};
use crate::cli::usual::Usual;

/// A pixel's trace.
pub(crate) struct Traced {
    pub(crate) scene: Scene,
    pub(crate) settings: Settings,
    pub(crate) records: Vec<Record>,
    /// Did the verb choose the strategy, and no option?
    is_usual: bool,
    /// The grid that was walked, if most objects lie in one of its cells.
    crowded: Option<CrowdedCell>,
    times: Times,
}

impl Traced {
    /// Prints what it cost, where `--stats` asks for it.
    pub(crate) fn tell_stats(&self, file: &Path, format: Option<Format>) -> Result<(), Error> {
        let Some(format) = format else {
            return Ok(());
        };
        let mut counts = LogCounts::new(&input::name_of(file), &self.settings)?;
        for record in &self.records {
            counts.add(record);
        }
        let report = Report {
            scene: &self.scene,
            settings: &self.settings,
            is_usual: self.is_usual,
            crowded: self.crowded,
            counts: counts.counts(),
            times: self.times,
        };
        stats::tell(format, &report)
    }
}

/// Prints the working.
pub(crate) fn run(args: &PixelArgs) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) {
        return Err(Error::StandardOutputTwice {
            fix: "use --stats, which writes to standard error",
        });
    }
    let started = Instant::now();
    let traced = match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => {
            let ready = input::ready(*loaded, &args.tracing, Usual::BySize, started)?;
            let pixel = inside(args.pixel, &ready.scene)?;
            trace(&args.scene, ready, pixel, args.budget)?
        }
        Input::Log(log) => {
            input::refuse_tracing(&args.scene, &args.tracing)?;
            from_log(*log, &args.scene, args.pixel, &args.only, started)?
        }
    };
    if let Some(ray) = args.ray {
        let own = traced.records.iter().filter(|r| r.path.is_none());
        let rays: BTreeSet<u32> = own.filter_map(|r| r.ray).collect();
        if !rays.contains(&ray) {
            let last = rays.last().copied();
            return Err(Error::NoSuchRay { ray, last });
        }
    }

    print(args, &traced)?;
    traced.tell_stats(&args.scene, args.tracing.stats)
}

/// The pixel, if the picture has it.
pub(crate) fn inside(pixel: [u64; 2], scene: &Scene) -> Result<[u32; 2], Error> {
    let pixels = scene.camera.pixels;
    if pixel
        .iter()
        .zip(pixels)
        .all(|(&place, side)| place < u64::from(side))
    {
        Ok(pixel.map(|place| place as u32))
    } else {
        Err(Error::PixelOutside { pixel, pixels })
    }
}

/// Traces the pixel, and keeps its events up to the budget.
pub(crate) fn trace(
    file: &Path,
    ready: Ready,
    pixel: [u32; 2],
    budget: u64,
) -> Result<Traced, Error> {
    let started = Instant::now();
    let strategy = ready.strategy()?;
    let built = Instant::now();
    let region = Region::pixel(pixel);
    let light = light_pass(file, &ready, &strategy, Some(region), None, None)?;
    let tracer = Tracer::new(&ready.scene, &strategy, ready.settings.transport)
        .with_light(light.as_ref())
        .with_max_rays(ready.max_rays);
    let Settings {
        building, through, ..
    } = ready.settings;
    let records = record_pixel(&tracer, pixel, through, building, budget);
    let records = records.map_err(|stopped| match stopped {
        Stopped::Recorder => Error::Budget { budget },
        Stopped::Rays { .. } => ready.stopped(stopped),
    })?;
    let times = Times {
        loading: ready.loading,
        building: built - started,
        tracing: built.elapsed(),
    };
    let crowded = ready.crowded(&strategy);
    drop(strategy);
    Ok(Traced {
        times,
        is_usual: ready.is_usual,
        crowded,
        scene: ready.scene,
        settings: ready.settings,
        records,
    })
}

/// The pixel's events in a log, which must hold some; `only` are the kinds that are asked for, if not all are.
pub(crate) fn from_log(
    log: Log,
    file: &Path,
    pixel: [u64; 2],
    only: &[Kind],
    started: Instant,
) -> Result<Traced, Error> {
    let pixel = inside(pixel, log.scene())?;
    let missing = |what: String, fix| Error::NotInLog {
        file: input::name_of(file),
        what,
        fix,
    };
    let [x, y] = pixel;
    if let Some(region) = log
        .settings()
        .region
        .filter(|region| !region.contains(pixel))
    {
        let what = format!("this log has only the pixels {region}, and {x},{y} is not one of them");
        return Err(missing(
            what,
            "choose one of them, or trace the scene again",
        ));
    }
    if let Some(kept) = log.settings().only.as_deref() {
        let is_kept = |kind: &Kind| kept.iter().any(|name| name == kind.name());
        if !only.is_empty() && !only.iter().any(is_kept) {
            let what = format!("this log has only {}", kept.join(", "));
            return Err(missing(
                what,
                "choose --only among them, or trace the scene again",
            ));
        }
    }
    let (scene, settings, records) = log.pixel(pixel)?;
    if records.is_empty() {
        let what = match &settings.only {
            Some(kept) => format!(
                "this log has only {}, and pixel {x},{y} has none",
                kept.join(", ")
            ),
            None => format!("this log has no events of pixel {x},{y}: its end is missing"),
        };
        return Err(missing(what, "trace the scene again"));
    }
    Ok(Traced {
        scene,
        settings,
        records,
        is_usual: false,
        crowded: None,
        times: Times {
            loading: started.elapsed(),
            ..Times::default()
        },
    })
}

/// The options that show what a page leaves out.
fn hint(unfold: Unfold) -> String {
    match unfold {
        Unfold::All => "--all shows them".into(),
        Unfold::Ray(ray) => format!("--ray {ray}"),
    }
}

/// Prints the working in its format, as the options restrict it.
fn print(args: &PixelArgs, traced: &Traced) -> Result<(), Error> {
    let Traced {
        scene,
        settings,
        records,
        ..
    } = traced;
    let kinds = if args.only.is_empty() {
        Kinds::ALL
    } else {
        Kinds::of(&args.only)
    };
    let options = WorkedOptions {
        kinds,
        ray: args.ray,
        all: args.all,
    };
    let page = || worked_solution(scene, settings, records, &options);
    match args.format {
        PixelFormat::Text => {
            let text = match AutoStream::choice(&std::io::stdout()) {
                ColorChoice::Never => render::plain(&page(), hint),
                _ => render::ansi(&page(), hint),
            };
            // translates the colours where a terminal has other codes
            let mut out = anstream::stdout();
            let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
            written.map_err(|error| Output::standard().failed(error))
        }
        PixelFormat::Markdown => {
            let markdown = render::markdown(&page(), hint);
            Output::standard().write_whole(markdown.as_bytes())
        }
        PixelFormat::Html => {
            let html = render::html_document(&page(), hint);
            Output::standard().write_whole(html.as_bytes())
        }
        PixelFormat::Json => {
            let wanted = |record: &&Record| {
                kinds.contains(record.event.kind())
                    && (args.ray.is_none() || record.path.is_none() && record.ray == args.ray)
            };
            let records: Vec<Record> = records.iter().filter(wanted).copied().collect();
            // the pixel is the same whatever region of a log it comes from
            let settings = Settings {
                region: None,
                ..settings.clone()
            };
            let json = pixel_json(scene, &settings, &records);
            Output::standard().write_whole(format!("{json:#}\n").as_bytes())
        }
    }
}
