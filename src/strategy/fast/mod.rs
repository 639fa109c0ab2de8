//! The second drivers: what runs where nobody follows.
//!
//! A driver here has the structure of its strategy and the same functions of geometry, finds the same object at the
//! same t, bit for bit, and has nothing to tell. So it may look at things in another order and leave out what does not
//! change the answer. `chosen.rs` alone comes here, in one line.
//!
//! - [`slabs`]: all slabs of a bound at one go, near and far by both planes side by side;
//! - [`leaf_order`]: copies of the objects in the order in which a search visits them, among them
//!   [`rounded_triangle`]s in a cache line each;
//! - [`sphere`]: spheres that are clearly missed, and the hit without its working;
//! - [`stack`]: nodes that wait without memory of their own; [`mailbox`]: stamps that no ray clears;
//! - [`grid`]: a walk without branches.
//!
//! What a driver needs beside the structure are its [`Aids`](Fast::Aids), built when the first ray comes that nobody
//! follows. z-aligned rays have none: their strategy sorts whoever looks on.

mod bounds;
mod exhaustive;
mod grid;
mod heap;
mod hierarchy;
mod leaf_order;
mod mailbox;
mod object_test;
mod rounded_triangle;
mod slabs;
mod sphere;
mod stack;

use std::fmt::Debug;
use std::ops::ControlFlow;

use crate::geometry::Ray;
use crate::strategy::{Search, Strategy};

/// A strategy with a second driver.
pub(super) trait Fast: Strategy {
    /// What only speed wants beside the structure: copies in another order, and the like.
    type Aids: Clone + Debug + Send + Sync;

    /// Builds them.
    fn aids(&self) -> Self::Aids;

    /// As [`Strategy::search`] does, and nothing is noted.
    fn search_fast(
        &self,
        aids: &Self::Aids,
        ray: &Ray,
        search: &mut impl Search,
    ) -> ControlFlow<()>;

    /// How much memory they take, in bytes.
    fn bytes_of(aids: &Self::Aids) -> usize {
        let _ = aids;
        0
    }
}
