//! Arguments that make no sense for the scene, or at all.

use snapbox::{assert_data_eq, str};

use super::refuses_in;
use crate::cli::run::Folder;

/// What the command says to these words in a folder with the scene of the design.
#[track_caller]
fn refuses(words: &str) -> String {
    let folder = Folder::with_scene();
    let message = folder.run(words).refused();
    assert_eq!(folder.names(), ["scene.json"], "a file was left behind");
    message
}

/// The same for verbs with an output.
#[track_caller]
fn refuses_output(words: &str) -> String {
    refuses_in(&Folder::with_scene(), words)
}

#[test]
fn a_pixel_beyond_the_picture_is_told_with_the_ranges() {
    assert_data_eq!(
        refuses("pixel scene.json 160,0"),
        str![[r#"
error: the picture has no pixel 160,0
  columns go from 0 to 159 and rows from 0 to 119

"#]]
    );
}

#[test]
fn a_pixel_beyond_every_picture_is_told_as_it_was_given() {
    assert_data_eq!(
        refuses("pixel scene.json 5000000000,7"),
        str![[r#"
error: the picture has no pixel 5000000000,7
  columns go from 0 to 159 and rows from 0 to 119

"#]]
    );
}

#[test]
fn a_negative_pixel_is_told() {
    assert_data_eq!(
        refuses("pixel scene.json -1,2"),
        str![[r#"
error: -1,2: no number of this command is negative; pixels count from 0,0 at the top left
  if it is a file, write ./-1,2

"#]]
    );
}

#[test]
fn a_pixel_without_a_row_is_told() {
    assert_data_eq!(
        refuses("pixel scene.json 80"),
        str![[r#"
error: invalid value '80' for '<X,Y>': give column and row, as in 80,60

For more information, try '--help'.

"#]]
    );
}

#[test]
fn a_ray_that_does_not_exist_is_told_with_those_that_do() {
    assert_data_eq!(
        refuses("pixel scene.json 0,0 --ray 7"),
        str![[r#"
error: the pixel has no ray 7
  choose one from 0 to 0

"#]]
    );
}

#[test]
fn an_unknown_kind_is_told_with_the_nearest() {
    assert_data_eq!(
        refuses("pixel scene.json 80,60 --only sphere_tets"),
        str![[r#"
error: invalid value 'sphere_tets' for '--only <KINDS>': there is no such kind; did you mean sphere_test?

For more information, try '--help'.

"#]]
    );
}

#[test]
fn a_kind_like_none_is_told_with_all() {
    assert_data_eq!(
        refuses("trace scene.json --only xyz"),
        str![[r#"
error: invalid value 'xyz' for '--only <KINDS>': there is no such kind; the kinds are merge, assign, path, pixel, ray, align, grid_enter, queue, slab_ray, slab_test, bound_test, node, cell, listed, mailbox, aligned, sphere_test, ellipsoid_test, cone_test, box_test, plane_test, edge, polygon_test, nearest, hit_outside_cell, grid_exit, z_sort, arrival, stored, nearby, gathered, light_term, refraction, photon, alternative, connection, shade, ray_end, pixel_colour

For more information, try '--help'.

"#]]
    );
}

#[test]
fn statistics_and_the_working_do_not_mix() {
    assert_data_eq!(
        refuses("pixel scene.json 80,60 --stats=json"),
        str![[r#"
error: --stats=json and the command itself cannot both write to standard output
  use --stats, which writes to standard error

"#]]
    );
}

#[test]
fn statistics_and_the_log_do_not_mix() {
    assert_data_eq!(
        refuses("trace scene.json --stats=json"),
        str![[r#"
error: --stats=json and the command itself cannot both write to standard output
  name a file with -o, or use --stats, which writes to standard error

"#]]
    );
}

#[test]
fn an_unknown_option_is_told_with_the_nearest() {
    assert_data_eq!(
        refuses("pixel scene.json 80,60 --onyl ray"),
        str![[r#"
error: unexpected argument '--onyl' found

  tip: a similar argument exists: '--only'

Usage: raystep pixel --only <KINDS> <SCENE> <X,Y>

For more information, try '--help'.

"#]]
    );
}

#[test]
fn zero_pixels_are_told() {
    assert_data_eq!(
        refuses_output("render scene.json --pixels 0,10"),
        str![[r#"
error: --pixels: a picture of 0 × 10 pixels cannot be made
  give a width and a height of at least 1, and at most 100000000 pixels in all

"#]]
    );
}

#[test]
fn a_million_times_a_million_pixels_are_told() {
    assert_data_eq!(
        refuses_output("render scene.json --pixels 1000000,1000000"),
        str![[r#"
error: --pixels: a picture of 1000000 × 1000000 pixels cannot be made
  give a width and a height of at least 1, and at most 100000000 pixels in all

"#]]
    );
}

#[test]
fn negative_pixels_are_told() {
    assert_data_eq!(
        refuses_output("render scene.json --pixels -3,4"),
        str![[r#"
error: -3,4: no number of this command is negative; pixels count from 0,0 at the top left
  if it is a file, write ./-3,4

"#]]
    );
}

#[test]
fn a_depth_of_zero_is_told() {
    assert_data_eq!(
        refuses_output("render scene.json --max-depth 0"),
        str![[r#"
error: --max-depth: the depth limit is 0
  give a depth from 1 (eye rays only) to 100

"#]]
    );
}

#[test]
fn no_threads_are_told() {
    assert_data_eq!(
        refuses_output("render scene.json --threads 0"),
        str![[r#"
error: invalid value '0' for '--threads <N>': 0 is not in 1..=1024

For more information, try '--help'.

"#]]
    );
}

#[test]
fn a_region_beyond_the_picture_is_told_with_the_ranges() {
    assert_data_eq!(
        refuses_output("trace scene.json --region 100,100-160,119"),
        str![[r#"
error: the picture does not contain the region 100,100-160,119
  columns go from 0 to 159 and rows from 0 to 119

"#]]
    );
}

#[test]
fn a_region_backwards_is_told() {
    assert_data_eq!(
        refuses_output("trace scene.json --region 5,5-4,6"),
        str![[r#"
error: invalid value '5,5-4,6' for '--region <X0,Y0-X1,Y1>': the second corner is above or left of the first

For more information, try '--help'.

"#]]
    );
}

#[test]
fn a_spent_budget_leaves_no_file() {
    assert_data_eq!(
        refuses_output("trace scene.json --budget 1000"),
        str![[r#"
error: the budget of 1000 events is used up
  narrow the trace with --region or --only, lower --max-depth, or raise --budget

"#]]
    );
}

#[test]
fn json_is_not_written_under_the_ending_of_another_format() {
    assert_data_eq!(
        refuses("convert scene.json scene.nff"),
        str![[r#"
error: scene.nff: convert writes JSON, and this file name has the ending of another format
  name a file that ends in .json

"#]]
    );
}

#[test]
fn a_name_cannot_control_the_terminal() {
    let folder = Folder::empty().with("scene.json", "{ \"cam\\u001b[31mera\": 1 }");
    let message = folder.run("pixel scene.json 0,0").refused();
    assert!(!message.contains('\u{1b}'), "{message:?}");
    assert!(message.contains("cam\\u{1b}[31mera"), "{message:?}");
}
