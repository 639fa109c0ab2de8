//! The even-odd count of a projected outline, with rules of one's own.

use glam::{DVec2, DVec3};

use crate::geometry::{Axis, Polygon};

/// Does an edge reach the height of p′, by the ends' heights less that of p′?
pub(super) type Straddles = fn(f64, f64) -> bool;

/// Is a point inside the outline that is left when a coordinate is dropped?
pub(super) fn inside_along(polygon: &Polygon, point: DVec3, dropped: Axis) -> bool {
    let corners: Vec<DVec2> = polygon.vertices().map(|v| dropped.drop_from(v)).collect();
    let straddles: Straddles = |from, to| (0.0 < from) != (0.0 < to);
    crossings(&corners, dropped.drop_from(point), straddles) % 2 == 1
}

/// How many edges cross the half-line from p′ along the first coordinate?
///
/// An edge counts if it reaches the height of p′ and passes it there on the side of larger coordinates. Of a level edge
/// the first end is taken.
pub(super) fn crossings(corners: &[DVec2], p: DVec2, straddles: Straddles) -> usize {
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next);
    let counts = |&(from, to): &(&DVec2, &DVec2)| {
        if !straddles(from.y - p.y, to.y - p.y) {
            return false;
        }
        let rise = to.y - from.y;
        let share = if rise == 0.0 {
            0.0
        } else {
            (p.y - from.y) / rise
        };
        p.x < from.x + share * (to.x - from.x)
    };
    edges.filter(counts).count()
}
