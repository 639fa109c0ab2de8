//! Scenes in JSON: broken, of the wrong form, and without sense.

use snapbox::{assert_data_eq, str};

use super::{refuses, refuses_with};
use crate::cli::run::SCENE;

const SPHERE: &str = r#"{ "sphere": { "center": [0, 1, 0], "radius": 1 } }"#;
const LOOK_AT: &str =
    r#""look_at": { "cop": [0, 1, 6], "target": [0, 1, 0], "up": [0, 1, 0], "fov_degrees": 40 }"#;
const FLOOR: &str = "[[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9]]";

#[test]
fn a_text_that_is_no_json_is_told_by_line() {
    assert_data_eq!(
        refuses("scene.json", "sphere at 0 1 0"),
        str![[r#"
error: scene.json, line 1: expected value
  correct the JSON here, or in the line before; NaN and Infinity are not JSON

"#]]
    );
}

#[test]
fn an_empty_file_is_told() {
    assert_data_eq!(
        refuses("scene.json", ""),
        str![[r#"
error: scene.json, line 1: the file ends in the middle of a value
  correct the JSON here, or in the line before; NaN and Infinity are not JSON

"#]]
    );
}

#[test]
fn a_file_that_is_cut_off_is_told_by_line() {
    assert_data_eq!(
        refuses("scene.json", &SCENE[..900]),
        str![[r#"
error: scene.json, line 18, at objects[3].name: the file ends in the middle of a string
  correct the JSON here, or in the line before; NaN and Infinity are not JSON

"#]]
    );
}

#[test]
fn a_binary_file_is_told() {
    assert_data_eq!(
        refuses("scene.json", b"\x89PNG\r\n\x1a\n\0\0"),
        str![[r#"
error: scene.json, line 1: this is not a text file
  give a scene in JSON, NFF or OBJ

"#]]
    );
}

#[test]
fn an_unknown_key_is_told_with_those_that_exist() {
    assert_data_eq!(
        refuses_with("\"shininess\": 40", "\"shinyness\": 40"),
        str![[r#"
error: scene.json, line 11, at materials.red.shinyness: unknown key `shinyness`, expected one of `colour`, `diffuse`, `specular`, `shininess`, `reflection`, `transmission`, `index`
  compare it with the JSON Schema of a scene file: 'raystep schema scene' prints it

"#]]
    );
}

#[test]
fn a_key_that_is_missing_is_told() {
    assert_data_eq!(
        refuses_with(SPHERE, r#"{ "sphere": { "center": [0, 1, 0] } }"#),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere: missing key `radius`
  compare it with the JSON Schema of a scene file: 'raystep schema scene' prints it

"#]]
    );
}

#[test]
fn a_wrong_type_deep_in_an_object_is_told_by_file_line_and_path() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, 1, 0], "radius": "one" } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.radius: invalid type: string "one", expected a number
  compare it with the JSON Schema of a scene file: 'raystep schema scene' prints it

"#]]
    );
}

#[test]
fn an_unknown_shape_is_told() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "spere": { "center": [0, 1, 0], "radius": 1 } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape: unknown name `spere`, expected one of `sphere`, `ellipsoid`, `box`, `cone`, `polygon`, `mesh`
  compare it with the JSON Schema of a scene file: 'raystep schema scene' prints it

"#]]
    );
}

#[test]
fn a_point_of_two_numbers_is_told() {
    assert_data_eq!(
        refuses_with(SPHERE, r#"{ "sphere": { "center": [0, 1], "radius": 1 } }"#),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.center: invalid length 2, expected an array of length 3
  compare it with the JSON Schema of a scene file: 'raystep schema scene' prints it

"#]]
    );
}

#[test]
fn nan_is_no_number() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, NaN, 0], "radius": 1 } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.center[1]: expected value
  correct the JSON here, or in the line before; NaN and Infinity are not JSON

"#]]
    );
}

#[test]
fn infinity_is_no_number() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, 1, 0], "radius": Infinity } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.radius: expected value
  correct the JSON here, or in the line before; NaN and Infinity are not JSON

"#]]
    );
}

#[test]
fn a_number_beyond_f64_is_told() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, 1e400, 0], "radius": 1 } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.center[1]: number out of range
  give a number within ±1e50

"#]]
    );
}

#[test]
fn a_number_whose_powers_overflow_is_told() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, -1e200, 0], "radius": 1 } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.center[1]: -1e200 is too large
  keep every number within ±1e50, so that products stay finite

"#]]
    );
}

#[test]
fn a_radius_of_zero_is_told() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, 1, 0], "radius": 0 } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.radius: the radius is 0, and must be above 0
  give a value of at least 1e-50

"#]]
    );
}

