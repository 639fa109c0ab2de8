//! The half axes of the ellipsoid that a matrix makes of the unit sphere.

use glam::{DMat3, DVec3};

/// The directions of the half axes, of unit length and at right angles, and their lengths.
///
/// With a rotation V the columns of F·V stand at right angles to each other: they are the half axes. V is
/// put together of rotations of two columns at a time (M. Hestenes 1958). Unlike the roots of F·Fᵀ this
/// keeps the digits of a half axis that is much shorter than the others.
///
/// The third column keeps its place if it stands across the others from the start; of the first two the
/// longer comes first. A column of length 0 gets the direction across the other two.
pub(in crate::structure) fn principal_axes(f: DMat3) -> ([DVec3; 3], DVec3) {
    /// Two columns stand at right angles if their cosine is within some roundings of 0.
    const RIGHT_ANGLE: f64 = 1e-15;
    /// Each round squares what is left: five do for any matrix.
    const MOST_ROUNDS: usize = 30;
    let mut columns = [f.x_axis, f.y_axis, f.z_axis];
    for _ in 0..MOST_ROUNDS {
        let mut turned = false;
        for [p, q] in [[0, 1], [0, 2], [1, 2]] {
            let (a, b) = (columns[p], columns[q]);
            let dot = a.dot(b);
            if dot.abs() <= RIGHT_ANGLE * (a.length() * b.length()) {
                continue;
            }
            turned = true;
            // the rotation that makes the dot product 0: of its two angles the smaller
            let half_cotangent = (b.length_squared() - a.length_squared()) / (2.0 * dot);
            let tangent =
                half_cotangent.signum() / (half_cotangent.abs() + libm::hypot(half_cotangent, 1.0));
            let cosine = 1.0 / libm::hypot(tangent, 1.0);
            let sine = cosine * tangent;
            columns[p] = cosine * a - sine * b;
            columns[q] = sine * a + cosine * b;
        }
        if !turned {
            break;
        }
    }
    if columns[0].length_squared() < columns[1].length_squared() {
        columns.swap(0, 1);
    }
    let lengths = columns.map(DVec3::length);
    let first = columns[0] / lengths[0];
    let second = columns[1] / lengths[1];
    let across = first.cross(second).normalize_or(DVec3::Z);
    ([first, second, across], DVec3::from(lengths))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_along_slanted_axes_has_them_as_half_axes() {
        // 3 along (0.6, 0.8, 0), 2 along (−0.8, 0.6, 0), 1e-6 along z, after a rotation that does not matter
        let axes = DMat3::from_cols(
            DVec3::new(0.6, 0.8, 0.0),
            DVec3::new(-0.8, 0.6, 0.0),
            DVec3::Z,
        );
        let rotation = DMat3::from_axis_angle(DVec3::new(0.36, 0.48, 0.8), 1.0);
        let lengths = DVec3::new(3.0, 2.0, 1e-6);
        let (directions, radii) = principal_axes(axes * DMat3::from_diagonal(lengths) * rotation);
        for (i, direction) in directions.into_iter().enumerate() {
            let at = lengths.to_array().map(|l| (l - radii[i]).abs() <= 1e-9 * l);
            let expected = at.iter().position(|&found| found).unwrap();
            assert!((direction.dot(axes.col(expected)).abs() - 1.0).abs() <= 1e-9);
        }
    }

    #[test]
    fn of_the_first_two_half_axes_the_longer_comes_first_and_the_third_keeps_its_place() {
        for lengths in [[2.0, 3.0, 9.0], [3.0, 2.0, 9.0]] {
            let columns = DMat3::from_diagonal(lengths.into());
            let (directions, radii) = principal_axes(columns);
            assert_eq!(radii, DVec3::new(3.0, 2.0, 9.0));
            let first = if lengths[0] < lengths[1] {
                DVec3::Y
            } else {
                DVec3::X
            };
            assert_eq!(directions[0], first);
            assert_eq!(directions[2].abs(), DVec3::Z);
        }
    }

    #[test]
    fn half_axes_of_any_size_stand_at_right_angles() {
        // (1, 0) and (1, 1): the roots of (3 ± √5)/2 are the golden ratio and its inverse
        let golden = 0.5 + 1.25_f64.sqrt();
        for size in [1e-40, 1.0, 1e40] {
            let f = DMat3::from_cols(DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Z);
            let (directions, radii) = principal_axes(size * f);
            let expected = DVec3::new(golden, 1.0 / golden, 1.0);
            assert!(
                (radii / size - expected).abs().max_element() <= 1e-14,
                "{radii}"
            );
            assert!(directions[0].dot(directions[1]).abs() <= 1e-14);
            // and the longest has the direction in which the square of the length is largest: (golden, 1)
            let along = DVec3::new(golden, 1.0, 0.0).normalize();
            assert!(
                (directions[0].dot(along).abs() - 1.0).abs() <= 1e-14,
                "{directions:?}"
            );
        }
    }
}
