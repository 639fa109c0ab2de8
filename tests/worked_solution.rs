//! The worked solution reads as one does it by hand: its lines against a pixel worked out on paper.

pub(crate) mod light;
pub(crate) mod ranges;
mod renderers;
mod strategies;

use raystep::explain::render;
use raystep::strategy::Exhaustive;
use raystep::trace::{Kind, Kinds};
use raystep::tracer::trace_pixel;
use raystep::{
    NoFiles, Record, Recording, Scene, Settings, Through, Tracer, Transport, WorkedOptions,
    load_bytes,
};

/// One pixel, whose eye ray runs along z from the origin: every number below is one of a few halves.
///
/// The mirror M is met at (0, 0, 4) with N = (0, 0, −1); the lamp stands in the eye, so L = V = N. The ball
/// behind the eye is what the mirror shows; the wall is parallel to the ray.
const SCENE: &str = r#"{
  "name": "on paper",
  "camera": { "window": { "cop": [0, 0, 0], "corner": [-1, -1, 1], "right": [2, 0, 0], "up": [0, 2, 0] },
              "pixels": [1, 1] },
  "background": [0, 0, 1],
  "ambient": [0.5, 0.5, 0.5],
  "lights": [ { "name": "lamp", "position": [0, 0, 0], "colour": [1, 1, 1] } ],
  "materials": {
    "mirror": { "colour": [0.5, 0.5, 0], "diffuse": 0.5, "specular": 0.25, "shininess": 3, "reflection": 0.5 },
    "dull": { "colour": [1, 0, 0] }
  },
  "objects": [
    { "name": "M", "material": "mirror", "shape": { "sphere": { "center": [0, 0, 5], "radius": 1 } } },
    { "name": "ball", "material": "dull", "shape": { "sphere": { "center": [0, 0, -4], "radius": 2 } } },
    { "name": "wall", "material": "dull", "shape": { "polygon": { "vertices": [[3, -9, -9], [3, 9, -9], [3, 9, 9], [3, -9, 9]] } } },
    { "name": "far", "material": "dull", "shape": { "sphere": { "center": [0, 3, 5], "radius": 1 } } }
  ],
  "max_depth": 2
}"#;

/// The worked solution as plain text, without hints.
pub(crate) fn worked_text(
    scene: &Scene,
    settings: &Settings,
    records: &[Record],
    options: &WorkedOptions,
) -> String {
    let page = raystep::worked_solution(scene, settings, records, options);
    render::plain(&page, render::no_hint)
}

pub(crate) fn scene() -> Scene {
    let loaded = load_bytes("paper.json", SCENE.as_bytes(), &NoFiles).unwrap();
    loaded.build().unwrap()
}

pub(crate) fn records(scene: &Scene) -> Vec<Record> {
    let strategy = Exhaustive::new(scene);
    let tracer = Tracer::new(scene, &strategy, Transport::HybridLight);
    let mut recording = Recording::new(Vec::new());
    trace_pixel(&tracer, [0, 0], Through::Centres, &mut recording).unwrap();
    recording.into_sink()
}

fn solution(options: &WorkedOptions) -> String {
    let scene = scene();
    worked_text(&scene, &Settings::default(), &records(&scene), options)
}

/// Each of the lines stands in the solution, in this order.
#[track_caller]
fn check(text: &str, lines: &[&str]) {
    let mut rest = text.lines();
    for line in lines {
        let found = rest.any(|candidate| candidate.trim_start() == *line);
        assert!(found, "not there, or not in its place: {line}\n{text}");
    }
}

#[test]
fn the_eye_ray_is_worked_out_as_on_paper() {
    check(
        &solution(&WorkedOptions::default()),
        &[
            "Pixel (0, 0) of \"on paper\"",
            "P = corner + 0.5/1·right + (1 − 0.5/1)·up",
            "= (−1, −1, 1) + 0.5·(2, 0, 0) + 0.5·(0, 2, 0)",
            "= (0, 0, 1)",
            "Ray 0: eye ray, depth 1",
            "direction: P − COP = (0, 0, 1), of length 1",
            "ray: (x, y, z) = (0, 0, 0) + t·(0, 0, 1) … (i), for t > 0",
            "M: sphere, centre (0, 0, 5), radius 1",
            "frame: o − centre = (0, 0, −5)",
            "a, b, c of a·t² + b·t + c = 0 … (iii)",
            "a = Δ·Δ = 0² + 0² + 1² = 1",
            "b = 2·Δ·(o − centre) = 2·[0·0 + 0·0 + 1·(−5)] = −10",
            "c = |o − centre|² − r² = 0² + 0² + (−5)² − 1² = 24",
            "discriminant: b² − 4ac = 100 − 96 = 4 > 0: two real roots",
            "roots: t = (−b ± √4)/2a = (10 ± 2)/2 = 4 and 6",
            "root that counts: t = 4, the smallest that counts: a hit; t = 6 lies beyond it",
            "→ nearest hit so far",
            "ball: sphere, centre (0, 0, −4), radius 2",
            "discriminant of t² + 8·t + 12 = 0: b² − 4ac = 64 − 48 = 16",
            "root that counts: none, t = −6 lies behind the origin; t = −2 lies behind the origin: missed",
            "plane: x + 0·y + 0·z − 3 = 0 … (iv)",
            "t: none, the denominator of (v) is 0: the ray is parallel to the plane, missed",
            "far: sphere, centre (0, 3, 5), radius 1",
            "discriminant of t² − 10·t + 33 = 0: b² − 4ac = 100 − 132 = −32 < 0, no real root: missed",
            "→ point: the ray hits M at t = 4",
            "p = o + t·Δ = (0, 0, 4)",
            "normal: N = (p − centre)/r = [(0, 0, 4) − (0, 0, 5)]/1 = (0, 0, −1)",
            "ε of the rays spawned here = 1e-9·max(|x|, |y|, |z|, t) = 1e-9·4 = 4e-9",
        ],
    );
}

