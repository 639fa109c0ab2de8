//! What is built over a scene before any ray is cast: bounds, hierarchies, the grid, and their pure walks.
//!
//! Nothing here records: a structure answers questions and its walks yield steps, and `strategy` asks the
//! questions and notes the steps.

mod bare_grid;
mod build;
mod cell_lists;
mod cell_overlap;
mod cell_planes;
mod cell_step;
mod cone_overlap;
mod extent;
pub(crate) mod extremes;
mod grid;
mod grid_error;
mod grid_resolution;
mod grid_start;
mod grid_walk;
mod hierarchy;
mod least_ellipsoid;
mod object_bounds;
mod options;
mod point_tree;
mod principal_axes;
mod ray_order;
mod ray_slabs;
mod slab_bound;
mod slab_set;
mod slab_step;
mod smallest_sphere;
mod volume;

pub(crate) use bare_grid::BareGrid;
pub(crate) use cell_planes::CellPlanes;
pub use cell_step::{Across, CellStep};
pub use extent::extent;
pub use grid::{AssignStep, Grid, GridOptions, Lists, Share};
pub use grid_error::{GridError, MOST_CELLS, MOST_CELLS_ALONG};
pub(crate) use grid_start::start;
pub use grid_walk::GridWalk;
pub use hierarchy::{Build, Hierarchy, Link, MergeStep, Node};
pub(crate) use hierarchy::{range, reach};
pub use options::{StructureError, StructureOptions};
pub use point_tree::{Neighbour, Placed, PointTree};
pub(crate) use ray_order::{Meeting, just_after};
pub use ray_slabs::{RaySlabs, room};
pub use slab_bound::SlabBound;
pub use slab_set::{SlabChoice, SlabSet};
pub use slab_step::{Inside, SlabOutcome, SlabStep};
pub use volume::{Volume, VolumeKind, VolumeRay};
pub(crate) use volume::{inside_ellipsoid, inside_sphere};
