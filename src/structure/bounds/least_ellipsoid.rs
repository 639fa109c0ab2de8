//! The ellipsoid of least volume around points, turned as it fits best (Löwner and John).
//!
//! It is the ellipsoid of a mean and a covariance: each point has a weight u ≥ 0, all weights together are
//! 1, and those weights are the best of which the ellipsoid reaches no point further than the others
//! (F. John 1948). They are found by L. Khachiyan's steps (1996): weight is moved to the point that lies
//! furthest outside, and, as P. Wolfe and C. Atwood showed, taken away from the point with weight that lies
//! furthest inside (M. Todd and E. Yıldırım 2007). Points in one plane have the ellipse of least area,
//! found in the same way with one dimension less.

use glam::{DMat3, DMat4, DVec3, DVec4};

use crate::geometry::OrientedEllipsoid;
use crate::structure::bounds::principal_axes::principal_axes;

/// Points whose distance from a plane is within this share of their size count as flat. It is what a
/// polygon's vertices may be off their plane.
const FLAT: f64 = 1e-5;

/// How near to the least volume the weights come: no point lies further outside than this share.
///
/// Made to hold every point, the ellipsoid then has less than 1 + 5·10⁻⁹ times the least volume.
const NEAR_LEAST: f64 = 1e-9;

/// Steps at most for one set of points; some hundreds are usual. What is left is made up for by the size.
const MOST_STEPS: usize = 20_000;

/// Up to this many points all take part from the start; of more points, only the outermost, and others as they are found
/// to lie outside.
const FEW: usize = 32;

/// The ellipsoid of least volume, or a flat one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::structure) struct LeastEllipsoid {
    /// Around the points. If they are flat, the third half axis stands across their plane and has length 0.
    pub(in crate::structure) ellipsoid: OrientedEllipsoid,
    /// How far the points lie off their plane, if they count as flat.
    pub(in crate::structure) off_plane: Option<f64>,
}

/// The ellipsoid of least volume around points that do not lie on one line; `None` if they do.
///
/// `is_flat` says that they belong to one plane, whatever rounding has made of them.
pub(in crate::structure) fn least_ellipsoid(
    points: &[DVec3],
    is_flat: bool,
) -> Option<LeastEllipsoid> {
    let frame = Frame::of(points)?;
    let is_flat = is_flat || frame.half.z <= FLAT * frame.half.x;
    let dimensions = if is_flat { 2 } else { 3 };
    let normed: Vec<DVec3> = points
        .iter()
        .map(|&point| frame.normed(point, is_flat))
        .collect();
    let weighted = Weighted::least(&normed, dimensions);

    // the ellipsoid of those weights, back in the frame: the columns of F map the unit sphere to it
    let (mean, root) = weighted.mean_and_root();
    let half_axes = DMat3::from_diagonal(frame.half) * root;
    let (directions, mut radii) = principal_axes(half_axes);
    if is_flat {
        radii.z = 0.0;
    }
    let mut ellipsoid = OrientedEllipsoid {
        center: frame.center + frame.axes * (frame.half * mean),
        axes: directions.map(|direction| frame.axes * direction),
        radii,
    };
    // what the weights are short of the best, and rounding
    let across = |point: DVec3| {
        let from_center = point - ellipsoid.center;
        let [u, v, w] = ellipsoid.axes.map(|axis| axis.dot(from_center));
        let w = if is_flat { 0.0 } else { w / radii.z };
        DVec3::new(u / radii.x, v / radii.y, w).length_squared()
    };
    let largest = points.iter().map(|&p| across(p)).fold(0.0, f64::max);
    ellipsoid.radii = radii * largest.sqrt();
    ellipsoid.radii.is_finite().then_some(LeastEllipsoid {
        ellipsoid,
        off_plane: is_flat.then_some(frame.half.z),
    })
}

/// A box around the points, turned so that they fill a good part of it, however long or flat they are: in
/// its coordinates, from −1 to 1, every direction counts alike.
struct Frame {
    center: DVec3,
    /// The columns: along the points' greatest length, across it, and across both.
    axes: DMat3,
    /// Half the sides.
    half: DVec3,
}

