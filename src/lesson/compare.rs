//! Every strategy on the same rays, one after the other.

use std::time::Instant;

use crate::explain::{Compared, Comparison, Cost, strategies_to_compare};
use crate::scene::Scene;
use crate::strategy::{Chosen, Strategy};
use crate::structure::StructureError;
use crate::trace::{Counts, Settings, Through};
use crate::tracer::{LightPass, Tracer, render, trace_pixel};

/// Traces a pixel, or the whole picture, with every strategy, over the rays of these settings. Where the transport
/// follows light, all its paths count, and [`check_light`](crate::tracer::check_light) must have been asked before.
///
/// `done` hears how many of the [`scan_lines_to_compare`] are finished.
pub fn compare<'a>(
    scene: &'a Scene,
    settings: &Settings,
    pixel: Option<[u32; 2]>,
    done: impl Fn(u64) + Sync,
) -> Comparison<'a> {
    let lines = scan_lines(scene, settings, pixel);
    let mut before = 0;
    let run = |settings: Settings| {
        let cost = cost(scene, &settings, pixel, |line| done(before + line));
        before += lines;
        done(before);
        Compared { settings, cost }
    };
    Comparison {
        scene,
        pixel,
        compared: strategies_to_compare(scene, settings)
            .into_iter()
            .map(run)
            .collect(),
    }
}

/// How many scan lines of eye rays all strategies together trace.
pub fn scan_lines_to_compare(scene: &Scene, settings: &Settings, pixel: Option<[u32; 2]>) -> u64 {
    let strategies = strategies_to_compare(scene, settings).len() as u64;
    scan_lines(scene, settings, pixel) * strategies
}

/// What one strategy costs.
fn cost(
    scene: &Scene,
    settings: &Settings,
    pixel: Option<[u32; 2]>,
    done: impl Fn(u64) + Sync,
) -> Result<Cost, StructureError> {
    let started = Instant::now();
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure)?;
    let building = started.elapsed();
    let started = Instant::now();
    let mut counts = Counts::default();
    let hear = |heard: Counts| counts.add(&heard);
    let light = LightPass::new(scene, &strategy, settings, None, hear, |_| {});
    let tracer = Tracer::new(scene, &strategy, settings.transport).with_light(light.as_ref());
    match pixel {
        Some(pixel) => {
            trace_pixel(&tracer, pixel, settings.through, &mut counts);
        }
        None => {
            let done = |lines: usize| done(lines as u64);
            let (_, lines) = render::<_, Counts>(&tracer, settings.through, done);
            for line in &lines {
                counts.add(line);
            }
        }
    }
    Ok(Cost {
        counts,
        bytes: strategy.bytes(),
        building,
        tracing: started.elapsed(),
    })
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
