//! Point in polygon (Fig. 15.57): which axis is dropped, and which edges count.

use glam::{DVec2, DVec3};

use crate::geometry::{Axis, Polygon, Ray};
use crate::mistake::outline::{Straddles, crossings};
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "axis of the smallest coefficient",
        sentence: "The coordinate with the smallest coefficient is dropped, so the outline may shrink to a line.",
        spoils: "dropped axis",
        wrong: Wrong::DroppedAxis(smallest_coefficient),
    },
    Mistake {
        name: "vertex twice",
        sentence: "A vertex at the height of p′ counts for both edges that end in it.",
        spoils: "crossings",
        wrong: Wrong::Inside(vertex_twice),
    },
    Mistake {
        name: "≤ at both ends",
        sentence: "An edge counts if p′ is at the height of one of its ends or between them, and so does a level edge.",
        spoils: "crossings",
        wrong: Wrong::Inside(closed_at_both_ends),
    },
];

fn smallest_coefficient(normal: DVec3) -> Axis {
    Axis::of_smallest(normal)
}

fn vertex_twice(polygon: &Polygon, ray: &Ray, t: f64) -> bool {
    is_inside(polygon, ray, t, |from, to| {
        from != to && from.min(to) <= 0.0 && 0.0 <= from.max(to)
    })
}

fn closed_at_both_ends(polygon: &Polygon, ray: &Ray, t: f64) -> bool {
    is_inside(polygon, ray, t, |from, to| {
        from.min(to) <= 0.0 && 0.0 <= from.max(to)
    })
}

fn is_inside(polygon: &Polygon, ray: &Ray, t: f64, straddles: Straddles) -> bool {
    let p: DVec2 = polygon.dropped().drop_from(ray.at(t));
    crossings(polygon.outline(), p, straddles) % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mistake::outline::inside_along;

    /// Inside of the outline at z = 0, by the right function and both mistakes: a ray along z through (x, y).
    fn inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> [bool; 3] {
        let corners = corners.iter().map(|&[x, y]| DVec3::new(x, y, 0.0));
        let polygon = Polygon::new(corners.collect(), None).unwrap();
        let ray = Ray::new(DVec3::new(x, y, 5.0), DVec3::NEG_Z);
        [
            polygon.contains(&ray, 5.0).inside,
            vertex_twice(&polygon, &ray, 5.0),
            closed_at_both_ends(&polygon, &ray, 5.0),
        ]
    }

    #[test]
    fn a_vertex_and_a_level_edge_at_the_height_of_the_point_count_once_or_not_at_all() {
        let diamond = [[2.0, 0.0], [0.0, 2.0], [-2.0, 0.0], [0.0, -2.0]];
        // the half-line from the middle passes the vertex (2, 0)
        assert_eq!(inside(&diamond, [0.0, 0.0]), [true, false, false]);
        assert_eq!(inside(&diamond, [0.0, 0.5]), [true; 3]);
        assert_eq!(inside(&diamond, [3.0, 0.5]), [false; 3]);
        // left of a square, level with its upper edge: two upright edges, and the level one makes three
        let square = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
        assert_eq!(inside(&square, [-3.0, 1.0]), [false, false, true]);
        assert_eq!(inside(&square, [-3.0, 0.5]), [false; 3]);
    }

    #[test]
    fn an_outline_without_its_longest_coordinate_has_no_inside() {
        let normal = DVec3::new(0.6, 0.0, 0.8);
        assert_eq!(Axis::of_largest(normal), Axis::Z);
        assert_eq!(smallest_coefficient(normal), Axis::Y);
        // of three equal coefficients both take the first
        assert_eq!(
            smallest_coefficient(DVec3::ONE),
            Axis::of_largest(DVec3::ONE)
        );
        // (1, 1, 0) in a square at z = 0: without x or y a line is left
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let square = square.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let square = Polygon::new(square, None).unwrap();
        let p = DVec3::new(1.0, 1.0, 0.0);
        let found = [Axis::X, Axis::Y, Axis::Z].map(|axis| inside_along(&square, p, axis));
        assert!(!found[1] && found[2], "{found:?}");
    }
}
