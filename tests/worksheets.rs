//! Worksheets: ten thousand questions, each with its key confirmed by another way to it.

use std::collections::{BTreeMap, BTreeSet};

use raystep::lesson::question::{Asked, Form, Given};
use raystep::lesson::worksheet::{Item, Worksheet, worksheet};
use raystep::lesson::{Lesson, course};
use raystep::{Chosen, Event, Library, Off, Settings, StrategyName, Tracer};
use serde_json::Value;

use crate::cli::run::Folder;

/// So many seeds of each lesson make ten thousand questions: 12 lessons, at most 8 questions.
const SEEDS: u64 = 110;

fn sheet(library: &Library, lesson: &Lesson, seed: u64) -> Worksheet {
    worksheet(library, lesson, seed)
        .unwrap_or_else(|error| panic!("{}: {seed}: {error}", lesson.name))
}

/// Every lesson's sheets, a thread for each.
fn each_lesson(check: impl Fn(&Library, &Lesson) + Sync) {
    let library = course().unwrap();
    let lessons: Vec<&Lesson> = library
        .lessons
        .iter()
        .filter(|lesson| lesson.name.starts_with(|c: char| c.is_ascii_digit()))
        .collect();
    assert_eq!(lessons.len(), 12);
    std::thread::scope(|scope| {
        for lesson in lessons {
            let (library, check) = (&library, &check);
            scope.spawn(move || check(library, lesson));
        }
    });
}

#[test]
fn of_ten_thousand_questions_the_key_is_right_and_every_wrong_answer_is_refused_with_its_reason() {
    let count = std::sync::Mutex::new([0, 0, 0]);
    each_lesson(|library, lesson| {
        let mut sheets = BTreeSet::new();
        for seed in 0..SEEDS {
            let sheet = sheet(library, lesson, seed);
            for item in &sheet.items {
                let place = format!("{}: {seed}: {}", lesson.name, item.asked.name);
                judged(item, &place);
                let confirmed = confirmed(&item.asked, &place);
                let mut count = count.lock().unwrap();
                count[0] += 1;
                count[1] += usize::from(item.is_varied);
                count[2] += usize::from(confirmed);
            }
            // two seeds never give the same sheet
            let text = sheet.markdown(false);
            let text = text
                .split_once("\n\n")
                .unwrap()
                .1
                .split_once("\n\n")
                .unwrap()
                .1;
            assert!(sheets.insert(text.to_owned()), "{}: {seed}", lesson.name);
        }
    });
    let [all, varied, closed] = *count.lock().unwrap();
    assert!(10_000 <= all, "{all}");
    // four of ten have numbers of their own (4951 of 10 560), and of many there is a closed form
    assert!(4 * all <= 10 * varied, "{varied} of {all}");
    assert!(600 <= closed, "{closed} of {all}");
}

/// The right answer is accepted, and what is wrong is refused with a reason.
fn judged(item: &Item, place: &str) {
    let asked = &item.asked;
    let right = asked.answer(&asked.right());
    assert!(
        right.right && !right.reason.trim().is_empty(),
        "{place}: {right:?}"
    );
    let refused = |given: &Given| {
        let judged = asked.answer(given);
        assert!(!judged.right, "{place}: {given:?}");
        assert!(!judged.reason.trim().is_empty(), "{place}: {given:?}");
        judged.reason
    };
    match &asked.form {
        Form::Number(of) => {
            assert!(of.answer.is_finite() && 0.0 < of.tolerance, "{place}");
            for sign in [-3.0, 3.0] {
                refused(&Given::Number(of.answer + sign * of.tolerance));
            }
            for (value, choice) in &of.wrong {
                // a number that was drawn is no answer to both, the right one and a wrong one
                let least = if item.is_varied { 2.0 } else { 1.0 } * of.tolerance;
                assert!(least < (value - of.answer).abs(), "{place}: {value}");
                assert_eq!(refused(&Given::Number(*value)), choice.reason, "{place}");
            }
        }
        Form::Choice(choices) | Form::Place(choices) => {
            let texts: BTreeSet<&str> = choices.iter().map(|of| of.text.as_str()).collect();
            assert_eq!(texts.len(), choices.len(), "{place}: {choices:?}");
            assert_eq!(choices.iter().filter(|of| of.right).count(), 1, "{place}");
            for (number, choice) in choices.iter().enumerate().filter(|(_, of)| !of.right) {
                assert_eq!(refused(&Given::Choice(number)), choice.reason, "{place}");
            }
        }
        Form::Several(choices) => {
            let Given::Several(right) = asked.right() else {
                panic!("{place}");
            };
            for (number, choice) in choices.iter().enumerate() {
                let mut other = right.clone();
                if !other.remove(&number) {
                    other.insert(number);
                }
                assert!(
                    refused(&Given::Several(other)).contains(&choice.reason),
                    "{place}"
                );
            }
        }
        Form::Order(of) => {
            refused(&Given::Order(of.order[1..].to_vec()));
            if of.before.is_empty() {
                return;
            }
            let backwards: Vec<usize> = of.order.iter().rev().copied().collect();
            refused(&Given::Order(backwards));
            for (number, item) in of.items.iter().enumerate().filter(|(_, of)| !of.right) {
                let mut more = of.order.clone();
                more.push(number);
                assert!(
                    refused(&Given::Order(more)).contains(&item.reason),
                    "{place}"
                );
            }
        }
        Form::Blank(of) => {
            let right: Vec<f64> = of.answers.iter().map(|of| of.0).collect();
            for (number, (answer, tolerance)) in of.answers.iter().enumerate() {
                let mut other = right.clone();
                other[number] = answer + 3.0 * tolerance;
                assert!(
                    refused(&Given::Blanks(other)).starts_with(&format!("[{}]", number + 1)),
                    "{place}"
                );
            }
        }
    }
}

