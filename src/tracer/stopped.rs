//! Why a trace did not end as it should.

use std::fmt;
use std::ops::ControlFlow;

use crate::trace::Recorder;

/// Why a trace did not end as it should.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// The recorder has enough.
    Recorder,
    /// A pixel takes more rays than it may.
    Rays {
        /// Column and row. Through the corners: one of the pixels around the corner.
        pixel: [u32; 2],
        /// How many it may take.
        max_rays: u64,
    },
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Recorder => f.write_str("the recorder stopped the trace"),
            Self::Rays {
                pixel: [x, y],
                max_rays,
            } => write!(f, "pixel {x},{y} takes more than {max_rays} rays"),
        }
    }
}

impl Stopped {
    /// What was traced, if the recorder has heard all of it. A recorder that has enough of the last ray stops no ray.
    #[inline]
    pub(super) fn unless_whole<T>(
        traced: ControlFlow<(), T>,
        recorder: &impl Recorder,
    ) -> Result<T, Self> {
        match traced {
            ControlFlow::Continue(traced) if !recorder.has_enough() => Ok(traced),
            _ => Err(Self::Recorder),
        }
    }
}

impl std::error::Error for Stopped {}
