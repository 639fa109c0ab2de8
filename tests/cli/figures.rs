//! `raystep figure` and `raystep figures`: files, logs, steps, and the check.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;

use super::run::Folder;

/// The middle ray of a ball straight ahead.
const SCENE: &str = r#"{ "name": "one ball",
  "camera": { "look_at": { "cop": [0, 0, 0], "target": [0, 0, -1], "up": [0, 1, 0], "fov_degrees": 40 },
              "pixels": [9, 9] },
  "materials": { "red": { "colour": [0.8, 0.2, 0.2], "diffuse": 0.7 } },
  "objects": [ { "name": "A", "material": "red", "shape": { "sphere": { "center": [0, 0, -5], "radius": 1 } } } ] }"#;

const LESSON: &str = r#"{ "title": "A ball", "figures": {
  "hit": { "kind": "rays", "scene": "scene.json", "pixel": [4, 4] },
  "picture": { "kind": "picture", "scene": "scene.json", "pixel": [4, 4] } } }"#;

/// A folder with one lesson of two figures.
pub(crate) fn course() -> Folder {
    let folder = Folder::empty();
    fs::create_dir_all(folder.path("lessons/01-ball")).unwrap();
    folder
        .with("lessons/01-ball/scene.json", SCENE)
        .with("lessons/01-ball/lesson.json", LESSON)
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

#[test]
fn the_committed_figures_are_what_is_drawn_today() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let lessons = root.join("lessons");
    let out = root.join("tests/figures");
    let words = format!(
        "figures --check --lessons {} --out {}",
        lessons.display(),
        out.display()
    );
    Folder::empty().run(&words).well();
}

#[test]
fn a_figure_is_the_same_twice_on_standard_output_and_in_a_file() {
    let folder = course();
    let first = text(folder.run("figure 01-ball/hit").well());
    folder.run("figure 01-ball/hit -o hit.svg").well();
    assert_eq!(text(folder.read("hit.svg")), first);
    assert!(first.starts_with("<svg") && first.contains("id=\"raystep-01-ball-hit\""));
}

#[test]
fn a_saved_log_draws_the_same_bytes_without_the_scene() {
    let folder = course();
    for name in ["hit", "picture"] {
        let drawn = folder.run(&format!("figure 01-ball/{name} --write-log {name}.jsonl"));
        let drawn = text(drawn.well());
        fs::rename(
            folder.path("lessons/01-ball/scene.json"),
            folder.path("away"),
        )
        .unwrap();
        let again = folder.run(&format!("figure 01-ball/{name} --log {name}.jsonl"));
        assert_eq!(text(again.well()), drawn, "{name}");
        fs::rename(
            folder.path("away"),
            folder.path("lessons/01-ball/scene.json"),
        )
        .unwrap();
    }
}

#[test]
fn the_log_of_a_figure_has_all_of_its_pixel_and_the_colour_of_the_last() {
    let folder = course();
    folder
        .run("figure 01-ball/hit --write-log hit.jsonl -o hit.svg")
        .well();
    let log = text(folder.read("hit.jsonl"));
    let colours = || {
        log.lines()
            .filter(|line| line.contains("\"kind\":\"pixel_colour\""))
    };
    assert_eq!(colours().count(), 2);
    let last = log.lines().last().unwrap();
    assert!(last.contains("\"kind\":\"pixel_colour\"") && last.contains("\"pixel\":[8,8]"));
    assert!(!log.contains("\"kind\":\"picture\""));
    let tests: Vec<&str> = log
        .lines()
        .filter(|line| line.contains("sphere_test"))
        .collect();
    assert!(
        tests.iter().all(|line| line.contains("\"pixel\":[4,4]")),
        "{tests:?}"
    );
    assert_eq!(tests.len(), 1);
    // it is a log as any other
    let worked = text(folder.run("pixel hit.jsonl 4,4").well());
    assert!(worked.contains("b² − 4ac = 100 − 96 = 4"), "{worked}");
}

