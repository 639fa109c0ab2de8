//! Whatever a file holds, it is read or refused with one error; nothing panics.
//!
//! Good files are damaged as editors, disks and people damage them: bytes are changed, pieces lost, doubled or brought
//! in from another file, numbers and words replaced by odd ones. Every damage follows from its number.

mod damage;

use std::any::Any;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

use raystep::book::NoCommands;
use raystep::explain::pixel_json;
use raystep::strategy::Exhaustive;
use raystep::tracer::trace_pixel;
use raystep::{
    FigureSpec, LoadError, LogReader, NoFiles, Off, Rendition, Settings, StrategyName, Through,
    Tracer, Transport, Width, WorkedOptions, load_bytes, preprocess, worked_solution,
};
use serde_json::json;

use crate::mutations::damage::damaged;
use crate::seeded::Seeded;
use crate::trace_log::{EXAMPLE, MIXED, all_of, built, log};

const SCENES: u64 = 5_000;
const NFFS: u64 = 4_000;
const OBJS: u64 = 4_000;
const LOGS: u64 = 4_000;
const LESSONS: u64 = 1_500;
const BOOKS: u64 = 1_500;

/// How many inputs there are to be in all.
const INPUTS: u64 = 20_000;

const NFF: &str = "b 0.1 0.2 0.3
v
from 0 1 6
at 0 1 0
up 0 1 0
angle 40
hither 1
resolution 16 12
l 4 6 5
f 0.8 0.2 0.2 0.7 0.3 40 0 1
s 0 1 0 1
f 1 1 1 0.05 0.3 40 0.85 1.5
c
2 0 0 0.5
2 2 0 0
p 4
-9 0 -9
-9 0 9
9 0 9
9 0 -9
pp 3
0 0 1 0 0 1
1 0 1 0 0.1 1
0 1 1 0.1 0 1
";

const OBJ: &str = "# a bent square and a triangle
mtllib none.mtl
o square
v 0 0 0
v 1 0 0 1
v 1 1 0.1
v 0 1 0
vt 0 0
vn 0 0 1
vn 0.1 0 1
usemtl red
f 1/1/1 2/1/2 3//1 4//2
f -1 -2 \\
  -3
l 1 2
";

/// A ball straight ahead, before a lamp: small, so that every figure of it takes a few milliseconds.
const BALL: &str = r#"{ "name": "one ball",
  "camera": { "look_at": { "cop": [0, 0, 0], "target": [0, 0, -1], "up": [0, 1, 0], "fov_degrees": 40 }, "pixels": [9, 9] },
  "lights": [ { "name": "lamp", "position": [2, 3, 0], "power": 90 } ],
  "materials": { "red": { "colour": [0.8, 0.2, 0.2], "diffuse": 0.7 } },
  "objects": [ { "name": "A", "material": "red", "shape": { "sphere": { "center": [0, 0, -5], "radius": 1 } } } ] }"#;

const LESSON: &str = r#"{ "title": "A ball", "figures": {
  "hit": { "kind": "rays", "scene": "scene.json", "pixel": [4, 4], "show": ["objects", "names", "eye", "ray", "hits"] },
  "seen": { "kind": "picture", "scene": "scene.json", "caption": "seen", "size": [6, 5] },
  "cells": { "kind": "grid", "scene": "scene.json", "pixel": [4, 4], "strategy": "grid", "view": "top",
             "structure": { "grid": { "resolution": [4, 4, 4], "lists": "boxes", "mailboxes": false } } },
  "light": { "kind": "paths", "scene": "scene.json", "pixel": [4, 4], "view": "side", "transport": "forward", "paths": 3,
             "light": { "seed": 7, "paths": 50, "bounces": 3 } } } }"#;

const CHAPTER: &str = "# One\n\nIt is {{#raystep-value 01-ball/hit sphere_test[0].discriminant}} or \
    {{#raystep-value 01-ball/hit sphere_test.count}}.\n\n{{#raystep 01-ball/hit step=3}}\n\n\
    > {{#raystep-log 01-ball/hit only=sphere_test}}\n> `{{#raystep 01-ball/hit}}` <!-- x -->\n\n\
    - {{#raystep-compare 01-ball/hit}}\n";