impl Frame {
    /// From a point to the furthest other, and again from there: that is the length. Then the point
    /// furthest from this line gives the plane. (G. Barequet and S. Har-Peled 2001)
    fn of(points: &[DVec3]) -> Option<Self> {
        let first = *points.first()?;
        let from = largest(points, first, |p| p.distance_squared(first)).0;
        let to = largest(points, first, |p| p.distance_squared(from)).0;
        let along = (to - from).try_normalize()?;
        let off_line = |p: DVec3| (p - from) - along * (p - from).dot(along);
        let beside = largest(points, first, |p| off_line(p).length_squared()).0;
        let side = off_line(beside).try_normalize()?;
        let axes = DMat3::from_cols(along, side, along.cross(side).try_normalize()?);
        let local = |p: DVec3| axes.transpose() * (p - first);
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for &point in points {
            low = low.min(local(point));
            high = high.max(local(point));
        }
        Some(Self {
            center: first + axes * (0.5 * (low + high)),
            axes,
            half: 0.5 * (high - low),
        })
    }

    /// A point in the coordinates of the box; the third is left out if the points are flat.
    fn normed(&self, point: DVec3, is_flat: bool) -> DVec3 {
        let local = self.axes.transpose() * (point - self.center);
        if is_flat {
            return DVec3::new(local.x / self.half.x, local.y / self.half.y, 0.0);
        }
        local / self.half
    }
}

/// Points and their weights.
///
/// With q = (p, 1) and M = Σ u·q·qᵀ, a point's level is κ = qᵀ·M⁻¹·q. The mean of the levels is one more
/// than the dimensions; with the best weights no level is larger, and those of the points with weight equal
/// that.
struct Weighted {
    /// Those that take part.
    points: Vec<DVec3>,
    weights: Vec<f64>,
    /// 3, or 2 with every third coordinate 0.
    dimensions: usize,
}

impl Weighted {
    /// The weights of the ellipsoid of least volume.
    fn least(points: &[DVec3], dimensions: usize) -> Self {
        let taking_part = if points.len() <= FEW {
            points.to_vec()
        } else {
            outermost(points)
        };
        let even = 1.0 / taking_part.len() as f64;
        let mut weighted = Self {
            weights: vec![even; taking_part.len()],
            points: taking_part,
            dimensions,
        };
        let mut steps = 0;
        loop {
            weighted.improve(&mut steps);
            if points.len() <= FEW {
                return weighted;
            }
            // the others: does one of them lie outside?
            let levels = Levels(weighted.moments().inverse());
            let (outermost, level) = largest(points, points[0], |point| levels.of(point));
            let all_inside = level <= weighted.best() * (1.0 + 2.0 * NEAR_LEAST);
            if all_inside || MOST_STEPS <= steps {
                return weighted;
            }
            weighted.points.push(outermost);
            weighted.weights.push(0.0);
        }
    }

    /// The level of the points on the best ellipsoid.
    fn best(&self) -> f64 {
        (self.dimensions + 1) as f64
    }

    /// Moves weight until no point that takes part lies outside by more than [`NEAR_LEAST`].
    ///
    /// The step to a point of level κ that makes the volume least, u ← (1 − β)u + β there, is
    /// β = (κ − D)/(D(κ − 1)) with D one more than the dimensions: above 0 outside, below 0 inside, and no
    /// lower than takes all weight from the point.
    fn improve(&mut self, steps: &mut usize) {
        let best = self.best();
        while *steps < MOST_STEPS {
            *steps += 1;
            let levels = Levels(self.moments().inverse());
            let (mut outer, mut inner) = ((0, 0.0), (0, f64::INFINITY));
            for (i, (&point, &weight)) in self.points.iter().zip(&self.weights).enumerate() {
                let level = levels.of(point);
                if outer.1 < level {
                    outer = (i, level);
                }
                if 0.0 < weight && level < inner.1 {
                    inner = (i, level);
                }
            }
            let (outside, inside) = (outer.1 / best - 1.0, 1.0 - inner.1 / best);
            if outside <= NEAR_LEAST {
                return;
            }
            let (at, level) = if inside <= outside { outer } else { inner };
            let least = -self.weights[at] / (1.0 - self.weights[at]);
            // a level of 1 or less is that of a point so far inside that it is better without weight
            let step = if level <= 1.0 {
                least
            } else {
                ((level - best) / (best * (level - 1.0))).max(least)
            };
            for weight in &mut self.weights {
                *weight *= 1.0 - step;
            }
            self.weights[at] = if step <= least {
                0.0
            } else {
                self.weights[at] + step
            };
        }
    }

