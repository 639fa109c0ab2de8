//! What is built over a scene before any ray is cast: bounds, hierarchies, the grid, and their pure walks.
//!
//! Nothing here records: a structure answers questions and its walks yield steps, and `strategy` asks the
//! questions and notes the steps.

mod bounds;
mod grid;
mod hierarchy;
pub(crate) mod options;
mod point_tree;

pub use bounds::{
    RaySlabs, SlabBound, SlabChoice, SlabSet, SlabStep, SlabVerdict, Volume, VolumeKind, VolumeRay,
    extent, room,
};
pub(crate) use bounds::{inside_ellipsoid, inside_sphere};
pub use grid::{
    Across, AssignStep, CellStep, Grid, GridError, GridOptions, GridWalk, Lists, MOST_CELLS,
    MOST_CELLS_ALONG, Share,
};
pub(crate) use grid::{BareGrid, CellPlanes, Meeting, just_after, start};
pub use hierarchy::{Build, Hierarchy, Link, MergeStep, Node};
pub(crate) use hierarchy::{range, reach};
pub use options::StructureError;
pub(crate) use options::StructureOptions;
pub use point_tree::{Neighbour, Placed, PointTree};
