//! Strategies on the command line: each verb takes each of them with its options.

use super::run::{Folder, SCENE};
use serde_json::Value;

/// Every strategy with every option of its own.
pub(crate) const WAYS: [&str; 20] = [
    "--strategy exhaustive",
    "--strategy bounds",
    "--strategy bounds --volume sphere",
    "--strategy bounds --volume ellipsoid",
    "--strategy bounds --volume box",
    "--strategy bounds --volume slabs",
    "--strategy bounds --volume slabs --slabs seven",
    "--strategy bounds --volume slabs --slabs scene",
    "--strategy hierarchy",
    "--strategy hierarchy --build insertion",
    "--strategy hierarchy --build surface-area --slabs seven",
    "--strategy hierarchy --build bottom-up --slabs scene",
    "--strategy heap",
    "--strategy heap --build surface-area --slabs scene",
    "--strategy grid",
    "--strategy grid --grid 5,1,2",
    "--strategy grid --density 0.5 --lists boxes",
    "--strategy grid --density 20 --no-mailboxes",
    "--strategy grid --lists objects --no-mailboxes --building",
    "--strategy z-aligned",
];

/// The scene of the design with slabs of its own.
fn folder() -> Folder {
    let slabs = "{ \"slabs\": [[1, 1, 0], [1, -1, 0], [0, 0, 1], [0, 1, 1]],";
    Folder::empty().with("scene.json", SCENE.replacen('{', slabs, 1))
}

#[test]
fn every_strategy_renders_the_same_picture_on_any_number_of_threads() {
    let folder = folder();
    let picture = |options: &str| {
        let words = format!("render scene.json --pixels 32,24 -o - {options}");
        folder.run(&words).well()
    };
    let expected = picture("");
    for (way, threads) in WAYS.into_iter().zip([1, 2, 3].into_iter().cycle()) {
        let found = picture(&format!("{way} --threads {threads}"));
        assert!(found == expected, "{way} on {threads} threads");
    }
}

#[test]
fn every_strategy_writes_a_log_that_is_explained_as_the_scene_is() {
    let folder = folder();
    let size = "--pixels 16,12";
    for way in WAYS.into_iter().filter(|way| !way.contains("--building")) {
        let words = format!("trace scene.json {size} --region 7,5-8,6 {way} -o a.jsonl");
        folder.run(&words).well();
        for options in ["", "--all", "--format json"] {
            let scene = folder.run(&format!("pixel scene.json {size} 8,6 {way} {options}"));
            let log = folder.run(&format!("pixel a.jsonl 8,6 {options}"));
            let [scene, log] = [scene, log].map(|ran| String::from_utf8(ran.well()).unwrap());
            assert!(scene == log, "{way} {options}\n{scene}\n{log}");
        }
    }
}

#[test]
fn the_head_of_a_log_names_the_strategy_and_what_was_chosen() {
    let folder = folder();
    let settings = |way: &str| -> Value {
        let words = format!("trace scene.json --region 8,6 --only ray {way}");
        let log = folder.run(&words).well();
        let first = log.split(|&byte| byte == b'\n').next().unwrap();
        let mut head: Value = serde_json::from_slice(first).unwrap();
        head["settings"].take()
    };
    assert!(settings("")["structure"].is_null());
    let heap = settings("--strategy heap --build insertion --slabs seven");
    assert_eq!(heap["strategy"], "heap");
    assert_eq!(heap["structure"]["build"], "insertion");
    assert_eq!(heap["structure"]["slabs"], "seven");
    let grid = settings("--strategy grid --grid 4,3,2 --lists boxes --no-mailboxes");
    assert_eq!(grid["strategy"], "grid");
    let [resolution, lists, mailboxes] =
        ["resolution", "lists", "mailboxes"].map(|key| grid["structure"]["grid"][key].clone());
    assert_eq!(resolution, serde_json::json!([4, 3, 2]));
    assert_eq!((lists, mailboxes), ("boxes".into(), false.into()));
}

/// How many lines of a log have all of these words.
fn count_lines(log: &[u8], words: &[(&str, &str)]) -> u64 {
    let lines = std::str::from_utf8(log).unwrap().lines();
    let has = |line: &&str| {
        let line: Value = serde_json::from_str(line).unwrap();
        words.iter().all(|(key, word)| line[*key] == *word)
    };
    lines.filter(has).count() as u64
}

#[test]
fn every_strategy_counts_of_its_search_what_its_log_has() {
    let folder = folder();
    let entered = ("outcome", "entered");
    for (way, counted, kind, of_kind) in [
        ("bounds", "bound_tests", "bound_test", None),
        ("hierarchy", "nodes_entered", "node", Some(entered)),
        ("heap", "nodes_entered", "node", Some(entered)),
        ("heap", "heap_pushes", "queue", Some(("action", "push"))),
        ("grid", "cells", "cell", None),
        ("z-aligned", "points_aligned", "aligned", None),
    ] {
        let words: Vec<_> = [("kind", kind)].into_iter().chain(of_kind).collect();
        let picture = format!("scene.json --pixels 16,12 --strategy {way}");
        let log = folder.run(&format!("trace {picture}")).well();
        let json = folder
            .run(&format!("render {picture} -o a.png --stats=json"))
            .well();
        let json: Value = serde_json::from_slice(&json).unwrap();
        let expected = count_lines(&log, &words);
        assert!(0 < expected, "{way}, {counted}");
        assert_eq!(json["search"][counted], expected, "{way}, {counted}");

        let pixel = format!("scene.json --strategy {way}");
        let log = folder.run(&format!("trace {pixel} --region 80,60")).well();
        let expected = count_lines(&log, &words).to_string();
        let stderr = folder.run(&format!("pixel {pixel} 80,60 --stats")).stderr;
        let counted = counted.replace('_', " ");
        let line = stderr.lines().find_map(|line| line.strip_prefix(&counted));
        assert_eq!(line.map(str::trim), Some(&*expected), "{way}\n{stderr}");
    }
}

#[test]
fn the_building_is_told_before_the_pixel() {
    let folder = folder();
    for (way, line) in [
        ("hierarchy", "D_min = min("),
        ("heap --slabs seven", "slab 6: D_min = min("),
        ("grid", "lists floor"),
    ] {
        let words = format!("pixel scene.json 80,60 --strategy {way}");
        let without = String::from_utf8(folder.run(&words).well()).unwrap();
        assert!(!without.contains("Building, before"), "{way}");
        let with = folder.run(&format!("{words} --building")).well();
        let with = String::from_utf8(with).unwrap();
        let built = with.find("Building, before the first ray").unwrap();
        let told = with.find(line).unwrap();
        let window = with.find("Window point: the pixel's centre").unwrap();
        assert!(built < told && told < window, "{way}\n{with}");
        // nothing else is told otherwise
        assert_eq!(
            with[window..],
            without[without.len() - (with.len() - window)..]
        );
    }
}
