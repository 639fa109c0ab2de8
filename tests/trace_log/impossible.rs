//! Logs that name what cannot be there: the message says what there is.

use raystep::structure::GridOptions;
use raystep::trace::Region;
use raystep::{LogReader, Record, Settings, StrategyName, StructureOptions};

use super::{all_of, built, log};

/// Two balls ahead of the eye, one behind the other.
const SCENE: &str = r#"{
  "camera": { "look_at": { "cop": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 20 },
              "pixels": [1, 1] },
  "materials": { "red": { "colour": [1, 0, 0] } },
  "objects": [
    { "name": "near", "material": "red", "shape": { "sphere": { "center": [0, 0, 3], "radius": 1 } } },
    { "name": "far", "material": "red", "shape": { "sphere": { "center": [0, 0, -3], "radius": 1 } } }
  ]
}"#;

/// The log of its pixel with this strategy, the building with it.
fn of(strategy: StrategyName, resolution: Option<[u32; 3]>) -> String {
    let settings = Settings {
        strategy,
        building: true,
        structure: StructureOptions {
            grid: GridOptions {
                resolution,
                ..GridOptions::default()
            },
            ..StructureOptions::default()
        },
        ..Settings::default()
    };
    let bytes = log(&built(SCENE), &settings, &all_of(Region::pixel([0, 0])));
    String::from_utf8(bytes).unwrap()
}

/// What the reader says to a log in whose first line of a kind something is changed.
#[track_caller]
fn check(good: &str, kind: &str, from: &str, to: &str, what: &str) {
    let read = |text: &str| {
        let reader = LogReader::open("a.jsonl", text.as_bytes());
        reader.and_then(Iterator::collect::<Result<Vec<Record>, _>>)
    };
    assert!(read(good).is_ok(), "the log is good before it is changed");
    let start = format!("{{\"kind\":\"{kind}\"");
    let mut lines: Vec<String> = good.lines().map(|line| format!("{line}\n")).collect();
    let at = lines
        .iter()
        .position(|line| line.starts_with(&start))
        .unwrap();
    let changed = lines[at].replacen(from, to, 1);
    assert_ne!(changed, lines[at], "{from} is not in {changed}");
    lines[at] = changed;
    let error = read(&lines.concat()).unwrap_err().to_string();
    let expected = format!(
        "a.jsonl, line {}: {what}\n  the log is damaged: make it again",
        at + 1
    );
    assert_eq!(error, expected);
}

#[test]
fn a_node_beyond_those_that_a_tree_over_the_objects_can_have_is_told() {
    let log = of(StrategyName::Heap, None);
    // two leaves and the root above them: 0, 1 and 2
    let what = "there is no node 4: a hierarchy over 2 objects has fewer than 4";
    check(&log, "merge", "\"node\":0", "\"node\":4", what);
    check(&log, "merge", "\"first\":1", "\"first\":4", what);
    check(&log, "merge", "\"second\":2", "\"second\":4", what);
    for kind in ["slab_test", "bound_test", "node", "queue"] {
        check(&log, kind, "\"node\":0", "\"node\":4", what);
    }
}

#[test]
fn a_slab_beyond_the_set_is_told() {
    let log = of(StrategyName::Hierarchy, None);
    let what = "there is no slab 3: the set has 3";
    check(&log, "merge", "\"slab\":0", "\"slab\":3", what);
    check(&log, "slab_test", "\"slab\":0", "\"slab\":3", what);
}

#[test]
fn more_objects_than_the_scene_has_are_told() {
    let log = of(StrategyName::Grid, None);
    let what = "\"listed\" is 3, and the scene has 2 objects";
    check(&log, "cell", "\"listed\":1", "\"listed\":3", what);
    let log = of(StrategyName::ZAligned, None);
    let what = "\"place\" is 2, and no more than 2 objects can be hit";
    check(&log, "z_sort", "\"place\":0", "\"place\":2", what);
}

#[test]
fn a_cell_beyond_the_resolution_is_told() {
    // ∛(3·2/(2·2·8)) = 0.572 cells for each unit of length: 1.14, 1.14 and 4.6
    for resolution in [None, Some([1, 1, 5])] {
        let log = of(StrategyName::Grid, resolution);
        let what = "there is no cell [0, 0, 7]: the grid has [1, 1, 5]";
        for kind in ["grid_enter", "cell"] {
            check(&log, kind, "\"cell\":[0,0,4]", "\"cell\":[0,0,7]", what);
        }
        if resolution.is_some() {
            check(&log, "assign", "\"cell\":[0,0,3]", "\"cell\":[0,0,7]", what);
        }
    }
}

#[test]
fn grids_that_differ_are_told() {
    let log = of(StrategyName::Grid, Some([1, 1, 5]));
    let what = "the grid has [1, 1, 5] cells";
    check(&log, "grid_enter", "[1,1,5]", "[1,2,5]", what);
}

#[test]
fn a_pixel_beyond_the_picture_is_told() {
    let log = of(StrategyName::Exhaustive, None);
    let what = "there is no pixel [1,0] in a picture of 1 × 1";
    check(&log, "pixel", "\"pixel\":[0,0]", "\"pixel\":[1,0]", what);
}
