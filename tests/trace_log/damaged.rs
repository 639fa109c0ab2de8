//! Damaged logs: the message names the file, the line and what is wrong in it.

use raystep::explain::pixel_json;
use raystep::trace::Region;
use raystep::{LogReader, Record, Settings, WorkedOptions};

use crate::worked_solution::worked_text;

use super::{all_of, built, log};
use crate::seeded::Seeded;

/// A ball below a roof, seen in one pixel: the head has 3 lines and the trace 18.
const SCENE: &str = r#"{
  "camera": { "look_at": { "cop": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 },
              "pixels": [1, 1] },
  "lights": [ { "name": "lamp", "position": [0, 5, 5], "colour": [1, 1, 1] } ],
  "materials": { "red": { "colour": [1, 0, 0], "diffuse": 0.5 } },
  "objects": [
    { "name": "ball", "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } },
    { "name": "roof", "material": "red", "shape": { "mesh": { "faces": [
      { "vertices": [[-1, 2, 1], [1, 2, 1], [1, 2, -1], [-1, 2, -1]] } ] } } }
  ]
}"#;

fn good() -> String {
    let scene = built(SCENE);
    let bytes = log(&scene, &Settings::default(), &all_of(Region::pixel([0, 0])));
    String::from_utf8(bytes).unwrap()
}

/// All records, or the message.
fn read(bytes: &[u8]) -> Result<Vec<Record>, String> {
    LogReader::open("a.jsonl", bytes)
        .and_then(Iterator::collect)
        .map_err(|error| error.to_string())
}

#[track_caller]
fn refused(bytes: &[u8], message: &str) {
    let error = read(bytes).unwrap_err();
    assert!(error == message, "found    {error}\nexpected {message}");
}

const REMEDY: &str = "\n  the log is damaged: make it again";

/// The good log with a change in one line, counted from 1.
#[track_caller]
fn changed(line: usize, from: &str, to: &str) -> String {
    let good = good();
    let mut lines: Vec<String> = good.split_inclusive('\n').map(Into::into).collect();
    let changed = lines[line - 1].replacen(from, to, 1);
    assert_ne!(changed, lines[line - 1], "{from} is not in line {line}");
    lines[line - 1] = changed;
    lines.concat()
}

#[track_caller]
fn check(line: usize, from: &str, to: &str, place: &str, what: &str) {
    let message = format!("a.jsonl, line {line}{place}: {what}{REMEDY}");
    refused(changed(line, from, to).as_bytes(), &message);
}

#[test]
fn the_log_is_good_before_it_is_damaged() {
    assert_eq!(read(good().as_bytes()).map(|records| records.len()), Ok(18));
    let kinds: Vec<_> = good()
        .lines()
        .map(|line| line.split('"').nth(3).unwrap_or_default().to_owned())
        .collect();
    assert_eq!(
        kinds.join(" "),
        "trace object object pixel ray sphere_test nearest plane_test ray sphere_test plane_test \
         edge edge edge edge polygon_test ray_end light_term shade ray_end pixel_colour"
    );
}

