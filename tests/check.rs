//! Logs of ray tracers in other languages, against what this one computes.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::process::Command;

use flate2::read::GzDecoder;
use rand::rngs::SmallRng;
use rand::{RngExt, SeedableRng};
use raystep::lesson::check::{CheckError, CheckOptions, Checked, Named, check_log};
use raystep::{Chosen, NoFiles, Scene, Settings, StrategyName, load_bytes};
use serde_json::{Value, json};

use crate::cli::run::Folder;

const SCENE: &str = include_str!("../lessons/any-language/scene.json");

/// What the sample tracers can be planted with: the file of the log, and the mistake that is found.
const PLANTED: [(&str, &str); 37] = [
    ("python-no-half", "no ½"),
    ("python-row-from-below", "row from below"),
    (
        "python-c-minus-o-without-the-turned-sign",
        "c − o without the turned sign",
    ),
    (
        "python-half-b-in-the-full-formula",
        "half b in the full formula",
    ),
    ("python-first-root-always", "first root always"),
    ("python-largest-root", "largest root"),
    ("python-negative-t-kept", "negative t kept"),
    (
        "python-axis-of-the-smallest-coefficient",
        "axis of the smallest coefficient",
    ),
    ("python-last-hit-wins", "last hit wins"),
    ("python-p-instead-of-p-minus-c", "p instead of p − c"),
    ("python-plus-2", "plus 2"),
    ("python-no-weight", "no weight"),
    ("python-l-from-light-to-point", "L from light to point"),
    ("python-any-hit-counts", "any hit counts"),
    ("python-no-epsilon", "no ε"),
    ("cpp-sign-of-d", "sign of D"),
    ("cpp-r-made-of-v", "R made of V"),
    ("cpp-first-light-only", "first light only"),
    ("cpp-first-root-always", "first root always"),
    ("python-tan-of-the-whole-angle", "tan of the whole angle"),
    ("python-degrees-for-radians", "degrees for radians"),
    ("python-u-and-v-swapped", "u and v swapped"),
    ("python-w-turned", "w turned"),
    ("python-n-minus-1", "n − 1"),
    ("python-aspect-twice", "aspect twice"),
    ("python-not-divided-by-r", "not divided by r"),
    ("python-ambient-in-the-loop", "ambient in the loop"),
    ("python-no-shadow-ray", "no shadow ray"),
    ("python-n-not-unit", "N not unit"),
    ("python-d-turned", "D turned"),
    ("python-limit-one-too-high", "limit one too high"),
    ("python-limit-one-too-low", "limit one too low"),
    ("python-background-at-the-limit", "background at the limit"),
    ("python-stops-at-the-first-leaf", "stops at the first leaf"),
    ("cpp-offset-to-the-wrong-side", "offset to the wrong side"),
    ("colours-plus-2", "plus 2"),
    ("colours-no-weight", "no weight"),
];

/// The scene of a log: the sample's, with fewer rays or another order of the objects where that shows a mistake.
fn scene(name: &str) -> Scene {
    let mut scene: Value = serde_json::from_str(SCENE).unwrap();
    if name.contains("limit") {
        scene["max_depth"] = json!(2);
    }
    if name.contains("first-leaf") {
        scene["objects"].as_array_mut().unwrap().reverse();
    }
    load_bytes("scene.json", scene.to_string().as_bytes(), &NoFiles)
        .unwrap()
        .build()
        .unwrap()
}

fn data(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/any-language");
    let file = File::open(folder.join(format!("{name}.jsonl.gz"))).unwrap();
    let mut log = Vec::new();
    GzDecoder::new(file).read_to_end(&mut log).unwrap();
    log
}

fn check_with(log: &[u8], tolerance: f64) -> Result<Checked, CheckError> {
    check_in(&scene(""), log, tolerance)
}

