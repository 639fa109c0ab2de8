//! Bounding volumes around single objects: sphere, ellipsoid, rectangular solid, slabs.
//!
//! Slides, "Optimizing Intersection Calculations": "an object that is relatively expensive to test may be
//! enclosed in a bounding volume whose intersection test is less expensive, such as a sphere, ellipsoid, or
//! rectangular solid", or "the intersection of a set of slabs" (Fig. 15.58(a)). An object is what the scene
//! file names: a mesh has one volume around all its faces.

use glam::DVec3;
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::{MOST_SLABS, OrientedEllipsoid, Sphere};
use crate::scene::Scene;
use crate::structure::bounds::object_bounds::{ellipsoid_around, slabs_around, sphere_around};
use crate::structure::{SlabBound, SlabSet, range};

/// Which volume is put around an object?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum VolumeKind {
    /// The smallest sphere.
    Sphere,
    /// The ellipsoid of the smallest volume, in any orientation.
    Ellipsoid,
    /// The rectangular solid along the axes.
    #[default]
    Box,
    /// The intersection of slabs.
    Slabs,
}

/// A volume around an object, without padding: that comes with a [`VolumeRay`](crate::structure::VolumeRay).
#[doc(alias = "bounding volume")]
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
            Self::Box(bound) => Some(bound.as_box().size().element_product()),
            Self::Slabs(_) => None,
            Self::Nothing => Some(0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::scene::small_scene::{scene_from, scene_of, solid};

    #[test]
    fn volumes_around_a_box_with_sides_2_4_and_4_have_the_space_of_closed_forms() {
        let scene = scene_of(&[solid([1.0, 2.0, 3.0], [3.0, 6.0, 7.0])]);
        let volume = |kind| Volume::around(&scene, 0, kind, &SlabSet::SEVEN).volume();
        let close = |found: Option<f64>, expected: f64| {
            let found = found.unwrap();
            assert!(
                (found - expected).abs() <= 1e-12 * expected,
                "{found}, expected {expected}"
            );
        };
        close(volume(VolumeKind::Box), 32.0);
        // radius 3; half sides 1, 2, 2 times √3
        close(volume(VolumeKind::Sphere), 36.0 * PI);
        close(
            volume(VolumeKind::Ellipsoid),
            4.0 / 3.0 * PI * 4.0 * 27.0_f64.sqrt(),
        );
        assert_eq!(volume(VolumeKind::Slabs), None);
        assert_eq!(Volume::<3>::Nothing.volume(), Some(0.0));
    }

    #[test]
    fn a_mesh_without_faces_has_nothing_around_it() {
        let scene = scene_from(
            r#"{"camera":{"look_at":{"cop":[0,0,5],"target":[0,0,0],"up":[0,1,0],"fov_degrees":40},
            "pixels":[2,2]},"materials":{"m":{"colour":[1,1,1]}},
            "objects":[{"name":"empty","material":"m","shape":{"mesh":{"faces":[]}}}]}"#,
        );
        for kind in [
            VolumeKind::Sphere,
            VolumeKind::Box,
            VolumeKind::Ellipsoid,
            VolumeKind::Slabs,
        ] {
            let volume = Volume::around(&scene, 0, kind, &SlabSet::SEVEN);
            assert_eq!(volume, Volume::Nothing);
        }
    }
}
