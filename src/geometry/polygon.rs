//! The polygon: convex or concave, any number of vertices.
//!
//! What is constant for all rays is computed here, once: the plane, the coordinate to drop and the
//! projected outline. [`Plane::test`] then finds the point p on the plane, and the module
//! `point_in_polygon` decides whether p lies inside (Fig. 15.57).

use std::fmt;

use glam::{DVec2, DVec3};

use crate::geometry::corners::Corners;
use crate::geometry::plane::FLAT;
use crate::geometry::{Axis, Plane, PlaneTest, Ray, Sides, TRange};

/// The some twenty roundings of t and of o + t·Δ, as a share of the numbers that enter (v).
pub(crate) const OUTLINE_ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A polygon in space with everything that does not depend on a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    pub(super) plane: Plane,
    /// The largest distance of a vertex from the plane, and the rounding of that.
    pub(super) off_plane: f64,
    /// The projected outline, what the projection drops, and the normals for smooth shading.
    pub(super) corners: Corners,
}

/// A vertex may lie off the plane by this share of the polygon's size: coordinates that were written
/// with six digits.
pub(crate) const PLANARITY: f64 = 1e-5;

/// A ray that hits the plane more flatly than 1 in 64 has its t kept to the outline; one that does
/// not can hit the plane up to 64 times the vertices' distance from it away from them.
const FLATTEST: f64 = 1.0 / FLAT;

/// Why a list of vertices is no polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PolygonError {
    /// Fewer than three.
    TooFewVertices {
        /// How many there are.
        count: usize,
    },
    /// All on one line, or the outline has no area.
    NoArea,
    /// A vertex lies off the plane of the others.
    NotPlanar {
        /// The vertex that is furthest off, counted from 0.
        vertex: usize,
        /// Its distance from the plane.
        distance: f64,
        /// The largest distance that is allowed for a polygon of this size.
        allowed: f64,
    },
    /// The normals are not one per vertex.
    NormalCount {
        /// How many normals there are.
        normals: usize,
        /// How many vertices.
        vertices: usize,
    },
    /// A normal has no direction.
    NormalWithoutDirection {
        /// The vertex it belongs to, counted from 0.
        vertex: usize,
    },
}

impl fmt::Display for PolygonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooFewVertices { count } => {
                write!(f, "a polygon needs at least 3 vertices, here are {count}")
            }
            Self::NoArea => f.write_str("the vertices are on one line or enclose no area"),
            Self::NotPlanar {
                vertex,
                distance,
                allowed,
            } => write!(
                f,
                "the polygon is not planar: vertex {vertex} lies {distance:.3e} off the plane of the \
                 others, and {allowed:.3e} is allowed for its size"
            ),
            Self::NormalCount { normals, vertices } => write!(
                f,
                "a polygon has one normal per vertex or none: {normals} normals for {vertices} vertices"
            ),
            Self::NormalWithoutDirection { vertex } => {
                write!(f, "the normal of vertex {vertex} has length 0")
            }
        }
    }
}

impl std::error::Error for PolygonError {}

impl Polygon {
    /// The polygon with these vertices, in order around it, counter-clockwise from its front.
    ///
    /// `normals`, if given, is one normal per vertex of any length above 0.
    ///
    /// # Errors
    /// Fewer than three vertices, no area, a vertex further off the plane than 10⁻⁵ of the size, or
    /// normals that do not fit.
    pub fn new(vertices: Vec<DVec3>, normals: Option<Vec<DVec3>>) -> Result<Self, PolygonError> {
        let (plane, off_plane) = Self::plane_of(&vertices)?;
        let dropped = Axis::of_largest(plane.normal);
        let normals = normals
            .map(|normals| unit_normals(normals, vertices.len()))
            .transpose()?;
        Ok(Self {
            plane,
            off_plane,
            corners: Corners::new(vertices, normals, dropped),
        })
    }