fn check_in(scene: &Scene, log: &[u8], tolerance: f64) -> Result<Checked, CheckError> {
    let settings = Settings {
        strategy: StrategyName::Exhaustive,
        ..Settings::default()
    };
    let chosen = Chosen::new(scene, settings.strategy, &settings.structure).unwrap();
    let options = CheckOptions {
        tolerance,
        ..CheckOptions::default()
    };
    check_log(scene, &[(&settings, &chosen)], "log", log, &options)
}

fn check(log: &[u8]) -> Result<Checked, CheckError> {
    check_with(log, CheckOptions::default().tolerance)
}

#[track_caller]
fn is_right(log: &[u8], tolerance: f64) -> Checked {
    let checked = check_with(log, tolerance).unwrap();
    assert!(checked.is_right(), "{}", checked.text(&Named::default()));
    checked
}

fn each_line(log: &[u8], mut change: impl FnMut(&mut Value)) -> Vec<u8> {
    let text = std::str::from_utf8(log).unwrap();
    let mut out = String::new();
    for line in text.lines() {
        let mut value: Value = serde_json::from_str(line).unwrap();
        change(&mut value);
        writeln!(out, "{value}").unwrap();
    }
    out.into_bytes()
}

fn each_number(value: &mut Value, change: &impl Fn(f64) -> f64) {
    match value {
        Value::Number(number) if number.is_f64() => {
            *value = json!(change(number.as_f64().unwrap()));
        }
        Value::Array(items) => items.iter_mut().for_each(|item| each_number(item, change)),
        Value::Object(fields) => fields.values_mut().for_each(|of| each_number(of, change)),
        _ => {}
    }
}

/// The Python sample has unit directions, b and b² − 4ac, ε in t; the C++ one t = 1 at the window, half b, planes that
/// are not normalised, the objects from the last to the first, and its points moved by 10⁻⁶ along the normal.
#[test]
fn right_tracers_of_two_forms_are_accused_of_nothing() {
    let python = is_right(&data("python-right"), 1e-5);
    assert_eq!(python.pixels, 8);
    let compared: u64 = python.compared.values().sum();
    // 8 pixels, each with its point, its colour and at least a ray and 5 tests
    assert!(8 * 8 <= compared, "{compared}");
    is_right(&data("cpp-right"), 1e-5);
    // the colours alone of one that starts its rays 10⁻⁴ beside their surfaces
    is_right(&data("colours-right"), 1e-5);
}

/// a·t² + b·t + c = 0 has the same roots if it is divided by a: t² + (b/a)·t + c/a = 0. It was called a difference in a.
#[test]
fn a_quadratic_divided_by_a_is_no_mistake_but_an_a_that_was_forgotten_is_one() {
    let divided = |log: &[u8], by: fn(f64) -> f64| {
        each_line(log, |line| {
            if line["kind"] == "sphere_test" {
                let k = by(line["a"].as_f64().unwrap());
                for (key, power) in [("a", 1), ("b", 1), ("c", 1), ("discriminant", 2)] {
                    line[key] = json!(line[key].as_f64().unwrap() / k.powi(power));
                }
            }
        })
    };
    // half b and another length of Δ; and directions of unit length
    is_right(&divided(&data("cpp-right"), |a| a), 1e-5);
    is_right(&divided(&data("python-right"), |_| -7.0), 1e-5);
    // without a the line is still the same equation, without c too
    for absent in ["a", "c", "discriminant"] {
        let log = each_line(&divided(&data("cpp-right"), |a| a), |line| {
            if line["kind"] == "sphere_test" {
                line.as_object_mut().unwrap().remove(absent);
            }
        });
        is_right(&log, 1e-5);
    }
    let forgotten = each_line(&data("cpp-right"), |line| {
        if line["kind"] == "sphere_test" {
            line["a"] = json!(1);
        }
    });
    let divergence = check(&forgotten).unwrap().divergence.unwrap();
    assert_eq!(divergence.quantities.last().unwrap().key, "a");
}

