//! The schemas: what they allow is what the program writes, and what the program refuses they refuse.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use jsonschema::Validator;
use raystep::trace::{Kind, scene_schema, trace_schema};
use serde_json::{Value, json};

use crate::bad_input::light::LAMP;
use crate::cli::figures::course;
use crate::cli::run::Folder;
use crate::recording::NFF;
use crate::trace_log::strategies::{built_cases, log_with_building};
use crate::trace_log::{EXAMPLE, MIXED, loaded_nff, traced};

#[track_caller]
fn validator(schema: &Value) -> Validator {
    assert_eq!(
        schema["$schema"],
        "https://json-schema.org/draft/2020-12/schema"
    );
    if let Err(error) = jsonschema::draft202012::meta::validate(schema) {
        panic!("at {}: {error}", error.instance_path());
    }
    jsonschema::draft202012::new(schema).unwrap()
}

#[track_caller]
fn check_allowed(validator: &Validator, what: &str, value: &Value) {
    if let Err(error) = validator.validate(value) {
        panic!("{what}, at {}: {error}", error.instance_path());
    }
}

fn example() -> Value {
    serde_json::from_str(EXAMPLE).unwrap()
}

#[test]
fn scenes_that_load_are_allowed() {
    let schema = validator(&scene_schema());
    check_allowed(&schema, "the example", &example());
    check_allowed(&schema, "mixed", &serde_json::from_str(MIXED).unwrap());
    for name in NFF {
        let scene = serde_json::to_value(loaded_nff(name).scene).unwrap();
        check_allowed(&schema, name, &scene);
    }
    let least = json!({
        "camera": {
            "window": { "cop": [0, 0, 0], "corner": [0, 0, 1], "right": [1, 0, 0], "up": [0, 1, 0] },
            "pixels": [1, 1]
        },
        "objects": []
    });
    check_allowed(&schema, "the least scene", &least);
    for slabs in [
        json!([[1, 0, 0], [0, 1, 0], [0, 0, 1]]),
        json!([[1, 0], [0, 1]]),
    ] {
        let mut scene = least.clone();
        set(&mut scene, "/slabs", Some(slabs));
        check_allowed(&schema, "a scene with slabs", &scene);
    }
}

/// Sets the value at a JSON pointer, or takes it away.
#[track_caller]
fn set(value: &mut Value, pointer: &str, to: Option<Value>) {
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    let parent = value.pointer_mut(parent).unwrap();
    match (parent, to) {
        (Value::Array(list), Some(to)) => list[key.parse::<usize>().unwrap()] = to,
        (Value::Object(map), Some(to)) => drop(map.insert(key.into(), to)),
        (Value::Object(map), None) => drop(map.remove(key).unwrap()),
        (Value::Array(list), None) => drop(list.remove(key.parse().unwrap())),
        (other, _) => panic!("{other} has no members"),
    }
}

