//! Tracing what a figure is drawn from.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use crate::figure::{FigureError, FigureKind, FigureSpec, Traced};
use crate::lesson::LessonError;
use crate::lesson::compare_transports::{light_of_lamps, rays_of_picture};
use crate::lesson::error::too_many_rays;
use crate::lesson::picture::trace_picture;
use crate::mistake::{mistake, mistakes, shown};
use crate::parallel;
use crate::scene::{Loaded, Scene, nearest_name};
use crate::strategy::{Chosen, Strategy};
use crate::structure::StructureOptions;
use crate::trace::{
    Counts, Kind, Kinds, LoggedMistake, LoggedPicture, OfPixels, Off, Record, Recording, Region,
    Settings, Sink, StrategyName, TestsOfRow, Through, Totals, Transport,
};
use crate::tracer::{
    Heat, HeatLine, LightError, LightPass, Stopped, Tracer, check_light, paths_behind, trace_pixel,
};

/// The most pixels that a figure may have of which every one is recorded.
const MOST_PIXELS: u64 = 512 * 512;

/// The most paths of light that are followed for a figure: some ten seconds.
const MOST_FOLLOWED: u64 = 10_000_000;

/// The most paths of light that a figure may show: all their events are kept.
const MOST_PATHS: u32 = 10_000;

/// Traces a scene as a figure asks for it, once for each of its strategies and volumes.
///
/// `name` is the figure's, as in `12-grid/walk`; `wrong` says where its specification is.
///
/// # Errors
/// A scene that makes no sense, or a specification that does not fit it.
#[expect(clippy::too_many_lines, reason = "one step of tracing after the other")]
pub fn trace_figure(
    mut loaded: Loaded,
    name: &str,
    spec: &FigureSpec,
    wrong: impl Fn(FigureError) -> LessonError,
) -> Result<Vec<Traced>, LessonError> {
    let error = |key, what: String, fix: &str| wrong(FigureError::new(key, what, fix));
    if let Some(size) = spec.size {
        loaded.scene.camera.pixels = size;
    }
    let scene = loaded.build()?;
    let [width, height] = scene.camera.pixels;
    if (records_every_pixel(spec.kind) || spec.kind == FigureKind::Heat)
        && MOST_PIXELS < u64::from(width) * u64::from(height)
    {
        return Err(error(
            "size",
            format!(
                "{width} × {height} pixels are too many for this kind of figure, which records every pixel"
            ),
            "give the figure a \"size\" of at most 512 × 512 in all, such as [48, 36]",
        ));
    }
    let whole = spec.traced_pixels();
    if let Some([x, y]) = whole.iter().find(|[x, y]| width <= *x || height <= *y) {
        return Err(error(
            "pixel",
            format!("pixel {x},{y} is not in the picture of {width} × {height} pixels"),
            "count columns from 0 at the left and rows from 0 at the top",
        ));
    }

    check_paths(spec, [width, height]).map_err(&wrong)?;

    let kept = kept(spec.kind);
    let trace = |variant: Variant| {
        let Variant {
            strategy,
            structure,
            transport,
        } = variant;
        let settings = Settings {
            strategy,
            structure,
            building: true,
            transport,
            light: spec.light,
            through: spec.through,
            one_sided: false,
            only: Some(kept.iter().map(|kind| kind.name().into()).collect()),
            whole: whole.clone(),
            figure: Some(name.into()),
            region: None,
        };
        let chosen = Chosen::new(&scene, strategy, &structure).map_err(|fault| {
            // some say themselves what to do, in a line of its own
            let text = fault.to_string();
            let (what, fix) = text
                .split_once("\n  ")
                .unwrap_or((&text, "change \"structure\""));
            wrong(FigureError::new("structure", what, fix))
        })?;
        let followed = settings.light_paths(scene.camera.pixels);
        if MOST_FOLLOWED < followed {
            return Err(error(
                "light",
                format!(
                    "{followed} paths of light are too many for a figure, which traces all of them"
                ),
                "lower \"paths\" or \"samples\" in \"light\", to at most 10 million paths in all",
            ));
        }
        check_light(&scene, &chosen, &settings).map_err(|fault| wrong(no_light(&fault)))?;
        let around = Region::around(&whole);
        let light = LightPass::new(&scene, &chosen, &settings, around, |Off| (), |_| ());
        let light = light.map_err(|stopped| wrong(too_many_rays(&stopped)))?;
        let tracer = Tracer::new(&scene, &chosen, transport).with_light(light.as_ref());
        let mut recording = Recording::new(Keep {
            records: Vec::new(),
            whole: &whole,
            of_every: Kinds::of(kept),
        });
        chosen.note_building(&mut recording);
        record(&tracer, spec, &whole, &mut recording)
            .map_err(|stopped| wrong(too_many_rays(&stopped)))?;
        let records = recording.into_sink().records;
        let mut of_pixels = OfPixels::default();
        if spec.kind == FigureKind::Heat {
            let tests = tests_of_pixels(&tracer, spec.through);
            of_pixels.tests = tests.map_err(|stopped| wrong(too_many_rays(&stopped)))?;
        }
        of_pixels.totals = match (spec.kind, transport) {
            (FigureKind::Sum, _) => Some(tests_of_some(&tracer, spec.every())),
            (FigureKind::Transports, _) => Some(rays_of_all(
                &light_of_lamps(scene.clone()),
                &chosen,
                &settings,
            )),
            (FigureKind::Paths, Transport::Forward) => {
                Some(rays_of_all(&scene, &chosen, &settings))
            }
            _ => None,
        }
        .transpose()
        .map_err(|stopped| wrong(too_many_rays(&stopped)))?;
        let traced = Traced {
            scene: scene.clone(),
            settings,
            of_pixels,
            records,
        };
        Ok((traced, light))
    };
    let traced: Result<Vec<_>, LessonError> = variants(spec).into_iter().map(trace).collect();
    let mut traced = traced?;
    if spec.shows_picture() {
        // each kind of ray tracing has a picture of its own
        let pictures = spec.transports.len().max(1);
        for (of, light) in traced.iter_mut().take(pictures) {
            let transport = of.settings.transport;
            let picture = trace_picture(&scene, (spec, transport), light.as_ref());
            of.of_pixels.picture = Some(picture.map_err(&wrong)?);
        }
    }
    if spec.kind == FigureKind::Mistake
        && let Some((first, _)) = traced.first_mut()
    {
        let (picture, mistake) = mistaken(&scene, spec).map_err(&wrong)?;
        first.of_pixels.picture = Some(picture);
        first.of_pixels.mistake = Some(mistake);
    }
    Ok(traced.into_iter().map(|(traced, _)| traced).collect())
}

