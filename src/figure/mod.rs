//! Drawings: bars of costs as SVG, heat maps as pixels.
//!
//! What is drawn comes from counts and numbers; nothing here traces. `canvas` alone names the crate `svg`.

mod canvas;
mod cost_chart;
mod heat_map;

pub use cost_chart::cost_chart;
pub use heat_map::{Raster, heat_map};
