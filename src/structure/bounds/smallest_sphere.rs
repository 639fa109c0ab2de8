//! The smallest sphere around points.
//!
//! It is settled by at most four of them, which lie on it. They are found by exchange (as E. Welzl 1991
//! puts the problem, with the pivots of B. Gärtner 1999): the point that lies furthest outside joins those
//! that settle the sphere so far, and of these five at most the smallest sphere is found by trying all. The
//! sphere grows with each exchange, so no set comes twice; some ten exchanges do for any number of points.

use glam::DVec3;

use crate::geometry::Sphere;

/// The smallest sphere around points; `None` around none.
///
/// Of one point, or of equal ones, the sphere has radius 0. Its radius is the largest distance that was
/// computed, so that no point is outside but for the rounding of a distance. The same points in the same
/// order give the same sphere, bit for bit.
pub(in crate::structure) fn smallest_sphere(points: &[DVec3]) -> Option<Sphere> {
    /// A point counts as outside beyond this share of the radius: the rounding of some distances.
    const OUTSIDE: f64 = 1e-14;
    let first = *points.first()?;
    let mut settled = vec![first];
    let mut center = first;
    // the distance up to which the points of `settled` reach
    let mut radius = 0.0;
    loop {
        let (furthest, distance) = furthest_from(center, points);
        if distance <= radius * (1.0 + OUTSIDE) {
            break;
        }
        settled.push(furthest);
        let (next, next_radius, few) = smallest_of_few(&settled);
        settled = few;
        // rounding alone is left to be gained
        if next_radius <= radius {
            break;
        }
        (center, radius) = (next, next_radius);
    }
    let (_, radius) = furthest_from(center, points);
    Some(Sphere { center, radius })
}

/// The point that is furthest from a center, the first of equals, and its distance.
fn furthest_from(center: DVec3, points: &[DVec3]) -> (DVec3, f64) {
    let (mut furthest, mut largest) = (center, 0.0);
    for &point in points {
        let squared = point.distance_squared(center);
        if largest < squared {
            (furthest, largest) = (point, squared);
        }
    }
    (furthest, largest.sqrt())
}

/// The center and radius of the smallest sphere around up to five points, and those that settle it.
///
/// Around the center of each choice of up to four of them, the radius that holds all five is measured. The
/// smallest sphere's center is among those centers, and no other center needs as small a radius. So it does
/// no harm that a choice in one line, or in one plane, has no center worth the name.
fn smallest_of_few(points: &[DVec3]) -> (DVec3, f64, Vec<DVec3>) {
    let mut smallest = (points[0], f64::INFINITY, Vec::new());
    for choice in 1_u32..1 << points.len() {
        let chosen: Vec<DVec3> = (0..points.len())
            .filter(|i| choice >> i & 1 == 1)
            .map(|i| points[i])
            .collect();
        let Some(center) = center_of(&chosen) else {
            continue;
        };
        let (_, radius) = furthest_from(center, points);
        if radius < smallest.1 {
            smallest = (center, radius, chosen);
        }
    }
    smallest
}

