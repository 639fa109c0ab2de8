//! A tree while it grows, and its nodes in the order in which a walk wants them.

use crate::scene::PrimitiveId;
use crate::structure::hierarchy::{Link, Topology};

/// A tree of objects in which nodes are known by their places. `C` holds the children of a node: a list, or
/// where all have as many an array, which needs no memory of its own.
#[derive(Clone, Debug)]
pub(super) struct Tree<C> {
    pub(super) nodes: Vec<TreeNode<C>>,
}

/// A node of a growing tree.
#[derive(Clone, Debug)]
pub(super) enum TreeNode<C> {
    /// One object.
    Object(PrimitiveId),
    /// The places of its children.
    Children(C),
}

impl<C> Default for Tree<C> {
    fn default() -> Self {
        Self { nodes: Vec::new() }
    }
}

impl<C: AsRef<[u32]>> Tree<C> {
    /// The nodes with the root first and children side by side behind their parent.
    pub(super) fn laid_out(&self, root: u32) -> Topology {
        let mut topology = Topology::default();
        let mut waiting = vec![root];
        topology.links.push(Link::Objects { first: 0, count: 0 });
        // breadth first within a family, depth first between families: what is visited together lies together
        let mut places = vec![0_u32];
        while let (Some(node), Some(place)) = (waiting.pop(), places.pop()) {
            topology.links[place as usize] = match &self.nodes[node as usize] {
                TreeNode::Object(id) => {
                    topology.order.push(*id);
                    Link::Objects {
                        first: topology.order.len() as u32 - 1,
                        count: 1,
                    }
                }
                TreeNode::Children(children) => {
                    let children = children.as_ref();
                    let first = topology.links.len() as u32;
                    let count = children.len() as u32;
                    let open = Link::Objects { first: 0, count: 0 };
                    topology
                        .links
                        .resize(topology.links.len() + children.len(), open);
                    // the first child is laid out next
                    waiting.extend(children.iter().rev());
                    places.extend((first..first + count).rev());
                    Link::Children { first, count }
                }
            };
        }
        topology
    }
}
