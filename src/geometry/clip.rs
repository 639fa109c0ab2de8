//! What is left of a polygon on one side of a line or a plane.

use std::ops::{Add, Mul, Sub};

use glam::DVec2;

/// What is left of an outline where the distance from a line, or in space from a plane, is not negative; it replaces what
/// is in `left`.
///
/// An edge from p to q that passes the line, at the distances a and b of its ends, is cut at p + a/(a − b)·(q − p)
/// (I. Sutherland and G. Hodgman, *Reentrant polygon clipping*, 1974). Where a concave outline falls into pieces, edges
/// along the line connect them, which enclose nothing.
///
/// An outline without points leaves none. `left` keeps its memory, so that whoever clips often hands in the same list.
pub(crate) fn clip<P>(outline: &[P], distance: impl Fn(P) -> f64, left: &mut Vec<P>)
where
    P: Copy + Add<Output = P> + Sub<Output = P> + Mul<f64, Output = P>,
{
    left.clear();
    let Some(&last) = outline.last() else {
        return;
    };
    let mut from = last;
    for &to in outline {
        let (at_from, at_to) = (distance(from), distance(to));
        if (0.0 <= at_from) != (0.0 <= at_to) {
            left.push(from + (to - from) * (at_from / (at_from - at_to)));
        }
        if 0.0 <= at_to {
            left.push(to);
        }
        from = to;
    }
}

/// What is left of an outline in a rectangle along the axes: clipped at one side after the other.
pub(crate) fn clip_to_rectangle(outline: &[DVec2], low: DVec2, high: DVec2) -> Vec<DVec2> {
    let (mut piece, mut left) = (outline.to_vec(), Vec::new());
    for axis in 0..2 {
        clip(&piece, |p| p[axis] - low[axis], &mut left);
        clip(&left, |p| high[axis] - p[axis], &mut piece);
    }
    piece
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn square() -> Vec<DVec2> {
        [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]
            .map(DVec2::from)
            .to_vec()
    }

    fn clipped(outline: &[DVec2], distance: impl Fn(DVec2) -> f64) -> Vec<DVec2> {
        let mut left = vec![DVec2::NAN];
        clip(outline, distance, &mut left);
        left
    }

    #[test]
    fn a_square_is_cut_where_its_edges_pass_the_line() {
        // right of x = 1
        let expected = [[1.0, 0.0], [4.0, 0.0], [4.0, 4.0], [1.0, 4.0]].map(DVec2::from);
        let found = clipped(&square(), |p| p.x - 1.0);
        assert_eq!(found.len(), 4);
        assert!(expected.iter().all(|p| found.contains(p)), "{found:?}");
        // below x + y = 2 a triangle is left
        let found = clipped(&square(), |p| 2.0 - p.x - p.y);
        assert_eq!(found, [[0.0, 2.0], [0.0, 0.0], [2.0, 0.0]].map(DVec2::from));
    }

    #[test]
    fn an_outline_on_one_side_stays_or_goes_and_points_on_the_line_stay() {
        assert_eq!(clipped(&square(), |p| p.x + 1.0), square());
        assert_eq!(clipped(&square(), |p| p.x - 5.0), []);
        let on_the_line = [[4.0, 0.0], [4.0, 4.0]].map(DVec2::from);
        // the edges across end there, which counts as cut
        let mut edge = clipped(&square(), |p| p.x - 4.0);
        edge.dedup();
        assert_eq!(edge, on_the_line);
        assert_eq!(clipped(&[], |p| p.x), []);
    }

    #[test]
    fn a_concave_outline_keeps_both_its_parts() {
        // a V of which the notch reaches down to (2, 1)
        let v = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]].map(DVec2::from);
        let found = clipped(&v, |p| p.y - 1.0);
        // the edges to the notch do not pass y = 1 but end on it
        let expected = [[0.0, 1.0], [4.0, 1.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]];
        assert_eq!(found, expected.map(DVec2::from));
    }

    #[test]
    fn a_triangle_over_a_corner_of_a_rectangle_keeps_its_part() {
        let triangle = [[3.0, 1.0], [5.0, 1.0], [3.0, 3.0]].map(DVec2::from);
        let found = clip_to_rectangle(&triangle, DVec2::ZERO, DVec2::new(4.0, 2.0));
        // x + y = 6 leaves the rectangle in its corner, (4, 2): the square from (3, 1) to (4, 2)
        let square = [[3.0, 1.0], [4.0, 1.0], [4.0, 2.0], [3.0, 2.0]].map(DVec2::from);
        assert!(
            square.iter().all(|corner| found.contains(corner)),
            "{found:?}"
        );
        assert!(found.iter().all(|p| square.contains(p)), "{found:?}");
    }

    #[test]
    fn a_triangle_in_space_is_cut_at_a_plane() {
        let corners = [[0.0, 0.0, -1.0], [2.0, 0.0, 1.0], [0.0, 2.0, 1.0]].map(DVec3::from);
        let mut left = Vec::new();
        clip(&corners, |p| p.z, &mut left);
        let expected = [
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [2.0, 0.0, 1.0],
            [0.0, 2.0, 1.0],
        ];
        assert_eq!(left, expected.map(DVec3::from));
    }
}
