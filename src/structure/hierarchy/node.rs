//! The nodes of a hierarchy, and the tree that a build decides.

use crate::scene::PrimitiveId;
use crate::structure::SlabBound;

/// A node: its bound and what it bounds.
///
/// With three slabs it takes 64 bytes, a cache line, and is aligned to one: to visit it costs one read of
/// memory and not two.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Node<const N: usize> {
    /// D_min and D_max of each slab.
    pub bound: SlabBound<N>,
    /// The child nodes, or the objects of a leaf.
    pub link: Link,
}

/// What is below a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// Other nodes, which stand one after the other.
    Children {
        /// The first of them.
        first: u32,
        /// How many.
        count: u32,
    },
    /// Objects, which stand one after the other in [`Hierarchy::order`](crate::structure::Hierarchy::order).
    Objects {
        /// The first of them.
        first: u32,
        /// How many.
        count: u32,
    },
}

impl<const N: usize> Node<N> {
    /// A node whose bound comes later.
    pub(in crate::structure) fn unbounded(link: Link) -> Self {
        Self {
            bound: SlabBound::EMPTY,
            link,
        }
    }
}

/// The nodes without their bounds: what a build decides. The root is the first; children come after their
/// parent and stand side by side.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::structure) struct Topology<const N: usize> {
    pub(in crate::structure) nodes: Vec<Node<N>>,
    /// The objects in the order of the leaves.
    pub(in crate::structure) order: Vec<PrimitiveId>,
}
