//! Hierarchies of bounds: the nodes, the three builds, and the bounds from the bottom up.

mod bottom_up;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
mod hierarchy;
mod insertion;
mod node;
mod surface_area;
mod tree;

pub use hierarchy::{Build, Hierarchy, MergeStep};
pub(crate) use hierarchy::{range, reach};
pub use node::{Link, Node};
