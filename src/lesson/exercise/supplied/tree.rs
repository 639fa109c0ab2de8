//! A hierarchy over a scene, small enough to be looked at, which notes what is asked of it.

use std::cell::RefCell;
use std::fmt;

use crate::geometry::{AxisBox, Ray, TRange};
use crate::lesson::exercise::Watch;
use crate::scene::{Scene, Shape};
use crate::tracer::simple::{Own, Parts};

/// What is below a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Below {
    /// Other nodes.
    Children(Vec<usize>),
    /// The objects of a leaf.
    Objects(Vec<usize>),
}

struct Node {
    around: AxisBox,
    below: Below,
    parent: Option<usize>,
}

/// More visits than any traversal of such a tree needs.
const MOST_VISITS: usize = 10_000;

/// A tree of bounding boxes: node 0 is the root.
pub struct Tree<'a> {
    scene: &'a Scene,
    nodes: Vec<Node>,
    watch: &'a dyn Watch,
    noted: RefCell<Noted>,
}

/// What was asked.
#[derive(Clone, Debug, Default)]
pub(in crate::lesson::exercise) struct Noted {
    /// The nodes that were opened, in order.
    pub(in crate::lesson::exercise) opened: Vec<usize>,
    /// Nodes whose box the ray hits.
    met: Vec<usize>,
    /// A node that was asked for though the ray misses its parent, or though its parent was never asked for.
    pub(in crate::lesson::exercise) orphan: Option<usize>,
    visits: usize,
}

impl fmt::Debug for Tree<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tree")
            .field("nodes", &self.nodes.len())
            .finish_non_exhaustive()
    }
}

impl<'a> Tree<'a> {
    /// Halves the objects by their order, again and again, down to single ones.
    pub(in crate::lesson::exercise) fn new(scene: &'a Scene, watch: &'a dyn Watch) -> Self {
        let mut tree = Self {
            scene,
            nodes: Vec::new(),
            watch,
            noted: RefCell::default(),
        };
        let objects: Vec<usize> = (0..scene.primitives.len()).collect();
        tree.add(&objects, None);
        tree
    }

    fn add(&mut self, objects: &[usize], parent: Option<usize>) -> usize {
        let boxes = objects
            .iter()
            .map(|&object| box_of(&self.scene.primitives[object].shape));
        let around = boxes.fold(AxisBox::EMPTY, |sum, of| sum.union(&of));
        let node = self.nodes.len();
        self.nodes.push(Node {
            around,
            below: Below::Objects(objects.to_vec()),
            parent,
        });
        if 1 < objects.len() {
            let (first, second) = objects.split_at(objects.len().div_ceil(2));
            let children = vec![self.add(first, Some(node)), self.add(second, Some(node))];
            self.nodes[node].below = Below::Children(children);
        }
        node
    }

    /// Tests the box of a node: the t at which the ray enters it, or `range.min` if it starts inside. `None` if it misses the
    /// box, or has left it before the range or enters it after.
    ///
    /// # Panics
    /// A node that does not exist, or thousands of visits.
    pub fn near(&self, node: usize, ray: &Ray, range: TRange) -> Option<f64> {
        self.visit(node);
        let Node { around, parent, .. } = &self.nodes[node];
        let mut noted = self.noted.borrow_mut();
        if parent.is_some_and(|parent| !noted.met.contains(&parent)) {
            noted.orphan.get_or_insert(node);
        }
        let [near, far] = around.inside(ray)?;
        if far < range.min || range.max < near {
            return None;
        }
        noted.met.push(node);
        Some(near.max(range.min))
    }

    /// Opens a node: its children or its objects.
    ///
    /// # Panics
    /// A node that does not exist, or thousands of visits.
    pub fn below(&self, node: usize) -> &Below {
        self.visit(node);
        self.noted.borrow_mut().opened.push(node);
        &self.nodes[node].below
    }

    /// Tests an object: t of the hit, if it is in the range.
    ///
    /// # Panics
    /// An object that does not exist.
    pub fn hit(&self, object: usize, ray: &Ray, range: TRange) -> Option<f64> {
        Own.hit(&self.scene.primitives[object], ray, range)
    }

    fn visit(&self, node: usize) {
        self.watch.place(&format!("node {node}"));
        let mut noted = self.noted.borrow_mut();
        noted.visits += 1;
        assert!(
            noted.visits <= MOST_VISITS,
            "{MOST_VISITS} visits of {} nodes, the last one of node {node}: the traversal does not end",
            self.nodes.len()
        );
        assert!(
            node < self.nodes.len(),
            "there is no node {node}: the tree has {}",
            self.nodes.len()
        );
    }

    pub(in crate::lesson::exercise) fn noted(&self) -> Noted {
        self.noted.borrow().clone()
    }

    /// The boxes of all nodes.
    pub(in crate::lesson::exercise) fn boxes(&self) -> impl Iterator<Item = &AxisBox> {
        self.nodes.iter().map(|node| &node.around)
    }
}

/// The smallest box around a sphere; exercises have no other shapes.
fn box_of(shape: &Shape) -> AxisBox {
    match shape {
        Shape::Sphere(sphere) => {
            AxisBox::around([sphere.center - sphere.radius, sphere.center + sphere.radius])
        }
        Shape::Box(solid) => *solid,
        _ => AxisBox::EMPTY,
    }
}
