//! `raystep lesson export`: what a lecturer hands out, and what checks the hand-in.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use raystep::lesson::exercise::{Seeds, exercises};

use super::run::{Folder, Ran};

/// Exercises whose cases are all made by hand: the hand-in is checked with the public ones.
const BY_HAND: [&str; 0] = [];

fn lessons() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons")
}

/// The files below a folder, with their paths from there.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fn add(below: &Path, folder: &Path, files: &mut BTreeMap<String, Vec<u8>>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                add(below, &path, files);
            } else {
                let name = path
                    .strip_prefix(below)
                    .unwrap()
                    .to_string_lossy()
                    .replace('\\', "/");
                files.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    let mut found = BTreeMap::new();
    add(folder, folder, &mut found);
    found
}

/// The lines of the solutions that the exercises do not have.
fn lines_of_solutions() -> BTreeSet<String> {
    /// Shorter lines stand in any program.
    const LEAST: usize = 20;
    let mut lines = BTreeSet::new();
    for entry in fs::read_dir(lessons()).unwrap() {
        let folder = entry.unwrap().path();
        let Ok(solution) = fs::read_to_string(folder.join("solution.rs")) else {
            continue;
        };
        let exercise = fs::read_to_string(folder.join("exercise.rs")).unwrap();
        let known: BTreeSet<&str> = exercise.lines().map(str::trim).collect();
        let own = solution.lines().map(str::trim);
        let own = own.filter(|line| LEAST <= line.len() && !known.contains(line));
        lines.extend(own.map(str::to_owned));
    }
    assert!(100 < lines.len(), "{}", lines.len());
    lines
}

fn exported(folder: &Folder, words: &str) -> BTreeMap<String, Vec<u8>> {
    let source = env!("CARGO_MANIFEST_DIR");
    let name = words.split(' ').next().unwrap();
    folder
        .run(&format!("lesson export {words} --raystep {source}"))
        .well();
    files(&folder.path(name))
}

#[test]
fn no_file_has_a_line_of_a_solution() {
    let folder = Folder::empty();
    let solutions = lines_of_solutions();
    for words in ["handout", "grading --secret abcdefghijklmnop"] {
        let files = exported(&folder, words);
        for (path, bytes) in &files {
            assert!(
                !path.ends_with("solution.rs") && !path.contains("tracer."),
                "{path}"
            );
            let text = String::from_utf8_lossy(bytes);
            for line in text.lines().map(str::trim) {
                assert!(!solutions.contains(line), "{words}: {path}: {line}");
            }
            // nothing asks for them either
            if path.starts_with("run/") {
                assert!(!text.contains("solutions"), "{words}: {path}");
            }
        }
        assert!(files.contains_key("12-grid/exercise.rs") && files.contains_key("run/run.rs"));
        assert!(files.contains_key("any-language/README.md"));
    }
    // what is handed out and what checks it are beside each other, and nothing else is
    assert_eq!(folder.names(), ["grading", "handout"]);
}

#[test]
fn what_is_handed_out_says_nothing_of_the_secret_and_the_secret_alone_makes_the_cases() {
    let folder = Folder::empty();
    let handout = exported(&folder, "handout");
    let [one, same, other] = [
        ("one", "the-first-secret"),
        ("same", "the-first-secret"),
        ("other", "the-second-one"),
    ]
    .map(|(name, secret)| exported(&folder, &format!("{name} --secret {secret}")));
    assert_eq!(one, same);
    let differ = |a: &BTreeMap<String, Vec<u8>>, b: &BTreeMap<String, Vec<u8>>| -> Vec<String> {
        let paths: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
        let differ = paths
            .into_iter()
            .filter(|path| a.get(*path) != b.get(*path));
        differ.cloned().collect()
    };
    assert_eq!(differ(&one, &other), ["run/hand_in.rs"]);
    assert_eq!(
        differ(&handout, &one),
        [
            ".github/workflows/classroom.yml",
            "README.md",
            "run/hand_in.rs"
        ]
    );
    let cases = |files: &BTreeMap<String, Vec<u8>>| {
        let text = String::from_utf8(files["run/hand_in.rs"].clone()).unwrap();
        assert!(text.contains("HAS_OTHERS: bool = true"), "{text}");
        text
    };
    assert!(cases(&handout).contains("SECRET: Option<&str> = None;"));
    assert!(cases(&one).contains("SECRET: Option<&str> = Some(\"the-first-secret\");"));
    assert!(cases(&other).contains("SECRET: Option<&str> = Some(\"the-second-one\");"));
}

