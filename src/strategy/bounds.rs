//! Bounding volumes: an object is tested only if the ray hits the volume around it.
//!
//! Slides, "Optimizing Intersection Calculations": "the object need not be tested if the ray fails to
//! intersect with its bounding volume". Each test becomes cheaper, but every object still has one: the work
//! is linear in the number of objects (erratum 10). And around a sphere a sphere saves nothing.

use std::ops::ControlFlow;

use crate::geometry::{MOST_SLABS, Ray, TRange};
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::slab_rays::note_slab_rays;
use crate::strategy::{Search, Strategy};
use crate::structure::{SlabSet, Volume, VolumeKind, VolumeRay, reach, room};
use crate::trace::{BoundTest, BoundVerdict, Bounded, Event, Recorder, SlabTest};

/// Tests a ray against the volume around each object, in the order of the scene, and if it hits that where
/// a hit still counts, against the object.
#[derive(Clone, Debug)]
pub struct BoundedObjects<'a, const N: usize = MOST_SLABS> {
    pub(super) scene: &'a Scene,
    kind: VolumeKind,
    pub(super) set: SlabSet<N>,
    /// One for each object of the scene.
    volumes: Vec<Volume<N>>,
    /// The largest coordinate of the objects.
    reach: f64,
}

impl<'a, const N: usize> BoundedObjects<'a, N> {
    /// Puts a volume around each object. The set matters for [`VolumeKind::Slabs`] alone.
    pub fn new(scene: &'a Scene, kind: VolumeKind, set: &SlabSet<N>) -> Self {
        let volumes = (0..scene.objects.len())
            .map(|object| Volume::around(scene, object, kind, set))
            .collect();
        Self {
            scene,
            kind,
            set: *set,
            volumes,
            reach: reach(scene),
        }
    }

    /// The volumes, one for each object of the scene.
    pub fn volumes(&self) -> &[Volume<N>] {
        &self.volumes
    }

    /// The room for rounding that all volumes have around a ray.
    pub(super) fn room(&self, ray: &Ray) -> f64 {
        room(ray, self.reach)
    }

    /// Does the ray hit the volume around an object where a hit still counts?
    fn meets<R: Recorder>(
        &self,
        object: u32,
        ray: &VolumeRay<N>,
        range: TRange,
        recorder: &mut R,
    ) -> bool {
        let of = Bounded::Object(object);
        let mut inside = None;
        match &self.volumes[object as usize] {
            Volume::Slabs(bound) => {
                for step in bound.steps(ray.across_set(), &self.set) {
                    recorder.note(|| Event::SlabTest(SlabTest { of, step }));
                    inside = step.inside();
                }
            }
            other => inside = other.inside(ray, &self.set),
        }
        let inside = inside.and_then(|inside| inside.ends());
        let verdict = BoundVerdict::of(inside, range);
        recorder.note(|| {
            Event::BoundTest(BoundTest {
                of,
                volume: self.kind,
                inside,
                room: ray.room(),
                verdict,
            })
        });
        verdict == BoundVerdict::Hit
    }
}

