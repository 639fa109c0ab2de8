//! How much of a polygon lies in a rectangle.

use glam::DVec2;

use crate::geometry::clip_to_rectangle;

/// The area that a polygon shares with a rectangle along the axes, in square units.
///
/// The polygon is cut off at each of the four sides in turn. Where a concave polygon falls into pieces, edges along the
/// side connect them; they enclose nothing, so that the area is right.
///
/// A = ½ |Σ pᵢ × pᵢ₊₁|. Fewer than three vertices share nothing.
pub fn polygon_in_rectangle(outline: &[DVec2], low: DVec2, high: DVec2) -> f64 {
    let piece = clip_to_rectangle(outline, low, high);
    let next = piece.iter().cycle().skip(1);
    let twice: f64 = piece.iter().zip(next).map(|(p, q)| p.perp_dot(*q)).sum();
    0.5 * twice.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(outline: &[[f64; 2]], expected: f64) {
        let outline: Vec<DVec2> = outline.iter().copied().map(DVec2::from).collect();
        let area = polygon_in_rectangle(&outline, DVec2::ZERO, DVec2::new(2.0, 1.0));
        assert!((area - expected).abs() <= 1e-15, "{area} {expected}");
    }

    #[test]
    fn a_polygon_counts_as_far_as_it_lies_in_the_rectangle() {
        check(&[[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]], 2.0);
        check(&[[0.5, 0.25], [1.5, 0.25], [1.5, 0.75], [0.5, 0.75]], 0.5);
        check(&[[3.0, 0.0], [4.0, 0.0], [4.0, 1.0]], 0.0);
        // the triangle below x + y = 1
        check(&[[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]], 1.5);
    }

    #[test]
    fn a_concave_polygon_in_two_pieces_counts_both() {
        // a U whose arms are 0.5 wide and whose bar lies below the rectangle
        let outline = [
            [0.0, -1.0],
            [1.5, -1.0],
            [1.5, 1.0],
            [1.0, 1.0],
            [1.0, -0.5],
            [0.5, -0.5],
            [0.5, 1.0],
            [0.0, 1.0],
        ];
        check(&outline, 1.0);
    }

    #[test]
    fn points_that_are_no_polygon_share_nothing() {
        check(&[], 0.0);
        check(&[[0.1, 0.1], [0.9, 0.9]], 0.0);
    }

    #[test]
    fn a_rectangle_away_from_the_origin_cuts_where_it_lies() {
        let triangle = [[0.0, 0.0], [6.0, 0.0], [0.0, 6.0]].map(DVec2::from);
        // of 1 ≤ x ≤ 3, 2 ≤ y ≤ 4 the corner beyond x + y = 6 is left out: half of 1·1 at (3, 4)
        let area = polygon_in_rectangle(&triangle, DVec2::new(1.0, 2.0), DVec2::new(3.0, 4.0));
        assert_eq!(area, 3.5);
        // the same the other way around
        let turned = triangle.map(|p| DVec2::new(p.y, p.x));
        let area = polygon_in_rectangle(&turned, DVec2::new(2.0, 1.0), DVec2::new(4.0, 3.0));
        assert_eq!(area, 3.5);
    }
}
