//! How many rays one pixel may take.
//!
//! A ray that hits a surface which reflects and transmits is followed by two, each of which may be followed by two
//! again: between two panes of glass 100 deep that would be 2¹⁰⁰ rays. The limit ends such a tree.

use std::ops::ControlFlow;

use crate::trace::{Event, Recorder};
use crate::tracer::stopped::Stopped;

/// How many rays a pixel may take unless another limit is asked for: about a second's work. A pixel of a lesson's
/// scene takes at most some hundred.
pub const MAX_RAYS: u64 = 1_000_000;

/// Counts rays, and has enough beyond a limit. It wants no events.
pub(super) struct RayLimit {
    most: u64,
    rays: u64,
}

impl Recorder for RayLimit {
    const ENABLED: bool = false;

    #[inline(always)]
    fn note(&mut self, _: impl FnOnce() -> Event) {}

    #[inline]
    fn has_enough(&self) -> bool {
        self.most < self.rays
    }

    #[inline]
    fn next_ray(&mut self) -> ControlFlow<()> {
        self.rays += 1;
        if self.has_enough() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

/// Traces for a pixel with a limit of its rays, and says why if tracing stops.
#[inline]
pub(super) fn within<'r, R: Recorder, T>(
    max_rays: u64,
    pixel: [u32; 2],
    recorder: &'r mut R,
    trace: impl FnOnce(&mut (RayLimit, &'r mut R)) -> ControlFlow<(), T>,
) -> Result<T, Stopped> {
    let limit = RayLimit {
        most: max_rays,
        rays: 0,
    };
    let mut both = (limit, recorder);
    let traced = trace(&mut both);
    if both.0.has_enough() {
        return Err(Stopped::Rays { pixel, max_rays });
    }
    Stopped::unless_whole(traced, both.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::Off;

    /// Traces this many rays where five are allowed.
    fn trace(rays: u32) -> Result<u32, Stopped> {
        within(5, [3, 4], &mut Off, |recorder| {
            for _ in 0..rays {
                recorder.next_ray()?;
            }
            ControlFlow::Continue(rays)
        })
    }

    #[test]
    fn a_pixel_may_take_as_many_rays_as_the_limit_says_and_not_one_more() {
        assert_eq!(trace(0), Ok(0));
        assert_eq!(trace(5), Ok(5));
        let stopped = Stopped::Rays {
            pixel: [3, 4],
            max_rays: 5,
        };
        assert_eq!(trace(6), Err(stopped));
        assert_eq!(stopped.to_string(), "pixel 3,4 takes more than 5 rays");
    }

    #[test]
    fn a_limit_of_its_own_is_no_reason_to_stop_for_a_recorder_that_has_enough() {
        /// Has enough from the start.
        struct Enough;

        impl Recorder for Enough {
            const ENABLED: bool = true;

            fn note(&mut self, _: impl FnOnce() -> Event) {}

            fn has_enough(&self) -> bool {
                true
            }
        }

        let traced = within(5, [3, 4], &mut Enough, |recorder| {
            recorder.next_ray()?;
            ControlFlow::Continue(())
        });
        assert_eq!(traced, Err(Stopped::Recorder));
        // it has enough of the last ray: all was traced, and nothing is given
        let traced = within(5, [3, 4], &mut Enough, |_| ControlFlow::Continue(()));
        assert_eq!(traced, Err(Stopped::Recorder));
        assert_eq!(
            Stopped::Recorder.to_string(),
            "the recorder stopped the trace"
        );
    }
}
