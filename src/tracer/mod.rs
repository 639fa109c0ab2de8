//! What a hit leads to: rays sent on, shades, pixels and pictures.

mod backward;
mod epsilon;
mod heat;
mod in_order;
mod log;
mod picture;
mod pixel;

pub use backward::Tracer;
pub use epsilon::{EPSILON, start_epsilon};
pub use heat::{Heat, HeatLine, HeatOf, heat_values};
pub use log::{LogOptions, LogStopped, write_log};
pub use picture::{Picture, render};
pub use pixel::{eye_samples, trace_pixel};
