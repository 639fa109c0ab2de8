//! A tree while it grows, and its nodes in the order in which a walk wants them.

use crate::scene::PrimitiveId;
use crate::structure::hierarchy::node::{Link, Node, Topology};

/// A tree over the objects of a scene. Its nodes have numbers: first come the objects with theirs, then the nodes
/// with children as they are made. `C` holds the children of a node: a list, or where all have as many an array,
/// which needs no memory of its own.
#[derive(Clone, Debug)]
pub(in crate::structure) struct Tree<C> {
    objects: usize,
    families: Vec<C>,
}

impl<C> Tree<C> {
    /// The number of the objects alone.
    pub(in crate::structure) fn of(objects: usize) -> Self {
        Self {
            objects,
            families: Vec::new(),
        }
    }

    /// A new node with these children.
    pub(in crate::structure) fn join(&mut self, children: C) -> u32 {
        self.families.push(children);
        (self.objects + self.families.len() - 1) as u32
    }

    /// The children of a node; `None` of an object.
    pub(in crate::structure) fn children(&self, node: u32) -> Option<&C> {
        let family = (node as usize).checked_sub(self.objects)?;
        Some(&self.families[family])
    }

    /// The same, to be changed.
    pub(in crate::structure) fn children_mut(&mut self, node: u32) -> Option<&mut C> {
        let family = (node as usize).checked_sub(self.objects)?;
        Some(&mut self.families[family])
    }
}

impl<C: AsRef<[u32]>> Tree<C> {
    /// The nodes with the root first and children side by side behind their parent.
    pub(in crate::structure) fn laid_out<const N: usize>(&self, root: u32) -> Topology<N> {
        let open = Node::unbounded(Link::Objects { first: 0, count: 0 });
        let mut nodes = Vec::with_capacity(self.objects + self.families.len());
        nodes.push(open);
        let mut order = Vec::with_capacity(self.objects);
        // breadth first within a family, depth first between families: what is visited together lies together
        let mut waiting = vec![root];
        let mut places = vec![0_u32];
        while let (Some(node), Some(place)) = (waiting.pop(), places.pop()) {
            nodes[place as usize].link = match self.children(node) {
                None => {
                    order.push(PrimitiveId(node));
                    Link::Objects {
                        first: order.len() as u32 - 1,
                        count: 1,
                    }
                }
                Some(children) => {
                    let children = children.as_ref();
                    let first = nodes.len() as u32;
                    let count = children.len() as u32;
                    nodes.resize(nodes.len() + children.len(), open);
                    // the first child is laid out next
                    waiting.extend(children.iter().rev());
                    places.extend((first..first + count).rev());
                    Link::Children { first, count }
                }
            };
        }
        Topology { nodes, order }
    }
}
