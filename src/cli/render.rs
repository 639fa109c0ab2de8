//! `raystep render`: the picture as PNG, 8 bits a channel, without gamma; or what each pixel cost.

use std::io::{self, Write};
use std::time::Instant;

use raystep::figure::{Raster, heat_map};
use raystep::tracer::{HeatLine, HeatOf, Picture, heat_values, render_heat};
use raystep::{Chosen, Counts, Stopped, Through, Tracer, Transport, render_picture};

use crate::cli::Error;
use crate::cli::args::{Format, RenderArgs};
use crate::cli::input::{self, Input, Ready};
use crate::cli::light::light_pass;
use crate::cli::output::{self, Output};
use crate::cli::progress::{bar, on_threads};
use crate::cli::same_file::Taken;
use crate::cli::stats::{self, Times};
use crate::cli::usual::Usual;
use crate::cli::word::word;

/// Writes the picture.
pub(crate) fn run(args: &RenderArgs) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) && output::is_standard(&args.output) {
        return Err(Error::StandardOutputTwice {
            fix: "name a file with -o, or use --stats, which writes to standard error",
        });
    }
    let started = Instant::now();
    let ready = match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => {
            // a heat map shows what the simple ray tracer costs, unless it is to show another strategy
            let usual = match args.heatmap {
                None => Usual::Hierarchy,
                Some(_) => Usual::Exhaustive,
            };
            input::ready(*loaded, &args.tracing, usual, started)?
        }
        Input::Log(_) => return Err(input::needs_scene(&args.scene, "a picture needs")),
    };
    let transport = ready.settings.transport;
    if args.heatmap.is_some()
        && matches!(transport, Transport::Forward | Transport::HybridConnected)
    {
        return Err(Error::Unused {
            option: "--heatmap",
            chosen: format!(
                "--transport {}: a ray does not belong to a single pixel",
                word(transport)
            ),
            users: vec!["another --transport".into()],
        });
    }
    let taken = Taken::by_reading(&args.scene, &ready.files);
    taken.refuse(&args.output)?;
    output::refuse_ending(&args.output, "a picture", &["png"])?;
    let mut out = Output::create(&args.output, &taken)?;
    let started = Instant::now();
    let strategy = ready.strategy()?;
    let times = Times {
        loading: ready.loading,
        building: started.elapsed(),
        ..Times::default()
    };
    let (picture, counted) = render_with(&strategy, &ready, args, times)?;
    write_png(&picture, &mut out).map_err(|error| out.failed(error))?;
    out.finish()?;
    match (args.tracing.stats, counted) {
        (Some(format), Some((counts, times))) => {
            stats::tell(format, &ready.report(&strategy, &counts, times))
        }
        _ => Ok(()),
    }
}

/// The picture or the heat map, and the counts if they are wanted.
fn render_with(
    strategy: &Chosen<'_>,
    ready: &Ready,
    args: &RenderArgs,
    mut times: Times,
) -> Result<(Raster, Option<(Counts, Times)>), Error> {
    let started = Instant::now();
    let wanted = args.heatmap.is_some() || args.tracing.stats.is_some();
    let mut counts = wanted.then(Counts::default);
    let light = light_pass(
        &args.scene,
        ready,
        strategy,
        None,
        args.threads,
        counts.as_mut(),
    )?;
    let tracer = Tracer::new(&ready.scene, strategy, ready.settings.transport)
        .with_light(light.as_ref())
        .with_max_rays(ready.max_rays);
    let through = ready.settings.through;
    let raster = match (args.heatmap, &mut counts) {
        (Some(of), Some(counts)) => {
            let trace = |done: &(dyn Fn(usize) + Sync)| render_heat(&tracer, through, counts, done);
            let (picture, lines) = traced(ready, args, trace)?;
            heat_raster(&picture, &lines, of, ready)
        }
        (_, counts) => {
            let trace = |done: &(dyn Fn(usize) + Sync)| {
                render_picture(&tracer, through, counts.as_mut(), done)
            };
            raster(&traced(ready, args, trace)?)
        }
    };
    times.tracing = started.elapsed();
    Ok((raster, counts.map(|counts| (counts, times))))
}

/// The colours of the picture.
fn raster(picture: &Picture) -> Raster {
    Raster {
        pixels: picture.pixels,
        bytes: picture.bytes(),
    }
}

/// What its pixels cost.
fn heat_raster(picture: &Picture, lines: &[HeatLine], of: HeatOf, ready: &Ready) -> Raster {
    let values = heat_values(lines, of, ready.settings.through);
    heat_map(picture.pixels, &values, of.title())
}

/// Traces on the threads that are asked for, with a bar of scan lines.
fn traced<T: Send>(
    ready: &Ready,
    args: &RenderArgs,
    trace: impl FnOnce(&(dyn Fn(usize) + Sync)) -> Result<T, Stopped> + Send,
) -> Result<T, Error> {
    let rows = u64::from(ready.scene.camera.pixels[1]);
    // through the corners there is one more line of eye rays than of pixels
    let bar = bar(rows + u64::from(ready.settings.through == Through::Corners));
    let done = |lines: usize| bar.set_position(lines as u64);
    let traced = on_threads(args.threads, || trace(&done));
    bar.finish_and_clear();
    traced?.map_err(|stopped| ready.stopped(stopped))
}

fn write_png(picture: &Raster, out: impl Write) -> io::Result<()> {
    let failed = |error| match error {
        png::EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    };
    let [width, height] = picture.pixels;
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&picture.bytes).map_err(failed)?;
    writer.finish().map_err(failed)
}
