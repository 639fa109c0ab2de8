//! Logs of every strategy: with the steps of its search, and with the building before the first pixel.

use raystep::geometry::SlabInterval;
use raystep::structure::{Build, GridOptions, Lists, SlabChoice, VolumeKind};
use raystep::trace::{Kind, LineSink, LogNames, QueueAction, Region, Sink, write_log_head};
use raystep::{
    Event, LogReader, Recording, Scene, Settings, StrategyName, StructureOptions, Through,
    WorkedOptions,
};

use crate::worked_solution::worked_text;

use super::{EXAMPLE, MIXED, all_of, built, check_same, log, pixels_of, records};

/// Every strategy with every kind of structure.
pub(crate) fn ways() -> Vec<Settings> {
    let usual = StructureOptions::default();
    let bounds = |volume, slabs| {
        let structure = StructureOptions {
            volume,
            slabs,
            ..usual
        };
        (StrategyName::Bounds, structure)
    };
    let tree = |name, slabs, build| {
        let structure = StructureOptions {
            slabs,
            build,
            ..usual
        };
        (name, structure)
    };
    let grid = |grid| (StrategyName::Grid, StructureOptions { grid, ..usual });
    let (axes, seven, own) = (SlabChoice::Axes, SlabChoice::Seven, SlabChoice::Scene);
    let (hierarchy, heap) = (StrategyName::Hierarchy, StrategyName::Heap);
    let cells = GridOptions::default();
    [
        (StrategyName::Exhaustive, usual),
        bounds(VolumeKind::Sphere, axes),
        bounds(VolumeKind::Ellipsoid, axes),
        bounds(VolumeKind::Box, axes),
        bounds(VolumeKind::Slabs, own),
        tree(hierarchy, axes, Build::BottomUp),
        tree(hierarchy, seven, Build::SurfaceArea),
        tree(hierarchy, own, Build::Insertion),
        tree(heap, axes, Build::Insertion),
        tree(heap, own, Build::SurfaceArea),
        grid(cells),
        grid(GridOptions {
            resolution: Some([4, 3, 5]),
            lists: Lists::Boxes,
            mailboxes: false,
            ..cells
        }),
        (StrategyName::ZAligned, usual),
    ]
    .into_iter()
    .map(|(strategy, structure)| Settings {
        strategy,
        structure,
        ..Settings::default()
    })
    .collect()
}

/// A scene with the slabs of its own that [`ways`] asks for.
pub(crate) fn with_slabs(mut scene: Scene) -> Scene {
    let slabs = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.5],
        [0.0, -0.5, 1.0],
        [1.0, 1.0, 1.0],
    ];
    scene.slabs = Some(slabs.map(Into::into).to_vec());
    scene
}

/// A ball ahead of the eye, and one beside it: the ray through the middle runs along z, parallel to the slabs
/// of both across x and y.
const ALONG_Z: &str = r#"{
  "name": "along z",
  "camera": { "window": { "cop": [0, 0, 5], "corner": [-1, -1, 4], "right": [2, 0, 0], "up": [0, 2, 0] },
              "pixels": [1, 1] },
  "lights": [ { "name": "lamp", "position": [0, 5, 5], "colour": [1, 1, 1] } ],
  "materials": { "red": { "colour": [1, 0, 0], "diffuse": 0.5 } },
  "objects": [
    { "name": "ahead", "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } },
    { "name": "beside", "material": "red", "shape": { "sphere": { "center": [0, 4, 0], "radius": 1 } } }
  ]
}"#;

/// Every strategy through a few pixels: where ball and floor lie behind one another, of mirrors and glass
/// through the corners, and along z.
pub(super) fn cases() -> Vec<(Scene, Settings, Region)> {
    let example = with_slabs(built(EXAMPLE));
    let mixed = with_slabs(built(MIXED));
    let along = with_slabs(built(ALONG_Z));
    let mut cases = Vec::new();
    for way in ways() {
        let corners = Settings {
            through: Through::Corners,
            ..way.clone()
        };
        let region = |text: &str| text.parse::<Region>().unwrap();
        cases.push((example.clone(), way.clone(), region("79,76-81,77")));
        cases.push((mixed.clone(), corners, region("4,3-5,4")));
        cases.push((along.clone(), way, region("0,0")));
    }
    cases
}

/// Those of them that build something, in one pixel each; the two balls along z may share a leaf.
pub(crate) fn built_cases() -> impl Iterator<Item = (Scene, Settings, [u32; 2])> {
    let builds = |settings: &Settings| {
        use StrategyName::{Grid, Heap, Hierarchy};
        [Hierarchy, Heap, Grid].contains(&settings.strategy)
    };
    let of_builds = cases()
        .into_iter()
        .filter(move |(scene, settings, _)| builds(settings) && scene.name != "along z");
    of_builds.map(|(scene, settings, region)| {
        let building = true;
        (
            scene,
            Settings {
                building,
                ..settings
            },
            region.from,
        )
    })
}

/// The log of one pixel with what was built before it, line by line as a sink makes it.
pub(crate) fn log_with_building(scene: &Scene, settings: &Settings, pixel: [u32; 2]) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_log_head(scene, settings, &mut bytes).unwrap();
    let names = LogNames::new(scene);
    let mut sink = LineSink::new(&names);
    for record in records(scene, settings, pixel) {
        assert!(sink.record(&record).is_continue());
    }
    bytes.extend(sink.lines);
    bytes
}

