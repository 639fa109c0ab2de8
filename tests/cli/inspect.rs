//! `raystep inspect`: the page of a picture says what the plain stepper says, and is refused before it is written.

use std::io::Read;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use flate2::read::GzDecoder;
use serde_json::Value;

use super::run::{Folder, Ran};
use crate::book::plain_words;

/// A part of a pixel's data.
pub(crate) fn unpacked(part: &str) -> Value {
    let bytes = BASE64.decode(part).unwrap();
    let mut json = String::new();
    GzDecoder::new(&bytes[..])
        .read_to_string(&mut json)
        .unwrap();
    serde_json::from_str(&json).unwrap()
}

/// The steps of a part, from their forms and their numbers.
pub(crate) fn steps_of(part: &Value) -> Vec<Value> {
    let texts = |list: &Value| -> Vec<String> {
        let list = list.as_array().unwrap().iter();
        list.map(|text| text.as_str().unwrap().into()).collect()
    };
    let forms: Vec<Vec<String>> = part["forms"]
        .as_array()
        .unwrap()
        .iter()
        .map(texts)
        .collect();
    let mut last = vec![Vec::new(); forms.len()];
    let step = |row: &String| {
        let mut marks = row.split(' ');
        let form: usize = marks.next().unwrap().parse().unwrap();
        let mut numbers: Vec<String> = Vec::new();
        for (place, mark) in marks.enumerate() {
            let before = || -> &String { &last[form][place] };
            let number = match mark.strip_prefix('@') {
                Some(known) => numbers[usize::from_str_radix(known, 36).unwrap()].clone(),
                None if mark.is_empty() => before().clone(),
                None if mark == "+" => (before().parse::<u32>().unwrap() + 1).to_string(),
                None => mark.into(),
            };
            numbers.push(number);
        }
        let mut text = forms[form][0].clone();
        for (number, piece) in numbers.iter().zip(&forms[form][1..]) {
            text += number;
            text += piece;
        }
        last[form] = numbers;
        serde_json::from_str(&text).unwrap()
    };
    texts(&part["rows"]).iter().map(step).collect()
}

/// Numbers that a head has as distances.
pub(crate) fn sums(distances: &Value) -> Value {
    let mut sum = 0;
    let distances = distances.as_array().unwrap().iter();
    distances
        .map(|by| {
            sum += by.as_i64().unwrap();
            sum
        })
        .collect()
}

/// The data of each pixel that a page holds: the head, and then all its steps.
fn pixels(page: &str) -> Vec<(String, Value, Vec<Value>)> {
    let of_pixel = |text: &str| {
        let (pixel, rest) = text.split_once("\">").unwrap();
        let packed = rest.split("</script>").next().unwrap();
        let mut parts: Vec<Value> = packed.split(' ').map(unpacked).collect();
        let head = parts.remove(0);
        let steps = parts.iter().flat_map(steps_of);
        (pixel.to_owned(), head, steps.collect())
    };
    page.split("<script type=\"text/plain\" data-pixel=\"")
        .skip(1)
        .map(of_pixel)
        .collect()
}

