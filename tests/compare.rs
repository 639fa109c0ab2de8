//! Strategies side by side: the table, JSON and CSV say the same, and what can be counted by hand is right.

mod chart;
mod crowded;
mod heat;
mod not_built;
mod table;
mod transports;

use raystep::explain::{Compared, Comparison, Cost, strategies_to_compare};
use raystep::strategy::Exhaustive;
use raystep::tracer::render;
use raystep::{Counts, NoFiles, Scene, Settings, Through, Tracer, Transport, load_bytes};
use serde_json::Value;

use crate::cli::run::Folder;

/// The scene of the slides' example.
const LESSON: &str = include_str!("../lessons/09-cost/scene.json");

/// One pixel looks along -z at the ball A; the ball B lies ten to the side, far out of its way.
const TWO_BALLS: &str = r#"{
  "name": "two balls",
  "camera": { "window": { "cop": [0, 0, 0], "corner": [-0.01, -0.01, -1], "right": [0.02, 0, 0], "up": [0, 0.02, 0] }, "pixels": [1, 1] },
  "background": [0, 0, 0], "ambient": [1, 1, 1], "lights": [],
  "materials": { "red": { "colour": [1, 0, 0] } },
  "objects": [
    { "name": "A", "material": "red", "shape": { "sphere": { "center": [0, 0, -5], "radius": 1 } } },
    { "name": "B", "material": "red", "shape": { "sphere": { "center": [10, 0, -5], "radius": 1 } } }
  ],
  "max_depth": 1
}"#;

/// Two pixels look down at a square that fills the window.
const SQUARE: &str = r#"{
  "name": "a square, \"quoted\"",
  "camera": { "window": { "cop": [0, 0, 5], "corner": [-0.1, -0.05, 4], "right": [0.2, 0, 0], "up": [0, 0.1, 0] }, "pixels": [2, 1] },
  "background": [0, 0, 0], "ambient": [1, 1, 1], "lights": [],
  "materials": { "red": { "colour": [1, 0, 0] } },
  "objects": [
    { "name": "S", "material": "red", "shape": { "polygon": { "vertices": [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]] } } }
  ],
  "max_depth": 1
}"#;

fn json_of(folder: &Folder, words: &str) -> Value {
    let out = folder.run(&format!("{words} --format json")).well();
    serde_json::from_slice(&out).unwrap()
}

fn text_of(folder: &Folder, words: &str) -> String {
    String::from_utf8(folder.run(words).well()).unwrap()
}

/// The entry of a strategy.
fn entry<'a>(json: &'a Value, name: &str) -> &'a Value {
    let strategies = json["strategies"].as_array().unwrap();
    let found = strategies.iter().find(|entry| entry["name"] == name);
    found.unwrap_or_else(|| panic!("no {name} in {json:#}"))
}

/// Cells of a line of CSV as RFC 4180 has them.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                cells.last_mut().unwrap().push('"');
                letters.next();
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().unwrap().push(letter),
        }
    }
    cells
}

#[test]
fn the_counts_of_two_balls_are_those_counted_by_hand() {
    let folder = Folder::empty().with("s.json", TWO_BALLS);
    let json = json_of(&folder, "compare s.json");
    // one eye ray, nothing sent on: each ball is tested
    let all = entry(&json, "exhaustive");
    let numbers = |entry: &Value| {
        ["rays", "bound_tests", "nodes", "cells", "object_tests"]
            .map(|key| entry[key].as_u64().unwrap())
    };
    assert_eq!(numbers(all), [1, 0, 0, 0, 2]);
    assert_eq!(
        (&all["share_percent"], &all["bytes"]),
        (&100.0.into(), &0.into())
    );
    // the root's box holds both balls: it is met and entered; of its two leaves A's box is met and entered,
    // B's is missed; A alone is tested
    for name in [
        "hierarchy, bottom-up",
        "hierarchy, bottom-up, 7 slabs",
        "heap, bottom-up",
    ] {
        let tree = entry(&json, name);
        assert_eq!(numbers(tree), [1, 3, 2, 0, 1], "{name}");
        assert_eq!(tree["share_percent"], 50.0, "{name}");
        assert_eq!(tree["tests_per_ray"], 1.0, "{name}");
        assert!(0 < tree["bytes"].as_u64().unwrap(), "{name}");
        // S and T: once for each of 3 or 7 directions
        let directions = if name.ends_with("slabs") { 7 } else { 3 };
        assert_eq!(
            tree["in_advance"]["s_and_t"]["computed"], directions,
            "{name}"
        );
    }
}