#[test]
fn the_cases_hold_what_is_rare() {
    let (mut stops, mut parallel, mut outside, mut saved) = (0, [0, 0], 0, 0);
    for (scene, settings, region) in cases() {
        for pixel in pixels_of(region) {
            for record in records(&scene, &settings, pixel) {
                match record.event {
                    Event::Queue(step) => stops += u32::from(step.action == QueueAction::Stop),
                    Event::SlabTest(test) => match test.step.interval {
                        SlabInterval::ParallelInside => parallel[0] += 1,
                        SlabInterval::ParallelOutside => parallel[1] += 1,
                        SlabInterval::Between { .. } => {}
                    },
                    Event::HitOutsideCell(_) => outside += 1,
                    Event::Mailbox { .. } => saved += 1,
                    _ => {}
                }
            }
        }
    }
    let [inside, beside] = parallel;
    for (what, found) in [
        ("heap stops", stops),
        ("rays parallel inside a slab", inside),
        ("rays parallel outside a slab", beside),
        ("hits beyond their cell", outside),
        ("objects saved by their mailbox", saved),
    ] {
        assert!(0 < found, "no {what}");
    }
}

#[test]
fn what_was_built_reads_back_as_the_same_records_and_the_same_text() {
    for (scene, settings, pixel) in built_cases() {
        let what = format!("{} {:?}", scene.name, settings.strategy);
        let traced = records(&scene, &settings, pixel);
        let bytes = log_with_building(&scene, &settings, pixel);
        let log = LogReader::open("a.jsonl", &*bytes).unwrap();
        let (read_scene, read_settings, read) = log.pixel(pixel).unwrap();
        check_same(&what, &settings, &read_settings);
        check_same(&what, &traced, &read);
        for all in [false, true] {
            let options = WorkedOptions {
                all,
                ..WorkedOptions::default()
            };
            let memory = worked_text(&scene, &settings, &traced, &options);
            let file = worked_text(&read_scene, &read_settings, &read, &options);
            assert!(memory == file, "{what}");
            assert!(memory.contains("Building, before the first ray"), "{what}");
        }
    }
}

#[test]
fn what_was_built_comes_before_the_pixel_and_belongs_to_none() {
    for (scene, settings, pixel) in built_cases() {
        let traced = records(&scene, &settings, pixel);
        let begins = |kind| traced.iter().position(|record| record.event.kind() == kind);
        let first = begins(Kind::Pixel).unwrap();
        assert!(0 < first, "{}: nothing was built", scene.name);
        for (place, record) in traced.iter().enumerate() {
            let of_building = record.event.kind().is_of_building();
            assert_eq!(of_building, place < first, "{record:?}");
            assert_eq!(record.pixel.is_none(), of_building, "{record:?}");
            if of_building {
                assert_eq!((record.step as usize, record.ray), (place, None));
            }
        }
        let bytes = log_with_building(&scene, &settings, pixel);
        let text = String::from_utf8(bytes).unwrap();
        for line in text.lines() {
            let building =
                line.starts_with(r#"{"kind":"merge""#) || line.starts_with(r#"{"kind":"assign""#);
            assert!(!(building && line.contains("\"pixel\"")), "{line}");
        }
    }
}

#[test]
fn the_building_is_left_out_where_it_is_not_asked_for() {
    for (scene, settings, pixel) in built_cases() {
        let settings = Settings {
            building: false,
            ..settings
        };
        let by_hand = log_with_building(&scene, &settings, pixel);
        let written = log(&scene, &settings, &all_of(Region::pixel(pixel)));
        assert!(by_hand == written, "{}", scene.name);
    }
}

#[test]
fn a_line_of_the_building_that_was_lost_is_told() {
    let (scene, settings, pixel) = built_cases().next().unwrap();
    let text = String::from_utf8(log_with_building(&scene, &settings, pixel)).unwrap();
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    let second = lines
        .iter()
        .position(|line| line.contains("\"step\":1,"))
        .unwrap();
    lines.remove(second);
    let log = lines.concat();
    let error = LogReader::open("a.jsonl", log.as_bytes())
        .and_then(Iterator::collect::<Result<Vec<_>, _>>)
        .unwrap_err()
        .to_string();
    let expected = "step 1 is missing: a line is lost or in the wrong place";
    assert!(error.contains(expected), "{error}");
}

#[test]
fn a_second_pixel_after_a_building_begins_again_at_0() {
    let (scene, settings, pixel) = built_cases().next().unwrap();
    let strategy = super::strategy(&scene, &settings);
    let tracer = super::tracer(&scene, &strategy, &settings);
    let mut recording = Recording::new(Vec::new());
    raystep::strategy::Strategy::note_building(&strategy, &mut recording);
    for _ in 0..2 {
        raystep::tracer::trace_pixel(&tracer, pixel, settings.through, &mut recording).unwrap();
    }
    let all = recording.into_sink();
    let starts = all
        .iter()
        .filter(|record| record.event.kind() == Kind::Pixel);
    let steps: Vec<_> = starts.map(|record| (record.step, record.pixel)).collect();
    assert_eq!(steps, [(0, Some(pixel)); 2]);
}

#[test]
fn after_a_slab_that_the_ray_is_parallel_to_and_outside_of_no_more_are_told() {
    // a further slab was told after the line that says that no more are looked at
    let mut outside = 0;
    for (scene, settings, region) in cases() {
        for pixel in pixels_of(region) {
            let records = records(&scene, &settings, pixel);
            for pair in records.windows(2) {
                let Event::SlabTest(test) = pair[0].event else {
                    continue;
                };
                if test.step.interval == SlabInterval::ParallelOutside {
                    outside += 1;
                    let next = pair[1].event;
                    assert!(
                        matches!(next, Event::BoundTest(bound) if bound.inside.is_none()),
                        "{next:?}"
                    );
                }
            }
        }
    }
    assert!(0 < outside);
}
