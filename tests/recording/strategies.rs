//! Every strategy paints the same picture, and its counts are those of its log.

use raystep::trace::Region;
use raystep::tracer::{Picture, render, write_log};
use raystep::{Counts, LogReader, Off, Recorder, Scene, Settings, StrategyName, Through};

use super::{name, on, scenes, ways, ways_through};
use crate::trace_log::{all_of, strategy, tracer};

fn picture(scene: &Scene, settings: &Settings) -> Picture {
    on(scene, settings, |tracer| {
        render::<_, Off>(tracer, settings.through, |_| {})
            .unwrap()
            .0
    })
}

#[test]
fn every_strategy_paints_the_picture_of_the_exhaustive_one() {
    let mut rounded_otherwise = 0;
    for (through, side) in [(Through::Centres, 64), (Through::Corners, 24)] {
        for scene in scenes(side) {
            let exhaustive = Settings {
                through,
                ..Settings::default()
            };
            let expected = picture(&scene, &exhaustive);
            for way in ways_through(through) {
                let name = name(&scene, &way);
                let found = picture(&scene, &way);
                if way.strategy == StrategyName::ZAligned {
                    // its t is rounded in another frame
                    rounded_otherwise += differing(&name, &expected, &found);
                } else {
                    assert_eq!(expected.bytes(), found.bytes(), "{name}");
                    assert_eq!(expected.colours, found.colours, "{name}");
                }
            }
        }
    }
    assert_eq!(rounded_otherwise, 0, "pixels differ by a step of 255");
}

/// How many pixels differ, each channel by one step of 255 at most.
#[track_caller]
fn differing(name: &str, expected: &Picture, found: &Picture) -> usize {
    let (expected, found) = (expected.bytes(), found.bytes());
    assert_eq!(expected.len(), found.len(), "{name}");
    let far = expected
        .iter()
        .zip(&found)
        .find(|(a, b)| 1 < a.abs_diff(**b));
    assert_eq!(far, None, "{name}: more than a step");
    let pixels = expected.chunks(3).zip(found.chunks(3));
    pixels.filter(|(a, b)| a != b).count()
}

#[test]
fn one_sided_pictures_are_the_same_as_well() {
    for scene in scenes(16).map(Scene::one_sided) {
        let expected = picture(&scene, &Settings::default());
        for way in ways() {
            let found = picture(&scene, &way);
            let name = name(&scene, &way);
            if way.strategy == StrategyName::ZAligned {
                assert_eq!(differing(&name, &expected, &found), 0, "{name}");
            } else {
                assert_eq!(expected.bytes(), found.bytes(), "{name}");
            }
        }
    }
}

#[test]
fn counts_of_a_trace_are_those_of_its_log() {
    for (through, side) in [(Through::Centres, 4), (Through::Corners, 1)] {
        for scene in scenes(side) {
            for way in ways_through(through) {
                let name = name(&scene, &way);
                let strategy = strategy(&scene, &way);
                let tracer = tracer(&scene, &strategy, &way);
                let mut bytes = Vec::new();
                let options = all_of(Region::whole(scene.camera.pixels));
                let traced = write_log::<_, Counts>(&tracer, &way, &options, &mut bytes, |_| {});
                let traced = traced.unwrap();
                let mut read = Counts::default();
                for record in LogReader::open(&name, &*bytes).unwrap() {
                    let event = record.unwrap().event;
                    read.note(|| event);
                }
                assert_eq!(traced.rays, read.rays, "{name}");
                assert_eq!(traced.tests, read.tests, "{name}");
                assert_eq!(traced.search, read.search, "{name}");
            }
        }
    }
}
