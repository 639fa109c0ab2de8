//! NFF and OBJ files that are missing, binary, cut off or wrong: told by line.

use snapbox::{assert_data_eq, str};

use super::{refuses, refuses_in};
use crate::cli::run::Folder;

const NFF: &str = include_str!("../cli/two-balls.nff");
const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The file up to where this text ends.
#[track_caller]
fn up_to<'a>(whole: &'a str, end: &str) -> &'a str {
    let at = whole.find(end).expect("the text is in the file");
    &whole[..at + end.len()]
}

#[test]
fn a_missing_nff_file_is_told() {
    assert_data_eq!(
        refuses_in(&Folder::empty(), "render none.nff"),
        str![[r#"
error: none.nff: cannot be read: No such file or directory (os error 2)
  check the name and the folder

"#]]
    );
}

#[test]
fn a_missing_obj_file_is_told() {
    assert_data_eq!(
        refuses_in(&Folder::empty(), "render none.obj"),
        str![[r#"
error: none.obj: cannot be read: No such file or directory (os error 2)
  check the name and the folder

"#]]
    );
}

#[test]
fn a_folder_is_no_scene() {
    assert_data_eq!(
        refuses_in(&Folder::with_scene(), "render ."),
        str![[r#"
error: .: cannot be read: Is a directory (os error 21)
  name a file inside the folder

"#]]
    );
}

#[test]
fn a_binary_nff_file_is_told() {
    assert_data_eq!(
        refuses("a.nff", b"v\nfrom 0 \xff\xfe\0\n"),
        str![[r#"
error: a.nff, line 2: this is not a text file
  give a scene in JSON, NFF or OBJ

"#]]
    );
}

#[test]
fn a_binary_obj_file_is_told() {
    assert_data_eq!(
        refuses("a.obj", b"v 0 0 0\nv 1 0 0\n\0\0\0"),
        str![[r#"
error: a.obj, line 3: this is not a text file
  give a scene in JSON, NFF or OBJ

"#]]
    );
}

#[test]
fn an_empty_nff_file_is_told() {
    assert_data_eq!(
        refuses("a.nff", ""),
        str![[r#"
error: a.nff: the file has no view
  a view is written v, then from x y z, at x y z, up x y z, angle a, hither h and resolution w h

"#]]
    );
}

#[test]
fn an_empty_obj_file_is_told() {
    assert_data_eq!(
        refuses("a.obj", ""),
        str![[r#"
error: a.obj: the file has no faces
  give vertices and at least one face, such as f 1 2 3; lines, points and curved surfaces are not read

"#]]
    );
}

#[test]
fn an_nff_file_cut_off_in_a_polygon_is_told_by_line() {
    assert_data_eq!(
        refuses("a.nff", up_to(NFF, "5 -5 0")),
        str![[r#"
error: a.nff, line 14: the file ends inside the polygon that begins in line 13: 9 numbers are missing
  add the rest; a polygon is written p n, then n times x y z

"#]]
    );
}

#[test]
fn an_nff_file_cut_off_in_a_sphere_is_told_by_line() {
    assert_data_eq!(
        refuses("a.nff", up_to(NFF, "s -1 0")),
        str![[r#"
error: a.nff, line 19: the file ends inside the sphere that begins in line 19: 2 numbers are missing
  add the rest; a sphere is written s x y z r

"#]]
    );
}

#[test]
fn an_nff_file_cut_off_in_its_view_is_told_by_line() {
    assert_data_eq!(
        refuses("a.nff", up_to(NFF, "up 0 0 1")),
        str![[r#"
error: a.nff, line 2: the view has no "angle"
  a view is written v, then from x y z, at x y z, up x y z, angle a, hither h and resolution w h

"#]]
    );
}

#[test]
fn an_unknown_entity_in_nff_is_told_by_line() {
    assert_data_eq!(
        refuses("a.nff", NFF.replace("s 1.25", "t 1.25")),
        str![[r#"
error: a.nff, line 21: "t" is not an entity of NFF
  begin an entity with v, b, l, f, s, p, pp or c, and a comment with #

"#]]
    );
}

#[test]
fn a_word_for_a_number_in_nff_is_told_by_line() {
    assert_data_eq!(
        refuses("a.nff", NFF.replace("s 1.25", "s one")),
        str![[r#"
error: a.nff, line 21: "one" is not a number, and the sphere of line 21 needs 4 numbers more
  a sphere is written s x y z r

"#]]
    );
}

#[test]
fn a_radius_of_zero_in_nff_is_told_by_line() {
    assert_data_eq!(
        refuses("a.nff", NFF.replace("s -1 0 1 1", "s -1 0 1 0")),
        str![[r#"
error: a.nff, line 19, at objects[1].shape.sphere.radius: the radius is 0, and must be above 0
  give a value of at least 1e-50

"#]]
    );
}

#[test]
fn an_obj_file_cut_off_in_a_vertex_is_told_by_line() {
    assert_data_eq!(
        refuses("a.obj", up_to(OBJ, "v 0 1")),
        str![[r#"
error: a.obj, line 3: a vertex has 3 to 7 numbers, and there are 2
  a vertex is written v x y z

"#]]
    );
}

#[test]
fn an_obj_file_cut_off_in_a_face_is_told_by_line() {
    assert_data_eq!(
        refuses("a.obj", up_to(OBJ, "f 1 2")),
        str![[r#"
error: a.obj, line 4: a polygon needs at least 3 vertices, here are 2
  list the corners in order around the polygon

"#]]
    );
}

#[test]
fn an_obj_face_with_a_vertex_that_does_not_exist_is_told_by_line() {
    assert_data_eq!(
        refuses("a.obj", OBJ.replace("f 1 2 3", "f 1 2 4")),
        str![[r#"
error: a.obj, line 4: there is no vertex 4: so far there are 3
  give a number from 1 to 3, or from -1, the last, to -3

"#]]
    );
}

#[test]
fn a_number_beyond_f64_in_obj_is_told_by_line() {
    assert_data_eq!(
        refuses("a.obj", OBJ.replace("v 1 0 0", "v 1e400 0 0")),
        str![[r#"
error: a.obj, line 2: "1e400" is not a finite number
  give a number within ±1e50

"#]]
    );
}
