//! Of the shade: what an exercise does not ask for.

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::scene::{Material, Primitive, Scene};
use crate::tracer::Surface;
use crate::tracer::simple::{Own, Parts};

/// t of the hit with one object, if it is in the range.
pub fn hit(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    Own.hit(primitive, ray, range)
}

/// Ambient light and the terms of the visible lights: the colour without the rays that mirrors and glass spawn.
pub fn direct(scene: &Scene, surface: &Surface<'_>) -> DVec3 {
    let dull = Material {
        reflection: 0.0,
        transmission: 0.0,
        ..*surface.material
    };
    let surface = Surface {
        material: &dull,
        ..*surface
    };
    Own.shade(scene, &surface)
}

/// The colour that a ray brings which starts at the surface in a direction, however deep it is.
pub fn seen(scene: &Scene, surface: &Surface<'_>, direction: DVec3) -> DVec3 {
    let ray = Ray::new(surface.point, direction);
    let range = TRange {
        min: surface.epsilon,
        max: f64::INFINITY,
    };
    match Own.nearest(scene, &ray, range) {
        None => scene.background,
        Some(hit) => {
            let shape = &scene.primitive(hit.object).shape;
            let normals = shape.normals(ray.at(hit.t));
            let surface = Surface::new(scene, &ray, surface.depth + 1, hit, normals);
            Own.shade(scene, &surface)
        }
    }
}
