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
    // BEGIN SOLUTION
    let mut nearest = None;
    traverse(tree, ray, 0, &mut nearest);
    return nearest;

    fn traverse(tree: &Tree<'_>, ray: &Ray, node: usize, nearest: &mut Option<(usize, f64)>) {
        if tree.near(node, ray, TRange::FORWARD).is_none() {
            return;
        }
        match tree.below(node) {
            Below::Children(children) => {
                for &child in children {
                    traverse(tree, ray, child, nearest);
                }
            }
            Below::Objects(objects) => {
                for &object in objects {
                    if let Some(t) = tree.hit(object, ray, TRange::FORWARD)
                        && nearest.is_none_or(|(_, nearest)| t < nearest)
                    {
                        *nearest = Some((object, t));
                    }
                }
            }
        }
    }
    // END SOLUTION
}

/// The same with a heap: the node with the smallest near is always opened next, and the search ends once that begins behind the
/// nearest hit.
///
/// A `Vec` in which you look for the smallest is heap enough.
pub fn heap(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)> {
    // BEGIN SOLUTION
    let mut nearest: Option<(usize, f64)> = None;
    let mut waiting: Vec<(f64, usize)> = Vec::new();
    waiting.extend(tree.near(0, ray, TRange::FORWARD).map(|near| (near, 0)));
    while let Some(place) = smallest(&waiting) {
        let (near, node) = waiting.swap_remove(place);
        if nearest.is_some_and(|(_, t)| t < near) {
            break;
        }
        match tree.below(node) {
            Below::Children(children) => {
                for &child in children {
                    let near = tree.near(child, ray, TRange::FORWARD);
                    waiting.extend(near.map(|near| (near, child)));
                }
            }
            Below::Objects(objects) => {
                for &object in objects {
                    if let Some(t) = tree.hit(object, ray, TRange::FORWARD)
                        && nearest.is_none_or(|(_, nearest)| t < nearest)
                    {
                        nearest = Some((object, t));
                    }
                }
            }
        }
    }
    return nearest;

    fn smallest(waiting: &[(f64, usize)]) -> Option<usize> {
        (0..waiting.len()).min_by(|&one, &other| waiting[one].0.total_cmp(&waiting[other].0))
    }
    // END SOLUTION
}

/// What a node costs once it is cut: node_cost + (A₁·n₁ + A₂·n₂)/A, in tests of objects.
///
/// `area` is A of the node; a half is (its area, how many objects it has). `count as f64` makes a number of a count.
pub fn split_cost(node_cost: f64, area: f64, halves: [(f64, usize); 2]) -> f64 {
    // BEGIN SOLUTION
    let [first, second] = halves.map(|(area, count)| area * count as f64);
    node_cost + (first + second) / area
    // END SOLUTION
}
