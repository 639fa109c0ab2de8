//! S, T and the room of a ray for each direction of a set of slabs: one event each, before the tests that take them.
//!
//! Slides, on Fig. 15.58: S and T "can be calculated once for a given ray and parameterized slab".

use crate::structure::{RaySlabs, SlabSet};
use crate::trace::{Event, RaySlab, Recorder};

/// Notes S, T and the room for each direction of the set.
#[inline]
pub(super) fn note_slab_rays<const N: usize>(
    ray: &RaySlabs<N>,
    set: &SlabSet<N>,
    recorder: &mut impl Recorder,
) {
    for ((slab, &normal), &line) in (0..).zip(set.directions()).zip(ray.lines()) {
        recorder.note(|| Event::SlabRay(RaySlab::new(slab, normal, line, ray.room())));
    }
}
