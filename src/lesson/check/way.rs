//! The simple ray tracer with a mistake, as different programs write it: what is free changes what the mistake gives.

use glam::DVec3;

use crate::geometry::{Polygon, Ray, Refraction, Sides, Sphere, TRange};
use crate::mistake::Wrong;
use crate::scene::{Camera, Light, Material, Normals, PhongTerm, Primitive, Scene, Shape};
use crate::strategy::Hit;
use crate::tracer::Surface;
use crate::tracer::simple::{self, Parts};

/// What is free in a program beside its mistake.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Way {
    /// Rays that leave a surface start ε beside it, along the normal, in place of an ε in t.
    is_beside: bool,
    /// Each reflected direction is divided by its length.
    is_unit: bool,
}

/// By how much a ray starts beside its surface, relative to the larger of 1 and the point's distance from 0: a usual choice.
const BESIDE: f64 = 1e-4;

impl Way {
    /// The ways in which programs with this mistake differ.
    pub(super) fn of(wrong: &Wrong) -> impl Iterator<Item = Self> {
        let count = match wrong {
            Wrong::Reflect(_) => 4,
            Wrong::Normals(_) => 2,
            _ => 1,
        };
        (0..count).map(|bits| Self {
            is_beside: bits & 1 != 0,
            is_unit: bits & 2 != 0,
        })
    }

    /// The simple ray tracer with a mistake, written in this way.
    pub(super) fn with(self, wrong: &Wrong) -> Program<'_> {
        Program { wrong, way: self }
    }
}

/// The parts of a program: those of a mistake, but for what is free.
pub(super) struct Program<'a> {
    wrong: &'a Wrong,
    way: Way,
}

impl Parts for Program<'_> {
    fn leaves_from(&self, surface: &Surface<'_>) -> (DVec3, f64) {
        if self.way.is_beside {
            let by = BESIDE * surface.point.length().max(1.0);
            (surface.point + by * surface.normal, 0.0)
        } else {
            self.wrong.leaves_from(surface)
        }
    }

    fn reflect(&self, direction: DVec3, normal: DVec3) -> DVec3 {
        let reflected = self.wrong.reflect(direction, normal);
        if self.way.is_unit {
            reflected.normalize_or(reflected)
        } else {
            reflected
        }
    }

    fn shade(&self, scene: &Scene, surface: &Surface<'_>) -> DVec3 {
        match self.wrong {
            Wrong::Shade(wrong) => wrong(scene, self.wrong, surface),
            _ => simple::shade(scene, self, surface),
        }
    }

    fn window_point(&self, camera: &Camera, x: f64, y: f64) -> DVec3 {
        self.wrong.window_point(camera, x, y)
    }

    fn nearest(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
        self.wrong.nearest(scene, ray, range)
    }

    fn hit(&self, primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
        self.wrong.hit(primitive, ray, range)
    }

    fn root(&self, sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        self.wrong.root(sphere, ray, range, sides)
    }

    fn plane_t(&self, polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        self.wrong.plane_t(polygon, ray, range, sides)
    }

    fn inside(&self, polygon: &Polygon, ray: &Ray, t: f64) -> bool {
        self.wrong.inside(polygon, ray, t)
    }

    fn normals(&self, shape: &Shape, point: DVec3) -> Normals {
        self.wrong.normals(shape, point)
    }

    fn blocked(&self, scene: &Scene, ray: &Ray, range: TRange) -> bool {
        self.wrong.blocked(scene, ray, range)
    }

    fn light_term(
        &self,
        light: &Light,
        material: &Material,
        point: DVec3,
        normal: DVec3,
        to_viewer: DVec3,
    ) -> PhongTerm {
        self.wrong
            .light_term(light, material, point, normal, to_viewer)
    }

    fn refract(&self, direction: DVec3, normal: DVec3, from: f64, to: f64) -> Refraction {
        self.wrong.refract(direction, normal, from, to)
    }
}