/// A misspelt field was passed over in silence.
#[test]
fn a_field_that_is_not_known_is_named_once_and_fails_nothing() {
    let log = each_line(&data("python-right"), |line| {
        if line["kind"] == "sphere_test" {
            let fields = line.as_object_mut().unwrap();
            let value = fields.remove("discriminant").unwrap();
            fields.insert("disc".into(), value);
            fields.insert("my own".into(), json!("\u{1b}[31m"));
        }
    });
    let checked = is_right(&log, 1e-5);
    let text = checked.text(&Named::default());
    let notes: Vec<&str> = text.lines().filter(|line| line.contains("note:")).collect();
    let count = checked.compared[&raystep::trace::Kind::SphereTest];
    assert_eq!(
        notes,
        [
            format!(
                "  note: the field \"disc\" of sphere_test is not known and not compared ({count} lines, the first one is line 3); did you mean \"discriminant\"?"
            ),
            format!(
                "  note: the field \"my own\" of sphere_test is not known and not compared ({count} lines, the first one is line 3)"
            ),
        ]
    );
    let json = checked.json(&Named::default());
    assert_eq!(json["unknown"][0]["field"], "disc");
    assert_eq!(json["unknown"][0]["near"], "discriminant");
    // a log that makes up keys without end
    let mut number = 0;
    let log = each_line(&data("python-right"), |line| {
        number += 1;
        line[format!("key {number}")] = json!(1);
    });
    assert_eq!(is_right(&log, 1e-5).unknown.len(), 20);
}

/// Of two nested reflected rays without numbers the end of the outer one stands behind that of the inner one, and was taken
/// for a second end of the inner one.
#[test]
fn the_end_of_a_ray_behind_that_of_a_deeper_one_belongs_to_the_ray_around_it() {
    let folder = Folder::empty().with("scene.json", SCENE);
    folder.run("trace scene.json -o own.jsonl").well();
    let own = folder.read("own.jsonl");
    is_right(&own, 1e-5);
    let mut purposes: BTreeMap<(String, u64), Value> = BTreeMap::new();
    let mut most_nested = 0;
    let by_purpose = each_line(&own, |line| {
        let Some(ray) = line["ray"].as_u64() else {
            return;
        };
        let ray = (line["pixel"].to_string(), ray);
        if line["kind"] == "ray" && line["purpose"] == "reflected" {
            most_nested = most_nested.max(line["depth"].as_u64().unwrap());
        }
        if line["kind"] == "ray" {
            purposes.insert(ray.clone(), line["purpose"].clone());
        }
        line["purpose"] = purposes[&ray].clone();
        let fields = line.as_object_mut().unwrap();
        fields.remove("ray");
        fields.remove("parent");
    });
    // four surfaces, and the ray at the limit, which is not traced
    assert_eq!(most_nested, 5);
    is_right(&by_purpose, 1e-5);
}

#[test]
fn each_planted_mistake_is_found_by_its_name() {
    for (name, expected) in PLANTED {
        let checked = check_in(&scene(name), &data(name), 1e-5).unwrap();
        assert!(checked.unknown.is_empty(), "{name}: {:?}", checked.unknown);
        let divergence = checked
            .divergence
            .as_ref()
            .unwrap_or_else(|| panic!("{name}: right"));
        let found = divergence.mistake.map(|mistake| mistake.name);
        assert_eq!(
            found,
            Some(expected),
            "{name}: {}",
            checked.text(&Named::default())
        );
        let (last, before) = divergence.quantities.split_last().unwrap();
        assert!(
            !last.is_same && before.iter().all(|of| of.is_same),
            "{name}"
        );
    }
}

#[test]
fn numbers_of_32_bits_pass_with_a_tolerance_and_are_not_taken_for_a_mistake() {
    for name in ["python-right", "cpp-right"] {
        let rounded = each_line(&data(name), |line| {
            each_number(line, &|x| f64::from(x as f32));
        });
        is_right(&rounded, 1e-3);
    }
}

#[test]
fn six_printed_digits_pass_as_they_are() {
    let printed = each_line(&data("python-right"), |line| {
        each_number(line, &|x| format!("{x:.5e}").parse().unwrap());
    });
    is_right(&printed, 1e-5);
}

