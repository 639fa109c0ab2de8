//! The walk of a ray through the cells of a grid (slides, "Spatial Partitioning", Fig. 15.61).
//!
//! The slides take the next partition from "a 3D version of the line-drawing algorithm". A line-drawing
//! algorithm draws one cell in each column and leaves out others that the line passes through; this walk
//! visits every cell that the ray pierces (erratum 7), in order and each once, after A. Fujimoto, T. Tanaka
//! and K. Iwata (1986, 3DDDA) and J. Amanatides and A. Woo (1987).
//!
//! **Which cells are pierced.** Those in which the ray, within its range, is for more than a single t, where
//! a cell owns its lower faces: along each axis it is [pᵢ, pᵢ₊₁), and the last one [pₙ₋₁, pₙ]. So a ray that
//! runs in the face between two cells belongs to the upper one alone; and through an edge or a corner the walk
//! steps along two or three axes at once, without the cells that the ray only touches there. Nothing is lost
//! by that: objects are listed with a little room around them, so one that is met on an edge is
//! on the list of every cell around it.
//!
//! **Exactly.** t = (pᵢ − o)/Δ is computed from each plane itself, not added up from cell to cell, and which
//! plane comes first is decided without rounding: by f64 where the difference is beyond their error, else by
//! the sign of (p − o)·Δ′ − (p′ − o′)·Δ. A zero of either sign is no direction. The ray's coordinates may have
//! any size that leaves their differences within f64.

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::structure::axis_walk::AxisWalk;
use crate::structure::cell_planes::CellPlanes;
use crate::structure::extremes::{larger, smaller};
use crate::structure::grid_start::{Guess, Start, exact_start, guess};
use crate::structure::one_way::OneWay;
use crate::structure::ray_order::{Meeting, just_after};
use crate::structure::{Across, CellStep};

/// A walk through a grid; an iterator over the cells that the ray pierces.
#[derive(Clone, Debug)]
pub struct GridWalk<'g> {
    cells: &'g CellPlanes,
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

/// How the ray leaves a cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leaving {
    /// Where.
    pub(crate) t: f64,
    /// Across which planes, by the bits of [`Across::BY_BITS`].
    across: u8,
}

impl<'g> GridWalk<'g> {
    /// From the first cell that the ray pierces in its range.
    #[inline]
    pub(super) fn new(cells: &'g CellPlanes, ray: &Ray, range: TRange) -> Self {
        let inverse = 1.0 / ray.direction;
        if are_usable(inverse) {
            let ways = cells.ways(ray.direction);
            match guess(ways, ray, inverse, range) {
                Guess::Cell(start) => {
                    let (walk, entered) = Self::begun(cells, ways, ray, inverse, start, range.max);
                    if walk.is_clearly_begun(entered) {
                        return walk;
                    }
                }
                Guess::PassesBy => return Self::nowhere(cells),
                Guess::Unsure => {}
            }
        }
        Self::begun_exactly(cells, ray, range)
    }

    /// From the first cell, every comparison without rounding. Nearly every ray is spared that.
    #[cold]
    #[inline(never)]
    fn begun_exactly(cells: &'g CellPlanes, ray: &Ray, range: TRange) -> Self {
        match exact_start(cells, ray, range) {
            Some(start) => {
                let inverse = ray.direction.map(usable_inverse);
                let ways = cells.ways(ray.direction);
                let (mut walk, _) = Self::begun(cells, ways, ray, inverse, start, range.max);
                // what a ray that leaves no doubt is spared
                for (next, direction) in walk.next.iter_mut().zip(ray.direction.to_array()) {
                    *next = if direction == 0.0 {
                        f64::INFINITY
                    } else {
                        not_before(start.t, *next)
                    };
                }
                walk
            }
            None => Self::nowhere(cells),
        }
    }

