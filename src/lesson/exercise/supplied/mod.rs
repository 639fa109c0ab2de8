//! What the crate supplies to exercises: functions and structures that a student calls and does not write.

mod children;
mod tree;
mod walked;

pub use children::{direct, hit, seen};
pub use tree::{Below, Tree};
pub use walked::Cells;
