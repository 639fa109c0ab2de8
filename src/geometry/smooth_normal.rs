//! Smooth shading: the normal at a point inside a polygon from the normals at its vertices.

use glam::{DVec2, DVec3};

/// Which share has each vertex of an outline at a point inside?
///
/// Mean value coordinates (M. Floater 2003; K. Hormann, M. Floater 2006):
/// wᵢ = (tan(αᵢ₋₁/2) + tan(αᵢ/2)) / |vᵢ − p|, αᵢ the angle that edge i subtends at p, divided by their sum.
/// They serve convex and concave outlines alike, and for a triangle they are the barycentric
/// coordinates.
///
/// `p` lies inside or on the outline. On a vertex: that vertex alone; on an edge: its two ends.
///
/// ```
/// use glam::DVec2;
/// let outline = [DVec2::ZERO, DVec2::new(6.0, 0.0), DVec2::new(0.0, 12.0)];
/// let weights = raystep::geometry::mean_value_weights(&outline, DVec2::new(2.0, 2.0));
/// let expected = [1.0 / 2.0, 1.0 / 3.0, 1.0 / 6.0];
/// assert!(weights.iter().zip(expected).all(|(w, e)| (w - e).abs() < 1e-15));
/// ```
pub fn mean_value_weights(outline: &[DVec2], p: DVec2) -> Vec<f64> {
    let count = outline.len();
    let mut weights = vec![0.0; count];
    for i in 0..count {
        let j = (i + 1) % count;
        let (to_i, to_j) = (outline[i] - p, outline[j] - p);
        let (far_i, far_j) = (to_i.length(), to_j.length());
        let (cross, dot) = (to_i.perp_dot(to_j), to_i.dot(to_j));
        // on a vertex, or on the edge between two
        if far_i == 0.0 || (cross == 0.0 && dot < 0.0) {
            weights.fill(0.0);
            weights[i] = far_j / (far_i + far_j);
            weights[j] = far_i / (far_i + far_j);
            return weights;
        }
        // tan(α/2) = (1 − cos α)/sin α = (|a||b| − a·b)/(a × b), and 0 on the edge's extension
        if cross != 0.0 {
            let half_tangent = (far_i * far_j - dot) / cross;
            weights[i] += half_tangent / far_i;
            weights[j] += half_tangent / far_j;
        }
    }
    // a clockwise outline has all weights negative, and so has their sum
    let sum: f64 = weights.iter().sum();
    for weight in &mut weights {
        *weight /= sum;
    }
    weights
}

/// Which normal does a smoothly shaded polygon have at a point?
///
/// N = Σ wᵢNᵢ / |Σ wᵢNᵢ|, with the weights of [`mean_value_weights`].
///
/// `outline` is the projected outline, `normals` one unit normal for each of its vertices, `p` the
/// projected point, inside or on the outline. `None` if the mixture cancels to zero.
///
/// ```
/// use glam::{DVec2, DVec3};
/// let outline = [DVec2::ZERO, DVec2::new(2.0, 0.0), DVec2::new(0.0, 2.0)];
/// let normals = [DVec3::Z, DVec3::X, DVec3::Z];
/// let middle = raystep::geometry::interpolated_normal(&outline, &normals, DVec2::new(1.0, 0.0));
/// assert_eq!(middle, Some(DVec3::new(0.5, 0.0, 0.5).normalize()));
/// ```
pub fn interpolated_normal(outline: &[DVec2], normals: &[DVec3], p: DVec2) -> Option<DVec3> {
    let weights = mean_value_weights(outline, p);
    let mixed: DVec3 = normals.iter().zip(&weights).map(|(&n, &w)| w * n).sum();
    mixed.try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NORMALS: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];

    #[test]
    fn in_a_triangle_the_weights_are_barycentric() {
        // p = ½·a + ⅓·b + ⅙·c, so N ∝ (3, 2, 1)
        let triangle = [
            DVec2::new(0.0, 0.0),
            DVec2::new(6.0, 0.0),
            DVec2::new(0.0, 12.0),
        ];
        let p = DVec2::new(2.0, 2.0);
        let expected = DVec3::new(3.0, 2.0, 1.0).normalize();
        let found = interpolated_normal(&triangle, &NORMALS, p).unwrap();
        assert!((found - expected).length() <= 1e-15, "{found}");
        let clockwise = [triangle[0], triangle[2], triangle[1]];
        let swapped = [NORMALS[0], NORMALS[2], NORMALS[1]];
        let found = interpolated_normal(&clockwise, &swapped, p).unwrap();
        assert!((found - expected).length() <= 1e-15, "{found}");
    }

    #[test]
    fn a_vertex_has_its_own_normal() {
        let triangle = [DVec2::ZERO, DVec2::X, DVec2::Y];
        for i in 0..3 {
            let found = interpolated_normal(&triangle, &NORMALS, triangle[i]);
            assert_eq!(found, Some(NORMALS[i]));
        }
    }

    #[test]
    fn the_middle_of_a_square_mixes_all_four_alike() {
        let square = [
            DVec2::new(-1.0, -1.0),
            DVec2::new(1.0, -1.0),
            DVec2::new(1.0, 1.0),
            DVec2::new(-1.0, 1.0),
        ];
        let normals = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::Z];
        let expected = DVec3::new(1.0, 1.0, 2.0).normalize();
        let found = interpolated_normal(&square, &normals, DVec2::ZERO).unwrap();
        assert!((found - expected).length() <= 1e-15, "{found}");
    }

    #[test]
    fn opposite_normals_that_cancel_give_none() {
        let triangle = [DVec2::ZERO, DVec2::X, DVec2::Y];
        let normals = [DVec3::X, -DVec3::X, DVec3::Z];
        let found = interpolated_normal(&triangle, &normals, DVec2::new(0.5, 0.0));
        assert_eq!(found, None);
    }

    #[test]
    fn on_an_edge_the_nearer_end_has_the_larger_share() {
        // ¼ of the way along an edge of 8
        let outline = [DVec2::ZERO, DVec2::new(8.0, 0.0), DVec2::new(0.0, 8.0)];
        let weights = mean_value_weights(&outline, DVec2::new(2.0, 0.0));
        assert_eq!(weights, [0.75, 0.25, 0.0]);
    }
}
