//! What a program does with a scene, over whichever strategy was chosen: a pixel's events, a picture, a heat map, a log.
//!
//! The tracer is generic over strategies and recorders, and every use with other types is compiled anew. Nothing here is
//! generic: whoever calls these functions, as the command line does, compiles none of the tracer again.

use std::collections::BTreeSet;
use std::io::Write;

use crate::scene::Scene;
use crate::strategy::{Chosen, Strategy};
use crate::trace::{Budget, Counts, Off, Record, Recording, Region, Settings, Through};
use crate::tracer::eye::heat::HeatLine;
use crate::tracer::eye::picture::{Picture, render};
use crate::tracer::eye::pixel::trace_pixel;
use crate::tracer::light::all_paths;
use crate::tracer::light::light_check::check_light;
use crate::tracer::light::light_error::LightError;
use crate::tracer::light::light_pass::LightPass;
use crate::tracer::log::{LogOptions, LogStopped, write_log};
use crate::tracer::stopped::Stopped;
use crate::tracer::tracer::Tracer;

/// A tracer over a strategy that was chosen by its name.
pub type ChosenTracer<'a, 's> = Tracer<'a, Chosen<'s>>;

/// The events of a pixel: how the structure was built if `building` asks for it, the paths of light that led to the
/// pixel, and the pixel itself.
///
/// # Errors
/// More events than the budget ([`Stopped::Recorder`]), or more rays than the tracer allows.
pub fn record_pixel(
    tracer: &ChosenTracer<'_, '_>,
    pixel: [u32; 2],
    through: Through,
    building: bool,
    budget: u64,
) -> Result<Vec<Record>, Stopped> {
    let mut recording = Recording::new(Budget {
        left: budget,
        sink: Vec::new(),
    });
    if building {
        tracer.strategy.note_building(&mut recording);
    }
    for path in paths_behind_region(tracer, Region::pixel(pixel), through)? {
        tracer.trace_path(path, &mut recording)?;
    }
    trace_pixel(tracer, pixel, through, &mut recording)?;
    Ok(recording.into_sink().sink)
}

/// The paths of light that led to the colours of a region: see [`paths_behind`](crate::tracer::paths_behind).
///
/// # Errors
/// A pixel that takes more rays than the tracer allows.
pub fn paths_behind_region(
    tracer: &ChosenTracer<'_, '_>,
    region: Region,
    through: Through,
) -> Result<BTreeSet<u32>, Stopped> {
    all_paths::paths_behind(tracer, region, through)
}

/// Asks whether light can be followed: see [`check_light`].
///
/// # Errors
/// The first thing that stands against it.
pub fn check_light_of(
    scene: &Scene,
    strategy: &Chosen<'_>,
    settings: &Settings,
) -> Result<Vec<String>, LightError> {
    check_light(scene, strategy, settings)
}

/// Follows all paths of light, if the transport follows any; `counts`, where there are some, get what was traced for
/// it. Which paths the pixels of `region` saw is remembered. `done` hears how many paths have been followed.
///
/// # Errors
/// A recorder that has enough: none of these ever has.
pub fn follow_light(
    scene: &Scene,
    strategy: &Chosen<'_>,
    settings: &Settings,
    region: Option<Region>,
    counts: Option<&mut Counts>,
    done: &dyn Fn(u64),
) -> Result<Option<LightPass>, Stopped> {
    match counts {
        None => LightPass::new(scene, strategy, settings, region, |_: Off| {}, done),
        Some(counts) => {
            let hear = |heard: Counts| counts.add(&heard);
            LightPass::new(scene, strategy, settings, region, hear, done)
        }
    }
}

/// Traces a picture; `counts`, where there are some, get what was traced for it. `done` hears how many scan lines of eye
/// rays are finished.
///
/// # Errors
/// More rays for a pixel than the tracer allows.
pub fn render_picture(
    tracer: &ChosenTracer<'_, '_>,
    through: Through,
    counts: Option<&mut Counts>,
    done: &(dyn Fn(usize) + Sync),
) -> Result<Picture, Stopped> {
    match counts {
        None => render::<_, Off>(tracer, through, done).map(|(picture, _)| picture),
        Some(counts) => {
            let (picture, lines) = render::<_, Counts>(tracer, through, done)?;
            for line in &lines {
                counts.add(line);
            }
            Ok(picture)
        }
    }
}

