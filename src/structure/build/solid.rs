//! The box around an object, by which the builds compare volumes whatever slabs the bounds will have.

use glam::DVec3;

use crate::scene::Shape;
use crate::structure::extent::widened_box;
use crate::structure::extremes::{larger, smaller};

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

    /// Around a shape, with a little room: so flat things have a volume too, and of equal volumes that nearer to the
    /// origin is the smaller one.
    pub(super) fn of(shape: &Shape) -> Self {
        let [min, max] = widened_box(shape);
        Self { min, max }
    }

    /// Around both.
    #[inline]
    pub(super) fn union(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        // not by the least of vectors, which looks out for NaN
        Self {
            min: DVec3::new(
                smaller(a.min.x, b.min.x),
                smaller(a.min.y, b.min.y),
                smaller(a.min.z, b.min.z),
            ),
            max: DVec3::new(
                larger(a.max.x, b.max.x),
                larger(a.max.y, b.max.y),
                larger(a.max.z, b.max.z),
            ),
        }
    }

    /// Around points.
    pub(super) fn around_points(points: impl Iterator<Item = DVec3>) -> Self {
        let at = |point| Self {
            min: point,
            max: point,
        };
        points.fold(Self::EMPTY, |sum, point| sum.union(&at(point)))
    }

    /// Half its surface: the share of random rays that meet it grows with that. 0 around nothing.
    #[inline]
    pub(super) fn half_area(&self) -> f64 {
        let side = self.max - self.min;
        if side.x < 0.0 {
            return 0.0;
        }
        side.x * side.y + side.y * side.z + side.z * side.x
    }

    /// Twice its center: enough to compare places.
    #[inline]
    pub(super) fn doubled_center(&self) -> DVec3 {
        self.min + self.max
    }
}
