//! The comparison's table fits a terminal of 80 columns and begins with the cheapest strategy.

use serde_json::Value;

use super::{LESSON, TWO_BALLS, json_of, text_of};
use crate::cli::run::{Folder, SCENE};

/// The rows of the narrow table: the strategy, and its numbers.
fn rows(text: &str) -> Vec<(String, Vec<String>)> {
    let table = text
        .lines()
        .skip_while(|line| !line.starts_with("strategy "));
    let rows = table.skip(1).take_while(|line| !line.is_empty());
    rows.map(|row| {
        let (name, numbers) = row.split_at(row.find("  ").unwrap());
        let numbers = numbers.split_whitespace().map(String::from);
        (name.to_owned(), numbers.collect())
    })
    .collect()
}

#[test]
fn the_table_of_the_lesson_and_of_own_slabs_fits_eighty_columns() {
    // what went wrong: the table of the lesson was 150 columns wide
    let slabs = "{ \"slabs\": [[1, 1, 0], [1, -1, 0], [0, 0, 1], [0, 1, 1]],";
    let long = SCENE.replacen('{', slabs, 1).replace(
        "\"two balls over a floor\"",
        "\"a scene whose name says at length what it shows, and then goes on with what it does not show\"",
    );
    for (scene, size) in [(LESSON, "128,128"), (&*long, "24,18")] {
        let folder = Folder::empty().with("s.json", scene);
        let text = text_of(&folder, &format!("compare s.json --pixels {size}"));
        for line in text.lines() {
            assert!(line.chars().count() <= 80, "{line}\n{text}");
        }
        assert!(13 <= rows(&text).len(), "{text}");
        // the kinds of object are one column
        let head = text.lines().find(|line| line.starts_with("strategy "));
        let head: Vec<&str> = head.unwrap().split_whitespace().collect();
        assert_eq!(
            head,
            [
                "strategy", "object", "tests", "search", "per", "ray", "share", "%"
            ]
        );
    }
}

#[test]
fn the_cheapest_strategy_comes_first_with_the_numbers_of_the_json() {
    let folder = Folder::empty();
    // a hundred spheres: every strategy saves most tests
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/09-cost/scene.json");
    let words = &format!("compare {scene} --pixels 24,18");
    let json = json_of(&folder, words);
    let number = |entry: &Value, key: &str| entry[key].as_u64().unwrap();
    let search = |entry: &Value| ["bound_tests", "nodes", "cells"].map(|key| number(entry, key));
    let mut expected: Vec<(u64, String, [String; 2])> = json["strategies"]
        .as_array()
        .unwrap()
        .iter()
        .map(|entry| {
            let (tests, search) = (
                number(entry, "object_tests"),
                search(entry).iter().sum::<u64>(),
            );
            let name = entry["name"].as_str().unwrap().to_owned();
            (
                tests + search,
                name,
                [tests.to_string(), search.to_string()],
            )
        })
        .collect();
    expected.sort_by_key(|(total, ..)| *total);
    // else the order of the table would be that of the list
    assert_ne!(expected[0].1, "exhaustive");

    let text = text_of(&folder, words);
    let found = rows(&text);
    assert_eq!(found.len(), expected.len(), "{text}");
    for ((name, numbers), (_, expected, cells)) in found.iter().zip(&expected) {
        assert_eq!(name, expected, "{text}");
        assert_eq!(numbers[..2], *cells, "{name}");
    }
    let rays = number(&json["strategies"][0], "rays");
    assert!(
        text.contains(&format!(
            "{} rays; sorted by",
            raystep::explain::grouped(rays)
        )),
        "{text}"
    );
}

#[test]
fn what_was_never_used_is_not_told() {
    // a square far behind the eye: its plane is tested, and never its outline
    let square = r#"    { "name": "S", "material": "red", "shape": { "polygon": { "vertices": [[-9, -9, 90], [9, -9, 90], [9, 9, 90], [-9, 9, 90]] } } },
    { "name": "A""#;
    let scene = TWO_BALLS.replacen("    { \"name\": \"A\"", square, 1);
    let folder = Folder::empty().with("s.json", scene);
    let text = text_of(&folder, "compare s.json");
    assert!(
        text.contains("\n  exhaustive\n    plane equations: computed once, used once\n"),
        "{text}"
    );
    // what went wrong: "projected outlines: computed once, used 0 times" under every strategy
    assert!(!text.contains("used 0 times"), "{text}");
    assert!(!text.contains("projected outlines"), "{text}");
    // programs have the number
    let json = json_of(&folder, "compare s.json");
    let first = &json["strategies"][0]["in_advance"]["projected_outlines"];
    assert_eq!((&first["computed"], &first["used"]), (&1.into(), &0.into()));
}

#[test]
fn wide_is_refused_where_it_changes_nothing() {
    let folder = Folder::with_scene();
    let message = folder
        .run("compare scene.json --wide --format csv")
        .refused();
    assert!(
        message.starts_with("error: --wide has no effect with --format csv"),
        "{message}"
    );
}
