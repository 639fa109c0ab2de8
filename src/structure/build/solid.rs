//! The box around an object, by which the builds compare volumes whatever slabs the bounds will have.

use glam::DVec3;

use crate::scene::Shape;
use crate::structure::extent::box_around;

/// min ≤ p ≤ max.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Solid {
    pub(super) min: DVec3,
    pub(super) max: DVec3,
}

impl Solid {
    /// Around nothing.
    pub(super) const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// Around a shape.
    pub(super) fn of(shape: &Shape) -> Self {
        let [min, max] = box_around(shape);
        Self { min, max }
    }

    /// Around both.
    #[inline]
    pub(super) fn union(&self, other: &Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Half its surface: the share of random rays that meet it grows with that. 0 around nothing.
    #[inline]
    pub(super) fn half_area(&self) -> f64 {
        let side = (self.max - self.min).max(DVec3::ZERO);
        side.x * side.y + side.y * side.z + side.z * side.x
    }

    /// Twice its center: enough to compare places.
    #[inline]
    pub(super) fn doubled_center(&self) -> DVec3 {
        self.min + self.max
    }
}
