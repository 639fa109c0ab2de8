//! The box around an object, by which the builds compare volumes whatever slabs the bounds will have.

use glam::DVec3;

use crate::scene::Shape;
use crate::structure::bounds::extremes::{larger, smaller};
use crate::structure::bounds::widened_box;

/// min ≤ p ≤ max.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::structure) struct Solid {
    pub(in crate::structure) min: DVec3,
    pub(in crate::structure) max: DVec3,
}

impl Solid {
    /// Around nothing.
    pub(in crate::structure) const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// Around a shape, with a little room: so flat things have a volume too, and of equal volumes that nearer to the
    /// origin is the smaller one.
    pub(in crate::structure) fn of(shape: &Shape) -> Self {
        let [min, max] = widened_box(shape);
        Self { min, max }
    }

    /// Around both.
    #[inline]
    pub(in crate::structure) fn union(&self, other: &Self) -> Self {
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
    pub(in crate::structure) fn around_points(points: impl Iterator<Item = DVec3>) -> Self {
        let at = |point| Self {
            min: point,
            max: point,
        };
        points.fold(Self::EMPTY, |sum, point| sum.union(&at(point)))
    }

    /// Half its surface: the share of random rays that meet it grows with that. 0 around nothing.
    #[inline]
    pub(in crate::structure) fn half_area(&self) -> f64 {
        let side = self.max - self.min;
        if side.x < 0.0 {
            return 0.0;
        }
        side.x * side.y + side.y * side.z + side.z * side.x
    }

    /// Twice its center: enough to compare places.
    #[inline]
    pub(in crate::structure) fn doubled_center(&self) -> DVec3 {
        self.min + self.max
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sphere;

    #[test]
    fn half_the_surface_of_a_box_with_sides_2_3_5_is_31() {
        // 2·3 + 3·5 + 5·2, wherever it lies
        for corner in [DVec3::ZERO, DVec3::new(1.0, -7.0, 4.0)] {
            let solid = Solid {
                min: corner,
                max: corner + DVec3::new(2.0, 3.0, 5.0),
            };
            assert_eq!(solid.half_area(), 31.0);
            assert_eq!(
                solid.doubled_center(),
                2.0 * corner + DVec3::new(2.0, 3.0, 5.0)
            );
        }
    }

    #[test]
    fn a_flat_box_has_the_area_of_its_two_faces_and_nothing_has_none() {
        let flat = Solid {
            min: DVec3::new(1.0, 1.0, 1.0),
            max: DVec3::new(1.0, 3.0, 4.0),
        };
        assert_eq!(flat.half_area(), 6.0);
        assert_eq!(Solid::EMPTY.half_area(), 0.0);
    }

    #[test]
    fn the_box_of_two_boxes_has_the_smaller_and_the_larger_corner_of_both() {
        let a = Solid {
            min: DVec3::new(1.0, 5.0, 3.0),
            max: DVec3::new(4.0, 6.0, 9.0),
        };
        let b = Solid {
            min: DVec3::new(2.0, 2.0, 2.0),
            max: DVec3::new(3.0, 8.0, 7.0),
        };
        let both = Solid {
            min: DVec3::new(1.0, 2.0, 2.0),
            max: DVec3::new(4.0, 8.0, 9.0),
        };
        assert_eq!(a.union(&b), both);
        assert_eq!(b.union(&a), both);
        assert_eq!(Solid::EMPTY.union(&a), a);
        let corners = [a.min, b.max, DVec3::new(4.0, 2.0, 9.0)];
        let around = Solid {
            min: DVec3::new(1.0, 2.0, 3.0),
            max: DVec3::new(4.0, 8.0, 9.0),
        };
        assert_eq!(Solid::around_points(corners.into_iter()), around);
    }

    #[test]
    fn the_box_around_a_shape_is_wider_by_a_share_of_its_coordinates() {
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::new(5.0, 10.0, 1.0),
            radius: 2.0,
        });
        // 10⁻¹⁰ of 10 + 2
        let room = 1.2e-9;
        let Solid { min, max } = Solid::of(&sphere);
        let off = (min - (DVec3::new(3.0, 8.0, -1.0) - room)).abs();
        assert!(off.max_element() <= ROUNDING, "{min}");
        let off = (max - (DVec3::new(7.0, 12.0, 3.0) + room)).abs();
        assert!(off.max_element() <= ROUNDING, "{max}");
    }

    /// Two roundings of coordinates up to 12.
    const ROUNDING: f64 = 4e-15;
}