#[test]
fn scenes_that_do_not_load_are_refused() {
    let schema = validator(&scene_schema());
    let window =
        json!({ "cop": [0, 0, 0], "corner": [0, 0, 1], "right": [1, 0, 0], "up": [0, 1, 0] });
    let face = json!({ "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]] });
    for (pointer, to) in [
        ("/lamps", Some(json!([]))),
        ("/camera", None),
        ("/objects", None),
        ("/max_depth", Some(json!(0))),
        ("/max_depth", Some(json!(101))),
        ("/max_depth", Some(json!(2.5))),
        ("/name", Some(json!(null))),
        ("/slabs", Some(json!(null))),
        ("/slabs", Some(json!(7))),
        ("/slabs", Some(json!([1, 0, 0]))),
        ("/slabs", Some(json!([["1", 0, 0]]))),
        ("/background", Some(json!([0, 0]))),
        ("/background", Some(json!([0, 0, 0, 0]))),
        ("/background/1", Some(json!("0.8"))),
        ("/camera/window", Some(window)),
        ("/camera/window", Some(json!(null))),
        ("/camera/look_at", Some(json!(null))),
        ("/camera/look_at", None),
        ("/camera/pixels/0", Some(json!(0))),
        ("/camera/pixels/0", Some(json!(1.5))),
        ("/camera/look_at/fov_degrees", Some(json!(0))),
        ("/camera/look_at/fov_degrees", Some(json!(180))),
        ("/camera/look_at/roll", Some(json!(3))),
        ("/lights/0/colour", None),
        ("/lights/0/colour", Some(json!(null))),
        ("/lights/0/colour/0", Some(json!(-1))),
        ("/lights/0/power", Some(json!(5))),
        (
            "/lights/0",
            Some(json!({ "position": [0, 0, 0], "power": -5 })),
        ),
        (
            "/lights/0",
            Some(json!({ "position": [0, 0, 0], "power": 0 })),
        ),
        ("/lights/0/position", None),
        ("/materials/red/colour", None),
        ("/materials/red/diffuse", Some(json!(-0.1))),
        ("/materials/red/gloss", Some(json!(1))),
        ("/materials/glass/index", Some(json!(0))),
        ("/objects/0/name", None),
        ("/objects/0/name", Some(json!(""))),
        ("/objects/0/material", Some(json!(1))),
        ("/objects/0/sides", Some(json!("left"))),
        ("/objects/0/sides", Some(json!(null))),
        ("/objects/0/colour", Some(json!([1, 0, 0]))),
        ("/objects/0/shape/sphere/radius", Some(json!(0))),
        ("/objects/0/shape/sphere/radius", Some(json!("1"))),
        ("/objects/0/shape/sphere/radius", None),
        ("/objects/0/shape/sphere/centre", Some(json!([0, 0, 0]))),
        (
            "/objects/0/shape/box",
            Some(json!({ "min": [0, 0, 0], "max": [1, 1, 1] })),
        ),
        ("/objects/0/shape/sphere", None),
        (
            "/objects/0/shape",
            Some(json!({ "torus": { "center": [0, 0, 0] } })),
        ),
        ("/objects/1/shape/ellipsoid/radii/2", Some(json!(0))),
        ("/objects/2/shape/box/max", Some(json!([1, 2]))),
        (
            "/objects/3/shape/polygon/vertices",
            Some(json!([[0, 0, 0], [1, 0, 0]])),
        ),
        ("/objects/3/shape/polygon/normals", Some(json!(null))),
        ("/objects/3/shape", Some(json!({ "mesh": {} }))),
        (
            "/objects/3/shape",
            Some(json!({ "mesh": { "file": "a.obj", "faces": [face] } })),
        ),
        (
            "/objects/3/shape",
            Some(json!({ "mesh": { "file": null } })),
        ),
    ] {
        let mut scene = example();
        set(&mut scene, pointer, to.clone());
        assert!(!schema.is_valid(&scene), "{pointer} = {to:?} is allowed");
        let text = scene.to_string();
        let loaded = raystep::load_bytes("a.json", text.as_bytes(), &raystep::NoFiles);
        let built = loaded.and_then(raystep::scene::Loaded::build);
        assert!(built.is_err(), "{pointer} = {to:?} loads");
    }
}

/// Some lines of each kind, made once for all tests.
fn lines() -> &'static [Value] {
    static LINES: OnceLock<Vec<Value>> = OnceLock::new();
    LINES.get_or_init(made_lines)
}

fn made_lines() -> Vec<Value> {
    let mut lines = Vec::new();
    for case in traced() {
        lines.extend(case.lines().map(parsed));
    }
    for (scene, settings, pixel) in built_cases() {
        let text = String::from_utf8(log_with_building(&scene, &settings, pixel)).unwrap();
        lines.extend(text.lines().map(parsed));
    }
    // what the log of a figure holds of every pixel
    let folder = course().with(
        "lessons/01-ball/lesson.json",
        r#"{ "title": "A ball", "figures": {
            "picture": { "kind": "picture", "scene": "scene.json" },
            "heat": { "kind": "heat", "scene": "scene.json", "strategies": ["exhaustive", "grid"] } } }"#,
    );
    for figure in ["picture", "heat"] {
        let words = format!("figure 01-ball/{figure} --write-log log.jsonl -o f.svg");
        folder.run(&words).well();
        let text = String::from_utf8(folder.read("log.jsonl")).unwrap();
        lines.extend(text.lines().map(parsed));
    }
    // an eye that is wider than anybody's, and of the paths those that arrive in it
    let folder = Folder::empty().with("scene.json", LAMP);
    for options in [
        "--transport forward --paths 20000 --aperture 1 --region 0,0-7,5",
        "--transport hybrid-stored --paths 50",
        "--transport hybrid-connected --samples 1",
    ] {
        let text = folder.run(&format!("trace scene.json {options}")).well();
        let text = String::from_utf8(text).unwrap();
        lines.extend(text.lines().map(parsed));
    }
    lines
}

