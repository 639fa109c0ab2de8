//! `raystep inspect`: one page of a picture, on which one steps through its pixels.

mod picture;

use std::collections::BTreeSet;
use std::path::Path;
use std::time::Instant;

use clap::ArgMatches;
use raystep::explain::{grouped, strategy_title};
use raystep::lesson::StepFigures;
use raystep::page::{InspectPage, PackedPixel};
use raystep::step::{Address, AddressError, StepLog};
use raystep::trace::{OfPixels, Region};
use raystep::{Event, Record, Scene, Settings, Stopped, Traced, Tracer, record_pixel};

use crate::cli::Error;
use crate::cli::args::{Format, InspectArgs};
use crate::cli::input::{self, Input, Log, Ready};
use crate::cli::inspect::picture::{LogHeat, Shown, of_log, of_scene};
use crate::cli::light::light_pass;
use crate::cli::notes::note;
use crate::cli::output::{self, Output};
use crate::cli::pixel::inside;
use crate::cli::same_file::Taken;
use crate::cli::stats::{self, LogCounts, Report, Times};
use crate::cli::typed::{options, quoted};
use crate::cli::usual::Usual;
use crate::cli::word::word;

/// The options that `step` takes from elsewhere, or that the page says itself.
const OWN: [&str; 6] = ["scene", "pixel", "strategy", "at", "predict", "stats"];

/// Writes the page.
pub(crate) fn run(args: &InspectArgs, matches: &ArgMatches) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) && output::is_standard(&args.output) {
        return Err(Error::StandardOutputTwice {
            fix: "name a file with -o, or use --stats, which writes to standard error",
        });
    }
    let started = Instant::now();
    match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => {
            let ready = input::ready(*loaded, &args.tracing, Usual::BySize, started)?;
            from_scene(&ready, args, matches)
        }
        Input::Log(log) => {
            input::refuse_tracing(&args.scene, &args.tracing)?;
            from_log(*log, args, matches, started)
        }
    }
}

/// The pixels that are asked for.
fn region(args: &InspectArgs, scene: &Scene) -> Result<Region, Error> {
    let pixels = scene.camera.pixels;
    let whole = Region::whole(pixels);
    match (args.pixel, args.region) {
        (Some(pixel), _) => Ok(Region::pixel(inside(pixel, scene)?)),
        (None, None) => Ok(whole),
        (None, Some(region)) if whole.contains(region.from) && whole.contains(region.to) => {
            Ok(region)
        }
        (None, Some(region)) => Err(Error::RegionOutside { region, pixels }),
    }
}

/// The pixels of a region, row by row.
fn pixels_of(region: Region) -> impl Iterator<Item = [u32; 2]> {
    let columns = move || region.from[0]..=region.to[0];
    (region.from[1]..=region.to[1]).flat_map(move |y| columns().map(move |x| [x, y]))
}

fn from_scene(ready: &Ready, args: &InspectArgs, matches: &ArgMatches) -> Result<(), Error> {
    let region = region(args, &ready.scene)?;
    let taken = Taken::by_reading(&args.scene, &ready.files);
    taken.refuse(&args.output)?;
    output::refuse_ending(&args.output, "a page", &["html", "htm"])?;
    let out = Output::create(&args.output, &taken)?;
    let started = Instant::now();
    let strategy = ready.strategy()?;
    let built = Instant::now();
    let light = light_pass(&args.scene, ready, &strategy, Some(region), None, None)?;
    let tracer = Tracer::new(&ready.scene, &strategy, ready.settings.transport)
        .with_light(light.as_ref())
        .with_max_rays(ready.max_rays);
    let Settings {
        building, through, ..
    } = ready.settings;
    let mut pages = Pages::new(args, &ready.settings)?;
    for pixel in pixels_of(region) {
        let records = record_pixel(&tracer, pixel, through, building, args.budget);
        let records = records.map_err(|stopped| match stopped {
            Stopped::Recorder => Error::Budget {
                budget: args.budget,
            },
            Stopped::Rays { .. } => ready.stopped(stopped),
        })?;
        pages.add(&ready.scene, &ready.settings, pixel, &records)?;
    }
    let times = Times {
        loading: ready.loading,
        building: built - started,
        tracing: built.elapsed(),
    };
    let shown = if args.no_picture {
        Shown::default()
    } else {
        of_scene(&args.scene, ready, &strategy)?
    };
    if let (Some(format), Some(counts)) = (args.tracing.stats, &pages.counts) {
        stats::tell(format, &ready.report(&strategy, counts.counts(), times))?;
    }
    let source = Source {
        scene: &ready.scene,
        settings: &ready.settings,
        is_scene: true,
    };
    pages.write(&source, shown, args, matches, out)
}

