//! Volumes around objects, without their working.

use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::scene::PrimitiveId;
use crate::strategy::fast::Fast;
use crate::strategy::fast::object_test::test;
use crate::strategy::fast::slabs::BothPlanes;
use crate::strategy::{BoundedObjects, Search};
use crate::structure::{SlabSet, Volume, inside_ellipsoid, inside_sphere};

impl<const N: usize> Fast for BoundedObjects<'_, N> {
    type Aids = ();

    fn aids(&self) {}

    #[inline]
    fn search_fast(&self, (): &(), ray: &Ray, search: &mut impl Search) -> ControlFlow<()> {
        let room = self.room(ray);
        let across_axes = BothPlanes::new(ray, &SlabSet::AXES, room);
        let across_set = BothPlanes::new(ray, &self.set, room);
        for (volume, object) in self.volumes().iter().zip(&self.scene.objects) {
            let inside = match volume {
                Volume::Sphere(sphere) => inside_sphere(sphere, ray, room),
                Volume::Ellipsoid(ellipsoid) => inside_ellipsoid(ellipsoid, ray, room),
                Volume::Box(bound) => Some(across_axes.inside(bound)),
                Volume::Slabs(bound) => Some(across_set.inside(bound)),
                Volume::Nothing => None,
            };
            if !inside.is_some_and(|inside| inside.meets(search.range())) {
                continue;
            }
            let first = object.first.0;
            for id in (first..first + object.count).map(PrimitiveId) {
                test(id, self.scene.primitive(id), ray, search)?;
            }
        }
        ControlFlow::Continue(())
    }
}
