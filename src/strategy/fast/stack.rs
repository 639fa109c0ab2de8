//! The nodes that wait for their turn, without memory of their own as long as they are few.

use std::cmp::Ordering;

use crate::geometry::TRange;
use crate::strategy::fast::slabs::BothPlanes;
use crate::structure::SlabBound;

/// A node that waits to be entered.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Waiting {
    /// Where the ray enters its bound.
    pub(super) near: f64,
    pub(super) node: u32,
}

impl Waiting {
    /// A node, if the ray meets its bound where a hit still counts.
    #[inline]
    pub(super) fn met<const N: usize>(
        node: u32,
        bound: &SlabBound<N>,
        ray: &BothPlanes<N>,
        range: TRange,
    ) -> Option<Self> {
        let inside = ray.inside(bound);
        let near = inside.begins(range);
        inside.meets(range).then_some(Self { near, node })
    }
}

/// By the estimated distance; of equals by the number of the node, so that the order is always the same.
impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_distance = self.near.total_cmp(&other.near);
        by_distance.then(self.node.cmp(&other.node))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

/// How many nodes wait without memory of their own: of the twenty levels of a tree of a million objects, not
/// every one leaves a node waiting, and places are cleared anew for each ray.
const FEW: usize = 12;

/// A stack of nodes, the next one on top.
#[derive(Debug)]
pub(super) struct Stack {
    few: [Waiting; FEW],
    /// How many of the few wait.
    len: usize,
    /// What does not fit, in trees of uncommon depth.
    more: Vec<Waiting>,
}

impl Stack {
    /// Nothing waits.
    #[inline]
    pub(super) fn new() -> Self {
        Self {
            few: [Waiting::default(); FEW],
            len: 0,
            more: Vec::new(),
        }
    }

    /// Puts a node on top.
    #[inline]
    pub(super) fn push(&mut self, waiting: Waiting) {
        match self.few.get_mut(self.len) {
            Some(place) => {
                *place = waiting;
                self.len += 1;
            }
            None => self.more.push(waiting),
        }
    }

    /// Takes the node on top.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<Waiting> {
        if self.len == FEW
            && let Some(last) = self.more.pop()
        {
            return Some(last);
        }
        self.len = self.len.checked_sub(1)?;
        Some(self.few[self.len])
    }
}