#[test]
fn a_negative_radius_is_told() {
    assert_data_eq!(
        refuses_with(
            SPHERE,
            r#"{ "sphere": { "center": [0, 1, 0], "radius": -2.5 } }"#
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.radius: the radius is -2.5, and must be above 0
  give a value of at least 1e-50

"#]]
    );
}

#[test]
fn a_polygon_of_two_vertices_is_told() {
    assert_data_eq!(
        refuses_with(FLOOR, "[[-9, 0, -9], [-9, 0, 9]]"),
        str![[r#"
error: scene.json, line 19, at objects[3].shape.polygon: a polygon needs at least 3 vertices, here are 2
  list the corners in order around the polygon

"#]]
    );
}

#[test]
fn collinear_vertices_are_told() {
    assert_data_eq!(
        refuses_with(FLOOR, "[[-9, 0, -9], [0, 0, 0], [9, 0, 9]]"),
        str![[r#"
error: scene.json, line 19, at objects[3].shape.polygon: the vertices are on one line or enclose no area
  list the corners in order around the polygon

"#]]
    );
}

#[test]
fn a_vertex_off_the_plane_is_told_with_its_distance() {
    assert_data_eq!(
        refuses_with(FLOOR, "[[-9, 0, -9], [-9, 0, 9], [9, 1, 9], [9, 0, -9]]"),
        str![[r#"
error: scene.json, line 19, at objects[3].shape.polygon: the polygon is not planar: vertex 2 lies 2.498e-1 off the plane of the others, and 2.548e-4 is allowed for its size
  divide it into triangles, or correct the vertex

"#]]
    );
}

#[test]
fn a_material_that_does_not_exist_is_told_with_the_nearest() {
    assert_data_eq!(
        refuses_with("\"material\": \"glass\"", "\"material\": \"glas\""),
        str![[r#"
error: scene.json, line 16, at objects[1].material: there is no material "glas"
  did you mean "glass"?

"#]]
    );
}

#[test]
fn a_material_like_none_is_told() {
    assert_data_eq!(
        refuses_with("\"material\": \"glass\"", "\"material\": \"wood\""),
        str![[r#"
error: scene.json, line 16, at objects[1].material: there is no material "wood"
  add it to "materials"

"#]]
    );
}

#[test]
fn two_objects_of_one_name_are_told() {
    assert_data_eq!(
        refuses_with("\"name\": \"B\"", "\"name\": \"A\""),
        str![[r#"
error: scene.json, line 16, at objects[1].name: objects[0] is called "A" already
  rename one of them: the log identifies objects by their names

"#]]
    );
}

#[test]
fn a_window_without_area_is_told() {
    assert_data_eq!(
        refuses_with(
            LOOK_AT,
            r#""window": { "cop": [0, 0, 5], "corner": [-1, -1, 0], "right": [2, 0, 0], "up": [4, 0, 0] }"#,
        ),
        str![[r#"
error: scene.json, line 4, at camera.window: the window has no area
  give two edges, right and up, that are neither zero nor parallel

"#]]
    );
}

#[test]
fn a_cop_on_the_plane_of_the_window_is_told() {
    assert_data_eq!(
        refuses_with(
            LOOK_AT,
            r#""window": { "cop": [5, 0, 0], "corner": [-1, -1, 0], "right": [2, 0, 0], "up": [0, 2, 0] }"#,
        ),
        str![[r#"
error: scene.json, line 4, at camera.window.cop: the centre of projection lies on the window's plane
  move the centre of projection off the window's plane

"#]]
    );
}

#[test]
fn two_cameras_are_told() {
    assert_data_eq!(
        refuses_with(
            LOOK_AT,
            &format!(
                r#"{LOOK_AT}, "window": {{ "cop": [0, 0, 5], "corner": [-1, -1, 0], "right": [2, 0, 0], "up": [0, 2, 0] }}"#
            ),
        ),
        str![[r#"
error: scene.json, line 4, at camera: exactly one of "look_at" and "window" is needed, and both are there
  remove "look_at" or "window"

"#]]
    );
}

#[test]
fn a_picture_without_pixels_is_told() {
    assert_data_eq!(
        refuses_with("[160, 120]", "[0, 120]"),
        str![[r#"
error: scene.json, line 5, at camera.pixels: a picture of 0 × 120 pixels cannot be made
  give a width and a height of at least 1, and at most 100000000 pixels in all

"#]]
    );
}

#[test]
fn a_picture_of_a_million_times_a_million_pixels_is_told() {
    assert_data_eq!(
        refuses_with("[160, 120]", "[1000000, 1000000]"),
        str![[r#"
error: scene.json, line 5, at camera.pixels: a picture of 1000000 × 1000000 pixels cannot be made
  give a width and a height of at least 1, and at most 100000000 pixels in all

"#]]
    );
}

#[test]
fn a_mesh_file_that_is_missing_is_told() {
    assert_data_eq!(
        refuses_with(SPHERE, r#"{ "mesh": { "file": "roof.obj" } }"#),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.mesh.file: the mesh file "roof.obj" cannot be read: No such file or directory (os error 2)
  name an OBJ file; its path is relative to the folder of the scene

"#]]
    );
}