    /// M = Σ u·q·qᵀ; for flat points with a 1 where the third coordinate has only zeros.
    fn moments(&self) -> DMat4 {
        let mut sum = DMat4::ZERO;
        for (&point, &weight) in self.points.iter().zip(&self.weights) {
            let q = point.extend(1.0);
            let column = |x: f64| (weight * x) * q;
            sum += DMat4::from_cols(column(q.x), column(q.y), column(q.z), column(q.w));
        }
        if self.dimensions == 2 {
            sum.z_axis.z = 1.0;
        }
        sum
    }

    /// The ellipsoid's center, and a lower triangular matrix that maps the unit sphere to the ellipsoid
    /// around it: the root of the covariance times the dimensions (A. Cholesky).
    fn mean_and_root(&self) -> (DVec3, DMat3) {
        let weighted = || self.points.iter().zip(&self.weights);
        let mean: DVec3 = weighted().map(|(&p, &u)| u * p).sum();
        let mut covariance = DMat3::ZERO;
        for (&point, &weight) in weighted() {
            let off = point - mean;
            let column = |x: f64| (self.dimensions as f64 * weight * x) * off;
            covariance += DMat3::from_cols(column(off.x), column(off.y), column(off.z));
        }
        if self.dimensions == 2 {
            covariance.z_axis.z = 1.0;
        }
        (mean, cholesky(covariance))
    }
}

/// M⁻¹, which gives each point its level.
struct Levels(DMat4);

impl Levels {
    fn of(&self, point: DVec3) -> f64 {
        let q: DVec4 = point.extend(1.0);
        q.dot(self.0 * q)
    }
}

/// The points that lie furthest along 13 directions and against them: those of the faces, edges and corners
/// of a cube.
fn outermost(points: &[DVec3]) -> Vec<DVec3> {
    let mut found: Vec<DVec3> = Vec::new();
    for number in 0..27 {
        let direction = [1, 3, 9].map(|place| f64::from(number / place % 3 - 1));
        let direction = DVec3::from(direction);
        // the points are around 0, so that some are in front of it
        let (outermost, _) = largest(points, points[0], |point| direction.dot(point));
        if !found.contains(&outermost) {
            found.push(outermost);
        }
    }
    found
}

/// The first of the points for which a quantity is largest, and that; `otherwise` if it is 0 for all.
fn largest(points: &[DVec3], otherwise: DVec3, quantity: impl Fn(DVec3) -> f64) -> (DVec3, f64) {
    let mut largest = (otherwise, 0.0);
    for &point in points {
        let of_point = quantity(point);
        if largest.1 < of_point {
            largest = (point, of_point);
        }
    }
    largest
}

