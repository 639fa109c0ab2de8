//! Logs of light on its way: what of a whole log belongs to one pixel.

use raystep::explain::pixel_json;
use raystep::trace::{Kinds, PathSieve, Region, Sink};
use raystep::tracer::{LightPass, LogOptions, LoggedPaths, write_log};
use raystep::{
    Chosen, Event, LogReader, Off, Record, Scene, Settings, Tracer, Transport, WorkedOptions,
};

use crate::worked_solution::worked_text;

use crate::worked_solution::light::{GLASS, SCENE, built, records, settings};

const FOLLOWING: [Transport; 3] = [
    Transport::Forward,
    Transport::HybridStored,
    Transport::HybridConnected,
];

/// The whole log, with all paths of light.
fn log(scene: &Scene, settings: &Settings) -> Vec<u8> {
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure).unwrap();
    let pass = LightPass::new(scene, &strategy, settings, None, |Off| {}, |_| {}).unwrap();
    let tracer = Tracer::new(scene, &strategy, settings.transport).with_light(pass.as_ref());
    let pixels = scene.camera.pixels;
    let options = LogOptions {
        region: Region::whole(pixels),
        kinds: Kinds::ALL,
        budget: u64::MAX,
        paths: LoggedPaths::All(settings.light_paths(pixels)),
    };
    let mut bytes = Vec::new();
    write_log::<_, Off>(&tracer, settings, &options, &mut bytes, |_| {}).unwrap();
    bytes
}

/// Scenes, each with every transport that follows light; every fifth pixel.
fn cases() -> Vec<(Scene, Settings, Vec<[u32; 2]>)> {
    let mut cases = Vec::new();
    for text in [SCENE, GLASS] {
        for transport in FOLLOWING {
            let scene = built(text);
            let [width, height] = scene.camera.pixels;
            let pixels = (0..width * height).step_by(5);
            let pixels = pixels.map(|number| [number % width, number / width]);
            let pixels = pixels.collect();
            cases.push((scene, settings(transport), pixels));
        }
    }
    cases
}

#[test]
fn a_whole_log_holds_of_each_pixel_what_tracing_that_pixel_alone_gives() {
    for (scene, settings, pixels) in cases() {
        let bytes = log(&scene, &settings);
        for pixel in pixels {
            let traced = records(&scene, &settings, pixel);
            let reader = LogReader::open("a.jsonl", &*bytes).unwrap();
            let (read_scene, read_settings, read) = reader.pixel(pixel).unwrap();
            let what = format!("{:?} {pixel:?} of {}", settings.transport, scene.name);
            assert!(traced == read, "{what}");
            for all in [false, true] {
                let options = WorkedOptions {
                    all,
                    ..WorkedOptions::default()
                };
                let memory = worked_text(&scene, &settings, &traced, &options);
                let file = worked_text(&read_scene, &read_settings, &read, &options);
                assert!(memory == file, "{what}");
            }
        }
    }
}

#[test]
fn a_log_cut_down_to_a_region_holds_all_that_its_pixels_tell() {
    for (scene, settings, pixels) in cases() {
        let bytes = log(&scene, &settings);
        let width = scene.camera.pixels[0];
        let whole: Vec<Record> = LogReader::open("a.jsonl", &*bytes)
            .unwrap()
            .map(Result::unwrap)
            .collect();
        for pixel in pixels {
            let region = Region::pixel(pixel);
            let mut sieve = PathSieve::new(&settings, width, Some(region), Vec::new());
            for record in &whole {
                assert!(sieve.record(record).is_continue());
            }
            assert!(sieve.finish().is_continue());
            let kept = sieve.sink;
            for record in records(&scene, &settings, pixel) {
                assert!(
                    kept.contains(&record),
                    "{:?} {record:?}",
                    settings.transport
                );
            }
            // and of paths that tell where they led, no other
            if settings.transport == Transport::Forward {
                let arrives = |record: &&Record| match record.event {
                    Event::Arrival(arrival) => arrival.pixel == pixel,
                    _ => false,
                };
                let arrivals = whole.iter().filter(arrives).map(|record| record.path);
                let mut arrivals: Vec<_> = arrivals.collect();
                arrivals.dedup();
                let mut paths: Vec<_> = kept.iter().map(|record| record.path).collect();
                paths.retain(Option::is_some);
                paths.dedup();
                assert_eq!(paths, arrivals);
            }
        }
    }
}

#[test]
fn the_json_of_a_pixel_has_its_paths_beside_its_rays() {
    let scene = built(SCENE);
    let settings = settings(Transport::HybridConnected);
    let records = records(&scene, &settings, [1, 1]);
    let json = pixel_json(&scene, &settings, &records);
    let paths = json["paths"].as_array().unwrap();
    // the pixel's own four: 4·(4·1 + 1) and the next
    let numbers: Vec<u64> = paths
        .iter()
        .map(|path| path["path"].as_u64().unwrap())
        .collect();
    for own in 20..24 {
        assert!(numbers.contains(&own), "{numbers:?}");
    }
    for path in paths {
        assert_eq!(path["events"][0]["kind"], "path");
        assert_eq!(path["rays"][0]["id"], 0);
        assert_eq!(path["rays"][0]["start"]["purpose"], "light");
    }
    assert_eq!(json["pixel"].as_array().unwrap().len(), 2);
    assert_eq!(json["rays"][0]["start"]["purpose"], "eye");
    let connections = json["events"].as_array().unwrap();
    assert!(
        connections
            .iter()
            .any(|event| event["kind"] == "connection")
    );
}
