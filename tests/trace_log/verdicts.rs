//! The verdict of each test in a log, and why it was rejected, against places that are worked out by hand.

use std::collections::BTreeSet;

use raystep::structure::VolumeKind;
use raystep::trace::trace_schema;
use raystep::{Settings, StrategyName, StructureOptions};
use serde_json::Value;

use super::{all_of, built, log, traced};

/// The eye ray runs from 0 along (0.6, 0, −0.8): at t it is at (0.6t, 0, −0.8t).
pub(super) const SCENE: &str = r#"{
  "camera": { "window": { "cop": [0, 0, 0], "corner": [0.2, -0.5, -1.1], "right": [0.8, 0, 0.6], "up": [0, 1, 0] },
              "pixels": [1, 1] },
  "lights": [ { "name": "lamp", "position": [0, 3, 0], "colour": [1, 1, 1] } ],
  "materials": { "red": { "colour": [1, 0, 0], "diffuse": 0.5 } },
  "objects": [
    { "name": "hit", "material": "red", "shape": { "sphere": { "center": [6, 0, -8], "radius": 1 } } },
    { "name": "aside", "material": "red", "shape": { "sphere": { "center": [0, 0, -8], "radius": 1 } } },
    { "name": "egg", "material": "red", "shape": { "ellipsoid": { "center": [3, 5, -4], "radii": [1, 2, 1] } } },
    { "name": "behind", "material": "red", "shape": { "sphere": { "center": [-6, 0, 8], "radius": 1 } } },
    { "name": "hidden", "material": "red", "shape": { "sphere": { "center": [12, 0, -16], "radius": 1 } } },
    { "name": "around", "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 20 } } },
    { "name": "crossed", "material": "red", "shape": { "box": { "min": [0, -1, -5], "max": [1, 1, -4] } } },
    { "name": "above", "material": "red", "shape": { "box": { "min": [2, 1, -5], "max": [4, 2, -3] } } },
    { "name": "tube", "material": "red",
      "shape": { "cone": { "base": [3, 1, -4], "base_radius": 0.5, "apex": [3, 2, -4], "apex_radius": 0.5 } } },
    { "name": "floor", "material": "red",
      "shape": { "polygon": { "vertices": [[-9, -1, -9], [-9, -1, 9], [9, -1, 9], [9, -1, -9]] } } },
    { "name": "sign", "material": "red",
      "shape": { "polygon": { "vertices": [[3, 1, -5], [3, 2, -5], [3, 2, -3], [3, 1, -3]] } } },
    { "name": "back", "material": "red", "sides": "front",
      "shape": { "polygon": { "vertices": [[3, -1, -5], [3, 1, -5], [3, 1, -3], [3, -1, -3]] } } },
    { "name": "front", "material": "red", "sides": "back",
      "shape": { "polygon": { "vertices": [[3, -1, -3], [3, 1, -3], [3, 1, -5], [3, -1, -5]] } } }
  ]
}"#;

/// The lines of a log that are about one object, each as kind, verdict and reason.
fn verdicts(log: &[u8], ray: u32, object: &str) -> Vec<String> {
    let lines = std::str::from_utf8(log).unwrap().lines();
    let lines = lines.map(|line| serde_json::from_str::<Value>(line).unwrap());
    let of = lines.filter(|line| line["ray"] == ray && line["object"] == object);
    let tests = of.filter(|line| line["kind"].as_str().unwrap().ends_with("_test"));
    let text = |value: &Value| value.as_str().unwrap_or("").to_owned();
    tests
        .map(|line| {
            let words = [&line["kind"], &line["verdict"], &line["why"]].map(text);
            words.join(" ").trim_end().to_owned()
        })
        .collect()
}