#[test]
fn the_inputs_are_as_many_as_they_are_said_to_be() {
    assert_eq!(SCENES + NFFS + OBJS + LOGS + LESSONS + BOOKS, INPUTS);
}

/// Damages one of the files for each number, and hands it to the reader. At least a part of what is read must be good and
/// a part bad, or the damage is too little or too much to find anything.
#[track_caller]
fn survives(seed: u64, count: u64, files: &[&[u8]], read: impl Fn(&[u8]) -> Result<(), String>) {
    for file in files {
        assert_eq!(read(file), Ok(()), "{}", String::from_utf8_lossy(file));
    }
    let (mut good, mut bad) = (0, 0);
    for number in 0..count {
        let mut random = Seeded::new((seed << 32) | number);
        let input = damaged(files, &mut random);
        let shown = || String::from_utf8_lossy(&input).into_owned();
        match catch_unwind(AssertUnwindSafe(|| read(&input))) {
            Ok(Ok(())) => good += 1,
            Ok(Err(error)) => {
                bad += 1;
                let is_one = !error.trim().is_empty()
                    && !error.contains(|c: char| c.is_control() && c != '\n')
                    && !error.contains("panicked");
                assert!(is_one, "input {number}: {error:?}\n{}", shown());
            }
            Err(panic) => panic!("input {number}: {}\n{}", told(&*panic), shown()),
        }
    }
    assert!(
        count / 50 < good && count / 10 < bad,
        "{good} good, {bad} bad"
    );
}

fn told(panic: &(dyn Any + Send)) -> &str {
    let owned = panic.downcast_ref::<String>().map(String::as_str);
    owned
        .or(panic.downcast_ref::<&str>().copied())
        .unwrap_or("a panic")
}

/// A scene, and if it is one, a pixel of it.
fn read_scene(file: &str, bytes: &[u8]) -> Result<(), String> {
    let traced = load_bytes(file, bytes, &NoFiles).and_then(|mut loaded| {
        // deeper trees take longer and show nothing else
        loaded.scene.max_depth = loaded.scene.max_depth.min(3);
        loaded.build()
    });
    match traced {
        Ok(scene) => {
            let strategy = Exhaustive::new(&scene);
            let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
            let [width, height] = scene.camera.pixels;
            // a scene whose rays are too many is stopped, which is no panic
            let _ = trace_pixel(&tracer, [width / 2, height / 2], Through::Centres, &mut Off);
            Ok(())
        }
        Err(error) => Err(of_two_lines(&error)),
    }
}

/// An error of the loader says in one line what and where, and in one what to do.
fn of_two_lines(error: &LoadError) -> String {
    let text = error.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert!(
        matches!(lines[..], [_, fix] if fix.starts_with("  ")),
        "{text:?}"
    );
    text
}

#[test]
fn damaged_scenes_are_traced_or_refused() {
    let files = [EXAMPLE, MIXED, BALL].map(str::as_bytes);
    survives(1, SCENES, &files, |bytes| read_scene("scene.json", bytes));
}

#[test]
fn damaged_nff_is_traced_or_refused() {
    survives(2, NFFS, &[NFF.as_bytes()], |bytes| {
        read_scene("scene.nff", bytes)
    });
}

#[test]
fn damaged_obj_is_traced_or_refused() {
    survives(3, OBJS, &[OBJ.as_bytes()], |bytes| {
        read_scene("scene.obj", bytes)
    });
}

