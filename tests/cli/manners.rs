//! The manners of the command: tips, colours, silence, lists.

use super::figures::course;
use super::run::{Folder, SCENE};

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

#[test]
fn numbers_in_several_words_are_told_as_one_word() {
    let folder = Folder::with_scene();
    for (words, tip) in [
        // what went wrong: "60" was an unexpected argument, and nothing said how to write a pixel
        ("pixel scene.json 80 60", "80,60"),
        ("pixel scene.json 80, 60", "80,60"),
        ("pixel scene.json 80 ,60 --all", "80,60"),
        ("pixel scene.json --ray 2 80 60", "80,60"),
        ("compare scene.json 80 60", "80,60"),
        ("trace scene.json --region 80 60 -o a.jsonl", "80,60"),
        ("trace scene.json --region=80 60 -o a.jsonl", "80,60"),
        ("render scene.json --pixels 32 24 -o a.png", "32,24"),
        (
            "render scene.json --strategy grid --grid 4 5 6 -o a.png",
            "4,5,6",
        ),
    ] {
        let message = folder.run(words).refused();
        let told = format!("\n  tip: write it as one word: {tip}\n");
        assert!(message.contains(&told), "{words}: {message}");
    }
    // nothing to join: the number of words is another, or one of them is no number
    for words in [
        "pixel scene.json 80",
        "pixel scene.json 80 60 5",
        "pixel scene.json 80 --all",
        "pixel scene.json 80,60 --ray 1 2",
        "pixel scene.json left top",
        "render scene.json --strategy grid --grid 4 5 -o a.png",
    ] {
        let message = folder.run(words).refused();
        assert!(!message.contains("one word"), "{words}: {message}");
    }
}

/// Does the output of these words have colours, with a variable set or none?
fn has_colours(words: &str, variable: Option<&str>) -> bool {
    let mut command = Folder::with_scene().command(words);
    let folder = Folder::with_scene();
    command.current_dir(folder.path(""));
    if let Some(variable) = variable {
        command.env(variable, "1");
    }
    let output = command.output().unwrap();
    [output.stdout, output.stderr].concat().contains(&0x1b)
}

#[test]
fn colours_are_automatic_forced_or_off() {
    for words in ["pixel scene.json 80,60", "pixel --help", "pixel scene.json"] {
        let with = |option: &str, variable| has_colours(&format!("{words} {option}"), variable);
        // into a pipe, which is no terminal
        assert!(!with("", None), "{words}");
        assert!(!with("--color auto", Some("NO_COLOR")), "{words}");
        assert!(with("--color auto", Some("CLICOLOR_FORCE")), "{words}");
        assert!(with("--color always", None), "{words}");
        assert!(with("--color=always", Some("NO_COLOR")), "{words}");
        assert!(!with("--color never", Some("CLICOLOR_FORCE")), "{words}");
    }
    let message = Folder::with_scene().run("pixel scene.json 80,60 --color blue");
    let message = message.refused();
    assert!(
        message.contains("'auto', 'always', 'never'") || message.contains("auto, always, never"),
        "{message}"
    );
}

#[test]
fn quiet_silences_notes_and_no_errors() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
    let folder = Folder::empty().with("a.obj", obj).with("scene.json", SCENE);
    let note = folder.run("render a.obj --pixels 8,6 -o a.png").noted();
    assert_eq!(note, "note: a.obj: its materials are not read\n");
    folder
        .run("render a.obj --pixels 8,6 -o a.png --quiet")
        .well();
    folder
        .run("--quiet render a.obj --pixels 8,6 -o a.png")
        .well();
    let message = folder.run("pixel scene.json 999,0 --quiet").refused();
    assert!(
        message.contains("the picture has no pixel 999,0"),
        "{message}"
    );
    // what is asked for is no note
    let ran = folder.run("render a.obj --pixels 8,6 -o a.png --quiet --stats");
    assert!(ran.stderr.starts_with("strategy: "), "{}", ran.stderr);
}

#[test]
fn figures_are_listed_by_name_with_the_beginning_of_their_caption() {
    let folder = course();
    assert_eq!(
        text(folder.run("figures --list").well()),
        "01-ball/hit\n01-ball/picture\n"
    );
    let lesson = text(folder.read("lessons/01-ball/lesson.json"));
    let caption = "The ray goes straight ahead. ".repeat(9);
    let lesson = lesson.replacen("[4, 4]", &format!("[4, 4], \"caption\": \"{caption}\""), 1);
    let folder = folder.with("lessons/01-ball/lesson.json", lesson);
    // 80 columns less 15 of the longest name and 2 between: 63, and the next word would be the 64th
    let expected = "01-ball/hit      The ray goes straight ahead. The ray goes straight ahead. The…\n\
                    01-ball/picture\n";
    assert_eq!(text(folder.run("figures --list").well()), expected);
    // nothing is drawn, and no folder made
    assert_eq!(folder.names(), ["lessons"]);
    let message = folder.run("figures --list --check").refused();
    assert!(message.contains("cannot be used with"), "{message}");
}

#[test]
fn every_figure_of_the_course_is_listed_and_can_be_drawn_by_that_name() {
    let lessons = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let words = format!("figures --list --lessons {}", lessons.display());
    let list = text(Folder::empty().run(&words).well());
    let library = raystep::open_lessons(&lessons).unwrap();
    let names: Vec<String> = library.figures().iter().map(ToString::to_string).collect();
    let listed: Vec<&str> = list
        .lines()
        .filter_map(|line| line.split(' ').next())
        .collect();
    assert_eq!(listed, names);
    for line in list.lines() {
        assert!(line.chars().count() <= 80, "{line}");
    }
}

#[test]
fn the_readme_installs_the_command_before_it_is_first_called() {
    let readme = include_str!("../../README.md");
    let install = readme.find("cargo install --path .").unwrap();
    let called = readme.lines().find(|line| line.starts_with("raystep "));
    let first = readme.find(called.unwrap()).unwrap();
    assert!(install < first);
}

#[test]
fn the_readme_shows_what_the_command_prints() {
    let readme = include_str!("../../README.md");
    let lesson = include_str!("../../lessons/04-sphere/scene.json");
    let folder = Folder::empty().with("lessons.json", lesson);
    let printed = text(folder.run("pixel lessons.json 80,60").well());
    let (_, shown) = readme.split_once("```text\nRay 0").unwrap();
    let (shown, _) = shown.split_once("```").unwrap();
    let shown = format!("Ray 0{shown}");
    let mut rest = printed.lines();
    let lines: Vec<&str> = shown.lines().filter(|line| line.trim() != "…").collect();
    assert!(10 < lines.len(), "{shown}");
    for line in lines {
        assert!(rest.any(|printed| printed == line), "{line}\n{printed}");
    }
}
