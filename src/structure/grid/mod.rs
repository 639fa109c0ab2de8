//! The uniform grid: which objects lie in which cell, and the walk of a ray from cell to cell.

mod bare_grid;
mod cell_lists;
mod cell_overlap;
mod cell_planes;
mod cell_step;
mod cone_overlap;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
mod grid;
mod grid_error;
mod grid_options;
mod grid_resolution;
mod grid_start;
mod grid_walk;
mod ray_order;

pub(crate) use bare_grid::BareGrid;
pub(crate) use cell_planes::CellPlanes;
pub use cell_step::{Across, CellStep};
pub use grid::{AssignStep, Grid, Share};
pub use grid_error::{GridError, MOST_CELLS, MOST_CELLS_ALONG};
pub use grid_options::{GridOptions, Lists};
pub(crate) use grid_start::start;
pub use grid_walk::GridWalk;
pub(crate) use ray_order::{Meeting, just_after};
