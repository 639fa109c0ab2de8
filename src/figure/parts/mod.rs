//! What several kinds of figure draw: outlines of objects, axes, bounds, grids, paths of light, angles.

pub(in crate::figure) mod angle;
pub(in crate::figure) mod axes;
pub(in crate::figure) mod bound;
pub(in crate::figure) mod depth;
pub(in crate::figure) mod disc;
pub(in crate::figure) mod gathering;
pub(in crate::figure) mod hatch;
pub(in crate::figure) mod light_path;
pub(in crate::figure) mod named_lines;
pub(in crate::figure) mod outline;
pub(in crate::figure) mod parabola;
pub(in crate::figure) mod percent;
pub(in crate::figure) mod picture;
pub(in crate::figure) mod plan;
pub(in crate::figure) mod right_angle;
pub(in crate::figure) mod scale_bar;
pub(in crate::figure) mod scenery;
pub(in crate::figure) mod slab_rows;
pub(in crate::figure) mod surface;
pub(in crate::figure) mod ticks;
pub(in crate::figure) mod transport_name;
pub(in crate::figure) mod tree;
pub(in crate::figure) mod turn;
pub(in crate::figure) mod visits;
pub(in crate::figure) mod volume_outline;
pub(in crate::figure) mod walk;
