//! The three builds of a hierarchy. Each decides which nodes there are; their bounds come afterwards, from
//! the bottom up, in `hierarchy`.

mod bottom_up;
mod insertion;
mod solid;
mod surface_area;
mod tree;

pub(super) use bottom_up::bottom_up;
pub(super) use insertion::insertion;
pub(super) use surface_area::surface_area;
