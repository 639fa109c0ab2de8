//! A question that cannot be asked is refused with its file and line.

use raystep::open_lessons;
use serde_json::{Value, json};

use crate::cli::run::Folder;

/// A ball of radius 2 around the origin, seen from z = 10: a = 1, b = −20, c = 96, t = 8 and 12.
const SCENE: &str = r#"{
  "camera": { "window": { "cop": [0, 0, 10], "corner": [-1, -1, 9], "right": [2, 0, 0], "up": [0, 2, 0] }, "pixels": [1, 1] },
  "materials": { "red": { "colour": [1, 0, 0], "diffuse": 0.5 } },
  "lights": [ { "name": "lamp", "position": [0, 0, 20], "colour": [1, 1, 1] } ],
  "objects": [ { "name": "ball", "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 2 } } } ]
}"#;

fn question(ask: &Value) -> Value {
    json!({
        "name": "roots", "scene": "ball.json", "pixel": [0, 0],
        "at": { "kind": "sphere_test", "ray": 0 },
        "text": "b is {b}.",
        "ask": ask,
    })
}

fn number(wrong: &Value) -> Value {
    question(&json!({ "number": { "answer": "t", "reason": "It is {t}.", "wrong": wrong } }))
}

fn choices(choices: &Value) -> Value {
    question(&json!({ "choice": { "choices": choices } }))
}

/// What a question is refused with: the message, from its first line.
#[track_caller]
fn refusal(question: &Value) -> String {
    let lesson = json!({ "title": "roots", "figures": {}, "questions": [question] });
    let text = serde_json::to_string_pretty(&lesson).unwrap();
    let folder = Folder::empty();
    std::fs::create_dir_all(folder.path("01-ball")).unwrap();
    let folder = folder
        .with("01-ball/lesson.json", text)
        .with("01-ball/ball.json", SCENE);
    match open_lessons(&folder.path("")) {
        Err(error) => error.to_string(),
        Ok(library) => match library.ask("01-ball", "roots") {
            Err(error) => error.to_string(),
            Ok(asked) => panic!("it is asked: {}", asked.text),
        },
    }
}

/// The line of a text in the lesson, counted from 1.
fn line_of(question: &Value, text: &str) -> usize {
    let lesson = json!({ "title": "roots", "figures": {}, "questions": [question] });
    let lines = serde_json::to_string_pretty(&lesson).unwrap();
    lines.lines().position(|line| line.contains(text)).unwrap() + 1
}

#[track_caller]
fn check(question: &Value, at: &str, message: &str) {
    let refused = refusal(question);
    assert!(refused.contains(message), "{refused}");
    // of a list or an object it is the line of its first part
    let line = line_of(question, at);
    let is_there = |line: usize| refused.contains(&format!("01-ball/lesson.json, line {line},"));
    assert!((line - 1..=line + 1).any(is_there), "{line}: {refused}");
    // and what to do
    assert!(refused.lines().count() == 2, "{refused}");
}

#[test]
fn a_selector_that_finds_no_step_or_several_is_refused() {
    let mut none = number(&json!([]));
    none["at"]["ray"] = json!(7);
    check(&none, "\"at\"", "no sphere_test is there");
    let mut several = number(&json!([]));
    several["at"] = json!({ "kind": "sphere_test" });
    check(
        &several,
        "\"at\"",
        "2 of kind sphere_test are there, and one is asked for",
    );
    let mut other = number(&json!([]));
    other["with"] = json!({ "other": { "kind": "ray", "nth": 5 } });
    check(&other, "\"other\"", "there is no ray number 5: 2 are there");
    let mut kind = number(&json!([]));
    kind["at"]["kind"] = json!("sphere_tests");
    check(&kind, "\"at\"", "did you mean sphere_test?");
}

#[test]
fn a_distractor_that_equals_the_answer_or_another_is_refused() {
    let like = json!([{ "value": "near", "reason": "This is the smaller root." }]);
    check(
        &number(&like),
        "\"value\"",
        "the wrong number 8 is the answer",
    );
    let twice = json!([
        { "value": "far", "reason": "This is the larger root." },
        { "mistake": "largest root" },
    ]);
    check(
        &number(&twice),
        "\"mistake\"",
        "the wrong number 12 is wrong number 0",
    );
    // from outside the first root is the right one
    let mistake = json!([{ "mistake": "first root always" }]);
    check(
        &number(&mistake),
        "\"mistake\"",
        "the wrong number 8 is the answer",
    );
    let alike = json!([
        { "text": "t = {near}", "when": "t = near", "reason": "It is the smaller root." },
        { "text": "t = 8", "when": "t = far", "reason": "It is the larger root." },
    ]);
    check(
        &choices(&alike),
        "t = 8",
        "choice 1 is like choice 0: \"t = 8\"",
    );
}

#[test]
fn a_choice_without_a_reason_is_refused() {
    let empty = json!([
        { "text": "t = {near}", "when": "t = near", "reason": "It is the smaller root." },
        { "text": "t = {far}", "when": "t = far", "reason": " " },
    ]);
    check(
        &choices(&empty),
        "\"reason\": \" \"",
        "the choice has no reason",
    );
    let wrong = json!([{ "value": "far" }]);
    check(&number(&wrong), "\"value\"", "the choice has no reason");
    let mut missing = choices(&json!([{ "text": "t = {near}", "when": "t = near" }]));
    let refused = refusal(&missing);
    assert!(refused.contains("missing key `reason`"), "{refused}");
    missing["ask"]["choice"]["choices"][0]["reason"] = json!("It is right.");
    assert!(refusal(&missing).contains("there are 1 choices"));
}

#[test]
fn a_question_of_which_no_choice_or_two_are_right_is_refused() {
    let two = json!([
        { "text": "near", "when": "t = near", "reason": "It is." },
        { "text": "ahead", "when": "0 < t", "reason": "It is." },
    ]);
    check(&choices(&two), "\"choice\"", "2 choices are right");
    let none = json!([
        { "text": "far", "when": "t = far", "reason": "It is not." },
        { "text": "behind", "when": "t < 0", "reason": "It is not." },
    ]);
    check(&choices(&none), "\"choice\"", "no choice is right");
}

#[test]
fn what_is_not_there_is_said_with_what_is_like_it() {
    let mut text = number(&json!([]));
    text["text"] = json!("It is {discriminants}.");
    check(&text, "\"text\"", "did you mean discriminant?");
    let mut route = number(&json!([]));
    route["ask"]["number"]["confirm"] = json!("far");
    check(&route, "\"confirm\"", "\"far\" is 12, and the answer is 8");
    let mistake = json!([{ "mistake": "largest roots" }]);
    check(
        &number(&mistake),
        "\"mistake\"",
        "there is no mistake \"largest roots\"",
    );
    let mistake = json!([{ "mistake": "plus 2" }]);
    check(&number(&mistake), "\"mistake\"", "has no part in this step");
    let mut pixel = number(&json!([]));
    pixel["pixel"] = json!([3, 0]);
    check(&pixel, "\"pixel\"", "pixel 3,0 is not in the picture");
    let mut change = number(&json!([]));
    change["change"] = json!({ "/objects/5/name": "B" });
    check(
        &change,
        "\"change\"",
        "the scene has no \"/objects/5/name\"",
    );
    let mut name = number(&json!([]));
    name["name"] = json!("Two words");
    check(&name, "\"name\"", "is not a name for a question");
    let blank =
        question(&json!({ "blank": { "take": ["t"], "lines": ["b = {b}"], "reason": "It is." } }));
    check(&blank, "\"take\"", "which is in none of the lines");
    let mut figure = number(&json!([]));
    figure["figure"] = json!("01-ball/roots");
    check(
        &figure,
        "\"figure\"",
        "there is no figure \"01-ball/roots\"",
    );
    let reason = question(&json!({ "reason": {} }));
    check(&reason, "\"at\"", "nothing was rejected in it");
}
