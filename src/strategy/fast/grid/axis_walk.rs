//! The walk of a ray along one axis of a grid: from plane to plane, always one way.

use crate::strategy::fast::grid::one_way::OneWay;
use crate::structure::Meeting;

/// A walk along one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AxisWalk<'g> {
    origin: f64,
    direction: f64,
    /// 1/Δ.
    inverse: f64,
    /// To the next cell's number, as a wrapping number.
    to_cell: usize,
    /// The plane behind the cell, the next one, the one behind that, and so on.
    ahead: &'g [f64],
}

impl<'g> AxisWalk<'g> {
    /// From a cell, along an axis.
    #[inline]
    pub(super) fn new(
        way: &'g OneWay,
        cell: usize,
        origin: f64,
        direction: f64,
        inverse: f64,
    ) -> Self {
        Self {
            origin,
            direction,
            inverse,
            to_cell: way.to_cell,
            ahead: way.ahead(cell),
        }
    }

    /// t of the plane behind the cell, of the next one and of the one behind that.
    #[inline]
    pub(super) fn first_three(&self) -> [f64; 3] {
        let planes = &self.ahead[..3];
        [planes[0], planes[1], planes[2]].map(|plane| self.meets(plane))
    }

    /// t = (pᵢ − o)/Δ.
    #[inline]
    fn meets(&self, plane: f64) -> f64 {
        (plane - self.origin) * self.inverse
    }

    /// Goes on behind the next plane, and says t of the plane that is the one behind the next one there; `None` if the
    /// next plane leads out of the grid.
    #[inline]
    pub(super) fn cross(&mut self) -> Option<f64> {
        let [_, _, _, after, ..] = *self.ahead else {
            return None;
        };
        self.ahead = &self.ahead[1..];
        Some(self.meets(after))
    }

    /// The number of the cell behind the next plane, from that of the one before it.
    #[inline]
    pub(super) fn next_cell(&self, number: usize) -> usize {
        number.wrapping_add(self.to_cell)
    }

    /// The ray and the next plane.
    pub(super) fn meeting(&self) -> Meeting {
        Meeting {
            plane: self.ahead[1],
            origin: self.origin,
            direction: self.direction,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::AxisBox;
    use crate::strategy::fast::grid::one_way::Ways;
    use crate::structure::CellPlanes;
    use glam::DVec3;

    /// Three cells along y, from 1 to 7, of a grid with 10 along x.
    fn ways() -> Ways {
        let (min, max) = (DVec3::new(0.0, 1.0, 0.0), DVec3::new(10.0, 7.0, 1.0));
        Ways::new(&CellPlanes::new(&AxisBox { min, max }, [10, 3, 1]))
    }

    #[test]
    fn a_walk_upwards_meets_the_planes_from_the_lowest_on() {
        let ways = ways();
        let way = ways.of(DVec3::Y)[1];
        // y = 2 + t/2: 1 at −2, 3 at 2, 5 at 6, 7 at 10
        let mut walk = AxisWalk::new(way, 1, 2.0, 0.5, 2.0);
        assert_eq!(walk.first_three(), [2.0, 6.0, 10.0]);
        assert_eq!((walk.meeting().plane, walk.meeting().t()), (5.0, 6.0));
        // behind the next plane the plane after the next one is the end of the world
        assert_eq!(walk.cross(), Some(f64::INFINITY));
        assert_eq!((walk.meeting().plane, walk.meeting().t()), (7.0, 10.0));
        assert_eq!(walk.next_cell(10), 20);
        assert_eq!(walk.cross(), None);
    }

    #[test]
    fn a_walk_downwards_meets_them_from_the_highest_on() {
        let ways = ways();
        let way = ways.of(DVec3::NEG_Y)[1];
        // from the highest cell, y = 8 − 2t: 7 at ½, 5 at 1½, 3 at 2½, 1 at 3½
        let mut walk = AxisWalk::new(way, 0, 8.0, -2.0, -0.5);
        assert_eq!(walk.first_three(), [f64::NEG_INFINITY, 1.5, 2.5]);
        assert_eq!(walk.cross(), Some(3.5));
        assert_eq!(walk.next_cell(20), 10);
        assert_eq!((walk.meeting().plane, walk.meeting().t()), (3.0, 2.5));
    }
}