#[test]
fn the_shade_is_worked_out_as_on_paper() {
    check(
        &solution(&WorkedOptions::default()),
        &[
            r#"Ray 1: shadow ray to light "lamp", spawned by ray 0, depth 2"#,
            "→ visibility: no object is in between, so the light is visible",
            r#"visibility of light "lamp": visible"#,
            "L = (light − p)/|light − p| = [(0, 0, 0) − (0, 0, 4)]/4 = (0, 0, −1)",
            "N·L = 0·0 + 0·0 + (−1)·(−1) = 1",
            "diffuse: light·colour·diffuse·(N·L) = (1, 1, 1)·(0.5, 0.5, 0)·0.5·1 = (0.25, 0.25, 0)",
            "specular: R = 2(N·L)N − L = (0, 0, −1), V = −Δ = (0, 0, −1)",
            "R·V = 0·0 + 0·0 + (−1)·(−1) = 1",
            "light·specular·max(0, R·V)^shininess = (1, 1, 1)·0.25·1^3 = (0.25, 0.25, 0.25)",
            "ambient: (0.5, 0.5, 0.5)·(0.5, 0.5, 0) = (0.25, 0.25, 0)",
            "sum over the visible lights: (0.5, 0.5, 0.25)",
            "Ray 2: reflected ray, spawned by ray 0, depth 2",
            "direction: Δ = Δ′ − 2(Δ′·N)N = (0, 0, 1) − 2·(−1)·(0, 0, −1) = (0, 0, −1), with Δ′ the direction of the \
             incoming ray",
            "→ point: the ray hits ball at t = 6",
            // the ball is dull, and the lamp reaches it: ½·(1, 0, 0) of ambient light is all
            "colour of the ray: I = ambient + lights = (0.5, 0, 0) + (0, 0, 0) = (0.5, 0, 0)",
            "colour of the ray: I = ambient + lights + reflection·I_reflected = (0.25, 0.25, 0) + (0.5, 0.5, 0.25) + \
             0.5·(0.5, 0, 0) = (1, 0.75, 0.25)",
            "Colour of the pixel",
            "from the eye ray: (1, 0.75, 0.25)",
            "times 255, in the picture: (255, 191, 64)",
        ],
    );
}

#[test]
fn a_ray_is_indented_below_the_one_that_spawned_it() {
    let text = solution(&WorkedOptions::default());
    let indent = |start: &str| {
        let line = text.lines().find(|l| l.trim_start().starts_with(start));
        let line = line.unwrap();
        line.len() - line.trim_start().len()
    };
    assert_eq!(indent("Ray 0:"), 0);
    assert_eq!(indent("Ray 1:"), 2);
    assert_eq!(indent("Ray 2:"), 2);
    assert_eq!(indent("Ray 3:"), 4);
}

#[test]
fn only_some_kinds_are_shown_where_that_is_asked_for() {
    let text = solution(&WorkedOptions {
        kinds: Kinds::of(&[Kind::PlaneTest]),
        ..WorkedOptions::default()
    });
    assert!(text.contains("… (iv)"));
    for other in [
        "sphere",
        "visibility",
        "P = corner",
        "of the pixel",
        "nearest",
    ] {
        assert!(!text.contains(other), "{other} in\n{text}");
    }
}

#[test]
fn one_ray_alone_names_the_rays_that_it_spawned() {
    let text = solution(&WorkedOptions {
        ray: Some(0),
        ..WorkedOptions::default()
    });
    assert!(text.contains("Ray 0:"));
    check(
        &text,
        &["Ray 2: reflected ray, spawned by ray 0, depth 2: the ray hits ball at t = 6"],
    );
}

#[test]
fn a_solution_of_a_filtered_trace_says_what_is_there() {
    let scene = scene();
    let kept: Vec<_> = records(&scene)
        .into_iter()
        .filter(|record| record.event.kind() == Kind::SphereTest)
        .collect();
    let settings = Settings {
        only: Some(vec!["sphere_test".into()]),
        ..Settings::default()
    };
    let text = worked_text(&scene, &settings, &kept, &WorkedOptions::default());
    assert!(text.contains("the log holds only: sphere_test"), "{text}");
    assert!(text.contains("b² − 4ac = 100 − 96 = 4"), "{text}");
}

#[test]
fn colour_changes_no_word() {
    let scene = scene();
    let records = records(&scene);
    let (settings, options) = (Settings::default(), WorkedOptions::default());
    let page = raystep::worked_solution(&scene, &settings, &records, &options);
    let plain = render::plain(&page, render::no_hint);
    let coloured = render::ansi(&page, render::no_hint);
    assert!(!plain.contains('\u{1b}'));
    assert!(coloured.contains('\u{1b}'));
    assert_eq!(anstream::adapter::strip_str(&coloured).to_string(), plain);
}
