//! Light on its way, as one works it out by hand: a lamp above one floor.

use raystep::strategy::Exhaustive;
use raystep::trace::{Kind, Kinds, Region};
use raystep::tracer::{LightPass, paths_behind, trace_pixel};
use raystep::{
    NoFiles, Off, Record, Recording, Scene, Settings, Through, Tracer, Transport, WorkedOptions,
    load_bytes,
};

use crate::worked_solution::worked_text;

use super::check;

/// The eye at (0, 2, 0) looks straight down through a window of 2 × 2 at distance 1, onto a floor at y = 0 that
/// sends on 0.8, 0.4 and 0.2 of red, green and blue.
pub(crate) const SCENE: &str = r#"{
  "name": "a lamp over a floor",
  "camera": { "window": { "cop": [0, 2, 0], "corner": [-1, 1, -1], "right": [2, 0, 0], "up": [0, 0, 2] },
              "pixels": [4, 4] },
  "lights": [ { "name": "lamp", "position": [0, 2, 1], "power": 100 } ],
  "materials": { "chalk": { "colour": [1, 0.5, 0.25], "diffuse": 0.8 } },
  "objects": [
    { "name": "floor", "material": "chalk",
      "shape": { "polygon": { "vertices": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]] } } }
  ]
}"#;

/// A glass ball over the same floor, and a mirror beside it.
pub(crate) const GLASS: &str = r#"{
  "name": "a glass ball over a floor",
  "camera": { "look_at": { "cop": [0, 2, 7], "target": [0, 1, 0], "up": [0, 1, 0], "fov_degrees": 40 },
              "pixels": [6, 4] },
  "lights": [ { "name": "lamp", "position": [0, 4, 1], "power": 80 },
              { "name": "spot", "position": [2, 3, 3], "power": 40 } ],
  "materials": {
    "chalk": { "colour": [1, 0.5, 0.25], "diffuse": 0.8, "reflection": 0.1 },
    "glass": { "colour": [1, 1, 1], "diffuse": 0.05, "reflection": 0.1, "transmission": 0.85, "index": 1.5 } },
  "objects": [
    { "name": "ball", "material": "glass", "shape": { "sphere": { "center": [0, 1, 0], "radius": 1 } } },
    { "name": "floor", "material": "chalk",
      "shape": { "polygon": { "vertices": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]] } } },
    { "name": "wall", "material": "chalk",
      "shape": { "polygon": { "vertices": [[-4, 0, -4], [4, 0, -4], [4, 5, -4], [-4, 5, -4]] } } }
  ]
}"#;

/// The scene of a JSON text.
#[track_caller]
pub(crate) fn built(text: &str) -> Scene {
    let loaded = load_bytes("scene.json", text.as_bytes(), &NoFiles).unwrap();
    loaded.build().unwrap()
}

/// So few paths that they are traced in no time, and an aperture so wide that some arrive.
pub(crate) fn settings(transport: Transport) -> Settings {
    let mut settings = Settings {
        transport,
        ..Settings::default()
    };
    settings.light.paths = 2000;
    settings.light.aperture = Some(0.5);
    settings.light.nearest = 8;
    settings
}

/// What led to a pixel: the paths of light behind it, then its own records.
pub(crate) fn records(scene: &Scene, settings: &Settings, pixel: [u32; 2]) -> Vec<Record> {
    let strategy = Exhaustive::new(scene);
    let region = Region::pixel(pixel);
    let pass = LightPass::new(scene, &strategy, settings, Some(region), |Off| {}, |_| {}).unwrap();
    let tracer = Tracer::new(scene, &strategy, settings.transport).with_light(pass.as_ref());
    let mut recording = Recording::new(Vec::new());
    for path in paths_behind(&tracer, region, settings.through).unwrap() {
        tracer.trace_path(path, &mut recording).unwrap();
    }
    trace_pixel(&tracer, pixel, Through::Centres, &mut recording).unwrap();
    recording.into_sink()
}

fn solution(settings: &Settings, pixel: [u32; 2], options: &WorkedOptions) -> String {
    let scene = built(SCENE);
    let records = records(&scene, settings, pixel);
    worked_text(&scene, settings, &records, options)
}

fn told(transport: Transport) -> String {
    solution(&settings(transport), [1, 1], &WorkedOptions::default())
}

/// The numbers after the last `=` of the first line that holds a text.
#[track_caller]
fn value(text: &str, holds: &str) -> f64 {
    let line = text.lines().find(|line| line.contains(holds));
    let line = line.unwrap_or_else(|| panic!("no {holds} in\n{text}"));
    let number = line.rsplit(" = ").next().unwrap();
    let number = number.split([' ', ',']).next().unwrap();
    number.replace('−', "-").parse().unwrap()
}