fn from_log(
    log: Log,
    args: &InspectArgs,
    matches: &ArgMatches,
    started: Instant,
) -> Result<(), Error> {
    let region = region(args, log.scene())?;
    output::refuse_ending(&args.output, "a page", &["html", "htm"])?;
    let out = Output::create(&args.output, &Taken::by_reading(&args.scene, &[]))?;
    let mut log = log;
    let mut traced = Traced {
        scene: log.scene().clone(),
        settings: log.settings().clone(),
        of_pixels: OfPixels::default(),
        records: Vec::new(),
    };
    let mut colours = Vec::new();
    let mut heat = LogHeat::default();
    let mut held = BTreeSet::new();
    while let Some(record) = log.next_record().map_err(Error::Log)? {
        if let (Some(pixel), Event::PixelColour(colour)) = (record.pixel, &record.event) {
            colours.push((pixel, colour.clamped));
        }
        heat.add(&record);
        if record.pixel.is_none_or(|pixel| region.contains(pixel)) {
            // a pixel of which the log has the colour alone has no steps
            let is_colour = matches!(record.event, Event::PixelColour(_));
            let pixel = record.pixel.filter(|_| !is_colour);
            held.extend(pixel.map(|[x, y]| [y, x]));
            traced.records.push(record);
        }
    }
    let held = held.into_iter().map(|[y, x]| [x, y]);
    let mut pages = Pages::new(args, &traced.settings)?;
    for pixel in held {
        let records = traced.of_pixel(Some(pixel));
        pages.add(&traced.scene, &traced.settings, pixel, &records)?;
    }
    if pages.pixels.is_empty() {
        let what = match args.pixel {
            Some([x, y]) => format!("this log has no steps of pixel {x},{y}"),
            None => format!("this log has no steps of the pixels {region}"),
        };
        return Err(Error::NotInLog {
            file: input::name_of(&args.scene),
            what,
            fix: "choose another pixel, or trace the scene again",
        });
    }
    let shown = if args.no_picture {
        Shown::default()
    } else {
        let size = traced.scene.camera.pixels;
        of_log(size, traced.settings.transport, &colours, heat)
    };
    if let (Some(format), Some(counts)) = (args.tracing.stats, &pages.counts) {
        let report = Report {
            scene: &traced.scene,
            settings: &traced.settings,
            is_usual: false,
            crowded: None,
            counts: counts.counts(),
            times: Times {
                loading: started.elapsed(),
                ..Times::default()
            },
        };
        stats::tell(format, &report)?;
    }
    let source = Source {
        scene: &traced.scene,
        settings: &traced.settings,
        is_scene: false,
    };
    pages.write(&source, shown, args, matches, out)
}

/// What the pixels of a page come from.
struct Source<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    /// Can they be traced again?
    is_scene: bool,
}

/// The pixels of a page, one after the other.
struct Pages<'a> {
    args: &'a InspectArgs,
    pixels: Vec<PackedPixel>,
    size: usize,
    counts: Option<LogCounts>,
}

impl<'a> Pages<'a> {
    fn new(args: &'a InspectArgs, settings: &Settings) -> Result<Self, Error> {
        let file = input::name_of(&args.scene);
        let counts = args.tracing.stats.map(|_| LogCounts::new(&file, settings));
        Ok(Self {
            args,
            pixels: Vec::new(),
            size: 0,
            counts: counts.transpose()?,
        })
    }

    /// The most bytes of the page.
    fn most(&self) -> usize {
        self.args.megabytes as usize * 1_000_000
    }