/// Traces a picture, and what each of its eye rays cost, scan line by scan line; `counts` get the sums.
///
/// # Errors
/// More rays for a pixel than the tracer allows.
pub fn render_heat(
    tracer: &ChosenTracer<'_, '_>,
    through: Through,
    counts: &mut Counts,
    done: &(dyn Fn(usize) + Sync),
) -> Result<(Picture, Vec<HeatLine>), Stopped> {
    let (picture, lines) = render::<_, (HeatLine, Counts)>(tracer, through, done)?;
    let (heat, of_lines): (Vec<_>, Vec<_>) = lines.into_iter().unzip();
    for line in &of_lines {
        counts.add(line);
    }
    Ok((picture, heat))
}

/// Writes the log of a region: see [`write_log`]. `counts`, where there are some, get what was traced.
///
/// # Errors
/// A failing output, more events than the budget, or more rays for a pixel than the tracer allows.
pub fn record_log(
    tracer: &ChosenTracer<'_, '_>,
    settings: &Settings,
    options: &LogOptions,
    out: &mut (dyn Write + Send),
    counts: Option<&mut Counts>,
    done: &(dyn Fn(usize) + Sync),
) -> Result<(), LogStopped> {
    match counts {
        None => write_log::<_, Off>(tracer, settings, options, out, done).map(|_| ()),
        Some(counts) => {
            *counts += write_log::<_, Counts>(tracer, settings, options, out, done)?;
            Ok(())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{object, one_pixel, wall};
    use crate::structure::StructureOptions;
    use crate::trace::{Kinds, Purpose, StrategyName, Transport};
    use crate::tracer::log::LoggedPaths;

    #[test]
    fn what_is_done_by_name_counts_and_records_what_the_generic_functions_do() {
        // a white wall 5 ahead, lit from between; the ambient light is left out where light is followed
        let scene = one_pixel(&format!(
            r#""ambient":[1,1,1],"materials":{{"m":{{"colour":[1,1,1],"diffuse":0.5}}}},
            "lights":[{{"position":[0,0,-3],"power":12}}],"objects":[{}]"#,
            object("wall", "m", &wall(-5.0))
        ));
        let options = StructureOptions::default();
        let strategy = Chosen::new(&scene, StrategyName::Grid, &options).unwrap();
        let mut settings = Settings {
            transport: Transport::HybridStored,
            ..Settings::default()
        };
        settings.light.paths = 100;
        settings.light.nearest = 7;
        assert_eq!(
            check_light_of(&scene, &strategy, &settings).unwrap().len(),
            1
        );

        let mut counts = Counts::default();
        let light = follow_light(
            &scene,
            &strategy,
            &settings,
            None,
            Some(&mut counts),
            &|_| {},
        );
        let light = light.unwrap();
        assert!(light.is_some() && 100 <= counts.of(Purpose::Light).traced);
        let tracer = Tracer::new(&scene, &strategy, settings.transport).with_light(light.as_ref());
        let whole = Region::whole([1, 1]);
        // each path leaves one photon on the wall, and seven are gathered
        let behind = paths_behind_region(&tracer, whole, Through::Centres).unwrap();
        assert_eq!(behind.len(), 7);

        // the grid's lists, the seven paths, then the pixel, as far as the budget goes
        let record = |building, budget| {
            let records = record_pixel(&tracer, [0, 0], Through::Centres, building, budget);
            records.map(|records| records.len())
        };
        let pixel = record(false, 10_000).unwrap();
        assert!(7 * 3 < pixel && pixel < record(true, 10_000).unwrap());

        let log = LogOptions {
            region: whole,
            kinds: Kinds::ALL,
            budget: 10_000,
            paths: LoggedPaths::All(100),
        };
        let mut out = Vec::new();
        let mut heard = Counts::default();
        record_log(
            &tracer,
            &settings,
            &log,
            &mut out,
            Some(&mut heard),
            &|_| {},
        )
        .unwrap();
        assert_eq!(heard.of(Purpose::Light), counts.of(Purpose::Light));
        assert_eq!(heard.of(Purpose::Eye).traced, 1);
        assert!(100 * 3 < String::from_utf8(out).unwrap().lines().count());
    }
}