fn number(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

/// What `step --predict` prints at a step of which the question is skipped.
fn asked(step: &Value) -> String {
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    let question = &step["question"];
    if question.is_null() {
        return plain_words(step) + "no question waits for an answer\n";
    }
    let choices = question["choices"].as_array().unwrap();
    let choices: String = choices.iter().map(|choice| text(choice) + "\n").collect();
    format!(
        "\n{}\n{}\nquestion: {}\n{choices}answer with a letter, or skip\n{}",
        text(&step["subject"]),
        text(&step["place"]),
        text(&question["text"]),
        plain_words(step)
    )
}

#[test]
fn a_page_says_the_words_of_the_plain_face_with_every_strategy_and_transport() {
    let lamps = include_str!("../../lessons/08-transport/powered.json");
    let folder = Folder::with_scene().with("lamps.json", lamps);
    let strategies = [
        "exhaustive",
        "bounds",
        "hierarchy",
        "heap",
        "grid",
        "z-aligned",
    ];
    let of_strategy = |name: &str| {
        let building = match name {
            "hierarchy" | "heap" | "grid" => " --building",
            _ => "",
        };
        (
            "scene.json",
            "80,60",
            format!("--strategy {name}{building}"),
        )
    };
    let mut cases: Vec<_> = strategies.map(of_strategy).into();
    for transport in ["backward", "forward", "hybrid-stored", "hybrid-connected"] {
        let options = format!("--transport {transport}");
        let few = match transport {
            "backward" => "",
            "hybrid-connected" => " --samples 1",
            _ => " --paths 2000",
        };
        cases.push(("lamps.json", "30,16", options + few));
    }
    let (mut questions, mut steps) = (0, 0);
    for (scene, pixel, options) in cases {
        folder
            .run(&format!(
                "inspect {scene} {pixel} {options} --no-picture -o page.html --quiet"
            ))
            .well();
        let page = String::from_utf8(folder.read("page.html")).unwrap();
        let [(held, head, all)] = &pixels(&page)[..] else {
            panic!("{options}");
        };
        assert_eq!(held, pixel);
        // along the tests, and along the events
        for (key, walk) in [("4", 3), ("5", 4)] {
            let walk = sums(&head["walks"][walk]);
            let walk: Vec<&Value> = walk
                .as_array()
                .unwrap()
                .iter()
                .map(|step| &all[number(step)])
                .collect();
            let script = format!("{key} first{}", " over".repeat(walk.len() - 1));
            let plain = step(
                &folder,
                &format!("step {scene} {pixel} {options} --quiet --script"),
                &script,
            );
            let told: String = walk.iter().map(|step| plain_words(step)).collect();
            assert!(
                plain.ends_with(&told),
                "{options}\n{plain}\n--- page ---\n{told}"
            );

            let script = format!("{key} first skip{}", " over skip".repeat(walk.len() - 1));
            let words = format!("step {scene} {pixel} {options} --quiet --predict --script");
            let plain = step(&folder, &words, &script);
            let told: String = walk.iter().map(|step| asked(step)).collect();
            assert!(
                plain.ends_with(&told),
                "{options}\n{plain}\n--- page ---\n{told}"
            );
            steps += walk.len();
            questions += walk
                .iter()
                .filter(|step| !step["question"].is_null())
                .count();
        }
    }
    assert!(
        300 < steps && 50 < questions,
        "{steps} steps, {questions} questions"
    );
}

/// What a script of the plain stepper prints.
fn step(folder: &Folder, words: &str, script: &str) -> String {
    let ran: Ran = folder.command(words).arg(script).output().unwrap().into();
    String::from_utf8(ran.well()).unwrap()
}

#[test]
fn a_page_of_a_region_has_its_pixels_and_says_how_large_it_is() {
    let folder = Folder::with_scene();
    let ran = folder.run("inspect scene.json --pixels 8,6 --region 3,2-4,3 -o page.html");
    let notes = ran.noted();
    assert!(
        notes.contains("the picture and the heat map took "),
        "{notes}"
    );
    assert!(
        notes.contains("the page holds 4 pixels and has 0.1 of at most 8 MB"),
        "{notes}"
    );
    let page = String::from_utf8(folder.read("page.html")).unwrap();
    let held: Vec<String> = pixels(&page).into_iter().map(|(pixel, ..)| pixel).collect();
    assert_eq!(held, ["3,2", "4,2", "3,3", "4,3"]);
    assert!(page.contains("Heat map: "), "{page}");
    // the page may load nothing, and the drawings are packed with the pixels
    assert!(!page.contains("http:") && !page.contains("https:"));
    // without a region all pixels
    folder
        .run("inspect scene.json --pixels 3,2 --no-picture -o page.html --quiet")
        .well();
    let page = String::from_utf8(folder.read("page.html")).unwrap();
    assert_eq!(pixels(&page).len(), 6);
    assert!(!page.contains("data:image/png"));
}

#[test]
fn a_page_of_a_log_holds_what_the_log_holds() {
    let folder = Folder::with_scene();
    let trace = "trace scene.json --pixels 8,6 --region 3,2-4,2 -o part.jsonl --strategy grid";
    folder.run(trace).well();
    folder.run("inspect part.jsonl -o page.html --quiet").well();
    let page = String::from_utf8(folder.read("page.html")).unwrap();
    let held: Vec<String> = pixels(&page).into_iter().map(|(pixel, ..)| pixel).collect();
    assert_eq!(held, ["3,2", "4,2"]);
    assert!(
        page.contains("<p>The log has 2 of the 48 pixels of the picture.</p>"),
        "{page}"
    );
    assert!(page.contains("Heat map: object tests per pixel"));
    // a log of all pixels has the heat map of the scene
    folder
        .run("trace scene.json --pixels 8,6 --strategy grid -o all.jsonl")
        .well();
    let heat = |from: &str| {
        let page = format!("inspect {from} -o heat.html --quiet");
        folder.run(&page).well();
        let page = String::from_utf8(folder.read("heat.html")).unwrap();
        let image = page.split("<img class=\"heat\"").nth(1).unwrap();
        image.split("</section>").next().unwrap().to_owned()
    };
    let of_scene = heat("scene.json --pixels 8,6 --strategy grid");
    assert_eq!(heat("all.jsonl"), of_scene);
    assert_ne!(heat("part.jsonl"), of_scene);
    // one that holds no tests has none
    folder
        .run("trace scene.json --pixels 8,6 --only pixel,shade,pixel_colour -o few.jsonl")
        .well();
    folder.run("inspect few.jsonl -o page.html --quiet").well();
    assert!(
        !String::from_utf8(folder.read("page.html"))
            .unwrap()
            .contains("Heat map")
    );
    // the same pixel as from the scene
    let scene = "inspect scene.json --pixels 8,6 3,2 --strategy grid -o other.html --quiet";
    folder.run(scene).well();
    let other = String::from_utf8(folder.read("other.html")).unwrap();
    assert_eq!(pixels(&page)[0], pixels(&other)[0]);
    let refused = folder.run("inspect part.jsonl 5,5 -o none.html").refused();
    assert!(
        refused.contains("this log has no steps of pixel 5,5"),
        "{refused}"
    );
    let refused = folder
        .run("inspect part.jsonl --strategy grid -o none.html")
        .refused();
    assert!(refused.contains("--strategy"), "{refused}");
}

#[test]
fn what_makes_no_page_is_refused_and_nothing_is_written() {
    let folder = Folder::with_scene();
    for (words, says) in [
        (
            "inspect scene.json 80,60 -o none.png",
            "a page is not written as .png",
        ),
        ("inspect scene.json 80,60 -o scene.json", "scene.json"),
        ("inspect scene.json 160,60 -o none.html", "160,60"),
        ("inspect scene.json --region 0,0-160,2 -o none.html", "160"),
        (
            "inspect scene.json 80,60 --at 999 -o none.html",
            "there is no step 999",
        ),
        (
            "inspect scene.json 80,60 --at #1,2:3 -o none.html",
            "no such section",
        ),
        (
            "inspect scene.json 80,60 --budget 5 -o none.html",
            "the budget of 5 events",
        ),
        (
            "inspect scene.json --region 0,0-159,99 --megabytes 1 --no-picture -o none.html",
            "the page has 1.0 MB, and it may have 1 MB\n  choose fewer pixels: X,Y or a smaller --region, or raise --megabytes",
        ),
    ] {
        let refused = folder.run(words).refused();
        assert!(refused.contains(says), "{words}: {refused}");
        assert!(!folder.path("none.html").exists(), "{words}");
    }
}
