//! Where the walk of a ray through a grid begins.

use std::cmp::Ordering;

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::structure::cell_planes::{CellPlanes, CellsAlong};
use crate::structure::extremes::{larger, smaller};
use crate::structure::ray_order::{Meeting, just_after};

/// The first cell that a ray pierces in its range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// i, j and k.
    pub(super) cell: [usize; 3],
    /// Where the ray enters it, or where its range begins inside it.
    pub(super) t: f64,
}

/// What plain arithmetic says of the first cell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Guess {
    /// About this one.
    Cell(Start),
    /// There is none, for certain.
    PassesBy,
    /// Something is too near to something else.
    Unsure,
}

/// About which cell the ray pierces first. `inverse` is 1/Δ, with all its digits along each axis.
///
/// The grid is a box: the ray comes into it at t₀, the largest near of its three slabs, if that is before the smallest
/// far. Along each axis (x₀ + t₀·Δx − low) times the cells for a unit of length says in which cell it is then.
#[inline]
pub(super) fn guess(cells: &CellPlanes, ray: &Ray, inverse: DVec3, range: TRange) -> Guess {
    let [x, y, z] = cells.along();
    let at_low = (DVec3::new(x.low, y.low, z.low) - ray.origin) * inverse;
    let at_high = (DVec3::new(x.high, y.high, z.high) - ray.origin) * inverse;
    let begin = larger(
        larger(smaller(at_low.x, at_high.x), smaller(at_low.y, at_high.y)),
        larger(smaller(at_low.z, at_high.z), larger(range.min, 0.0)),
    );
    let end = smaller(
        smaller(larger(at_low.x, at_high.x), larger(at_low.y, at_high.y)),
        smaller(larger(at_low.z, at_high.z), range.max),
    );
    if just_after(begin) < end {
        let at = |along: &CellsAlong, origin: f64, direction: f64| {
            // what does not depend on t₀ is at hand before it is
            let per_unit = along.per_unit;
            along.cell_at((origin - along.low) * per_unit + begin * (direction * per_unit))
        };
        let (origin, direction) = (ray.origin, ray.direction);
        Guess::Cell(Start {
            cell: [
                at(x, origin.x, direction.x),
                at(y, origin.y, direction.y),
                at(z, origin.z, direction.z),
            ],
            t: begin,
        })
    } else if just_after(end) < begin {
        Guess::PassesBy
    } else {
        Guess::Unsure
    }
}

/// The first cell, every comparison without rounding.
///
/// It begins at t₀, the largest of `range.min` and of the t at which the ray comes in between the outer
/// planes of each axis. Along an axis in which the ray moves, the first cell is the one whose far plane is the
/// first one met *after* t₀: so a ray that runs down from a plane starts in the cell below, and one that
/// only touches the grid in a point has no first cell. Along an axis in which it does not move, the cell owns
/// its lower plane, and the last cell both.
pub(super) fn exact_start(cells: &CellPlanes, ray: &Ray, range: TRange) -> Option<Start> {
    let mut begin = Meeting::at(range.min.max(0.0));
    for axis in 0..3 {
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        let planes = cells.axis(axis);
        let (low, high) = (planes[0], planes[planes.len() - 1]);
        if direction == 0.0 {
            if !(low <= origin && origin <= high) {
                return None;
            }
            continue;
        }
        let outer = Meeting {
            plane: if 0.0 < direction { low } else { high },
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
    for (axis, of_cell) in cell.iter_mut().enumerate() {
        let place = if ray.direction[axis] == 0.0 {
            standing_cell(cells, axis, ray.origin[axis])
        } else {
            moving_cell(cells, axis, ray, &begin)?
        };
        *of_cell = place;
    }
    Some(Start { cell, t: begin.t() })
}

/// The cell [pᵢ, pᵢ₊₁) that a coordinate between the outer planes lies in; the last one has both its planes.
fn standing_cell(cells: &CellPlanes, axis: usize, x: f64) -> usize {
    let planes = cells.axis(axis);
    let guess = cells.along()[axis].near(x);
    if planes[guess] <= x && x < planes[guess + 1] {
        return guess;
    }
    let below = planes.partition_point(|&plane| plane <= x);
    below.clamp(1, planes.len() - 1) - 1
}

/// The cell along an axis that the ray is in just after `begin`; `None` if it has left the grid by then.
fn moving_cell(cells: &CellPlanes, axis: usize, ray: &Ray, begin: &Meeting) -> Option<usize> {
    let planes = cells.axis(axis);
    let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
    let is_met_after = |plane: f64| {
        let meeting = Meeting {
            plane,
            origin,
            direction,
        };
        meeting.order(begin) == Ordering::Greater
    };
    let cells_along = planes.len() - 1;
    let guess = cells.along()[axis].near(origin + begin.t() * direction);
    // upwards plane i + 1 is the first one met after t₀, and plane i is not; downwards the other way round
    if 0.0 < direction {
        let fits = |i: usize| is_met_after(planes[i + 1]) && (i == 0 || !is_met_after(planes[i]));
        if fits(guess) {
            return Some(guess);
        }
        let met_before = planes.partition_point(|&plane| !is_met_after(plane));
        (met_before <= cells_along).then(|| met_before.max(1) - 1)
    } else {
        let last = cells_along - 1;
        let fits =
            |i: usize| is_met_after(planes[i]) && (i == last || !is_met_after(planes[i + 1]));
        if fits(guess) {
            return Some(guess);
        }
        let met_after = planes.partition_point(|&plane| is_met_after(plane));
        (0 < met_after).then(|| (met_after - 1).min(last))
    }
}
