//! `raystep compare`: what every strategy costs on the same rays, as a table, JSON, CSV and bars.

use std::time::Instant;

use raystep::Transport;
use raystep::figure::cost_chart;
use raystep::lesson::{
    NotCompared, compare, compare_transports, light_of_lamps, scan_lines_to_compare,
};
use raystep::scene::Loaded;
use raystep::tracer::check_light_of;

use crate::cli::Error;
use crate::cli::args::{CompareArgs, TableFormat, Tracing};
use crate::cli::input::{self, Input, Ready};
use crate::cli::light::tell_notes;
use crate::cli::output::{self, Output};
use crate::cli::pixel::inside;
use crate::cli::progress::{bar, bar_of, on_threads};
use crate::cli::same_file::Taken;
use crate::cli::usual::Usual;

/// Begins the ids of the chart.
const CHART_ID: &str = "raystep-compare";

/// Prints the comparison, and draws it if that is wanted.
pub(crate) fn run(args: &CompareArgs) -> Result<(), Error> {
    if args.chart.as_deref().is_some_and(output::is_standard) {
        return Err(Error::Target {
            file: "--chart -".into(),
            what: "the table and the chart cannot both go to standard output".into(),
            fix: "name a file with --chart".into(),
        });
    }
    if args.wide && args.format != TableFormat::Text {
        return Err(Error::Unused {
            option: "--wide",
            chosen: format!("--format {}, which has all columns", args.format.word()),
            users: vec!["--format text".into()],
        });
    }
    if args.transports {
        return transports(args);
    }
    let ready = scene_of(args, input::ready)?;
    let scene = &ready.scene;
    let pixel = args.pixel.map(|pixel| inside(pixel, scene)).transpose()?;
    let taken = Taken::by_reading(&args.scene, &ready.files);
    let chart = match &args.chart {
        Some(path) => {
            taken.refuse(path)?;
            output::refuse_ending(path, "a chart", &["svg"])?;
            Some(Output::create(path, &taken)?)
        }
        None => None,
    };

    let settings = &ready.settings;
    let strategy = ready.strategy()?;
    tell_notes(&args.scene, check_light_of(scene, &strategy, settings))?;
    let started = Instant::now();
    let clock = || started.elapsed();
    let bar = bar(scan_lines_to_compare(scene, settings, pixel));
    let comparison = on_threads(args.threads, || {
        compare(scene, settings, pixel, ready.max_rays, clock, |done| {
            bar.set_position(done);
        })
    })?;
    bar.finish_and_clear();
    let comparison = comparison.map_err(|stopped| ready.stopped(stopped))?;
    if let Some(chart) = chart {
        chart.write_whole(cost_chart(CHART_ID, &comparison).as_bytes())?;
    }
    let table = match args.format {
        TableFormat::Text if args.wide => comparison.wide_text(),
        TableFormat::Text => comparison.text(),
        TableFormat::Json => format!("{:#}\n", comparison.json()),
        TableFormat::Csv => comparison.csv(),
    };
    Output::standard().write_whole(table.as_bytes())
}

/// The scene, made ready as the options want it.
fn scene_of(
    args: &CompareArgs,
    ready: impl FnOnce(Loaded, &Tracing, Usual, Instant) -> Result<Ready, Error>,
) -> Result<Ready, Error> {
    let started = Instant::now();
    let tracing = Tracing {
        casting: args.casting.clone(),
        ..Tracing::default()
    };
    match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => ready(*loaded, &tracing, Usual::Exhaustive, started),
        Input::Log(_) => Err(input::needs_scene(&args.scene, "a comparison needs")),
    }
}

/// Prints what each kind of ray tracing costs and brings.
fn transports(args: &CompareArgs) -> Result<(), Error> {
    let ready = scene_of(args, input::ready_for_all)?;
    let scene = light_of_lamps(ready.scene);
    let started = Instant::now();
    let clock = || started.elapsed();
    let bar = bar_of(Transport::ALL.len() as u64, "kinds of ray tracing");
    let compared = on_threads(args.threads, || {
        let done = |done| bar.set_position(done);
        compare_transports(&scene, &ready.settings, ready.max_rays, clock, done)
    })?;
    bar.finish_and_clear();
    let comparison = compared.map_err(|error| match error {
        NotCompared::Light(fault) => Error::Light {
            file: input::name_of(&args.scene),
            fault,
        },
        NotCompared::Stopped { transport, stopped } => Error::Stopped { stopped, transport },
    })?;
    let table = match args.format {
        TableFormat::Text if args.wide => comparison.wide_text(),
        TableFormat::Text => comparison.text(),
        TableFormat::Json => format!("{:#}\n", comparison.json()),
        TableFormat::Csv => comparison.csv(),
    };
    Output::standard().write_whole(table.as_bytes())
}
