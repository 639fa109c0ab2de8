//! Chance that can be repeated: the same seed gives the same bytes, on any number of threads, whoever listens, whatever
//! the strategy.

use std::ops::ControlFlow;

use glam::DVec3;
use raystep::strategy::{Exhaustive, Strategy};
use raystep::trace::{Kinds, LightOptions, Region, Sink};
use raystep::tracer::{LightPass, LogOptions, LoggedPaths, render, trace_pixel, write_log};
use raystep::{
    Chosen, Counts, Off, Record, Recorder, Recording, Scene, Settings, StrategyName, Tracer,
    Transport,
};

use super::ledger::scene;
use super::settings;
use crate::trace_log::strategies::{ways, with_slabs};

/// Every transport that follows light, with few paths; storage as points and as maps.
fn all(seed: u64) -> Vec<Settings> {
    let usual = LightOptions {
        seed,
        paths: 3_000,
        samples: 2,
        ..LightOptions::default()
    };
    let wide = LightOptions {
        aperture: Some(1.0),
        ..usual
    };
    let map = LightOptions {
        map: Some(8),
        ..usual
    };
    vec![
        settings(Transport::Forward, wide),
        settings(Transport::HybridStored, usual),
        settings(Transport::HybridStored, map),
        settings(Transport::HybridConnected, usual),
    ]
}

fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(work)
}

type Bits = Vec<[u64; 3]>;

fn bits(colours: impl IntoIterator<Item = DVec3>) -> Bits {
    let of_one = |colour: DVec3| colour.to_array().map(f64::to_bits);
    colours.into_iter().map(of_one).collect()
}

/// Both halves: the paths of light, and the pixels.
fn picture<S: Strategy, R: Recorder + Default + Send>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
) -> Bits {
    let light = LightPass::new::<_, R>(scene, strategy, settings, None, |_| {}, |_| {}).unwrap();
    let tracer = Tracer::new(scene, strategy, settings.transport).with_light(light.as_ref());
    bits(
        render::<_, R>(&tracer, settings.through, |_| {})
            .unwrap()
            .0
            .colours,
    )
}

fn off(scene: &Scene, settings: &Settings) -> Bits {
    picture::<_, Off>(scene, &Exhaustive::new(scene), settings)
}

/// The log of a few pixels and of all paths of light.
fn log(scene: &Scene, settings: &Settings) -> Vec<u8> {
    let strategy = Exhaustive::new(scene);
    let region: Region = "4,3-7,6".parse().unwrap();
    let light =
        LightPass::new::<_, Off>(scene, &strategy, settings, Some(region), |_| {}, |_| {}).unwrap();
    let tracer = Tracer::new(scene, &strategy, settings.transport).with_light(light.as_ref());
    let options = LogOptions {
        region,
        kinds: Kinds::ALL,
        budget: u64::MAX,
        paths: LoggedPaths::All(settings.light_paths(scene.camera.pixels).min(1_500)),
    };
    let mut bytes = Vec::new();
    write_log::<_, Off>(&tracer, settings, &options, &mut bytes, |_| {}).unwrap();
    bytes
}

