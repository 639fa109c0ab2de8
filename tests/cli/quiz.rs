//! `raystep lesson quiz`: answers in, verdicts and reasons out.

use std::io::Write;
use std::process::Stdio;

use super::run::{Folder, Ran};

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

/// Asks with these lines on standard input.
#[track_caller]
fn typed(folder: &Folder, words: &str, lines: &str) -> String {
    let mut command = folder.command(words);
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(lines.as_bytes())
        .unwrap();
    text(Ran::from(child.wait_with_output().unwrap()).well())
}

#[test]
fn a_wrong_answer_is_told_with_every_choice_its_reason_and_the_command_to_the_step() {
    // t = (8.2 ± 1.8)/2 is 3.2 and 5: by hand, from a = 1, b = −8.2, c = 16
    let said = typed(
        &Folder::empty(),
        "lesson quiz 04 --only smaller-root",
        "5\n",
    );
    assert!(said.starts_with("Lesson 4: Computing intersections: the sphere. 1 question. "));
    assert!(said.contains("wrong: Mistake \"largest root\""), "{said}");
    assert!(said.contains("\nright is: 3.2\n"), "{said}");
    assert!(
        said.contains("  −5 is wrong: Mistake \"c − o without the turned sign\""),
        "{said}"
    );
    assert!(
        said.contains("discriminant: b² − 4ac = 67.24 − 64 = 3.24 > 0"),
        "{said}"
    );
    let command = "To step to it: raystep step course/04-sphere/roots.json 38,15 --strategy exhaustive --at 2\n";
    assert!(said.contains(command), "{said}");
    assert!(said.ends_with("\n0 right, 1 wrong, 0 skipped\n"), "{said}");
}

#[test]
fn what_is_no_answer_is_told_what_is_accepted_and_asked_again() {
    let said = typed(
        &Folder::empty(),
        "lesson quiz 04 --only smaller-root --only graze",
        "three\n?\n3,2\nd\ns\n",
    );
    let accepted = "\"three\" is no answer: give a number, such as 2.5 or 1e-3\n";
    assert!(said.contains(accepted), "{said}");
    assert!(
        said.contains("\nright: t = (8.2 − √3.24)/2 = 3.2"),
        "{said}"
    );
    assert!(
        said.contains("\"d\" is no answer: give one letter, a to c\n"),
        "{said}"
    );
    assert!(said.contains("skipped; right is: "), "{said}");
    assert!(said.ends_with("\n1 right, 0 wrong, 1 skipped\n"), "{said}");
}

#[test]
fn a_script_answers_and_what_it_leaves_is_not_asked() {
    let said = text(
        Folder::empty()
            .run("lesson quiz 12 --script skip;s;q")
            .well(),
    );
    assert!(said.contains("\n3 of 13: cells-in-order\n"), "{said}");
    assert!(!said.contains("4 of 13"), "{said}");
    assert!(
        said.ends_with("\n0 right, 0 wrong, 2 skipped, 11 not asked\n"),
        "{said}"
    );
}

#[test]
fn lessons_of_a_folder_are_asked_and_the_command_leads_to_its_scenes() {
    let folder = Folder::empty();
    folder.run("lesson start mine").well();
    let words = "lesson quiz 04 --only graze --lessons mine --script skip";
    let said = text(folder.run(words).well());
    let command = said
        .lines()
        .find_map(|line| line.strip_prefix("To step to it: raystep "));
    let stepped = folder
        .run(&format!("{} --script out", command.unwrap()))
        .well();
    assert!(text(stepped).contains("b² − 4ac"), "{command:?}");
    let command = said
        .lines()
        .find_map(|line| line.strip_prefix("Its figure: raystep "));
    folder.run(command.unwrap()).well();
    assert!(text(folder.read("graze.svg")).contains("<svg"));
}

#[test]
fn what_is_not_there_is_refused() {
    let folder = Folder::empty();
    let message = folder.run("lesson quiz 13").refused();
    assert!(
        message.contains("there is no lesson 13\n  the lessons are 01-pinhole,"),
        "{message}"
    );
    let message = folder.run("lesson quiz 04 --only grace").refused();
    assert!(
        message.contains("lesson 4 has no question \"grace\"\n  did you mean graze?"),
        "{message}"
    );
    let message = folder.run("lesson quiz 04 --lessons nowhere").refused();
    assert!(message.contains("nowhere"), "{message}");
}
