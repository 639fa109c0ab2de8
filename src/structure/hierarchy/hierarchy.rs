//! Hierarchies: bounds within bounds, with the objects at the leaves.
//!
//! Slides, "Hierarchies": "bounding volumes may be organized in nested hierarchies with objects at the
//! leaves and internal nodes that bound their children". Which nodes there are is decided by one of the
//! [`Build`]s; a parent's D_min and D_max come from its children's, from the bottom up, whatever built it.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::Ray;
use crate::scene::{PrimitiveId, Scene};
use crate::structure::hierarchy::bottom_up::bottom_up;
use crate::structure::hierarchy::insertion::insertion;
use crate::structure::hierarchy::node::{Link, Node, Topology};
use crate::structure::hierarchy::surface_area::surface_area;
use crate::structure::{RaySlabs, SlabBound, SlabSet, room};

/// How a hierarchy is built. All give the same hits at another cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[doc(alias = "BVH construction")]
#[doc(alias = "SAH")]
#[serde(rename_all = "kebab-case")]
pub enum Build {
    /// From the objects up: the nearest two volumes are joined each time, as the slides say.
    #[default]
    BottomUp,
    /// Objects are inserted one by one where they add the least area (Goldsmith and Salmon 1987).
    Insertion,
    /// From the top down: each node is split where the surface-area heuristic expects the fewest tests.
    SurfaceArea,
}

/// A hierarchy over the objects of a scene, with N slabs to a bound.
#[doc(alias = "BVH")]
#[doc(alias = "bounding volume hierarchy")]
#[derive(Clone, Debug)]
pub struct Hierarchy<const N: usize> {
    set: SlabSet<N>,
    nodes: Vec<Node<N>>,
    order: Vec<PrimitiveId>,
    /// The largest coordinate of the objects.
    reach: f64,
}

/// Two volumes joined: one pair of planes of a node, as it grows by one child.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MergeStep {
    /// The node whose bound it becomes.
    pub node: u32,
    /// The volume so far: the first child, or the node itself from the third child on.
    pub first: u32,
    /// The child that is joined to it.
    pub second: u32,
    /// Which direction of the set, from 0.
    pub slab: u32,
    /// D_min of the slab of both volumes, without padding.
    pub d_min: [f64; 2],
    /// D_max of the slab of both volumes, without padding.
    pub d_max: [f64; 2],
}

impl MergeStep {
    /// D_min and D_max of both together: "the minimum D_min and the maximum D_max".
    pub fn joined(&self) -> (f64, f64) {
        let ([a_min, b_min], [a_max, b_max]) = (self.d_min, self.d_max);
        (a_min.min(b_min), a_max.max(b_max))
    }
}

impl<const N: usize> Hierarchy<N> {
    /// Builds the hierarchy of a scene. A scene without objects has none of nodes.
    pub fn new(scene: &Scene, set: &SlabSet<N>, build: Build) -> Self {
        let topology = match build {
            Build::BottomUp => bottom_up(scene),
            Build::Insertion => insertion(scene),
            Build::SurfaceArea => surface_area(scene),
        };
        Self::bounded(scene, *set, topology)
    }

    /// Gives the nodes their bounds, from the bottom up.
    fn bounded(scene: &Scene, set: SlabSet<N>, topology: Topology<N>) -> Self {
        let Topology { mut nodes, order } = topology;
        // children stand behind their parent
        for at in (0..nodes.len()).rev() {
            let bound = |of: &[Node<N>], bound: SlabBound<N>| {
                of.iter().fold(bound, |sum, node| sum.union(&node.bound))
            };
            nodes[at].bound = match nodes[at].link {
                Link::Children { first, count } => {
                    bound(&nodes[range(first, count)], SlabBound::EMPTY)
                }
                Link::Objects { first, count } => order[range(first, count)]
                    .iter()
                    .map(|&id| SlabBound::of(&scene.primitive(id).shape, &set))
                    .fold(SlabBound::EMPTY, |sum, of| sum.union(&of)),
            };
        }
        let reach = reach(scene);
        Self {
            set,
            nodes,
            order,
            reach,
        }
    }

    /// The directions of the slabs.
    #[inline]
    pub fn set(&self) -> &SlabSet<N> {
        &self.set
    }

    /// The room for rounding that all bounds have around a ray.
    #[inline]
    pub fn room(&self, ray: &Ray) -> f64 {
        room(ray, self.reach)
    }

    /// S and T of a ray for the slabs of all nodes.
    pub fn ray_slabs(&self, ray: &Ray) -> RaySlabs<N> {
        RaySlabs::new(ray, &self.set, self.room(ray))
    }

    /// The nodes, the root first; a scene without objects has none.
    #[inline]
    pub fn nodes(&self) -> &[Node<N>] {
        &self.nodes
    }

    /// The objects in the order of the leaves.
    #[inline]
    pub fn order(&self) -> &[PrimitiveId] {
        &self.order
    }

