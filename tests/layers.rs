//! Data flows one way: a layer uses the layers before it and none after it.

use std::fs;
use std::path::{Path, PathBuf};

/// From pure mathematics to the command line.
const LAYERS: [&str; 13] = [
    "parallel",
    "geometry",
    "scene",
    "structure",
    "trace",
    "strategy",
    "tracer",
    "explain",
    "figure",
    "lesson",
    "files",
    "book",
    "cli",
];

/// What draws and explains sees events and the scene, never how they were made.
const FROM_EVENTS_ALONE: [&str; 2] = ["explain", "figure"];

pub(crate) fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found
}

fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn layer_of(path: &Path) -> Option<usize> {
    let relative = path.strip_prefix(src()).unwrap().with_extension("");
    let folder = relative.iter().next().unwrap().to_str().unwrap();
    LAYERS.iter().position(|layer| *layer == folder)
}

/// What follows each `crate::` (in the command, `raystep::`) of a source.
fn uses<'a>(text: &'a str, root: &'a str) -> impl Iterator<Item = &'a str> {
    text.match_indices(root).map(move |(at, _)| {
        let rest = &text[at + root.len()..];
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        &rest[..end.unwrap_or(rest.len())]
    })
}

#[test]
fn every_path_names_its_layer_and_no_import_points_up() {
    let mut checked = 0;
    for path in sources(&src()) {
        let Some(layer) = layer_of(&path) else {
            continue;
        };
        if LAYERS[layer] == "cli" {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        for used in uses(&text, "crate::") {
            let place = path.display();
            let of = LAYERS.iter().position(|layer| *layer == used);
            let of = of.unwrap_or_else(|| panic!("{place}: crate::{used} names no layer"));
            assert!(of <= layer, "{place}: {used} lies above {}", LAYERS[layer]);
            let events_alone = FROM_EVENTS_ALONE.contains(&LAYERS[layer]);
            let traces = ["strategy", "tracer"].contains(&used);
            assert!(!(events_alone && traces), "{place}: uses {used}");
            checked += 1;
        }
    }
    assert!(50 < checked, "only {checked} paths were found");
}

#[test]
fn geometry_uses_glam_and_the_exact_predicates_alone() {
    for path in sources(&src().join("geometry")) {
        let text = fs::read_to_string(&path).unwrap();
        for line in text.lines().filter(|line| line.starts_with("use ")) {
            let known = ["use crate::", "use glam::", "use robust::", "use std::"];
            let allowed = known.iter().any(|start| line.starts_with(start));
            assert!(allowed, "{}: {line}", path.display());
        }
        for forbidden in ["println!", "eprintln!", "std::fs", "std::io"] {
            assert!(!text.contains(forbidden), "{}: {forbidden}", path.display());
        }
    }
}

#[test]
fn whether_somebody_follows_is_asked_by_one_line_and_by_those_who_must_make_events() {
    // the door to the fast drivers; the points of an object in a ray's frame, a polygon's edges, how a structure was built
    let expected = [
        ("strategy/chosen.rs", 1),
        ("strategy/grid.rs", 1),
        ("strategy/node_bounds.rs", 1),
        ("strategy/object_test.rs", 1),
        ("strategy/z_aligned.rs", 2),
    ];
    let mut found = Vec::new();
    for path in sources(&src()) {
        let place = path.strip_prefix(src()).unwrap();
        let place = place.to_str().unwrap().replace('\\', "/");
        let text = fs::read_to_string(&path).unwrap();
        // a recorder passes the question on
        let asked = text.matches("R::ENABLED").count();
        if 0 < asked && !place.starts_with("trace/") {
            found.push((place.clone(), asked));
        }
        let enters = text.contains("strategy::fast") && !place.starts_with("strategy/fast/");
        assert!(!enters || place == "strategy/chosen.rs", "{place}");
    }
    found.sort();
    let expected = expected.map(|(place, asked)| (place.to_owned(), asked));
    assert_eq!(found, expected);
}
