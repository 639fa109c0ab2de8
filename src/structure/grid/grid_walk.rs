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
//! by that: objects are listed with a little room around them, so one that is hit on an edge is
//! on the list of every cell around it.
//!
//! **Exactly.** t = (pᵢ − o)/Δ is computed from each plane itself, not added up from cell to cell, and which
//! plane comes first is decided without rounding ([`Meeting::before`]): by f64 where the difference is beyond their
//! error, else by the sign of (p − o)·Δ′ − (p′ − o′)·Δ. A zero of either sign is no direction. The ray's coordinates
//! may have any size that leaves their differences within f64.

use crate::geometry::{Ray, TRange};
use crate::structure::grid::cell_planes::CellPlanes;
use crate::structure::grid::grid_start::start;
use crate::structure::grid::ray_order::Meeting;
use crate::structure::{Across, CellStep};

/// A walk through a grid; an iterator over the cells that the ray pierces.
#[doc(alias = "DDA")]
#[doc(alias = "3DDDA")]
#[doc(alias = "voxel traversal")]
#[doc(alias = "grid traversal")]
#[derive(Clone, Debug)]
pub struct GridWalk<'g> {
    cells: &'g CellPlanes,
    ray: Ray,
    /// The cell that comes next.
    cell: Option<[u32; 3]>,
    /// Where the ray enters it.
    t_in: f64,
    /// Where the range ends.
    max: f64,
}

impl<'g> GridWalk<'g> {
    /// From the first cell that the ray pierces in its range.
    pub(crate) fn new(cells: &'g CellPlanes, ray: &Ray, range: TRange) -> Self {
        let (cell, t_in) = start(cells, ray, range).unzip();
        Self {
            cells,
            ray: *ray,
            cell,
            t_in: t_in.unwrap_or(range.min),
            max: range.max,
        }
    }

    /// The cell that comes next.
    pub(crate) fn cell(&self) -> Option<[u32; 3]> {
        self.cell
    }

    /// Where the ray hits the next plane across an axis, from a cell; `None` if it does not move along the axis.
    fn meeting(&self, axis: usize, cell: [u32; 3]) -> Option<Meeting> {
        let direction = self.ray.direction[axis];
        let at = cell[axis] as usize;
        let next = if direction < 0.0 { at } else { at + 1 };
        (direction != 0.0).then(|| Meeting {
            plane: self.cells.axis(axis)[next],
            origin: self.ray.origin[axis],
            direction,
        })
    }

    /// Does the range go on behind this plane?
    fn goes_on(&self, plane: &Meeting) -> bool {
        self.max == f64::INFINITY || plane.before(&Meeting::at(self.max))
    }

    /// The cell behind the next planes of these axes; `None` if the grid ends there.
    fn cell_behind(&self, cell: [u32; 3], is_crossed: [bool; 3]) -> Option<[u32; 3]> {
        let mut behind = cell;
        for axis in (0..3).filter(|&axis| is_crossed[axis]) {
            behind[axis] = if self.ray.direction[axis] < 0.0 {
                cell[axis].checked_sub(1)?
            } else {
                let above = cell[axis] + 1;
                (above < self.cells.resolution()[axis]).then_some(above)?
            };
        }
        Some(behind)
    }
}

impl Iterator for GridWalk<'_> {
    type Item = CellStep;

    fn next(&mut self) -> Option<CellStep> {
        let cell = self.cell?;
        let meetings = [0, 1, 2].map(|axis| self.meeting(axis, cell));
        // the ray leaves across the plane that no other comes before: at an edge or a corner across two or three
        let is_first = |plane: &Meeting| {
            let others = meetings.iter().flatten();
            others.into_iter().all(|other| !other.before(plane))
        };
        let is_crossed = meetings.map(|plane| plane.is_some_and(|plane| is_first(&plane)));
        // rounding may not turn the order round
        let t_of = |plane: Meeting| plane.t().max(self.t_in);
        let next = meetings.map(|plane| plane.map_or(f64::INFINITY, t_of));
        let crossed = || (0..3).filter(|&axis| is_crossed[axis]);
        let step = CellStep {
            cell,
            t_in: self.t_in,
            t_out: crossed()
                .map(|axis| next[axis])
                .fold(f64::INFINITY, f64::min),
            next,
            across: Across::BY_BITS[crossed().map(|axis| 1 << axis).sum::<usize>()],
        };
        let first = meetings.into_iter().flatten().find(is_first);
        let goes_on = first.is_some_and(|plane| self.goes_on(&plane));
        self.cell = self.cell_behind(cell, is_crossed).filter(|_| goes_on);
        self.t_in = step.t_out;
        Some(step)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::AxisBox;

    /// 4 × 4 × 4 cells with sides of 1.
    fn unit_cells() -> CellPlanes {
        CellPlanes::new(&AxisBox::around([DVec3::ZERO, DVec3::splat(4.0)]), [4; 3])
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
        let cells = CellPlanes::new(
            &AxisBox::around([DVec3::ZERO, DVec3::new(30.0, 70.0, 1.0)]),
            [10, 10, 1],
        );
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

    #[test]
    fn the_cell_that_comes_next_is_known_before_the_step() {
        let ray = Ray::new(DVec3::new(-1.0, 2.5, 0.5), DVec3::X);
        let cells = unit_cells();
        let mut walk = GridWalk::new(&cells, &ray, TRange::FORWARD);
        for i in 0..4 {
            assert_eq!(walk.cell(), Some([i, 2, 0]));
            assert!(walk.next().is_some());
        }
        assert_eq!(walk.cell(), None);
    }
}
