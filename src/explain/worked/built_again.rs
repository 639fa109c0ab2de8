//! Structures that are built again from the scene in a log, where the log says too little of them.

use std::sync::OnceLock;

use crate::geometry::MOST_SLABS;
use crate::structure::{BareGrid, Hierarchy};

/// What is built again from the scene, once it is asked for.
#[derive(Debug, Default)]
pub(super) struct BuiltAgain {
    /// The hierarchy, where the log says too little of its bounds.
    pub(super) hierarchy: OnceLock<Hierarchy<MOST_SLABS>>,
    /// The grid without room.
    pub(super) grid: OnceLock<BareGrid>,
}
