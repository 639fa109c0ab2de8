//! `raystep compare`: what every strategy costs on the same rays, as a table, JSON, CSV and bars.

use std::time::Instant;

use indicatif::ProgressBar;
use raystep::{
    Chosen, Compared, Comparison, Cost, Counts, Scene, Settings, Strategy, StructureError, Through,
    Tracer, cost_chart, render, strategies_to_compare, trace_pixel,
};

use crate::cli::Error;
use crate::cli::args::{CompareArgs, TableFormat, Tracing};
use crate::cli::input::{self, Input};
use crate::cli::output::{self, Output};
use crate::cli::pixel::inside;
use crate::cli::progress::{bar, on_threads};
use crate::cli::stats;

/// Begins the ids of the chart.
const CHART_ID: &str = "raystep-compare";

/// Prints the comparison, and draws it if that is wanted.
pub(crate) fn run(args: &CompareArgs) -> Result<(), Error> {
    if args.chart.as_deref().is_some_and(output::is_standard) {
        return Err(Error::Target {
            file: "--chart -".into(),
            what: "the table goes to standard output, and so would the chart".into(),
            fix: "name a file with --chart".into(),
        });
    }
    let started = Instant::now();
    let tracing = Tracing {
        casting: args.casting.clone(),
        ..Tracing::default()
    };
    let ready = match input::open(&args.scene)? {
        Input::Scene(loaded) => input::ready(*loaded, &tracing, started)?,
        Input::Log(_) => return Err(input::needs_scene(&args.scene, "a comparison needs")),
    };
    let scene = &ready.scene;
    let pixel = args.pixel.map(|pixel| inside(pixel, scene)).transpose()?;
    let chart = args.chart.as_deref().map(Output::create).transpose()?;

    let comparison = Comparison {
        scene,
        pixel,
        compared: compare(scene, &ready.settings, pixel, args.threads)?,
    };
    if let Some(chart) = chart {
        chart.write_whole(cost_chart(CHART_ID, &comparison).as_bytes())?;
    }
    let table = match args.format {
        TableFormat::Text => comparison.text(),
        TableFormat::Json => format!("{:#}\n", comparison.json()),
        TableFormat::Csv => comparison.csv(),
    };
    Output::standard().write_whole(table.as_bytes())
}

/// Runs every strategy, one after the other.
fn compare(
    scene: &Scene,
    settings: &Settings,
    pixel: Option<[u32; 2]>,
    threads: Option<u16>,
) -> Result<Vec<Compared>, Error> {
    let all = strategies_to_compare(scene, settings);
    let bar = bar(scan_lines(scene, settings, pixel) * all.len() as u64);
    let compared = on_threads(threads, || {
        let run = |settings: Settings| Compared {
            cost: cost(scene, &settings, pixel, &bar),
            settings,
        };
        all.into_iter().map(run).collect()
    });
    bar.finish_and_clear();
    compared
}

/// What one strategy costs.
fn cost(
    scene: &Scene,
    settings: &Settings,
    pixel: Option<[u32; 2]>,
    bar: &ProgressBar,
) -> Result<Cost, StructureError> {
    let done_before = bar.position();
    let started = Instant::now();
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure);
    let building = started.elapsed();
    let cost = strategy.map(|strategy| {
        let tracer = Tracer {
            scene,
            strategy: &strategy,
            transport: settings.transport,
        };
        let started = Instant::now();
        let counts = match pixel {
            Some(pixel) => {
                let mut counts = Counts::default();
                trace_pixel(&tracer, pixel, settings.through, &mut counts);
                counts
            }
            None => {
                let done = |lines: usize| bar.set_position(done_before + lines as u64);
                let (_, lines) = render::<_, Counts>(&tracer, settings.through, done);
                stats::sum(&lines)
            }
        };
        Cost {
            counts,
            bytes: strategy.bytes(),
            building,
            tracing: started.elapsed(),
        }
    });
    bar.set_position(done_before + scan_lines(scene, settings, pixel));
    cost
}

/// How many scan lines of eye rays a strategy traces.
fn scan_lines(scene: &Scene, settings: &Settings, pixel: Option<[u32; 2]>) -> u64 {
    match pixel {
        Some(_) => 1,
        None => {
            let rows = u64::from(scene.camera.pixels[1]);
            // through the corners there is one more line of eye rays than of pixels
            rows + u64::from(settings.through == Through::Corners)
        }
    }
}
