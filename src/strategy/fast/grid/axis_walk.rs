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
