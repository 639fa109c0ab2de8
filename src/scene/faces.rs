//! Polygons while they wait between the file and the scene: as little memory for each as their numbers
//! take, because a file may have a million of them.
//!
//! In the file they are lists of points, whatever they are here.

use std::fmt;
use std::ops::Deref;

use serde::de::{Deserialize, Deserializer, SeqAccess, Visitor};
use serde::{Serialize, Serializer};

use crate::scene::file::PolygonFile;

/// The vertices of one polygon. Three of them need no list of their own.
#[derive(Clone, Debug, PartialEq)]
pub enum Points {
    /// Those of a triangle.
    Three([[f64; 3]; 3]),
    /// Any other number.
    Many(Box<[[f64; 3]]>),
}

impl Deref for Points {
    type Target = [[f64; 3]];
    fn deref(&self) -> &Self::Target {
        match self {
            Self::Three(points) => points,
            Self::Many(points) => points,
        }
    }
}

impl From<Vec<[f64; 3]>> for Points {
    fn from(points: Vec<[f64; 3]>) -> Self {
        match points.try_into() {
            Ok(three) => Self::Three(three),
            Err(points) => Self::Many(points.into()),
        }
    }
}

impl Serialize for Points {
    fn serialize<S: Serializer>(&self, output: S) -> Result<S::Ok, S::Error> {
        output.collect_seq(self.iter())
    }
}

impl<'de> Deserialize<'de> for Points {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        Vec::deserialize(input).map(Self::from)
    }
}

/// The faces of a mesh, all their points in two lists.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceList {
    vertices: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    ends: Vec<Ends>,
}

/// Where the points of a face end in the lists; they begin where those of the face before end. Fewer than
/// 2³², which would take 100 GB.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Ends {
    vertices: u32,
    normals: u32,
    has_normals: bool,
}

/// One face of a list.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Face<'a> {
    /// Its vertices, counter-clockwise from the front.
    pub vertices: &'a [[f64; 3]],
    /// One normal per vertex, for smooth shading.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normals: Option<&'a [[f64; 3]]>,
}

impl FaceList {
    /// Adds a face behind the others.
    pub fn push<P: Copy + Into<[f64; 3]>>(&mut self, vertices: &[P], normals: Option<&[P]>) {
        let has_normals = normals.is_some();
        let normals = normals.unwrap_or_default();
        self.vertices.extend(vertices.iter().map(|&p| p.into()));
        self.normals.extend(normals.iter().map(|&n| n.into()));
        self.ends.push(Ends {
            vertices: self.vertices.len() as u32,
            normals: self.normals.len() as u32,
            has_normals,
        });
    }

    /// How many faces there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The faces, in order.
    pub fn iter(&self) -> impl Iterator<Item = Face<'_>> {
        let mut start = Ends::default();
        self.ends.iter().map(move |&end| {
            let vertices = start.vertices as usize..end.vertices as usize;
            let normals = start.normals as usize..end.normals as usize;
            start = end;
            Face {
                vertices: &self.vertices[vertices],
                normals: end.has_normals.then(|| &self.normals[normals]),
            }
        })
    }
}

impl Serialize for FaceList {
    fn serialize<S: Serializer>(&self, output: S) -> Result<S::Ok, S::Error> {
        output.collect_seq(self.iter())
    }
}

impl<'de> Deserialize<'de> for FaceList {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct InOrder;
        impl<'de> Visitor<'de> for InOrder {
            type Value = FaceList;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a sequence")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<FaceList, A::Error> {
                let mut faces = FaceList::default();
                while let Some(face) = list.next_element::<PolygonFile>()? {
                    faces.push(&face.vertices, face.normals.as_deref());
                }
                Ok(faces)
            }
        }
        input.deserialize_seq(InOrder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_come_back_from_json_as_they_were_written() {
        let text = "[{\"vertices\":[[0.0,0.0,0.5],[1.0,0.0,0.0],[-0.0,1.0,0.0]]},\
                    {\"vertices\":[[0.0,0.0,0.0],[1.0,0.0,0.0]],\"normals\":[]},\
                    {\"vertices\":[],\"normals\":[[0.0,0.0,1.0]]}]";
        let faces: FaceList = serde_json::from_str(text).unwrap();
        assert_eq!(serde_json::to_string(&faces).unwrap(), text);
        let counts: Vec<_> = faces
            .iter()
            .map(|face| (face.vertices.len(), face.normals.map(<[_]>::len)))
            .collect();
        assert_eq!(counts, [(3, None), (2, Some(0)), (0, Some(1))]);
    }

    #[test]
    fn a_polygon_that_waits_takes_no_list_for_three_vertices() {
        let points = Points::from(vec![[1.0; 3], [2.0; 3], [3.0; 3]]);
        assert_eq!(points, Points::Three([[1.0; 3], [2.0; 3], [3.0; 3]]));
        let points = Points::from(vec![[1.0; 3]; 4]);
        assert_eq!(points.len(), 4);
        assert!(matches!(points, Points::Many(_)));
    }
}
