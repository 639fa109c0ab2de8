//! Where the walk of a ray through a grid begins.

use std::cmp::Ordering;

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::structure::cell_planes::CellPlanes;
use crate::structure::extremes::{larger, smaller};
use crate::structure::one_way::OneWay;
use crate::structure::ray_order::{Meeting, just_after};

/// The first cell that a ray pierces in its range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// Along x, y and z, each counted as the ray goes.
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
/// far. Along each axis (x₀ + t₀·Δx − from) times the cells for a unit of length says in which cell it is then.
#[inline]
pub(super) fn guess(ways: [&OneWay; 3], ray: &Ray, inverse: DVec3, range: TRange) -> Guess {
    let [x, y, z] = ways;
    let near = (DVec3::new(x.from, y.from, z.from) - ray.origin) * inverse;
    let far = (DVec3::new(x.to, y.to, z.to) - ray.origin) * inverse;
    let begin = larger(
        larger(near.x, near.y),
        larger(near.z, larger(range.min, 0.0)),
    );
    let end = smaller(smaller(far.x, far.y), smaller(far.z, range.max));
    if just_after(begin) < end {
        let at = |way: &OneWay, origin: f64, direction: f64| {
            // what does not depend on t₀ is at hand before it is
            let per_unit = way.per_unit;
            way.cell_at((origin - way.from) * per_unit + begin * (direction * per_unit))
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
    if cells.is_empty() {
        return None;
    }
    let ways = cells.ways(ray.direction);
    let mut begin = Meeting::at(range.min.max(0.0));
    for (axis, way) in ways.into_iter().enumerate() {
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        if direction == 0.0 {
            let (low, high) = (way.from.min(way.to), way.from.max(way.to));
            if !(low <= origin && origin <= high) {
                return None;
            }
            continue;
        }
        let outer = Meeting {
            plane: way.from,
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
    for (axis, way) in ways.into_iter().enumerate() {
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        cell[axis] = if direction == 0.0 {
            let above = standing_cell(cells.axis(axis), origin);
            if direction.is_sign_negative() {
                way.last as usize - above
            } else {
                above
            }
        } else {
            moving_cell(way, origin, direction, &begin)?
        };
    }
    Some(Start { cell, t: begin.t() })
}

/// The cell [pᵢ, pᵢ₊₁) that a coordinate between the outer planes lies in; the last one has both its planes.
fn standing_cell(planes: &[f64], x: f64) -> usize {
    let below = planes.partition_point(|&plane| plane <= x);
    below.clamp(1, planes.len() - 1) - 1
}

/// The cell along its way that the ray is in just after `begin`; `None` if it has left the grid by then.
fn moving_cell(way: &OneWay, origin: f64, direction: f64, begin: &Meeting) -> Option<usize> {
    let is_met_after = |plane: f64| {
        let meeting = Meeting {
            plane,
            origin,
            direction,
        };
        meeting.order(begin) == Ordering::Greater
    };
    // the next plane is the first one met after t₀
    let guess = way.near(origin + begin.t() * direction);
    if let [behind, next, ..] = *way.ahead(guess)
        && is_met_after(next)
        && (guess == 0 || !is_met_after(behind))
    {
        return Some(guess);
    }
    let cell = way.met().partition_point(|&plane| !is_met_after(plane));
    (cell <= way.last as usize).then_some(cell)
}
