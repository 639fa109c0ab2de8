//! The planes across an axis of a grid in the order in which rays hit them that all go the same way along it.
//!
//! Upwards and downwards a walk is the same, but for the order of the planes and the sign of the step. So each axis
//! has both orders at hand, a ray takes one of them, and from there on nothing asks for its direction.

use glam::DVec3;

use crate::structure::CellPlanes;

/// The ways through a grid: along x, y and z, each upwards and downwards.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Ways([[OneWay; 2]; 3]);

impl Ways {
    /// Those through these cells.
    pub(super) fn new(cells: &CellPlanes) -> Self {
        if cells.is_empty() {
            return Self::default();
        }
        let strides = cells.strides();
        Self([0, 1, 2].map(|axis| {
            let planes = cells.axis(axis);
            [
                OneWay::up(planes, strides[axis]),
                OneWay::down(planes, strides[axis]),
            ]
        }))
    }

    /// The way of a ray along each axis; a zero of either sign counts as its sign says.
    #[inline]
    pub(super) fn of(&self, direction: DVec3) -> [&OneWay; 3] {
        let [x, y, z] = &self.0;
        let sign = |direction: f64| usize::from(direction.is_sign_negative());
        [
            &x[sign(direction.x)],
            &y[sign(direction.y)],
            &z[sign(direction.z)],
        ]
    }

    /// How much memory the planes take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.0.as_flattened().iter().map(OneWay::bytes).sum()
    }
}

/// The cells along an axis, as rays come through them that all go the same way.
///
/// Cells are counted as they are entered: cell 0 is the lowest upwards, and the highest downwards.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct OneWay {
    /// The outer plane through which such a ray comes in.
    pub(super) from: f64,
    /// The one through which it goes out.
    pub(super) to: f64,
    /// Cells for each unit of length; below 0 downwards.
    pub(super) per_unit: f64,
    /// How much of a cell's number cell 0 stands for.
    pub(super) first_number: usize,
    /// By how much the number grows from one cell to the next, as a wrapping number.
    pub(super) to_cell: usize,
    /// The last cell.
    pub(super) last: u32,
    /// −∞ (downwards ∞) in the place of `from`, before which no walk begins; each plane up to `to`; and one that no
    /// ray hits, for a walk that looks one plane too far.
    planes: Box<[f64]>,
}

impl OneWay {
    /// Upwards through planes that rise.
    fn up(planes: &[f64], stride: usize) -> Self {
        Self::along(planes.iter().copied(), f64::INFINITY, 0, stride)
    }

    /// Downwards through planes that rise.
    fn down(planes: &[f64], stride: usize) -> Self {
        let cells = planes.len() - 1;
        let highest = (cells - 1) * stride;
        Self::along(
            planes.iter().rev().copied(),
            f64::NEG_INFINITY,
            highest,
            stride.wrapping_neg(),
        )
    }

    /// Through at least two planes in this order, and on to the end of the world.
    fn along(
        planes: impl ExactSizeIterator<Item = f64> + Clone,
        end: f64,
        first_number: usize,
        to_cell: usize,
    ) -> Self {
        let cells = planes.len() - 1;
        let mut ends = planes.clone();
        let from = ends.next().unwrap_or_default();
        let to = ends.last().unwrap_or_default();
        Self {
            from,
            to,
            per_unit: cells as f64 / (to - from),
            first_number,
            to_cell,
            last: cells as u32 - 1,
            planes: [-end]
                .into_iter()
                .chain(planes.skip(1))
                .chain([end])
                .collect(),
        }
    }

    /// The planes that lie ahead in a cell, led by the one behind it: so the second one is hit next.
    #[inline]
    pub(super) fn ahead(&self, cell: usize) -> &[f64] {
        &self.planes[cell..]
    }

    /// A cell counted from the lowest, as it is counted along the way.
    pub(super) fn along_from_lowest(&self, cell: usize) -> usize {
        if self.per_unit < 0.0 {
            self.last as usize - cell
        } else {
            cell
        }
    }

