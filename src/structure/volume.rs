//! Bounding volumes around single objects: sphere, ellipsoid, rectangular solid, slabs.
//!
//! Slides, "Optimizing Intersection Calculations": "an object that is relatively expensive to test may be
//! enclosed in a bounding volume whose intersection test is less expensive, such as a sphere, ellipsoid, or
//! rectangular solid", or "the intersection of a set of slabs" (Fig. 15.58(a)). An object is what the scene
//! file names: a mesh has one volume around all its faces.

use std::cell::OnceCell;

use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::{MOST_SLABS, OrientedEllipsoid, QuadraticTest, Ray, Sides, Sphere, TRange};
use crate::scene::Scene;
use crate::structure::object_bounds::{ellipsoid_around, slabs_around, sphere_around};
use crate::structure::slab_bound::ROOM;
use crate::structure::{Inside, RaySlabs, SlabBound, SlabSet, range};

/// Which volume is put around an object?
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum VolumeKind {
    /// The smallest sphere.
    Sphere,
    /// The ellipsoid of least volume, turned as it fits best.
    Ellipsoid,
    /// The rectangular solid along the axes.
    #[default]
    Box,
    /// The intersection of slabs.
    Slabs,
}

/// A volume around an object, a little wider than the object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Volume<const N: usize = MOST_SLABS> {
    /// The smallest sphere.
    Sphere(Sphere),
    /// The ellipsoid of least volume.
    Ellipsoid(OrientedEllipsoid),
    /// The rectangular solid along the axes: slabs across x, y and z.
    Box(SlabBound<3>),
    /// The intersection of slabs. A, B and C are those of the structure's [`SlabSet`].
    Slabs(SlabBound<N>),
    /// Around a mesh without faces: every ray misses it.
    Nothing,
}

/// A ray, and what of its meeting with slabs is the same for all volumes: S and T of each direction,
/// calculated once, when the first volume asks for them.
#[derive(Clone, Debug)]
pub struct VolumeRay<'a, const N: usize = MOST_SLABS> {
    ray: &'a Ray,
    set: &'a SlabSet<N>,
    /// The largest coordinate of what the volumes are around.
    reach: f64,
    across_axes: OnceCell<RaySlabs<3>>,
    across_set: OnceCell<RaySlabs<N>>,
}

impl<'a, const N: usize> VolumeRay<'a, N> {
    /// A ray that is to be tested against volumes with slabs of this set; `reach` is the largest coordinate
    /// of what they are around.
    #[inline]
    pub fn new(ray: &'a Ray, set: &'a SlabSet<N>, reach: f64) -> Self {
        Self {
            ray,
            set,
            reach,
            across_axes: OnceCell::new(),
            across_set: OnceCell::new(),
        }
    }
}

impl<const N: usize> Volume<N> {
    /// The volume around an object, by its place in [`Scene::objects`].
    ///
    /// - sphere: the smallest. A sphere's is itself, an ellipsoid's has its largest radius, a box's half its
    ///   diagonal; a cone's touches both rims or has the wider one as its equator; that of polygons and
    ///   meshes is settled by up to four vertices.
    /// - ellipsoid: that of least volume. A sphere and an ellipsoid are their own, a box's has half its sides
    ///   times √3; a cone's is round about the same axis; that of a mesh is the Löwner–John ellipsoid of the
    ///   vertices. Of something flat: the ellipse of least area, with a thousandth of its larger half axis
    ///   as the third.
    /// - box and slabs: from the smallest to the largest n·p along each normal.
    pub fn around(scene: &Scene, object: usize, kind: VolumeKind, set: &SlabSet<N>) -> Self {
        let object = &scene.objects[object];
        let primitives = &scene.primitives[range(object.first.0, object.count)];
        if primitives.is_empty() {
            return Self::Nothing;
        }
        match kind {
            VolumeKind::Sphere => sphere_around(primitives).map_or(Self::Nothing, Self::Sphere),
            VolumeKind::Ellipsoid => {
                ellipsoid_around(primitives).map_or(Self::Nothing, Self::Ellipsoid)
            }
            VolumeKind::Box => Self::Box(slabs_around(primitives, &SlabSet::AXES)),
            VolumeKind::Slabs => Self::Slabs(slabs_around(primitives, set)),
        }
    }

    /// Where is the ray's line inside the volume? `None`, or ends that have crossed, if it passes by.
    ///
    /// Both t can be negative: the near one of a ray that starts inside. There is some room on both sides,
    /// as [`RaySlabs`] has it: the rounding of a test grows with the distance that the ray comes from, and
    /// spheres and ellipsoids grow by 2·10⁻¹⁰ of that.
    ///
    /// `tell` hears of each slab of [`Volume::Slabs`], with the largest near and the smallest far up to it.
    #[inline]
    pub fn inside(
        &self,
        ray: &VolumeRay<N>,
        tell: impl FnMut(usize, f64, f64) -> bool,
    ) -> Option<Inside> {
        let room = || ROOM * (ray.ray.origin.abs().element_sum() + ray.reach);
        match self {
            Self::Sphere(Sphere { center, radius }) => {
                let wider = Sphere {
                    center: *center,
                    radius: radius + room(),
                };
                between_roots(&wider.test(ray.ray, TRange::FORWARD, Sides::Both))
            }
            Self::Ellipsoid(ellipsoid) => {
                let wider = ellipsoid.widened(room());
                between_roots(&wider.test(ray.ray, TRange::FORWARD, Sides::Both))
            }
            Self::Box(bound) => {
                let lines = || RaySlabs::new(ray.ray, &SlabSet::AXES, ray.reach);
                let lines = ray.across_axes.get_or_init(lines);
                Some(bound.inside(lines, |_, _, _| false))
            }
            Self::Slabs(bound) => {
                let lines = || RaySlabs::new(ray.ray, ray.set, ray.reach);
                Some(bound.inside(ray.across_set.get_or_init(lines), tell))
            }
            Self::Nothing => None,
        }
    }

    /// How much space is in the volume? `None` for slabs, whose corners are not known.
    pub fn volume(&self) -> Option<f64> {
        match self {
            Self::Sphere(Sphere { center, radius }) => {
                let round = OrientedEllipsoid {
                    center: *center,
                    axes: DVec3::AXES,
                    radii: DVec3::splat(*radius),
                };
                Some(round.volume())
            }
            Self::Ellipsoid(ellipsoid) => Some(ellipsoid.volume()),
            Self::Box(bound) => Some(
                (0..3)
                    .map(|slab| bound.d_max[slab] - bound.d_min[slab])
                    .product(),
            ),
            Self::Slabs(_) => None,
            Self::Nothing => Some(0.0),
        }
    }
}

/// From the smaller root to the larger; `None` without real roots.
#[inline]
fn between_roots(test: &QuadraticTest) -> Option<Inside> {
    let mut roots = test.roots.iter().map(|root| root.t);
    let near = roots.next()?;
    let far = roots.next().unwrap_or(near);
    Some(Inside {
        near: near * (1.0 - ROOM),
        far: far * (1.0 + ROOM),
    })
}
