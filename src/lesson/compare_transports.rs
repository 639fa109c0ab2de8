//! Every kind of ray tracing on the same scene, one after the other.

use std::time::Duration;

use glam::DVec3;

use crate::explain::{ErrorOf, TransportComparison, TransportCost};
use crate::scene::Scene;
use crate::strategy::{DepthFirst, Strategy};
use crate::structure::{Build, SlabSet};
use crate::trace::{Counts, Off, Recorder, Settings, Through, Transport, UsefulRays};
use crate::tracer::{
    LightError, LightPass, MAX_RAYS, Picture, Stopped, Tracer, check_light, render,
};

/// Why the kinds of ray tracing cannot be compared.
#[derive(Debug)]
pub enum NotCompared {
    /// Light cannot be followed through the scene.
    Light(LightError),
    /// A pixel takes more rays than it may.
    Stopped {
        /// With this kind of ray tracing.
        transport: Transport,
        /// Which pixel.
        stopped: Stopped,
    },
}

/// Traces the picture with each of the five kinds of ray tracing: the light of the lamps alone, with no ambient light
/// and no background, so that all five show the same.
///
/// `scene` is without both: see [`light_of_lamps`]. A pixel may take `max_rays` rays. `clock` says how much time has
/// passed since any moment. `done` hears how many of the
/// kinds are finished.
///
/// # Errors
/// A scene through which light cannot be followed, or a pixel that takes more rays.
pub fn compare_transports<'a>(
    scene: &'a Scene,
    settings: &Settings,
    max_rays: u64,
    clock: impl Fn() -> Duration,
    done: impl Fn(u64),
) -> Result<TransportComparison<'a>, NotCompared> {
    // every strategy finds the same; this one is quick
    let strategy = &DepthFirst::<3>::new(scene, &SlabSet::AXES, Build::SurfaceArea);
    let closed_form = Settings {
        transport: Transport::HybridLight,
        through: Through::Centres,
        ..settings.clone()
    };
    let expected = values(&one_surface(scene, strategy, &closed_form, max_rays)?);
    let mut compared = Vec::new();
    for transport in Transport::ALL {
        let settings = Settings {
            transport,
            through: Through::Centres,
            ..settings.clone()
        };
        check_light(scene, strategy, &settings).map_err(NotCompared::Light)?;
        let mut counts = Counts::default();
        let mut rays = UsefulRays::default();
        let hear = |(counted, useful): (Counts, UsefulRays)| {
            counts.add(&counted);
            rays.add(&useful);
        };
        let started = clock();
        picture(scene, strategy, &settings, max_rays, hear)?;
        let time = clock().saturating_sub(started);

        let found = one_surface(scene, strategy, &settings, max_rays)?;
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

/// What the rays of the picture take and bring, those of the paths of light among them.
///
/// # Errors
/// A pixel that takes more rays than it may.
pub(super) fn rays_of_picture<S: Strategy>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
) -> Result<(Counts, UsefulRays), Stopped> {
    let mut counts = Counts::default();
    let mut rays = UsefulRays::default();
    let heard = |(counted, useful): (Counts, UsefulRays)| {
        counts.add(&counted);
        rays.add(&useful);
    };
    traced(scene, strategy, settings, MAX_RAYS, heard)?;
    Ok((counts, rays))
}

/// The picture; `heard` is given what the recorders have heard.
fn picture<S: Strategy, R: Recorder + Default + Send>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
    max_rays: u64,
    heard: impl FnMut(R),
) -> Result<Picture, NotCompared> {
    let transport = settings.transport;
    let traced = traced(scene, strategy, settings, max_rays, heard);
    traced.map_err(|stopped| NotCompared::Stopped { transport, stopped })
}

fn traced<S: Strategy, R: Recorder + Default + Send>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
    max_rays: u64,
    mut heard: impl FnMut(R),
) -> Result<Picture, Stopped> {
    let light = LightPass::new(scene, strategy, settings, None, &mut heard, |_| {})?;
    let tracer = Tracer::new(scene, strategy, settings.transport)
        .with_light(light.as_ref())
        .with_max_rays(max_rays);
    let (picture, of_lines) = render(&tracer, settings.through, |_| {})?;
    for recorder in of_lines {
        heard(recorder);
    }
    Ok(picture)
}

/// The picture of light that hits only one surface between lamp and eye. With rays to the lamps it is the closed
/// form: L = Σ colour·diffuse/π · Φ·cos θ/(4π·r²) over the lamps that a point sees.
fn one_surface<S: Strategy>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
    max_rays: u64,
) -> Result<Picture, NotCompared> {
    let mut scene = scene.clone();
    scene.max_depth = 1;
    let mut settings = settings.clone();
    settings.light.bounces = Some(1);
    picture(&scene, strategy, &settings, max_rays, |_: Off| {})
}

/// Each channel of each pixel.
fn values(picture: &Picture) -> Vec<f64> {
    let channels = picture.colours.iter().flat_map(DVec3::to_array);
    channels.collect()
}
