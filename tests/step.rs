//! A log as a tree of steps: small logs by hand, and what must hold of every log, over the scenes of all lessons and random
//! ones, with every strategy and every transport.

mod by_hand;
mod drawn;
mod filtered;
mod moves;
mod questions;
mod state;
mod targets;
mod walks;
mod words;

use raystep::scene::SceneFile;
use raystep::step::StepLog;
use raystep::{Record, Scene, Settings, StrategyName, Through};
use serde_json::json;

use crate::seeded::Seeded;
use crate::strategies::random_scene;
use crate::worked_solution::ranges::{all_settings, scenes, traced};

pub(crate) const STRATEGIES: [StrategyName; 6] = [
    StrategyName::Exhaustive,
    StrategyName::Bounds,
    StrategyName::Hierarchy,
    StrategyName::Heap,
    StrategyName::Grid,
    StrategyName::ZAligned,
];

/// Calls with the log of each of two pixels of all lessons' scenes, under every strategy and every transport. Returns how
/// many logs there were.
fn each_lesson(mut check: impl FnMut(&str, &StepLog)) -> usize {
    let mut logs = 0;
    for (name, scene, pixels) in scenes() {
        for settings in all_settings(&scene) {
            for &pixel in &pixels {
                let records = traced(&scene, &settings, pixel);
                let (strategy, transport) = (settings.strategy, settings.transport);
                let name = format!("{name} {pixel:?} {strategy:?} {transport:?}");
                check(&name, &StepLog::new(&scene, &settings, &records));
                logs += 1;
            }
        }
    }
    logs
}

/// The same with random scenes, which have lamps, mirrors and glass, through the centres and the corners of their pixels.
fn each_random(mut check: impl FnMut(&str, &StepLog)) -> usize {
    let mut random = Seeded::new(11);
    let mut logs = 0;
    for seed in 0..40 {
        let mut file = random_scene(seed, seed % 2 == 0);
        file["materials"]["grey"] = json!({
            "colour": [0.5, 0.5, 0.5], "diffuse": 0.6, "reflection": 0.3, "transmission": 0.2, "index": 1.5
        });
        file["lights"] = json!([
            { "name": "lamp", "position": [3, 9, 4], "colour": [1, 1, 1] },
            { "name": "spot", "position": [-4, 2, 7], "colour": [0.5, 0.5, 0] }
        ]);
        file["max_depth"] = 3.into();
        let Ok(scene) = Scene::new(serde_json::from_value::<SceneFile>(file).unwrap()) else {
            continue;
        };
        for strategy in STRATEGIES {
            let through = if random.index(4) == 0 {
                Through::Corners
            } else {
                Through::Centres
            };
            let settings = Settings {
                strategy,
                through,
                ..Settings::default()
            };
            let pixel = scene.camera.pixels;
            let pixel = pixel.map(|side| random.index(side as usize) as u32);
            let records = traced(&scene, &settings, pixel);
            let name = format!("random scene {seed}, {strategy:?} {pixel:?}");
            check(&name, &StepLog::new(&scene, &settings, &records));
            logs += 1;
        }
    }
    logs
}

/// The logs of small scenes for which more work is done: one pixel of each lesson's scenes, with each strategy once, and each
/// transport.
pub(crate) fn each_of_few(mut check: impl FnMut(&str, &StepLog)) -> usize {
    let mut logs = 0;
    for (name, scene, pixels) in scenes() {
        let mut seen: Vec<(StrategyName, raystep::Transport)> = Vec::new();
        for settings in all_settings(&scene) {
            let key = (settings.strategy, settings.transport);
            if seen.contains(&key) {
                continue;
            }
            seen.push(key);
            let records: Vec<Record> = traced(&scene, &settings, pixels[0]);
            let name = format!("{name} {:?} {key:?}", pixels[0]);
            check(&name, &StepLog::new(&scene, &settings, &records));
            logs += 1;
        }
    }
    logs
}
