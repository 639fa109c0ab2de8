//! The scene file: the example of the documentation loads as it stands, and its values arrive.

use std::path::Path;

use glam::DVec3;
use raystep::geometry::Sides;
use raystep::scene::{Emission, Fault, Shape};
use raystep::{LoadError, NoFiles, Scene, load, load_bytes};

fn example() -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/04-sphere/scene.json");
    load(&path).unwrap().build().unwrap()
}

#[test]
fn the_example_loads_as_it_stands() {
    let scene = example();
    assert_eq!(scene.name, "two balls over a floor");
    assert_eq!(scene.camera.pixels, [160, 120]);
    assert_eq!(scene.max_depth, 5);
    assert_eq!(scene.background, DVec3::new(0.6, 0.8, 1.0));
    assert_eq!(scene.lights[0].emission, Emission::Colour(DVec3::ONE));
    let names: Vec<_> = scene.objects.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["A", "B", "C", "floor"]);
    let Shape::Ellipsoid(b) = &scene.primitives[1].shape else {
        panic!("B is an ellipsoid");
    };
    assert_eq!(b.radii, DVec3::new(1.0, 0.5, 0.5));
    let Shape::Polygon(floor) = &scene.primitives[3].shape else {
        panic!("the floor is a polygon");
    };
    assert_eq!(floor.plane().normal, DVec3::Y);
}

#[test]
fn absent_coefficients_are_0_and_the_index_is_1() {
    let scene = example();
    let (name, red) = &scene.materials.0[0];
    assert_eq!(name, "red");
    let absent = (red.reflection, red.transmission, red.index);
    assert_eq!(absent, (0.0, 0.0, 1.0));
}

#[test]
fn one_sided_is_for_opaque_surfaces_alone() {
    let scene = example().one_sided();
    let sides: Vec<_> = scene.primitives.iter().map(|p| p.sides).collect();
    // B is of glass
    assert_eq!(
        sides,
        [Sides::Front, Sides::Both, Sides::Front, Sides::Front]
    );
}

#[test]
fn the_window_of_the_example_spans_40_degrees() {
    // the window lies at distance 1, so its height is 2·tan 20° = 0.727940…
    let camera = example().camera;
    assert!((camera.up - DVec3::new(0.0, 0.727_940_468_532_405, 0.0)).length() <= 1e-14);
    assert!((camera.right.length() / camera.up.length() - 160.0 / 120.0).abs() <= 1e-14);
    assert!((camera.corner().z - 5.0).abs() <= 1e-15);
}

const ONE_TRIANGLE: &str = r#"{
  "camera": { "window": { "cop": [0, 0, 0], "corner": [-1, -1, 1], "right": [2, 0, 0], "up": [0, 2, 0] },
              "pixels": [2, 2] },
  "materials": { "m": { "colour": [1, 1, 1] } },
  "objects": [ { "name": "t", "material": "m", "shape": { "mesh": { "faces": [
    { "vertices": [[0, 0, 5], [1, 0, 5], [0, 1, 5]] } ] } } } ]
}"#;

#[test]
fn a_mesh_may_stand_in_the_scene_itself_and_is_told_by_its_faces() {
    let scene = load_bytes("m.json", ONE_TRIANGLE.as_bytes(), &NoFiles);
    let scene = scene.unwrap().build().unwrap();
    assert_eq!(
        scene.name_of(raystep::scene::PrimitiveId(0)),
        ("t", Some(0))
    );
    assert_eq!(scene.max_depth, 5);
}

#[test]
fn a_value_that_makes_no_sense_is_named_with_its_line_and_path() {
    let bad = ONE_TRIANGLE.replace("[0, 1, 5]", "[2, 0, 5]");
    let loaded = load_bytes("m.json", bad.as_bytes(), &NoFiles).unwrap();
    let Err(LoadError::Fault { place, fault }) = loaded.build() else {
        panic!("a triangle without area was taken");
    };
    assert_eq!(place.line, Some(6));
    assert_eq!(place.path, "objects[0].shape.mesh.faces[0]");
    assert_eq!(
        fault,
        Fault::Polygon(raystep::geometry::PolygonError::NoArea)
    );
}

#[test]
fn a_scene_written_again_is_the_same_scene() {
    let scene = example();
    let mut file = scene.head();
    file.objects = scene.objects.iter().map(|o| scene.object_file(o)).collect();
    let text = serde_json::to_string(&file).unwrap();
    let again = load_bytes("again.json", text.as_bytes(), &NoFiles);
    assert_eq!(again.unwrap().build().unwrap(), scene);
}
