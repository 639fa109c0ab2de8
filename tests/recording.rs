//! Recording: it never changes a colour, and what it hears adds up.

mod stopped;
mod strategies;
mod sums;

use std::ops::ControlFlow;

use glam::DVec3;
use raystep::trace::Purpose;
use raystep::tracer::{render, trace_pixel};
use raystep::{
    Chosen, Counts, Event, Off, Record, Recorder, Recording, Scene, Settings, Through, Tracer,
    Transport,
};

use crate::trace_log::strategies::{ways, with_slabs};
use crate::trace_log::{EXAMPLE, MIXED, built, nff, strategy, tracer};
use sums::Sums;

pub(crate) const NFF: [&str; 7] = [
    "balls-2", "gears-1", "mount-3", "rings-1", "teapot-2", "tetra-3", "tree-4",
];

/// Every scene, as a small picture.
fn scenes(side: u32) -> impl Iterator<Item = Scene> {
    let own = [EXAMPLE, MIXED].map(|text| {
        let mut file: serde_json::Value = serde_json::from_str(text).unwrap();
        file["camera"]["pixels"] = [side, side].into();
        built(&file.to_string())
    });
    let nff = NFF.into_iter().map(move |name| nff(name, [side, side]));
    own.into_iter().chain(nff).map(with_slabs)
}

fn on<T>(scene: &Scene, settings: &Settings, work: impl Fn(&Tracer<'_, Chosen<'_>>) -> T) -> T {
    let strategy = strategy(scene, settings);
    work(&tracer(scene, &strategy, settings))
}

/// Every strategy, looking through the centres or the corners of the pixels.
fn ways_through(through: Through) -> impl Iterator<Item = Settings> {
    ways()
        .into_iter()
        .map(move |way| Settings { through, ..way })
}

fn bits(colour: DVec3) -> [u64; 3] {
    colour.to_array().map(f64::to_bits)
}

/// The colours of all pixels, one after the other.
fn pixel_by_pixel<R: Recorder>(
    scene: &Scene,
    settings: &Settings,
    recorder: &mut R,
) -> Vec<[u64; 3]> {
    let strategy = strategy(scene, settings);
    pixels_of(
        &tracer(scene, &strategy, settings),
        settings.through,
        recorder,
    )
}

fn pixels_of<R: Recorder>(
    tracer: &Tracer<'_, Chosen<'_>>,
    through: Through,
    recorder: &mut R,
) -> Vec<[u64; 3]> {
    let [width, height] = tracer.scene.camera.pixels;
    (0..height)
        .flat_map(|y| (0..width).map(move |x| [x, y]))
        .map(|pixel| bits(trace_pixel(tracer, pixel, through, recorder).unwrap()))
        .collect()
}

/// The colours of a picture.
fn picture<R: Recorder + Default + Send>(
    tracer: &Tracer<'_, Chosen<'_>>,
    through: Through,
) -> Vec<[u64; 3]> {
    let (picture, _) = render::<_, R>(tracer, through, |_| {}).unwrap();
    picture.colours.into_iter().map(bits).collect()
}

/// Hears everything and keeps nothing.
#[derive(Default)]
struct Forgets;