/// Confirms the trace by the fast drivers of another strategy, and the answer by a closed form where there is one: is there?
fn confirmed(asked: &Asked, place: &str) -> bool {
    let traced = &asked.traced;
    let colour = traced
        .records
        .iter()
        .rev()
        .find_map(|record| match &record.event {
            Event::PixelColour(colour) => Some(colour.raw),
            _ => None,
        });
    let has_light_of_lamps = traced.settings.transport.follows_light();
    if let (Some(colour), false) = (colour, has_light_of_lamps) {
        let structure = Settings::default().structure;
        let chosen = Chosen::new(&traced.scene, StrategyName::Hierarchy, &structure).unwrap();
        let tracer = Tracer::new(&traced.scene, &chosen, traced.settings.transport);
        let other =
            raystep::tracer::trace_pixel(&tracer, traced.pixel, traced.settings.through, &mut Off);
        let other = other.unwrap();
        // z-aligned rays are computed in another frame
        assert!(
            (other - colour).abs().max_element() <= 1e-9,
            "{place}: {colour}, {other}"
        );
    }
    closed_form(asked, traced.file(), place)
}

fn vector(value: &Value) -> [f64; 3] {
    let at = |axis: usize| value[axis].as_f64().unwrap();
    [at(0), at(1), at(2)]
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn scaled(k: f64, a: [f64; 3]) -> [f64; 3] {
    a.map(|x| k * x)
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    scaled(1.0 / dot(a, a).sqrt(), a)
}

/// The eye, and the point of the window: of a window where the scene has it, else 1 ahead of the eye.
fn window_point(file: &Value, [x, y]: [u32; 2]) -> ([f64; 3], [f64; 3]) {
    let camera = &file["camera"];
    let size = [0, 1].map(|axis| camera["pixels"][axis].as_f64().unwrap());
    let place = [f64::from(x) + 0.5, f64::from(y) + 0.5];
    let window = &camera["window"];
    if window.is_object() {
        let [corner, right, up] = ["corner", "right", "up"].map(|key| vector(&window[key]));
        let (u, v) = (place[0] / size[0], 1.0 - place[1] / size[1]);
        let point = std::array::from_fn(|i| corner[i] + u * right[i] + v * up[i]);
        return (vector(&window["cop"]), point);
    }
    let look = &camera["look_at"];
    let cop = vector(&look["cop"]);
    let ahead = unit(sub(vector(&look["target"]), cop));
    let right = unit(cross(ahead, vector(&look["up"])));
    let up = cross(right, ahead);
    let fov = look["fov_degrees"].as_f64().unwrap().to_radians();
    let pixel = 2.0 * (fov / 2.0).tan() / size[1];
    let across = (place[0] - size[0] / 2.0) * pixel;
    let above = (size[1] / 2.0 - place[1]) * pixel;
    let point = std::array::from_fn(|i| cop[i] + ahead[i] + across * right[i] + above * up[i]);
    (cop, point)
}

/// The answers of some questions by a program of three lines.
fn closed_form(asked: &Asked, file: &Value, place: &str) -> bool {
    let is = |found: f64| {
        match &asked.form {
            Form::Number(of) => {
                let off = (found - of.answer).abs();
                assert!(
                    off <= 1e-9 * found.abs().max(1.0),
                    "{place}: {found}, {}",
                    of.answer
                );
            }
            // a choice is shown with six digits
            Form::Choice(choices) => {
                let right = choices.iter().find(|of| of.right).unwrap();
                let shown: f64 = right.text.replace('−', "-").parse().unwrap();
                let off = (found - shown).abs();
                assert!(off <= 1e-5 * found.abs(), "{place}: {found}, {shown}");
            }
            other => panic!("{place}: {other:?}"),
        }
        true
    };
    let (eye, point) = window_point(file, asked.place.pixel);
    let to_window = sub(point, eye);
    let direction = unit(to_window);
    let has_window = file["camera"]["window"].is_object();
    let sphere = |name: &str| {
        let objects = file["objects"].as_array().unwrap();
        let object = objects
            .iter()
            .find(|object| object["name"] == name)
            .unwrap();
        let sphere = &object["shape"]["sphere"];
        (
            vector(&sphere["center"]),
            sphere["radius"].as_f64().unwrap(),
        )
    };
    match (asked.lesson.as_str(), asked.name.as_str(), &asked.form) {
        ("01-pinhole", "window-height", _) if has_window => is(point[1]),
        ("01-pinhole", "window-point", _) | ("03-ray", "pixel-beside", _) if has_window => {
            is(point[0])
        }
        ("03-ray", "t-of-the-window", _) if has_window => is(dot(to_window, to_window).sqrt()),
        // an eye ray for each pixel, and a test of each object
        ("09-cost", "tests-of-a-picture", _) => {
            let count = file["objects"].as_array().unwrap().len() as f64;
            let sides = [0, 1].map(|axis| file["camera"]["pixels"][axis].as_f64().unwrap());
            is(sides[0] * sides[1] * count / 1e6)
        }
        // the distance along the ray to the foot of the centre, less half the chord
        ("04-sphere", "smaller-root", _) => {
            let (center, radius) = sphere("A");
            let to_center = sub(center, eye);
            let along = dot(to_center, direction);
            let off = dot(to_center, to_center) - along * along;
            is(along - (radius * radius - off).sqrt())
        }
        ("04-sphere", "fill-in-the-roots", Form::Blank(of)) => {
            let (center, radius) = sphere("A");
            let to_center = sub(center, eye);
            let along = dot(to_center, direction);
            let off = dot(to_center, to_center) - along * along;
            let half = (radius * radius - off).sqrt();
            let expected = [4.0 * half * half, along - half, along + half];
            for ((answer, _), expected) in of.answers.iter().zip(expected) {
                assert!(
                    (answer - expected).abs() <= 1e-8 * expected.abs().max(1.0),
                    "{place}: {answer}, {expected}"
                );
            }
            true
        }
        _ => false,
    }
}

/// An eye that moved made the half-line pass beside the vertex through which it runs, as the text says.
#[test]
fn a_half_line_through_a_vertex_runs_through_it_on_every_sheet() {
    let library = course().unwrap();
    let lesson = library
        .lessons
        .iter()
        .find(|lesson| lesson.name == "06-polygon")
        .unwrap();
    let height = |text: &str, name: &str| {
        let rest = text.split_once(name).unwrap().1;
        let (pair, _) = rest.split_once(')').unwrap();
        pair.split_once(", ").unwrap().1.to_owned()
    };
    let mut checked = 0;
    for seed in 0..20 {
        let sheet = sheet(&library, lesson, seed);
        let of_vertex = sheet
            .items
            .iter()
            .filter(|item| item.asked.name == "a-vertex-at-the-height");
        for item in of_vertex {
            let text = &item.asked.text;
            assert_eq!(
                height(text, "p′ = ("),
                height(text, "the vertex ("),
                "{seed}: {text}"
            );
            checked += 1;
        }
    }
    assert!(0 < checked);
}

#[test]
fn the_command_writes_a_sheet_and_its_key() {
    let folder = Folder::empty();
    let text = |words: &str| String::from_utf8(folder.run(words).well()).unwrap();
    let sheet = text("lesson worksheet 04 --seed 7");
    let key = text("lesson worksheet 4 --seed 7 --answers");
    assert!(sheet.starts_with("# Worksheet 04: "), "{sheet}");
    assert!(key.starts_with("# Key to worksheet 04: "), "{key}");
    let questions = |text: &str| text.lines().filter(|line| line.starts_with("## ")).count();
    assert_eq!(questions(&sheet), questions(&key));
    assert!(!sheet.contains("**Answer"), "{sheet}");
    assert_eq!(key.matches("**Answer: ").count(), questions(&key));
    assert!(key.contains("Working:"));
    folder
        .run("lesson worksheet 04 --seed 7 -o sheet.md")
        .well();
    assert_eq!(folder.read("sheet.md"), sheet.as_bytes());
    assert_ne!(text("lesson worksheet 04 --seed 8"), sheet);
    let message = folder.run("lesson worksheet 13 --seed 1").refused();
    assert!(message.contains("there is no lesson 13"), "{message}");
    let message = folder.run("lesson worksheet 04").refused();
    assert!(message.contains("--seed"), "{message}");
}

/// No figure of a sheet tells what is asked: it shows what is given, the first stage.
#[test]
fn figures_are_in_the_sheet_and_say_nothing_more_than_the_first_stage() {
    let library = course().unwrap();
    let mut figures = BTreeMap::new();
    for lesson in library
        .lessons
        .iter()
        .filter(|lesson| lesson.name.starts_with(|c: char| c.is_ascii_digit()))
    {
        let mut sheet = sheet(&library, lesson, 3);
        sheet.draw(&library).unwrap();
        for [given, whole] in sheet.items.iter().filter_map(|item| item.figure.as_ref()) {
            assert!(given.svg.len() < whole.svg.len(), "{}", lesson.name);
            assert!(!given.description.is_empty());
            *figures.entry(lesson.name.clone()).or_insert(0) += 1;
        }
        let [blank, key] = [false, true].map(|answers| sheet.markdown(answers));
        assert_eq!(
            blank.matches("data:image/svg+xml;base64,").count(),
            key.matches("data:image/svg+xml;base64,").count()
        );
    }
    assert!(4 <= figures.len(), "{figures:?}");
}