/// The right picture, and what a mistake makes of it.
fn mistaken(
    scene: &Scene,
    spec: &FigureSpec,
) -> Result<(LoggedPicture, LoggedMistake), FigureError> {
    let error = |what: String, fix: String| FigureError::new("mistake", what, fix);
    let Some(name) = &spec.mistake else {
        let fix = "add \"mistake\" with the name of one, such as \"first root always\"";
        return Err(error("the figure names no mistake".into(), fix.into()));
    };
    let Some(mistake) = mistake(name) else {
        let near = nearest_name(name, mistakes().map(|of| of.name));
        let fix = near.map_or_else(
            || "name one of the gallery, such as \"first root always\"".into(),
            |near| format!("did you mean {near:?}?"),
        );
        return Err(error(format!("there is no mistake {name:?}"), fix));
    };
    shown(scene, mistake).map_err(|not| error(not.to_string(), "choose another scene".into()))
}

/// What differs from trace to trace.
struct Variant {
    strategy: StrategyName,
    structure: StructureOptions,
    transport: Transport,
}

/// All combinations of the strategies, volumes, resolutions and transports that a figure compares, or the one that it shows.
fn variants(spec: &FigureSpec) -> Vec<Variant> {
    fn or_one<T: Copy>(several: &[T], one: T) -> Vec<T> {
        if several.is_empty() {
            vec![one]
        } else {
            several.into()
        }
    }
    let resolutions: Vec<_> = spec.resolutions.iter().copied().map(Some).collect();
    let mut variants = Vec::new();
    for strategy in or_one(&spec.strategies, spec.strategy) {
        for volume in or_one(&spec.volumes, spec.structure.volume) {
            for resolution in or_one(&resolutions, spec.structure.grid.resolution) {
                for transport in or_one(&spec.transports, spec.transport) {
                    let mut structure = StructureOptions {
                        volume,
                        ..spec.structure
                    };
                    structure.grid.resolution = resolution;
                    variants.push(Variant {
                        strategy,
                        structure,
                        transport,
                    });
                }
            }
        }
    }
    variants
}

