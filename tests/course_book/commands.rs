//! The commands that a text shows in blocks of `sh`: each is run, in their order, in a folder of its own for each text.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What is not run: it installs something, needs the network, or compiles the exercises, which tests of their own do.
const NOT_RUN: [&str; 9] = [
    // mdBook calls it, and hands it the book
    "raystep mdbook",
    "cargo install",
    "cargo test",
    "cargo run -p lessons",
    "cargo doc",
    "cargo bench",
    "git clone",
    "mdbook build",
    "raystep lesson check",
];

/// What takes another way to the same command.
const SAME: [(&str, &str); 3] = [
    ("cargo run --features course -- ", "raystep "),
    ("cargo run --release -- ", "raystep "),
    ("cargo run -- ", "raystep "),
];

/// What ends with 1 where all is well: a log that differs.
const MAY_DIFFER: [&str; 1] = ["raystep check"];

/// Runs all commands of a text. Says how many were run, and what went wrong.
pub(super) fn run_all(root: &Path, file: &str, text: &str) -> (usize, Vec<String>) {
    let all = commands(text);
    if all.is_empty() {
        return (0, Vec::new());
    }
    let scratch = tempfile::tempdir().unwrap();
    super::copy(&root.join("lessons"), &scratch.path().join("lessons"));
    super::copy(&root.join("book"), &scratch.path().join("book"));
    super::copy(&root.join("src"), &scratch.path().join("src"));
    for file in ["Cargo.toml", "ARCHITECTURE.md"] {
        fs::copy(root.join(file), scratch.path().join(file)).unwrap();
    }
    let program = Path::new(env!("CARGO_BIN_EXE_raystep"));
    // a log that a reader has written
    let foreign = Command::new(program)
        .args([
            "trace",
            "lessons/any-language/scene.json",
            "-o",
            "mine.jsonl",
        ])
        .current_dir(scratch.path())
        .status();
    assert!(foreign.unwrap().success());

    let mut here = scratch.path().to_path_buf();
    let (mut run, mut faults) = (0, Vec::new());
    let mut last_block = 0;
    for (block, command) in all {
        // a reader begins each block in the folder of the project
        if block != last_block {
            here = scratch.path().to_path_buf();
            last_block = block;
        }
        if let Some(folder) = command.strip_prefix("cd ") {
            here = here.join(folder.trim());
            continue;
        }
        if NOT_RUN.iter().any(|start| command.starts_with(start)) {
            continue;
        }
        // where this program was built without it
        if command.contains("raystep book build") && !cfg!(feature = "course") {
            continue;
        }
        match of_shell(program, &here, &command) {
            Ok(()) => run += 1,
            Err(why) => faults.push(format!("{file}: {command}\n  {why}")),
        }
    }
    (run, faults)
}

/// The commands in the blocks of `sh` of a text, each with the number of its block, without their comments.
fn commands(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut is_shell = None;
    let mut block = 0;
    for line in text.lines() {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            block += 1;
            is_shell = match is_shell {
                None => Some(matches!(language.trim(), "sh" | "bash")),
                Some(_) => None,
            };
            continue;
        }
        if is_shell != Some(true) || line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let command = line.split("  #").next().unwrap_or_default();
        let command = command.split(" # ").next().unwrap_or_default().trim();
        let mut command = command.to_owned();
        for (from, to) in SAME {
            if let Some(rest) = command.strip_prefix(from) {
                command = format!("{to}{rest}");
            }
        }
        found.push((block, command));
    }
    found
}

/// A line that shows what a command takes: its words in capitals stand for something else, and `a|b` for one of both.
fn is_form(command: &str) -> bool {
    let has_choice = |word: &str| {
        let inner = word.trim_matches(|c: char| !c.is_alphanumeric());
        inner.contains('|') && !word.contains(['\'', '"'])
    };
    if command.split_whitespace().any(has_choice) {
        return true;
    }
    command.split([' ', '[', ']', '|', '.']).any(|word| {
        let letters = word.trim_matches(',');
        !letters.is_empty()
            && letters != "R"
            && letters.chars().all(|c| c.is_ascii_uppercase() || c == ',')
    })
}

fn of_shell(program: &Path, here: &Path, command: &str) -> Result<(), String> {
    let command = if is_form(command) && !command.contains(" | ") {
        // its verb must exist
        let verb = command.split_whitespace().nth(1).unwrap_or_default();
        format!("raystep {verb} --help")
    } else {
        // as many paths as the text says take a test too long
        command.replace("--paths 1000000", "--paths 1000")
    };
    let missing = [" jq ", " python"].iter().find(|tool| {
        let name = tool.trim();
        command.contains(*tool) && !on_path(name)
    });
    if let Some(tool) = missing {
        return Err(format!("there is no{tool}").trim_end().into());
    }
    let folder = program.parent().unwrap();
    let path = env::var_os("PATH").unwrap_or_default();
    let path: Vec<PathBuf> = std::iter::once(folder.to_path_buf())
        .chain(env::split_paths(&path))
        .collect();
    let out = Command::new("sh")
        .args(["-c", &command])
        .current_dir(here)
        .env("PATH", env::join_paths(path).unwrap())
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let code = out.status.code();
    let may_differ = MAY_DIFFER.iter().any(|start| command.starts_with(start));
    if code == Some(0) || (may_differ && code == Some(1)) {
        return Ok(());
    }
    Err(format!(
        "{code:?}: {}",
        String::from_utf8_lossy(&out.stderr)
    ))
}

fn on_path(name: &str) -> bool {
    let path = env::var_os("PATH").unwrap_or_default();
    env::split_paths(&path).any(|folder| folder.join(name).is_file())
}