#[test]
fn the_log_of_a_picture_holds_it_finer_than_the_pixels_of_its_scene() {
    let white = SCENE.replace("\"materials\"", "\"background\": [1, 1, 1], \"materials\"");
    let folder = course().with("lessons/01-ball/scene.json", &white);
    folder
        .run("figure 01-ball/picture --write-log p.jsonl -o p.svg")
        .well();
    let log = text(folder.read("p.jsonl"));
    let line = log
        .lines()
        .find(|line| line.contains("\"kind\":\"picture\""))
        .unwrap();
    let line: serde_json::Value = serde_json::from_str(line).unwrap();
    // 29 times 9 is the first multiple from 256 on
    assert_eq!(line["pixels"], serde_json::json!([261, 261]));
    assert_eq!(line["samples"], 4);
    // the drawing has the same PNG
    let svg = text(folder.read("p.svg"));
    let uri = format!("data:image/png;base64,{}", line["png"].as_str().unwrap());
    assert!(svg.contains(&uri));

    // no light shines on the ball: it is black before white, and a pixel of its edge is neither
    let png = BASE64.decode(line["png"].as_str().unwrap()).unwrap();
    let mut reader = png::Decoder::new(Cursor::new(png)).read_info().unwrap();
    let mut rgb = vec![0; 3 * 261 * 261];
    reader.next_frame(&mut rgb).unwrap();
    let row: Vec<[u8; 3]> = rgb[3 * 261 * 130..3 * 261 * 131]
        .chunks_exact(3)
        .map(|of| of.try_into().unwrap())
        .collect();
    assert_eq!([row[0], row[130]], [[255; 3], [0; 3]]);
    let edge = row.iter().position(|of| *of != [255; 3]).unwrap();
    // tan 20° is half of the window, and the silhouette of a ball of radius 1 at distance 5 is at 1/√24: it begins
    // 130.5 · (1 − 0.20412/0.36397) = 57.3 pixels from the left
    assert_eq!(edge, 57);
    assert_ne!(row[edge], [0; 3]);

    // a log without its last line, or without its picture, is refused
    let lines: Vec<&str> = log.lines().collect();
    let without = |left_out: usize| {
        let kept = lines.iter().enumerate().filter(|(at, _)| *at != left_out);
        kept.flat_map(|(_, line)| [*line, "\n"]).collect::<String>()
    };
    let picture = lines.iter().position(|line| line.contains("\"png\""));
    for left_out in [lines.len() - 1, picture.unwrap()] {
        let folder = course().with("cut.jsonl", without(left_out));
        let ran = folder.run("figure 01-ball/picture --log cut.jsonl");
        assert_eq!(ran.code, Some(2), "{}", ran.stderr);
        assert!(
            ran.stderr.contains("the log of this figure is not whole"),
            "{}",
            ran.stderr
        );
    }
}

#[test]
fn each_step_is_a_file_and_the_last_is_the_whole_figure() {
    let folder = course();
    folder.run("figure 01-ball/hit --steps -o hit.svg").well();
    let whole = text(folder.run("figure 01-ball/hit").well());
    let names: Vec<String> = folder
        .names()
        .into_iter()
        .filter(|name| name != "lessons")
        .collect();
    // the ray leaves, it hits the ball, and the pixel has its colour
    assert_eq!(names, ["hit-1.svg", "hit-2.svg", "hit-3.svg"]);
    assert_eq!(text(folder.read("hit-3.svg")), whole);
    // before the ray starts there is none
    let before = text(folder.run("figure 01-ball/hit --step 0").well());
    assert!(whole.contains("eye ray") && !before.contains(">eye ray<"));
}

#[test]
fn for_a_slide_letters_are_larger_and_for_print_there_is_no_colour() {
    let folder = course();
    let drawn = |options: &str| text(folder.run(&format!("figure 01-ball/hit {options}")).well());
    let book = drawn("");
    assert!(book.contains("width=\"760\"") && book.contains("viewBox=\"0 "));
    let slide = drawn("--width slide");
    assert!(slide.contains("viewBox=\"0 0 1280 720\"") && slide.contains("font-size=\"32\""));
    let alone = drawn("--standalone");
    assert!(!alone.contains("var(") && !alone.contains("<style"));
    let grey = drawn("--grayscale");
    let colours = grey.split('#').skip(1).map(|rest| &rest[..6]);
    for colour in colours {
        assert!(
            colour[..2] == colour[2..4] && colour[2..4] == colour[4..],
            "{colour}"
        );
    }
}

#[test]
fn the_check_tells_what_is_stale_missing_or_left_over() {
    let folder = course();
    folder.run("figures").well();
    folder.run("figures --check").well();

    fs::write(folder.path("figures/01-ball/hit.svg"), "old").unwrap();
    fs::remove_file(folder.path("figures/01-ball/picture.svg")).unwrap();
    fs::write(folder.path("figures/01-ball/gone.svg"), "").unwrap();
    let ran = folder.run("figures --check");
    assert_eq!(ran.code, Some(1));
    for line in [
        "figures/01-ball/hit.svg: differs",
        "figures/01-ball/picture.svg: is missing",
        "figures/01-ball/gone.svg: no lesson has this figure",
        "raystep figures --out figures",
    ] {
        assert!(ran.stderr.contains(line), "{}", ran.stderr);
    }
    // nothing was written
    assert_eq!(text(folder.read("figures/01-ball/hit.svg")), "old");
}

#[test]
fn names_that_look_like_markup_come_out_as_text() {
    let long = "n".repeat(300);
    for name in [
        "</svg><script>alert(1)</script>",
        "a\u{1}\u{1b}[31m\u{202e}b\u{200f}",
        &long,
    ] {
        let name = serde_json::Value::from(name).to_string();
        let scene = SCENE.replace("\"A\"", &name).replace("\"one ball\"", &name);
        let folder = course().with("lessons/01-ball/scene.json", scene);
        for figure in ["hit", "picture"] {
            let svg = text(folder.run(&format!("figure 01-ball/{figure}")).well());
            roxmltree::Document::parse(&svg).unwrap();
            assert!(!svg.contains("<script"), "{svg}");
            assert!(
                !svg.contains(['\u{1}', '\u{1b}', '\u{202e}', '\u{200f}']),
                "{svg:?}"
            );
        }
        let worked = text(folder.run("pixel lessons/01-ball/scene.json 4,4").well());
        assert!(
            !worked.contains(['\u{1}', '\u{1b}', '\u{202e}', '\u{200f}']),
            "{worked:?}"
        );
    }
}