#[test]
fn the_order_within_a_pixel_is_free_and_a_log_may_have_any_part_of_it() {
    let log = data("python-right");
    let text = String::from_utf8(log).unwrap();
    let pixel_of = |line: &str| serde_json::from_str::<Value>(line).unwrap()["pixel"].clone();
    let lines: Vec<&str> = text.lines().collect();
    let mut backwards = String::new();
    for pixel in lines.chunk_by(|a, b| pixel_of(a) == pixel_of(b)) {
        for line in pixel.iter().rev() {
            writeln!(backwards, "{line}").unwrap();
        }
    }
    is_right(backwards.as_bytes(), 1e-5);
    // the rays told apart by their purposes alone, no parents, one quantity a line
    let sparse = each_line(text.as_bytes(), |line| {
        let keep = [
            "kind",
            "pixel",
            "purpose",
            "object",
            "light",
            "discriminant",
            "raw",
            "n_dot_l",
        ];
        line.as_object_mut()
            .unwrap()
            .retain(|key, _| keep.contains(&key.as_str()));
    });
    let checked = is_right(&sparse, 1e-5);
    assert!(100 < checked.compared.values().sum::<u64>());
    let colours = each_line(text.as_bytes(), |line| {
        if line["kind"] != "pixel_colour" {
            *line = json!({"kind": "trace"});
        }
    });
    let checked = is_right(&colours, 1e-5);
    let compared: Vec<(&str, u64)> = checked
        .compared
        .iter()
        .map(|(kind, n)| (kind.name(), *n))
        .collect();
    assert_eq!(compared, [("pixel_colour", 8)]);
    assert!(
        checked
            .absent
            .iter()
            .any(|kind| kind.name() == "sphere_test")
    );
}

/// A white mirror that adds 0.6 of what it sees: one number in one line.
#[test]
fn a_single_wrong_number_is_named_with_its_line() {
    let mut number = 0;
    let mut changed = None;
    let log = each_line(&data("python-right"), |line| {
        number += 1;
        if changed.is_none() && line["kind"] == "plane_test" && line["object"] == "floor" {
            line["denominator"] = json!(line["denominator"].as_f64().unwrap() + 0.001);
            changed = Some(number);
        }
    });
    let checked = check(&log).unwrap();
    let divergence = checked.divergence.unwrap();
    assert_eq!(Some(divergence.line), changed);
    assert_eq!(divergence.quantities.last().unwrap().key, "denominator");
    assert!(divergence.mistake.is_none(), "nobody writes that");
}

#[track_caller]
fn refused(log: &str, what: &str) {
    let error = check(log.as_bytes()).map(|_| ()).unwrap_err().to_string();
    assert!(error.contains(what), "{error}");
    assert_eq!(error.lines().count(), 2, "what, and what to do: {error}");
}

