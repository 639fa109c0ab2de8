//! Data flows one way: a layer uses the layers before it and none after it.

#[path = "layers/imports.rs"]
mod imports;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use imports::{Modules, circle, program};

/// From pure mathematics to the command line.
const LAYERS: [&str; 17] = [
    "parallel",
    "geometry",
    "scene",
    "structure",
    "trace",
    "strategy",
    "tracer",
    "mistake",
    "explain",
    "figure",
    "step",
    "page",
    "lesson",
    "files",
    "book",
    "tui",
    "cli",
];

/// The layers that run anywhere: no file system, no clock, no threads of their own, no words of a command line.
const CORE: [&str; 12] = [
    "geometry",
    "scene",
    "structure",
    "trace",
    "strategy",
    "tracer",
    "mistake",
    "explain",
    "figure",
    "step",
    "page",
    "lesson",
];

/// Every crate that a layer may name, and which layers may; the command line may name any.
const CRATES_OF: [(&str, &[&str]); 23] = [
    ("anstyle", &["explain"]),
    ("base64", &["trace", "figure", "page", "lesson"]),
    ("flate2", &["page"]),
    ("font8x8", &["figure"]),
    (
        "glam",
        &[
            "geometry",
            "scene",
            "structure",
            "trace",
            "strategy",
            "tracer",
            "mistake",
            "explain",
            "figure",
            "step",
            "lesson",
            "book",
        ],
    ),
    ("itoa", &["trace"]),
    (
        "libm",
        &[
            "geometry",
            "scene",
            "structure",
            "mistake",
            "explain",
            "figure",
            "lesson",
        ],
    ),
    ("math_core", &["book"]),
    ("memchr", &["scene", "trace"]),
    ("png", &["trace"]),
    ("pulldown_cmark", &["book"]),
    ("rand", &["tracer"]),
    ("ratatui", &["tui"]),
    ("rayon", &["parallel"]),
    ("robust", &["geometry"]),
    (
        "schemars",
        &["scene", "structure", "trace", "figure", "lesson"],
    ),
    (
        "serde",
        &[
            "scene",
            "structure",
            "trace",
            "figure",
            "page",
            "lesson",
            "book",
        ],
    ),
    (
        "serde_json",
        &[
            "scene", "trace", "explain", "figure", "step", "page", "lesson", "book",
        ],
    ),
    ("serde_path_to_error", &["scene"]),
    ("smol_str", &["scene", "trace"]),
    ("strsim", &["scene"]),
    ("svg", &["figure"]),
    ("zmij", &["trace"]),
];

/// The crates of others.
const CRATES: [&str; 30] = [
    "anstream",
    "anstyle",
    "base64",
    "clap",
    "clap_complete",
    "ctrlc",
    "flate2",
    "font8x8",
    "glam",
    "indicatif",
    "itoa",
    "libm",
    "math_core",
    "memchr",
    "png",
    "pulldown_cmark",
    "rand",
    "ratatui",
    "rayon",
    "resvg",
    "robust",
    "schemars",
    "serde",
    "serde_json",
    "serde_path_to_error",
    "signal_hook",
    "smol_str",
    "strsim",
    "svg",
    "zmij",
];

/// What draws, explains and steps sees events and the scene, never how they were made.
const FROM_EVENTS_ALONE: [&str; 4] = ["explain", "figure", "step", "page"];

/// Files that unit tests alone compile: they may make with a layer above what they test with.
const FOR_TESTS: [&str; 1] = ["figure/read_back.rs"];

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
            let for_tests = FOR_TESTS.iter().any(|file| path.ends_with(file));
            assert!(
                for_tests || of <= layer,
                "{place}: {used} lies above {}",
                LAYERS[layer]
            );
            let events_alone = FROM_EVENTS_ALONE.contains(&LAYERS[layer]);
            let traces = ["strategy", "tracer"].contains(&used);
            assert!(!(events_alone && traces), "{place}: uses {used}");
            checked += 1;
        }
    }
    assert!(50 < checked, "only {checked} paths were found");
}

/// The crates of others that a source names.
fn crates(text: &str) -> impl Iterator<Item = &str> {
    CRATES.into_iter().filter(move |name| {
        let path = format!("{name}::");
        text.match_indices(&path).any(|(at, _)| {
            let before = text[..at].chars().next_back();
            !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':')
        })
    })
}

#[test]
fn each_layer_uses_its_own_crates_alone() {
    let mut checked = 0;
    for path in sources(&src()) {
        let Some(layer) = layer_of(&path).map(|layer| LAYERS[layer]) else {
            continue;
        };
        if layer == "cli" {
            continue;
        }
        let text = program(&fs::read_to_string(&path).unwrap());
        for used in crates(&text) {
            let users = CRATES_OF.iter().find(|(name, _)| *name == used);
            let may = users.is_some_and(|(_, layers)| layers.contains(&layer));
            assert!(may, "{}: {used}", path.display());
            checked += 1;
        }
    }
    assert!(200 < checked, "only {checked} crates were found");
}