/// The tests of every n-th pixel both ways.
fn tests_of_some<S: Strategy>(tracer: &Tracer<'_, S>, every: u32) -> Result<Totals, Stopped> {
    let [width, height] = tracer.scene.camera.pixels;
    let rows: Vec<u32> = (0..height).step_by(every as usize).collect();
    let of_row = |row: usize| {
        let mut counts = Counts::default();
        let mut pixels = 0;
        for x in (0..width).step_by(every as usize) {
            trace_pixel(tracer, [x, rows[row]], Through::Centres, &mut counts)?;
            pixels += 1;
        }
        Ok((pixels, counts))
    };
    let mut totals = Totals {
        every,
        ..Totals::default()
    };
    for row in parallel::map(rows.len(), of_row) {
        let (pixels, counts): (u64, Counts) = row?;
        let search = &counts.search;
        totals.pixels += pixels;
        totals.objects += counts.objects_tested();
        totals.nodes += search.bounds.tests + search.entered;
        totals.cells += search.cells;
    }
    Ok(totals)
}

/// The rays of the whole picture, with those of paths of light.
fn rays_of_all<S: Strategy>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
) -> Result<Totals, Stopped> {
    let (counts, rays) = rays_of_picture(scene, strategy, settings)?;
    let [width, height] = scene.camera.pixels.map(u64::from);
    Ok(Totals {
        every: 1,
        pixels: width * height,
        cast: rays.cast,
        contributed: rays.contributed(),
        paths: counts.light.paths,
        arrived: counts.light.reached_eye,
        ..Totals::default()
    })
}

/// Records the paths of light that a figure shows, then its pixels, and the last one of the picture: its colour closes the
/// log, so that a log without its end is known by it.
fn record<S: Strategy>(
    tracer: &Tracer<'_, S>,
    spec: &FigureSpec,
    whole: &[[u32; 2]],
    recording: &mut Recording<Keep<'_>>,
) -> Result<(), Stopped> {
    for path in shown_paths(tracer, spec, whole)? {
        tracer.trace_path(path, recording)?;
    }
    let [width, height] = tracer.scene.camera.pixels;
    let mut pixels: BTreeSet<[u32; 2]> = whole.iter().map(|[x, y]| [*y, *x]).collect();
    pixels.insert([height - 1, width - 1]);
    if records_every_pixel(spec.kind) {
        pixels.extend((0..height).flat_map(|y| (0..width).map(move |x| [y, x])));
    }
    for [y, x] in pixels {
        trace_pixel(tracer, [x, y], spec.through, recording)?;
    }
    Ok(())
}

/// How many tests the rays of each pixel take, row by row.
fn tests_of_pixels<S: Strategy>(
    tracer: &Tracer<'_, S>,
    through: Through,
) -> Result<Vec<TestsOfRow>, Stopped> {
    let [width, height] = tracer.scene.camera.pixels;
    let of_row = |row: usize| {
        let mut tests = TestsOfRow::default();
        for x in 0..width {
            let mut line = HeatLine::default();
            trace_pixel(tracer, [x, row as u32], through, &mut line)?;
            let sum = |of: fn(&Heat) -> u64| line.heats.iter().map(of).sum();
            tests.objects.push(sum(|heat| heat.tests));
            tests.nodes.push(sum(|heat| heat.nodes));
            tests.cells.push(sum(|heat| heat.cells));
        }
        Ok(tests)
    };
    parallel::map(height as usize, of_row).into_iter().collect()
}

/// Does this kind of figure draw paths of light?
fn draws_paths(kind: FigureKind) -> bool {
    use FigureKind::{Connections, Gather, Paths, Rays, Transports};
    matches!(kind, Rays | Paths | Gather | Connections | Transports)
}

