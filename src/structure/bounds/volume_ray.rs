//! A ray against bounding volumes: where is it inside one, with room for rounding?

use crate::geometry::{
    Inside, MOST_SLABS, OrientedEllipsoid, QuadraticTest, Ray, Sides, Sphere, TRange,
};
use crate::structure::{RaySlabs, SlabSet, Volume};

/// A ray, and what of its meeting with volumes is the same for all of them: the room for rounding, and S and T of
/// each direction of slabs.
#[derive(Clone, Debug)]
pub struct VolumeRay<'a, const N: usize = MOST_SLABS> {
    ray: &'a Ray,
    /// By how much a volume is wider than what it is around: a length.
    room: f64,
    across_axes: RaySlabs<3>,
    across_set: RaySlabs<N>,
}

impl<'a, const N: usize> VolumeRay<'a, N> {
    /// A ray that is to be tested against volumes with slabs of this set, wider by this
    /// [`room`](crate::structure::room).
    pub fn new(ray: &'a Ray, set: &SlabSet<N>, room: f64) -> Self {
        Self {
            ray,
            room,
            across_axes: RaySlabs::new(ray, &SlabSet::AXES, room),
            across_set: RaySlabs::new(ray, set, room),
        }
    }

    /// By how much a volume is wider than what it is around: a length.
    pub fn room(&self) -> f64 {
        self.room
    }

    /// S and T for the directions of the set.
    pub fn across_set(&self) -> &RaySlabs<N> {
        &self.across_set
    }
}

impl<const N: usize> Volume<N> {
    /// Where is the ray's line inside the volume, with its room? `None` if it passes by.
    ///
    /// Both t can be negative: the near one of a ray that starts inside. A sphere or an ellipsoid is larger by the
    /// room; its roots, which are good to 10⁻¹⁰ of themselves, have as much again.
    pub fn inside(&self, ray: &VolumeRay<N>, set: &SlabSet<N>) -> Option<Inside> {
        match self {
            Self::Sphere(sphere) => inside_sphere(sphere, ray.ray, ray.room),
            Self::Ellipsoid(ellipsoid) => inside_ellipsoid(ellipsoid, ray.ray, ray.room),
            Self::Box(bound) => bound.inside(&ray.across_axes, &SlabSet::AXES),
            Self::Slabs(bound) => bound.inside(&ray.across_set, set),
            Self::Nothing => None,
        }
    }
}

/// Where is a ray inside a sphere, with this room around it?
#[inline]
pub(crate) fn inside_sphere(sphere: &Sphere, ray: &Ray, room: f64) -> Option<Inside> {
    let wider = Sphere {
        center: sphere.center,
        radius: sphere.radius + room,
    };
    between_roots(&wider.test(ray, TRange::FORWARD, Sides::Both), room)
}

/// Where is a ray inside an ellipsoid, with this room around it?
#[inline]
pub(crate) fn inside_ellipsoid(
    ellipsoid: &OrientedEllipsoid,
    ray: &Ray,
    room: f64,
) -> Option<Inside> {
    let wider = ellipsoid.with_room(room);
    between_roots(&wider.test(ray, TRange::FORWARD, Sides::Both), room)
}

/// From the smaller root to the larger; `None` without real roots. With room, a root's own rounding counts too.
#[inline]
fn between_roots(test: &QuadraticTest, room: f64) -> Option<Inside> {
    let mut roots = test.roots.iter().map(|root| root.t);
    let near = roots.next()?;
    let far = roots.next().unwrap_or(near);
    let rounding = if room == 0.0 { 0.0 } else { ROOT };
    Some(Inside {
        near: near - rounding * near.abs(),
        far: far + rounding * far.abs(),
    })
}