#[test]
fn damaged_logs_are_told_or_refused() {
    let scene = built(&MIXED.replace("[9, 7]", "[2, 1]"));
    let small = built(&BALL.replace("[9, 9]", "[2, 2]"));
    let with = |strategy| Settings {
        strategy,
        building: true,
        ..Settings::default()
    };
    let logs = [
        log(
            &scene,
            &with(StrategyName::Exhaustive),
            &all_of(raystep::trace::Region::pixel([1, 0])),
        ),
        log(
            &small,
            &with(StrategyName::Grid),
            &all_of(raystep::trace::Region::whole([2, 2])),
        ),
        log(
            &small,
            &with(StrategyName::Hierarchy),
            &all_of(raystep::trace::Region::whole([2, 2])),
        ),
    ];
    let files: Vec<&[u8]> = logs.iter().map(Vec::as_slice).collect();
    survives(4, LOGS, &files, |bytes| {
        let pixel = [1, 0];
        let read = LogReader::open("log.jsonl", bytes).and_then(|log| log.pixel(pixel));
        let (scene, settings, records) = read.map_err(|error| error.to_string())?;
        worked_solution(&scene, &settings, &records, &WorkedOptions::default());
        pixel_json(&scene, &settings, &records);
        Ok(())
    });
}

/// A folder with one lesson.
fn course() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let lesson = folder.path().join("lessons/01-ball");
    fs::create_dir_all(&lesson).unwrap();
    fs::write(lesson.join("scene.json"), BALL).unwrap();
    fs::write(lesson.join("lesson.json"), LESSON).unwrap();
    folder
}

/// Is the figure drawn in a moment?
fn is_quick(spec: &FigureSpec) -> bool {
    let [width, height] = spec.size.unwrap_or([9, 9]);
    let light = &spec.light;
    let number = spec
        .structure
        .grid
        .resolution
        .map_or(0, |n| n.into_iter().max().unwrap_or(0));
    u64::from(width) * u64::from(height) <= 400
        && light.paths <= 1000
        && light.samples <= 4
        && light.map.is_none_or(|cells| cells <= 100)
        && number <= 50
        && spec.structure.grid.density <= 1000.0
}

#[test]
fn damaged_lessons_are_drawn_or_refused() {
    let course = course();
    let lessons = course.path().join("lessons");
    let file = lessons.join("01-ball/lesson.json");
    survives(5, LESSONS, &[LESSON.as_bytes()], |bytes| {
        fs::write(&file, bytes).unwrap();
        let library = raystep::open_lessons(&lessons).map_err(|error| error.to_string())?;
        for name in library.figures() {
            let (lesson, spec) = library.find(&name).map_err(|error| error.to_string())?;
            if !is_quick(spec) {
                continue;
            }
            let drawn = lesson.trace(&name.figure, spec).and_then(|traced| {
                let how = (Width::Book, Rendition::default());
                lesson.draw(&name.figure, spec, &traced, "id", how)
            });
            drawn.map_err(|error| error.to_string())?;
        }
        Ok(())
    });
}

#[test]
fn damaged_books_are_followed_or_refused() {
    let course = course();
    let chapter = json!({ "Chapter": {
        "name": "One", "content": CHAPTER, "number": [1], "sub_items": [],
        "path": "one.md", "source_path": "one.md", "parent_names": [] } });
    let context = json!({
        "root": course.path(), "renderer": "html", "mdbook_version": "0.5.4",
        "config": { "preprocessor": { "raystep": { "lessons": "lessons", "before": ["links"] } } } });
    let book = json!([context, { "items": [chapter] }]).to_string();
    survives(6, BOOKS, &[book.as_bytes()], |bytes| {
        match preprocess(bytes, &NoCommands) {
            Ok(_) => Ok(()),
            Err(error) => Err(error.to_string()),
        }
    });
    // the chapter alone, in a protocol that is whole
    survives(7, BOOKS / 10, &[CHAPTER.as_bytes()], |bytes| {
        let content = String::from_utf8_lossy(bytes);
        let mut chapter = chapter.clone();
        chapter["Chapter"]["content"] = content.into();
        let book = json!([context, { "items": [chapter] }]).to_string();
        preprocess(book.as_bytes(), &NoCommands)
            .map(drop)
            .map_err(|error| error.to_string())
    });
}
