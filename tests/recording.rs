//! Recording: it never changes a colour, and what it hears adds up.

mod sums;

use glam::DVec3;
use raystep::{
    Counts, Event, Exhaustive, Off, Purpose, Record, Recorder, Recording, Scene, Settings, Through,
    Tracer, Transport, render, trace_pixel,
};

use crate::trace_log::{EXAMPLE, MIXED, built, nff};
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
    own.into_iter().chain(nff)
}

fn on<T>(
    scene: &Scene,
    transport: Transport,
    work: impl Fn(&Tracer<'_, Exhaustive<'_>>) -> T,
) -> T {
    let strategy = Exhaustive::new(scene);
    work(&Tracer {
        scene,
        strategy: &strategy,
        transport,
    })
}

fn bits(colour: DVec3) -> [u64; 3] {
    colour.to_array().map(f64::to_bits)
}

/// The colours of all pixels, one after the other.
fn pixel_by_pixel<R: Recorder>(scene: &Scene, through: Through, recorder: &mut R) -> Vec<[u64; 3]> {
    let strategy = Exhaustive::new(scene);
    let tracer = Tracer {
        scene,
        strategy: &strategy,
        transport: Transport::HybridLight,
    };
    let [width, height] = scene.camera.pixels;
    (0..height)
        .flat_map(|y| (0..width).map(move |x| [x, y]))
        .map(|pixel| bits(trace_pixel(&tracer, pixel, through, recorder)))
        .collect()
}

/// The colours of a picture.
fn picture<R: Recorder + Default + Send>(scene: &Scene, through: Through) -> Vec<[u64; 3]> {
    let (picture, _) = on(scene, Transport::HybridLight, |tracer| {
        render::<_, R>(tracer, through, |_| {})
    });
    picture.colours.into_iter().map(bits).collect()
}

/// Hears everything and keeps nothing.
#[derive(Default)]
struct Forgets;

impl raystep::Sink for Forgets {
    fn record(&mut self, _: &Record) {}
}

#[track_caller]
fn check_same(scene: &Scene, what: &str, expected: &[[u64; 3]], found: &[[u64; 3]]) {
    assert_eq!(expected.len(), found.len());
    let first = expected.iter().zip(found).position(|(a, b)| a != b);
    assert_eq!(
        first, None,
        "{}: {what}: the first pixel that differs",
        scene.name
    );
}

#[test]
fn no_recorder_changes_a_bit_of_a_picture() {
    for through in [Through::Centres, Through::Corners] {
        for scene in scenes(24) {
            let expected = picture::<Off>(&scene, through);
            let colours = pixel_by_pixel(&scene, through, &mut Off);
            check_same(&scene, "pixel by pixel", &expected, &colours);
            let colours = picture::<Counts>(&scene, through);
            check_same(&scene, "Counts", &expected, &colours);
            let colours = picture::<Recording<Forgets>>(&scene, through);
            check_same(&scene, "Recording", &expected, &colours);
            let mut pair = ((Counts::default(), Off), Recording::new(Forgets));
            let colours = pixel_by_pixel(&scene, through, &mut pair);
            check_same(&scene, "a pair", &expected, &colours);
        }
    }
}

#[test]
fn a_pair_hears_what_each_of_it_hears_alone() {
    for scene in scenes(12) {
        let mut alone = Counts::default();
        pixel_by_pixel(&scene, Through::Centres, &mut alone);
        let mut pair = (Recording::new(Sums::default()), Counts::default());
        pixel_by_pixel(&scene, Through::Centres, &mut pair);
        assert_eq!(alone, pair.1, "{}", scene.name);
    }
}

#[test]
fn counts_are_those_of_the_events_and_those_of_the_rays_ends() {
    for through in [Through::Centres, Through::Corners] {
        for scene in scenes(16) {
            let mut pair = (Counts::default(), Recording::new(Sums::default()));
            pixel_by_pixel(&scene, through, &mut pair);
            let (counts, sums) = (pair.0, pair.1.into_sink());
            sums.check(&scene.name, &counts);
        }
    }
}

#[test]
fn scan_lines_counts_add_up_to_those_of_the_picture() {
    for scene in scenes(16) {
        let mut whole = Counts::default();
        pixel_by_pixel(&scene, Through::Centres, &mut whole);
        let (_, lines) = on(&scene, Transport::HybridLight, |tracer| {
            render::<_, Counts>(tracer, Through::Centres, |_| {})
        });
        let mut sum = Counts::default();
        for line in &lines {
            sum.add(line);
        }
        assert_eq!(sum.rays, whole.rays, "{}", scene.name);
        assert_eq!(sum.tests, whole.tests, "{}", scene.name);
        // corners are shared: 17 × 17 eye rays for 16 × 16 pixels
        let (_, lines) = on(&scene, Transport::HybridLight, |tracer| {
            render::<_, Counts>(tracer, Through::Corners, |_| {})
        });
        let eye: u64 = lines.iter().map(|line| line.of(Purpose::Eye).traced).sum();
        assert_eq!(eye, 17 * 17);
    }
}

#[test]
fn each_ray_and_each_colour_follows_from_the_events_before_it() {
    for (through, side) in [(Through::Centres, 24), (Through::Corners, 10)] {
        for scene in scenes(side) {
            for transport in [Transport::HybridLight, Transport::Backward] {
                let settings = Settings {
                    through,
                    transport,
                    ..Settings::default()
                };
                check_pixels(&scene, &settings);
            }
        }
    }
}

fn check_pixels(scene: &Scene, settings: &Settings) {
    let [width, height] = scene.camera.pixels;
    on(scene, settings.transport, |tracer| {
        let mut recording = Recording::new(Vec::new());
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            let colour = trace_pixel(tracer, pixel, settings.through, &mut recording);
            let records = std::mem::take(recording.sink_mut());
            sums::check_pixel(scene, pixel, &records);
            let Some(Event::PixelColour(last)) = records.last().map(|record| record.event) else {
                panic!("the last event of {pixel:?} is no colour");
            };
            assert_eq!(bits(last.raw), bits(colour));
        }
    });
}
