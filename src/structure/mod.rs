//! What is built over a scene before any ray is cast: bounds, hierarchies, the grid, and their pure walks.
//!
//! Nothing here records: a structure answers questions and its walks yield steps, and `strategy` asks the
//! questions and notes the steps.

mod build;
mod extent;
mod grid;
mod grid_walk;
mod hierarchy;
mod options;
mod slab_bound;
mod slab_set;
mod volume;

pub use extent::extent;
pub use grid::{AssignStep, GridOptions, Lists, Share};
pub use grid_walk::{Across, CellStep};
pub(crate) use hierarchy::range;
pub use hierarchy::{Build, Hierarchy, Link, MergeStep, Node};
pub use options::{StructureError, StructureOptions};
pub use slab_bound::{Inside, RaySlabs, SlabBound, SlabOutcome, SlabStep};
pub use slab_set::{MOST_SLABS, SlabChoice, SlabSet, SlabSetError};
pub use volume::VolumeKind;