#[test]
fn cases_of_two_secrets_and_of_the_public_course_have_none_in_common() {
    let [public, one, same, other] = [
        Seeds::PUBLIC,
        Seeds::of_secret("first secret"),
        Seeds::of_secret("first secret"),
        Seeds::of_secret("first secre"),
    ];
    let mut by_hand = Vec::new();
    for of in exercises() {
        let id = of.about().id();
        let given = |seeds: &Seeds| of.given(seeds);
        assert_eq!(given(&one), given(&same), "{id}");
        let public: BTreeSet<String> = given(&public).into_iter().collect();
        let [one, other] =
            [one, other].map(|seeds| given(&seeds).into_iter().collect::<BTreeSet<_>>());
        if one == public {
            by_hand.push(id);
            continue;
        }
        assert!(4 <= one.len(), "{id}: {one:?}");
        assert_eq!(one.intersection(&public).next(), None, "{id}");
        let shared = one.intersection(&other).count();
        // where a case is a few whole numbers, some come twice by chance
        assert!(shared * 4 <= one.len(), "{id}: {shared} of {}", one.len());
    }
    assert_eq!(by_hand, BY_HAND);
}

#[test]
fn the_workflow_has_one_command_for_each_exercise() {
    let folder = Folder::empty();
    let files = exported(&folder, "handout");
    let workflow = String::from_utf8(files[".github/workflows/classroom.yml"].clone()).unwrap();
    let ids: Vec<String> = exercises().iter().map(|of| of.about().id()).collect();
    let commands: Vec<&str> = workflow
        .lines()
        .filter_map(|line| {
            line.trim().strip_prefix(
                "command: cargo test --quiet --package lessons --test check -- --exact ",
            )
        })
        .collect();
    assert_eq!(commands, ids);
    for id in &ids {
        let result = format!(
            "          {}_RESULTS: ${{{{ steps.{id}.outputs.result }}}}",
            id.to_uppercase()
        );
        assert!(workflow.lines().any(|line| line == result), "{result}");
    }
    let runners = workflow
        .lines()
        .last()
        .unwrap()
        .trim()
        .strip_prefix("runners: ")
        .unwrap();
    assert_eq!(runners.split(',').collect::<Vec<_>>(), ids);
    assert!(!workflow.contains('{') || workflow.matches("${{").count() == ids.len());
    assert!(!workflow.contains('\t'));
}

#[test]
fn nothing_is_written_over_and_nothing_stays_half_written() {
    let folder = Folder::empty();
    fs::create_dir(folder.path("taken")).unwrap();
    let folder = folder.with("taken/mine.txt", "mine").with("file", "mine");
    let message = folder.run("lesson export taken").refused();
    assert!(
        message.contains("taken is there already, and not empty"),
        "{message}"
    );
    let message = folder.run("lesson export file").refused();
    assert!(message.contains("file is there already"), "{message}");
    // below a file there can be no folder
    let message = folder.run("lesson export file/handout").refused();
    assert!(message.contains("file/handout"), "{message}");
    let message = folder.run("lesson export new --raystep nowhere").refused();
    assert!(message.contains("there is no Cargo.toml"), "{message}");
    let message = folder
        .command("lesson export new --secret")
        .arg(" ")
        .output()
        .unwrap();
    let message = Ran::from(message).refused();
    assert!(message.contains("the secret is empty"), "{message}");
    assert_eq!(folder.names(), ["file", "taken"]);
    assert_eq!(folder.read("taken/mine.txt"), b"mine");
    // an empty folder is as good as a new one
    fs::create_dir(folder.path("empty")).unwrap();
    exported(&folder, "empty");
    assert!(folder.path("empty/README.md").is_file());
    folder
        .run("lesson export from-git --raystep https://example.org/raystep.git")
        .well();
    let short = folder.run("lesson export short --secret 7").noted();
    assert!(short.contains("this secret is short"), "{short}");
    let package = String::from_utf8(folder.read("from-git/run/Cargo.toml")).unwrap();
    assert!(
        package.contains("raystep = { git = \"https://example.org/raystep.git\""),
        "{package}"
    );
}
