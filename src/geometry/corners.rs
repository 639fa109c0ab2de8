//! The corners of a polygon as its tests read them: the projected outline, and beside it the coordinate
//! that the projection drops. Both together are the vertices, bit for bit, so these are not kept twice.
//!
//! A triangle holds its corners itself. A mesh has a million of them, and a list of its own for each
//! would cost memory and a second place to read at every test.

use glam::{DVec2, DVec3};

use crate::geometry::Axis;

/// Outline, dropped coordinates and normals, one of each per vertex.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Corners {
    /// Three, in place.
    Triangle {
        /// The coordinate that the projection drops.
        dropped: Axis,
        /// The vertices without it.
        outline: [DVec2; 3],
        /// It, vertex by vertex.
        heights: [f64; 3],
        /// The unit normals.
        normals: Option<Box<[DVec3; 3]>>,
    },
    /// Any other number, as lists.
    Many {
        /// The coordinate that the projection drops.
        dropped: Axis,
        /// The vertices without it.
        outline: Box<[DVec2]>,
        /// It, vertex by vertex.
        heights: Box<[f64]>,
        /// The unit normals.
        normals: Option<Box<[DVec3]>>,
    },
}

impl Corners {
    /// The corners at these vertices, seen along the dropped axis; `normals` are as many, if there are any.
    pub(super) fn new(vertices: Vec<DVec3>, normals: Option<Box<[DVec3]>>, dropped: Axis) -> Self {
        match <[DVec3; 3]>::try_from(vertices) {
            Ok(vertices) => Self::Triangle {
                dropped,
                outline: vertices.map(|v| dropped.drop_from(v)),
                heights: vertices.map(|v| dropped.of(v)),
                normals: normals.and_then(|normals| normals.try_into().ok()),
            },
            Err(vertices) => Self::Many {
                dropped,
                outline: vertices.iter().map(|&v| dropped.drop_from(v)).collect(),
                heights: vertices.iter().map(|&v| dropped.of(v)).collect(),
                normals,
            },
        }
    }

    #[inline]
    pub(super) fn dropped(&self) -> Axis {
        match self {
            Self::Triangle { dropped, .. } | Self::Many { dropped, .. } => *dropped,
        }
    }

    #[inline]
    pub(super) fn outline(&self) -> &[DVec2] {
        match self {
            Self::Triangle { outline, .. } => outline,
            Self::Many { outline, .. } => outline,
        }
    }

    #[inline]
    pub(super) fn heights(&self) -> &[f64] {
        match self {
            Self::Triangle { heights, .. } => heights,
            Self::Many { heights, .. } => heights,
        }
    }

    pub(super) fn normals(&self) -> Option<&[DVec3]> {
        match self {
            Self::Triangle { normals, .. } => normals.as_deref().map(<[DVec3; 3]>::as_slice),
            Self::Many { normals, .. } => normals.as_deref(),
        }
    }
}
