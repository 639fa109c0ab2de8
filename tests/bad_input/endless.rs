//! Trees of rays that do not end: each ray that meets a pane is followed by two.

use snapbox::{assert_data_eq, str};

use super::refuses_in;
use crate::cli::run::Folder;

/// A picture of 9 × 9 pixels, 30° wide, of panes across the view that reflect one half and transmit the other.
///
/// At distance 1 the window reaches to tan 15° = 0.268 on each side, and a pixel is 2·0.268/9 = 0.0595 wide.
fn panes(panes: &[[f64; 5]], max_depth: u32) -> Folder {
    let pane = |(number, [left, right, below, above, z]): (usize, &[f64; 5])| {
        format!(
            r#"{{ "name": "pane {number}", "material": "pane", "shape": {{ "polygon": {{ "vertices":
               [[{left}, {below}, {z}], [{right}, {below}, {z}], [{right}, {above}, {z}], [{left}, {above}, {z}]]
               }} }} }}"#
        )
    };
    let panes: Vec<String> = panes.iter().enumerate().map(pane).collect();
    let scene = format!(
        r#"{{ "camera": {{ "look_at": {{ "cop": [0, 0, 0], "target": [0, 0, -1], "up": [0, 1, 0],
             "fov_degrees": 30 }}, "pixels": [9, 9] }},
             "materials": {{ "pane": {{ "colour": [1, 1, 1], "reflection": 0.5, "transmission": 0.5 }} }},
             "objects": [{}], "max_depth": {max_depth} }}"#,
        panes.join(",")
    );
    Folder::empty().with("panes.json", scene)
}

/// Three large panes behind each other. Between them rays become more and more: 2⁵⁰ at a depth of 100, and more.
fn endless() -> Folder {
    let pane = |z| [-9.0, 9.0, -9.0, 9.0, z];
    panes(&[pane(-1.0), pane(-2.0), pane(-3.0)], 100)
}

#[test]
fn a_pixel_ends_at_its_budget() {
    assert_data_eq!(
        endless()
            .run("pixel panes.json 4,4 --budget 100000")
            .refused(),
        str![[r#"
error: the budget of 100000 events is used up
  narrow the trace with --region or --only, lower --max-depth, or raise --budget

"#]]
    );
}

#[test]
fn a_log_ends_at_its_budget() {
    let folder = endless();
    for region in ["", " --region 4,4", " --region 4,4-8,8 --threads 1"] {
        let words = format!("trace panes.json --budget 100000{region}");
        assert_data_eq!(
            refuses_in(&folder, &words),
            str![[r#"
error: the budget of 100000 events is used up
  narrow the trace with --region or --only, lower --max-depth, or raise --budget

"#]]
        );
    }
}

#[test]
fn a_log_of_few_kinds_ends_at_the_most_rays() {
    let folder = endless();
    for threads in [1, 3] {
        let words = format!(
            "trace panes.json --only pixel_colour --max-rays 1000 --region 2,3-8,8 --threads {threads}"
        );
        assert_data_eq!(
            refuses_in(&folder, &words),
            str![[r#"
error: pixel 2,3 takes more than 1000 rays
  lower --max-depth, or raise --max-rays

"#]]
        );
    }
}

#[test]
fn a_picture_ends_at_the_most_rays_of_its_first_pixel() {
    let folder = endless();
    for options in [
        "--threads 1",
        "--threads 3",
        "--through corners",
        "--transport backward --strategy grid",
        "--heatmap tests",
        "--stats",
    ] {
        let words = format!("render panes.json --max-rays 1000 {options}");
        assert_data_eq!(
            refuses_in(&folder, &words),
            str![[r#"
error: pixel 0,0 takes more than 1000 rays
  lower --max-depth, or raise --max-rays

"#]]
        );
    }
}

#[test]
fn a_picture_ends_at_a_million_rays_unless_another_number_is_given() {
    assert_data_eq!(
        refuses_in(&endless(), "render panes.json"),
        str![[r#"
error: pixel 0,0 takes more than 1000000 rays
  lower --max-depth, or raise --max-rays

"#]]
    );
}

#[test]
fn a_comparison_ends_at_the_most_rays() {
    for words in [
        "compare panes.json --max-rays 1000",
        "compare panes.json 4,4 --max-rays 1000",
    ] {
        let message = endless().run(words).refused();
        let pixel = if words.contains("4,4") { "4,4" } else { "0,0" };
        let expected = format!(
            "error: pixel {pixel} takes more than 1000 rays\n  lower --max-depth, or raise --max-rays\n"
        );
        assert_eq!(message, expected);
    }
}

/// The eye ray through the pane, the ray that it reflects and the one that it transmits: three.
#[test]
fn a_pixel_may_take_just_as_many_rays_as_the_limit_says() {
    // inside the middle pixel, which reaches 0.0298 to each side; its centre is that of the view
    let middle = panes(&[[-0.02, 0.02, -0.02, 0.02, -1.0]], 5);
    middle
        .run("render panes.json -o out.png --max-rays 3")
        .well();
    middle
        .run("trace panes.json -o out.jsonl --max-rays 3")
        .well();
    for verb in [
        "render panes.json -o 2.png",
        "trace panes.json -o 2.jsonl",
        "pixel panes.json 4,4",
    ] {
        let message = middle.run(&format!("{verb} --max-rays 2")).refused();
        assert_data_eq!(
            message,
            str![[r#"
error: pixel 4,4 takes more than 2 rays
  lower --max-depth, or raise --max-rays

"#]]
        );
    }
    assert_eq!(middle.names(), ["out.jsonl", "out.png", "panes.json"]);
}

/// Through the corners there is one more eye ray to the right of the last pixel and below it.
#[test]
fn the_last_corner_is_told_as_the_last_pixel() {
    // around the window's lower right corner, at (0.268, -0.268)
    let corner = panes(&[[0.25, 0.29, -0.29, -0.25, -1.0]], 5);
    corner
        .run("render panes.json -o out.png --max-rays 1")
        .well();
    assert_data_eq!(
        corner
            .run("render panes.json -o 2.png --max-rays 2 --through corners")
            .refused(),
        str![[r#"
error: pixel 8,8 takes more than 2 rays
  lower --max-depth, or raise --max-rays

"#]]
    );
}

/// A transport that stores light first finds out which photons a pixel has gathered.
#[test]
fn the_paths_behind_a_pixel_are_looked_for_within_the_limit() {
    let folder = endless();
    let scene = String::from_utf8(folder.read("panes.json")).unwrap();
    let lit = scene.replace(
        "\"objects\"",
        r#""lights": [{ "name": "lamp", "position": [0, 0, -1.5], "power": 1 }], "objects""#,
    );
    let folder = folder.with("panes.json", lit);
    for verb in ["pixel panes.json 4,4", "trace panes.json --region 4,4"] {
        let words =
            format!("{verb} --transport hybrid-stored --paths 100 --bounces 5 --max-rays 1000");
        let message = folder.run(&words).refused();
        assert!(
            message.ends_with(
                "error: pixel 4,4 takes more than 1000 rays\n  lower --max-depth, or raise --max-rays\n"
            ),
            "{message}"
        );
    }
}

/// Rays that no pixel of its own casts have no limit.
#[test]
fn forward_tracing_has_no_rays_of_a_pixel() {
    assert_data_eq!(
        refuses_in(
            &endless(),
            "render panes.json --transport forward --max-rays 10"
        ),
        str![[r#"
error: --max-rays has no effect with --transport forward
  omit it, or use --transport backward or --transport hybrid-light or --transport hybrid-stored or --transport hybrid-connected

"#]]
    );
}
