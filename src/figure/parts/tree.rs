//! A hierarchy as a tree: where its nodes stand, leaves side by side, parents above the middle of their children.

use glam::DVec2;

use crate::figure::sheet::frame::Frame;
use crate::scene::PrimitiveId;
use crate::structure::{Hierarchy, Link, range};

/// A node in its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::figure) struct TreeNode {
    /// Across in leaves, down in levels; the root's level is 0.
    pub(in crate::figure) place: DVec2,
    pub(in crate::figure) parent: Option<u32>,
    pub(in crate::figure) children: Vec<u32>,
    /// The objects of a leaf.
    pub(in crate::figure) objects: Vec<PrimitiveId>,
    /// Is it drawn? Of a large tree only a part is.
    pub(in crate::figure) is_shown: bool,
}

/// A hierarchy laid out.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::figure) struct Tree {
    /// By the number of the node; the root is 0.
    pub(in crate::figure) nodes: Vec<TreeNode>,
    /// How many leaves and levels there are.
    size: DVec2,
}

impl Tree {
    pub(in crate::figure) fn of<const N: usize>(hierarchy: &Hierarchy<N>) -> Self {
        Self::part_of(hierarchy, |_| true)
    }

    /// Only some of its nodes; one without its parent is left out as well.
    pub(in crate::figure) fn part_of<const N: usize>(
        hierarchy: &Hierarchy<N>,
        is_shown: impl Fn(u32) -> bool,
    ) -> Self {
        let links: Vec<Link> = hierarchy.nodes().iter().map(|node| node.link).collect();
        Self::laid_out(&links, hierarchy.order(), is_shown)
    }

    fn laid_out(links: &[Link], order: &[PrimitiveId], is_shown: impl Fn(u32) -> bool) -> Self {
        let mut tree = Self {
            nodes: vec![TreeNode::default(); links.len()],
            size: DVec2::ZERO,
        };
        for (number, link) in links.iter().enumerate() {
            match *link {
                Link::Objects { first, count } => {
                    tree.nodes[number].objects = order[range(first, count)].into();
                }
                Link::Children { first, count } => {
                    tree.nodes[number].children = (first..first + count).collect();
                    for child in range(first, count) {
                        tree.nodes[child].parent = Some(number as u32);
                    }
                }
            }
        }
        if !links.is_empty() {
            tree.put(0, 0, &is_shown);
        }
        tree
    }

    /// Gives a node and what is below it their places, from the left.
    fn put(&mut self, node: usize, level: u32, is_shown: &impl Fn(u32) -> bool) {
        self.nodes[node].is_shown = true;
        let mut children = self.nodes[node].children.clone();
        children.retain(|child| is_shown(*child));
        for &child in &children {
            self.put(child as usize, level + 1, is_shown);
        }
        let x = match (children.first(), children.last()) {
            (Some(&first), Some(&last)) => {
                let [first, last] = [first, last].map(|child| self.nodes[child as usize].place.x);
                0.5 * (first + last)
            }
            _ => {
                self.size.x += 1.0;
                self.size.x - 0.5
            }
        };
        let level = f64::from(level);
        self.size.y = self.size.y.max(level + 1.0);
        self.nodes[node].place = DVec2::new(x, level);
    }

    /// The numbers of the nodes that are drawn.
    pub(in crate::figure) fn shown(&self) -> Vec<usize> {
        let numbers = 0..self.nodes.len();
        numbers
            .filter(|&number| self.nodes[number].is_shown)
            .collect()
    }

    /// How far leaves and levels are apart in a frame, at most so far.
    pub(in crate::figure) fn spacing(&self, frame: Frame, most: DVec2) -> DVec2 {
        (frame.size() / self.size.max(DVec2::ONE)).min(most)
    }

    /// Where a node stands in a frame: the tree in its middle, the root in the middle of the first level.
    pub(in crate::figure) fn at(&self, node: usize, frame: Frame, spacing: DVec2) -> DVec2 {
        let corner = frame.middle() - 0.5 * self.size * spacing;
        corner + (self.nodes[node].place + DVec2::new(0.0, 0.5)) * spacing
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parent_stands_above_the_middle_of_its_children() {
        // 0 has 1 and 2; 1 is a leaf, 2 has 3 and 4
        let links = [
            Link::Children { first: 1, count: 2 },
            Link::Objects { first: 0, count: 1 },
            Link::Children { first: 3, count: 2 },
            Link::Objects { first: 1, count: 1 },
            Link::Objects { first: 2, count: 2 },
        ];
        let order = [3, 0, 1, 2].map(PrimitiveId);
        let tree = Tree::laid_out(&links, &order, |_| true);
        let places: Vec<[f64; 2]> = tree.nodes.iter().map(|node| node.place.into()).collect();
        // leaves 1, 3, 4 from the left; 2 is between 3 and 4, 0 between 1 and 2
        let expected = [[1.25, 0.0], [0.5, 1.0], [2.0, 1.0], [1.5, 2.0], [2.5, 2.0]];
        assert_eq!(places, expected);
        let parents: Vec<_> = tree.nodes.iter().map(|node| node.parent).collect();
        assert_eq!(parents, [None, Some(0), Some(0), Some(2), Some(2)]);
        assert_eq!(tree.nodes[4].objects, [1, 2].map(PrimitiveId));
        assert_eq!(tree.size, DVec2::new(3.0, 3.0));
        // without 4 its parent stands above 3
        let part = Tree::laid_out(&links, &order, |node| node != 4);
        assert_eq!(part.shown(), [0, 1, 2, 3]);
        assert_eq!(part.nodes[2].place, DVec2::new(1.5, 1.0));
        assert_eq!(part.size, DVec2::new(2.0, 3.0));
    }
}