impl raystep::trace::Sink for Forgets {
    fn record(&mut self, _: &Record) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

#[track_caller]
fn check_same(what: &str, expected: &[[u64; 3]], found: &[[u64; 3]]) {
    assert_eq!(expected.len(), found.len());
    let first = expected.iter().zip(found).position(|(a, b)| a != b);
    assert_eq!(first, None, "{what}: the first pixel that differs");
}

/// The scene and the way through it, for messages.
fn name(scene: &Scene, settings: &Settings) -> String {
    format!(
        "{}, {:?} {:?}",
        scene.name, settings.strategy, settings.structure
    )
}

/// No recorder changes a bit of the picture.
fn check_unchanged(scene: &Scene, settings: &Settings) {
    let name = name(scene, settings);
    let check = |recorder: &str, expected: &[_], found: &[_]| {
        check_same(&format!("{name}, {recorder}"), expected, found);
    };
    let through = settings.through;
    on(scene, settings, |tracer| {
        let expected = picture::<Off>(tracer, through);
        let colours = pixels_of(tracer, through, &mut Off);
        check("pixel by pixel", &expected, &colours);
        let colours = picture::<Counts>(tracer, through);
        check("Counts", &expected, &colours);
        let colours = picture::<Recording<Forgets>>(tracer, through);
        check("Recording", &expected, &colours);
        let mut pair = ((Counts::default(), Off), Recording::new(Forgets));
        let colours = pixels_of(tracer, through, &mut pair);
        check("a pair", &expected, &colours);
    });
}

#[test]
fn no_recorder_changes_a_bit_of_a_picture() {
    for (through, side) in [(Through::Centres, 16), (Through::Corners, 9)] {
        for scene in scenes(side) {
            for way in ways_through(through) {
                check_unchanged(&scene, &way);
            }
        }
    }
}

#[test]
fn a_pair_hears_what_each_of_it_hears_alone() {
    for scene in scenes(12) {
        let settings = Settings::default();
        let mut alone = Counts::default();
        pixel_by_pixel(&scene, &settings, &mut alone);
        let mut pair = (Recording::new(Sums::default()), Counts::default());
        pixel_by_pixel(&scene, &settings, &mut pair);
        assert_eq!(alone, pair.1, "{}", scene.name);
    }
}

#[test]
fn counts_are_those_of_the_events_and_those_of_the_rays_ends() {
    for (through, side) in [(Through::Centres, 12), (Through::Corners, 8)] {
        for scene in scenes(side) {
            for way in ways_through(through) {
                let mut pair = (Counts::default(), Recording::new(Sums::default()));
                pixel_by_pixel(&scene, &way, &mut pair);
                let (counts, sums) = (pair.0, pair.1.into_sink());
                sums.check(&name(&scene, &way), &counts);
            }
        }
    }
}

#[test]
fn scan_lines_counts_add_up_to_those_of_the_picture() {
    for scene in scenes(12) {
        for way in ways() {
            let name = name(&scene, &way);
            let mut whole = Counts::default();
            pixel_by_pixel(&scene, &way, &mut whole);
            let lines_through = |through| {
                on(&scene, &way, |tracer| {
                    render::<_, Counts>(tracer, through, |_| {}).unwrap().1
                })
            };
            let mut sum = Counts::default();
            for line in &lines_through(Through::Centres) {
                sum.add(line);
            }
            assert_eq!(sum.rays, whole.rays, "{name}");
            assert_eq!(sum.tests, whole.tests, "{name}");
            assert_eq!(sum.search, whole.search, "{name}");
            // corners are shared: 13 × 13 eye rays for 12 × 12 pixels
            let lines = lines_through(Through::Corners);
            let eye: u64 = lines.iter().map(|line| line.of(Purpose::Eye).traced).sum();
            assert_eq!(eye, 13 * 13);
        }
    }
}

#[test]
fn each_ray_and_each_colour_follows_from_the_events_before_it() {
    for (through, side) in [(Through::Centres, 12), (Through::Corners, 6)] {
        for scene in scenes(side) {
            for transport in [Transport::HybridLight, Transport::Backward] {
                for way in ways_through(through) {
                    check_pixels(&scene, &Settings { transport, ..way });
                }
            }
        }
    }
}

fn check_pixels(scene: &Scene, settings: &Settings) {
    let [width, height] = scene.camera.pixels;
    on(scene, settings, |tracer| {
        let mut recording = Recording::new(Vec::new());
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            let colour = trace_pixel(tracer, pixel, settings.through, &mut recording).unwrap();
            let records = std::mem::take(recording.sink_mut());
            sums::check_pixel(scene, settings, pixel, &records);
            let Some(Event::PixelColour(last)) = records.last().map(|record| record.event) else {
                panic!("the last event of {pixel:?} is no colour");
            };
            assert_eq!(bits(last.raw), bits(colour));
        }
    });
}
