//! From the eye into the scene: backward, with rays to the lights, and the pixels and pictures that come of it.

pub(in crate::tracer) mod backward;
pub(in crate::tracer) mod heat;
mod hybrid_light;
pub(in crate::tracer) mod picture;
pub(in crate::tracer) mod pixel;
mod visibility;

pub use heat::{Heat, HeatLine, HeatOf, heat_values};
pub use picture::{Picture, render};
pub use pixel::{eye_samples, trace_pixel};
