//! Lesson 6: the polygon.
//!
//! - plane: A·x + B·y + C·z + D = 0 … (iv)
//! - t: where the ray hits the plane … (v)
//! - p: the point o + t·Δ
//! - axis: the coordinate that is dropped
//! - p′: p without that coordinate
//! - crossings: the edges that cross the half-line from p′
//! - inside or outside: an odd number of crossings means inside

use glam::{DVec2, DVec3};
use raystep::geometry::{Axis, Polygon, Ray, Sides, TRange};

/// t of the polygon's plane, if it counts: 0 < t and `range.min` ≤ t ≤ `range.max`. A parallel ray has none.
///
/// `polygon.plane()` has `normal`, which is (A, B, C) of unit length, and `d`. `_sides` says which sides of a surface can be
/// seen; here both can.
pub fn plane_t(polygon: &Polygon, ray: &Ray, range: TRange, _sides: Sides) -> Option<f64> {
    todo!()
}

/// The axis whose coordinate the projection drops. `normal` is (A, B, C); `v.abs()` has the absolute values.
pub fn dropped_axis(normal: DVec3) -> Axis {
    todo!()
}

/// How many edges cross the half-line from p′ towards larger x?
///
/// `outline` has the projected vertices in order; the last one is joined with the first. Only whether the number is odd matters.
pub fn crossings(outline: &[DVec2], p: DVec2) -> usize {
    todo!()
}

/// Does the point at t lie inside the polygon?
///
/// `polygon.dropped()` is the axis, `axis.drop_from(point)` a point without that coordinate, `polygon.outline()` the vertices
/// without it.
pub fn inside(polygon: &Polygon, ray: &Ray, t: f64) -> bool {
    todo!()
}
