//! The bars: well-formed, finite, and nothing lies over anything else.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use raystep::figure::{cost_chart, text_width};
use roxmltree::{Document, Node};

use super::{lesson, made_up};
use crate::cli::run::Folder;
use crate::layers::sources;

/// Left, top, right, bottom.
type Frame = [f64; 4];

fn attribute(node: Node, name: &str) -> f64 {
    let text = node
        .attribute(name)
        .unwrap_or_else(|| panic!("{name} of {node:?}"));
    let value: f64 = text.parse().unwrap();
    assert!(value.is_finite(), "{name} of {node:?}");
    value
}

fn size(root: Node) -> f64 {
    attribute(root, "font-size")
}

/// The most room that a text can take.
fn frame(text: Node, size: f64) -> Frame {
    let width = text_width(text.text().unwrap()) * size;
    let [x, y] = ["x", "y"].map(|name| attribute(text, name));
    let left = match text.attribute("text-anchor") {
        None => x,
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        Some(other) => panic!("{other}"),
    };
    // from the capitals' top to below the longest letter
    [left, y - 0.75 * size, left + width, y + 0.25 * size]
}

fn overlap(a: Frame, b: Frame) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

#[track_caller]
fn check(svg: &str) {
    let document = Document::parse(svg).unwrap();
    let root = document.root_element();
    assert_eq!(root.attribute("role"), Some("img"));
    assert!(
        !svg.trim_end().contains("\n\n"),
        "an empty line ends a block of HTML"
    );

    let all = || root.descendants().filter(Node::is_element);
    let ids: Vec<&str> = all().filter_map(|node| node.attribute("id")).collect();
    assert_eq!(
        ids.iter().collect::<BTreeSet<_>>().len(),
        ids.len(),
        "{ids:?}"
    );
    let own = root.attribute("id").unwrap();
    assert!(ids.iter().all(|id| id.starts_with(own)), "{ids:?}");
    let labels = root.attribute("aria-labelledby").unwrap();
    assert!(labels.split(' ').all(|id| ids.contains(&id)), "{labels}");

    let view: Vec<f64> = root
        .attribute("viewBox")
        .unwrap()
        .split(' ')
        .map(|n| n.parse().unwrap())
        .collect();
    let size = size(root);
    assert!(14.0 * view[2] / 760.0 <= size);
    let texts: Vec<(String, Frame)> = all()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| (node.text().unwrap().into(), frame(node, size)))
        .collect();
    let mut drawn: Vec<(String, Frame)> = Vec::new();
    for node in all() {
        match node.tag_name().name() {
            "path" => {
                let data = node.attribute("d").unwrap();
                let numbers = data.split(['M', 'L', ' ']).filter(|word| !word.is_empty());
                let numbers: Vec<f64> = numbers.map(|word| word.parse().unwrap()).collect();
                let [x1, y1, x2, y2] = numbers[..] else {
                    panic!("not a straight line: {data}");
                };
                drawn.push((
                    "a line".into(),
                    [x1.min(x2), y1.min(y2), x1.max(x2), y1.max(y2)],
                ));
            }
            "rect" => {
                let [x, y, width, height] =
                    ["x", "y", "width", "height"].map(|name| attribute(node, name));
                assert!(0.0 < width && 0.0 < height, "{node:?}");
                // all but the ground
                if width < view[2] {
                    drawn.push(("a bar".into(), [x, y, x + width, y + height]));
                }
            }
            _ => {}
        }
    }
    let inside = |frame: &Frame| {
        let [right, bottom] = [view[0] + view[2], view[1] + view[3]];
        view[0] <= frame[0] && view[1] <= frame[1] && frame[2] <= right && frame[3] <= bottom
    };
    for (i, (text, frame)) in texts.iter().enumerate() {
        assert!(inside(frame), "{text} lies outside: {frame:?}");
        for (other, with) in drawn.iter().chain(&texts[..i]) {
            assert!(
                !overlap(*frame, *with),
                "{text} {frame:?} lies over {other} {with:?}"
            );
        }
    }
    for (what, frame) in &drawn {
        assert!(inside(frame), "{what} lies outside: {frame:?}");
    }
}

