//! Goldsmith and Salmon's automatic hierarchy: one object after the other is put where it adds the least.
//!
//! J. Goldsmith, J. Salmon 1987, "Automatic creation of object hierarchies for ray tracing". A ray meets a
//! volume in proportion to its area, and each volume met costs one test for each of its children. An object
//! on its way down from the root has, at each node, three choices, and the cheapest is taken:
//!
//! 1. it becomes one more child of the node: the node's area is paid once more;
//! 2. it is joined with a child that is an object: a new node around both, with two children;
//! 3. it goes on into the child whose area grows the least.
//!
//! What it cost to make the nodes above larger is paid in any case. The tree depends on the order of the
//! objects; here it is that of the scene.

use crate::scene::{PrimitiveId, Scene};
use crate::structure::build::solid::Solid;
use crate::structure::build::tree::{Tree, TreeNode};
use crate::structure::hierarchy::Topology;

/// A node of the growing tree and the box around it.
struct Growing {
    tree: Tree<Vec<u32>>,
    solids: Vec<Solid>,
    root: u32,
}

/// The hierarchy by insertion.
pub(in crate::structure) fn insertion(scene: &Scene) -> Topology {
    let mut objects = (0..).map(PrimitiveId).zip(&scene.primitives);
    let Some((first, primitive)) = objects.next() else {
        return Topology::default();
    };
    let mut growing = Growing {
        tree: Tree::default(),
        solids: Vec::with_capacity(2 * scene.primitives.len()),
        root: 0,
    };
    growing.add(TreeNode::Object(first), Solid::of(&primitive.shape));
    for (id, primitive) in objects {
        growing.insert(id, Solid::of(&primitive.shape));
    }
    growing.tree.laid_out(growing.root)
}

impl Growing {
    fn add(&mut self, node: TreeNode<Vec<u32>>, solid: Solid) -> u32 {
        self.tree.nodes.push(node);
        self.solids.push(solid);
        self.solids.len() as u32 - 1
    }

    fn children(&self, node: u32) -> Option<&[u32]> {
        match &self.tree.nodes[node as usize] {
            TreeNode::Object(_) => None,
            TreeNode::Children(children) => Some(children),
        }
    }

    fn insert(&mut self, id: PrimitiveId, solid: Solid) {
        let new = self.add(TreeNode::Object(id), solid);
        let mut node = self.root;
        let Some(_) = self.children(node) else {
            let both = self.solids[node as usize].union(&solid);
            self.root = self.add(TreeNode::Children(vec![node, new]), both);
            return;
        };
        loop {
            let grown = self.solids[node as usize].union(&solid);
            self.solids[node as usize] = grown;
            let Some((place, child, added, is_object)) = self.best_child(node, &solid) else {
                return;
            };
            // one more child: the node's volume, once met, costs one test more
            let as_child = grown.half_area();
            match &mut self.tree.nodes[node as usize] {
                TreeNode::Children(children) if as_child <= added => return children.push(new),
                TreeNode::Children(_) if !is_object => node = child,
                TreeNode::Children(_) | TreeNode::Object(_) => {
                    let both = self.solids[child as usize].union(&solid);
                    let pair = self.add(TreeNode::Children(vec![child, new]), both);
                    if let TreeNode::Children(children) = &mut self.tree.nodes[node as usize] {
                        children[place] = pair;
                    }
                    return;
                }
            }
        }
    }

    /// The child that takes the object in at the least cost: its place, itself, what it adds, and whether it
    /// is an object, so that a pair would be made.
    fn best_child(&self, node: u32, solid: &Solid) -> Option<(usize, u32, f64, bool)> {
        let children = self.children(node)?;
        let cost = |(place, &child): (usize, &u32)| {
            let before = self.solids[child as usize];
            let after = before.union(solid).half_area();
            match self.children(child) {
                // a new volume with two children
                None => (place, child, 2.0 * after, true),
                // the child's volume grows, and each of its children is tested more often
                Some(grandchildren) => {
                    let growth = (after - before.half_area()) * grandchildren.len() as f64;
                    (place, child, growth, false)
                }
            }
        };
        let costs = children.iter().enumerate().map(cost);
        costs.min_by(|a, b| a.2.total_cmp(&b.2).then(a.0.cmp(&b.0)))
    }
}
