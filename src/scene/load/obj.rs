//! Wavefront OBJ: the vertices, normals and polygons of a mesh.
//!
//! A line is a keyword and what belongs to it; a backslash at its end joins the next line to it. Left
//! out are textures, materials, groups, lines, points and curved surfaces. A face that is not planar
//! becomes a fan of triangles from its first corner, and what has no area is left out: notes say so.

mod framed;

pub(super) use framed::read_obj_scene;

use std::{iter, mem};

use glam::DVec3;

use crate::geometry::{Polygon, PolygonError};
use crate::scene::check::checked_point;
use crate::scene::fault::Fault;
use crate::scene::file::FaceList;
use crate::scene::load::error::{LoadError, Place};
use crate::scene::load::words::{Entity, Word, form_error, lines, numbers_of, words_of};
use crate::scene::{printable, quoted};

/// The faces of an OBJ file.
#[derive(Debug)]
pub(super) struct Faces {
    pub(super) faces: FaceList,
    /// What was left out or mended.
    pub(super) notes: Vec<String>,
}

/// Reads the faces of a mesh.
///
/// # Errors
/// What is not OBJ, with its line; a file without faces.
pub(super) fn read_obj(file: &str, text: &str) -> Result<Faces, LoadError> {
    let mut reader = Reader {
        file,
        ..Reader::default()
    };
    let mut statement = Vec::new();
    for (line, text) in lines(text) {
        let joined = text.trim_end().strip_suffix('\\');
        statement.extend(words_of((line, joined.unwrap_or(text))));
        if joined.is_none() {
            reader.statement(&statement)?;
            statement.clear();
        }
    }
    reader.statement(&statement)?;

    if reader.faces.is_empty() {
        let kind = if reader.flat == 0 {
            ""
        } else {
            " with an area"
        };
        let what = format!("the file has no faces{kind}");
        let fix = "give vertices and at least one face, such as f 1 2 3; lines, points and curved \
                   surfaces are not read";
        return Err(form_error(file, None, what, fix));
    }
    Ok(Faces {
        notes: reader.notes(),
        faces: reader.faces,
    })
}

/// What has been read so far.
#[derive(Default)]
struct Reader<'a> {
    file: &'a str,
    vertices: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    faces: FaceList,
    /// Room for the vertices and the normals of one face.
    corners: (Vec<DVec3>, Vec<DVec3>),
    /// How many faces have no area.
    flat: u64,
    /// How many faces were divided into triangles.
    divided: u64,
    /// How many faces lost their normals.
    bare: u64,
    /// Are there materials?
    materials: bool,
}

const VERTEX: &str = "a vertex is written v x y z";
const TEXTURE: &str = "a texture vertex is written vt u, vt u v or vt u v w";
const NORMAL: &str = "a normal is written vn x y z";
const FACE: &str = "a face is written f and its corners, each a, a/b, a//c or a/b/c: the numbers of a \
                    vertex, a texture vertex and a normal";

/// The keywords that say nothing about the form of a face.
const IGNORED: &str = "o g s mg usemtl mtllib usemap maplib l p vp cstype deg bmat step curv curv2 \
                       surf parm trim hole scrv sp end con bevel c_interp d_interp lod shadow_obj \
                       trace_obj ctech stech call csh bsp bzp cdc cdp res";