/// The two points of the first line that holds them: `x = (…), …, x′ = (…)`.
#[track_caller]
fn ends(text: &str) -> [[f64; 3]; 2] {
    let line = text
        .lines()
        .find(|line| line.trim_start().starts_with("x = ("))
        .unwrap();
    let points: Vec<[f64; 3]> = line
        .split('(')
        .skip(1)
        .map(|part| {
            let (numbers, _) = part.split_once(')').unwrap();
            let numbers: Vec<f64> = numbers
                .replace('−', "-")
                .split(", ")
                .map(|n| n.parse().unwrap())
                .collect();
            numbers.try_into().unwrap()
        })
        .collect();
    points.try_into().unwrap()
}

/// Six printed digits, through a few operations.
const PRINTED: f64 = 1e-5;

#[track_caller]
fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= PRINTED * b.abs(), "{a} {b}");
}

#[test]
fn the_geometry_term_of_a_line_from_lamp_to_floor_is_that_of_paper_and_pencil() {
    let text = told(Transport::HybridConnected);
    let of_lamp = text.find(r#"Connection of light "lamp""#).unwrap();
    let text = &text[of_lamp..];
    let [lamp, floor] = ends(text);
    assert_eq!(lamp, [0.0, 2.0, 1.0]);
    // floor is y = 0, so the lamp is 2 above it: cos θ' = 2/d and G = 2/d³
    let squared = floor[0] * floor[0] + 4.0 + (floor[2] - 1.0) * (floor[2] - 1.0);
    let geometry = 2.0 / squared.powf(1.5);
    close(value(text, "G = cos θ·cos θ′/d²"), geometry);
    check(
        text,
        &["cos θ = 1: a point light emits the same in all directions"],
    );

    // the lamp sends 1/(4π) per steradian, the floor 0.8/π; at the eye, with the window at distance 1 and cos θ = 2/e
    // to the floor at distance e: d = 1/cos θ, A = 4, so d²/(A·cos θ) = (e/2)³/4; and G of that edge is 2/e³
    let eye_squared = floor[0] * floor[0] + 4.0 + floor[2] * floor[2];
    let eye_distance = eye_squared.sqrt();
    let pi = std::f64::consts::PI;
    let own = 1.0 / (geometry / (4.0 * pi) * 0.8 / pi);
    let at_eye = (eye_distance / 2.0).powi(3) / 4.0;
    let other = 1.0 / (2.0 / eye_distance.powi(3) * 0.8 / pi * at_eye);
    close(value(text, "edge 0–1, the line"), own);
    close(value(text, "edge 1–2"), other);
    // (2/e³)·(e³/32) = 1/16, whatever e: the share is 16·π/0.8
    close(other, 20.0 * pi);
    close(value(text, "w = share/Σ shares"), own / (own + other));

    // 100 W over 64 paths, and 16 pixels share them: 1.5625/(4π)·G·0.8/π·w, 16 times
    let red = 1.5625 / (4.0 * pi) * geometry * 0.8 / pi * own / (own + other);
    let adds = text
        .lines()
        .find(|line| line.contains("→ the line adds"))
        .unwrap();
    let printed = adds.rsplit('(').next().unwrap().split(',').next().unwrap();
    close(printed.parse().unwrap(), 16.0 * red);
}

#[test]
fn a_photon_on_its_way_to_the_eye_brings_its_power_by_the_area_it_passes() {
    let text = told(Transport::Forward);
    check(
        &text,
        &[
            "2 000 paths of light, seed 1; the eye is an aperture of radius 0.5",
            "Window point: the pixel's centre; no ray is cast through it, photons arrive at the pixel",
        ],
    );
    // the planes of window and aperture are 1 apart: cos θ = 1/d, so G = 1/d⁴
    let squared = value(&text, "d² = |window − aperture|²");
    let geometry = value(&text, "G = cos²θ/d²");
    close(geometry, 1.0 / (squared * squared));
    // 100 W over 2000 paths, a disc of radius ½, pixels of ½ × ½
    let red = 0.05 / (geometry * std::f64::consts::PI * 0.25 * 0.25);
    let line = text
        .lines()
        .find(|line| line.contains("L = power/"))
        .unwrap();
    let printed = line
        .split(" = (")
        .last()
        .unwrap()
        .split(',')
        .next()
        .unwrap();
    close(printed.parse().unwrap(), red);
}

#[test]
fn an_aperture_of_nothing_sees_nothing_and_the_solution_says_why() {
    let mut settings = settings(Transport::Forward);
    settings.light.aperture = Some(0.0);
    let text = solution(&settings, [1, 1], &WorkedOptions::default());
    check(
        &text,
        &[
            "none of 2 000 photons passes this pixel into the eye: the eye's aperture is a point, which no photon \
             ever hits",
            "nothing arrives: (0, 0, 0)",
        ],
    );
    assert!(!text.contains("Ray 0"), "{text}");
}

#[test]
fn photons_around_a_point_make_its_irradiance() {
    let text = told(Transport::HybridStored);
    let r = value(&text, "area = π·r²").sqrt();
    assert!(0.0 < r);
    check(
        &text,
        &[
            "→ point: the ray hits floor at t = 2.12132",
            "gathered light of the photons stored around p on floor",
            "… 3 more photons",
            // seven of eight, each with 100 W over 2000 paths
            "irradiance: Σ power = 0.05·(7, 7, 7) = (0.35, 0.35, 0.35), in W, with how many of the 7 photons carry each channel",
            "ambient: none, the paths of light replace it",
        ],
    );
    let area = value(&text, "area = π·r²");
    let line = text
        .lines()
        .find(|line| line.contains("E = Σ power/area"))
        .unwrap();
    let red = line.rsplit('(').next().unwrap().split(',').next().unwrap();
    close(red.parse().unwrap(), 0.35 / area);
    let photons = text
        .lines()
        .filter(|line| line.contains("stored and gathered"))
        .count();
    assert_eq!(photons, 8, "{text}");
}

#[test]
fn a_path_of_light_is_told_leg_by_leg_and_in_full_where_all_is_asked_for() {
    let text = told(Transport::HybridStored);
    let title = r#"of light: from light "lamp", carries 0.05 W in each channel (100 W of the light, shared by 2 000 paths)"#;
    assert!(text.contains(title), "{text}");
    let legs = text
        .lines()
        .filter(|line| line.starts_with(r#"  leg 1: light "lamp" → floor at t = "#))
        .count();
    assert_eq!(legs, 8, "{text}");
    let all = WorkedOptions {
        all: true,
        ..WorkedOptions::default()
    };
    let full = solution(&settings(Transport::HybridStored), [1, 1], &all);
    assert!(!full.contains("\"lamp\" → floor"), "{full}");
    check(
        &full,
        &[
            r#"Ray 0: light ray from light "lamp", depth 1"#,
            "→ nearest hit so far",
            "Ray 0: eye ray, depth 1",
        ],
    );
}

#[test]
fn of_many_paths_some_are_told_and_the_others_counted() {
    let mut settings = settings(Transport::HybridStored);
    settings.light.nearest = 50;
    let text = solution(&settings, [1, 1], &WorkedOptions::default());
    let paths = text
        .lines()
        .filter(|line| line.starts_with("Path "))
        .count();
    assert_eq!(paths, 8);
    assert!(text.contains("more paths of light led to the pixel"));
}

#[test]
fn kinds_and_a_ray_restrict_light_as_they_do_the_pixel() {
    let settings = settings(Transport::HybridConnected);
    let only = WorkedOptions {
        kinds: Kinds::of(&[Kind::Connection]),
        ..WorkedOptions::default()
    };
    let text = solution(&settings, [1, 1], &only);
    assert!(text.contains("G = cos θ·cos θ′/d²"));
    for other in [
        "ξ",
        "w = share",
        "plane",
        "Colour of the pixel",
        "P = corner",
    ] {
        assert!(!text.contains(other), "{other} in\n{text}");
    }
    // ray 2 is the first line of the pixel, though paths of light have a ray 2 as well
    let ray = WorkedOptions {
        ray: Some(2),
        ..WorkedOptions::default()
    };
    let text = solution(&settings, [1, 1], &ray);
    assert_eq!(text.matches(r#"Connection of light "lamp""#).count(), 1);
    assert!(text.contains("G = cos θ·cos θ′/d²"), "{text}");
    assert!(!text.contains("Path "), "{text}");
}

#[test]
fn a_mirror_or_glass_on_the_way_is_told_as_what_cannot_be_the_line() {
    let scene = built(GLASS);
    let settings = settings(Transport::HybridConnected);
    let text: String = (0..4)
        .flat_map(|y| (0..6).map(move |x| [x, y]))
        .map(|pixel| {
            let records = records(&scene, &settings, pixel);
            worked_text(&scene, &settings, &records, &WorkedOptions::default())
        })
        .collect();
    for line in [
        "since a mirror or glass at an end reflects or refracts in one direction only",
        "w = 1: no other edge could have been the line",
        "→ contribution: none, V = 0 since an object is in between",
        "the refracted radiance is multiplied by (n₁/n₂)² = 1.5² = 2.25, since the solid angle changes",
    ] {
        assert!(text.contains(line), "{line}");
    }
}

#[test]
fn the_aperture_is_a_twentieth_of_the_way_to_the_window_unless_it_is_given() {
    let scene = built(SCENE);
    let mut light = settings(Transport::Forward).light;
    for given in [None, Some(0.25)] {
        light.aperture = given;
        // a window that is looked at stands at distance 1
        assert_eq!(light.aperture_radius(&scene.camera), given.unwrap_or(0.05));
    }
}