/// The point at equal distance from up to four points, in the plane or line that they span.
///
/// With the edges e from the first: of a tetrahedron
/// (|e₁|²·e₂×e₃ + |e₂|²·e₃×e₁ + |e₃|²·e₁×e₂) / (2·e₁·(e₂×e₃)), of a triangle with n = e₁×e₂
/// (|e₂|²·n×e₁ + |e₁|²·e₂×n) / (2·|n|²), each added to the first point. `None` for no point or five.
fn center_of(points: &[DVec3]) -> Option<DVec3> {
    let first = *points.first()?;
    // edges of about length 1: products of tiny ones would vanish
    let size = points
        .iter()
        .map(|&p| (p - first).abs().max_element())
        .fold(0.0, f64::max);
    let edge = |p: DVec3| (p - first) / size;
    let from_first = match *points {
        [_] => return Some(first),
        [_, b] => 0.5 * edge(b),
        [_, b, c] => {
            let (b, c) = (edge(b), edge(c));
            let normal = b.cross(c);
            let turned =
                c.length_squared() * normal.cross(b) + b.length_squared() * c.cross(normal);
            turned / (2.0 * normal.length_squared())
        }
        [_, b, c, d] => {
            let (b, c, d) = (edge(b), edge(c), edge(d));
            let sum = b.length_squared() * c.cross(d)
                + c.length_squared() * d.cross(b)
                + d.length_squared() * b.cross(c);
            sum / (2.0 * b.dot(c.cross(d)))
        }
        _ => return None,
    };
    let center = first + size * from_first;
    center.is_finite().then_some(center)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(points: &[[f64; 3]], center: [f64; 3], radius: f64) {
        let points: Vec<_> = points.iter().copied().map(DVec3::from).collect();
        let found = smallest_sphere(&points).unwrap();
        let off = (found.center - DVec3::from(center)).length();
        assert!(
            off <= 1e-14 && (found.radius - radius).abs() <= 1e-14,
            "{found:?}"
        );
    }

    #[test]
    fn two_points_have_the_sphere_over_their_distance() {
        check(&[[0.0; 3], [0.0, 6.0, 8.0]], [0.0, 3.0, 4.0], 5.0);
        check(&[[1.0; 3]], [1.0; 3], 0.0);
        check(&[[1.0; 3], [1.0; 3], [1.0; 3]], [1.0; 3], 0.0);
        assert_eq!(smallest_sphere(&[]), None);
    }

    #[test]
    fn an_obtuse_triangle_has_the_sphere_over_its_longest_side() {
        check(
            &[[0.0; 3], [10.0, 0.0, 0.0], [5.0, 1.0, 0.0]],
            [5.0, 0.0, 0.0],
            5.0,
        );
    }

    #[test]
    fn an_acute_triangle_has_its_circumscribed_circle() {
        // 3, 4, 5 on a circle of radius 5 around the origin; no angle above a right one
        check(
            &[[3.0, 4.0, 0.0], [-5.0, 0.0, 0.0], [3.0, -4.0, 0.0]],
            [0.0; 3],
            5.0,
        );
    }

    #[test]
    fn the_corners_of_a_cube_have_the_sphere_of_half_its_diagonal() {
        let corners: Vec<_> = (0..8)
            .map(|i| [0, 1, 2].map(|axis| f64::from(i >> axis & 1)))
            .collect();
        check(&corners, [0.5; 3], 0.75_f64.sqrt());
    }

    #[test]
    fn tiny_and_huge_points_keep_their_digits() {
        for size in [1e-50, 1e50] {
            let points = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.5, 0.0]];
            let points = points.map(|p| size * DVec3::from(p));
            let found = smallest_sphere(&points).unwrap();
            assert!((found.radius - size).abs() <= 1e-15 * size, "{found:?}");
        }
    }

    #[test]
    fn a_tetrahedron_has_the_sphere_around_its_corners_or_around_fewer() {
        // every other corner of the cube from (1, 2, 3) to (3, 4, 5)
        let regular = [
            [1.0, 2.0, 3.0],
            [3.0, 4.0, 3.0],
            [3.0, 2.0, 5.0],
            [1.0, 4.0, 5.0],
        ];
        check(&regular, [2.0, 3.0, 4.0], 3.0_f64.sqrt());
        // 3-4-5: (±4, 0, −3), (0, ±4, 3), (3, 0, 4) and (0, −3, 4) on a sphere of radius 5, around (1, 1, 1)
        let on_five = [
            [5.0, 1.0, -2.0],
            [-3.0, 1.0, -2.0],
            [1.0, 5.0, 4.0],
            [1.0, -2.0, 5.0],
        ];
        check(&on_five, [1.0; 3], 5.0);
        // flat over an acute triangle, whose circle is large enough: radius 5 around (0, 0, 1)
        let low = [
            [3.0, 4.0, 1.0],
            [-5.0, 0.0, 1.0],
            [3.0, -4.0, 1.0],
            [0.0, 0.0, 2.0],
        ];
        check(&low, [0.0, 0.0, 1.0], 5.0);
        // an equilateral triangle with sides of 2, and a point within
        let height = 3.0_f64.sqrt();
        let within = [
            [0.0, 0.0, 0.0],
            [1.0, 0.5, 0.0],
            [2.0, 0.0, 0.0],
            [1.0, height, 0.0],
        ];
        check(&within, [1.0, height / 3.0, 0.0], 2.0 / height);
    }

    #[test]
    fn the_pair_that_settles_the_sphere_may_stand_anywhere_in_the_list() {
        // two ends of a diameter of 10 among points within
        let ends = [[1.0, -3.0, 2.0], [1.0, 5.0, 8.0]];
        let inner = [
            [1.0, 1.0, 5.0],
            [2.0, 1.0, 5.0],
            [1.0, 3.0, 5.0],
            [1.0, 1.0, 2.0],
        ];
        for first in 0..6 {
            for second in (0..6).filter(|&second| second != first) {
                let mut points = Vec::from(inner);
                let (low, high) = (first.min(second), first.max(second));
                points.insert(low, ends[usize::from(second < first)]);
                points.insert(high, ends[usize::from(first < second)]);
                check(&points, [1.0, 1.0, 5.0], 5.0);
            }
        }
    }

    #[test]
    fn of_few_points_those_that_settle_the_sphere_are_told_wherever_they_stand() {
        let points = [[-5.0, 0.0, 0.0], [0.0, 1.0, 0.0], [5.0, 0.0, 0.0]].map(DVec3::from);
        let (center, radius, few) = smallest_of_few(&points);
        assert_eq!((center, radius), (DVec3::ZERO, 5.0));
        assert_eq!(few, [points[0], points[2]]);
    }
}