/// Too long to be printed.
#[track_caller]
fn check_equal<T: PartialEq>(what: &str, a: &[T], b: &[T]) {
    let first = a.iter().zip(b).position(|(a, b)| a != b);
    assert_eq!(
        (first, a.len()),
        (None, b.len()),
        "{what}: the first place that differs"
    );
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_number_of_threads() {
    let scene = scene(true);
    for settings in all(3) {
        let name = format!("{:?}", settings.transport);
        let (first_log, first) = on_threads(1, || (log(&scene, &settings), off(&scene, &settings)));
        for threads in [2, 3] {
            let (again_log, again) =
                on_threads(threads, || (log(&scene, &settings), off(&scene, &settings)));
            check_equal(&format!("{name}, log"), &first_log, &again_log);
            check_equal(&name, &first, &again);
        }
    }
}

#[test]
fn another_seed_gives_another_picture_and_another_log() {
    let scene = scene(true);
    for (one, other) in all(3).into_iter().zip(all(4)) {
        assert_ne!(off(&scene, &one), off(&scene, &other));
        let [one, other] = [one, other].map(|settings| {
            let bytes = log(&scene, &settings);
            // behind the head, which names the seed
            let place = bytes
                .windows(13)
                .position(|bytes| bytes == b"\"kind\":\"path\"");
            bytes[place.unwrap()..].to_vec()
        });
        assert_ne!(one, other);
    }
}

/// Hears everything and keeps nothing.
#[derive(Default)]
struct Forgets;

impl Sink for Forgets {
    fn record(&mut self, _: &Record) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

#[test]
fn nobody_who_listens_changes_a_bit() {
    for closed in [false, true] {
        let scene = scene(closed);
        let strategy = Exhaustive::new(&scene);
        for settings in all(5) {
            let name = format!("{:?}", settings.transport);
            let expected = off(&scene, &settings);
            let found = picture::<_, Counts>(&scene, &strategy, &settings);
            check_equal(&name, &expected, &found);
            let found = picture::<_, Recording<Forgets>>(&scene, &strategy, &settings);
            check_equal(&name, &expected, &found);
            let found = picture::<_, (Counts, Recording<Forgets>)>(&scene, &strategy, &settings);
            check_equal(&name, &expected, &found);
        }
    }
}

#[test]
fn every_strategy_gives_the_same_bits() {
    let scene = with_slabs(scene(true));
    for settings in all(6) {
        let expected = off(&scene, &settings);
        // in the frame of a ray t is another number in its last bits
        let same = ways()
            .into_iter()
            .filter(|way| way.strategy != StrategyName::ZAligned);
        for way in same {
            let strategy = Chosen::new(&scene, way.strategy, &way.structure).unwrap();
            let found = picture::<_, Off>(&scene, &strategy, &settings);
            let name = format!("{:?}, {:?}", settings.transport, way.strategy);
            check_equal(&name, &expected, &found);
        }
    }
}

#[test]
fn a_pixel_alone_is_the_pixel_of_the_picture() {
    let scene = scene(true);
    let strategy = Exhaustive::new(&scene);
    for settings in all(7) {
        let light =
            LightPass::new::<_, Off>(&scene, &strategy, &settings, None, |_| {}, |_| {}).unwrap();
        let tracer = Tracer::new(&scene, &strategy, settings.transport).with_light(light.as_ref());
        let [width, height] = scene.camera.pixels;
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        // the other way round, so that none depends on those before it
        let mut alone: Vec<DVec3> = pixels
            .rev()
            .map(|pixel| {
                trace_pixel(&tracer, pixel, settings.through, &mut Counts::default()).unwrap()
            })
            .collect();
        alone.reverse();
        let name = format!("{:?}", settings.transport);
        check_equal(&name, &off(&scene, &settings), &bits(alone));
    }
}

#[test]
fn a_path_of_light_can_be_followed_again() {
    let scene = scene(true);
    let strategy = Exhaustive::new(&scene);
    for settings in all(8) {
        let light =
            LightPass::new::<_, Off>(&scene, &strategy, &settings, None, |_| {}, |_| {}).unwrap();
        let tracer = Tracer::new(&scene, &strategy, settings.transport).with_light(light.as_ref());
        let follow = |path| {
            let mut recording = Recording::new(Vec::new());
            tracer.trace_path(path, &mut recording).unwrap();
            recording.into_sink()
        };
        let [first, other, again] = [follow(150), follow(7), follow(150)];
        assert_eq!(first, again);
        assert_ne!(first, other);
        assert!(
            first
                .iter()
                .all(|record| record.path == Some(150) && record.pixel.is_none())
        );
    }
}
