//! The walk of a ray through the cells of a grid, without branches.
//!
//! It visits the cells that [`Grid::walk`](crate::structure::Grid::walk) visits; its t are products with 1/Δ in place
//! of quotients. A step can go on once the next cell's number is known, and which plane comes next cannot be foretold.
//! So neither the start nor a step jumps by the ray's direction, and t of the plane behind the next one is computed
//! before it is asked for. Where two t are near each other, or the range ends about here, the step is decided exactly.

use glam::DVec3;

use crate::geometry::{Ray, TRange, larger, smaller};
use crate::strategy::fast::grid::axis_walk::AxisWalk;
use crate::strategy::fast::grid::guess::{Guess, Start, guess};
use crate::strategy::fast::grid::one_way::{OneWay, Ways};
use crate::structure::{CellPlanes, Meeting, just_after, start};

/// A walk through a grid.
#[derive(Clone, Debug)]
pub(super) struct Walk<'g> {
    axes: [AxisWalk<'g>; 3],
    /// t of the next plane across each axis; infinite if the ray does not move along it, no number if 1/Δ is none.
    next: [f64; 3],
    /// t of the plane behind that one, at hand before it is asked for.
    after: [f64; 3],
    /// The number of the cell that comes next.
    number: usize,
    /// Where the ray enters it.
    t_in: f64,
    /// Where the range ends.
    max: f64,
    done: bool,
}

impl<'g> Walk<'g> {
    /// From the first cell that the ray pierces in its range.
    #[inline]
    pub(super) fn new(ways: &'g Ways, cells: &CellPlanes, ray: &Ray, range: TRange) -> Self {
        let inverse = 1.0 / ray.direction;
        let ways = ways.of(ray.direction);
        if are_usable(inverse) {
            match guess(ways, ray, inverse, range) {
                Guess::Cell(start) => {
                    let (walk, entered) = Self::begun(ways, ray, inverse, start, range.max);
                    if walk.is_clearly_begun(entered) {
                        return walk;
                    }
                }
                Guess::PassesBy => return Self::nowhere(),
                Guess::Unsure => {}
            }
        }
        Self::begun_exactly(ways, cells, ray, range)
    }

    /// From the first cell, every comparison without rounding. Nearly every ray is spared that.
    #[cold]
    #[inline(never)]
    fn begun_exactly(ways: [&'g OneWay; 3], cells: &CellPlanes, ray: &Ray, range: TRange) -> Self {
        let Some((cell, t)) = start(cells, ray, range) else {
            return Self::nowhere();
        };
        let along = |axis: usize| ways[axis].along_from_lowest(cell[axis] as usize);
        let start = Start {
            cell: [0, 1, 2].map(along),
            t,
        };
        let inverse = ray.direction.map(usable_inverse);
        let (mut walk, _) = Self::begun(ways, ray, inverse, start, range.max);
        // what a ray that leaves no doubt is spared
        for (next, direction) in walk.next.iter_mut().zip(ray.direction.to_array()) {
            *next = if direction == 0.0 {
                f64::INFINITY
            } else {
                not_before(t, *next)
            };
        }
        walk
    }

    /// Through no cell.
    #[inline]
    fn nowhere() -> Self {
        Self {
            axes: [AxisWalk::default(); 3],
            next: [f64::INFINITY; 3],
            after: [f64::INFINITY; 3],
            number: 0,
            t_in: 0.0,
            max: 0.0,
            done: true,
        }
    }

    /// From a cell, if the ray moves along all axes and its next planes lie behind `start.t`; and t of the planes behind
    /// that cell.
    #[inline(always)]
    #[expect(
        clippy::inline_always,
        reason = "in place, the walk is not copied: that was a third of the start"
    )]
    fn begun(
        ways: [&'g OneWay; 3],
        ray: &Ray,
        inverse: DVec3,
        start: Start,
        max: f64,
    ) -> (Self, [f64; 3]) {
        let (origin, direction) = (ray.origin, ray.direction);
        let [of_x, of_y, of_z] = ways;
        let [i, j, k] = start.cell;
        let x = AxisWalk::new(of_x, i, origin.x, direction.x, inverse.x);
        let y = AxisWalk::new(of_y, j, origin.y, direction.y, inverse.y);
        let z = AxisWalk::new(of_z, k, origin.z, direction.z, inverse.z);
        let [[x0, x1, x2], [y0, y1, y2], [z0, z1, z2]] =
            [x.first_three(), y.first_three(), z.first_three()];
        let walk = Self {
            axes: [x, y, z],
            next: [x1, y1, z1],
            after: [x2, y2, z2],
            number: of_x
                .number(i)
                .wrapping_add(of_y.number(j))
                .wrapping_add(of_z.number(k)),
            t_in: start.t,
            max,
            done: false,
        };
        (walk, [x0, y0, z0])
    }

    /// Is it beyond doubt that the ray is in the first cell by the t at which the walk begins, and leaves it later?
    #[inline]
    fn is_clearly_begun(&self, entered: [f64; 3]) -> bool {
        let [x, y, z] = entered;
        let entered = larger(larger(x, y), z);
        let [x, y, z] = self.next;
        let left = smaller(smaller(x, y), z);
        just_after(entered) < self.t_in && just_after(self.t_in) < left
    }

    /// The next cell's number, and where the ray leaves it.
    #[inline]
    pub(super) fn step(&mut self) -> Option<(usize, f64)> {
        if self.done {
            return None;
        }
        let number = self.number;
        let [x, y, z] = self.next;
        // the choice is kept free of branches: which axis comes next cannot be foretold
        let (of_two, other) = if y < x { (y, x) } else { (x, y) };
        let (t, third) = if z < of_two { (z, of_two) } else { (of_two, z) };
        let axis = if z < of_two { 2 } else { usize::from(y < x) };
        let later = just_after(t);
        let t_out = if later < other && later < third && later < self.max {
            self.cross(axis, t);
            t
        } else {
            self.step_exactly()
        };
        self.t_in = t_out;
        Some((number, t_out))
    }

    /// Crosses the next plane of an axis at t.
    #[inline]
    fn cross(&mut self, axis: usize, t: f64) {
        let of = &mut self.axes[axis];
        let Some(after) = of.cross() else {
            self.done = true;
            return;
        };
        self.number = of.next_cell(self.number);
        self.next[axis] = not_before(t, self.after[axis]);
        self.after[axis] = after;
    }

    /// The step where two planes are about equally near, or where the range ends about here.
    #[cold]
    fn step_exactly(&mut self) -> f64 {
        let meetings = [0, 1, 2].map(|axis| self.axes[axis].meeting());
        let moving = [0, 1, 2].map(|axis: usize| meetings[axis].direction != 0.0);
        let is_first = |axis: &usize| {
            let before = |other: usize| moving[other] && meetings[other].before(&meetings[*axis]);
            moving[*axis] && !(0..3).any(before)
        };
        let is_crossed = [0, 1, 2].map(|axis| is_first(&axis));

        let t_of = |axis: usize| match self.next[axis] {
            next if next.is_nan() => meetings[axis].t().max(self.t_in),
            next => next,
        };
        let crossed = (0..3).filter(|&axis| is_crossed[axis]);
        let t = crossed.map(t_of).fold(f64::INFINITY, f64::min);
        let leaves = (0..3).find(|&axis| is_crossed[axis]);
        let goes_on = leaves.is_some_and(|axis| {
            self.max == f64::INFINITY || meetings[axis].before(&Meeting::at(self.max))
        });
        if !goes_on {
            self.done = true;
            return t;
        }
        for (axis, is_crossed) in is_crossed.into_iter().enumerate() {
            if is_crossed {
                self.cross(axis, t);
            } else {
                self.next[axis] = not_before(t, self.next[axis]);
            }
        }
        t
    }
}

