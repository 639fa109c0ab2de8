//! Wrong functions by what they replace, and the simple ray tracer with one of them.

use glam::DVec3;

use crate::geometry::{
    Axis, AxisBox, Inside, Polygon, QuadraticTest, Ray, Refraction, Sides, SlabInterval, SlabRay,
    Sphere, TRange,
};
use crate::mistake::outline::inside_along;
use crate::scene::{Camera, Light, Material, Normals, PhongTerm, Primitive, Scene, Shape};
use crate::strategy::Hit;
use crate::structure::Across;
use crate::trace::BoundVerdict;
use crate::tracer::Surface;
use crate::tracer::simple::{self, Own, Parts};

/// From the box of a grid, its resolution, and a ray with its range: the cells that are visited.
pub type WalkOfCells = fn(&AxisBox, [u32; 3], &Ray, TRange) -> Vec<[u32; 3]>;

/// A wrong function, with the signature of the right one.
///
/// It is a set of [`Parts`]: the simple ray tracer with this one function replaced. A function that no part of the simple
/// ray tracer uses changes nothing there.
#[derive(Clone, Copy, Debug)]
pub enum Wrong {
    /// In place of [`Parts::window_point`].
    WindowPoint(fn(&Camera, f64, f64) -> DVec3),
    /// In place of [`Parts::nearest`].
    Nearest(fn(&Scene, &Ray, TRange) -> Option<Hit>),
    /// In place of [`Parts::hit`].
    Hit(fn(&Primitive, &Ray, TRange) -> Option<f64>),
    /// In place of [`Sphere::test`], and so of [`Parts::root`].
    SphereTest(fn(&Sphere, &Ray, TRange, Sides) -> QuadraticTest),
    /// In place of [`Parts::root`].
    Root(fn(&Sphere, &Ray, TRange, Sides) -> Option<f64>),
    /// In place of [`Parts::plane_t`].
    PlaneT(fn(&Polygon, &Ray, TRange, Sides) -> Option<f64>),
    /// In place of [`Parts::inside`].
    Inside(fn(&Polygon, &Ray, f64) -> bool),
    /// In place of [`Axis::of_largest`] of the plane's normal, and so of [`Parts::inside`].
    DroppedAxis(fn(DVec3) -> Axis),
    /// In place of [`Parts::normals`].
    Normals(fn(&Shape, DVec3) -> Normals),
    /// In place of [`Parts::leaves_from`].
    LeavesFrom(fn(&Surface<'_>) -> (DVec3, f64)),
    /// In place of [`Parts::blocked`].
    Blocked(fn(&Scene, &Ray, TRange) -> bool),
    /// In place of [`Parts::light_term`].
    LightTerm(fn(&Light, &Material, DVec3, DVec3, DVec3) -> PhongTerm),
    /// In place of [`Parts::reflect`].
    Reflect(fn(DVec3, DVec3) -> DVec3),
    /// In place of [`Parts::refract`].
    Refract(fn(DVec3, DVec3, f64, f64) -> Refraction),
    /// In place of [`Parts::shade`].
    Shade(fn(&Scene, &Wrong, &Surface<'_>) -> DVec3),
    /// In place of [`Ray::normalised`].
    Normalised(fn(&Ray) -> Option<(Ray, f64)>),
    /// In place of [`start_epsilon`](crate::tracer::start_epsilon).
    StartEpsilon(fn(DVec3, f64, f64) -> f64),
    /// In place of [`SlabRay::interval`].
    SlabInterval(fn(&SlabRay, f64, f64) -> SlabInterval),
    /// In place of [`Inside::and`]: the slabs so far, and one more.
    SlabsSoFar(fn(Inside, SlabInterval) -> Inside),
    /// What follows from where the ray is inside a bound, and from which t count: in place of `BoundVerdict::of`.
    Bound(fn(Option<[f64; 2]>, TRange) -> BoundVerdict),
    /// From the t of the next planes of a cell: across which the ray leaves. In place of a step of
    /// [`GridWalk`](crate::structure::GridWalk).
    PlanesCrossed(fn([f64; 3]) -> Across),
    /// From a cell along an axis and the ray's direction there: the next plane, counted from 0 at the lowest. In place of a
    /// step of [`GridWalk`](crate::structure::GridWalk).
    NextPlane(fn(u32, f64) -> u32),
    /// From the box of the grid, how many cells it has along x, y and z, and the ray with its range: the cells that are visited,
    /// in their order. In place of [`GridWalk`](crate::structure::GridWalk).
    CellsVisited(WalkOfCells),
    /// From t of the nearest hit and t at which the ray leaves the cell: does the walk end? In place of the test of
    /// [`UniformGrid`](crate::strategy::UniformGrid).
    WalkEnds(fn(f64, f64) -> bool),
}

impl Wrong {
    /// The name of the right function.
    pub fn replaces(&self) -> &'static str {
        match self {
            Self::WindowPoint(_) => "Parts::window_point",
            Self::Nearest(_) => "Parts::nearest",
            Self::Hit(_) => "Parts::hit",
            Self::SphereTest(_) => "Sphere::test",
            Self::Root(_) => "Parts::root",
            Self::PlaneT(_) => "Parts::plane_t",
            Self::Inside(_) => "Parts::inside",
            Self::DroppedAxis(_) => "Axis::of_largest",
            Self::Normals(_) => "Parts::normals",
            Self::LeavesFrom(_) => "Parts::leaves_from",
            Self::Blocked(_) => "Parts::blocked",
            Self::LightTerm(_) => "Parts::light_term",
            Self::Reflect(_) => "Parts::reflect",
            Self::Refract(_) => "Parts::refract",
            Self::Shade(_) => "Parts::shade",
            Self::Normalised(_) => "Ray::normalised",
            Self::StartEpsilon(_) => "start_epsilon",
            Self::SlabInterval(_) => "SlabRay::interval",
            Self::SlabsSoFar(_) => "Inside::and",
            Self::Bound(_) => "BoundVerdict::of",
            Self::PlanesCrossed(_) | Self::NextPlane(_) => "GridWalk::next",
            Self::CellsVisited(_) => "GridWalk",
            Self::WalkEnds(_) => "UniformGrid::search",
        }
    }

    /// Does it replace a part of the simple ray tracer, so that it has a picture?
    pub fn is_part(&self) -> bool {
        !matches!(
            self,
            Self::Normalised(_)
                | Self::StartEpsilon(_)
                | Self::SlabInterval(_)
                | Self::SlabsSoFar(_)
                | Self::Bound(_)
                | Self::PlanesCrossed(_)
                | Self::NextPlane(_)
                | Self::CellsVisited(_)
                | Self::WalkEnds(_)
        )
    }
}

impl Parts for Wrong {
    fn window_point(&self, camera: &Camera, x: f64, y: f64) -> DVec3 {
        match self {
            Self::WindowPoint(wrong) => wrong(camera, x, y),
            _ => Own.window_point(camera, x, y),
        }
    }

    fn nearest(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
        match self {
            Self::Nearest(wrong) => wrong(scene, ray, range),
            _ => simple::closest(scene, self, ray, range),
        }
    }

    fn hit(&self, primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
        match self {
            Self::Hit(wrong) => wrong(primitive, ray, range),
            _ => simple::hit(self, primitive, ray, range),
        }
    }

    fn root(&self, sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        match self {
            Self::Root(wrong) => wrong(sphere, ray, range, sides),
            Self::SphereTest(wrong) => wrong(sphere, ray, range, sides).roots.chosen(),
            _ => Own.root(sphere, ray, range, sides),
        }
    }

    fn plane_t(&self, polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        match self {
            Self::PlaneT(wrong) => wrong(polygon, ray, range, sides),
            _ => Own.plane_t(polygon, ray, range, sides),
        }
    }

    fn inside(&self, polygon: &Polygon, ray: &Ray, t: f64) -> bool {
        match self {
            Self::Inside(wrong) => wrong(polygon, ray, t),
            Self::DroppedAxis(wrong) => {
                inside_along(polygon, ray.at(t), wrong(polygon.plane().normal))
            }
            _ => Own.inside(polygon, ray, t),
        }
    }

    fn normals(&self, shape: &Shape, point: DVec3) -> Normals {
        match self {
            Self::Normals(wrong) => wrong(shape, point),
            _ => Own.normals(shape, point),
        }
    }

    fn leaves_from(&self, surface: &Surface<'_>) -> (DVec3, f64) {
        match self {
            Self::LeavesFrom(wrong) => wrong(surface),
            _ => Own.leaves_from(surface),
        }
    }

    fn blocked(&self, scene: &Scene, ray: &Ray, range: TRange) -> bool {
        match self {
            Self::Blocked(wrong) => wrong(scene, ray, range),
            _ => simple::blocked(scene, self, ray, range),
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
        match self {
            Self::LightTerm(wrong) => wrong(light, material, point, normal, to_viewer),
            _ => Own.light_term(light, material, point, normal, to_viewer),
        }
    }

    fn reflect(&self, direction: DVec3, normal: DVec3) -> DVec3 {
        match self {
            Self::Reflect(wrong) => wrong(direction, normal),
            _ => Own.reflect(direction, normal),
        }
    }

    fn refract(
        &self,
        direction: DVec3,
        normal: DVec3,
        index_from: f64,
        index_to: f64,
    ) -> Refraction {
        match self {
            Self::Refract(wrong) => wrong(direction, normal, index_from, index_to),
            _ => Own.refract(direction, normal, index_from, index_to),
        }
    }

    fn shade(&self, scene: &Scene, surface: &Surface<'_>) -> DVec3 {
        match self {
            Self::Shade(wrong) => wrong(scene, self, surface),
            _ => simple::shade(scene, self, surface),
        }
    }
}
