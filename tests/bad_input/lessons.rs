//! Lessons and figures that make no sense: one message with file, line and path.

use std::fs;

use crate::cli::figures::course;
use crate::cli::run::Folder;

/// The message about a lesson file with this figure.
#[track_caller]
fn refuses(figure: &str, says: &[&str]) {
    let lesson = format!("{{ \"title\": \"t\", \"figures\": {{\n  \"f\": {figure} }} }}");
    let folder = course().with("lessons/01-ball/lesson.json", lesson);
    for words in ["figure 01-ball/f -o f.svg", "figures"] {
        let message = folder.run(words).refused();
        for part in says {
            assert!(message.contains(part), "{part}: {message}");
        }
        assert_eq!(folder.names(), ["lessons"], "{words} left something behind");
    }
}

#[test]
fn a_figure_that_cannot_be_drawn_is_told_with_its_line() {
    let at = |key: &str| format!("lessons/01-ball/lesson.json, line 2, at figures.f{key}: ");
    refuses(
        r#"{ "kind": "rays", "scene": "scene.json" }"#,
        &[&at(".pixel"), "add \"pixel\": [x, y]"],
    );
    refuses(
        r#"{ "kind": "rays", "scene": "scene.json", "pixel": [9, 0] }"#,
        &[
            &at(".pixel"),
            "pixel 9,0 is not in the picture of 9 × 9 pixels",
        ],
    );
    refuses(
        r#"{ "kind": "rays", "scene": "scene.json", "pixel": [4, 4], "show": ["tree"] }"#,
        &[&at(".show"), "nothing called tree", "choose among objects"],
    );
    refuses(
        r#"{ "kind": "picture", "scene": "scene.json", "size": [4000, 4000] }"#,
        &[
            &at(".picture"),
            "too many",
            "at most 4 million eye rays in all",
        ],
    );
    refuses(
        r#"{ "kind": "picture", "scene": "scene.json", "picture": { "finer": 9, "samples": 0 } }"#,
        &[&at(".picture"), "9 × 9 pixels with 0 × 0 eye rays each"],
    );
    refuses(
        r#"{ "kind": "heat", "scene": "scene.json", "size": [4000, 4000] }"#,
        &[&at(".size"), "too many", "[48, 36]"],
    );
    refuses(
        r#"{ "kind": "rays", "scene": "scene.json", "pixel": [4, 4], "strategy": "grid",
             "structure": { "grid": { "density": 0 } } }"#,
        &["figures.f.structure", "density"],
    );
    // what went wrong: the paths were followed for hours
    refuses(
        r#"{ "kind": "rays", "scene": "scene.json", "pixel": [4, 4], "transport": "hybrid-connected",
             "light": { "samples": 1000000 } }"#,
        &[
            "figures.f.light: 81000000 paths of light are too many for a figure",
            "10 million",
        ],
    );
}

