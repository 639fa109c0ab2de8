//! The five kinds of ray tracing: which of them sees what, and those that follow light against physics: closed forms, a
//! sampler of another make, and the conservation of energy.
//!
//! What chance decides is compared in standard errors: each test takes them from its data, holds them below a limit, and
//! asks that the difference is at most three of them. The seeds are fixed: a test passes always or never.

mod agree;
mod caustic;
mod chain;
mod effects;
mod furnace;
mod inside_glass;
mod irradiance;
mod ledger;
mod reproducible;
mod room;
mod weights;

use glam::DVec3;
use raystep::strategy::Exhaustive;
use raystep::trace::LightOptions;
use raystep::tracer::{LightPass, Picture, check_light, render};
use raystep::{Off, Recorder, Scene, Settings, Tracer, Transport};

pub(crate) use crate::trace_log::built;

/// A mean differs from what it estimates by more than this many standard errors in one case of 370.
const DEVIATIONS: f64 = 3.0;

/// The settings of a transport.
fn settings(transport: Transport, light: LightOptions) -> Settings {
    Settings {
        transport,
        light,
        ..Settings::default()
    }
}

/// Follows all paths of light, with what a recorder hears of each thousand of them.
#[track_caller]
fn light_pass<R: Recorder + Default + Send>(
    scene: &Scene,
    settings: &Settings,
) -> (LightPass, Vec<R>) {
    let strategy = Exhaustive::new(scene);
    check_light(scene, &strategy, settings).unwrap();
    let mut heard = Vec::new();
    let hears = |recorder| heard.push(recorder);
    let light = LightPass::new::<_, R>(scene, &strategy, settings, None, hears, |_| {}).unwrap();
    (light.unwrap(), heard)
}

/// The whole picture.
#[track_caller]
fn picture(scene: &Scene, settings: &Settings) -> Picture {
    let (light, _) = light_pass::<Off>(scene, settings);
    let strategy = Exhaustive::new(scene);
    let tracer = Tracer::new(scene, &strategy, settings.transport).with_light(Some(&light));
    render::<_, Off>(&tracer, settings.through, |_| {})
        .unwrap()
        .0
}

/// Pictures that differ in their seed alone, from 1 on.
#[track_caller]
fn pictures(
    scene: &Scene,
    transport: Transport,
    seeds: u64,
    options: LightOptions,
) -> Vec<Picture> {
    (1..=seeds)
        .map(|seed| {
            picture(
                scene,
                &settings(transport, LightOptions { seed, ..options }),
            )
        })
        .collect()
}

/// Some columns and rows of a picture.
#[derive(Clone, Copy, Debug)]
struct Block {
    columns: [u32; 2],
    rows: [u32; 2],
}

impl Block {
    /// The mean over its pixels.
    fn mean(self, picture: &Picture) -> DVec3 {
        let [left, right] = self.columns;
        let [top, bottom] = self.rows;
        let mut sum = DVec3::ZERO;
        for y in top..bottom {
            for x in left..right {
                sum += picture.colours[(y * picture.pixels[0] + x) as usize];
            }
        }
        sum / f64::from((right - left) * (bottom - top))
    }

    /// The same over many pictures.
    fn estimate(self, pictures: &[Picture]) -> Estimate {
        let means: Vec<DVec3> = pictures.iter().map(|picture| self.mean(picture)).collect();
        Estimate::of(&means)
    }
}

/// What independent samples say: their mean and its standard error, channel by channel.
#[derive(Clone, Copy, Debug)]
struct Estimate {
    mean: DVec3,
    error: DVec3,
}

impl Estimate {
    /// σ² of the mean of n samples is Σ (sample − mean)² / (n·(n − 1)).
    fn of(samples: &[DVec3]) -> Self {
        let count = samples.len() as f64;
        let mean = samples.iter().sum::<DVec3>() / count;
        let squares: DVec3 = samples.iter().map(|&s| (s - mean) * (s - mean)).sum();
        let variance = squares / (count * (count - 1.0));
        Self {
            mean,
            error: variance.map(f64::sqrt),
        }
    }

    /// What is known exactly.
    fn exact(mean: DVec3) -> Self {
        Self {
            mean,
            error: DVec3::ZERO,
        }
    }

    /// Is the standard error at most this share of the mean?
    #[track_caller]
    fn is_within(self, limit: f64, what: &str) -> Self {
        let share = self.error / self.mean;
        assert!(
            (0.0..=limit).contains(&share.min_element()) && share.max_element() <= limit,
            "{what}: σ is {share} of {}, and may be {limit}",
            self.mean
        );
        self
    }
}

/// Do two estimates of the same quantity agree?
#[track_caller]
fn check_same(what: &str, a: Estimate, b: Estimate) {
    let error = (a.error * a.error + b.error * b.error).map(f64::sqrt);
    let off = (a.mean - b.mean).abs() / error;
    assert!(
        off.cmple(DVec3::splat(DEVIATIONS)).all(),
        "{what}: {} and {} differ by {off} standard errors",
        a.mean,
        b.mean
    );
}