    /// Returns the plane of an outline, and how far its vertices lie off it, rounding included: what
    /// [`Polygon::new`] checks of the vertices, without a polygon.
    ///
    /// # Errors
    /// Fewer than three vertices, no area, or a vertex further off the plane than 10⁻⁵ of the size.
    pub(crate) fn plane_of(vertices: &[DVec3]) -> Result<(Plane, f64), PolygonError> {
        if vertices.len() < 3 {
            return Err(PolygonError::TooFewVertices {
                count: vertices.len(),
            });
        }
        let plane = Plane::newell(vertices).ok_or(PolygonError::NoArea)?;
        let off_plane = planarity(&plane, vertices)?;
        Ok((plane, off_plane))
    }

    /// The vertices, in order.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = DVec3> + Clone {
        let dropped = self.dropped();
        let pairs = self.outline().iter().zip(self.corners.heights());
        pairs.map(move |(&p, &height)| dropped.put_back(p, height))
    }

    /// One of the vertices, counted from 0.
    #[inline]
    pub(super) fn vertex(&self, index: usize) -> DVec3 {
        let (p, height) = (self.outline()[index], self.corners.heights()[index]);
        self.dropped().put_back(p, height)
    }

    /// The vertices projected along [`Polygon::dropped`].
    #[inline]
    pub fn outline(&self) -> &[DVec2] {
        self.corners.outline()
    }

    /// One unit normal per vertex, if the polygon is to be shaded smoothly.
    pub fn normals(&self) -> Option<&[DVec3]> {
        self.corners.normals()
    }

    /// The polygon's plane.
    pub fn plane(&self) -> Plane {
        self.plane
    }

    /// The largest distance of a vertex from the plane, and the rounding of that.
    pub(crate) fn off_plane(&self) -> f64 {
        self.off_plane
    }

    /// How far a computed hit may lie off the vertices' extent, as they are not quite in one plane: the room that a volume
    /// around the polygon has for that. A length.
    pub fn room(&self) -> f64 {
        self.off_plane * FLATTEST
    }

    /// The coordinate that the projection drops: the one whose coefficient in (iv) has the largest
    /// absolute value.
    #[inline]
    pub fn dropped(&self) -> Axis {
        self.corners.dropped()
    }

    /// Where does the ray hit the polygon's plane? Whether that point lies inside is
    /// [`Polygon::contains`].
    ///
    /// t of (v), unless the ray is flat: |A·Δx + B·Δy + C·Δz| ≤ (|Δx| + |Δy| + |Δz|)/64. Then the division
    /// stretches the rounding of the numerator, and t may lie before or behind the whole polygon. Within that
    /// error it is brought to the nearest t at which the ray passes through the outline, as seen along the dropped
    /// axis, so that a hit lies in the polygon and whoever looks for hits there finds this one. It depends on nothing
    /// but the ray and the polygon.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Polygon, Ray, Sides, TRange};
    ///
    /// let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [0.0, 4.0, 5.0]].map(DVec3::from_array);
    /// let triangle = Polygon::new(corners.to_vec(), None).unwrap();
    /// let ray = Ray::new(DVec3::new(1.0, 1.0, 0.0), DVec3::Z);
    /// let test = triangle.plane_test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!(test.chosen(), Some(5.0));
    /// ```
    #[inline]
    pub fn plane_test(&self, ray: &Ray, range: TRange, sides: Sides) -> PlaneTest {
        let settled = |t| self.settled_in_outline(ray, t);
        self.plane.test_settled(ray, range, sides, settled)
    }

    /// The t closest to this one at which the ray passes through the outline, if the error of t reaches as far;
    /// else t itself, for then the ray misses the polygon.
    #[cold]
    fn settled_in_outline(&self, ray: &Ray, t: f64) -> f64 {
        let error = self.tolerance(ray, t) / ray.direction.abs().element_sum();
        self.nearest_in_outline(ray, t)
            .filter(|nearest| (nearest - t).abs() <= error)
            .unwrap_or(t)
    }

    /// The t closest to this one at which the ray, projected along [`Polygon::dropped`], is in the outline; `None` if
    /// it passes by.
    ///
    /// That is t itself if an odd number of edges lies ahead of it on the ray; else one at which the ray enters or
    /// leaves. A vertex counts as passed within the rounding of its coordinates and of the ray's, and so does an
    /// edge along the ray. A flat ray does not run along the dropped axis, so that its projection is a line.
    fn nearest_in_outline(&self, ray: &Ray, t: f64) -> Option<f64> {
        let origin = self.dropped().drop_from(ray.origin);
        let direction = self.dropped().drop_from(ray.direction);
        // t of the point of the line that is closest to p, and how far p lies beside the line, times |Δ′|
        let along = |p: DVec2| (p - origin).dot(direction) / direction.length_squared();
        let beside = |p: DVec2| direction.perp_dot(p - origin);
        let is_passed = |p: DVec2| {
            let reach = origin.abs().element_sum() + p.abs().element_sum();
            beside(p).abs() <= OUTLINE_ROUNDING * reach * direction.abs().element_sum()
        };

        let mut nearest: Option<f64> = None;
        let mut consider = |candidate: f64| {
            if nearest.is_none_or(|known| (candidate - t).abs() < (known - t).abs()) {
                nearest = Some(candidate);
            }
        };
        let mut ahead = 0;
        let mut from = *self.outline().last()?;
        for &to in self.outline() {
            let (from_side, to_side) = (beside(from), beside(to));
            if (from_side < 0.0) != (to_side < 0.0) {
                let share = from_side / (from_side - to_side);
                let crossed = along(from + share * (to - from));
                ahead += u32::from(t < crossed);
                consider(crossed);
            }
            if is_passed(to) {
                consider(along(to));
                if is_passed(from) {
                    let (a, b) = (along(from), along(to));
                    consider(t.max(a.min(b)).min(a.max(b)));
                }
            }
            from = to;
        }
        if ahead % 2 == 1 { Some(t) } else { nearest }
    }
}

