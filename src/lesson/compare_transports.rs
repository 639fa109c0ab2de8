//! Every kind of ray tracing on the same scene, one after the other.

use std::time::{Duration, Instant};

use glam::DVec3;

use crate::explain::{ErrorOf, TransportComparison, TransportCost};
use crate::scene::Scene;
use crate::strategy::{DepthFirst, Strategy};
use crate::structure::{Build, SlabSet};
use crate::trace::{Counts, Off, Recorder, Settings, Through, Transport, UsefulRays};
use crate::tracer::{LightError, LightPass, Picture, Tracer, check_light, render};

/// Traces the picture with each of the five kinds of ray tracing: the light of the lamps alone, with no ambient light
/// and no background, so that all five show the same.
///
/// `scene` is without both: see [`light_of_lamps`]. `done` hears how many of the kinds are finished.
///
/// # Errors
/// A scene through which light cannot be followed.
pub fn compare_transports<'a>(
    scene: &'a Scene,
    settings: &Settings,
    done: impl Fn(u64),
) -> Result<TransportComparison<'a>, LightError> {
    // every strategy finds the same; this one is quick
    let strategy = &DepthFirst::<3>::new(scene, &SlabSet::AXES, Build::SurfaceArea);
    let closed_form = Settings {
        transport: Transport::HybridLight,
        through: Through::Centres,
        ..settings.clone()
    };
    let expected = values(&one_surface(scene, strategy, &closed_form));
    let mut compared = Vec::new();
    for transport in Transport::ALL {
        let settings = Settings {
            transport,
            through: Through::Centres,
            ..settings.clone()
        };
        check_light(scene, strategy, &settings)?;
        let mut counts = Counts::default();
        let mut rays = UsefulRays::default();
        let hear = |(counted, useful): (Counts, UsefulRays)| {
            counts.add(&counted);
            rays.add(&useful);
        };
        let (_, time) = picture(scene, strategy, &settings, hear);

        let found = one_surface(scene, strategy, &settings);
        compared.push(TransportCost {
            settings,
            counts,
            rays,
            error: ErrorOf::between(&values(&found), &expected),
            time,
        });
        done(compared.len() as u64);
    }
    Ok(TransportComparison { scene, compared })
}

/// The same scene without what does not come from its lamps.
#[must_use]
pub fn light_of_lamps(mut scene: Scene) -> Scene {
    scene.ambient = DVec3::ZERO;
    scene.background = DVec3::ZERO;
    scene
}

/// The picture, and how long it took.
fn picture<S: Strategy, R: Recorder + Default + Send>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
    mut heard: impl FnMut(R),
) -> (Picture, Duration) {
    let started = Instant::now();
    let light = LightPass::new(scene, strategy, settings, None, &mut heard, |_| {});
    let tracer = Tracer::new(scene, strategy, settings.transport).with_light(light.as_ref());
    let (picture, of_lines) = render(&tracer, settings.through, |_| {});
    for recorder in of_lines {
        heard(recorder);
    }
    (picture, started.elapsed())
}

/// The picture of light that meets only one surface between lamp and eye. With rays to the lamps it is the closed
/// form: L = Σ colour·diffuse/π · Φ·cos θ/(4π·r²) over the lamps that a point sees.
fn one_surface<S: Strategy>(scene: &Scene, strategy: &S, settings: &Settings) -> Picture {
    let mut scene = scene.clone();
    scene.max_depth = 1;
    let mut settings = settings.clone();
    settings.light.bounces = Some(1);
    picture(&scene, strategy, &settings, |_: Off| {}).0
}

/// Each channel of each pixel.
fn values(picture: &Picture) -> Vec<f64> {
    let channels = picture.colours.iter().flat_map(DVec3::to_array);
    channels.collect()
}