#[track_caller]
fn parsed(line: &str) -> Value {
    serde_json::from_str(line).unwrap()
}

fn kind_of(line: &Value) -> &str {
    line["kind"].as_str().unwrap()
}

#[test]
fn every_line_of_a_log_is_allowed_and_all_kinds_occur() {
    let schema = validator(&trace_schema());
    let lines = lines();
    for line in lines {
        check_allowed(&schema, kind_of(line), line);
    }
    let kinds: BTreeSet<&str> = lines.iter().map(kind_of).collect();
    let heads = ["trace", "object", "picture", "pixel_tests"].into_iter();
    let all = heads.chain(Kind::ALL.into_iter().map(Kind::name)).collect();
    assert_eq!(kinds, all);
}

#[test]
fn a_line_with_a_wrong_key_or_value_is_refused() {
    let schema = validator(&trace_schema());
    let lines = lines();
    for kind in Kind::ALL {
        let good = lines.iter().find(|line| kind_of(line) == kind.name());
        let good = good.unwrap();
        let keys: Vec<String> = good.as_object().unwrap().keys().cloned().collect();
        let refused = |pointer: &str, to: Option<Value>| {
            let mut line = good.clone();
            set(&mut line, pointer, to);
            assert!(!schema.is_valid(&line), "{line}");
        };
        refused("/colour_of_money", Some(json!(1)));
        refused("/step", None);
        // what is built is built before the first pixel
        let pixel = good.get("pixel").is_none().then(|| json!([0, 0]));
        refused("/pixel", pixel);
        let path = good.get("path").is_none().then(|| json!(0));
        refused("/path", path);
        refused("/kind", None);
        refused("/step", Some(json!(-1)));
        refused("/step", Some(json!(0.5)));
        refused("/pixel", Some(json!([0])));
        refused("/kind", Some(json!("sphere-test")));
        for key in &keys {
            refused(&format!("/{key}"), Some(json!(null)));
            let to = if good[key].is_string() {
                json!(1)
            } else {
                json!("1")
            };
            refused(&format!("/{key}"), Some(to));
        }
        let other = if kind == Kind::Ray { "shade" } else { "ray" };
        refused("/kind", Some(json!(other)));
    }
}

#[test]
fn a_head_with_a_wrong_key_or_value_is_refused() {
    let schema = validator(&trace_schema());
    let lines = lines();
    let of = |kind: &str| lines.iter().find(|line| kind_of(line) == kind).unwrap();
    for (kind, pointer, to) in [
        ("trace", "/version", Some(json!(1))),
        ("trace", "/version", Some(json!(3))),
        ("trace", "/version", None),
        ("trace", "/settings", None),
        ("trace", "/settings/strategy", Some(json!("best"))),
        ("trace", "/settings/seed", Some(json!(1))),
        ("trace", "/settings/building", Some(json!("yes"))),
        ("trace", "/settings/structure", Some(json!({ "ball": 1 }))),
        (
            "trace",
            "/settings/structure",
            Some(json!({ "volume": "ball" })),
        ),
        ("trace", "/slabs", Some(json!([1, 0, 0]))),
        ("trace", "/camera/look_at", None),
        ("trace", "/materials/red/colour", Some(json!("red"))),
        ("trace", "/objects", Some(json!([]))),
        ("object", "/shape", None),
        ("object", "/shape/sphere/radius", Some(json!(0))),
        ("object", "/step", Some(json!(0))),
        ("object", "/kind", Some(json!("trace"))),
        ("picture", "/png", None),
        ("picture", "/pixels", Some(json!([1]))),
        ("picture", "/pixel", Some(json!([0, 0]))),
        ("pixel_tests", "/row", Some(json!(-1))),
        ("pixel_tests", "/cells", None),
        ("pixel_tests", "/nodes", Some(json!(3))),
    ] {
        let mut line = of(kind).clone();
        set(&mut line, pointer, to.clone());
        assert!(!schema.is_valid(&line), "{kind} {pointer} = {to:?}");
    }
}
