//! The walk of a ray along one axis of a grid: from plane to plane, always one way.

use crate::structure::cell_planes::{CellPlanes, CellsAlong};
use crate::structure::ray_order::Meeting;

/// A walk along one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AxisWalk {
    origin: f64,
    direction: f64,
    /// 1/Δ.
    inverse: f64,
    /// The place of the next plane among all planes.
    plane: usize,
    /// The place of the outer plane through which the ray leaves the grid.
    last: usize,
    /// To the next plane: 1, or −1 as a wrapping number.
    to_plane: usize,
    /// To the next cell's number, likewise.
    to_cell: usize,
}

impl AxisWalk {
    /// From a cell, along an axis.
    #[inline]
    pub(super) fn new(
        along: &CellsAlong,
        at: usize,
        origin: f64,
        direction: f64,
        inverse: f64,
    ) -> Self {
        let below = along.first_plane + at;
        // no jump depends on which way the ray goes: that cannot be foretold
        let downwards = direction.is_sign_negative();
        let one_way = |by: usize| if downwards { by.wrapping_neg() } else { by };
        let last = if downwards { 0 } else { along.count as usize };
        Self {
            origin,
            direction,
            inverse,
            plane: below + usize::from(!downwards),
            last: along.first_plane + last,
            to_plane: one_way(1),
            to_cell: one_way(along.stride),
        }
    }

    /// t of the next plane.
    #[inline]
    pub(super) fn next(&self, cells: &CellPlanes) -> f64 {
        self.meets(cells, self.plane)
    }

    /// t of the plane behind the next one.
    #[inline]
    pub(super) fn after(&self, cells: &CellPlanes) -> f64 {
        self.meets(cells, self.plane.wrapping_add(self.to_plane))
    }

    /// t of the plane through which the ray came into the cell: −∞ if that is the outermost one, before which no walk
    /// begins.
    #[inline]
    pub(super) fn entered(&self, along: &CellsAlong, cells: &CellPlanes) -> f64 {
        let behind = self.plane.wrapping_sub(self.to_plane);
        let outermost = if self.direction.is_sign_negative() {
            along.count as usize
        } else {
            0
        };
        let place = if behind == along.first_plane + outermost {
            behind.wrapping_sub(self.to_plane)
        } else {
            behind
        };
        self.meets(cells, place)
    }

    /// t = (pᵢ − o)/Δ of the plane in this place.
    #[inline]
    fn meets(&self, cells: &CellPlanes, plane: usize) -> f64 {
        (cells.plane(plane) - self.origin) * self.inverse
    }

    /// Does the next plane lead out of the grid?
    #[inline]
    pub(super) fn is_last(&self) -> bool {
        self.plane == self.last
    }

    /// Goes on behind the next plane; the cell's number there, from the one before it.
    #[inline]
    pub(super) fn cross(&mut self, number: usize) -> usize {
        self.plane = self.plane.wrapping_add(self.to_plane);
        number.wrapping_add(self.to_cell)
    }

    /// The ray and the next plane.
    pub(super) fn meeting(&self, cells: &CellPlanes) -> Meeting {
        Meeting {
            plane: cells.plane(self.plane),
            origin: self.origin,
            direction: self.direction,
        }
    }
}
