//! Structures that cannot be built, and scenes that are hard on them.

use std::fmt::Write as _;

use snapbox::{assert_data_eq, str};

use super::{refuses, refuses_in};
use crate::cli::run::{Folder, SCENE};
use crate::cli::strategies::WAYS;

/// What the command says to these options with the scene of the design.
#[track_caller]
fn refuses_options(options: &str) -> String {
    refuses_in(
        &Folder::with_scene(),
        &format!("render scene.json {options}"),
    )
}

/// What the command says to these slabs in the scene.
#[track_caller]
fn refuses_slabs(slabs: &str) -> String {
    let scene = SCENE.replacen('{', &format!("{{ \"slabs\": {slabs},"), 1);
    let folder = Folder::empty().with("scene.json", scene);
    refuses_in(
        &folder,
        "render scene.json --strategy hierarchy --slabs scene",
    )
}

#[test]
fn a_grid_of_a_thousand_million_cells_is_refused_before_it_is_built() {
    let started = std::time::Instant::now();
    assert_data_eq!(
        refuses_options("--strategy grid --grid 1000,1000,1000"),
        str![[r#"
error: a grid of 1000000000 cells takes too much memory; at most 67108864 are allowed
  give a smaller resolution or density

"#]]
    );
    // its lists alone would take 4 GB to clear
    assert!(started.elapsed().as_secs() < 5);
}

#[test]
fn a_grid_without_cells_is_told() {
    assert_data_eq!(
        refuses_options("--strategy grid --grid 0,1,1"),
        str![[r#"
error: --grid: a grid of 0 × 1 × 1 has no cells
  give at least 1 along each axis

"#]]
    );
}

#[test]
fn a_grid_of_a_million_cells_in_a_row_is_told() {
    // what went wrong: it was built, and every ray along x took a million steps
    assert_data_eq!(
        refuses_options("--strategy grid --grid 1000000,1,1"),
        str![[r#"
error: --grid: a ray along x would step through 1000000 cells
  give at most 4096 along each axis

"#]]
    );
    assert_data_eq!(
        refuses_options("--strategy grid --grid 1,4097,1"),
        str![[r#"
error: --grid: a ray along y would step through 4097 cells
  give at most 4096 along each axis

"#]]
    );
}

#[test]
fn a_density_of_more_cells_than_there_is_memory_is_told() {
    assert_data_eq!(
        refuses_options("--strategy grid --density 1e300"),
        str![[r#"
error: a grid of 4e300 cells takes too much memory; at most 67108864 are allowed
  give a smaller resolution or density

"#]]
    );
}

#[test]
fn a_scene_without_slabs_of_its_own_is_told() {
    let message = refuses_options("--strategy hierarchy --slabs scene");
    assert_data_eq!(
        &message,
        str![[r#"
error: --slabs scene: the scene has no "slabs"
  add a list of directions [A, B, C] to it, or take the slabs axes or seven

"#]]
    );
    for options in ["heap", "bounds --volume slabs"] {
        let again = refuses_options(&format!("--strategy {options} --slabs scene"));
        assert_eq!(again, message);
    }
}

#[test]
fn slabs_that_do_not_bound_are_told() {
    assert_data_eq!(
        refuses_slabs("[[1, 0, 0], [0, 1, 0], [1, 1, 0]]"),
        str![[r#"
error: scene.json, line 1, at slabs: the slabs do not bound: they have 2 of 3 independent directions
  add a direction that is not in the plane of the others

"#]]
    );
    assert_data_eq!(
        refuses_slabs("[[1, 0, 0]]"),
        str![[r#"
error: scene.json, line 1, at slabs: the slabs do not bound: they have 1 of 3 independent directions
  add two directions that are not in one plane with the first

"#]]
    );
    assert_data_eq!(
        refuses_slabs("[]"),
        str![[r#"
error: scene.json, line 1, at slabs: the slabs do not bound: they have 0 of 3 independent directions
  give three directions [A, B, C] that are not in one plane

"#]]
    );
}

#[test]
fn parallel_slabs_are_told() {
    assert_data_eq!(
        refuses_slabs("[[1, 0, 0], [0, 1, 0], [-3, 0, 0]]"),
        str![[r#"
error: scene.json, line 1, at slabs[2]: slabs[0] and slabs[2] are parallel
  omit one of them

"#]]
    );
}

#[test]
fn a_slab_without_a_direction_is_told() {
    assert_data_eq!(
        refuses_slabs("[[1, 0, 0], [0, 0, 0], [0, 1, 0]]"),
        str![[r#"
error: scene.json, line 1, at slabs[1]: slabs[1] is zero
  give it a direction [A, B, C], or omit it

"#]]
    );
}

#[test]
fn slabs_of_mixed_lengths_are_told_by_their_line() {
    assert_data_eq!(
        refuses_slabs("[[1, 0], [0, 1, 0], [0, 0, 1]]"),
        str![[r#"
error: scene.json, line 1, at slabs[1]: a direction of slabs has 2 numbers, as the first
  give every direction as [A, B, C], or all of a plane as [A, B]

"#]]
    );
    assert_data_eq!(
        refuses_slabs("[[1, 0, 0], [0, 1, 0], [0, 0, 1, 2]]"),
        str![[r#"
error: scene.json, line 1, at slabs[2]: a direction of slabs has 3 numbers
  give every direction as [A, B, C], or all of a plane as [A, B]

"#]]
    );
}

#[test]
fn slabs_that_no_strategy_looks_at_are_told_with_the_line_they_stand_in() {
    // what went wrong: only --slabs scene noticed them, and did not say where they stand
    let slabs = "{\n  \"slabs\": [[1, 0, 0],\n    [0, 1, 0],\n    [0, -2, 0]],";
    let folder = Folder::empty().with("scene.json", SCENE.replacen('{', slabs, 1));
    assert_data_eq!(
        refuses_in(&folder, "render scene.json"),
        str![[r#"
error: scene.json, line 4, at slabs[2]: slabs[1] and slabs[2] are parallel
  omit one of them

"#]]
    );
}

#[test]
fn more_than_sixteen_slabs_are_told() {
    let slabs: Vec<_> = (1..=17).map(|z| format!("[1, {}, {z}]", z * z)).collect();
    assert_data_eq!(
        refuses_slabs(&format!("[{}]", slabs.join(", "))),
        str![[r#"
error: scene.json, line 1, at slabs: the slabs have 17 directions
  omit some; at most 16 are allowed

"#]]
    );
}

#[test]
fn sixteen_slabs_are_taken() {
    let slabs: Vec<_> = (1..=16).map(|z| format!("[1, {}, {z}]", z * z)).collect();
    let slabs = format!("{{ \"slabs\": [{}],", slabs.join(", "));
    let folder = Folder::empty().with("scene.json", SCENE.replacen('{', &slabs, 1));
    same_pictures(&folder, "--pixels 16,12");
}

#[test]
fn coordinates_of_1e150_are_refused_by_the_loader() {
    assert_data_eq!(
        refuses(
            "scene.json",
            SCENE.replacen("[0, 1, 0], \"radius\"", "[0, 1e150, 0], \"radius\"", 1)
        ),
        str![[r#"
error: scene.json, line 15, at objects[0].shape.sphere.center[1]: 1e150 is too large
  keep every number within ±1e50, so that products stay finite

"#]]
    );
}

/// Every strategy gives the exhaustive one's picture of `scene.json`.
#[track_caller]
fn same_pictures(folder: &Folder, size: &str) {
    let picture = |options: &str| {
        let words = format!("render scene.json {size} -o - {options}");
        folder.run(&words).well()
    };
    let expected = picture("");
    let scene = String::from_utf8(folder.read("scene.json")).unwrap();
    let has_slabs = scene.contains("\"slabs\"");
    for way in WAYS {
        if has_slabs || !way.contains("--slabs scene") {
            assert!(picture(way) == expected, "{way}");
        }
    }
}

/// The scene of the design with other objects.
fn with_objects(objects: &str) -> Folder {
    let start = SCENE.find("\"objects\"").unwrap();
    let end = SCENE.find("\"max_depth\"").unwrap();
    let (head, tail) = (&SCENE[..start], &SCENE[end..]);
    let scene = format!("{head}\"objects\": [{objects}],\n  {tail}");
    Folder::empty().with("scene.json", scene)
}

#[test]
fn a_scene_without_objects_shows_the_background_whatever_the_strategy() {
    let folder = with_objects("");
    same_pictures(&folder, "--pixels 8,6");
    let bytes = folder
        .run("render scene.json --pixels 2,1 --strategy grid -o -")
        .well();
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert_eq!(pixels, [153, 204, 255, 153, 204, 255]);
    // and is explained
    for way in WAYS
        .into_iter()
        .filter(|way| !way.contains("--slabs scene"))
    {
        let builds = ["hierarchy", "heap", "grid"]
            .iter()
            .any(|name| way.contains(name));
        let building = if builds && !way.contains("--building") {
            "--building"
        } else {
            ""
        };
        let words = format!("pixel scene.json 80,60 {building} {way}");
        let text = String::from_utf8(folder.run(&words).well()).unwrap();
        assert!(text.contains("(153, 204, 255)"), "{way}: {text}");
    }
}

#[test]
fn a_scene_of_one_object_is_the_same_whatever_the_strategy() {
    for shape in [
        r#"{ "sphere": { "center": [0, 1, 0], "radius": 1 } }"#,
        r#"{ "polygon": { "vertices": [[-2, 0, 0], [2, 0, 0], [0, 2, 0]] } }"#,
    ] {
        let object = format!(r#"{{ "name": "only", "material": "red", "shape": {shape} }}"#);
        same_pictures(&with_objects(&object), "--pixels 32,24");
    }
}

#[test]
fn a_thousand_spheres_in_one_point_take_no_time_and_are_the_first_of_them() {
    let mut objects = String::new();
    for i in 0..1000 {
        let comma = if i == 0 { "" } else { "," };
        // the first is red, all others glass
        let material = if i == 0 { "red" } else { "glass" };
        write!(
            objects,
            r#"{comma}{{ "name": "{i}", "material": "{material}",
            "shape": {{ "sphere": {{ "center": [0, 1, 0], "radius": 1 }} }} }}"#
        )
        .unwrap();
    }
    let started = std::time::Instant::now();
    let folder = with_objects(&objects);
    same_pictures(&folder, "--pixels 16,12");
    // some 20 pictures of 192 pixels; the slowest builds are done in milliseconds
    assert!(started.elapsed().as_secs() < 60, "{:?}", started.elapsed());
    let text = folder.run("pixel scene.json 80,60 --strategy heap").well();
    let text = String::from_utf8(text).unwrap();
    assert!(text.contains("→ point: the ray hits 0 at t = "), "{text}");
}
