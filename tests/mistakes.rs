//! A wrong part of the simple ray tracer makes another picture than the right one.

use std::collections::BTreeMap;

use raystep::mistake::{Wrong, mistake, mistakes};
use raystep::scene::SceneFile;
use raystep::tracer::simple::{self, Own};
use raystep::{Scene, load};
use serde_json::json;

use crate::simple_tracer::scene_files;

/// Pixels to a side, odd: the middle of a scene is often its axis.
const SIDE: u32 = 15;

/// A part whose picture is the right one on every scene, since another part hides it.
const NO_PICTURE: [&str; 4] = [
    // no light is a billion times as far away as an object
    "ε in t of an unnormalised ray",
    // one root or twice the same: t is equal
    "graze is two hits",
    // a surface that faces away gets no shadow ray and no term
    "only the sum clamped",
    // an infinite t is never nearer than another, and the plane's point there is in no polygon
    "no parallel case",
];

/// What no lesson has: a floor on which a ball throws a shadow of the second light, and behind it a slanted pane of glass that
/// is a single polygon.
fn two_lights_and_a_pane() -> Scene {
    let square = |z: f64, slant: f64| {
        json!({ "polygon": { "vertices": [
            [-4.0, -4.0, z - slant], [4.0, -4.0, z + slant], [4.0, 4.0, z + slant], [-4.0, 4.0, z - slant]
        ] } })
    };
    let file = json!({
        "camera": { "pixels": [SIDE, SIDE], "look_at": {
            "cop": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 50
        } },
        "background": [0.2, 0.4, 0.6],
        "lights": [
            { "name": "first", "position": [-5, 5, 8], "colour": [1, 1, 1] },
            { "name": "second", "position": [5, 5, 8], "colour": [1, 1, 1] }
        ],
        "materials": {
            "dull": { "colour": [1, 1, 1], "diffuse": 0.5 },
            "glass": { "colour": [1, 1, 1], "transmission": 0.8, "index": 1.5 }
        },
        "objects": [
            { "name": "ball", "material": "dull", "shape": { "sphere": { "center": [1, 1, -1], "radius": 1.0 } } },
            { "name": "wall", "material": "dull", "shape": square(-3.0, 0.0) },
            { "name": "pane", "material": "glass", "shape": square(2.0, 1.5) }
        ]
    });
    Scene::new(serde_json::from_value::<SceneFile>(file).unwrap()).unwrap()
}

#[test]
fn a_mistake_in_a_part_shows_on_some_scene() {
    let lessons: Vec<Scene> = scene_files()
        .iter()
        .map(|path| {
            let mut file = load(path).unwrap();
            // wider than high
            file.scene.camera.pixels = [SIDE, SIDE - 4];
            file.scene.max_depth = 3;
            file.build().unwrap()
        })
        .collect();
    let scenes: Vec<Scene> = lessons
        .into_iter()
        .chain([two_lights_and_a_pane()])
        .collect();
    let right: Vec<_> = scenes
        .iter()
        .map(|scene| simple::picture(scene, &Own))
        .collect();
    let bits = |picture: &raystep::tracer::Picture| -> Vec<[u64; 3]> {
        let colours = picture.colours.iter();
        colours
            .map(|colour| colour.to_array().map(f64::to_bits))
            .collect()
    };
    let mut shown: BTreeMap<&str, usize> = BTreeMap::new();
    for of in mistakes() {
        let differs = scenes
            .iter()
            .zip(&right)
            .filter(|(scene, right)| bits(&simple::picture(scene, &of.wrong)) != bits(right));
        shown.insert(of.name, differs.count());
    }
    for of in mistakes() {
        let expected = of.wrong.is_part() && !NO_PICTURE.contains(&of.name);
        assert_eq!(0 < shown[of.name], expected, "{}: {shown:#?}", of.name);
    }
    let with_picture = shown.values().filter(|&&scenes| 0 < scenes).count();
    assert!(30 <= with_picture, "{with_picture}");
}

#[test]
fn a_mistake_says_which_function_it_replaces() {
    let of = mistake("largest root").unwrap();
    assert!(matches!(of.wrong, Wrong::Root(_)));
    assert_eq!(of.wrong.replaces(), "Parts::root");
    assert_eq!(of.spoils, "t");
}
