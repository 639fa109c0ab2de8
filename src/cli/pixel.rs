//! `raystep pixel`: the worked solution of one pixel, from a scene or from a log.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Instant;

use anstream::{AutoStream, ColorChoice};
use raystep::{
    Kind, Kinds, Off, Record, Recording, Region, Scene, Settings, Sink, Strategy, Tracer,
    WorkedOptions, paths_behind, pixel_json, trace_pixel, worked_solution,
};

use crate::cli::Error;
use crate::cli::args::{Format, PixelArgs};
use crate::cli::input::{self, Input, Log, Ready};
use crate::cli::light::light_pass;
use crate::cli::output::Output;
use crate::cli::stats::{self, LogCounts, Times};

/// A pixel's trace.
struct Traced {
    scene: Scene,
    settings: Settings,
    records: Vec<Record>,
    times: Times,
}

/// Prints the working.
pub(crate) fn run(args: &PixelArgs) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) {
        return Err(Error::StandardOutputTwice {
            fix: "take --stats, which writes to standard error",
        });
    }
    let started = Instant::now();
    let traced = match input::open(&args.scene)? {
        Input::Scene(loaded) => {
            let ready = input::ready(*loaded, &args.tracing, started)?;
            let pixel = inside(args.pixel, &ready.scene)?;
            trace(args.scene.clone(), ready, pixel, args.budget)?
        }
        Input::Log(log) => {
            input::refuse_tracing(&args.scene, &args.tracing)?;
            from_log(*log, args, started)?
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
    if let Some(format) = args.tracing.stats {
        let mut counts = LogCounts::new(&input::name_of(&args.scene), &traced.settings)?;
        for record in &traced.records {
            counts.add(record);
        }
        let Traced {
            scene, settings, ..
        } = &traced;
        stats::tell(format, scene, settings, counts.counts(), traced.times)?;
    }
    Ok(())
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

/// Traces the pixel on a thread of its own: a tree of rays that outgrows the budget would go on for
/// long, and is left behind.
fn trace(file: PathBuf, ready: Ready, pixel: [u32; 2], budget: u64) -> Result<Traced, Error> {
    let (sender, receiver) = mpsc::channel();
    let spent = sender.clone();
    let worker = std::thread::Builder::new().stack_size(STACK);
    let started = worker.spawn(move || {
        let traced = trace_here(&file, ready, pixel, Spending { budget, spent });
        // nobody listens any more if the budget was spent
        let _ = sender.send(Some(Box::new(traced)));
    });
    started.map_err(|source| Error::Thread { source })?;
    match receiver.recv() {
        Ok(Some(traced)) => *traced,
        Ok(None) | Err(_) => Err(Error::Budget { budget }),
    }
}

/// Room for the deepest tree of rays.
const STACK: usize = 16 << 20;

/// Says once that more events came than the budget allows.
struct Spending {
    budget: u64,
    spent: mpsc::Sender<Option<Box<Result<Traced, Error>>>>,
}

/// Keeps records up to a budget.
struct Kept {
    records: Vec<Record>,
    spending: Spending,
}

impl Sink for Kept {
    fn record(&mut self, record: &Record) {
        if (self.records.len() as u64) < self.spending.budget {
            self.records.push(*record);
        } else {
            // the command ends with this message, and this thread with it
            let _ = self.spending.spent.send(None);
        }
    }
}

fn trace_here(
    file: &Path,
    ready: Ready,
    pixel: [u32; 2],
    spending: Spending,
) -> Result<Traced, Error> {
    let started = Instant::now();
    let strategy = ready.strategy()?;
    let built = Instant::now();
    let region = Region::pixel(pixel);
    let (light, _) = light_pass::<_, Off>(file, &ready, &strategy, Some(region), None)?;
    let tracer = Tracer::new(&ready.scene, &strategy, ready.settings.transport);
    let tracer = tracer.with_light(light.as_ref());
    let mut recording = Recording::new(Kept {
        records: Vec::new(),
        spending,
    });
    if ready.settings.building {
        strategy.note_building(&mut recording);
    }
    // the paths that led to the pixel come first
    for path in paths_behind(&tracer, region, ready.settings.through) {
        tracer.trace_path(path, &mut recording);
    }
    trace_pixel(&tracer, pixel, ready.settings.through, &mut recording);
    let records = recording.into_sink().records;
    let times = Times {
        loading: ready.loading,
        building: built - started,
        tracing: built.elapsed(),
    };
    drop(strategy);
    Ok(Traced {
        times,
        scene: ready.scene,
        settings: ready.settings,
        records,
    })
}

fn from_log(log: Log, args: &PixelArgs, started: Instant) -> Result<Traced, Error> {
    let pixel = inside(args.pixel, log.scene())?;
    let missing = |what: String, fix| Error::NotInLog {
        file: input::name_of(&args.scene),
        what,
        fix,
    };
    let [x, y] = pixel;
    if let Some(region) = log
        .settings()
        .region
        .filter(|region| !region.contains(pixel))
    {
        let what = format!("this log kept only the pixels {region}, and {x},{y} is none of them");
        return Err(missing(
            what,
            "choose one of them, or trace the scene again",
        ));
    }
    if let Some(kept) = log.settings().only.as_deref() {
        let is_kept = |kind: &Kind| kept.iter().any(|name| name == kind.name());
        if !args.only.is_empty() && !args.only.iter().any(is_kept) {
            let what = format!("this log kept only {}", kept.join(", "));
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
                "this log kept only {}, and pixel {x},{y} has none",
                kept.join(", ")
            ),
            None => format!("this log holds nothing of pixel {x},{y}: its end is missing"),
        };
        return Err(missing(what, "trace the scene again"));
    }
    Ok(Traced {
        scene,
        settings,
        records,
        times: Times {
            loading: started.elapsed(),
            ..Times::default()
        },
    })
}

/// Prints the working as text or JSON, as the options restrict it.
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
    match args.format {
        Format::Text => {
            let choice = AutoStream::choice(&std::io::stdout());
            let options = WorkedOptions {
                kinds,
                ray: args.ray,
                all: args.all,
                colour: choice != ColorChoice::Never,
            };
            let text = worked_solution(scene, settings, records, &options);
            // translates the colours where a terminal has other codes
            let mut out = anstream::stdout();
            let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
            written.map_err(|error| Output::standard().failed(error))
        }
        Format::Json => {
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
