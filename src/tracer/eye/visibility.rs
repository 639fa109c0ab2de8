//! V: does nothing stand between two points? Any object that is hit is enough to say no; the nearest is not asked for.

use std::ops::ControlFlow;

use crate::strategy::Strategy;
use crate::trace::{Event, RayEnd, RayStart, RayVerdict, Recorder};
use crate::tracer::tracer::Tracer;

impl<S: Strategy> Tracer<'_, S> {
    /// Is the range of a ray free of objects? Then it ends as `arrives` says, and otherwise it is blocked.
    #[inline]
    pub(in crate::tracer) fn is_clear<R: Recorder>(
        &self,
        start: RayStart,
        arrives: RayVerdict,
        recorder: &mut R,
    ) -> ControlFlow<(), bool> {
        recorder.next_ray()?;
        recorder.note(|| Event::Ray(start));
        let hit = self.strategy.any(&start.ray, start.range, recorder);
        recorder.note(|| {
            Event::RayEnd(RayEnd {
                verdict: hit.map_or(arrives, |_| RayVerdict::Blocked),
                object: hit.map(|hit| hit.object),
                t: hit.map(|hit| hit.t),
                ..RayEnd::default()
            })
        });
        ControlFlow::Continue(hit.is_none())
    }
}