    /// How the bounds of the inner nodes came about, from the bottom up: child by child, slab by slab
    /// (Fig. 15.58(b)).
    pub fn merges(&self) -> impl Iterator<Item = MergeStep> + '_ {
        let slabs = self.set.directions().len();
        (0..self.nodes.len()).rev().flat_map(move |at| {
            let (first, count) = match self.nodes[at].link {
                Link::Children { first, count } => (first, count),
                Link::Objects { .. } => (0, 0),
            };
            (1..count).flat_map(move |child| {
                let before = &self.nodes[range(first, child)];
                let so_far = before
                    .iter()
                    .fold(SlabBound::EMPTY, |sum, node| sum.union(&node.bound));
                let joined = self.nodes[(first + child) as usize].bound;
                (0..slabs).map(move |slab| MergeStep {
                    node: at as u32,
                    first: if child == 1 { first } else { at as u32 },
                    second: first + child,
                    slab: slab as u32,
                    d_min: [so_far.d_min[slab], joined.d_min[slab]],
                    d_max: [so_far.d_max[slab], joined.d_max[slab]],
                })
            })
        })
    }

    /// How much memory the nodes and the order of the objects take, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.order.as_slice())
    }
}

/// The largest absolute coordinate or radius of the objects.
pub(crate) fn reach(scene: &Scene) -> f64 {
    let reaches = scene.primitives.iter().map(|object| object.shape.reach());
    reaches.fold(0.0, f64::max)
}

/// `count` places from `first` on.
#[inline]
pub(crate) fn range(first: u32, count: u32) -> std::ops::Range<usize> {
    first as usize..(first + count) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{cube_at, scene_of, solid};

    /// Four cubes in a row: three children of the root by insertion, of which the last has the two that lie together.
    fn three_children() -> (Scene, Hierarchy<3>) {
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let hierarchy = Hierarchy::new(&scene, &SlabSet::AXES, Build::Insertion);
        (scene, hierarchy)
    }

    #[test]
    fn each_build_gives_the_hierarchy_it_is_named_for() {
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let nodes = |build| Hierarchy::new(&scene, &SlabSet::AXES, build).nodes().len();
        // pairs of pairs of objects; a root over two objects and a pair; a root over two leaves of two
        assert_eq!(nodes(Build::BottomUp), 7);
        assert_eq!(nodes(Build::Insertion), 6);
        assert_eq!(nodes(Build::SurfaceArea), 3);
    }

    #[test]
    fn a_parent_s_bound_is_that_of_its_children() {
        let (_, hierarchy) = three_children();
        // D = −p: x from 0 to 10 for the root, from 8 to 10 for the pair
        let bound = |node: usize| {
            let SlabBound { d_min, d_max } = hierarchy.nodes()[node].bound;
            [d_min[0], d_max[0], d_min[1], d_max[1]]
        };
        let zero = 0.0;
        assert_eq!(bound(0), [-10.0, zero, -1.0, zero]);
        assert_eq!(bound(2), [-2.0, -1.0, -1.0, zero]);
        assert_eq!(bound(3), [-10.0, -8.0, -1.0, zero]);
    }

    #[test]
    fn merges_join_the_first_child_with_the_second_and_what_has_grown_with_the_third() {
        let (_, hierarchy) = three_children();
        let along_x: Vec<_> = hierarchy.merges().filter(|merge| merge.slab == 0).collect();
        let of = |merge: &MergeStep| (merge.node, merge.first, merge.second);
        // from the bottom up: the pair at node 3, then the root's three
        let steps: Vec<_> = along_x.iter().map(of).collect();
        assert_eq!(steps, [(3, 4, 5), (0, 1, 2), (0, 0, 3)]);
        assert_eq!(along_x[0].joined(), (-10.0, -8.0));
        assert_eq!(
            (along_x[1].d_min, along_x[1].d_max),
            ([-1.0, -2.0], [0.0, -1.0])
        );
        assert_eq!(along_x[1].joined(), (-2.0, 0.0));
        assert_eq!(
            (along_x[2].d_min, along_x[2].d_max),
            ([-2.0, -10.0], [0.0, -8.0])
        );
        assert_eq!(along_x[2].joined(), (-10.0, 0.0));
        assert_eq!(hierarchy.merges().count(), 9);
    }

    #[test]
    fn a_node_takes_64_bytes_and_an_object_4() {
        let (_, hierarchy) = three_children();
        assert_eq!(hierarchy.bytes(), 6 * 64 + 4 * 4);
        let order: Vec<_> = hierarchy.order().iter().map(|id| id.0).collect();
        assert_eq!(order, [0, 1, 2, 3]);
    }

    #[test]
    fn the_room_around_a_ray_is_that_of_the_largest_coordinate() {
        let scene = scene_of(&[cube_at(3.0), solid([-20.0, 0.0, 0.0], [1.0, 1.0, 1.0])]);
        assert_eq!(reach(&scene), 20.0);
        assert_eq!(reach(&scene_of(&[])), 0.0);
        let hierarchy = Hierarchy::new(&scene, &SlabSet::AXES, Build::BottomUp);
        // 2·10⁻¹⁰ of 1 + 2 + 3 + 20 and 10⁻¹⁰ of 20
        let ray = Ray::new(glam::DVec3::new(1.0, -2.0, 3.0), glam::DVec3::X);
        assert!((hierarchy.room(&ray) - 72e-10).abs() <= 1e-20);
        assert_eq!(hierarchy.ray_slabs(&ray).room(), hierarchy.room(&ray));
        assert_eq!(range(3, 4), 3..7);
    }
}
