//! S and T of a ray for each direction of a set of slabs: one event each, before the tests that take them.
//!
//! Slides, on Fig. 15.58: S and T "can be calculated once for a given ray and parameterized slab".

use crate::geometry::Ray;
use crate::structure::SlabSet;
use crate::trace::{Event, RaySlab, Recorder};

/// Notes S and T for each direction of the set.
#[inline]
pub(super) fn note_slab_rays<const N: usize>(
    ray: &Ray,
    set: &SlabSet<N>,
    recorder: &mut impl Recorder,
) {
    for (slab, &normal) in (0..).zip(set.directions()) {
        recorder.note(|| Event::SlabRay(RaySlab::new(ray, slab, normal)));
    }
}
