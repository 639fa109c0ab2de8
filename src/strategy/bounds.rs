//! Bounding volumes: an object is tested only if the ray meets the volume around it.
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
use crate::trace::{BoundOutcome, BoundTest, Bounded, Event, Recorder, SlabTest};

/// Tests a ray against the volume around each object, in the order of the scene, and if it meets that where
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

    /// Does the ray meet the volume around an object where a hit still counts?
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
        let outcome = BoundOutcome::of(inside, range);
        recorder.note(|| {
            Event::BoundTest(BoundTest {
                of,
                volume: self.kind,
                inside,
                room: ray.room(),
                outcome,
            })
        });
        outcome == BoundOutcome::Hit
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
            note_slab_rays(ray, &self.set, recorder);
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