#[test]
fn a_lesson_of_another_form_is_told_with_its_line() {
    for (figure, says) in [
        (
            r#"{ "kind": "ray", "scene": "scene.json" }"#,
            "figures.f.kind",
        ),
        (
            r#"{ "kind": "rays", "scene": "scene.json", "pixle": [4, 4] }"#,
            "unknown key `pixle`",
        ),
        (r#"{ "kind": "rays" }"#, "missing key `scene`"),
        (
            r#"{ "kind": "rays", "scene": "scene.json", "pixel": [4] }"#,
            "figures.f.pixel",
        ),
    ] {
        refuses(
            figure,
            &[says, "lesson.json, line ", "raystep schema lesson"],
        );
    }
    refuses(
        r#"{ "kind": "rays", "scene": "none.json", "pixel": [4, 4] }"#,
        &["lessons/01-ball/none.json"],
    );
}

#[test]
fn a_name_that_is_not_there_is_told_with_one_that_is() {
    let folder = course();
    for (words, says) in [
        ("figure 01-ball/hti", "did you mean 01-ball/hit?"),
        ("figure 1-ball/hit", "did you mean 01-ball/hit?"),
        (
            "figure 01-ball/zzz",
            "there are 01-ball/hit, 01-ball/picture",
        ),
        ("figure hit", "as in 12-grid/walk"),
        (
            "figure 01-ball/hit --lessons nowhere",
            "nowhere: the lessons cannot be read",
        ),
        (
            "figures --lessons lessons/01-ball",
            "there is no lesson in this folder",
        ),
    ] {
        let message = folder.run(words).refused();
        assert!(message.contains(says), "{words}: {message}");
    }
}

#[test]
fn a_lesson_name_that_is_no_name_is_refused() {
    let lesson =
        r#"{ "title": "t", "figures": { "../x": { "kind": "picture", "scene": "scene.json" } } }"#;
    let folder = course().with("lessons/01-ball/lesson.json", lesson);
    let message = folder.run("figures").refused();
    assert!(
        message.contains("\"../x\" is not a name for a figure"),
        "{message}"
    );
}

#[test]
fn a_log_that_is_not_the_figures_is_refused() {
    let folder = course()
        .with("empty.jsonl", "")
        .with("text.jsonl", "hello\n");
    folder
        .run("trace lessons/01-ball/scene.json --region 0,0 -o other.jsonl")
        .well();
    folder
        .run("figure 01-ball/picture --write-log picture.jsonl -o p.svg")
        .well();
    folder
        .run("figure 01-ball/hit --write-log hit.jsonl -o h.svg")
        .well();
    let log = String::from_utf8(folder.read("hit.jsonl")).unwrap();
    let lines = log.lines().count();
    let cut: String = log.split_inclusive('\n').take(lines - 1).collect();
    let folder = folder.with("cut.jsonl", cut);
    for (log, says) in [
        ("empty.jsonl", "empty.jsonl"),
        ("text.jsonl", "text.jsonl"),
        ("none.jsonl", "none.jsonl"),
        ("other.jsonl", "the log has no events of pixel 4,4"),
        (
            "picture.jsonl",
            "the log is that of the figure 01-ball/picture",
        ),
        ("cut.jsonl", "the log of this figure is not whole"),
    ] {
        let message = folder
            .run(&format!("figure 01-ball/hit --log {log}"))
            .refused();
        assert!(message.contains(says), "{log}: {message}");
    }
}

#[test]
fn several_files_do_not_go_to_standard_output() {
    let message = course().run("figure 01-ball/hit --steps").refused();
    assert!(message.contains("-o F.svg"), "{message}");
}

#[test]
#[cfg(not(feature = "raster"))]
fn without_the_feature_png_and_pdf_are_refused_and_the_way_is_told() {
    let folder = course();
    for words in ["--png", "--pdf", "-o f.png", "-o f.pdf"] {
        let message = folder.run(&format!("figure 01-ball/hit {words}")).refused();
        assert!(message.contains("--features raster"), "{message}");
    }
    assert_eq!(folder.names(), ["lessons"]);
}

#[test]
#[cfg(feature = "raster")]
fn with_the_feature_png_and_pdf_are_written() {
    let folder = course();
    for (words, begins) in [("-o f.png", &b"\x89PNG"[..]), ("-o f.pdf", b"%PDF")] {
        folder.run(&format!("figure 01-ball/hit {words}")).well();
        assert!(folder.read(&words[3..]).starts_with(begins), "{words}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_told() {
    let folder = course();
    fs::write(folder.path("file"), "").unwrap();
    let message = folder.run("figures --out file").refused();
    assert!(message.contains("file"), "{message}");
    assert_eq!(folder.read("file"), b"");
}

#[test]
fn an_empty_folder_has_no_lessons() {
    let folder = Folder::empty();
    fs::create_dir(folder.path("lessons")).unwrap();
    let message = folder.run("figures").refused();
    assert!(message.contains("lesson.json"), "{message}");
}
