//! The order in which nodes of a hierarchy wait to be entered.

use std::cmp::Ordering;

/// A node that waits, and where the ray enters its bound: its estimated distance.
///
/// By the estimated distance; of equals by the number of the node, so that the order is always the same.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Turn {
    /// t at which the ray enters the node's bound.
    pub(super) near: f64,
    /// The number of the node; the root is 0.
    pub(super) node: u32,
}

impl Ord for Turn {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_distance = self.near.total_cmp(&other.near);
        by_distance.then(self.node.cmp(&other.node))
    }
}

impl PartialOrd for Turn {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Turn {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Turn {}

#[cfg(test)]
mod tests {
    use std::cmp::Reverse;
    use std::collections::BinaryHeap;

    use super::*;

    #[test]
    fn the_nearest_node_comes_first_and_of_two_equally_near_that_with_the_smaller_number() {
        let turns = [(2.0, 1), (-1.0, 7), (2.0, 0), (0.5, 3), (f64::INFINITY, 2)];
        let turns = turns.map(|(near, node)| Reverse(Turn { near, node }));
        let mut heap = BinaryHeap::from(turns);
        let order = std::iter::from_fn(|| heap.pop().map(|Reverse(turn)| turn.node));
        assert_eq!(order.collect::<Vec<_>>(), [7, 3, 0, 1, 2]);
    }

    #[test]
    fn the_nearer_node_comes_first_and_of_equals_the_one_with_the_lower_number() {
        let turn = |near, node| Turn { near, node };
        assert_eq!(turn(1.0, 9).cmp(&turn(2.0, 3)), Ordering::Less);
        assert_eq!(turn(2.0, 3).cmp(&turn(2.0, 9)), Ordering::Less);
        assert!(turn(2.0, 3) == turn(2.0, 3));
        assert!(turn(2.0, 3) != turn(2.0, 4));
        assert!(turn(3.0, 3) > turn(2.0, 4));
    }
}
