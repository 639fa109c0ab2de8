//! Who listens to the tracer: recordings, filters, counts; and the tree of the rays that were recorded.

mod counts;
mod filter;
pub(in crate::trace) mod path_sieve;
mod ray_tree;
pub(in crate::trace) mod recorder;
mod useful_rays;

pub use counts::{Counts, LightCount, RayCount, SearchCount, TestCount};
pub use filter::{Budget, Filter, Kinds, Region};
pub use path_sieve::PathSieve;
pub use ray_tree::{Item, RayNode, RayTree};
pub use recorder::{Off, Record, Recorder, Recording, Sink};
pub use useful_rays::UsefulRays;
