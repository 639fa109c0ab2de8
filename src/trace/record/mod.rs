//! Who listens to the tracer: recordings, filters, counts; and the tree of the rays that were recorded.

pub(crate) mod counts;
mod filter;
pub(in crate::trace) mod path_sieve;
mod ray_tree;
pub(crate) mod recorder;
mod useful_rays;

pub(crate) use counts::Counts;
pub use counts::{LightCount, RayCount, SearchCount, TestCount};
pub use filter::{Budget, Filter, Kinds, Region};
pub use path_sieve::PathSieve;
pub(crate) use path_sieve::keep_paths_behind;
pub use ray_tree::{Item, RayNode, RayTree};
pub(crate) use recorder::Off;
pub(crate) use recorder::Record;
pub(crate) use recorder::Recorder;
pub(crate) use recorder::Recording;
pub use recorder::Sink;
pub use useful_rays::UsefulRays;
