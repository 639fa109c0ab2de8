//! A grid most of whose objects lie in one cell: its rays are tested against most of the scene.
//!
//! The grid's cells are of one size, and so a large object among small ones makes the cells too large for the small
//! ones (Haines's "teapot in a stadium").

use std::fmt;

use serde_json::{Value, json};

use crate::explain::{cell_name, grouped};
use crate::structure::Grid;

/// The fullest cell of a grid, where it lists most objects of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CrowdedCell {
    /// i, j and k.
    pub cell: [u32; 3],
    /// How many objects the cell lists.
    pub listed: usize,
    /// How many objects the scene has.
    pub objects: usize,
}

/// With fewer objects a grid has so few cells (three to an object) that a full one is no sign of a bad grid.
const MANY: usize = 20;

impl CrowdedCell {
    /// The fullest cell of a grid over a number of objects; `None` if it lists half of them or fewer, or there are fewer
    /// than 20.
    pub fn of(grid: &Grid, objects: usize) -> Option<Self> {
        let (cell, listed) = grid.fullest_cell()?;
        (MANY <= objects && objects < 2 * listed).then_some(Self {
            cell,
            listed,
            objects,
        })
    }

    /// The numbers as JSON.
    pub fn json(&self) -> Value {
        json!({ "cell": self.cell, "listed": self.listed, "objects": self.objects })
    }
}

impl fmt::Display for CrowdedCell {
    /// What is wrong, and what helps.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the grid is crowded: cell {} lists {} of the {} objects, and each ray through it is tested against all \
             of these; the hierarchy adapts to such a scene, a grid needs many more cells",
            cell_name(self.cell),
            grouped(self.listed as u64),
            grouped(self.objects as u64)
        )
    }
}