#[test]
fn a_pixel_alone_is_compared() {
    let folder = Folder::with_scene();
    let json = json_of(&folder, "compare scene.json 0,0 --transport backward");
    assert_eq!(json["pixel"], serde_json::json!([0, 0]));
    // the sky: one ray against a sphere, an ellipsoid, a box and a polygon's plane
    let all = entry(&json, "exhaustive");
    assert_eq!((&all["rays"], &all["object_tests"]), (&1.into(), &4.into()));
    let through_corners = json_of(
        &folder,
        "compare scene.json 0,0 --transport backward --through corners",
    );
    let all = entry(&through_corners, "exhaustive");
    assert_eq!(
        (&all["rays"], &all["object_tests"]),
        (&4.into(), &16.into())
    );
}

#[test]
fn every_row_adds_up_and_the_strategies_have_the_same_rays() {
    let folder = Folder::with_scene();
    let json = json_of(&folder, "compare scene.json --pixels 24,18");
    let strategies = json["strategies"].as_array().unwrap();
    assert_eq!(strategies.len(), 13);
    for entry in strategies {
        let name = &entry["name"];
        let tests = entry["counts"]["tests"].as_object().unwrap();
        let made = |kind: &str| tests[kind]["tests"].as_u64().unwrap();
        let sum: u64 = tests
            .keys()
            .filter(|kind| *kind != "polygon_test")
            .map(|kind| made(kind))
            .sum();
        assert_eq!(entry["object_tests"], sum, "{name}");
        // the same objects are hit; z-aligned rays compute in another frame, and may round otherwise
        if name != "z-aligned" {
            let [rays, all] = [entry, &strategies[0]].map(|entry| &entry["counts"]["rays"]);
            assert_eq!(rays, all, "{name}");
        }
        assert!(made("polygon_test") <= made("plane_test"), "{name}");
    }
}

#[test]
fn text_csv_and_json_say_the_same() {
    let folder = Folder::with_scene();
    let words = "compare scene.json --pixels 24,18";
    let json = json_of(&folder, words);
    let text = text_of(&folder, &format!("{words} --wide"));
    let csv = text_of(&folder, &format!("{words} --format csv"));

    let mut lines = csv.lines().map(cells);
    let keys = lines.next().unwrap();
    let rows: Vec<Vec<String>> = lines.collect();
    let strategies = json["strategies"].as_array().unwrap();
    assert_eq!(rows.len(), strategies.len());
    for (row, entry) in rows.iter().zip(strategies) {
        assert_eq!(row.len(), keys.len());
        let cell = |key: &str| &row[keys.iter().position(|known| known == key).unwrap()];
        assert_eq!(*cell("strategy"), entry["name"].as_str().unwrap());
        for key in [
            "rays",
            "bound_tests",
            "nodes",
            "cells",
            "object_tests",
            "bytes",
        ] {
            assert_eq!(*cell(key), entry[key].to_string(), "{key}");
        }
        for kind in ["sphere", "ellipsoid", "cone", "box", "plane", "polygon"] {
            let count = &entry["counts"]["tests"][format!("{kind}_test")]["tests"];
            assert_eq!(*cell(kind), count.to_string(), "{kind}");
        }
        let per_ray = entry["tests_per_ray"].as_f64().unwrap();
        assert_eq!(*cell("tests_per_ray"), format!("{per_ray:.2}"));

        // the table has the same cells, in words apart, without cones and seconds
        let line = text
            .lines()
            .find(|line| line.starts_with(&format!("{} ", cell("strategy"))));
        let numbers: Vec<&str> = line.unwrap()[cell("strategy").len()..]
            .split_whitespace()
            .collect();
        let expected = [
            "rays",
            "bound_tests",
            "nodes",
            "cells",
            "object_tests",
            "sphere",
            "ellipsoid",
            "box",
            "plane",
            "polygon",
            "tests_per_ray",
            "share_percent",
        ];
        assert_eq!(numbers[..12], expected.map(|key| cell(key).as_str()));
        assert_eq!(numbers[13], cell("bytes"));
    }
    assert!(
        text.starts_with("two balls over a floor: 4 objects, 24 × 18 pixels\n\n"),
        "{text}"
    );
    assert!(!text.contains("cone"), "{text}");
}

