//! What is built over a scene before any ray is cast: bounds, hierarchies, the grid, and their pure walks.
//!
//! Nothing here records: a structure answers questions and its walks yield steps, and `strategy` asks the
//! questions and notes the steps.

mod axis_walk;
mod build;
mod cell_lists;
mod cell_overlap;
mod cell_planes;
mod cell_step;
mod cone_overlap;
mod extent;
mod extremes;
mod grid;
mod grid_error;
mod grid_resolution;
mod grid_start;
mod grid_walk;
mod hierarchy;
mod least_ellipsoid;
mod object_bounds;
mod one_way;
mod options;
mod point_tree;
mod principal_axes;
mod ray_order;
mod slab_bound;
mod slab_set;
mod smallest_sphere;
mod volume;

pub use cell_step::{Across, CellStep};
pub use extent::extent;
pub use grid::{AssignStep, Grid, GridOptions, Lists, Share};
pub use grid_error::{GridError, MOST_CELLS, MOST_CELLS_ALONG};
pub use grid_walk::GridWalk;
pub use hierarchy::{Build, Hierarchy, Link, MergeStep, Node};
pub(crate) use hierarchy::{range, reach};
pub use options::{StructureError, StructureOptions};
pub use point_tree::{Neighbour, Placed, PointTree};
pub use slab_bound::{Inside, RaySlabs, SlabBound, SlabOutcome, SlabStep};
pub(crate) use slab_bound::{NO_SLAB, crossed};
pub use slab_set::{SlabChoice, SlabSet};
pub use volume::{Volume, VolumeKind, VolumeRay};