#[test]
fn a_line_that_makes_no_sense_is_told_with_its_number_and_what_to_do() {
    let good = r#"{"kind":"pixel_colour","pixel":[0,0],"raw":[0.6,0.8,1.0]}"#;
    let after = |line: &str| format!("{good}\n{line}\n");
    refused(
        &after(r#"{"kind":"ray","pixel":[0,0],"origin":NaN}"#),
        "log, line 2: NaN and infinity",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":[0,0],"t_max":-Infinity}"#),
        "line 2: NaN and infinity",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":[0,0]"#),
        "line 2: the line ends before its object does",
    );
    refused(&after("hello"), "line 2: the line is no JSON");
    refused(&after("[1, 2]"), "line 2: the line is no object of fields");
    refused(
        &after(r#"{"kind":"ray","kind":"ray"}"#),
        "the key \"kind\" comes twice",
    );
    refused(
        &after(r#"{"pixel":[0,0]}"#),
        "line 2: the line has no \"kind\"",
    );
    refused(
        &after(r#"{"kind":"sphere_tests","pixel":[0,0]}"#),
        "there is no kind \"sphere_tests\"\n  did you mean \"sphere_test\"?",
    );
    refused(
        &after(r#"{"kind":"sphere_test","pixel":[0,0],"object":"AA"}"#),
        "the scene has no object \"AA\"",
    );
    refused(
        &after(r#"{"kind":"sphere_test","pixel":[0,0],"object":0}"#),
        "it is the name of an object",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":[24,0]}"#),
        "pixel 24,0 is not in the picture of 24 × 18 pixels",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":[0.5,0]}"#),
        "it is [column, row]",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":"0,0"}"#),
        "it is [column, row]",
    );
    refused(
        r#"{"kind":"ray","purpose":"eye"}"#,
        "line 1: the line has no \"pixel\"",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":[0,0],"purpose":"camera"}"#),
        "there is no purpose \"camera\"",
    );
    refused(
        &after(r#"{"kind":"ray","pixel":[0,0],"ray":-1}"#),
        "it is the number of a ray",
    );
    refused(
        &after(r#"{"kind":"sphere_test","pixel":[0,0],"object":"A","a":"1.0"}"#),
        "line 2: \"a\" has a word; it is a number\n  write it without quotation marks",
    );
    refused(
        &after(r#"{"kind":"plane_test","pixel":[0,0],"object":"floor","verdict":"hitt"}"#),
        "line 2: \"verdict\" has the word \"hitt\"\n  it is \"hit\" or \"rejected\"; did you mean \"hit\"?",
    );
    refused(
        &after(r#"{"kind":"light_term","pixel":[0,0],"light":"lamp","visibility":"no"}"#),
        "\"visibility\" has the word \"no\"\n  it is \"visible\", \"shadowed\", \"faces_away\" or \"not_tested\"",
    );
    refused(
        &after(r#"{"kind":"polygon_test","pixel":[0,0],"object":"floor","dropped":"Y"}"#),
        "it is \"x\", \"y\" or \"z\"",
    );
    let again = format!("{good}\n{}\n{good}\n", good.replace("[0,0]", "[1,0]"));
    refused(&again, "line 3: pixel 0,0 comes again");
    let error = check(b"{\"kind\":\"ray\",\"pixel\":[0,0]}\n\0\n")
        .map(|_| ())
        .unwrap_err();
    assert!(
        error.to_string().contains("line 2: the line has a byte 0"),
        "{error}"
    );
}

#[test]
fn windows_line_ends_a_byte_order_mark_and_blank_lines_are_no_mistakes() {
    let log = String::from_utf8(data("python-right")).unwrap();
    let windows = format!(
        "\u{feff}{}\r\n \r\n",
        log.trim_end().replace('\n', "\r\n\r\n")
    );
    is_right(windows.as_bytes(), 1e-5);
    // and without an end of the last line
    is_right(log.trim_end().as_bytes(), 1e-5);
}

#[test]
fn degrees_for_radians_differ_at_the_first_pixel() {
    // tan(20) instead of tan(20°): a window of another size
    let wrong = 2.237_160_944_224_742_f64 / 0.363_970_234_266_202_4;
    let log = each_line(&data("python-right"), |line| {
        if line["kind"] == "pixel" {
            for value in line["point"].as_array_mut().unwrap() {
                *value = json!(value.as_f64().unwrap() * wrong);
            }
        }
    });
    let divergence = check(&log).unwrap().divergence.unwrap();
    assert_eq!((divergence.line, divergence.kind.name()), (1, "pixel"));
}

#[test]
fn a_thousand_damaged_logs_get_one_clear_message_each_or_an_answer() {
    let log = data("python-right");
    let end = log[..log.len() / 4]
        .iter()
        .rposition(|byte| *byte == b'\n')
        .unwrap();
    let first_pixels = &log[..=end];
    let mut random = SmallRng::seed_from_u64(22);
    let mut answers = [0, 0];
    for _ in 0..1000 {
        let mut damaged = first_pixels.to_vec();
        for _ in 0..random.random_range(1..4) {
            let at = random.random_range(0..damaged.len());
            match random.random_range(0..4) {
                0 => damaged[at] = random.random(),
                1 => drop(damaged.remove(at)),
                2 => damaged.insert(at, random.random_range(b' '..b'~')),
                _ => damaged.truncate(at.max(1)),
            }
        }
        match check(&damaged) {
            Ok(_) => answers[0] += 1,
            Err(error) => {
                answers[1] += 1;
                let text = error.to_string();
                assert!(
                    text.contains("line ") && text.lines().count() == 2,
                    "{text}"
                );
                assert!(
                    !text.chars().any(|c| c.is_control() && c != '\n'),
                    "{text:?}"
                );
            }
        }
    }
    assert!(answers.iter().all(|count| 50 < *count), "{answers:?}");
}

#[test]
fn the_command_answers_with_its_code_and_a_picture_of_both() {
    let folder = Folder::empty()
        .with("scene.json", SCENE)
        .with("right.jsonl", data("python-right"))
        .with("wrong.jsonl", data("python-largest-root"));
    let said = String::from_utf8(folder.run("check scene.json right.jsonl").well()).unwrap();
    assert!(said.ends_with("● nothing differs\n"), "{said}");
    assert!(!folder.names().contains(&"raystep-check.svg".into()));
    let ran = folder.run("check scene.json wrong.jsonl");
    assert_eq!((ran.code, &*ran.stderr), (Some(1), ""));
    let said = String::from_utf8(ran.stdout).unwrap();
    assert!(said.contains("mistake:  largest root"), "{said}");
    let see = said
        .lines()
        .find_map(|line| line.trim().strip_prefix("see it:"))
        .unwrap();
    let see = see.trim().strip_prefix("raystep ").unwrap();
    let step = String::from_utf8(folder.run(&format!("{see} --script q")).well()).unwrap();
    assert!(
        step.contains("sphere_test") || step.contains("sphere A") || step.contains('A'),
        "{step}"
    );
    let svg = String::from_utf8(folder.read("raystep-check.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let titles: Vec<&str> = document
        .root_element()
        .children()
        .filter(|node| node.has_tag_name("text"))
        .filter_map(|node| node.text())
        .collect();
    assert_eq!(titles, ["expected", "yours"]);

    let ran = folder.run("check scene.json wrong.jsonl --format json --no-picture");
    assert_eq!(ran.code, Some(1));
    let answer: Value = serde_json::from_slice(&ran.stdout).unwrap();
    assert_eq!(answer["divergence"]["mistake"], "largest root");
    assert_eq!(answer["right"], false);
    let ran = folder.run("check scene.json wrong.jsonl --format junit --no-picture");
    let xml = String::from_utf8(ran.stdout).unwrap();
    let suite = roxmltree::Document::parse(&xml).unwrap();
    let failed = suite
        .descendants()
        .filter(|node| node.has_tag_name("failure"));
    assert_eq!(
        failed.count(),
        answer["different"].as_object().unwrap().len()
    );
    let only = folder.run("check scene.json wrong.jsonl --only plane_test --no-picture");
    assert_eq!(only.code, Some(0), "{}", only.stderr);
    let missing = folder.run("check scene.json nowhere.jsonl").refused();
    assert!(
        missing.contains("nowhere.jsonl: cannot be read"),
        "{missing}"
    );
}

/// The samples themselves, where their languages are installed.
#[test]
fn the_samples_are_under_200_lines_and_write_what_the_data_has() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/any-language");
    for name in ["tracer.py", "tracer.cpp"] {
        let text = std::fs::read_to_string(folder.join(name)).unwrap();
        assert!(
            text.lines().count() < 200,
            "{name}: {}",
            text.lines().count()
        );
    }
    let python = Command::new("python3")
        .arg(folder.join("tracer.py"))
        .arg(folder.join("scene.json"))
        .args(["7,6", "15,7"])
        .output();
    match python {
        Ok(output) if output.status.success() => drop(is_right(&output.stdout, 1e-5)),
        _ => eprintln!("skipped: python3 is not installed"),
    }
}
