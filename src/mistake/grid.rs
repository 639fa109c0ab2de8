//! The walk through a grid, and where it ends.

use crate::geometry::{AxisBox, Ray, TRange};
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
    Mistake {
        name: "no end test",
        sentence: "The walk does not end when the nearest hit lies in its cell, so every cell up to the end of the grid is visited.",
        spoils: "number of cells",
        wrong: Wrong::WalkEnds(never),
    },
    Mistake {
        name: "one cell per column",
        sentence: "The walk draws a line as on a screen, one cell in each column, and skips other cells that the ray passes through.",
        spoils: "next cell",
        wrong: Wrong::CellsVisited(one_cell_per_column),
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

fn never(_nearest: f64, _t_out: f64) -> bool {
    false
}

/// The line-drawing algorithm (J. Bresenham 1965): along the axis on which the ray passes most cells, the cell in which the ray
/// is at the middle of each column.
fn one_cell_per_column(
    around: &AxisBox,
    resolution: [u32; 3],
    ray: &Ray,
    range: TRange,
) -> Vec<[u32; 3]> {
    let Some([t_in, t_out]) = around.inside(ray) else {
        return Vec::new();
    };
    let (t_in, t_out) = (t_in.max(range.min), t_out.min(range.max));
    if t_out < t_in {
        return Vec::new();
    }
    let side = |axis: usize| {
        let [low, high] = around.along(axis);
        (high - low) / f64::from(resolution[axis])
    };
    // in cells from the grid's lower corner
    let coordinate = |axis: usize, t: f64| (ray.at(t)[axis] - around.along(axis)[0]) / side(axis);
    let cell = |axis: usize, t: f64| {
        let last = f64::from(resolution[axis]) - 1.0;
        coordinate(axis, t).floor().clamp(0.0, last) as u32
    };
    let speed = |axis: usize| (ray.direction[axis] / side(axis)).abs();
    let main = (0..3).fold(0, |most, axis| {
        if speed(most) < speed(axis) {
            axis
        } else {
            most
        }
    });
    let (first, last) = (cell(main, t_in), cell(main, t_out));
    let columns: Vec<u32> = if first <= last {
        (first..=last).collect()
    } else {
        (last..=first).rev().collect()
    };
    let visited = columns.into_iter().map(|column| {
        let away = f64::from(column) + 0.5 - coordinate(main, t_in);
        let t = t_in + away * side(main) / ray.direction[main];
        // in the first and the last column the ray may not come to the middle
        let t = if t.is_finite() {
            t.clamp(t_in, t_out)
        } else {
            t_in
        };
        [0, 1, 2].map(|axis| if axis == main { column } else { cell(axis, t) })
    });
    visited.collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
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
        assert_eq!([3.0, 6.0].map(|t_out| never(5.0, t_out)), [false, false]);
        assert!(!is_passed(f64::INFINITY, 3.0) && !first_cell_with_a_hit(f64::INFINITY, 3.0));
    }

    #[test]
    fn a_line_on_a_screen_has_one_cell_in_each_column_where_the_ray_passes_two() {
        let around = AxisBox::around([DVec3::ZERO, DVec3::splat(4.0)]);
        let planes = CellPlanes::new(&around, [4; 3]);
        let of = |origin: [f64; 3], direction: [f64; 3], range: TRange| {
            let ray = Ray::new(origin.into(), direction.into());
            let right: Vec<_> = GridWalk::new(&planes, &ray, range)
                .map(|step| step.cell)
                .collect();
            [right, one_cell_per_column(&around, [4; 3], &ray, range)]
        };
        let flat = |cells: &[[u32; 2]]| -> Vec<[u32; 3]> {
            cells.iter().map(|&[i, j]| [i, j, 0]).collect()
        };
        // y = ½ + 0.9·x: 0.95, 1.85, 2.75, 3.65 in the middle of the columns
        let [right, wrong] = of([0.0, 0.5, 0.5], [1.0, 0.9, 0.0], TRange::FORWARD);
        let all = [[0, 0], [0, 1], [1, 1], [1, 2], [2, 2], [2, 3], [3, 3]];
        assert_eq!(right, flat(&all));
        assert_eq!(wrong, flat(&[[0, 0], [1, 1], [2, 2], [3, 3]]));
        // the same line from its other end
        let [right, wrong] = of([4.0, 4.1, 0.5], [-1.0, -0.9, 0.0], TRange::FORWARD);
        assert_eq!(right.iter().rev().copied().collect::<Vec<_>>(), flat(&all));
        assert_eq!(wrong, flat(&[[3, 3], [2, 2], [1, 1], [0, 0]]));
        // along an axis a column is a cell, and the range ends both
        let straight = of([0.5; 3], [0.0, 1.0, 0.0], TRange::FORWARD.up_to(2.0));
        assert_eq!(
            straight,
            [0, 1].map(|_| vec![[0, 0, 0], [0, 1, 0], [0, 2, 0]])
        );
        let past = of([9.0; 3], [1.0, 0.0, 0.0], TRange::FORWARD);
        assert!(past.iter().all(Vec::is_empty), "{past:?}");
    }
}
