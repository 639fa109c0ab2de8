//! A wrong part of the simple ray tracer makes another picture than the right one.

use std::collections::{BTreeMap, BTreeSet};

use raystep::explain::grouped;
use raystep::figure::draw;
use raystep::mistake::{Wrong, mistake, mistakes, shown};
use raystep::scene::SceneFile;
use raystep::strategy::UniformGrid;
use raystep::structure::GridOptions;
use raystep::trace::SpoiltValue;
use raystep::tracer::render;
use raystep::tracer::simple::{self, Own};
use raystep::{Counts, FigureName, Rendition, Scene, Through, Tracer, Transport, Width, load};
use serde_json::json;

use crate::figures::library;
use crate::simple_tracer::scene_files;

/// Pixels to a side, odd: the middle of a scene is often its axis.
const SIDE: u32 = 15;

/// A part whose picture is the right one on every scene, since another part hides it.
const NO_PICTURE: [&str; 3] = [
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

/// The figures of the gallery, with the mistake that each shows.
fn gallery() -> Vec<(FigureName, String)> {
    let library = library();
    let figures = library.figures().into_iter();
    let of_gallery = figures.filter(|name| name.lesson == "gallery");
    let with_mistake = of_gallery.map(|name| {
        let (_, spec) = library.find(&name).unwrap();
        let mistake = spec.mistake.clone().unwrap();
        (name, mistake)
    });
    with_mistake.collect()
}

#[test]
fn each_mistake_has_its_figure_in_the_gallery_and_each_figure_a_mistake() {
    let shown: BTreeSet<String> = gallery().into_iter().map(|(_, mistake)| mistake).collect();
    let known: BTreeSet<String> = mistakes().map(|of| of.name.to_owned()).collect();
    assert_eq!(shown, known);
    assert_eq!(gallery().len(), known.len());
}

#[test]
fn a_figure_of_the_gallery_counts_the_pixels_that_differ() {
    let library = library();
    let mut checked = 0;
    for (name, of) in gallery() {
        let (lesson, spec) = library.find(&name).unwrap();
        let scene = lesson.load(&name.figure, spec).unwrap().build().unwrap();
        let wrong = mistake(&of).unwrap().wrong;
        if !wrong.is_part() {
            continue;
        }
        let [right, wrong] = [
            simple::picture(&scene, &Own).bytes(),
            simple::picture(&scene, &wrong).bytes(),
        ];
        let pairs = right.chunks_exact(3).zip(wrong.chunks_exact(3));
        let differing = pairs.clone().filter(|(a, b)| a != b).count();
        let expected = match differing {
            0 => "The picture stays the same.".to_owned(),
            _ => format!(
                "{} of {} pixels differ.",
                grouped(differing as u64),
                grouped(pairs.len() as u64)
            ),
        };
        let traced = lesson.trace(&name.figure, spec).unwrap();
        let drawn = draw(spec, &traced, "id", Width::Book, Rendition::default()).unwrap();
        assert!(
            drawn.description.contains(&expected),
            "{name}: no {expected:?} in {:?}",
            drawn.description
        );
        checked += 1;
    }
    assert!(40 <= checked, "{checked}");
}

/// Without lights no ray but the nearest hits of the eye rays are searched for, by the simple ray tracer and by the engine.
#[test]
fn tests_and_cells_of_a_picture_are_those_that_the_engine_counts() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut file = load(&root.join("lessons/gallery/cloud.json")).unwrap();
    file.scene.lights.clear();
    let scene = file.build().unwrap();
    let wrong = mistake("next plane always +1").unwrap();
    let (_, shown) = shown(&scene, wrong).unwrap();
    let right = |name: &str| {
        let mut all = shown.spoilt.iter();
        all.find(|of| of.quantity == name)
            .map(|of| of.right.clone())
    };
    let grid = UniformGrid::new(&scene, &GridOptions::default()).unwrap();
    let tracer = Tracer::new(&scene, &grid, Transport::HybridLight);
    let (_, lines) = render::<_, Counts>(&tracer, Through::Centres, |_| {}).unwrap();
    let mut counts = Counts::default();
    for line in &lines {
        counts.add(line);
    }
    let number = |count: u64| Some(SpoiltValue::from(count as f64));
    assert_eq!(
        right("object tests to nearest hits"),
        number(counts.objects_tested())
    );
    assert_eq!(right("cells to nearest hits"), number(counts.search.cells));
}
