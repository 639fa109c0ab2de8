//! The walk through a grid, and where it ends.

use crate::mistake::{Mistake, Wrong};
use crate::structure::Across;

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "next plane always +1",
        sentence: "The next plane is taken above the cell, although the ray runs down along this axis.",
        spoils: "t of the next plane",
        wrong: Wrong::NextPlane(always_plus_1),
    },
    Mistake {
        name: "steps the largest t",
        sentence: "The walk crosses the plane with the largest t instead of the smallest.",
        spoils: "next cell",
        wrong: Wrong::PlanesCrossed(largest_t),
    },
    Mistake {
        name: "two axes at once",
        sentence: "The walk steps along two axes at once and skips the cell in between.",
        spoils: "next cell",
        wrong: Wrong::PlanesCrossed(two_axes_at_once),
    },
    Mistake {
        name: "stops at the first cell with a hit",
        sentence: "The walk ends with the first hit, even if that lies beyond its cell.",
        spoils: "nearest hit",
        wrong: Wrong::WalkEnds(first_cell_with_a_hit),
    },
];

fn always_plus_1(cell: u32, _direction: f64) -> u32 {
    cell + 1
}

/// The axes whose planes are crossed.
fn across(is_crossed: impl Fn(usize) -> bool) -> Across {
    let crossed = (0..3).filter(|&axis| is_crossed(axis));
    Across::BY_BITS[crossed.map(|axis| 1 << axis).sum::<usize>()]
}

/// Across an axis along which the ray does not move it crosses no plane.
fn largest_t(next: [f64; 3]) -> Across {
    let finite = next.into_iter().filter(|t| t.is_finite());
    let largest = finite.fold(f64::NEG_INFINITY, f64::max);
    across(|axis| next[axis] == largest)
}

fn two_axes_at_once(next: [f64; 3]) -> Across {
    let mut sorted = next;
    sorted.sort_by(f64::total_cmp);
    across(|axis| next[axis] <= sorted[1] && next[axis].is_finite())
}

fn first_cell_with_a_hit(nearest: f64, _t_out: f64) -> bool {
    nearest.is_finite()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::{AxisBox, Ray, TRange};
    use crate::strategy::is_passed;
    use crate::structure::{CellPlanes, CellStep, GridWalk};

    /// The first step from (2.5, 2.5, 2.5) through 4 × 4 × 4 cells with sides of 1.
    fn step(direction: [f64; 3]) -> CellStep {
        let around = AxisBox::around([DVec3::ZERO, DVec3::splat(4.0)]);
        let cells = CellPlanes::new(&around, [4; 3]);
        let ray = Ray::new(DVec3::splat(2.5), direction.into());
        GridWalk::new(&cells, &ray, TRange::FORWARD).next().unwrap()
    }

    #[test]
    fn the_smallest_t_is_crossed_first() {
        // half a cell to each plane: 0.5, 1, 2
        let slanted = step([1.0, 0.5, 0.25]);
        assert_eq!((slanted.next, slanted.across), ([0.5, 1.0, 2.0], Across::X));
        assert_eq!(largest_t(slanted.next), Across::Z);
        assert_eq!(two_axes_at_once(slanted.next), Across::XY);
        // along an axis there is one plane alone
        let straight = step([0.0, 1.0, 0.0]);
        assert_eq!(straight.across, Across::Y);
        assert_eq!(largest_t(straight.next), Across::Y);
        assert_eq!(two_axes_at_once(straight.next), Across::Y);
        let through_edge = step([1.0, 1.0, 0.5]);
        assert_eq!(through_edge.across, Across::XY);
        assert_eq!(two_axes_at_once(through_edge.next), Across::XY);
    }

    #[test]
    fn downwards_the_next_plane_is_the_lower_one_of_the_cell() {
        // cell 2 is [2, 3]: plane 3 upwards, plane 2 downwards
        assert_eq!(
            (step([1.0, 0.0, 0.0]).cell[0], always_plus_1(2, 1.0)),
            (2, 3)
        );
        let down = step([-1.0, 0.0, 0.0]);
        assert_eq!((down.cell[0], down.next[0]), (2, 0.5));
        let wrong = f64::from(always_plus_1(2, -1.0));
        assert_eq!((wrong - 2.5) / -1.0, -0.5);
    }

    #[test]
    fn a_hit_ends_the_walk_if_it_lies_in_its_cell() {
        // a hit at 5 with a cell that ends at 3, then at 6
        assert_eq!([is_passed(5.0, 3.0), is_passed(5.0, 6.0)], [false, true]);
        let wrong = [3.0, 6.0].map(|t_out| first_cell_with_a_hit(5.0, t_out));
        assert_eq!(wrong, [true, true]);
        assert!(!is_passed(f64::INFINITY, 3.0) && !first_cell_with_a_hit(f64::INFINITY, 3.0));
    }
}