#[test]
fn each_test_has_a_verdict_and_a_rejected_one_says_why() {
    let log = log(
        &built(SCENE),
        &Settings::default(),
        &all_of("0,0".parse().unwrap()),
    );
    for (object, expected) in [
        // t = 10 ± 1
        ("hit", "sphere_test hit"),
        // 6.4 along the ray, √(64 − 6.4²) = 4.8 beside it
        ("aside", "sphere_test rejected no_root"),
        ("egg", "ellipsoid_test rejected no_root"),
        // t = −10 ± 1
        ("behind", "sphere_test rejected behind"),
        // t = 20 ± 1, and 9 is known
        ("hidden", "sphere_test rejected beyond_nearest"),
        // t = −20 and 20: the root behind the eye is not the reason
        ("around", "sphere_test rejected beyond_nearest"),
        // x in t = 0 … 5/3, z in t = 5 … 6.25
        ("crossed", "box_test rejected empty"),
        // y = 0 is not in 1 … 2
        ("above", "box_test rejected parallel"),
        ("tube", "cone_test rejected beyond_ends"),
        ("floor", "plane_test rejected parallel"),
        ("sign", "plane_test hit, polygon_test rejected outside"),
        ("back", "plane_test rejected back_face"),
        ("front", "plane_test rejected front_face"),
    ] {
        assert_eq!(verdicts(&log, 0, object).join(", "), expected, "{object}");
    }
    // the shadow ray starts on the ball, and leaves it
    let shadow = verdicts(&log, 1, "hit");
    assert_eq!(shadow, ["sphere_test rejected below_epsilon"]);
}

#[test]
fn bounds_and_slabs_use_the_same_words() {
    let scene = built(SCENE);
    let bounds = |volume| {
        let structure = StructureOptions {
            volume,
            ..StructureOptions::default()
        };
        let settings = Settings {
            strategy: StrategyName::Bounds,
            structure,
            ..Settings::default()
        };
        log(&scene, &settings, &all_of("0,0".parse().unwrap()))
    };
    let balls = bounds(VolumeKind::Sphere);
    for (object, expected) in [
        ("hit", "bound_test hit, sphere_test hit"),
        ("aside", "bound_test rejected missed"),
        ("behind", "bound_test rejected behind"),
        ("hidden", "bound_test rejected beyond_nearest"),
    ] {
        assert_eq!(verdicts(&balls, 0, object).join(", "), expected, "{object}");
    }
    let slabs = bounds(VolumeKind::Slabs);
    for (object, expected) in [
        // x, then y, to which the ray is parallel, then z
        (
            "crossed",
            "slab_test hit, slab_test hit, slab_test rejected empty, bound_test rejected missed",
        ),
        (
            "above",
            "slab_test hit, slab_test rejected parallel, bound_test rejected missed",
        ),
    ] {
        assert_eq!(verdicts(&slabs, 0, object).join(", "), expected, "{object}");
    }
}

/// Version 1 had no verdict, and a reader had to know of each kind where its result stands.
#[test]
fn every_test_of_every_strategy_is_a_hit_or_rejected_and_the_hit_has_its_t() {
    let mut kinds = BTreeSet::new();
    for case in traced() {
        for line in case.lines() {
            let line: Value = serde_json::from_str(line).unwrap();
            let kind = line["kind"].as_str().unwrap().to_owned();
            if !kind.ends_with("_test") {
                assert_eq!(line.get("verdict"), None, "{line}");
                continue;
            }
            let is_hit = line["verdict"] == "hit";
            assert!(is_hit || line["verdict"] == "rejected", "{line}");
            assert_eq!(is_hit, line.get("why").is_none(), "{line}");
            match kind.as_str() {
                "polygon_test" => assert_eq!(line["inside"], is_hit, "{line}"),
                "bound_test" => assert!(!is_hit || line.get("near").is_some(), "{line}"),
                "slab_test" => {}
                _ => assert_eq!(is_hit, line.get("t").is_some(), "{line}"),
            }
            assert_eq!(line.get("outcome"), None, "{line}");
            kinds.insert(kind);
        }
    }
    let all = "bound_test box_test cone_test ellipsoid_test plane_test polygon_test slab_test sphere_test";
    assert_eq!(Vec::from_iter(kinds).join(" "), all);
}

#[test]
fn the_schema_says_what_each_word_means() {
    let mut lists = 0;
    let mut visited = vec![trace_schema()["oneOf"].clone()];
    while let Some(value) = visited.pop() {
        if let Some(words) = value["oneOf"].as_array()
            && value["type"] == "string"
        {
            lists += 1;
            for word in words {
                let meaning = word["description"].as_str().unwrap_or_default();
                assert!(10 <= meaning.len(), "{word}");
            }
        }
        match value {
            Value::Array(list) => visited.extend(list),
            Value::Object(map) => visited.extend(map.into_values()),
            _ => {}
        }
    }
    assert!(40 < lists, "{lists}");
}