/// Are there the paths of light that the figure shows?
fn check_paths(spec: &FigureSpec, pixels: [u32; 2]) -> Result<(), FigureError> {
    let Some(shown) = spec.paths else {
        return Ok(());
    };
    let follows = |transport: &&Transport| transport.follows_light();
    let transport = spec.transports.iter().find(follows);
    let transport = *transport.unwrap_or(&spec.transport);
    let settings = Settings {
        transport,
        light: spec.light,
        ..Settings::default()
    };
    let all = settings.light_paths(pixels);
    let (what, fix) = if !draws_paths(spec.kind) {
        let what = "this kind of figure draws no paths of light".to_owned();
        (what, "omit \"paths\"".to_owned())
    } else if !transport.follows_light() {
        let what = "this transport traces no light from the lights".to_owned();
        let fix = "omit \"paths\", or choose another \"transport\", such as \"forward\"";
        (what, fix.to_owned())
    } else if all == 0 {
        // what prevents tracing any is reported when the light is checked
        return Ok(());
    } else if shown == 0 || all.min(MOST_PATHS.into()) < shown.into() {
        let what = format!("{shown} paths cannot be shown: {all} are traced");
        let most = all.min(MOST_PATHS.into());
        (what, format!("show from 1 to {most}"))
    } else {
        return Ok(());
    };
    Err(FigureError::new("paths", what, fix))
}

/// Why light cannot be followed, as a mistake in the figure.
fn no_light(fault: &LightError) -> FigureError {
    let key = match fault {
        LightError::NoLights
        | LightError::NoPower { .. }
        | LightError::Albedo { .. }
        | LightError::Inside { .. }
        | LightError::Endless { .. } => "scene",
        LightError::NoPaths { .. }
        | LightError::TooMany { .. }
        | LightError::TooManyCells { .. }
        | LightError::OutOfRange { .. } => "light",
    };
    FigureError::new(key, fault.to_string(), fault.fix())
}

/// The paths of light that a figure shows, in order.
fn shown_paths<S: Strategy>(
    tracer: &Tracer<'_, S>,
    spec: &FigureSpec,
    whole: &[[u32; 2]],
) -> Result<BTreeSet<u32>, Stopped> {
    if !draws_paths(spec.kind) || !tracer.transport.follows_light() {
        return Ok(BTreeSet::new());
    }
    let mut shown: BTreeSet<u32> = (0..spec.paths.unwrap_or(0)).collect();
    for &pixel in whole {
        shown.extend(paths_behind(tracer, Region::pixel(pixel), spec.through)?);
    }
    Ok(shown)
}

/// Does the log keep events of every pixel?
fn records_every_pixel(kind: FigureKind) -> bool {
    kind == FigureKind::Irradiance
}

/// What is kept of the pixels that are not drawn.
fn kept(kind: FigureKind) -> &'static [Kind] {
    if records_every_pixel(kind) {
        &[Kind::PixelColour, Kind::Gathered]
    } else {
        &[Kind::PixelColour]
    }
}

/// Keeps every event of some pixels, and some kinds of all others.
struct Keep<'a> {
    records: Vec<Record>,
    whole: &'a [[u32; 2]],
    of_every: Kinds,
}

impl Sink for Keep<'_> {
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        let is_whole = record.pixel.is_none_or(|pixel| self.whole.contains(&pixel));
        if is_whole || self.of_every.contains(record.event.kind()) {
            self.records.push(*record);
        }
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is wrong with the paths of a figure over a picture of 2 × 2.
    fn wrong(spec: &str) -> Option<String> {
        let spec = serde_json::from_str(spec).unwrap();
        check_paths(&spec, [2, 2]).err().map(|error| error.what)
    }

    #[test]
    fn a_figure_shows_as_many_paths_as_there_are_and_none_where_no_light_is_followed() {
        let of = |kind: &str, transport: &str, paths: u32| {
            wrong(&format!(
                r#"{{"kind":"{kind}","scene":"s","transport":"{transport}","paths":{paths},"light":{{"paths":50,"samples":3}}}}"#
            ))
        };
        assert_eq!(of("paths", "forward", 50), None);
        assert_eq!(of("rays", "hybrid-connected", 12), None);
        let too_many = "51 paths cannot be shown: 50 are traced";
        assert_eq!(of("paths", "hybrid-stored", 51).as_deref(), Some(too_many));
        let too_many = "13 paths cannot be shown: 12 are traced";
        assert_eq!(
            of("paths", "hybrid-connected", 13).as_deref(),
            Some(too_many)
        );
        assert!(of("paths", "forward", 0).is_some());
        assert!(of("paths", "backward", 5).is_some());
        assert!(of("picture", "forward", 5).is_some());
    }
}
