//! Every strategy on the same rays, one after the other.

use std::time::Duration;

use crate::explain::{Compared, Comparison, Cost, CrowdedCell, strategies_to_compare};
use crate::scene::Scene;
use crate::strategy::{Chosen, Strategy};
use crate::structure::StructureError;
use crate::trace::{Counts, Settings, Through};
use crate::tracer::{LightPass, Stopped, Tracer, render, trace_pixel};

/// Traces a pixel, or the whole picture, with every strategy, over the rays of these settings. Where the transport
/// follows light, all its paths count, and [`check_light`](crate::tracer::check_light) must have been asked before.
///
/// A pixel may take `max_rays` rays. `clock` says how much time has passed since any moment; one that stands still
/// leaves the times at 0. `done` hears how many of the [`scan_lines_to_compare`] are finished.
///
/// # Errors
/// A pixel that takes more rays.
pub fn compare<'a>(
    scene: &'a Scene,
    settings: &Settings,
    pixel: Option<[u32; 2]>,
    max_rays: u64,
    clock: impl Fn() -> Duration,
    done: impl Fn(u64) + Sync,
) -> Result<Comparison<'a>, Stopped> {
    let lines = scan_lines(scene, settings, pixel);
    let mut before = 0;
    let run = |settings: Settings| {
        let cost = cost(scene, &settings, pixel, max_rays, &clock, |line| {
            done(before + line);
        })?;
        before += lines;
        done(before);
        Ok(Compared { settings, cost })
    };
    let strategies = strategies_to_compare(scene, settings).into_iter();
    let compared: Result<Vec<Compared>, Stopped> = strategies.map(run).collect();
    Ok(Comparison {
        scene,
        pixel,
        compared: compared?,
    })
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
    max_rays: u64,
    clock: &impl Fn() -> Duration,
    done: impl Fn(u64) + Sync,
) -> Result<Result<Cost, StructureError>, Stopped> {
    let started = clock();
    let strategy = match Chosen::new(scene, settings.strategy, &settings.structure) {
        Ok(strategy) => strategy,
        Err(fault) => return Ok(Err(fault)),
    };
    let building = clock().saturating_sub(started);
    let started = clock();
    let mut counts = Counts::default();
    let hear = |heard: Counts| counts.add(&heard);
    let light = LightPass::new(scene, &strategy, settings, None, hear, |_| {})?;
    let tracer = Tracer::new(scene, &strategy, settings.transport)
        .with_light(light.as_ref())
        .with_max_rays(max_rays);
    match pixel {
        Some(pixel) => {
            trace_pixel(&tracer, pixel, settings.through, &mut counts)?;
        }
        None => {
            let done = |lines: usize| done(lines as u64);
            let (_, lines) = render::<_, Counts>(&tracer, settings.through, done)?;
            for line in &lines {
                counts.add(line);
            }
        }
    }
    Ok(Ok(Cost {
        counts,
        bytes: strategy.bytes(),
        crowded: strategy
            .grid()
            .and_then(|grid| CrowdedCell::of(grid, scene.primitives.len())),
        building,
        tracing: clock().saturating_sub(started),
    }))
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
