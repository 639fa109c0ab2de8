//! `raystep figure --scene`: figures of scenes that no lesson knows.

use std::path::Path;

use roxmltree::Document;
use serde_json::Value;

use super::run::Folder;
use crate::figures::{check_svg, texts_of};

/// A scene of the standard databases.
fn nff(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.join("tests/data/nff").join(name).display().to_string()
}

/// What is drawn of a pixel of a scene.
#[track_caller]
fn drawn(scene: &str, pixel: &str, kind: &str) -> String {
    let words = format!("figure --scene {scene} {pixel} --kind {kind}");
    let svg = String::from_utf8(Folder::empty().run(&words).well()).unwrap();
    // ids begin otherwise here than in the lessons' figures
    let svg = svg.replace(&format!("raystep-{kind}"), "raystep-test");
    check_svg(&words, &svg);
    svg
}

#[test]
fn every_kind_of_a_ray_is_drawn_of_scenes_of_balls_triangles_and_cones() {
    const KINDS: [&str; 12] = [
        "window",
        "rays",
        "line-of-t",
        "shading",
        "volumes",
        "slabs",
        "intervals",
        "hierarchy",
        "heap",
        "partition",
        "grid",
        "steps",
    ];
    let mut drawings = 0;
    for (scene, pixel) in [
        ("balls-2.nff", "256,256"),
        ("tetra-3.nff", "256,256"),
        ("tree-4.nff", "256,300"),
    ] {
        for kind in KINDS {
            drawn(&nff(scene), pixel, kind);
            drawings += 1;
        }
    }
    assert_eq!(drawings, 36);
}

#[test]
fn of_thousands_of_balls_those_near_the_ray_are_drawn() {
    let scene = nff("full/balls.nff");
    // the grid has those as well that are on the lists of its cells
    for (kind, most) in [("rays", 240), ("hierarchy", 240), ("grid", 1000)] {
        let svg = drawn(&scene, "256,300", kind);
        let document = Document::parse(&svg).unwrap();
        let circles = document
            .descendants()
            .filter(|node| node.has_tag_name("circle"));
        // 7382 objects, of which 60 are near: each is drawn at most twice, and points are circles too
        let count = circles.count();
        assert!((1..most).contains(&count), "{kind}: {count} circles");
    }
}

#[test]
fn the_line_of_t_has_the_hit_that_the_worked_solution_has() {
    let scene = nff("balls-2.nff");
    let svg = drawn(&scene, "256,256", "line-of-t");
    let texts = texts_of(&svg);
    let solved = Folder::empty().run(&format!("pixel {scene} 256,256 --format json"));
    let solved: Value = serde_json::from_slice(&solved.well()).unwrap();
    // the eye ray is the first of the rays
    let t = first_end(&solved).unwrap()["t"].as_f64().unwrap();
    let digits = 3 - t.log10().floor() as usize;
    let shown = format!("{t:.digits$}");
    assert!(texts.contains(&shown), "no {shown} among {texts:?}");
}

/// The first end of a ray in a worked solution.
fn first_end(value: &Value) -> Option<&Value> {
    if value["kind"] == "ray_end" {
        return Some(value);
    }
    match value {
        Value::Array(values) => values.iter().find_map(first_end),
        Value::Object(values) => values.values().find_map(first_end),
        _ => None,
    }
}

#[test]
fn what_cannot_be_drawn_is_refused_with_what_to_do() {
    let folder = Folder::with_scene();
    let refused = |words: &str| folder.run(words).refused();
    let message = refused("figure --scene scene.json 999,0 --kind grid");
    assert!(
        message.contains("the picture has no pixel 999,0"),
        "{message}"
    );
    let message = refused("figure --scene scene.json 12-grid/walk --kind grid");
    assert!(
        message.contains("--scene draws a pixel of a scene"),
        "{message}"
    );
    let message = refused("figure 3,4");
    assert!(message.contains("add --scene FILE"), "{message}");
    let message = refused("figure --scene scene.json 3,4");
    assert!(message.contains("--kind"), "{message}");
    let message = refused("figure --scene scene.json 3,4 --kind gird");
    assert!(message.contains("grid"), "{message}");
    let message = refused("figure --scene scene.json 0,0 --kind gather");
    assert!(message.contains("power"), "{message}");
    folder
        .run("trace scene.json --region 0,0-1,1 -o log.jsonl")
        .well();
    let message = refused("figure --scene log.jsonl 0,0 --kind grid");
    assert!(message.contains("this is a log"), "{message}");
}
