//! Bounding volumes: an object is tested only if the ray meets the volume around it.
//!
//! Slides, "Optimizing Intersection Calculations": "the object need not be tested if the ray fails to
//! intersect with its bounding volume". Each test becomes cheaper, but every object still has one: the work
//! is linear in the number of objects (erratum 10). And around a sphere a sphere saves nothing.

use std::ops::ControlFlow;

use crate::geometry::{MOST_SLABS, Ray};
use crate::scene::{Object, PrimitiveId, Scene};
use crate::strategy::slab_rays::note_slab_rays;
use crate::strategy::{Search, Strategy};
use crate::structure::{NO_SLAB, SlabSet, Volume, VolumeKind, VolumeRay, crossed, reach};
use crate::trace::{BoundOutcome, BoundTest, Bounded, Event, Recorder, SlabTest};

/// Tests a ray against the volume around each object, in the order of the scene, and if it meets that where
/// a hit still counts, against the object.
#[derive(Clone, Debug)]
pub struct BoundedObjects<'a, const N: usize = MOST_SLABS> {
    scene: &'a Scene,
    kind: VolumeKind,
    set: SlabSet<N>,
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

    /// Does the ray meet the volume where a hit still counts?
    #[inline]
    fn meets<R: Recorder>(
        &self,
        (number, volume): (u32, &Volume<N>),
        ray: &Ray,
        line: &VolumeRay<N>,
        search: &impl Search,
        recorder: &mut R,
    ) -> bool {
        let of = Bounded::Object(number);
        let mut so_far = NO_SLAB;
        let inside = volume.inside(line, |slab, near, far| {
            // a set with fewer directions than it has room for is filled up with slabs that hold everything
            if R::ENABLED
                && let Volume::Slabs(bound) = volume
                && slab < self.set.directions().len()
            {
                let step = bound.step(slab, ray, &self.set, so_far, crossed(near, far));
                so_far = [step.max_near, step.min_far];
                recorder.note(|| Event::SlabTest(SlabTest { of, step }));
            }
            R::ENABLED
        });
        let mut inside = inside.and_then(|inside| inside.ends());
        let outcome = BoundOutcome::of(inside, search.range());
        if let Volume::Slabs(_) = volume
            && R::ENABLED
        {
            // decided with room for rounding, told as the slabs were
            inside = inside.map(|_| so_far);
        }
        recorder.note(|| {
            Event::BoundTest(BoundTest {
                of,
                volume: self.kind,
                inside,
                outcome,
            })
        });
        outcome == BoundOutcome::Hit
    }

    /// Tests what an object consists of: itself, or the faces of a mesh.
    #[inline]
    fn test_object<R: Recorder>(
        &self,
        object: &Object,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let first = object.first.0;
        for id in (first..first + object.count).map(PrimitiveId) {
            search.test(id, self.scene.primitive(id), ray, recorder)?;
        }
        ControlFlow::Continue(())
    }
}

impl<const N: usize> Strategy for BoundedObjects<'_, N> {
    #[inline]
    fn search<R: Recorder>(&self, ray: &Ray, search: &mut impl Search, recorder: &mut R) {
        let line = VolumeRay::new(ray, &self.set, self.reach);
        if self.kind == VolumeKind::Slabs {
            note_slab_rays(ray, &self.set, recorder);
        }
        let volumes = (0..).zip(&self.volumes);
        for (volume, object) in volumes.zip(&self.scene.objects) {
            if !self.meets(volume, ray, &line, search, recorder) {
                continue;
            }
            if self.test_object(object, ray, search, recorder).is_break() {
                return;
            }
        }
    }

    fn bytes(&self) -> usize {
        size_of_val(self.volumes.as_slice())
    }
}