#[test]
fn the_core_has_no_clock_no_files_no_threads_and_no_words_of_a_command_line() {
    // the variables of style sheets
    let variables = [
        "figure/sheet/look.rs",
        "figure/sheet/canvas.rs",
        "explain/render/html.rs",
    ]
    .map(|file| src().join(file));
    let forbidden = [
        "std::fs",
        "std::env",
        "std::process",
        "std::thread",
        "std::net",
        "Instant",
        "SystemTime",
        "print!",
        "println!",
    ];
    let verbs = [
        "pixel", "trace", "render", "figure", "schema", "convert", "compare",
    ];
    for path in CORE.iter().flat_map(|layer| sources(&src().join(layer))) {
        let text = program(&fs::read_to_string(&path).unwrap());
        for word in forbidden {
            assert!(!text.contains(word), "{}: {word}", path.display());
        }
        for literal in text.split('"').skip(1).step_by(2) {
            let flag = literal.match_indices("--").any(|(at, _)| {
                let next = literal[at + 2..].chars().next();
                next.is_some_and(|c| c.is_ascii_lowercase())
            });
            assert!(
                !flag || variables.contains(&path),
                "{}: {literal:?}",
                path.display()
            );
            for verb in verbs {
                let command = format!("raystep {verb}");
                assert!(!literal.contains(&command), "{}: {command}", path.display());
            }
        }
    }
}

#[test]
fn powers_and_angles_come_from_one_crate_on_every_system() {
    let functions = [
        "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sin_cos", "powf", "exp", "ln",
        "log10", "log2", "cbrt", "hypot", "angle_to",
    ];
    for path in CORE.iter().flat_map(|layer| sources(&src().join(layer))) {
        let text = program(&fs::read_to_string(&path).unwrap());
        for function in functions {
            let call = format!(".{function}(");
            assert!(!text.contains(&call), "{}: {call}", path.display());
        }
        assert!(!text.contains("::from_angle"), "{}", path.display());
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

#[test]
fn no_circle_of_files_imports_from_each_other() {
    let arrows = Modules::of_library(&src()).arrows();
    let count: usize = arrows.values().map(BTreeSet::len).sum();
    assert!(1000 < count, "only {count} imports were found");
    if let Some(circle) = circle(&arrows) {
        panic!("these import from each other:\n  {}", circle.join("\n  "));
    }
}

#[test]
fn architecture_draws_the_layers_and_their_folders() {
    let text = fs::read_to_string(src().join("../ARCHITECTURE.md")).unwrap();
    let picture = text
        .split("```")
        .find(|block| block.starts_with("\nsrc/\n"));
    let mut drawn = Vec::new();
    for line in picture
        .unwrap()
        .lines()
        .filter(|line| line.starts_with("  "))
    {
        let mut words = line.split_whitespace();
        let name = words.next().unwrap();
        let folders: BTreeSet<String> = words
            .filter_map(|word| word.strip_suffix('/'))
            .map(str::to_owned)
            .collect();
        if let Some(layer) = name
            .strip_suffix('/')
            .or((name == "parallel.rs").then_some("parallel"))
        {
            drawn.push((layer.to_owned(), folders));
        }
    }
    let expected = LAYERS.map(|layer| {
        let mut folders = BTreeSet::new();
        if let Ok(entries) = fs::read_dir(src().join(layer)) {
            for entry in entries
                .map(Result::unwrap)
                .filter(|entry| entry.path().is_dir())
            {
                folders.insert(entry.file_name().into_string().unwrap());
            }
        }
        (layer.to_owned(), folders)
    });
    assert_eq!(drawn, expected);
}

#[test]
fn the_front_door_has_about_40_names_and_none_of_them_a_second_path() {
    let text = program(&fs::read_to_string(src().join("lib.rs")).unwrap());
    let mut names = 0;
    for import in text.split("pub use ").skip(1) {
        let import = import.split(';').next().unwrap();
        let (path, of_group) = import.rsplit_once("::").unwrap();
        let group = of_group.trim_matches(['{', '}']).split(',').map(str::trim);
        let layer = path.split("::").next().unwrap();
        let module = fs::read_to_string(src().join(layer).join("mod.rs")).unwrap();
        for name in group.filter(|name| !name.is_empty()) {
            names += 1;
            let again = module.split("\npub use ").skip(1).find(|import| {
                let import = import.split(';').next().unwrap();
                import
                    .split(|c: char| !c.is_alphanumeric() && c != '_')
                    .any(|word| word == name)
            });
            assert!(again.is_none(), "{layer}: {name} is at the root too");
        }
    }
    assert!((30..=45).contains(&names), "{names} names");
}