impl<const N: usize> Strategy for BoundedObjects<'_, N> {
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let line = VolumeRay::new(ray, &self.set, self.room(ray));
        if self.kind == VolumeKind::Slabs {
            note_slab_rays(line.across_set(), &self.set, recorder);
        }
        for (number, object) in (0..).zip(&self.scene.objects) {
            if !self.meets(number, &line, search.range(), recorder) {
                continue;
            }
            // the object itself, or the faces of a mesh
            let first = object.first.0;
            for id in (first..first + object.count).map(PrimitiveId) {
                search.test(id, self.scene.primitive(id), ray, recorder)?;
            }
        }
        ControlFlow::Continue(())
    }

    fn bytes(&self) -> usize {
        size_of_val(self.volumes.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{cube_at, scene_of, sphere};
    use crate::strategy::noted::{noted, noted_in};

    /// What becomes of each volume, and how many objects are tested.
    fn verdicts(events: &[Event]) -> (Vec<BoundVerdict>, usize) {
        let bounds = events.iter().filter_map(|event| match event {
            Event::BoundTest(test) => Some(test.verdict),
            _ => None,
        });
        let is_test = |event: &&Event| event.object_tested().0;
        (bounds.collect(), events.iter().filter(is_test).count())
    }

    #[test]
    fn an_object_is_tested_if_the_ray_meets_its_volume_where_a_hit_still_counts() {
        use BoundVerdict::{Behind, Beyond, Hit, Missed};
        let scene = scene_of(&[
            cube_at(3.0),
            cube_at(7.0),
            cube_at(-5.0),
            sphere([5.0, 9.0, 0.0], 1.0),
        ]);
        let ray = Ray::new(DVec3::new(0.0, 0.5, 0.5), DVec3::X);
        for kind in [
            VolumeKind::Box,
            VolumeKind::Slabs,
            VolumeKind::Sphere,
            VolumeKind::Ellipsoid,
        ] {
            let strategy = BoundedObjects::new(&scene, kind, &SlabSet::SEVEN);
            let (events, hit) = noted(&strategy, &ray);
            assert_eq!(hit.map(|hit| (hit.object.0, hit.t)), Some((0, 3.0)));
            assert_eq!(
                verdicts(&events),
                (vec![Hit, Beyond, Behind, Missed], 1),
                "{kind:?}"
            );
        }
    }

    #[test]
    fn a_range_that_ends_at_the_volume_or_begins_there_still_counts() {
        use BoundVerdict::{Behind, Beyond, Hit};
        let scene = scene_of(&[cube_at(3.0)]);
        let strategy = BoundedObjects::new(&scene, VolumeKind::Box, &SlabSet::AXES);
        let ray = Ray::new(DVec3::new(0.0, 0.5, 0.5), DVec3::X);
        let of = |min, max| verdicts(&noted_in(&strategy, &ray, TRange { min, max }).0).0[0];
        assert_eq!(of(0.0, 3.0), Hit);
        assert_eq!(of(0.0, 2.9), Beyond);
        assert_eq!(of(4.0, 9.0), Hit);
        assert_eq!(of(4.1, 9.0), Behind);
    }

    #[test]
    fn there_is_one_volume_for_each_object() {
        let scene = scene_of(&[cube_at(3.0), cube_at(7.0)]);
        let strategy = BoundedObjects::new(&scene, VolumeKind::Box, &SlabSet::AXES);
        assert_eq!(strategy.volumes().len(), 2);
        assert_eq!(strategy.bytes(), 2 * size_of::<Volume<3>>());
        // 2·10⁻¹⁰ of 1 + 2 + 3 and of the largest coordinate of 8, and 10⁻¹⁰ of 8
        let ray = Ray::new(DVec3::new(1.0, -2.0, 3.0), DVec3::X);
        assert!((strategy.room(&ray) - 36e-10).abs() <= 1e-20);
    }

    #[test]
    fn s_and_t_of_each_direction_are_noted_where_slabs_are_the_volumes() {
        let scene = scene_of(&[cube_at(3.0)]);
        let ray = Ray::new(DVec3::new(0.0, 0.5, 0.5), DVec3::new(1.0, 2.0, 3.0));
        let lines = |kind| {
            let strategy = BoundedObjects::new(&scene, kind, &SlabSet::SEVEN);
            let lines = noted(&strategy, &ray)
                .0
                .into_iter()
                .filter_map(|event| match event {
                    Event::SlabRay(line) => Some(line.slab),
                    _ => None,
                });
            lines.collect::<Vec<_>>()
        };
        assert_eq!(lines(VolumeKind::Slabs), [0, 1, 2, 3, 4, 5, 6]);
        assert!(lines(VolumeKind::Box).is_empty());
    }
}
