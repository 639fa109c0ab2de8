//! The polygon: convex or concave, any number of vertices.
//!
//! What is constant for all rays is computed here, once: the plane, the coordinate to drop and the
//! projected outline. [`Plane::test`] then finds the point p on the plane, and the module
//! `point_in_polygon` decides whether p lies inside (Fig. 15.57).

use std::fmt;

use glam::{DVec2, DVec3};

use crate::geometry::{Axis, Plane, PlaneTest, Ray, Sides, TRange};

/// A polygon in space with everything that does not depend on a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    pub(super) plane: Plane,
    /// The largest distance of a vertex from the plane, and the rounding of that.
    pub(super) off_plane: f64,
    /// The coordinate with the largest coefficient in (iv).
    pub(super) dropped: Axis,
    pub(super) vertices: Box<[DVec3]>,
    /// The vertices without the dropped coordinate.
    pub(super) outline: Box<[DVec2]>,
    /// One unit normal per vertex, for smooth shading.
    normals: Option<Box<[DVec3]>>,
}

/// A vertex may lie off the plane by this share of the polygon's size: coordinates that were written
/// with six digits.
pub(crate) const PLANARITY: f64 = 1e-5;

/// A ray that meets the plane more flatly than 1 in 64 has its t kept to the vertices' extent; one that does
/// not can meet the plane up to 64 times the vertices' distance from it away from them.
const FLATTEST: f64 = 64.0;

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
            Self::NoArea => f.write_str("the vertices lie on one line or enclose no area"),
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
        if vertices.len() < 3 {
            return Err(PolygonError::TooFewVertices {
                count: vertices.len(),
            });
        }
        let plane = Plane::newell(&vertices).ok_or(PolygonError::NoArea)?;
        let off_plane = planarity(&plane, &vertices)?;
        let dropped = Axis::of_largest(plane.normal);
        Ok(Self {
            plane,
            off_plane,
            dropped,
            outline: vertices.iter().map(|&v| dropped.drop_from(v)).collect(),
            normals: normals
                .map(|n| unit_normals(n, vertices.len()))
                .transpose()?,
            vertices: vertices.into(),
        })
    }

    /// The vertices, in order.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// The vertices projected along [`Polygon::dropped`].
    pub fn outline(&self) -> &[DVec2] {
        &self.outline
    }

    /// One unit normal per vertex, if the polygon is to be shaded smoothly.
    pub fn normals(&self) -> Option<&[DVec3]> {
        self.normals.as_deref()
    }

    /// The polygon's plane.
    pub fn plane(&self) -> Plane {
        self.plane
    }

    /// How far a computed hit may lie off the vertices' extent: they are not quite in one plane.
    pub fn play(&self) -> f64 {
        self.off_plane * FLATTEST
    }

    /// The coordinate that the projection drops: the one whose coefficient in (iv) has the largest
    /// absolute value.
    pub fn dropped(&self) -> Axis {
        self.dropped
    }

    /// Where does the ray meet the polygon's plane? Whether that point lies inside is
    /// [`Polygon::contains`].
    #[inline]
    pub fn plane_test(&self, ray: &Ray, range: TRange, sides: Sides) -> PlaneTest {
        self.plane.test(ray, range, sides)
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
}
