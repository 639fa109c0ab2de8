//! `raystep lesson`: the course is written out, listed, shown, and hinted at.

use std::fs;
use std::path::Path;

use super::run::Folder;

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

#[test]
fn a_new_folder_has_the_course_with_the_core_from_where_it_is_said() {
    let folder = Folder::empty();
    let source = env!("CARGO_MANIFEST_DIR");
    folder
        .run(&format!("lesson start mine --raystep {source}"))
        .well();
    let there = |file: &str| text(folder.read(&format!("mine/{file}")));
    assert_eq!(
        there("Cargo.toml"),
        "[workspace]\nmembers = [\"run\"]\nresolver = \"3\"\n"
    );
    let path = fs::canonicalize(source).unwrap();
    let line = format!("raystep = {{ path = {path:?}, default-features = false }}");
    assert!(there("run/Cargo.toml").contains(&line));
    for file in [
        "04-sphere/exercise.rs",
        "04-sphere/roots.json",
        "run/lib.rs",
    ] {
        let original = Path::new(source).join("lessons").join(file);
        assert_eq!(there(file), fs::read_to_string(original).unwrap());
    }
    // nothing is written over what a student has written
    let message = folder.run("lesson start mine").refused();
    assert!(
        message.contains("mine is there already, and not empty"),
        "{message}"
    );
    folder.run("lesson start other").well();
    let version = format!("raystep = {{ version = \"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(text(folder.read("other/run/Cargo.toml")).contains(&version));
    let message = folder.run("lesson start third --raystep nowhere").refused();
    assert!(
        message.contains("there is no Cargo.toml in this folder"),
        "{message}"
    );
}

#[test]
fn the_list_says_what_the_last_check_said() {
    let report = |state: &str| format!(r#"{{"exercise":"x","state":"{state}","message":[]}}"#);
    let folder = Folder::empty();
    fs::create_dir_all(folder.path("target/lessons")).unwrap();
    let folder = folder
        .with("target/lessons/l04_roots.json", report("right"))
        .with("target/lessons/l04_coefficients.json", report("wrong"))
        .with("target/lessons/l06_inside.json", report("broken"))
        .with("target/lessons/l05_blocked.json", "cut o");
    let list = text(folder.run("lesson list").well());
    let line = |name: &str| list.lines().find(|line| line.contains(name)).unwrap();
    assert!(line(" roots ").starts_with("● 04 roots "));
    assert!(line(" coefficients ").starts_with("◐ 04"));
    assert!(line(" inside ").starts_with("◐ 06"));
    assert!(line(" blocked ").starts_with("○ 05"));
    assert!(line(" walk ").starts_with("○ 12"));
    assert!(
        list.contains("\n1 of 42 right when they were last checked\n"),
        "{list}"
    );
    assert!(
        list.ends_with(" questions in 12 lessons: raystep lesson quiz 01\n"),
        "{list}"
    );
}

#[test]
fn hints_go_deeper_one_by_one() {
    let folder = Folder::empty();
    let hint = |words: &str| text(folder.run(&format!("lesson hint {words}")).well());
    let nudge = hint("04 roots");
    assert_eq!(nudge.lines().count(), 3, "{nudge}");
    assert!(nudge.ends_with("  more: raystep lesson hint 04 roots --depth 2\n"));
    let formula = hint("4 roots --depth 2");
    assert!(formula.contains("t = (−b ± √(b² − 4ac)) / 2a"), "{formula}");
    let line = hint("04 l04_roots --depth 3");
    assert_eq!(line.lines().count(), 4, "{line}");
    assert!(!line.contains("more:"));
    for (words, expected) in [
        (
            "04 root",
            "its exercises are coefficients, roots, root_that_counts",
        ),
        ("13 roots", "the lessons are 1 to 12"),
    ] {
        let message = folder.run(&format!("lesson hint {words}")).refused();
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn a_lesson_shows_its_functions() {
    let folder = Folder::empty();
    fs::create_dir_all(folder.path("lessons/04-sphere")).unwrap();
    let shown = text(folder.run("lesson show 04").well());
    assert!(
        shown.starts_with("Lesson 4: write in lessons/04-sphere/exercise.rs\n"),
        "{shown}"
    );
    assert!(shown.contains("\n10 questions: raystep lesson quiz 04\n"));
    assert!(shown.contains("pub fn roots(a: f64, b: f64, c: f64) -> Vec<f64>"));
    assert!(shown.contains("cargo test -p lessons l04_roots"));
    let message = folder.run("lesson check 04 roots").refused();
    assert!(
        message.contains("there is no Cargo.toml in this folder"),
        "{message}"
    );
}
