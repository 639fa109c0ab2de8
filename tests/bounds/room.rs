//! The room for rounding that bounds have: the log has what decided, the words have the bound itself.

use std::path::Path;

use raystep::explain::render;
use raystep::geometry::TRange;
use raystep::scene::Loaded;
use raystep::structure::{Build, SlabChoice, VolumeKind};
use raystep::trace::{BoundVerdict, Kind};
use raystep::tracer::trace_pixel;
use raystep::{
    Chosen, Event, NoFiles, Record, Recording, Scene, Settings, StrategyName, StructureOptions,
    Through, Tracer, Transport, WorkedOptions, load, load_bytes, worked_solution,
};
use serde_json::json;

/// A box from 9 to 10 along each axis, seen along −x: the shadow ray starts on its face x = 10, and runs away from it.
fn on_a_face() -> Scene {
    let scene = json!({
        "camera": {
            "window": { "cop": [14, 9.5, 9.5], "corner": [13, 9.25, 9.75], "right": [0, 0, -0.5], "up": [0, 0.5, 0] },
            "pixels": [1, 1]
        },
        "lights": [{ "position": [14, 14, 13], "colour": [1, 1, 1] }],
        "materials": { "m": { "colour": [1, 1, 1], "diffuse": 1 } },
        "objects": [{ "name": "B", "material": "m", "shape": { "box": { "min": [9, 9, 9], "max": [10, 10, 10] } } }]
    });
    let loaded = load_bytes("scene.json", scene.to_string().as_bytes(), &NoFiles);
    loaded.and_then(Loaded::build).unwrap()
}

fn settings(strategy: StrategyName, volume: VolumeKind, slabs: SlabChoice) -> Settings {
    Settings {
        strategy,
        structure: StructureOptions {
            volume,
            slabs,
            build: Build::BottomUp,
            ..StructureOptions::default()
        },
        ..Settings::default()
    }
}

/// With every kind of bound.
fn with_bounds() -> Vec<Settings> {
    use SlabChoice::{Axes, Seven};
    use StrategyName::{Bounds, Heap, Hierarchy};
    vec![
        settings(Hierarchy, VolumeKind::Box, Axes),
        settings(Hierarchy, VolumeKind::Box, Seven),
        settings(Heap, VolumeKind::Box, Axes),
        settings(Bounds, VolumeKind::Box, Axes),
        settings(Bounds, VolumeKind::Slabs, Seven),
        settings(Bounds, VolumeKind::Sphere, Axes),
        settings(Bounds, VolumeKind::Ellipsoid, Axes),
    ]
}

fn traced(scene: &Scene, settings: &Settings, pixel: [u32; 2]) -> Vec<Record> {
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure).unwrap();
    let tracer = Tracer::new(scene, &strategy, Transport::HybridLight);
    let mut recording = Recording::new(Vec::new());
    trace_pixel(&tracer, pixel, Through::Centres, &mut recording).unwrap();
    recording.into_sink()
}

fn worked(scene: &Scene, settings: &Settings, records: &[Record]) -> String {
    let options = WorkedOptions {
        all: true,
        ..WorkedOptions::default()
    };
    let page = worked_solution(scene, settings, records, &options);
    render::plain(&page, render::no_hint)
}

/// What follows from the near and the far t in the log, for a ray that counts in this range.
fn follows(near_and_far: Option<[f64; 2]>, range: TRange) -> BoundVerdict {
    match near_and_far {
        None => BoundVerdict::Missed,
        Some([_, far]) if far < range.min => BoundVerdict::Behind,
        Some([near, _]) if range.max < near => BoundVerdict::Beyond,
        Some(_) => BoundVerdict::Hit,
    }
}

#[test]
fn a_bound_that_is_told_as_met_is_met_where_t_counts() {
    // it was told as met from t = −0.774 to t = 10⁻¹⁵, before the first t that counts
    let scene = on_a_face();
    for settings in with_bounds() {
        let records = traced(&scene, &settings, [0, 0]);
        let mut range = TRange::FORWARD;
        let mut tests = 0;
        for record in &records {
            match record.event {
                Event::Ray(start) => range = start.range,
                Event::Nearest(nearest) => range = range.up_to(nearest.t),
                Event::BoundTest(test) => {
                    tests += 1;
                    assert_eq!(
                        test.verdict,
                        follows(test.inside, range),
                        "{test:?} {range:?}"
                    );
                    assert!(0.0 < test.room && test.room < 1e-7, "{test:?}");
                }
                _ => {}
            }
        }
        // the eye ray and the shadow ray
        assert_eq!(tests, 2, "{settings:?}");
    }
}