    fn too_large(&self, what: String) -> Error {
        Error::PageTooLarge {
            what,
            most: self.args.megabytes,
            fix: if self.pixels.len() == 1 {
                "choose another --strategy, such as hierarchy, or --no-picture"
            } else {
                "choose fewer pixels: X,Y or a smaller --region"
            },
        }
    }

    /// One more pixel.
    fn add(
        &mut self,
        scene: &Scene,
        settings: &Settings,
        pixel: [u32; 2],
        records: &[Record],
    ) -> Result<(), Error> {
        let log = StepLog::new(scene, settings, records);
        if self.pixels.is_empty()
            && let Some(at) = self.args.at
        {
            check(&log, at, pixel)?;
        }
        if let Some(counts) = &mut self.counts {
            for record in records {
                counts.add(record);
            }
        }
        let views = StepFigures::new(&log).views(&log);
        let packed = PackedPixel::new(&log, pixel, &views);
        self.size += packed.size();
        self.pixels.push(packed);
        if self.most() < self.size {
            let pixels = self.pixels.len();
            let noun = if pixels == 1 { "pixel" } else { "pixels" };
            return Err(self.too_large(format!(
                "with {} {noun} the page has {:.1} MB",
                grouped(pixels as u64),
                self.size as f64 / 1e6
            )));
        }
        Ok(())
    }

    /// Puts the page together, says how large it is, and writes it.
    fn write(
        self,
        source: &Source,
        shown: Shown,
        args: &InspectArgs,
        matches: &ArgMatches,
        out: Output,
    ) -> Result<(), Error> {
        let transport = word(source.settings.transport);
        let strategy = strategy_title(source.settings);
        let mut notes = vec![format!("Transport: {transport}. Strategy: {strategy}.")];
        notes.extend(shown.notes);
        if StepFigures::MOST_FOR_ALL_VIEWS < source.scene.primitives.len() {
            notes.push("The scene has so many objects that one view is drawn.".into());
        }
        let page = InspectPage {
            title: title(source.scene, &args.scene),
            notes,
            size: source.scene.camera.pixels,
            picture: shown.picture,
            heat: shown.heat,
            pixels: self.pixels,
            at: args.at.map(|at| Address { pixel: None, ..at }.to_string()),
            predicts: args.predict,
            command: command(source, args, matches),
        };
        let most = args.megabytes as usize * 1_000_000;
        let pixels = page.pixels.len();
        let html = page.html(most).map_err(|error| Error::PageTooLarge {
            what: error.to_string(),
            most: args.megabytes,
            fix: "choose fewer pixels, or --no-picture",
        })?;
        let noun = if pixels == 1 { "pixel" } else { "pixels" };
        note(&format!(
            "the page holds {} {noun} and has {:.1} of at most {} MB",
            grouped(pixels as u64),
            html.len() as f64 / 1e6,
            args.megabytes
        ));
        out.write_whole(html.as_bytes())
    }
}

/// Is there the step at which the page is to begin?
fn check(log: &StepLog, at: Address, pixel: [u32; 2]) -> Result<(), Error> {
    let event = match at.pixel {
        Some(named) if named != pixel => Err(AddressError::NoSection(at)),
        _ => log.event_at(at),
    };
    event.map(|_| ()).map_err(|error| Error::Address { error })
}

/// The name of the scene, or of its file.
fn title(scene: &Scene, file: &Path) -> String {
    if scene.name.is_empty() {
        input::name_of(file)
    } else {
        scene.name.clone()
    }
}

/// The command that steps through a pixel, before and behind the pixel.
fn command(source: &Source, args: &InspectArgs, matches: &ArgMatches) -> [String; 2] {
    let scene = quoted(&args.scene.to_string_lossy());
    let mut behind = String::new();
    if source.is_scene {
        behind = format!(" --strategy {}", word(source.settings.strategy));
    }
    for option in options(matches, ["inspect", "step"], &OWN) {
        behind.push(' ');
        behind.push_str(&quoted(&option));
    }
    [format!("raystep step {scene}"), behind]
}