#[test]
fn what_is_no_log_is_told_so() {
    let no_log = "a.jsonl: this is not a log: the first line has no \"kind\":\"trace\"\n  make one";
    refused(b"", no_log);
    refused(b"\n", no_log);
    refused(b"{\"kind\":\"object\",\"name\":\"ball\"}\n", no_log);
    refused(b"{\"camera\":{}}\n", no_log);
    refused(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\xff\n", no_log);
    for found in [1, 3] {
        let version = changed(1, "\"version\":2", &format!("\"version\":{found}"));
        let message = format!(
            "a.jsonl, line 1: the log has version {found}, and this program reads version 2\n  \
             make the log again with this program"
        );
        refused(version.as_bytes(), &message);
    }
}

#[test]
fn a_log_that_was_cut_off_names_the_line() {
    let good = good();
    let start = good.find("{\"kind\":\"nearest\"").unwrap();
    let message = format!("a.jsonl, line 7: the line has no end: the log was cut off here{REMEDY}");
    refused(&good.as_bytes()[..start + 30], &message);
    // a whole line is cut off as well if it has no end
    let end = start + good[start..].find('\n').unwrap();
    refused(&good.as_bytes()[..end], &message);
    let head = good.find("{\"kind\":\"object\"").unwrap();
    let message = message.replace("line 7", "line 1");
    refused(&good.as_bytes()[..head - 1], &message);
}

#[test]
fn a_log_that_ends_after_its_head_has_no_records() {
    let good = good();
    let head = good.find("{\"kind\":\"pixel\"").unwrap();
    assert_eq!(read(&good.as_bytes()[..head]), Ok(Vec::new()));
    // without its objects, the events speak of unknown ones
    let objects = good.find("{\"kind\":\"object\"").unwrap();
    let without = format!("{}{}", &good[..objects], &good[head..]);
    let message = format!("a.jsonl, line 4: there is no object \"ball\"{REMEDY}");
    refused(without.as_bytes(), &message);
}

#[test]
fn broken_json_names_line_and_column() {
    // {"kind":"sphere_test" has 21 characters, and the comma after it is gone
    let what = "expected `,` or `}`";
    check(6, "_test\",", "_test\"", ", column 22", what);
    check(6, "\"a\":1.0", "\"a\":NaN", ", column 74", "expected value");
    check(
        6,
        "\"a\":1.0",
        "\"a\":1e400",
        ", column 78",
        "number out of range",
    );
    check(6, "}", "} }", ", column 231", "trailing characters");
    check(6, "}", "", ", column 228", "EOF while parsing an object");
    let what = "invalid type: null, expected a number, a string, true, false or a list of numbers";
    check(6, "\"a\":1.0", "\"a\":null", ", column 77", what);
    let what = "invalid type: sequence, expected a flat JSON object";
    check(6, "{", "[{", "", what);
    let what = "expected value";
    check(2, "\"radius\":1.0", "\"radius\":", ", column 100", what);
}

#[test]
fn an_unknown_word_is_named() {
    let what = "there is no kind \"sphere_tset\", did you mean \"sphere_test\"?";
    check(6, "sphere_test", "sphere_tset", "", what);
    check(6, "sphere_test", "xyz", "", "there is no kind \"xyz\"");
    check(6, "\"ball\"", "\"bell\"", "", "there is no object \"bell\"");
    check(18, "\"lamp\"", "\"lump\"", "", "there is no light \"lump\"");
    let what = "\"near_verdict\" must be one of chosen, behind, below_epsilon, beyond_nearest, \
                back_face, front_face, beyond_ends";
    check(6, "\"chosen\"", "\"taken\"", "", what);
    let what = "the key \"radius\" does not belong to \"sphere_test\"";
    check(6, "\"a\":", "\"radius\":1,\"a\":", "", what);
    let what = "unknown field `radios`, expected `center` or `radius`";
    check(2, "\"radius\"", "\"radios\"", ", column 98", what);
}

#[test]
fn a_key_that_is_missing_or_twice_is_named() {
    check(6, "\"a\":1.0,", "", "", "the key \"a\" is missing");
    check(6, "\"step\":2,", "", "", "the key \"step\" is missing");
    check(
        6,
        "\"object\":\"ball\",",
        "",
        "",
        "the key \"object\" is missing",
    );
    check(
        18,
        "\"light\":\"lamp\",",
        "",
        "",
        "the key \"light\" is missing",
    );
    check(
        6,
        "\"kind\":\"sphere_test\",",
        "",
        "",
        "the line has no \"kind\"",
    );
    let what = "the key \"a\" comes twice";
    check(6, "\"a\":1.0,", "\"a\":1.0,\"a\":1.0,", ", column 84", what);
    let what = "missing field `material`";
    check(2, "\"material\":\"red\",", "", ", column 103", what);
}

#[test]
fn a_value_of_the_wrong_type_or_size_is_named() {
    check(
        6,
        "\"a\":1.0",
        "\"a\":\"1.0\"",
        "",
        "\"a\" must be a number",
    );
    let whole = "\"step\" must be a whole number of 0 or more";
    check(6, "\"step\":2", "\"step\":-1", "", whole);
    check(6, "\"step\":2", "\"step\":2.5", "", whole);
    check(6, "\"step\":2", "\"step\":4294967296", "", whole);
    let what = "\"pixel\" must be a whole number of 0 or more";
    check(6, "\"pixel\":[0,0]", "\"pixel\":[0,-1]", "", what);
    let what = "\"pixel\" must be a list of 2 numbers";
    check(6, "\"pixel\":[0,0]", "\"pixel\":[0]", "", what);
    let what = "\"object\" must be a string";
    check(6, "\"object\":\"ball\"", "\"object\":1", "", what);
    check(
        18,
        "\"light\":\"lamp\"",
        "\"light\":0",
        "",
        "\"light\" must be a string",
    );
    check(
        16,
        "\"inside\":false",
        "\"inside\":0",
        "",
        "\"inside\" must be true or false",
    );
    check(
        5,
        "\"origin\":[0.0,",
        "\"origin\":[",
        "",
        "\"origin\" must be a list of 3 numbers",
    );
}

#[test]
fn fields_that_contradict_each_other_are_named() {
    let what = "\"roots\" does not fit \"near\" and \"far\"";
    check(6, "\"roots\":\"two\"", "\"roots\":\"none\"", "", what);
    let what = "a root has either both t and verdict or neither";
    check(6, "\"near\":4.0,", "", "", what);
    check(
        6,
        "\"t\":4.0",
        "\"t\":6.0",
        "",
        "\"t\" does not follow from the rest of the line",
    );
    let what = "\"verdict\" or \"why\" does not follow from the test";
    let missed = "\"verdict\":\"rejected\",\"why\":\"no_root\"";
    check(6, "\"verdict\":\"hit\"", missed, "", what);
    check(8, "\"why\":\"parallel\"", "\"why\":\"behind\"", "", what);
    let what = "a test has a \"why\" if it is rejected, and only then";
    let hit = "\"verdict\":\"rejected\"";
    check(6, "\"verdict\":\"hit\"", hit, "", what);
    // 255 · 0.5 · 4/√41, by the cosine at the lamp: 79.65
    let what = "\"rgb\" does not follow from the rest of the line";
    check(21, "\"rgb\":[80,", "\"rgb\":[81,", "", what);
    let what = "\"face\" does not fit the object \"ball\"";
    check(
        6,
        "\"object\":\"ball\"",
        "\"object\":\"ball\",\"face\":0",
        "",
        what,
    );
    let what = "\"face\" does not fit the object \"roof\"";
    check(8, "\"face\":0", "\"face\":1", "", what);
    check(8, "\"face\":0,", "", "", what);
    let what = "a ray meets a plane at a root unless it is parallel to it";
    check(
        8,
        "\"parallel\":\"beside\"",
        "\"parallel\":\"no\"",
        "",
        what,
    );
}

#[test]
fn a_scene_that_makes_no_sense_is_told_with_its_path() {
    let message = "a.jsonl: the scene in the log: objects[0].shape.sphere.radius: the radius is -1, and \
                   must be above 0\n  give a value of at least 1e-50";
    let changed = changed(2, "\"radius\":1.0", "\"radius\":-1.0");
    refused(changed.as_bytes(), message);
}

#[test]
fn a_ray_that_is_its_own_parent_makes_no_endless_tree() {
    // a filtered log cannot be held against its own numbers: what it says of parents is taken
    let own = changed(9, "\"parent\":0", "\"parent\":1");
    let own = own.replace(
        "\"one_sided\":false",
        "\"one_sided\":false,\"only\":[\"ray\"]",
    );
    assert_eq!(use_all(own.as_bytes()), Ok(()));
}

#[test]
fn a_line_that_was_lost_moved_or_changed_is_told_by_its_numbers() {
    let good = good();
    let lines: Vec<_> = good.lines().collect();
    let with = |lines: &[&str]| lines.join("\n") + "\n";
    let missing = "step 3 of pixel [0,0] is missing: a line is lost or in the wrong place";
    let mut lost = lines.clone();
    let at = lines
        .iter()
        .position(|line| line.contains("\"step\":3,"))
        .unwrap();
    lost.remove(at);
    let mut swapped = lines.clone();
    swapped.swap(at, at + 1);
    for text in [with(&lost), with(&swapped)] {
        let error = use_all(text.as_bytes()).unwrap_err();
        assert!(error.contains(missing), "{error}");
    }
    let mut another = lines.clone();
    let changed = lines[at].replace("\"ray\":0", "\"ray\":4");
    another[at] = &changed;
    let error = use_all(with(&another).as_bytes()).unwrap_err();
    assert!(error.contains("does not fit the rays before it"), "{error}");
}

#[test]
fn no_damage_makes_the_reader_panic_nor_what_is_made_of_its_records() {
    let good = good().into_bytes();
    let events = good
        .windows(15)
        .position(|part| part == b"{\"kind\":\"pixel\"");
    let digits: Vec<usize> = (events.unwrap()..good.len())
        .filter(|&at| good[at].is_ascii_digit())
        .collect();
    let mut seeded = Seeded::new(23);
    let (mut still_read, mut refused) = (0, 0);
    for round in 0..6000 {
        let mut bytes = good.clone();
        match round % 4 {
            0 => bytes.truncate(seeded.index(good.len())),
            1 => bytes[seeded.index(good.len())] = seeded.bits() as u8,
            // characters that mean something
            2 => {
                for _ in 0..=seeded.index(3) {
                    let character = b"0123456789-.e\",:[]{}\n "[seeded.index(22)];
                    bytes[seeded.index(good.len())] = character;
                }
            }
            // digits for digits: mostly it can still be read, and says what no tracer would
            _ => {
                for _ in 0..4 {
                    let digit = digits[seeded.index(digits.len())];
                    bytes[digit] = b"0123456789"[seeded.index(10)];
                }
            }
        }
        match use_all(&bytes) {
            Ok(()) => still_read += 1,
            Err(message) => {
                assert!(message.starts_with("a.jsonl"), "{message}");
                refused += 1;
            }
        }
    }
    assert!(500 < still_read && 3000 < refused, "{still_read} {refused}");
}

/// Reads a log and makes of it what can be made.
fn use_all(bytes: &[u8]) -> Result<(), String> {
    let told = |error: raystep::trace::LogError| error.to_string();
    let reader = LogReader::open("a.jsonl", bytes).map_err(told)?;
    let (scene, settings, records) = reader.pixel([0, 0]).map_err(told)?;
    for ray in [None, Some(0), Some(1)] {
        let options = WorkedOptions {
            ray,
            all: true,
            ..WorkedOptions::default()
        };
        worked_text(&scene, &settings, &records, &options);
    }
    pixel_json(&scene, &settings, &records);
    Ok(())
}