#[test]
fn near_and_far_of_a_slab_have_its_room_in_them() {
    let scene = on_a_face();
    let settings = settings(StrategyName::Hierarchy, VolumeKind::Box, SlabChoice::Axes);
    let mut slabs = 0;
    // S and T of the ray and each slab come before its tests
    let mut lines = Vec::new();
    for record in traced(&scene, &settings, [0, 0]) {
        let test = match record.event {
            Event::Ray(_) => {
                lines.clear();
                continue;
            }
            Event::SlabRay(line) => {
                lines.push(line);
                continue;
            }
            Event::SlabTest(test) => test,
            _ => continue,
        };
        let line = lines[test.step.slab as usize];
        let step = test.step;
        // as the objects have it: 9 … 10
        assert_eq!((step.d_min, step.d_max), (-10.0, -9.0));
        // 2·10⁻¹⁰ of |x₀| + |y₀| + |z₀|, at the eye and in the middle of the face, and 3·10⁻¹⁰ of the largest
        // coordinate, which is 10
        let from = if record.ray == Some(0) { 33.0 } else { 29.0 };
        assert!((line.room - (2e-10 * from + 3e-9)).abs() <= 1e-20);
        if line.t_scale.is_finite() {
            slabs += 1;
            let planes = [(-line.room, step.d_min), (line.room, step.d_max)];
            let t = planes.map(|(room, d)| (line.s + room + d) * line.t_scale);
            let raystep::geometry::SlabInterval::Between { near, far } = step.interval else {
                panic!("{step:?}");
            };
            assert_eq!((near, far), (t[0].min(t[1]), t[0].max(t[1])));
        }
    }
    assert_eq!(slabs, 4, "one of the eye ray, three of the shadow ray");
}

#[test]
fn where_the_room_alone_decides_one_line_says_so_and_the_numbers_are_those_of_the_bound() {
    let scene = on_a_face();
    let settings = settings(StrategyName::Hierarchy, VolumeKind::Box, SlabChoice::Axes);
    let text = worked(&scene, &settings, &traced(&scene, &settings, [0, 0]));
    // Δ = (4, 4.5, 3.5)/√48.5 = (0.574367, 0.646162, 0.502571); y = 9 at t = −0.5/0.646162; the room is
    // 2·10⁻¹⁰·29 + 3·10⁻⁹
    for line in [
        "bounding volume of node 0 (slabs): hit, inside for t in [4, 5], so the node can be entered",
        "interval: max near −0.773799 ≤ min far 0 so far",
        "bounding volume of node 0 (slabs): ends at t = 0, before the t that count, but by less than its padding, \
         8.8e-9, so the node can be entered",
    ] {
        assert!(text.contains(line), "{line:?} is not in\n{text}");
    }
}

/// The numbers of a line, as they are printed.
fn numbers(line: &str) -> impl Iterator<Item = &str> {
    line.split([' ', ',', ';', ':', '(', ')', '[', ']', '−'])
        .filter(|word| word.parse::<f64>().is_ok())
}

#[test]
fn no_number_in_words_is_room_for_rounding() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let scenes = [
        "10-bounds/two.json",
        "11-hierarchy/scene.json",
        "12-grid/scene.json",
    ];
    let scenes = scenes.map(|name| load(&folder.join(name)).and_then(Loaded::build).unwrap());
    let grid = settings(StrategyName::Grid, VolumeKind::Box, SlabChoice::Axes);
    for scene in scenes.iter().chain([&on_a_face()]) {
        let [width, height] = scene.camera.pixels;
        for settings in with_bounds().into_iter().chain([grid.clone()]) {
            for pixel in [[width / 2, height / 2], [width / 3, height / 3]] {
                let records = traced(scene, &settings, pixel);
                let text = worked(scene, &settings, &records);
                // t begins to count at the ray's ε, which has a line of its own: a cell or a key may begin there too
                let epsilons: Vec<&str> = text
                    .lines()
                    .filter(|line| line.contains('ε'))
                    .flat_map(numbers)
                    .collect();
                for line in text.lines() {
                    // room is named where it decides, and once for the whole page
                    if line.contains("1e-10 of the coordinates") || line.contains("its padding") {
                        continue;
                    }
                    // a term of the shade may be as small as it likes
                    const OF_VOLUMES: [&str; 8] = [
                        "slab", "near", "D_min", "interval", "grid", "cell", "box", "node",
                    ];
                    if !OF_VOLUMES.iter().any(|word| line.contains(word)) {
                        continue;
                    }
                    for number in numbers(line).filter(|number| !epsilons.contains(number)) {
                        for power in ["e-8", "e-9", "e-10"] {
                            assert!(!number.ends_with(power), "{line}\n{settings:?}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn a_grid_is_told_around_its_objects() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/12-grid/scene.json");
    let scene = load(&path).and_then(Loaded::build).unwrap();
    let settings = settings(StrategyName::Grid, VolumeKind::Box, SlabChoice::Axes);
    let text = worked(&scene, &settings, &traced(&scene, &settings, [0, 0]));
    // the planes themselves lie 10⁻⁸ further out
    let line = "grid of 8 × 1 × 5 cells from (0, 0, 0) to (8, 1, 5)";
    assert!(text.contains(line), "{line} is not in\n{text}");
}

#[test]
fn a_log_without_slabs_says_the_same_of_its_bounds() {
    let scene = on_a_face();
    for settings in with_bounds() {
        let records = traced(&scene, &settings, [0, 0]);
        let of_bounds = |records: &[Record]| {
            let text = worked(&scene, &settings, records);
            let lines = text
                .lines()
                .filter(|line| line.trim_start().starts_with("bounding volume of"));
            lines.map(String::from).collect::<Vec<_>>()
        };
        let is_kept = |record: &&Record| record.event.kind() != Kind::SlabTest;
        let fewer: Vec<Record> = records.iter().filter(is_kept).copied().collect();
        assert_eq!(of_bounds(&fewer), of_bounds(&records), "{settings:?}");
        assert!(!of_bounds(&fewer).is_empty(), "{settings:?}");
    }
}
