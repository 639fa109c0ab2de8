//! The events of the search for what a ray meets: bounds, nodes, cells, alignment.
//!
//! The steps that a structure's walk yields are wrapped as they are; what a strategy decides is defined here.

use glam::DVec3;

use crate::geometry::TRange;
use crate::scene::PrimitiveId;
use crate::structure::{SlabStep, VolumeKind};
use crate::trace::{AlignedPart, NodeOutcome, QueueAction, WalkEnd};

/// What a bounding volume is around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounded {
    /// An object of the scene, by its place in [`Scene::objects`](crate::scene::Scene::objects).
    Object(u32),
    /// A node of the hierarchy, by its number; the root is 0.
    Node(u32),
}

impl Default for Bounded {
    fn default() -> Self {
        Self::Node(0)
    }
}

/// What a ray does to a bounding volume.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundOutcome {
    /// It meets it where it counts: what is inside is looked at.
    Hit,
    /// It passes by.
    #[default]
    Missed,
    /// The volume lies behind the origin.
    Behind,
    /// The volume begins behind the nearest hit so far, or behind the light.
    Beyond,
}

impl BoundOutcome {
    /// What follows from where a ray is inside a volume, and from which t count. Equality counts.
    pub(crate) fn of(inside: Option<[f64; 2]>, range: TRange) -> Self {
        match inside {
            None => Self::Missed,
            Some([_, far]) if far < range.min => Self::Behind,
            Some([near, _]) if range.max < near => Self::Beyond,
            Some(_) => Self::Hit,
        }
    }
}

/// A ray was tested against a bounding volume.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundTest {
    /// What the volume is around.
    pub of: Bounded,
    /// Its form.
    pub volume: VolumeKind,
    /// Where the ray enters it and leaves it; `None` if it passes by.
    pub inside: Option<[f64; 2]>,
    /// What follows from that.
    pub outcome: BoundOutcome,
}

/// A ray was tested against one slab of a bound.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlabTest {
    /// What the bound is around.
    pub of: Bounded,
    /// The working.
    pub step: SlabStep,
}

/// A node of the hierarchy was come to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NodeVisit {
    /// Its number; the root is 0.
    pub node: u32,
    /// How deep it lies; the root at 0.
    pub depth: u32,
    /// How many nodes are directly below it.
    pub children: u32,
    /// How many objects are, in a leaf.
    pub objects: u32,
    /// Where the ray enters its bound, if it does.
    pub near: Option<f64>,
    /// What became of it.
    pub outcome: NodeOutcome,
}

/// The heap of the nodes that wait, the nearest at its top.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QueueStep {
    /// What was done.
    pub action: QueueAction,
    /// The node.
    pub node: u32,
    /// Where the ray enters its bound: the estimated distance.
    pub key: f64,
    /// How many nodes wait afterwards.
    pub size: u32,
}

/// A ray comes to the grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GridEnter {
    /// The smallest coordinates of the scene's box.
    pub min: DVec3,
    /// The largest.
    pub max: DVec3,
    /// Cells along x, y and z.
    pub resolution: [u32; 3],
    /// Where the ray is inside the box; `None` if it passes by.
    pub inside: Option<[f64; 2]>,
    /// The first cell; `None` if no cell is pierced in the ray's range.
    pub cell: Option<[u32; 3]>,
}

/// A cell's list is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CellVisit {
    /// Where the ray is in it and goes next.
    pub step: crate::structure::CellStep,
    /// How many objects are on its list.
    pub listed: u32,
}

/// A hit lies beyond the cell whose list the object was on: it is kept, and the walk goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HitOutsideCell {
    /// What was hit.
    pub object: PrimitiveId,
    /// Where.
    pub t: f64,
    /// Where the ray leaves the cell.
    pub t_out: f64,
}

/// The walk through the grid ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GridExit {
    /// Why.
    pub end: WalkEnd,
    /// How many cells were visited.
    pub cells: u32,
}

/// A point of an object in the frame in which the ray is the z axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Aligned {
    /// The object.
    pub object: PrimitiveId,
    /// What the point is of it.
    pub part: AlignedPart,
    /// Which of several, from 0.
    pub index: u32,
    /// The point before.
    pub from: DVec3,
    /// The point after.
    pub to: DVec3,
}

/// A hit in its place in the z sort.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ZSort {
    /// Its place, from 0: the nearest.
    pub place: u32,
    /// What was hit.
    pub object: PrimitiveId,
    /// Where: its z, which is the ray's t.
    pub z: f64,
}
