//! Where the walk of a ray through a grid begins.

use std::cmp::Ordering;

use crate::geometry::{Ray, TRange};
use crate::structure::cell_planes::CellPlanes;
use crate::structure::ray_order::{Meeting, clearly_before};

/// The first cell that a ray pierces in its range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// i, j and k.
    pub(super) cell: [u32; 3],
    /// Where the ray enters it, or where its range begins inside it.
    pub(super) t: f64,
}

/// Which cell does the ray pierce first, within its range? `None` if it pierces none.
///
/// It begins at t₀, the largest of `range.min` and of the t at which the ray comes in between the outer
/// planes of each axis. Along an axis in which the ray moves, the first cell is the one whose far plane is the
/// first one met *after* t₀: so a ray that runs down from a plane starts in the cell below, and one that
/// only touches the grid in a point has no first cell. Along an axis in which it does not move, the cell owns
/// its lower plane, and the last cell both.
///
/// `inverse` is 1/Δ along each axis, or no number.
#[inline]
pub(super) fn start(
    cells: &CellPlanes,
    ray: &Ray,
    inverse: [f64; 3],
    range: TRange,
) -> Option<Start> {
    if cells.count() == 0 {
        return None;
    }
    match plain_start(cells, ray, inverse, range) {
        Plain::Cell(start) => Some(start),
        Plain::PassesBy => None,
        Plain::Unsure => exact_start(cells, ray, range),
    }
}

/// What f64 says of the first cell.
enum Plain {
    /// It is this one.
    Cell(Start),
    /// There is none.
    PassesBy,
    /// Something is too near to something else, or the ray does not move along an axis.
    Unsure,
}

/// The first cell by plain arithmetic, if that leaves no doubt.
///
/// It does not where the two t of a comparison are not clearly one before the other: [`exact_start`] then
/// decides. Nearly every ray is spared that.
#[inline]
fn plain_start(cells: &CellPlanes, ray: &Ray, inverse: [f64; 3], range: TRange) -> Plain {
    // what is no number is left out of the comparisons, and asked for where one of them has settled something
    let is_unsure = || inverse.iter().any(|inverse| inverse.is_nan());
    let (mut begin, mut end) = (range.min.max(0.0), range.max);
    for (axis, inverse) in inverse.iter().enumerate() {
        let planes = cells.axis(axis);
        let t = |plane: f64| (plane - ray.origin[axis]) * inverse;
        let (at_low, at_high) = (t(planes[0]), t(planes[planes.len() - 1]));
        let (near, far) = if at_low < at_high {
            (at_low, at_high)
        } else {
            (at_high, at_low)
        };
        begin = if begin < near { near } else { begin };
        end = if far < end { far } else { end };
    }
    if !clearly_before(begin, end) {
        return if clearly_before(end, begin) && !is_unsure() {
            Plain::PassesBy
        } else {
            Plain::Unsure
        };
    }
    let mut cell = [0; 3];
    let (mut entered, mut left) = (f64::MIN, f64::INFINITY);
    for axis in 0..3 {
        let planes = cells.axis(axis);
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        let t = |plane: f64| (plane - origin) * inverse[axis];
        let at = cells.near(axis, origin + begin * direction);
        // no jump depends on which way the ray goes: that cannot be foretold
        let upwards = 0.0 < direction;
        let [behind, ahead] = [!upwards, upwards].map(|one| t(planes[at + usize::from(one)]));
        // the first cell behind the outer plane was entered before t₀, or there
        let outermost = if upwards { 0 } else { planes.len() - 2 };
        let behind = if at == outermost { f64::MIN } else { behind };
        entered = if entered < behind { behind } else { entered };
        left = if ahead < left { ahead } else { left };
        cell[axis] = at as u32;
    }
    if clearly_before(begin, left) && clearly_before(entered, begin) && !is_unsure() {
        Plain::Cell(Start { cell, t: begin })
    } else {
        Plain::Unsure
    }
}

/// The first cell, every comparison without rounding.
#[cold]
fn exact_start(cells: &CellPlanes, ray: &Ray, range: TRange) -> Option<Start> {
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
        *of_cell = place as u32;
    }
    Some(Start { cell, t: begin.t() })
}

/// The cell [pᵢ, pᵢ₊₁) that a coordinate between the outer planes lies in; the last one has both its planes.
fn standing_cell(cells: &CellPlanes, axis: usize, x: f64) -> usize {
    let planes = cells.axis(axis);
    let guess = cells.near(axis, x);
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
    let guess = cells.near(axis, origin + begin.t() * direction);
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