#[test]
fn counts_are_the_same_on_any_number_of_threads() {
    let folder = Folder::with_scene();
    let counts = |threads: &str| {
        let mut json = json_of(
            &folder,
            &format!("compare scene.json --pixels 24,18 {threads}"),
        );
        for entry in json["strategies"].as_array_mut().unwrap() {
            entry.as_object_mut().unwrap().remove("seconds").unwrap();
        }
        json
    };
    let first = counts("");
    for threads in ["--threads 1", "--threads 2"] {
        assert_eq!(counts(threads), first, "{threads}");
    }
}

#[test]
fn what_was_computed_in_advance_is_told() {
    let folder = Folder::empty().with("s.json", SQUARE);
    // two eye rays, each of which meets the plane and the outline of the one polygon
    let words = "render s.json --strategy exhaustive -o out.png --stats=json";
    let json: Value = serde_json::from_slice(&folder.run(words).well()).unwrap();
    let once = serde_json::json!({ "computed": 1, "used": 2, "saved": 1 });
    assert_eq!(
        json["in_advance"],
        serde_json::json!({ "plane_equations": once, "projected_outlines": once })
    );
    let stderr = folder
        .run("render s.json --strategy exhaustive -o out.png --stats")
        .stderr;
    for what in ["plane equations", "projected outlines"] {
        let line = format!("\n{what}: computed once instead of 2: 1 saved\n");
        assert!(stderr.contains(&line), "{stderr}");
    }
    let table = text_of(&folder, "compare s.json");
    assert!(
        table
            .contains("\n  exhaustive\n    plane equations: computed once instead of 2: 1 saved\n"),
        "{table}"
    );
    // z-aligned rays project each outline anew
    let json = json_of(&folder, "compare s.json");
    let aligned = &entry(&json, "z-aligned")["in_advance"];
    assert!(aligned["projected_outlines"].is_null(), "{aligned}");
}

#[test]
fn long_counts_of_the_search_end_under_the_other_numbers() {
    let mut counts = Counts::default();
    counts.search.outside_cell = 104_857_600;
    counts.search.entered = 7;
    counts.tests[0].tests = 1_234_567_890;
    let text = raystep::explain::counts_text(&counts);
    let ends: Vec<usize> = text
        .lines()
        .filter(|line| {
            ["sphere_test", "hits outside", "nodes entered"]
                .iter()
                .any(|name| line.starts_with(name))
        })
        .map(|line| {
            let first = line.find("  ").unwrap();
            let start = first + line[first..].find(|c: char| c != ' ').unwrap();
            start + line[start..].find(' ').unwrap_or(line.len() - start)
        })
        .collect();
    assert_eq!(ends, [36, 36, 36], "{text}");
}

#[test]
fn without_objects_there_is_no_share() {
    let start = TWO_BALLS.find("    { \"name\": \"A\"").unwrap();
    let end = TWO_BALLS.find("  ],").unwrap();
    let empty = format!("{}{}", &TWO_BALLS[..start], &TWO_BALLS[end..]);
    let folder = Folder::empty().with("s.json", empty);
    let json = json_of(&folder, "compare s.json --chart c.svg");
    for entry in json["strategies"].as_array().unwrap() {
        assert_eq!(entry["object_tests"], 0, "{entry}");
        assert!(entry["share_percent"].is_null(), "{entry}");
    }
    assert!(text_of(&folder, "compare s.json").starts_with("two balls: 0 objects, 1 × 1 pixels\n"));
}

