//! Lesson 12: the uniform grid.
//!
//! - building: each object is put on the lists of the cells that its box touches
//! - grid: the cell in which a point lies
//! - next planes: the t of the next plane along each axis
//! - cell: the one that comes next
//! - hit outside the cell: is kept, but does not end the walk
//! - end of the traversal: a hit in the cell, or the end of the grid
//! - nearest hit: of all objects on the lists of the cells that were visited
//!
//! A grid is a box `around` with `resolution` [nx, ny, nz] equal cells. Vectors and cells are indexed by the axis: `v[0]` is x.

use glam::DVec3;
use raystep::geometry::{AxisBox, Ray};
use raystep::lesson::exercise::supplied::Cells;

/// The first and the last cell that the box of an object touches, along each axis; at most those of the grid.
///
/// No face of an object lies on a plane between cells.
pub fn object_to_cells(around: &AxisBox, resolution: [u32; 3], object: &AxisBox) -> [[u32; 3]; 2] {
    todo!()
}

/// The cell that a point of the grid lies in: a cell owns its lower faces, and the last cell its upper face as well.
///
/// `x as u32` cuts off the digits behind the point, and makes 0 of a negative number.
pub fn cell_of(around: &AxisBox, resolution: [u32; 3], point: DVec3) -> [u32; 3] {
    todo!()
}

/// For each axis: the t at which the ray reaches the next plane from a cell, and Δt from there to the plane after it.
///
/// Cell i lies between plane i and plane i + 1. Both numbers are `f64::INFINITY` along an axis in which the ray does not move.
pub fn first_planes(
    around: &AxisBox,
    resolution: [u32; 3],
    ray: &Ray,
    cell: [u32; 3],
) -> [[f64; 2]; 3] {
    todo!()
}

/// The cell behind the plane that is reached first; None if that is outside of the grid.
///
/// `next` has the t of the next plane along each axis. No two of the smallest are equal.
pub fn next_cell(
    cell: [u32; 3],
    next: [f64; 3],
    direction: DVec3,
    resolution: [u32; 3],
) -> Option<[u32; 3]> {
    todo!()
}

/// May the walk end after a cell? `nearest` is t of the nearest hit so far, ∞ if there is none; the ray leaves the cell at `t_out`.
pub fn walk_ends(nearest: f64, t_out: f64) -> bool {
    todo!()
}

/// The walk through the grid, to the nearest object by its number, and its t.
///
/// `cells.first(ray)` is the first cell, or None. `cells.visit(cell, ray)` gives (object, t) of the objects on the cell's list that
/// the ray hits; t may lie beyond the cell. `cells.planes(axis)` are the planes across an axis. Call `visit` once for each cell
/// that the ray passes, in order.
pub fn walk(cells: &Cells<'_>, ray: &Ray) -> Option<(usize, f64)> {
    todo!()
}
