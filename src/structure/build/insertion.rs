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

use crate::scene::{Primitive, Scene};
use crate::structure::build::solid::Solid;
use crate::structure::build::tree::Tree;
use crate::structure::hierarchy::Topology;

/// The growing tree, and the box around each of its nodes.
struct Growing {
    tree: Tree<Vec<u32>>,
    solids: Vec<Solid>,
    root: u32,
}

/// The hierarchy by insertion.
pub(in crate::structure) fn insertion<const N: usize>(scene: &Scene) -> Topology<N> {
    let objects = scene.primitives.len();
    if objects == 0 {
        return Topology::default();
    }
    let solid_of = |primitive: &Primitive| Solid::of(&primitive.shape);
    let mut growing = Growing {
        tree: Tree::of(objects),
        solids: scene.primitives.iter().map(solid_of).collect(),
        root: 0,
    };
    for object in 1..objects as u32 {
        growing.insert(object);
    }
    growing.tree.laid_out(growing.root)
}

impl Growing {
    /// A new node around two.
    fn pair(&mut self, first: u32, second: u32) -> u32 {
        let [a, b] = [first, second].map(|node| self.solids[node as usize]);
        self.solids.push(a.union(&b));
        self.tree.join(vec![first, second])
    }

    fn insert(&mut self, new: u32) {
        let solid = self.solids[new as usize];
        let mut node = self.root;
        if self.tree.children(node).is_none() {
            self.root = self.pair(node, new);
            return;
        }
        loop {
            let grown = self.solids[node as usize].union(&solid);
            self.solids[node as usize] = grown;
            let Some((place, child, added, is_object)) = self.best_child(node, &solid) else {
                return;
            };
            // one more child: the node's volume, once met, costs one test more
            let as_child = grown.half_area();
            if as_child <= added {
                if let Some(children) = self.tree.children_mut(node) {
                    children.push(new);
                }
                return;
            }
            if is_object {
                let pair = self.pair(child, new);
                if let Some(children) = self.tree.children_mut(node) {
                    children[place] = pair;
                }
                return;
            }
            node = child;
        }
    }

    /// The child that takes the object in at the least cost: its place, itself, what it adds, and whether it
    /// is an object, so that a pair would be made.
    fn best_child(&self, node: u32, solid: &Solid) -> Option<(usize, u32, f64, bool)> {
        let children = self.tree.children(node)?;
        let cost = |(place, &child): (usize, &u32)| {
            let before = self.solids[child as usize];
            let after = before.union(solid).half_area();
            match self.tree.children(child) {
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
