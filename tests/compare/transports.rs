//! The five kinds of ray tracing side by side.

use std::f64::consts::PI;

use serde_json::Value;

use crate::cli::run::Folder;

/// A lamp 3 above the middle of a floor of 8 by 8, and nothing else: every path of light meets one surface or none.
const FLOOR: &str = r#"{
  "name": "a floor",
  "camera": { "look_at": { "cop": [0, 6, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 30 },
              "pixels": [8, 6] },
  "background": [1, 0, 0], "ambient": [0.5, 0.5, 0.5],
  "lights": [ { "position": [0, 3, 0], "power": 100 } ],
  "materials": { "grey": { "colour": [1, 1, 1], "diffuse": 0.5 } },
  "objects": [ { "name": "floor", "material": "grey",
      "shape": { "polygon": { "vertices": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]] } } } ]
}"#;

const PATHS: u64 = 100_000;

fn compared(threads: u32) -> Vec<Value> {
    let folder = Folder::empty().with("scene.json", FLOOR);
    let words = format!(
        "compare scene.json --transports --paths {PATHS} --aperture 0.4 --samples 20 --format json --threads {threads}"
    );
    let json: Value = serde_json::from_slice(&folder.run(&words).well()).unwrap();
    assert_eq!(json["pixels"], serde_json::json!([8, 6]));
    let mut all = json["transports"].as_array().unwrap().clone();
    for kind in &mut all {
        assert!(kind.as_object_mut().unwrap().remove("seconds").is_some());
    }
    all
}

fn of<'a>(all: &'a [Value], name: &str) -> &'a Value {
    all.iter().find(|kind| kind["transport"] == name).unwrap()
}

fn number(value: &Value, key: &str) -> f64 {
    value[key]
        .as_f64()
        .unwrap_or_else(|| panic!("no {key} in {value}"))
}

#[test]
fn all_five_are_compared_and_the_same_on_any_number_of_threads() {
    let all = compared(1);
    let names: Vec<&str> = all
        .iter()
        .map(|kind| kind["transport"].as_str().unwrap())
        .collect();
    let slides = [
        "backward",
        "forward",
        "hybrid-light",
        "hybrid-stored",
        "hybrid-connected",
    ];
    assert_eq!(names, slides);
    assert_eq!(compared(3), all);
}

#[test]
fn rays_are_those_that_the_kind_casts_and_those_that_see_the_floor_contribute() {
    let all = compared(2);
    // 48 eye rays, all of which see the floor, and a ray to the lamp from each point
    let backward = of(&all, "backward");
    assert_eq!(
        (number(backward, "rays"), number(backward, "contributed")),
        (48.0, 48.0)
    );
    assert_eq!(number(backward, "waste"), 0.0);
    let light = of(&all, "hybrid-light");
    assert_eq!(
        (number(light, "rays"), number(light, "contributed")),
        (96.0, 96.0)
    );
    // each path is one leg, and one more if the floor sends it on
    let forward = &of(&all, "forward")["counts"];
    let hit = number(&forward["light"], "hit_something");
    let left = number(&forward["light"], "left_the_scene");
    let absorbed = number(&forward["light"], "absorbed");
    assert_eq!(left + absorbed, PATHS as f64);
    assert_eq!(
        number(of(&all, "forward"), "rays"),
        PATHS as f64 + hit - absorbed
    );
    // the floor is seen from the lamp in a share of asin(16/25)/π of all directions; of those half go on
    let share = 0.64_f64.asin() / PI;
    let deviation = |share: f64, count: f64| (share * (1.0 - share) / count).sqrt();
    assert!(
        (hit / PATHS as f64 - share).abs() <= 3.0 * deviation(share, PATHS as f64),
        "{hit}"
    );
    assert!(
        (absorbed / hit - 0.5).abs() <= 3.0 * deviation(0.5, hit),
        "{absorbed} of {hit}"
    );
}

#[test]
fn nearly_all_that_forward_tracing_casts_is_in_vain() {
    let all = compared(2);
    let forward = of(&all, "forward");
    // L = ρ/π · Φ·cos θ/(4π·r²), integrated over the window and times the aperture of 0.16π, is 0.0150 W of 100 W. By
    // paths of 0.001 W these are 15 on average, give or take 3 · √15, and two rays each
    let contributed = number(forward, "contributed");
    assert!((8.0..=54.0).contains(&contributed), "{contributed}");
    assert!(0.999 < number(forward, "waste"));
    for kind in &all {
        let [rays, contributed] = ["rays", "contributed"].map(|key| number(kind, key));
        assert!(0.0 < contributed && contributed <= rays, "{kind}");
        assert!((number(kind, "waste") - (1.0 - contributed / rays)).abs() <= 1e-12);
    }
}

#[test]
fn each_error_is_the_one_its_kind_has() {
    let all = compared(2);
    // nothing stands in the way, so that the two kinds without chance are the closed form itself
    for exact in ["backward", "hybrid-light"] {
        let kind = of(&all, exact);
        assert_eq!(
            (number(kind, "mean_error"), number(kind, "rms_error")),
            (0.0, 0.0),
            "{exact}"
        );
    }
    // 50 of the nearest photons are off by 1/√49 = 14 %, a little less where neighbours share them
    let stored = number(of(&all, "hybrid-stored"), "rms_error");
    assert!((0.08..=0.2).contains(&stored), "{stored}");
    // a line from each point to the lamp leaves only what differs within a pixel, and what the weights move
    let connected = of(&all, "hybrid-connected");
    assert!(number(connected, "mean_error").abs() <= 0.02, "{connected}");
    // some 15 photons for 48 pixels: hardly a picture
    assert!(0.5 < number(of(&all, "forward"), "rms_error"));
}

#[test]
fn the_table_and_its_csv_have_a_row_for_each_and_say_the_waste_in_words() {
    let folder = Folder::empty().with("scene.json", FLOOR);
    let text = folder
        .run("compare scene.json --transports --paths 1000")
        .well();
    let text = String::from_utf8(text).unwrap();
    assert!(
        text.starts_with("a floor: the light of its lamps, 8 × 6 pixels\n"),
        "{text}"
    );
    assert!(text.contains("forward: of 1 000 paths of light "), "{text}");
    assert!(text.contains("% were wasted\n"), "{text}");
    for line in text.lines() {
        assert!(line.chars().count() <= 80, "{line}");
    }
    assert!(!text.contains("seconds"), "{text}");
    let wide = folder
        .run("compare scene.json --transports --paths 1000 --wide")
        .well();
    let wide = String::from_utf8(wide).unwrap();
    let titles = wide.lines().find(|line| line.starts_with("transport "));
    assert!(titles.unwrap().ends_with("RMS error %  seconds"), "{wide}");
    let csv = folder
        .run("compare scene.json --transports --paths 1000 --format csv")
        .well();
    let csv = String::from_utf8(csv).unwrap();
    let keys =
        "transport,rays,contributed,waste_percent,mean_error_percent,rms_error_percent,seconds";
    assert_eq!(csv.lines().next(), Some(keys));
    assert_eq!(csv.lines().count(), 6);
    assert!(
        csv.contains("\nhybrid-light,96,96,0.00,0.00,0.00,"),
        "{csv}"
    );
}
