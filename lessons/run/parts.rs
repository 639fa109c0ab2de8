//! The simple ray tracer with your functions: those that are right, and the crate's own for the rest.

use std::collections::BTreeSet;

use glam::DVec3;
use raystep::Scene;
use raystep::geometry::{Polygon, Ray, Refraction, Sides, Sphere, TRange};
use raystep::scene::{Camera, Light, Material, Normals, PhongTerm, Shape};
use raystep::strategy::Hit;
use raystep::tracer::Surface;
use raystep::tracer::simple::{self, Own, Parts};

use super::{l01, l02, l04, l05, l06, l07};

/// The exercises whose functions are parts of the simple ray tracer.
pub const PARTS: [&str; 13] = [
    "l01_window_point",
    "l01_eye_ray",
    "l02_nearest",
    "l04_root_that_counts",
    "l05_normals",
    "l05_light_term",
    "l05_blocked",
    "l05_shade",
    "l06_plane_t",
    "l06_inside",
    "l07_reflect",
    "l07_refract",
    "l07_children",
];

/// Your functions by the names of their exercises.
#[derive(Debug, Default)]
pub struct Yours(pub BTreeSet<String>);

impl Yours {
    fn has(&self, id: &str) -> bool {
        self.0.contains(id)
    }
}

impl Parts for Yours {
    fn window_point(&self, camera: &Camera, x: f64, y: f64) -> DVec3 {
        if self.has("l01_window_point") {
            l01::window_point(camera, x, y)
        } else {
            Own.window_point(camera, x, y)
        }
    }

    fn eye_ray(&self, camera: &Camera, to_window: DVec3) -> Ray {
        if self.has("l01_eye_ray") {
            l01::eye_ray(camera, to_window)
        } else {
            Own.eye_ray(camera, to_window)
        }
    }

    /// Yours asks the crate for the hit with an object, so it is taken until a test of your own is right.
    fn nearest(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
        let tests = ["l04_root_that_counts", "l06_plane_t", "l06_inside"];
        if self.has("l02_nearest") && !tests.iter().any(|id| self.has(id)) {
            l02::nearest(scene, ray, range)
        } else {
            simple::closest(scene, self, ray, range)
        }
    }

    fn root(&self, sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        if self.has("l04_root_that_counts") && sides == Sides::Both {
            l04::root_that_counts(sphere, ray, range, sides)
        } else {
            Own.root(sphere, ray, range, sides)
        }
    }

    fn plane_t(&self, polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        if self.has("l06_plane_t") && sides == Sides::Both {
            l06::plane_t(polygon, ray, range, sides)
        } else {
            Own.plane_t(polygon, ray, range, sides)
        }
    }

    fn inside(&self, polygon: &Polygon, ray: &Ray, t: f64) -> bool {
        if self.has("l06_inside") {
            l06::inside(polygon, ray, t)
        } else {
            Own.inside(polygon, ray, t)
        }
    }

    fn normals(&self, shape: &Shape, point: DVec3) -> Normals {
        if self.has("l05_normals") {
            l05::normals(shape, point)
        } else {
            Own.normals(shape, point)
        }
    }

    fn blocked(&self, scene: &Scene, ray: &Ray, range: TRange) -> bool {
        if self.has("l05_blocked") {
            l05::blocked(scene, ray, range)
        } else {
            simple::blocked(scene, self, ray, range)
        }
    }

    fn light_term(
        &self,
        light: &Light,
        material: &Material,
        point: DVec3,
        normal: DVec3,
        to_viewer: DVec3,
    ) -> PhongTerm {
        if self.has("l05_light_term") {
            l05::light_term(light, material, point, normal, to_viewer)
        } else {
            Own.light_term(light, material, point, normal, to_viewer)
        }
    }

    fn reflect(&self, direction: DVec3, normal: DVec3) -> DVec3 {
        if self.has("l07_reflect") {
            l07::reflect(direction, normal)
        } else {
            Own.reflect(direction, normal)
        }
    }

    fn refract(
        &self,
        direction: DVec3,
        normal: DVec3,
        index_from: f64,
        index_to: f64,
    ) -> Refraction {
        if self.has("l07_refract") {
            l07::refract(direction, normal, index_from, index_to)
        } else {
            Own.refract(direction, normal, index_from, index_to)
        }
    }

    fn shade(&self, scene: &Scene, surface: &Surface<'_>) -> DVec3 {
        let Material {
            reflection,
            transmission,
            ..
        } = *surface.material;
        let is_dull = reflection == 0.0 && transmission == 0.0;
        if is_dull && self.has("l05_shade") {
            l05::shade(scene, surface)
        } else if !is_dull && self.has("l07_children") {
            l07::children(scene, surface)
        } else {
            simple::shade(scene, self, surface)
        }
    }
}