/// A root is good to 10⁻¹⁰ of itself; twice that is a bound's room for it.
const ROOT: f64 = 2e-10;

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{scene_of, solid, sphere};
    use crate::structure::VolumeKind;

    const UNIT: Sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };

    fn along_x(x: f64, y: f64) -> Ray {
        Ray::new(DVec3::new(x, y, 0.0), DVec3::X)
    }

    #[test]
    fn a_ray_is_inside_a_sphere_between_its_roots() {
        let inside = |ray: Ray, room| inside_sphere(&UNIT, &ray, room).map(|of| [of.near, of.far]);
        assert_eq!(inside(along_x(-5.0, 0.0), 0.0), Some([4.0, 6.0]));
        assert_eq!(inside(along_x(0.5, 0.0), 0.0), Some([-1.5, 0.5]));
        // a graze has one root
        assert_eq!(inside(along_x(-5.0, 1.0), 0.0), Some([5.0, 5.0]));
        assert_eq!(inside(along_x(-5.0, 1.5), 0.0), None);
    }

    #[test]
    fn room_makes_a_volume_larger_and_each_root_by_a_share_of_itself_less_or_more() {
        let inside = |x: f64| {
            let found = inside_sphere(&UNIT, &along_x(x, 0.0), 0.5).unwrap();
            [found.near, found.far]
        };
        #[track_caller]
        fn check(found: [f64; 2], expected: [f64; 2]) {
            let off = [0, 1].map(|end| (found[end] - expected[end]).abs());
            assert!(off[0] <= 1e-14 && off[1] <= 1e-14, "{found:?}");
        }
        // radius 1.5: 3.5 and 6.5, each with 2·10⁻¹⁰ of itself
        check(inside(-5.0), [3.5 - 7e-10, 6.5 + 13e-10]);
        check(inside(5.0), [-6.5 - 13e-10, -3.5 + 7e-10]);
        let ellipsoid = OrientedEllipsoid {
            center: DVec3::ZERO,
            axes: DVec3::AXES,
            radii: DVec3::new(1.0, 2.0, 4.0),
        };
        // the sixteenth part of the smallest half axis: all grow by as much of themselves
        let room = 0.0625;
        let found = inside_ellipsoid(&ellipsoid, &along_x(-5.0, 0.0), room).unwrap();
        check(
            [found.near, found.far],
            [3.9375 - 7.875e-10, 6.0625 + 12.125e-10],
        );
        let up = Ray::new(DVec3::new(0.0, -5.0, 0.0), DVec3::Y);
        let found = inside_ellipsoid(&ellipsoid, &up, room).unwrap();
        check(
            [found.near, found.far],
            [2.875 - 5.75e-10, 7.125 + 14.25e-10],
        );
    }

    #[test]
    fn a_ray_meets_the_volume_that_was_put_around_the_object() {
        let scene = scene_of(&[
            sphere([50.0, 0.0, 0.0], 1.0),
            solid([1.0, -2.0, -2.0], [3.0, 2.0, 2.0]),
        ]);
        let set = SlabSet::SEVEN;
        let ray = along_x(0.0, 0.0);
        let line = VolumeRay::new(&ray, &set, 0.0);
        let inside = |kind| {
            let found = Volume::around(&scene, 1, kind, &set)
                .inside(&line, &set)
                .unwrap();
            [found.near, found.far]
        };
        assert_eq!(inside(VolumeKind::Box), [1.0, 3.0]);
        assert_eq!(inside(VolumeKind::Slabs), [1.0, 3.0]);
        // half the diagonal of 6 around (2, 0, 0)
        assert_eq!(inside(VolumeKind::Sphere), [-1.0, 5.0]);
        let [near, far] = inside(VolumeKind::Ellipsoid);
        let root = 3.0_f64.sqrt();
        assert!((near - (2.0 - root)).abs() <= 1e-14 && (far - (2.0 + root)).abs() <= 1e-14);
        assert!(Volume::Nothing.inside(&line, &set).is_none());
        assert_eq!((line.room(), line.across_set().room()), (0.0, 0.0));
    }

    #[test]
    fn the_room_of_a_ray_is_that_of_its_slabs() {
        let ray = along_x(0.0, 0.0);
        let line = VolumeRay::new(&ray, &SlabSet::SEVEN, 0.25);
        assert_eq!((line.room(), line.across_set().room()), (0.25, 0.25));
    }
}