impl Reader<'_> {
    fn statement(&mut self, words: &[Word<'_>]) -> Result<(), LoadError> {
        let Some((keyword, rest)) = words.split_first() else {
            return Ok(());
        };
        let line = keyword.line;
        let of = |what, form| Entity::new(what, form, line);
        match keyword.text {
            // behind x y z some programs write a weight, a colour or both
            "v" => self
                .vertices
                .push(self.point(&of("a vertex", VERTEX), rest, 7)?),
            "vn" => self
                .normals
                .push(self.point(&of("a normal", NORMAL), rest, 3)?),
            "vt" => {
                numbers_of(self.file, &of("a texture vertex", TEXTURE), rest, 1..=3)?;
            }
            "f" | "fo" => self.face(line, rest)?,
            known if IGNORED.split(' ').any(|ignored| ignored == known) => {
                self.materials |= known == "usemtl";
            }
            unknown => {
                let what = format!("{} is not a keyword of OBJ", quoted(unknown));
                let fix = "correct it, or put # before the line; a scene is in JSON, NFF or OBJ";
                return Err(form_error(self.file, line, what, fix));
            }
        }
        Ok(())
    }

    /// Three numbers that a scene may contain, among at most `most`.
    fn point(
        &self,
        entity: &Entity,
        words: &[Word<'_>],
        most: usize,
    ) -> Result<[f64; 3], LoadError> {
        let point = numbers_of(self.file, entity, words, 3..=most)?;
        match checked_point("", point) {
            Ok(_) => Ok(point),
            Err(wrong) => Err(self.fault(entity.line, wrong.fault)),
        }
    }

    fn face(&mut self, line: usize, corners: &[Word<'_>]) -> Result<(), LoadError> {
        // taken out and put back: a list of their own for each of a million faces takes time
        let (mut vertices, mut normals) = mem::take(&mut self.corners);
        vertices.clear();
        normals.clear();
        for &corner in corners {
            let mut numbers = corner.text.splitn(3, '/');
            let vertex = numbers.next().unwrap_or_default();
            vertices.push(self.listed(corner, vertex, "vertex", &self.vertices)?);
            if let Some(texture) = numbers.next().filter(|texture| !texture.is_empty()) {
                self.index(corner, texture)?;
            }
            if let Some(normal) = numbers.next() {
                normals.push(self.listed(corner, normal, "normal", &self.normals)?);
            }
        }
        if !normals.is_empty() && normals.len() != vertices.len() {
            let (some, all) = (normals.len(), vertices.len());
            let what = format!("{some} of the {all} corners of the face have a normal");
            let fix = "give every corner a normal (a//c or a/b/c), or none";
            return Err(form_error(self.file, line, what, fix));
        }
        if normals
            .iter()
            .any(|normal| normal.try_normalize().is_none())
        {
            self.bare += 1;
            normals.clear();
        }
        self.add(&vertices, &normals)
            .map_err(|error| self.fault(line, Fault::Polygon(error)))?;
        self.corners = (vertices, normals);
        Ok(())
    }

    /// Keeps a face, divides it or leaves it out.
    fn add(&mut self, vertices: &[DVec3], normals: &[DVec3]) -> Result<(), PolygonError> {
        match Polygon::plane_of(vertices) {
            Ok(_) => {
                let smooth = (!normals.is_empty()).then_some(normals);
                self.faces.push(vertices, smooth);
            }
            Err(PolygonError::NotPlanar { .. }) if 3 < vertices.len() => {
                self.divided += 1;
                for (triangle, normals) in
                    fan(vertices).zip(fan(normals).chain(iter::repeat(Vec::new())))
                {
                    self.add(&triangle, &normals)?;
                }
            }
            // a triangle is off its own plane only by rounding, if its corners are almost on one line
            Err(PolygonError::NoArea | PolygonError::NotPlanar { .. }) => self.flat += 1,
            Err(error) => return Err(error),
        }
        Ok(())
    }

    /// The entry of a list that a number in a corner names: from 1 on, or from -1 backwards.
    fn listed(
        &self,
        corner: Word<'_>,
        number: &str,
        what: &str,
        list: &[[f64; 3]],
    ) -> Result<DVec3, LoadError> {
        let number = self.index(corner, number)?;
        let index = match usize::try_from(number) {
            Ok(from_start) => from_start.checked_sub(1),
            Err(_) => list.len().checked_sub(number.unsigned_abs() as usize),
        };
        let entry = index.and_then(|index| list.get(index));
        entry.map(|&entry| entry.into()).ok_or_else(|| {
            let n = list.len();
            let fix = if n == 0 {
                format!("put each {what} before the faces that use it")
            } else {
                format!("give a number from 1 to {n}, or from -1, the last, to -{n}")
            };
            let what = format!("there is no {what} {number}: so far there are {n}");
            form_error(self.file, corner.line, what, fix)
        })
    }

    fn index(&self, corner: Word<'_>, number: &str) -> Result<i64, LoadError> {
        number.parse().map_err(|_| {
            let what = format!("{} is not a corner of a face", quoted(corner.text));
            form_error(self.file, corner.line, what, FACE)
        })
    }

    fn fault(&self, line: usize, fault: Fault) -> LoadError {
        let place = Place {
            file: self.file.into(),
            line: Some(line),
            path: String::new(),
        };
        LoadError::Fault { place, fault }
    }

    fn notes(&self) -> Vec<String> {
        let file = printable(self.file);
        let mut notes = Vec::new();
        for (n, what) in [
            (self.divided, "is not planar and was cut into triangles"),
            (self.flat, "has no area and was ignored"),
            (self.bare, "has a normal of length 0 and is shaded flat"),
        ] {
            let many = what.replace("is ", "are ").replace("has ", "have ");
            match n {
                0 => {}
                1 => notes.push(format!("{file}: 1 face {what}")),
                _ => notes.push(format!(
                    "{file}: {n} faces {}",
                    many.replace("was ", "were ")
                )),
            }
        }
        if self.materials {
            notes.push(format!("{file}: its materials are not read"));
        }
        notes
    }
}

/// The triangles from the first corner; none of fewer than three.
fn fan(points: &[DVec3]) -> impl Iterator<Item = Vec<DVec3>> {
    let rest = points.get(1..).unwrap_or_default();
    let first = points.first();
    rest.windows(2)
        .map(move |edge| first.into_iter().chain(edge).copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The unit square in z = 0, its normal, and a corner lifted by 1.
    const SQUARE: &str = "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0\nvn 0 0 2\nv 0 1 1\nvn 0 0 0\n";

    /// The vertices of the faces that lines after the square make, and the notes.
    #[track_caller]
    fn faces(lines: &str) -> (Vec<Vec<[f64; 3]>>, Vec<String>) {
        let read = read_obj("m.obj", &format!("{SQUARE}{lines}")).unwrap();
        let faces = read.faces.iter().map(|face| face.vertices.to_vec());
        (faces.collect(), read.notes)
    }

    #[track_caller]
    fn refused(lines: &str, message: &str) {
        let error = read_obj("m.obj", &format!("{SQUARE}{lines}")).map(|_| ());
        let error = error.unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}\n{message}");
    }

    const O: [f64; 3] = [0.0; 3];
    const X: [f64; 3] = [1.0, 0.0, 0.0];
    const XY: [f64; 3] = [1.0, 1.0, 0.0];
    const YZ: [f64; 3] = [0.0, 1.0, 1.0];

    #[test]
    fn corners_are_counted_from_either_end_and_lines_may_be_joined() {
        for line in [
            "f 1 2 3",
            "f -5 -4 -3",
            "g a\nfo 1/9 2/ 3/-1 # f 9",
            "f 1/1/1 2//-2 3//1",
            "f 1 \\\n2\\ # on\n\\\n3",
        ] {
            assert_eq!(faces(line), (vec![vec![O, X, XY]], vec![]), "{line}");
        }
    }

    #[test]
    fn a_bent_face_becomes_a_fan_and_what_has_no_area_is_left_out() {
        let (fan, notes) = faces("f 1 2 3 5\nf 1 2 1\nf 2 2 2 2\nusemtl a\nusemtl b");
        assert_eq!(fan, [[O, X, XY], [O, XY, YZ]]);
        assert_eq!(
            notes,
            [
                "m.obj: 1 face is not planar and was cut into triangles",
                "m.obj: 2 faces have no area and were ignored",
                "m.obj: its materials are not read"
            ]
        );
    }

    #[test]
    fn normals_are_kept_unless_one_has_no_length() {
        let read = read_obj(
            "m.obj",
            &format!("{SQUARE}f 1//1 2//1 3//1\nf 1//1 2//1 3//2"),
        )
        .unwrap();
        let normals: Vec<_> = read.faces.iter().map(|face| face.normals).collect();
        assert_eq!(normals, [Some(&[[0.0, 0.0, 2.0]; 3][..]), None]);
        let note = "m.obj: 1 face has a normal of length 0 and is shaded flat";
        assert_eq!(read.notes, [note]);
    }

    #[test]
    fn mistakes_are_told_with_their_line_and_what_to_do() {
        for row in [
            "f 1 2 6 => there is no vertex 6: so far there are 5\n  give a number from 1 to 5, or",
            "f 0 1 2 => there is no vertex 0: so far there are 5",
            "f -6 1 2 => there is no vertex -6",
            "f -9223372036854775808 1 2 => there is no vertex -9223372036854775808",
            "f 1//3 2//1 3//1 => there is no normal 3: so far there are 2",
            "f 1//1 2 3 => 1 of the 3 corners of the face have a normal\n  give every corner",
            "f 1 2 => a polygon needs at least 3 vertices, here are 2",
            "f 1 2 3.5 => \"3.5\" is not a corner of a face\n  a face is written f and",
            "f 1/2/ 2 3 => \"1/2/\" is not a corner of a face",
            "v 1 2 => a vertex has 3 to 7 numbers, and there are 2\n  a vertex is written v x y z",
            "v 1 2 1e60 => 1e60 is too large\n  keep every number within ±1e50",
            "vt nan => \"nan\" is not a finite number",
            "vertex 1 => \"vertex\" is not a keyword of OBJ\n  correct it",
        ] {
            let (lines, message) = row.split_once(" => ").unwrap();
            refused(lines, &format!("m.obj, line 8: {message}"));
        }
        refused(
            "f 1 2 1",
            "m.obj: the file has no faces with an area\n  give vertices",
        );
        refused(
            "",
            "m.obj: the file has no faces\n  give vertices and at least one face",
        );
    }
}
