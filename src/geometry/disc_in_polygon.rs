//! How much of a disc lies in a polygon.

use std::f64::consts::PI;

use glam::DVec2;

/// The area that a disc around the origin shares with a polygon, in square units.
///
/// The polygon is cut into triangles from the origin to each of its edges; along an edge, what lies within the
/// disc is a triangle, and what lies outside is replaced by a sector of the disc:
///
/// A = Σ over the pieces of ½·p×q where a piece lies inside, ½·r²·∠(p, q) where it lies outside.
///
/// Concave polygons count rightly, since edges that turn back count negatively. The order of the vertices does
/// not matter; fewer than three share nothing.
///
/// ```
/// use glam::DVec2;
/// // a quarter of a disc of radius 2 in the corner of a large square: π·2²/4
/// let square = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]].map(DVec2::from);
/// let area = raystep::geometry::disc_in_polygon(2.0, square.into_iter());
/// assert!((area - std::f64::consts::PI).abs() < 1e-15);
/// ```
pub fn disc_in_polygon(radius: f64, vertices: impl ExactSizeIterator<Item = DVec2> + Clone) -> f64 {
    if vertices.len() < 3 {
        return 0.0;
    }
    let next = vertices.clone().cycle().skip(1);
    let sum: f64 = vertices
        .zip(next)
        .map(|(p, q)| along_edge(radius, p, q))
        .sum();
    // rounding must not make the part larger than the whole
    sum.abs().min(PI * radius * radius)
}

/// The signed part between the origin and one edge.
fn along_edge(radius: f64, p: DVec2, q: DVec2) -> f64 {
    let inside = |from: DVec2, to: DVec2| 0.5 * from.perp_dot(to);
    let outside = |from: DVec2, to: DVec2| {
        0.5 * radius * radius * libm::atan2(from.perp_dot(to), from.dot(to))
    };
    // |p + s·(q − p)|² = r²: where the edge is within the disc, s from enters to leaves
    let along = q - p;
    let a = along.length_squared();
    let half_b = p.dot(along);
    let c = p.length_squared() - radius * radius;
    let discriminant = half_b * half_b - a * c;
    if a == 0.0 || discriminant <= 0.0 {
        return outside(p, q);
    }
    let root = discriminant.sqrt();
    let enters = ((-half_b - root) / a).clamp(0.0, 1.0);
    let leaves = ((-half_b + root) / a).clamp(0.0, 1.0);
    if leaves <= enters {
        return outside(p, q);
    }
    let [first, second] = [enters, leaves].map(|s| p + s * along);
    let before = if 0.0 < enters { outside(p, first) } else { 0.0 };
    let after = if leaves < 1.0 {
        outside(second, q)
    } else {
        0.0
    };
    before + inside(first, second) + after
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(center: [f64; 2], half: f64) -> [DVec2; 4] {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|corner| DVec2::from(center) + half * DVec2::from(corner))
    }

    #[track_caller]
    fn check(radius: f64, vertices: &[DVec2], expected: f64) {
        let area = disc_in_polygon(radius, vertices.iter().copied());
        assert!((area - expected).abs() <= 1e-13, "{area} {expected}");
        let turned = disc_in_polygon(radius, vertices.iter().rev().copied());
        assert!((turned - expected).abs() <= 1e-13, "{turned} {expected}");
    }

    #[test]
    fn a_disc_inside_counts_whole_and_a_polygon_inside_counts_whole() {
        check(1.0, &square([0.0, 0.0], 2.0), PI);
        check(3.0, &square([0.5, 0.0], 1.0), 4.0);
        check(1.0, &square([5.0, 0.0], 1.0), 0.0);
    }

    #[test]
    fn an_edge_through_the_middle_leaves_half_and_one_at_half_the_radius_a_segment() {
        check(1.0, &square([4.0, 0.0], 4.0), PI / 2.0);
        // beyond x = ½: the segment π/3 − √3/4
        check(
            1.0,
            &square([4.5, 0.0], 4.0),
            PI / 3.0 - 3.0_f64.sqrt() / 4.0,
        );
        // all but that
        check(
            1.0,
            &square([3.5, 0.0], 4.0),
            PI - (PI / 3.0 - 3.0_f64.sqrt() / 4.0),
        );
    }

    #[test]
    fn a_square_that_pokes_out_on_four_sides_loses_four_segments() {
        // half side cos 30°: four segments of 60° each, ½(π/3 − √3/2)
        let half = 3.0_f64.sqrt() / 2.0;
        let segment = 0.5 * (PI / 3.0 - 3.0_f64.sqrt() / 2.0);
        check(1.0, &square([0.0, 0.0], half), PI - 4.0 * segment);
    }

    #[test]
    fn the_notch_of_a_concave_polygon_is_left_out() {
        // an L around the origin: three quarters of the plane near it
        let corners = [
            [-9.0, -9.0],
            [9.0, -9.0],
            [9.0, 0.0],
            [0.0, 0.0],
            [0.0, 9.0],
            [-9.0, 9.0],
        ];
        check(2.0, &corners.map(DVec2::from), 3.0 * PI);
    }

    #[test]
    fn points_that_are_no_polygon_share_nothing() {
        check(1.0, &[], 0.0);
        check(1.0, &[DVec2::X, DVec2::Y], 0.0);
        check(1.0, &[DVec2::X; 4], 0.0);
    }

    #[test]
    fn a_triangle_with_its_corner_in_the_middle_takes_its_angle_of_the_disc() {
        // 45° of 360°: π·2²/8
        check(
            2.0,
            &[DVec2::ZERO, DVec2::new(9.0, 0.0), DVec2::new(9.0, 9.0)],
            PI / 2.0,
        );
    }
}