    /// Through no cell.
    #[inline]
    fn nowhere(cells: &'g CellPlanes) -> Self {
        Self {
            cells,
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
    #[inline]
    fn begun(
        cells: &'g CellPlanes,
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
            cells,
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

    /// The cell that comes next.
    pub(crate) fn cell(&self) -> Option<[u32; 3]> {
        (!self.done).then(|| self.cells.cell(self.number))
    }

    /// The next cell with all that is known of it before it is left.
    pub(crate) fn entering(&self) -> Option<CellStep> {
        let mut next = self.next;
        for (axis, next) in next.iter_mut().enumerate() {
            if next.is_nan() {
                *next = self.axes[axis].meeting().t().max(self.t_in);
            }
        }
        Some(CellStep {
            cell: self.cell()?,
            t_in: self.t_in,
            next,
            ..CellStep::default()
        })
    }

    /// The next cell's number, and how the ray leaves it.
    #[inline]
    pub(crate) fn step(&mut self) -> Option<(usize, Leaving)> {
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
        let leaving = if later < other && later < third && later < self.max {
            self.cross(axis, t);
            Leaving {
                t,
                across: 1 << axis,
            }
        } else {
            self.step_exactly()
        };
        self.t_in = leaving.t;
        Some((number, leaving))
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
    fn step_exactly(&mut self) -> Leaving {
        let meetings = [0, 1, 2].map(|axis| self.axes[axis].meeting());
        let moving = [0, 1, 2].map(|axis: usize| meetings[axis].direction != 0.0);
        let is_first = |axis: &usize| {
            let before = |other: usize| moving[other] && meetings[other].before(&meetings[*axis]);
            moving[*axis] && !(0..3).any(before)
        };
        let across: u8 = (0..3).filter(is_first).map(|axis| 1 << axis).sum();
        let is_crossed = |axis: usize| across & (1 << axis) != 0;

        let t_of = |axis: usize| match self.next[axis] {
            next if next.is_nan() => meetings[axis].t().max(self.t_in),
            next => next,
        };
        let crossed = (0..3).filter(|&axis| is_crossed(axis));
        let t = crossed.map(t_of).fold(f64::INFINITY, f64::min);
        let leaves = (0..3).find(|&axis| is_crossed(axis));
        let goes_on = leaves.is_some_and(|axis| {
            self.max == f64::INFINITY || meetings[axis].before(&Meeting::at(self.max))
        });
        if !goes_on {
            self.done = true;
            return Leaving { t, across };
        }
        for axis in 0..3 {
            if is_crossed(axis) {
                self.cross(axis, t);
            } else {
                self.next[axis] = not_before(t, self.next[axis]);
            }
        }
        Leaving { t, across }
    }
}

impl Iterator for GridWalk<'_> {
    type Item = CellStep;

    fn next(&mut self) -> Option<CellStep> {
        let entering = self.entering()?;
        let (_, leaving) = self.step()?;
        Some(leaving.completes(entering))
    }
}

impl Leaving {
    /// The whole step, from what was known of it before.
    pub(crate) fn completes(self, entering: CellStep) -> CellStep {
        CellStep {
            t_out: self.t,
            across: Across::BY_BITS[usize::from(self.across)],
            ..entering
        }
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
    use glam::DVec3;

    use super::*;

    /// 4 × 4 × 4 cells with sides of 1.
    fn unit_cells() -> CellPlanes {
        CellPlanes::new(DVec3::ZERO, DVec3::splat(4.0), [4; 3])
    }

    fn walk_in(origin: [f64; 3], direction: [f64; 3], range: TRange) -> Vec<CellStep> {
        let ray = Ray::new(origin.into(), direction.into());
        GridWalk::new(&unit_cells(), &ray, range).collect()
    }

    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], cells: &[[u32; 3]]) {
        let found = walk_in(origin, direction, TRange::FORWARD);
        let found: Vec<_> = found.iter().map(|step| step.cell).collect();
        assert_eq!(found, cells);
    }

    /// The cells of a row along x.
    fn row(j: u32, k: u32) -> [[u32; 3]; 4] {
        [0, 1, 2, 3].map(|i| [i, j, k])
    }

    #[test]
    fn a_slanted_ray_visits_every_cell_that_it_pierces() {
        let range = TRange::FORWARD;
        let steps = walk_in([-1.0, 0.25, 0.5], [2.0, 1.0, 0.0], range);
        // y = ¼ + ½(x + 1): 0.75 at x = 0; 1 at x = ½, 2 at x = 2½
        let cells = [
            [0, 0, 0],
            [0, 1, 0],
            [1, 1, 0],
            [2, 1, 0],
            [2, 2, 0],
            [3, 2, 0],
        ];
        let found: Vec<_> = steps.iter().map(|step| step.cell).collect();
        assert_eq!(found, cells);
        // t = (x + 1)/2
        let first = CellStep {
            cell: [0, 0, 0],
            t_in: 0.5,
            t_out: 0.75,
            next: [1.0, 0.75, f64::INFINITY],
            across: Across::Y,
        };
        assert_eq!(steps[0], first);
        assert_eq!((steps[5].t_out, steps[5].across), (2.5, Across::X));
    }

    #[test]
    fn a_line_drawing_algorithm_would_leave_out_every_second_of_these_cells() {
        // y = ½ + 0.9·x: one cell in each column would be (0,0), (1,1), (2,2), (3,3)
        let cells = [
            [0, 0, 0],
            [0, 1, 0],
            [1, 1, 0],
            [1, 2, 0],
            [2, 2, 0],
            [2, 3, 0],
            [3, 3, 0],
        ];
        check([0.0, 0.5, 0.5], [1.0, 0.9, 0.0], &cells);
    }

    #[test]
    fn through_a_corner_the_walk_steps_along_all_axes_at_once() {
        let diagonal = [[0, 0, 0], [1, 1, 1], [2, 2, 2], [3, 3, 3]];
        check([-1.0; 3], [1.0; 3], &diagonal);
        let steps = walk_in([-1.0; 3], [1.0; 3], TRange::FORWARD);
        assert!(steps.iter().all(|step| step.across == Across::XYZ));
        // through edges along z
        check(
            [0.0, 0.0, 0.5],
            [1.0, 1.0, 0.0],
            &[[0, 0, 0], [1, 1, 0], [2, 2, 0], [3, 3, 0]],
        );
    }

    #[test]
    fn a_corner_is_met_in_steps_where_f64_makes_one_or_the_other_first() {
        // thirds and sevenths: (3·n − 0)/3 = (7·n − 0)/7 in every n, whatever 1/3 and 1/7 are rounded to
        let cells = CellPlanes::new(DVec3::ZERO, DVec3::new(30.0, 70.0, 1.0), [10, 10, 1]);
        let ray = Ray::new(DVec3::new(0.0, 0.0, 0.5), DVec3::new(3.0, 7.0, 0.0));
        let steps: Vec<_> = GridWalk::new(&cells, &ray, TRange::FORWARD).collect();
        let diagonal: Vec<_> = (0..10).map(|n| [n, n, 0]).collect();
        let found: Vec<_> = steps.iter().map(|step| step.cell).collect();
        assert_eq!(found, diagonal);
    }

    #[test]
    fn a_ray_in_a_face_belongs_to_the_cells_above_it_and_in_the_last_plane_to_the_last() {
        for zero in [0.0, -0.0] {
            check([-1.0, 2.0, 0.5], [1.0, zero, zero], &row(2, 0));
            check([-1.0, 0.0, 0.5], [1.0, zero, zero], &row(0, 0));
            check([-1.0, 4.0, 0.5], [1.0, zero, zero], &row(3, 0));
            // along edges
            check([-1.0, 2.0, 1.0], [1.0, zero, zero], &row(2, 1));
            check([-1.0, 4.0, 4.0], [1.0, zero, zero], &row(3, 3));
        }
        let mut backwards = row(2, 0);
        backwards.reverse();
        check([9.0, 2.0, 0.5], [-1.0, 0.0, 0.0], &backwards);
    }

    #[test]
    fn from_a_plane_the_direction_says_which_cell_is_first() {
        check([1.0, 0.5, 0.5], [1.0, 0.0, 0.0], &row(0, 0)[1..]);
        check([1.0, 0.5, 0.5], [-1.0, 0.0, 0.0], &row(0, 0)[..1]);
        // from a corner, down in x and y and up in z
        check([1.0, 1.0, 3.0], [-1.0, -1.0, 1.0], &[[0, 0, 3]]);
        // from an edge, in x only: the edge belongs to the cell above
        check([3.0, 2.0, 2.0], [1.0, 0.0, 0.0], &[[3, 2, 2]]);
    }

    #[test]
    fn a_ray_that_only_touches_the_grid_in_a_point_pierces_nothing() {
        // leaving it from a face, and from a corner
        check([4.0, 0.5, 0.5], [1.0, 0.0, 0.0], &[]);
        check([0.0, 0.0, 0.0], [-1.0, 1.0, 1.0], &[]);
        // across an edge, and across a corner
        check([-1.0, 1.0, 0.5], [1.0, -1.0, 0.0], &[]);
        check([-1.0, 1.0, 1.0], [1.0, -1.0, -1.0], &[]);
    }

    #[test]
    fn a_ray_beside_the_grid_or_behind_it_pierces_nothing() {
        check([-1.0, 4.5, 0.5], [1.0, 0.0, 0.0], &[]);
        check([-1.0, -0.5, 0.5], [1.0, -0.0, 0.0], &[]);
        check([5.0, 0.5, 0.5], [1.0, 0.0, 0.0], &[]);
        check([-1.0, 0.5, 0.5], [0.0, 1.0, 0.0], &[]);
    }

    #[test]
    fn a_ray_without_direction_stays_in_its_cell() {
        let steps = walk_in([1.5, 2.0, 4.0], [0.0, -0.0, 0.0], TRange::FORWARD);
        let only = CellStep {
            cell: [1, 2, 3],
            t_in: 0.0,
            t_out: f64::INFINITY,
            next: [f64::INFINITY; 3],
            across: Across::None,
        };
        assert_eq!(steps, [only]);
    }

    #[test]
    fn a_range_cuts_the_walk_at_both_ends_and_a_single_point_does_not_count() {
        let cut = |min, max| {
            let range = TRange { min, max };
            let steps = walk_in([0.0, 0.5, 0.5], [1.0, 0.0, 0.0], range);
            steps.iter().map(|step| step.cell[0]).collect::<Vec<_>>()
        };
        assert_eq!(cut(0.0, 2.5), [0, 1, 2]);
        assert_eq!(cut(0.0, 2.0), [0, 1]);
        assert_eq!(cut(1.0, 2.0), [1]);
        assert_eq!(cut(1.5, 1.75), [1]);
        assert_eq!(cut(3.5, 9.0), [3]);
        assert_eq!(cut(4.0, 9.0), [0; 0]);
        assert_eq!(cut(2.0, 2.0), [0; 0]);
        // the range begins inside the cell
        let range = TRange { min: 1.5, max: 9.0 };
        let steps = walk_in([0.0, 0.5, 0.5], [1.0, 0.0, 0.0], range);
        assert_eq!((steps[0].t_in, steps[0].t_out), (1.5, 2.0));
    }

    #[test]
    fn tiny_and_huge_directions_visit_the_same_cells() {
        let diagonal = [[0, 0, 0], [1, 1, 0], [2, 2, 0], [3, 3, 0]];
        for size in [5e-324, 1e-310, 1e-200, 1e200, 1e308] {
            check([0.0, 0.0, 0.5], [size, size, 0.0], &diagonal);
        }
        // at z = 0.5 + 10⁻³¹⁰·x nothing changes
        check([0.0, 0.5, 0.5], [1.0, 1e-310, 0.0], &row(0, 0));
    }
}