    /// How much of a cell's number a cell along the way stands for, as a wrapping number.
    #[inline]
    pub(super) fn number(&self, cell: usize) -> usize {
        self.first_number
            .wrapping_add(cell.wrapping_mul(self.to_cell))
    }

    /// How much memory the planes take, in bytes.
    fn bytes(&self) -> usize {
        size_of_val(&*self.planes)
    }

    /// The cell at this number of cells behind `from`; the first or the last if that is outside.
    #[inline]
    pub(super) fn cell_at(&self, sides: f64) -> usize {
        // a conversion to whole numbers cuts off what does not fit
        (sides as u32).min(self.last) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::AxisBox;

    /// Three cells along y of a grid with 10 along x.
    fn ways() -> [OneWay; 2] {
        let planes = [1.0, 3.0, 5.0, 7.0];
        [OneWay::up(&planes, 10), OneWay::down(&planes, 10)]
    }

    #[test]
    fn the_planes_lie_ahead_in_the_order_in_which_they_are_met() {
        const INF: f64 = f64::INFINITY;
        let [up, down] = ways();
        assert_eq!(up.ahead(0), [-INF, 3.0, 5.0, 7.0, INF]);
        assert_eq!(up.ahead(2), [5.0, 7.0, INF]);
        assert_eq!(down.ahead(0), [INF, 5.0, 3.0, 1.0, -INF]);
        assert_eq!(down.ahead(2), [3.0, 1.0, -INF]);
    }

    #[test]
    fn a_cell_has_the_same_number_both_ways() {
        let [up, down] = ways();
        assert_eq!([0, 1, 2].map(|cell| up.number(cell)), [0, 10, 20]);
        assert_eq!([0, 1, 2].map(|cell| down.number(cell)), [20, 10, 0]);
        assert_eq!(down.number(0).wrapping_add(down.to_cell), 10);
    }

    #[test]
    fn cells_are_counted_from_where_the_ray_comes_in() {
        // sides of 2: 3 units behind the first plane is in the second cell
        for way in ways() {
            let sides = |units: f64| way.per_unit.abs() * units;
            let found = [-1.0, 0.5, 3.0, 5.5, 8.0].map(|units| way.cell_at(sides(units)));
            assert_eq!(found, [0, 0, 1, 2, 2]);
        }
    }

    #[test]
    fn ways_know_their_ends_their_cells_and_how_numbers_grow() {
        let [up, down] = ways();
        assert_eq!((up.from, up.to, up.per_unit, up.last), (1.0, 7.0, 0.5, 2));
        assert_eq!(
            (down.from, down.to, down.per_unit, down.last),
            (7.0, 1.0, -0.5, 2)
        );
        assert_eq!([0, 1, 2].map(|cell| up.along_from_lowest(cell)), [0, 1, 2]);
        assert_eq!(
            [0, 1, 2].map(|cell| down.along_from_lowest(cell)),
            [2, 1, 0]
        );
        // the end of the world in place of the first plane, three planes, the end of the world
        assert_eq!(up.bytes(), 40);
    }

    #[test]
    fn a_ray_takes_the_way_of_its_sign_along_each_axis() {
        let cells = CellPlanes::new(
            &AxisBox::around([DVec3::ZERO, DVec3::new(2.0, 4.0, 6.0)]),
            [1, 2, 3],
        );
        let ways = Ways::new(&cells);
        let from = |direction: DVec3| ways.of(direction).map(|way| (way.from, way.to));
        let found = from(DVec3::new(1.0, -1.0, 0.0));
        assert_eq!(found, [(0.0, 2.0), (4.0, 0.0), (0.0, 6.0)]);
        let found = from(DVec3::new(-1.0, 0.0, -0.0));
        assert_eq!(found, [(2.0, 0.0), (0.0, 4.0), (6.0, 0.0)]);
        // 2 + 3 + 4 planes and three more ends of the world, each both ways
        assert_eq!(ways.bytes(), 2 * 8 * (2 + 3 + 4 + 3));
        assert_eq!(Ways::new(&CellPlanes::default()).bytes(), 0);
    }
}
