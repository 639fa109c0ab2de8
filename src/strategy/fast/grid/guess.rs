//! Where the walk of a ray through a grid begins, as far as plain arithmetic can tell.

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::strategy::fast::grid::one_way::OneWay;
use crate::structure::extremes::{larger, smaller};
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