fn lesson() -> Scene {
    let loaded = load_bytes("scene.json", LESSON.as_bytes(), &NoFiles).unwrap();
    loaded.build().unwrap()
}

#[test]
fn the_slides_example_takes_as_many_tests_as_the_slides_say() {
    // 64 × 64 pixels and 100 objects: 409 600
    let folder = Folder::empty().with("scene.json", LESSON);
    let json = json_of(
        &folder,
        "compare scene.json --transport backward --pixels 64,64",
    );
    assert_eq!(entry(&json, "exhaustive")["object_tests"], 409_600);
    assert_eq!(
        entry(&json, "exhaustive")["counts"]["rays"]["eye"]["traced"],
        4096
    );

    // 1024 × 1024 and 100: erratum 9
    let scene = lesson();
    let strategy = Exhaustive::new(&scene);
    let tracer = Tracer::new(&scene, &strategy, Transport::Backward);
    let (_, lines) = render::<_, Counts>(&tracer, Through::Centres, |_| {}).unwrap();
    let tests: u64 = lines.iter().map(Counts::objects_tested).sum();
    assert_eq!(tests, 104_857_600);
}

#[test]
fn all_hundred_objects_of_the_lesson_are_seen() {
    let folder = Folder::empty().with("scene.json", LESSON);
    let words = "trace scene.json --pixels 128,128 --transport backward --only ray_end";
    let log = text_of(&folder, words);
    let seen: std::collections::BTreeSet<String> = log
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap())
        .filter(|line| line["kind"] == "ray_end")
        .filter_map(|line| line["object"].as_str().map(String::from))
        .collect();
    assert_eq!(seen.len(), 100);
}

/// What the command says to these words, which leave only the scene behind.
#[track_caller]
fn refuses(words: &str) -> String {
    let folder = Folder::with_scene();
    let message = folder.run(words).refused();
    assert_eq!(folder.names(), ["scene.json"], "a file was left behind");
    message
}

#[test]
fn what_makes_no_sense_is_refused_before_any_work() {
    for (words, told) in [
        (
            "compare scene.json --strategy grid",
            "unexpected argument '--strategy'",
        ),
        ("compare scene.json 160,0", "the picture has no pixel 160,0"),
        (
            "compare scene.json --chart none/c.svg",
            "there is no folder none",
        ),
        ("compare scene.json --chart -", "name a file with --chart"),
        (
            "compare scene.json --format xml",
            "[possible values: text, json, csv]",
        ),
        (
            "render scene.json -o a.png --heatmap warmth",
            "[possible values: tests, nodes, cells, depth]",
        ),
    ] {
        let message = refuses(words);
        assert!(message.contains(told), "{words}: {message}");
    }
}

#[test]
fn a_log_is_no_scene() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --region 3,3 -o a.jsonl")
        .well();
    for words in [
        "compare a.jsonl --chart c.svg",
        "render a.jsonl -o a.png --heatmap tests",
    ] {
        let message = folder.run(words).refused();
        assert!(message.contains("this is a log"), "{message}");
    }
    assert_eq!(folder.names(), ["a.jsonl", "scene.json"]);
}

#[test]
fn the_help_has_an_example() {
    let help = text_of(&Folder::empty(), "compare --help");
    assert!(help.contains("  raystep compare "), "{help}");
}

/// A comparison with made-up counts: object tests, and nodes entered.
fn made_up<'a>(scene: &'a Scene, numbers: &[[u64; 2]]) -> Comparison<'a> {
    let strategies = strategies_to_compare(scene, &Settings::default());
    let compared = strategies.into_iter().zip(numbers);
    Comparison {
        scene,
        pixel: None,
        compared: compared
            .map(|(settings, &[tests, nodes])| {
                let mut cost = Cost::default();
                cost.counts.tests[0].tests = tests;
                cost.counts.search.entered = nodes;
                Compared {
                    settings,
                    cost: Ok(cost),
                }
            })
            .collect(),
    }
}
