//! Objects, and the primitives they consist of.

use glam::DVec3;
use smol_str::SmolStr;

use crate::geometry::{AxisBox, Cone, Ellipsoid, Polygon, Sides, Sphere, interpolated_normal};

/// What a primitive's number is: its place in the order of the scene. A mesh counts one for each face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PrimitiveId(pub u32);

/// An object as the scene file names it: one primitive, or the faces of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its name; no two objects share one. Up to 23 bytes take no memory of their own: of a million triangles
    /// that is a tenth.
    pub name: SmolStr,
    /// Its place in [`Scene::materials`](crate::scene::Scene::materials).
    pub material: u32,
    /// Which sides of its surface the scene file lets be seen.
    pub sides: Sides,
    /// The first of its primitives, which are consecutive: the object itself, or the faces of a mesh.
    pub first: PrimitiveId,
    /// How many primitives it has.
    pub count: u32,
    /// A mesh is named by its faces, even if it has only one.
    pub is_mesh: bool,
}

/// What a ray is tested against.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// Its form, with what is constant for all rays computed in advance.
    pub shape: Shape,
    /// Its place in [`Scene::objects`](crate::scene::Scene::objects).
    pub object: u32,
    /// Which sides a ray can hit.
    pub sides: Sides,
}

/// The form of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Equation (ii).
    Sphere(Sphere),
    /// A sphere stretched along the axes.
    Ellipsoid(Ellipsoid),
    /// Three slabs.
    Box(AxisBox),
    /// An open cone or cylinder.
    Cone(Cone),
    /// A planar outline, equation (iv).
    Polygon(Polygon),
}

/// The unit normals at a point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normals {
    /// Across the surface itself, towards its front.
    pub geometric: DVec3,
    /// The one to shade with: differs where a polygon has a normal for each vertex.
    pub shading: DVec3,
}

impl Shape {
    /// The normals at a point of the surface.
    pub fn normals(&self, point: DVec3) -> Normals {
        let geometric = match self {
            Self::Sphere(sphere) => sphere.normal(point),
            Self::Ellipsoid(ellipsoid) => ellipsoid.normal(point),
            Self::Box(solid) => solid.normal(point),
            Self::Cone(cone) => cone.normal(point),
            Self::Polygon(polygon) => polygon.plane().normal,
        };
        let shading = match self {
            Self::Polygon(polygon) => polygon.normals().and_then(|normals| {
                let p = polygon.dropped().drop_from(point);
                interpolated_normal(polygon.outline(), normals, p)
            }),
            _ => None,
        };
        Normals {
            geometric,
            shading: shading.unwrap_or(geometric),
        }
    }

    /// The largest absolute coordinate or radius: what the rounding of a hit point is measured against.
    pub fn reach(&self) -> f64 {
        let of = |point: DVec3| point.abs().max_element();
        match self {
            Self::Sphere(sphere) => of(sphere.center) + sphere.radius,
            Self::Ellipsoid(ellipsoid) => of(ellipsoid.center) + ellipsoid.radii.max_element(),
            Self::Box(solid) => of(solid.min).max(of(solid.max)),
            Self::Cone(cone) => {
                of(cone.base()).max(of(cone.apex())) + cone.radii()[0].max(cone.radii()[1])
            }
            Self::Polygon(polygon) => polygon.vertices().map(of).fold(0.0, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_triangles_take_136_megabytes() {
        // 9 coordinates, the plane's 4, how far the vertices are off it, a place for normals: 15 numbers
        // of 8 bytes, and 8 bytes for what kind it is; then the object and its sides
        assert_eq!(size_of::<Polygon>(), 128);
        assert!(size_of::<Primitive>() <= 136, "{}", size_of::<Primitive>());
    }
}
