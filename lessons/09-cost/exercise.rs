//! Lesson 9: what ray tracing costs, and the ray turned into the z axis.
//!
//! - nearest hit: how many tests it takes to find it
//! - aligned frame: the frame in which the ray is the z axis
//! - aligned point: a point in that frame, and back
//! - z sort: the hits in the order of their z, which is t

use glam::DVec3;
use raystep::geometry::{Alignment, Ray};

/// How many tests a picture takes if every ray is tested against every object.
///
/// `pixels` is [width, height], with one eye ray for each; `hits` of them hit something, and from each of those points a shadow
/// ray is cast to each light.
pub fn cost(pixels: [u64; 2], objects: u64, hits: u64, lights: u64) -> u64 {
    todo!()
}

/// The frame in which a ray of unit length starts in (0, 0, 0) and runs along z: p′ = (x·(p − o), y·(p − o), z·(p − o)).
///
/// An `Alignment` has `origin` o and the rows `x`, `y` and `z` of the rotation: unit vectors at right angles, with z = x × y.
/// Which x and y they are does not matter. `a.cross(b)` is the cross product.
pub fn align(ray: &Ray) -> Alignment {
    todo!()
}

/// The nearest of the hits in the frame: the number of the object, and the point in the world. None if no hit is in front.
///
/// `z` has the z of a hit with each object. `frame.back(point)` is a point of the frame in the world.
pub fn z_sort(frame: &Alignment, z: &[f64]) -> Option<(usize, DVec3)> {
    todo!()
}