/// How far the vertices are off their plane, with the rounding of that; an error beyond [`PLANARITY`].
fn planarity(plane: &Plane, vertices: &[DVec3]) -> Result<f64, PolygonError> {
    let origin = vertices[0];
    let (mut worst, mut distance) = (0, 0.0);
    let (mut size, mut reach): (f64, f64) = (0.0, 0.0);
    for (i, &vertex) in vertices.iter().enumerate() {
        let off = plane.distance(vertex).abs();
        if distance < off {
            (worst, distance) = (i, off);
        }
        size = size.max((vertex - origin).length());
        reach = reach.max(vertex.abs().element_sum());
    }
    // four roundings in the distance, on terms of at most `reach`
    let rounding = 8.0 * f64::EPSILON * reach;
    let allowed = PLANARITY * size;
    if allowed + rounding < distance {
        return Err(PolygonError::NotPlanar {
            vertex: worst,
            distance,
            allowed,
        });
    }
    Ok(distance + rounding)
}

fn unit_normals(normals: Vec<DVec3>, vertices: usize) -> Result<Box<[DVec3]>, PolygonError> {
    if normals.len() != vertices {
        return Err(PolygonError::NormalCount {
            normals: normals.len(),
            vertices,
        });
    }
    // one of unit length stays as it is, bit for bit: a log gives back the scene it was made from
    const UNIT: f64 = 16.0 * f64::EPSILON;
    let unit = |(vertex, normal): (usize, DVec3)| {
        if (normal.length_squared() - 1.0).abs() <= UNIT {
            return Ok(normal);
        }
        normal
            .try_normalize()
            .ok_or(PolygonError::NormalWithoutDirection { vertex })
    };
    normals.into_iter().enumerate().map(unit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::PlaneVerdict;

    fn points(list: &[[f64; 3]]) -> Vec<DVec3> {
        list.iter().map(|&p| p.into()).collect()
    }

    #[test]
    fn plane_and_outline_are_those_of_the_vertices() {
        let floor = points(&[
            [-9.0, 0.0, -9.0],
            [-9.0, 0.0, 9.0],
            [9.0, 0.0, 9.0],
            [9.0, 0.0, -9.0],
        ]);
        let polygon = Polygon::new(floor, None).unwrap();
        assert_eq!(
            polygon.plane(),
            Plane {
                normal: DVec3::Y,
                d: 0.0
            }
        );
        assert_eq!(polygon.dropped(), Axis::Y);
        assert_eq!(polygon.outline()[0], DVec2::new(-9.0, -9.0));
        assert_eq!(polygon.outline()[1], DVec2::new(-9.0, 9.0));
    }

    #[test]
    fn vertices_are_put_together_again_bit_for_bit() {
        for corners in [
            vec![[0.1, -0.0, 0.3], [1.7, 0.2, 0.1], [0.4, 1.1, 0.9]],
            vec![
                [5.0, 0.1, 0.2],
                [5.0, 3.3, 0.0],
                [5.0, 3.0, 3.0],
                [5.0, -0.0, 3.1],
            ],
            vec![[0.1, -7.0, 0.2], [3.3, -7.0, 0.0], [3.0, -7.0, 3.0]],
        ] {
            let corners = points(&corners);
            let polygon = Polygon::new(corners.clone(), None).unwrap();
            let bits = |v: DVec3| v.to_array().map(f64::to_bits);
            assert!(
                polygon
                    .vertices()
                    .map(bits)
                    .eq(corners.into_iter().map(bits))
            );
        }
    }

    /// t of (v) as it is divided, t of the test, and whether it is inside.
    fn flat(polygon: &Polygon, ray: &Ray) -> (f64, f64, bool) {
        let meet = |range| match polygon.plane_test(ray, range, Sides::Both) {
            PlaneTest {
                verdict: PlaneVerdict::Meets(root),
                numerator,
                denominator,
                ..
            } => (-numerator / denominator, root.t),
            other => panic!("{other:?}"),
        };
        let (quotient, t) = meet(TRange::FORWARD);
        let near = TRange {
            min: 1e-3,
            max: 1.0,
        };
        assert_eq!(
            meet(near).1.to_bits(),
            t.to_bits(),
            "t depends on the range"
        );
        (quotient, t, polygon.contains(ray, t).inside)
    }

    #[test]
    fn a_flat_ray_hits_within_the_extent_whatever_its_division_gives() {
        let [a, b, c] = [[1.0, 2.0, 3.0], [5.0, 3.0, 1.0], [2.0, 6.0, 4.0]].map(DVec3::from);
        let triangle = Polygon::new(vec![a, b, c], None).unwrap();
        // inside, next to b: b + (a − b)/2048 + (c − b)/2048, with (−4, −1, 2) and (−3, 3, 3)
        let p = b + DVec3::new(-7.0, 2.0, 5.0) / 2048.0;
        let mut outside = 0;
        // along a → b = (4, 1, −2), tilted by about 10⁻⁹ and 10⁻¹² either way
        for tilt in [30, -30, 40, -40]
            .map(|power: i32| f64::from(power.signum()) * 0.5f64.powi(power.abs()))
        {
            let direction = DVec3::new(4.0, 1.0, -2.0 + tilt);
            for exact in [8.0, 64.0, 512.0, 1024.0] {
                // no product or sum here has more than 53 bits: the ray goes through p at t = `exact`
                let ray = Ray::new(p - exact * direction, direction);
                // whether it is inside is rounding: the ray sees the triangle 10⁻¹² as high as it is long
                let (quotient, t, _) = flat(&triangle, &ray);
                // x is 1 a little less than 1 before p, and 5 at 7/(4·2048) behind it
                let (near, far) = (exact - 1.0 + 7.0 / 8192.0, exact + 7.0 / 8192.0);
                assert!(near - 1e-12 <= t && t <= far + 1e-12, "{near} {t} {far}");
                outside += usize::from(!(near..=far).contains(&quotient));
            }
        }
        // else this test would hold without bringing t anywhere
        assert!(2 <= outside, "{outside}");
    }

    #[test]
    fn a_flat_ray_that_passes_through_the_extent_beside_the_polygon_keeps_its_t() {
        // x = z, met under 0.3°: x − z is ¼ at t = 4, in the middle of the extent, and 0 at 4 + 128/4
        let slanted = points(&[[0.0; 3], [1.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
        let triangle = Polygon::new(slanted, None).unwrap();
        let direction = DVec3::new(1.0, 0.0, 1.0 + 1.0 / 128.0);
        let ray = Ray::new(DVec3::new(0.25, 0.25, 0.0) - 4.0 * direction, direction);
        let (quotient, t, is_inside) = flat(&triangle, &ray);
        assert_eq!(t, quotient);
        assert!((t - 36.0).abs() <= 1e-11, "{t}");
        assert!(!is_inside);
    }

    #[test]
    fn t_of_a_ray_in_the_plane_is_brought_to_where_it_passes_through_the_outline() {
        // a square of 6 with a notch from x = 2 to 4, open at the top, down to y = 2
        let u = points(&[
            [0.0, 0.0, 5.0],
            [6.0, 0.0, 5.0],
            [6.0, 6.0, 5.0],
            [4.0, 6.0, 5.0],
            [4.0, 2.0, 5.0],
            [2.0, 2.0, 5.0],
            [2.0, 6.0, 5.0],
            [0.0, 6.0, 5.0],
        ]);
        let polygon = Polygon::new(u, None).unwrap();
        // along x from x = −1: at y = 4 it is inside for t from 1 to 3 and from 5 to 7, also along the top edges;
        // at y = 1 from 1 to 7; at y = 7 nowhere
        for (y, t, nearest) in [
            (4.0, -5.0, Some(1.0)),
            (4.0, 2.0, Some(2.0)),
            (4.0, 3.5, Some(3.0)),
            (4.0, 4.5, Some(5.0)),
            (4.0, 100.0, Some(7.0)),
            (6.0, 3.5, Some(3.0)),
            (6.0, 6.5, Some(6.5)),
            (1.0, 4.0, Some(4.0)),
            (7.0, 4.0, None),
        ] {
            let ray = Ray::new(DVec3::new(-1.0, y, 5.0), DVec3::X);
            assert_eq!(
                polygon.nearest_in_outline(&ray, t),
                nearest,
                "y = {y}, t = {t}"
            );
        }
        // down the diagonal from (−2, 8): it passes the corner (0, 6) at t = 2, and leaves by (6, 0) at t = 8
        let diagonal = Ray::new(DVec3::new(-2.0, 8.0, 5.0), DVec3::new(1.0, -1.0, 0.0));
        assert_eq!(polygon.nearest_in_outline(&diagonal, 0.0), Some(2.0));
        assert_eq!(polygon.nearest_in_outline(&diagonal, 9.0), Some(8.0));
    }

    #[test]
    fn a_vertex_off_the_plane_is_an_error_that_says_by_how_much() {
        let bent = points(&[
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.4],
        ]);
        let Err(PolygonError::NotPlanar { distance, .. }) = Polygon::new(bent, None) else {
            panic!("a bent polygon was taken");
        };
        // The normal is half the cross product of the diagonals (1, 1, 0) and (−1, 1, 0.4):
        // (0.4, −0.4, 2)/√4.32; the mean is (½, ½, 0.1), and (0, 1, 0.4) lies 0.2/√4.32 off.
        assert!(
            (distance - 0.2 / 4.32f64.sqrt()).abs() <= 1e-15,
            "{distance}"
        );
    }

    #[test]
    fn rounding_to_six_digits_is_still_planar() {
        let third = points(&[
            [0.0, 0.0, 0.333_333],
            [3.0, 0.0, 1.333_33],
            [3.0, 1.0, 1.333_33],
            [0.0, 1.0, 0.333_335],
        ]);
        assert!(Polygon::new(third, None).is_ok());
    }

    #[test]
    fn normals_must_fit_the_vertices() {
        let triangle = points(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        let with = |normals: &[[f64; 3]]| Polygon::new(triangle.clone(), Some(points(normals)));
        let up = [0.0, 0.0, 2.0];
        assert_eq!(with(&[up, up, up]).unwrap().normals().unwrap()[0], DVec3::Z);
        assert_eq!(
            with(&[up, up]),
            Err(PolygonError::NormalCount {
                normals: 2,
                vertices: 3
            })
        );
        assert_eq!(
            with(&[up, [0.0; 3], up]),
            Err(PolygonError::NormalWithoutDirection { vertex: 1 })
        );
    }

    #[test]
    fn how_far_a_vertex_may_be_off_is_measured_by_the_polygon_not_by_its_place() {
        // two corners up by h and two down: the plane is z = 0 and each lies h off; the size is 2
        let saddle = |h: f64, z: f64| {
            points(&[
                [1.0, 0.0, z + h],
                [0.0, 1.0, z - h],
                [-1.0, 0.0, z + h],
                [0.0, -1.0, z - h],
            ])
        };
        for z in [0.0, 1024.0] {
            let error = Polygon::new(saddle(0.5, z), None).unwrap_err();
            let expected = PolygonError::NotPlanar {
                vertex: 0,
                distance: 0.5,
                allowed: 2e-5,
            };
            assert_eq!(error, expected);
        }
        // the corners on the other side: vertex 0 is still the first that is furthest off
        let error = Polygon::new(saddle(-0.5, 0.0), None).unwrap_err();
        assert!(
            matches!(error, PolygonError::NotPlanar { vertex: 0, .. }),
            "{error}"
        );
        // 86·2⁻²² is 2.05·10⁻⁵: too much here, and within the rounding 8ε·2³⁰ = 1.9·10⁻⁶ at z = 2³⁰
        let h = 86.0 / 4_194_304.0;
        assert!(Polygon::new(saddle(h, 0.0), None).is_err());
        assert!(Polygon::new(saddle(h, 1_073_741_824.0), None).is_ok());
        // a hit may lie 64 times as far off as the vertices do
        let polygon = Polygon::new(saddle(1e-6, 0.0), None).unwrap();
        assert!(
            (polygon.room() - 64e-6).abs() <= 1e-12,
            "{}",
            polygon.room()
        );
    }

    #[test]
    fn t_of_a_flat_ray_goes_with_the_length_of_its_direction() {
        let [a, b, c] = [[1.0, 2.0, 3.0], [5.0, 3.0, 1.0], [2.0, 6.0, 4.0]].map(DVec3::from);
        let triangle = Polygon::new(vec![a, b, c], None).unwrap();
        let p = b + DVec3::new(-7.0, 2.0, 5.0) / 2048.0;
        let mut outside = 0;
        for exact in [8.0, 64.0, 512.0, 1024.0] {
            let direction = DVec3::new(4.0, 1.0, -2.0 + 0.5f64.powi(40));
            let ray = Ray::new(p - exact * direction, direction);
            let (quotient, t, _) = flat(&triangle, &ray);
            outside += usize::from(quotient != t);
            // a power of 2 changes no digit
            for factor in [2.0_f64.powi(20), 2.0_f64.powi(-20)] {
                let scaled = Ray::new(ray.origin, direction / factor);
                let found = triangle
                    .plane_test(&scaled, TRange::FORWARD, Sides::Both)
                    .chosen();
                assert_eq!(found, Some(factor * t), "{exact}");
                // nor does a minus before every coordinate
                let mirrored = Polygon::new(vec![-a, -b, -c], None).unwrap();
                let scaled = Ray::new(-scaled.origin, -scaled.direction);
                let found = mirrored
                    .plane_test(&scaled, TRange::FORWARD, Sides::Both)
                    .chosen();
                assert_eq!(found, Some(factor * t), "{exact}");
            }
        }
        // else this test would hold without bringing t anywhere
        assert!(1 <= outside);
    }

    #[test]
    fn a_normal_within_the_rounding_of_unit_length_stays_bit_for_bit() {
        // (1 + 8ε)² is 1 + 16ε
        let triangle = points(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        for (off, kept) in [(8.0, 8.0), (9.0, 0.0)] {
            let normal = |off: f64| (1.0 + off * f64::EPSILON) * DVec3::Z;
            let polygon = Polygon::new(triangle.clone(), Some(vec![normal(off); 3])).unwrap();
            assert_eq!(polygon.normals().unwrap()[0], normal(kept));
        }
    }

    #[test]
    fn a_tip_counts_as_passed_within_the_rounding_of_the_coordinates() {
        // only the tip is near the ray, and both edges leave it to one side; the same with all signs turned
        for sign in [1.0, -1.0] {
            let nearest = |tip: [f64; 2], origin: [f64; 2], direction: [f64; 2]| {
                let [x, y] = tip;
                let corners = [
                    [x, y, 5.0],
                    [x - 100.0, y + 200.0, 5.0],
                    [x - 300.0, y + 200.0, 5.0],
                ];
                let corners = corners.map(|p| sign * DVec3::from(p));
                let polygon = Polygon::new(corners.to_vec(), None).unwrap();
                let [origin, direction] = [origin, direction].map(|p| sign * DVec2::from(p));
                let ray = Ray::new(origin.extend(5.0 * sign), direction.extend(0.0));
                polygon.nearest_in_outline(&ray, 7.0)
            };
            assert_eq!(nearest([0.0; 2], [0.0; 2], [1.0, 0.0]), Some(0.0));
            // 32ε(|o| + |p|)(|Δu| + |Δv|) = 32ε·(4000 + 4000)·4 = 2.3·10⁻¹⁰, and the tip lies 3·6·10⁻¹¹ beside
            let (origin, direction) = ([-3000.0, -1000.0], [3.0, 1.0]);
            let passed = nearest([3000.0, 1000.0 + 6e-11], origin, direction);
            assert!((passed.unwrap() - 2000.0).abs() <= 1e-9);
            assert_eq!(nearest([3000.0, 1000.0 + 1e-10], origin, direction), None);
        }
    }

    #[test]
    fn along_an_edge_every_t_of_it_lies_in_the_outline() {
        // a square of 6 along each of its sides, both ways, from 1 before it: t from 1 to 7
        let square = points(&[
            [0.0, 0.0, 5.0],
            [6.0, 0.0, 5.0],
            [6.0, 6.0, 5.0],
            [0.0, 6.0, 5.0],
        ]);
        let square = Polygon::new(square, None).unwrap();
        for side in [0.0, 6.0] {
            for (origin, direction) in [
                ([-1.0, side, 5.0], DVec3::X),
                ([7.0, side, 5.0], DVec3::NEG_X),
                ([side, -1.0, 5.0], DVec3::Y),
                ([side, 7.0, 5.0], DVec3::NEG_Y),
            ] {
                let ray = Ray::new(origin.into(), direction);
                for (t, nearest) in [(-3.0, 1.0), (0.5, 1.0), (2.5, 2.5), (6.5, 6.5), (9.0, 7.0)] {
                    let found = square.nearest_in_outline(&ray, t);
                    assert_eq!(found, Some(nearest), "{origin:?} along {direction} at {t}");
                }
            }
        }
    }

    #[test]
    fn the_rounding_of_the_plane_is_that_of_the_vertex_with_the_largest_coordinates() {
        // 8ε(6 + 6 + 5), on either side of the origin
        for sign in [1.0, -1.0] {
            let corners =
                [[6.0, 6.0, 5.0], [0.0, 6.0, 5.0], [6.0, 0.0, 5.0]].map(|p| sign * DVec3::from(p));
            let triangle = Polygon::new(corners.to_vec(), None).unwrap();
            assert_eq!(triangle.off_plane, 136.0 * f64::EPSILON);
        }
    }
}