#[test]
fn a_chart_is_well_formed_and_nothing_overlaps_whatever_the_counts() {
    let scene = lesson();
    for numbers in [
        vec![
            [104_857_600, 0],
            [1, 9],
            [0, 0],
            [10, 11],
            [99, 100],
            [7, 7],
            [1, 1],
            [2, 3],
            [1000, 999],
        ],
        vec![[0, 0]],
        vec![[1, 0]],
        vec![[u64::MAX / 2, 1], [3, u64::MAX]],
        vec![],
    ] {
        check(&cost_chart("a-chart", &made_up(&scene, &numbers)));
    }
}

#[test]
fn the_numbers_of_the_command_are_in_the_drawing() {
    let folder = Folder::with_scene();
    let words = "compare scene.json --pixels 16,12 --format json --chart c.svg";
    let json: serde_json::Value = serde_json::from_slice(&folder.run(words).well()).unwrap();
    let svg = String::from_utf8(folder.read("c.svg")).unwrap();
    check(&svg);
    let document = Document::parse(&svg).unwrap();
    let texts: Vec<&str> = document
        .descendants()
        .filter(|n| n.has_tag_name("text"))
        .filter_map(|n| n.text())
        .collect();
    let description = document
        .descendants()
        .find(|n| n.has_tag_name("desc"))
        .unwrap();
    for entry in json["strategies"].as_array().unwrap() {
        let name = entry["name"].as_str().unwrap();
        let at = texts.iter().position(|text| *text == name).unwrap();
        let tests = entry["object_tests"].as_u64().unwrap();
        let searched = ["bound_tests", "nodes", "cells"].map(|key| entry[key].as_u64().unwrap());
        let searched: u64 = searched.iter().sum();
        // the total stands behind the bar, with its parts if there are two
        let numbers: Vec<u64> = texts[at + 1]
            .split(['=', '+'])
            .map(|number| number.replace(' ', "").parse().unwrap())
            .collect();
        let total = tests + searched;
        let parts = [total, tests, searched];
        let expected = if tests == 0 || searched == 0 {
            &parts[..1]
        } else {
            &parts[..]
        };
        assert_eq!(numbers, expected, "{name}");
        let [total, tests, searched] = parts.map(raystep::explain::grouped);
        let told = format!(
            "{name}: {total} tests in all, {tests} of objects and {searched} of bounds, nodes and cells."
        );
        assert!(description.text().unwrap().contains(&told), "{told}");
    }
    let again = folder.run("compare scene.json --pixels 16,12 --chart d.svg --threads 1");
    assert_eq!(again.code, Some(0));
    assert!(folder.read("d.svg") == svg.as_bytes());
}

#[test]
fn a_bar_is_as_long_as_its_tests_are_many() {
    let scene = lesson();
    let svg = cost_chart(
        "c",
        &made_up(&scene, &[[5, 0], [10, 0], [100, 0], [200, 0]]),
    );
    let document = Document::parse(&svg).unwrap();
    let full = document.descendants().filter(|node| {
        let is_full = node.attribute("fill-opacity").is_none();
        is_full
            && node
                .attribute("class")
                .is_some_and(|class| class.contains("c_visited-area"))
    });
    // the first one is the legend's; the dearest strategy is told first and stands below the others
    let mut widths: Vec<f64> = full.skip(1).map(|bar| attribute(bar, "width")).collect();
    widths.reverse();
    assert_eq!(widths.len(), 4);
    for (width, tests) in widths.iter().zip([5.0, 10.0, 100.0, 200.0]) {
        // numbers in a drawing are rounded to hundredths
        let expected = widths[3] * tests / 200.0;
        assert!((width - expected).abs() <= 0.02, "{widths:?}");
    }
}

#[test]
fn one_file_alone_names_the_crate_that_writes_svg() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut checked = 0;
    for path in sources(&folder) {
        let text = fs::read_to_string(&path).unwrap();
        let names = text.lines().any(|line| line.starts_with("use svg::"));
        assert_eq!(
            names,
            path.ends_with("figure/sheet/canvas.rs"),
            "{}",
            path.display()
        );
        checked += 1;
    }
    assert!(100 < checked, "{checked}");
}