/// The lower triangular L with L·Lᵀ = a symmetric matrix.
fn cholesky(a: DMat3) -> DMat3 {
    let x = a.x_axis.x.sqrt();
    let (xy, xz) = (a.x_axis.y / x, a.x_axis.z / x);
    let y = (a.y_axis.y - xy * xy).sqrt();
    let yz = (a.y_axis.z - xy * xz) / y;
    let z = (a.z_axis.z - xz * xz - yz * yz).sqrt();
    DMat3::from_cols(
        DVec3::new(x, xy, xz),
        DVec3::new(0.0, y, yz),
        DVec3::new(0.0, 0.0, z),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The weights are within 10⁻⁹ of the best, so lengths are within some 10⁻⁹ of the least.
    const NEAR: f64 = 1e-7;

    /// The half axes from the shortest to the longest.
    fn sorted(radii: DVec3) -> [f64; 3] {
        let mut radii = radii.to_array();
        radii.sort_by(f64::total_cmp);
        radii
    }

    #[track_caller]
    fn check(points: &[DVec3], center: [f64; 3], radii: [f64; 3]) -> LeastEllipsoid {
        let found = least_ellipsoid(points, false).unwrap();
        let ellipsoid = &found.ellipsoid;
        let off = (ellipsoid.center - DVec3::from(center)).length();
        assert!(off <= NEAR * radii[2].max(1.0), "{ellipsoid:?}");
        for (found, expected) in sorted(ellipsoid.radii).into_iter().zip(radii) {
            let near = NEAR * expected.max(1.0);
            assert!((found - expected).abs() <= near, "{ellipsoid:?}");
        }
        found
    }

    /// The corners of a box.
    fn corners(min: [f64; 3], max: [f64; 3]) -> Vec<DVec3> {
        let corner = |i: usize| [0, 1, 2].map(|axis| [min, max][i >> axis & 1][axis]);
        (0..8).map(|i| DVec3::from(corner(i))).collect()
    }

    #[test]
    fn the_corners_of_a_box_have_half_its_sides_times_root_3() {
        let root = 3.0_f64.sqrt();
        let points = corners([1.0, 2.0, 3.0], [3.0, 6.0, 9.0]);
        check(&points, [2.0, 4.0, 6.0], [root, 2.0 * root, 3.0 * root]);
    }

    #[test]
    fn points_within_that_ellipsoid_change_nothing_and_one_outside_does() {
        let root = 3.0_f64.sqrt();
        let mut points = corners([1.0, 2.0, 3.0], [3.0, 6.0, 9.0]);
        points.insert(0, DVec3::new(2.0, 4.0, 6.0));
        points.push(DVec3::new(3.0, 4.5, 7.0));
        check(&points, [2.0, 4.0, 6.0], [root, 2.0 * root, 3.0 * root]);
        // in units of the half sides (2, 0, 0): with it x²/4 + (y² + z²)·3/8 ≤ 1 is the least, and touches all nine
        points.push(DVec3::new(4.0, 4.0, 6.0));
        let across = (8.0_f64 / 3.0).sqrt();
        check(&points, [2.0, 4.0, 6.0], [2.0, 2.0 * across, 3.0 * across]);
    }

    #[test]
    fn of_many_points_the_outermost_settle_the_ellipsoid() {
        // a lattice of 4 × 4 × 4, of which the corners of the cube settle it
        let mut points = Vec::new();
        for i in 0..64 {
            let place = [1, 4, 16].map(|stride| f64::from(i / stride % 4 + 1));
            points.push(DVec3::from(place));
        }
        let radius = 1.5 * 3.0_f64.sqrt();
        check(&points, [2.5; 3], [radius; 3]);
    }

    #[test]
    fn a_cylinder_of_points_has_the_ellipsoid_of_its_rims_however_long_it_is() {
        // circles of 12 points on an axis, made long along (2, 1, 0): of 24 points all take part, of 48 the outermost
        let (along, across) = (DVec3::new(2.0, 1.0, 0.0), DVec3::new(-1.0, 2.0, 0.0));
        for heights in [&[1.0, 7.0][..], &[1.0, 3.0, 5.0, 7.0]] {
            let mut points = Vec::new();
            for z in heights {
                for (x, y) in [(5.0, 0.0), (4.0, 3.0), (3.0, 4.0)] {
                    for (x, y) in [(x, y), (-y, x), (-x, -y), (y, -x)] {
                        points.push(20.0 * x * along + y * across + *z * DVec3::Z);
                    }
                }
            }
            // radius 5, height 6: 5·√1.5 across, which is √5 and 20·√5 times as long here, and 6·√¾ along
            let across = 5.0 * 7.5_f64.sqrt();
            let radii = [3.0 * 3.0_f64.sqrt(), across, 20.0 * across];
            check(&points, [0.0, 0.0, 4.0], radii);
        }
    }

    /// Points of a circle of radius 5 around (7, 1), in the directions from 0° and 180° and halfway between the axes and the
    /// diagonals; on these, just within, points that a search along axes and diagonals finds in their place; and as many more.
    fn circle_with_decoys(more: usize) -> Vec<DVec3> {
        let at = |eighths: f64, radius: f64| {
            let (sine, cosine) = (eighths * std::f64::consts::FRAC_PI_4).sin_cos();
            DVec3::new(7.0 + radius * cosine, 1.0 + radius * sine, 3.0)
        };
        let mut points = vec![at(0.0, 5.0), at(4.0, 5.0)];
        points.extend((0..8).map(|i| at(f64::from(i) + 0.5, 5.0)));
        points.extend([1.0, 2.0, 3.0, 5.0, 6.0, 7.0].map(|eighths| at(eighths, 4.85)));
        points.extend((0..more).map(|i| at(0.7 * i as f64, 2.0)));
        points
    }

    #[test]
    fn a_point_that_no_direction_of_the_cube_finds_is_found_outside() {
        for more in [0, 30] {
            check(&circle_with_decoys(more), [7.0, 1.0, 3.0], [0.0, 5.0, 5.0]);
        }
    }

    #[test]
    fn no_point_lies_outside_and_the_outermost_on_the_surface() {
        let mut box_and_more = corners([1.0, 2.0, 3.0], [3.0, 6.0, 9.0]);
        box_and_more.push(DVec3::new(3.9, 4.1, 6.3));
        for points in [box_and_more, circle_with_decoys(30)] {
            let ellipsoid = least_ellipsoid(&points, false).unwrap().ellipsoid;
            let thick = OrientedEllipsoid {
                radii: ellipsoid.radii.max(DVec3::splat(1e-3)),
                ..ellipsoid
            };
            let levels = points.iter().map(|&p| thick.level(p));
            let largest = levels.fold(0.0, f64::max);
            assert!((largest - 1.0).abs() <= 1e-14, "{largest}");
        }
    }

    #[test]
    fn in_its_frame_points_fill_the_box_from_minus_1_to_1() {
        let mut points = corners([1.0, 2.0, 3.0], [3.0, 6.0, 9.0]);
        points.push(DVec3::new(3.9, 4.1, 6.3));
        let frame = Frame::of(&points).unwrap();
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for &point in &points {
            low = low.min(frame.normed(point, false));
            high = high.max(frame.normed(point, false));
        }
        assert!((low + 1.0).abs().max_element() <= 1e-14, "{low}");
        assert!((high - 1.0).abs().max_element() <= 1e-14, "{high}");
        assert_eq!(frame.normed(points[0], true).z, 0.0);
    }

    #[test]
    fn a_triangle_has_the_ellipse_around_it_whose_center_is_the_mean_of_its_corners() {
        // J. Steiner's ellipse: of an equilateral triangle with sides of 2 the circle, of radius 2/√3
        let height = 3.0_f64.sqrt();
        let triangle = [[1.0, 2.0, 5.0], [3.0, 2.0, 5.0], [2.0, 2.0 + height, 5.0]];
        let circle = 2.0 / height;
        let points = triangle.map(DVec3::from);
        let center = [2.0, 2.0 + height / 3.0, 5.0];
        let found = check(&points, center, [0.0, circle, circle]);
        assert_eq!(found.ellipsoid.radii.z, 0.0);
        assert!(found.ellipsoid.axes[2].z.abs() >= 1.0 - 1e-12);
        // stretched threefold along x
        let stretched = points.map(|p| DVec3::new(3.0 * p.x, p.y, p.z));
        let center = [6.0, 2.0 + height / 3.0, 5.0];
        let found = check(&stretched, center, [0.0, circle, 3.0 * circle]);
        assert_eq!(found.off_plane, Some(0.0));
    }

    #[test]
    fn points_count_as_flat_up_to_a_hundred_thousandth_of_their_length() {
        let rectangle = |height: f64| {
            let corners = [
                [1.0, 1.0, 5.0],
                [9.0, 1.0, 5.0 + height],
                [9.0, 5.0, 5.0],
                [1.0, 5.0, 5.0 + height],
            ];
            least_ellipsoid(&corners.map(DVec3::from), false).unwrap()
        };
        // every other corner is lifted: half the diagonal is 4.47, of which 10⁻⁵ is 45 millionths
        let flat = rectangle(40e-6).off_plane.unwrap();
        assert!((flat - 40e-6).abs() <= 1e-12, "{flat}");
        assert_eq!(rectangle(50e-6).off_plane, None);
        // and what is said to be flat is
        let bent = [[0.0; 3], [1.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0, 1.0, 0.1]];
        let told = least_ellipsoid(&bent.map(DVec3::from), true).unwrap();
        assert!(told.off_plane.is_some());
        assert_eq!(told.ellipsoid.radii.z, 0.0);
    }

    #[test]
    fn points_on_a_line_and_too_few_points_have_no_ellipsoid() {
        let line = [1.0, 2.0, 4.0].map(|t| t * DVec3::new(1.0, 2.0, 2.0));
        assert_eq!(least_ellipsoid(&line, false), None);
        assert_eq!(least_ellipsoid(&line[..1], false), None);
        assert_eq!(least_ellipsoid(&[], false), None);
    }

    #[test]
    fn cholesky_finds_the_lower_triangle_whose_square_a_matrix_is() {
        // L = (2 0 0 | 1 2 0 | 3 1 2): L·Lᵀ has 2·2, 2·1, 2·3; 1 + 4, 3 + 2; 9 + 1 + 4
        let square = DMat3::from_cols(
            DVec3::new(4.0, 2.0, 6.0),
            DVec3::new(2.0, 5.0, 5.0),
            DVec3::new(6.0, 5.0, 14.0),
        );
        let lower = DMat3::from_cols(
            DVec3::new(2.0, 1.0, 3.0),
            DVec3::new(0.0, 2.0, 1.0),
            DVec3::new(0.0, 0.0, 2.0),
        );
        assert_eq!(cholesky(square), lower);
    }

    #[test]
    fn the_outermost_of_a_lattice_are_the_corners_of_its_cube() {
        let mut lattice = Vec::new();
        for i in 0..27 {
            let place = [1, 3, 9].map(|stride| f64::from(i / stride % 3 - 1));
            lattice.push(DVec3::from(place));
        }
        let mut found = outermost(&lattice);
        let order = |p: &DVec3| (p.x + 2.0 * p.y + 4.0 * p.z) as i32;
        found.sort_by_key(order);
        let mut expected = corners([-1.0; 3], [1.0; 3]);
        expected.sort_by_key(order);
        assert_eq!(found, expected);
    }

    #[test]
    fn of_equal_quantities_the_first_is_the_largest_and_of_zeros_none() {
        let points = [DVec3::X, DVec3::Y, DVec3::Z];
        let by_length = |p: DVec3| p.length();
        assert_eq!(largest(&points, DVec3::ONE, by_length), (DVec3::X, 1.0));
        assert_eq!(largest(&points, DVec3::ONE, |_| 0.0), (DVec3::ONE, 0.0));
        let by_z = |p: DVec3| 2.0 * p.z;
        assert_eq!(largest(&points, DVec3::ONE, by_z), (DVec3::Z, 2.0));
    }

    /// The weights after one step.
    fn after_one_step(points: &[[f64; 2]], weights: &[f64]) -> Vec<f64> {
        let point = |&[x, y]: &[f64; 2]| DVec3::new(x, y, 0.0);
        let mut weighted = Weighted {
            points: points.iter().map(point).collect(),
            weights: weights.to_vec(),
            dimensions: 2,
        };
        let mut steps = MOST_STEPS - 1;
        weighted.improve(&mut steps);
        assert_eq!(steps, MOST_STEPS);
        weighted.weights
    }

    #[track_caller]
    fn check_weights(found: &[f64], expected: &[f64]) {
        let near = |(found, expected): (&f64, &f64)| (found - expected).abs() <= 1e-15;
        assert!(
            found.iter().zip(expected).all(near),
            "{found:?}, expected {expected:?}"
        );
    }

    const CROSS: [[f64; 2]; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

    #[test]
    fn a_step_to_a_point_that_lies_outside_has_the_length_that_makes_the_area_least() {
        // M has 0.4, 0.6 and 1 on its diagonal: levels of 1/0.4 + 1 = 3.5 and 1/0.6 + 1. The first lies outside by a sixth, the
        // others inside by a ninth: β = (3.5 − 3)/(3·2.5) = 1/15
        let found = after_one_step(&CROSS, &[0.2, 0.2, 0.3, 0.3]);
        let rest = 14.0 / 15.0;
        check_weights(
            &found,
            &[0.2 * rest + 1.0 / 15.0, 0.2 * rest, 0.3 * rest, 0.3 * rest],
        );
    }

    #[test]
    fn a_point_in_the_middle_loses_all_its_weight_at_once() {
        // M has 0.4 and 0.4: levels of 3.5 on the cross, a sixth outside, and 1 in the middle, two thirds inside
        let points = [&CROSS[..], &[[0.0; 2]]].concat();
        let found = after_one_step(&points, &[0.2; 5]);
        check_weights(&found, &[0.25, 0.25, 0.25, 0.25, 0.0]);
    }

    #[test]
    fn a_point_inside_with_too_much_weight_gives_some_of_it_away() {
        // a cross of 1 with 0.15 at each end, and one of 0.9 with 0.1: M has 0.3 + 0.2·0.81 = 0.462 twice. The outer ends lie
        // outside by 0.055, the inner ones, of level κ = 0.81/0.462 + 1 = 2.753, inside by 0.082
        let inner = CROSS.map(|point| point.map(|x| 0.9 * x));
        let weights = [0.15, 0.15, 0.15, 0.15, 0.1, 0.1, 0.1, 0.1];
        let found = after_one_step(&[CROSS, inner].concat(), &weights);
        // β = (κ − 3)/(3(κ − 1)) = −0.047
        let level = 0.81 / 0.462 + 1.0;
        let step = (level - 3.0) / (3.0 * (level - 1.0));
        let mut expected = weights.map(|weight| weight * (1.0 - step));
        expected[4] += step;
        check_weights(&found, &expected);
    }
}
