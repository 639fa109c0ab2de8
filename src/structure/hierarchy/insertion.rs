//! Goldsmith and Salmon's automatic hierarchy: one object after the other is put where it adds the least.
//!
//! J. Goldsmith, J. Salmon 1987, "Automatic creation of object hierarchies for ray tracing". A ray hits a
//! volume in proportion to its area, and each volume met costs one test for each of its children. An object
//! on its way down from the root has, at each node, three choices, and the cheapest is taken:
//!
//! 1. it becomes one more child of the node: the node's area is paid once more;
//! 2. it is joined with a child that is an object: a new node around both, with two children;
//! 3. it goes on into the child whose area grows the least.
//!
//! What it cost to make the nodes above larger is paid in any case. The tree depends on the order of the
//! objects; here it is that of the scene.

use crate::geometry::AxisBox;
use crate::scene::{Primitive, Scene};
use crate::structure::bounds::box_with_room;
use crate::structure::hierarchy::node::Topology;
use crate::structure::hierarchy::tree::Tree;

/// The growing tree, and the box around each of its nodes.
struct Growing {
    tree: Tree<Vec<u32>>,
    solids: Vec<AxisBox>,
    root: u32,
}

/// The hierarchy by insertion.
pub(in crate::structure) fn insertion<const N: usize>(scene: &Scene) -> Topology<N> {
    let objects = scene.primitives.len();
    if objects == 0 {
        return Topology::default();
    }
    let solid_of = |primitive: &Primitive| box_with_room(&primitive.shape);
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
    fn best_child(&self, node: u32, solid: &AxisBox) -> Option<(usize, u32, f64, bool)> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{cube_at, scene_of};
    use crate::structure::Link;

    /// What is below each node, as the first and the number of its children, or as the object.
    #[derive(Debug, PartialEq)]
    enum Below {
        Children(u32, u32),
        Object(u32),
    }

    fn below(places: &[f64]) -> Vec<Below> {
        let cubes: Vec<_> = places.iter().map(|&x| cube_at(x)).collect();
        let topology: Topology<3> = insertion(&scene_of(&cubes));
        let of = |link| match link {
            Link::Children { first, count } => Below::Children(first, count),
            Link::Objects { first, count } => {
                assert_eq!(count, 1);
                Below::Object(topology.order[first as usize].0)
            }
        };
        topology.nodes.iter().map(|node| of(node.link)).collect()
    }

    use Below::{Children, Object};

    #[test]
    fn no_object_makes_no_node_one_a_leaf_and_two_a_pair() {
        assert_eq!(below(&[]), []);
        assert_eq!(below(&[3.0]), [Object(0)]);
        assert_eq!(below(&[3.0, 9.0]), [Children(1, 2), Object(0), Object(1)]);
    }

    #[test]
    fn a_third_far_away_becomes_one_more_child() {
        // w wide and 1 × 1 across, half the surface is 2w + 1: one more child costs 2·9 + 1 = 19, a pair with the nearer cube
        // 2·(2·8 + 1) = 34
        let nodes = [Children(1, 3), Object(0), Object(1), Object(2)];
        assert_eq!(below(&[0.0, 1.0, 8.0]), nodes);
    }

    #[test]
    fn a_fourth_beside_the_third_is_joined_with_it() {
        // one more child costs 2·10 + 1 = 21, a pair with the third 2·(2·2 + 1) = 10
        let nodes = [
            Children(1, 3),
            Object(0),
            Object(1),
            Children(4, 2),
            Object(2),
            Object(3),
        ];
        assert_eq!(below(&[0.0, 1.0, 8.0, 9.0]), nodes);
    }

    #[test]
    fn a_fifth_beside_the_pair_goes_on_into_it() {
        // one more child of the root costs 2·11 + 1 = 23; the pair grows from 2 to 3, (7 − 5)·2 = 4. In it one more child costs 7
        // and a pair with the nearer cube 2·5 = 10
        let nodes = [
            Children(1, 3),
            Object(0),
            Object(1),
            Children(4, 3),
            Object(2),
            Object(3),
            Object(4),
        ];
        assert_eq!(below(&[0.0, 1.0, 8.0, 9.0, 10.0]), nodes);
    }

    #[test]
    fn growth_counts_once_for_each_grandchild() {
        // a triple of cubes at 0 and a pair at 7.5; a sixth between them at x makes the triple grow by 2x·3 and the pair by
        // 2(7.5 − x)·2, which is equal at x = 3
        let with = |x: f64| below(&[0.0, 7.5, 0.0, 0.0, 7.5, x]);
        let into = |nodes: &[Below]| match (&nodes[1], &nodes[2]) {
            (Children(_, first), Children(_, second)) => (*first, *second),
            other => panic!("{other:?}"),
        };
        assert_eq!(into(&with(2.9)), (4, 2));
        assert_eq!(into(&with(3.1)), (3, 3));
    }
}
