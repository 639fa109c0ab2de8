//! Lesson 11: hierarchies.
//!
//! - node: entered if the ray hits its box, else everything below it is missed
//! - heap: the nodes that wait, the nearest first
//! - nearest hit: of all leaves that were entered
//! - building: what a cut of a node costs
//!
//! A `Tree` has its root in node 0. `tree.near(node, ray, range)` is the t at which the ray enters the node's box in the range, or
//! None. `tree.below(node)` is `Below::Children(nodes)` or `Below::Objects(objects)`. `tree.hit(object, ray, range)` is t of a
//! hit with an object, or None. `TRange { min: 0.0, max: t }` is the range up to t.

use raystep::geometry::{Ray, TRange};
use raystep::lesson::exercise::supplied::{Below, Tree};

/// HIER_traverse: the nearest object by its number, and its t. A child is tested only if the ray hits its parent's box.
pub fn hier_traverse(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)> {
    todo!()
}

/// The same with a heap: the node with the smallest near is always opened next, and the search ends once that begins behind the
/// nearest hit.
///
/// A `Vec` in which you look for the smallest is heap enough.
pub fn heap(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)> {
    todo!()
}

/// What a node costs once it is cut: node_cost + (A₁·n₁ + A₂·n₂)/A, in tests of objects.
///
/// `area` is A of the node; a half is (its area, how many objects it has). `count as f64` makes a number of a count.
pub fn split_cost(node_cost: f64, area: f64, halves: [(f64, usize); 2]) -> f64 {
    todo!()
}
