//! Where the walk of a ray through a grid begins, every comparison without rounding.

use crate::geometry::{Ray, TRange};
use crate::structure::grid::cell_planes::CellPlanes;
use crate::structure::grid::ray_order::Meeting;

/// The first cell that a ray pierces in its range, and the t at which the ray enters it or its range begins inside;
/// `None` if it pierces none.
///
/// It begins at t₀, the largest of `range.min` and of the t at which the ray comes in between the outer
/// planes of each axis. Along an axis in which the ray moves, the first cell is the one whose far plane is the
/// first one met *after* t₀: so a ray that runs down from a plane starts in the cell below, and one that
/// only touches the grid in a point has no first cell. Along an axis in which it does not move, the cell owns
/// its lower plane, and the last cell both.
pub(crate) fn start(cells: &CellPlanes, ray: &Ray, range: TRange) -> Option<([u32; 3], f64)> {
    if cells.is_empty() {
        return None;
    }
    let mut begin = Meeting::at(range.min.max(0.0));
    for axis in 0..3 {
        let [first, .., last] = *cells.axis(axis) else {
            return None;
        };
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        if direction == 0.0 {
            if !(first <= origin && origin <= last) {
                return None;
            }
            continue;
        }
        let outer = Meeting {
            plane: if direction < 0.0 { last } else { first },
            origin,
            direction,
        };
        if begin.before(&outer) {
            begin = outer;
        }
    }
    // an infinite t has no exact value, and needs none
    let ends = range.max < f64::INFINITY && !begin.before(&Meeting::at(range.max));
    if ends || !begin.t().is_finite() {
        return None;
    }

    let mut cell = [0; 3];
    for (axis, cell) in cell.iter_mut().enumerate() {
        let planes = cells.axis(axis);
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        *cell = if direction == 0.0 {
            standing_cell(planes, origin)
        } else {
            moving_cell(planes, origin, direction, &begin)?
        } as u32;
    }
    Some((cell, begin.t()))
}

/// The cell [pᵢ, pᵢ₊₁) that a coordinate between the outer planes lies in; the last one has both its planes.
fn standing_cell(planes: &[f64], x: f64) -> usize {
    let below = planes.partition_point(|&plane| plane <= x);
    below.clamp(1, planes.len() - 1) - 1
}

/// The cell along an axis that the ray is in just after `begin`; `None` if it has left the grid by then.
fn moving_cell(planes: &[f64], origin: f64, direction: f64, begin: &Meeting) -> Option<usize> {
    let is_met_after = |plane: f64| {
        let meeting = Meeting {
            plane,
            origin,
            direction,
        };
        begin.before(&meeting)
    };
    let last = planes.len() - 1;
    if direction < 0.0 {
        // downwards: the planes that are still ahead are the lowest ones
        let ahead = planes[..last].partition_point(|&plane| is_met_after(plane));
        ahead.checked_sub(1)
    } else {
        let behind = planes[1..].partition_point(|&plane| !is_met_after(plane));
        (behind < last).then_some(behind)
    }
}