/// Holds t to the order of the planes, where rounding has turned it round; what is no number stays none.
#[inline]
fn not_before(t: f64, next: f64) -> f64 {
    if next < t { t } else { next }
}

/// Does f64 hold each 1/Δ with all its digits?
#[inline]
fn are_usable(inverse: DVec3) -> bool {
    let size = inverse.abs();
    let least = smaller(smaller(size.x, size.y), size.z);
    // the sum is beyond f64, or no number, if one of them is
    f64::MIN_POSITIVE <= least && size.element_sum() < f64::INFINITY
}

/// 1/Δ; no number where it is none that f64 holds with all its digits: then no t of it is ever certain, and
/// each is taken exactly.
#[inline]
fn usable_inverse(direction: f64) -> f64 {
    let inverse = 1.0 / direction;
    if inverse.is_normal() {
        inverse
    } else {
        f64::NAN
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::AxisBox;
    use crate::structure::{Across, CellStep, GridWalk};

    const OFF_THE_ORIGIN: AxisBox = AxisBox {
        min: DVec3::new(-1.1, -0.9, -1.3),
        max: DVec3::new(3.0, 2.1, 1.0),
    };

    /// The cells that both walks visit, one by one, and t at which the ray leaves each.
    #[track_caller]
    fn check(cells: &CellPlanes, ways: &Ways, ray: &Ray, range: TRange) -> Vec<CellStep> {
        let plain: Vec<_> = GridWalk::new(cells, ray, range).collect();
        let mut walk = Walk::new(ways, cells, ray, range);
        let found: Vec<_> = std::iter::from_fn(|| walk.step()).collect();
        let numbers: Vec<_> = plain.iter().map(|step| cells.number(step.cell)).collect();
        let visited: Vec<_> = found.iter().map(|(number, _)| *number).collect();
        assert_eq!(visited, numbers, "{ray:?} {range:?}");
        assert!(found.is_sorted_by(|a, b| a.1 <= b.1), "{found:?}: {ray:?}");
        for (step, (_, t_out)) in plain.iter().zip(found) {
            let off = (step.t_out - t_out).abs();
            let is_same = step.t_out == t_out || off <= 4.0 * f64::EPSILON * step.t_out.abs();
            assert!(is_same, "{t_out} for {}: {ray:?}", step.t_out);
        }
        plain
    }

    /// A number between −1 and 1 (G. Marsaglia's xorshift, 2003).
    fn random(state: &mut u64) -> f64 {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    #[test]
    fn both_walks_visit_the_same_cells() {
        let mut state = 0x9e37_79b9_7f4a_7c15;
        let mut number = || random(&mut state);
        let (mut visited, mut corners, mut cut) = (0, 0, 0);
        for case in 0..60_000_u32 {
            let resolution = [1 + case % 7, 1 + case % 5, 1 + case % 3];
            let (min, max) = (DVec3::splat(-1.0), DVec3::new(3.0, 2.0, 1.0));
            let cells = CellPlanes::new(&AxisBox { min, max }, resolution);
            let ways = Ways::new(&cells);
            let mut point = |size: f64| size * DVec3::new(number(), number(), number());
            let (mut origin, mut direction) = (point(4.0), point(1.0));
            if case % 2 == 0 {
                // on a lattice: in faces, through edges and corners, along axes
                origin = origin.round();
                direction = (2.0 * direction).round();
            }
            if case % 11 == 0 {
                direction *= [5e-324, 1e-310, 1e-200, 1e200, 8e307][case as usize / 11 % 5];
            }
            let mut range = TRange::FORWARD;
            if case % 3 == 0 {
                range = TRange {
                    min: 0.25 * f64::from(case % 4),
                    max: 0.5 * f64::from(case % 9),
                };
            }
            let steps = check(&cells, &ways, &Ray::new(origin, direction), range);
            visited += steps.len();
            let through =
                |step: &&CellStep| ![Across::X, Across::Y, Across::Z].contains(&step.across);
            corners += steps.iter().filter(through).count();
            cut += usize::from(range.max.is_finite() && !steps.is_empty());
        }
        // each of these is common among the rays, else this test would hold of itself
        assert!(
            5_000 < visited && 200 < corners && 200 < cut,
            "{visited} {corners} {cut}"
        );
    }

    #[test]
    fn a_grid_without_cells_is_passed_by() {
        let cells = CellPlanes::default();
        let ways = Ways::new(&cells);
        let ray = Ray::new(DVec3::ZERO, DVec3::ONE);
        assert!(
            Walk::new(&ways, &cells, &ray, TRange::FORWARD)
                .step()
                .is_none()
        );
    }

    #[test]
    fn a_range_that_begins_or_ends_beside_a_plane_is_walked_alike() {
        let mut state = 0x2545_f491_4f6c_dd1d;
        let mut number = || random(&mut state);
        let mut steps = 0;
        for case in 0..8_000_u32 {
            let cells =
                CellPlanes::new(&OFF_THE_ORIGIN, [2 + case % 7, 2 + case % 5, 2 + case % 3]);
            let ways = Ways::new(&cells);
            let mut point = |size: f64| size * DVec3::new(number(), number(), number());
            let ray = Ray::new(point(2.0), point(1.0));
            // t of two planes, or a few numbers beside it
            let t = |axis: usize, at: u32| {
                let planes = cells.axis(axis);
                let plane = planes[at as usize % planes.len()];
                let t = (plane - ray.origin[axis]) / ray.direction[axis];
                [t.next_down(), t, t.next_up(), t.next_up().next_up()][case as usize / 3 % 4]
            };
            let axis = case as usize % 3;
            let (a, b) = (t(axis, case / 7), t((axis + 1) % 3, case / 5));
            let range = TRange {
                min: a.min(b).max(0.0),
                max: if case % 2 == 0 {
                    a.max(b)
                } else {
                    f64::INFINITY
                },
            };
            steps += check(&cells, &ways, &ray, range).len();
        }
        assert!(4_000 < steps, "{steps}");
    }

    #[test]
    fn rays_through_edges_and_corners_but_for_rounding_are_walked_alike() {
        let mut state = 0x1234_5678_9abc_def1;
        let mut number = || random(&mut state);
        let mut corners = 0;
        for case in 0..8_000_u32 {
            let cells =
                CellPlanes::new(&OFF_THE_ORIGIN, [2 + case % 7, 2 + case % 5, 2 + case % 3]);
            let ways = Ways::new(&cells);
            let mut point = |size: f64| size * DVec3::new(number(), number(), number());
            let origin = point(2.0);
            // an edge along z, or a corner
            let plane = |axis: usize, at: u32| {
                let planes = cells.axis(axis);
                planes[at as usize % planes.len()]
            };
            let mut target = DVec3::new(plane(0, case / 3), plane(1, case / 7), point(1.0).z);
            if case % 2 == 0 {
                target.z = plane(2, case / 5);
            }
            let ray = Ray::new(origin, 0.3 * (target - origin));
            let steps = check(&cells, &ways, &ray, TRange::FORWARD);
            let near = |step: &&CellStep| {
                let [x, y, _] = step.next;
                (x - y).abs() <= 1e-14
            };
            corners += steps.iter().filter(near).count();
        }
        assert!(2_000 < corners, "{corners}");
    }
}
