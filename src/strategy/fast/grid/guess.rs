//! Where the walk of a ray through a grid begins, as far as plain arithmetic can decide.

use glam::DVec3;

use crate::geometry::{Ray, TRange, larger, smaller};
use crate::strategy::fast::grid::one_way::OneWay;
use crate::structure::just_after;

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
/// far, as [`AxisBox::inside`](crate::geometry::AxisBox::inside) has it; with 1/Δ at hand and the planes in the ray's order it
/// stands apart for speed. Along each axis (x₀ + t₀·Δx − from) times the cells for a unit of length says in which cell it is then.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::AxisBox;
    use crate::strategy::fast::grid::one_way::Ways;
    use crate::structure::CellPlanes;

    /// 4 × 2 × 3 cells from (1, 2, 3) to (5, 4, 9).
    fn guess_of(origin: [f64; 3], direction: [f64; 3], range: TRange) -> Guess {
        let (min, max) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(5.0, 4.0, 9.0));
        let ways = Ways::new(&CellPlanes::new(&AxisBox { min, max }, [4, 2, 3]));
        let ray = Ray::new(origin.into(), direction.into());
        guess(ways.of(ray.direction), &ray, 1.0 / ray.direction, range)
    }

    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], range: TRange, cell: [usize; 3], t: f64) {
        match guess_of(origin, direction, range) {
            Guess::Cell(start) => assert_eq!((start.cell, start.t), (cell, t)),
            other => panic!("{other:?}"),
        }
    }

    const UP: [f64; 3] = [1.0, 1.0, 2.0];
    const DOWN: [f64; 3] = [-1.0, -1.0, -2.0];

    #[test]
    fn the_first_cell_is_the_one_at_the_largest_near() {
        // y = 2 at t = 2, where x = 2.5 is in the second cell and z = 6.5 too, of sides of 2
        check([0.5, 0.0, 2.5], UP, TRange::FORWARD, [1, 0, 1], 2.0);
        // from above: y = 4 at t = 2, where x = 3.5 and z = 5.5 are in the second cells from above
        check([5.5, 6.0, 9.5], DOWN, TRange::FORWARD, [1, 0, 1], 2.0);
        // x = 1 at t = 2, where y = 3.25 and z = 7.5; z = 3 at t = 2, where x = 4.5 and y = 2.25
        check([-1.0, 1.25, 3.5], UP, TRange::FORWARD, [0, 1, 2], 2.0);
        check([2.5, 0.25, -1.0], UP, TRange::FORWARD, [3, 0, 0], 2.0);
    }

    #[test]
    fn a_ray_that_starts_inside_begins_at_its_own_start() {
        check([1.5, 2.5, 5.5], UP, TRange::FORWARD, [0, 0, 1], 0.0);
        // from t = ¾ on: x = 2.25, y = 3.25, z = 7
        let later = TRange {
            min: 0.75,
            ..TRange::FORWARD
        };
        check([1.5, 2.5, 5.75], UP, later, [1, 1, 2], 0.75);
        // nothing before 0 counts
        let before = TRange {
            min: -0.5,
            ..TRange::FORWARD
        };
        check([1.5, 2.5, 5.5], UP, before, [0, 0, 1], 0.0);
    }

    #[test]
    fn what_lies_beyond_the_grid_or_the_range_is_passed_by() {
        let passes = |origin: [f64; 3], direction, range| {
            matches!(guess_of(origin, direction, range), Guess::PassesBy)
        };
        // y = 4 at t = ½, before x = 1 at t = 1
        assert!(passes([0.0, 3.5, 2.5], UP, TRange::FORWARD));
        // the grid lies behind
        assert!(passes([6.0, 6.0, 9.5], UP, TRange::FORWARD));
        // the range ends at 1.5, and the grid begins at 2; z = 9 at 3.25, and the range begins later
        assert!(passes([0.5, 0.0, 2.5], UP, TRange::FORWARD.up_to(1.5)));
        let late = TRange {
            min: 3.5,
            ..TRange::FORWARD
        };
        assert!(passes([0.5, 0.0, 2.5], UP, late));
    }

    #[test]
    fn a_ray_that_touches_an_edge_is_not_decided() {
        // y = 4 and x = 1 at t = 1; and a range that ends where the grid begins
        let unsure = |origin: [f64; 3], range| matches!(guess_of(origin, UP, range), Guess::Unsure);
        assert!(unsure([0.0, 3.0, 2.5], TRange::FORWARD));
        assert!(unsure([0.5, 0.0, 2.5], TRange::FORWARD.up_to(2.0)));
    }

    #[test]
    fn cells_are_passed_at_the_speed_of_the_ray_along_each_axis() {
        // y = 2 at t = 4, where x = 2.5 and z = 8.5
        let slow = [0.25, 0.5, 1.5];
        check([1.5, 0.0, 2.5], slow, TRange::FORWARD, [1, 0, 2], 4.0);
    }
}
