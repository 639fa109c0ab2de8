//! Built from the top down by the surface-area heuristic, for speed.
//!
//! A ray that hits a node hits a child in proportion to the areas of their boxes (J. Goldsmith and
//! J. Salmon 1987). Cutting a node with area A into halves with areas A₁, A₂ and n₁, n₂ objects costs about
//!
//! C_node + C_object·(A₁·n₁ + A₂·n₂)/A,   and not cutting it C_object·n.
//!
//! The cut is looked for between [`BINS`] bins along each axis (I. Wald 2007). Erratum 14: hierarchies are
//! built top-down as well.

use glam::DVec3;

use crate::geometry::AxisBox;
use crate::scene::{Primitive, PrimitiveId, Scene, Shape};
use crate::structure::bounds::box_with_room;
use crate::structure::hierarchy::node::{Link, Node, Topology};

/// Into how many bins at most the centers are sorted along an axis: more of them find hardly better cuts.
const BINS: usize = 16;
/// What a node costs in tests of objects. Measured: from 0.6 to 2 the time of a ray hardly changes.
const NODE_COST: f64 = 1.5;
/// The same in tests of spheres, which are cheaper: most of them end after a few products.
const NODE_COST_IN_SPHERES: f64 = 2.2;
/// The most objects in a leaf, unless they cannot be split.
const LARGEST_LEAF: usize = 8;
/// From this depth on a node is cut into equal halves: what is left is few objects, or hopeless.
const DEEPEST: u32 = 64;

/// An object on its way into a leaf.
#[derive(Clone, Copy)]
struct Item {
    solid: AxisBox,
    id: PrimitiveId,
}

/// A node that is not cut yet: its place and its objects.
struct Task {
    node: usize,
    from: usize,
    to: usize,
    depth: u32,
    /// Around its objects.
    solid: AxisBox,
}

/// The hierarchy by the surface-area heuristic.
pub(in crate::structure) fn surface_area<const N: usize>(scene: &Scene) -> Topology<N> {
    let mut items: Vec<Item> = (0..)
        .map(PrimitiveId)
        .zip(&scene.primitives)
        .map(|(id, primitive)| Item {
            solid: box_with_room(&primitive.shape),
            id,
        })
        .collect();
    if items.is_empty() {
        return Topology::default();
    }
    let node_cost = node_cost(scene);
    let open = Node::unbounded(Link::Objects { first: 0, count: 0 });
    let mut nodes = vec![open];
    let mut tasks = vec![Task {
        node: 0,
        from: 0,
        to: items.len(),
        depth: 0,
        solid: around(&items),
    }];
    while let Some(Task {
        node,
        from,
        to,
        depth,
        solid,
    }) = tasks.pop()
    {
        nodes[node].link = match cut(&mut items[from..to], &solid, depth, node_cost) {
            None => Link::Objects {
                first: from as u32,
                count: (to - from) as u32,
            },
            Some(Halves { left, solids }) => {
                let first = nodes.len();
                nodes.extend([open; 2]);
                let depth = depth + 1;
                let middle = from + left;
                // the first half is laid out next
                let halves = [(first + 1, middle, to), (first, from, middle)];
                for ((node, from, to), solid) in halves.into_iter().zip([solids[1], solids[0]]) {
                    tasks.push(Task {
                        node,
                        from,
                        to,
                        depth,
                        solid,
                    });
                }
                Link::Children {
                    first: first as u32,
                    count: 2,
                }
            }
        };
    }
    Topology {
        nodes,
        order: items.into_iter().map(|item| item.id).collect(),
    }
}

/// What a node costs in tests of the objects of this scene: the mean over its kinds of objects.
fn node_cost(scene: &Scene) -> f64 {
    let is_sphere = |object: &&Primitive| matches!(object.shape, Shape::Sphere(_));
    let spheres = scene.primitives.iter().filter(is_sphere).count() as f64;
    let share = spheres / scene.primitives.len() as f64;
    NODE_COST + share * (NODE_COST_IN_SPHERES - NODE_COST)
}

/// The box around objects.
fn around(items: &[Item]) -> AxisBox {
    let join = |sum: AxisBox, item: &Item| sum.union(&item.solid);
    items.iter().fold(AxisBox::EMPTY, join)
}

/// A node that is cut in two.
struct Halves {
    /// How many objects the first half has.
    left: usize,
    /// The boxes around the halves.
    solids: [AxisBox; 2],
}

/// Sorts the objects of a node into two halves; `None` if it stays whole. `solid` is the box around them.
fn cut(items: &mut [Item], solid: &AxisBox, depth: u32, node_cost: f64) -> Option<Halves> {
    let count = items.len();
    if count <= 1 {
        return None;
    }
    let bins = Binning::new(items);
    let best = if depth < DEEPEST {
        best_cut(items, &bins)
    } else {
        None
    };
    let cost_of_leaf = count as f64 * solid.half_area();
    match best {
        Some(cut) => {
            let cost = node_cost * solid.half_area() + cut.cost;
            if count <= LARGEST_LEAF && cost_of_leaf <= cost {
                return None;
            }
            let left = partition(items, |item| bins.along(cut.axis, item) <= cut.bin);
            let solids = cut.solids;
            Some(Halves { left, solids })
        }
        // all centers in one place: the objects cannot be split
        None if count <= LARGEST_LEAF => None,
        None => {
            let (first, second) = items.split_at(count / 2);
            Some(Halves {
                left: first.len(),
                solids: [around(first), around(second)],
            })
        }
    }
}

/// A cut behind a bin.
struct Cut {
    cost: f64,
    axis: usize,
    bin: usize,
    solids: [AxisBox; 2],
}

/// Which bin an object belongs to, along each axis.
struct Binning {
    /// How many bins there are along each axis.
    count: u32,
    low: DVec3,
    /// Bins for each unit of a doubled center; 0 where all centers agree.
    scale: DVec3,
}

impl Binning {
    /// The bins from the lowest to the highest of the centers. Few objects need few: twice as many as there
    /// are objects tell nearly all of them apart.
    fn new(items: &[Item]) -> Self {
        let centers = items.iter().map(|item| item.solid.doubled_center());
        let around = AxisBox::around(centers);
        let count = BINS.min(2 * items.len()) as u32;
        let scale = around.size().to_array().map(|side| {
            let scale = f64::from(count) / side;
            if scale.is_finite() { scale } else { 0.0 }
        });
        Self {
            count,
            low: around.min,
            scale: scale.into(),
        }
    }

    /// Along one axis.
    #[inline]
    fn along(&self, axis: usize, item: &Item) -> usize {
        let place = (item.solid.doubled_center()[axis] - self.low[axis]) * self.scale[axis];
        (place as u32).min(self.count - 1) as usize
    }
}

/// What is in a bin, or in several.
#[derive(Clone, Copy)]
struct Bin {
    solid: AxisBox,
    count: u32,
}

impl Bin {
    const EMPTY: Self = Self {
        solid: AxisBox::EMPTY,
        count: 0,
    };

    #[inline]
    fn add(&mut self, other: &Self) {
        self.solid = self.solid.union(&other.solid);
        self.count += other.count;
    }

    /// A·n; infinite of nothing, for that is no half.
    #[inline]
    fn cost(&self) -> f64 {
        if self.count == 0 {
            return f64::INFINITY;
        }
        self.solid.half_area() * f64::from(self.count)
    }
}

/// The cut with the least A₁·n₁ + A₂·n₂, over all axes; `None` if all centers are in one bin.
fn best_cut(items: &[Item], bins: &Binning) -> Option<Cut> {
    let mut filled = [[Bin::EMPTY; BINS]; 3];
    for item in items {
        for (axis, filled) in filled.iter_mut().enumerate() {
            filled[bins.along(axis, item)].add(&Bin {
                solid: item.solid,
                count: 1,
            });
        }
    }
    let mut least = f64::INFINITY;
    let mut place = None;
    for (axis, filled) in filled.iter().enumerate() {
        let filled = &filled[..bins.count as usize];
        // A₂·n₂ of what lies behind each bin, from the last one down
        let mut behind = [f64::INFINITY; BINS];
        let mut sum = Bin::EMPTY;
        for (bin, of) in filled.iter().enumerate().skip(1).rev() {
            sum.add(of);
            behind[bin - 1] = sum.cost();
        }
        let mut sum = Bin::EMPTY;
        for (bin, (of, behind)) in filled.iter().zip(behind).enumerate() {
            sum.add(of);
            let cost = sum.cost() + behind;
            if cost < least {
                least = cost;
                place = Some((axis, bin));
            }
        }
    }
    let (axis, bin) = place?;
    let (before, behind) = filled[axis].split_at(bin + 1);
    let solid = |bins: &[Bin]| {
        let join = |sum: AxisBox, bin: &Bin| sum.union(&bin.solid);
        bins.iter().fold(AxisBox::EMPTY, join)
    };
    Some(Cut {
        cost: least,
        axis,
        bin,
        solids: [solid(before), solid(behind)],
    })
}

/// Moves the items for which it is true to the front and counts them.
fn partition(items: &mut [Item], first: impl Fn(&Item) -> bool) -> usize {
    let mut middle = 0;
    for at in 0..items.len() {
        if first(&items[at]) {
            items.swap(middle, at);
            middle += 1;
        }
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{cube_at, scene_of, sphere};

    /// What becomes of each node: the first child or object, how many, and whether they are objects.
    fn links(scene: &Scene) -> Vec<(u32, u32, bool)> {
        let topology: Topology<3> = surface_area(scene);
        let links = topology.nodes.iter().map(|node| match node.link {
            Link::Children { first, count } => (first, count, false),
            Link::Objects { first, count } => (first, count, true),
        });
        links.collect()
    }

    fn order(scene: &Scene) -> Vec<u32> {
        let topology: Topology<3> = surface_area(scene);
        topology.order.iter().map(|id| id.0).collect()
    }

    fn items(scene: &Scene) -> Vec<Item> {
        let item = |(id, primitive): (PrimitiveId, &Primitive)| Item {
            solid: box_with_room(&primitive.shape),
            id,
        };
        (0..)
            .map(PrimitiveId)
            .zip(&scene.primitives)
            .map(item)
            .collect()
    }

    #[test]
    fn two_pairs_of_cubes_far_apart_are_cut_between_the_pairs() {
        // w wide and 1 × 1 across, half the surface is 2w + 1. Whole: 4·21 = 84. Cut: 1.5·21 + 5·2 + 5·2 = 51.5. A pair
        // whole: 2·5 = 10; cut: 1.5·5 + 3 + 3 = 13.5
        for places in [[0.0, 1.0, 8.0, 9.0], [8.0, 0.0, 9.0, 1.0]] {
            let scene = scene_of(&places.map(cube_at));
            assert_eq!(links(&scene), [(1, 2, false), (0, 2, true), (2, 2, true)]);
            let sorted = order(&scene);
            let is_left = |id: &u32| places[*id as usize] < 5.0;
            assert!(sorted[..2].iter().all(is_left), "{sorted:?}");
            assert!(!sorted[2..].iter().any(is_left), "{sorted:?}");
        }
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let items = items(&scene);
        let cut = best_cut(&items, &Binning::new(&items)).unwrap();
        // the cubes are wider by some 10⁻⁹
        assert!((cut.cost - 20.0).abs() <= 1e-7, "{}", cut.cost);
        assert_eq!(cut.axis, 0);
        let [left, right] = cut.solids.map(|solid| [solid.min.x, solid.max.x]);
        for (found, expected) in [left, right]
            .into_iter()
            .flatten()
            .zip([0.0, 2.0, 8.0, 10.0])
        {
            assert!((found - expected).abs() <= 1e-8, "{found}");
        }
    }

    #[test]
    fn a_cut_pays_from_the_width_on_at_which_the_saved_tests_cost_more_than_the_node() {
        let is_cut = |shapes: [String; 2]| links(&scene_of(&shapes)).len() == 3;
        // boxes: 2(2w + 1) against 1.5(2w + 1) + 6, so from w = 5.5 on
        assert!(!is_cut([0.0, 4.4].map(cube_at)));
        assert!(is_cut([0.0, 4.6].map(cube_at)));
        // spheres, where a node costs 2.2 tests: never
        let balls = [1.0, 1000.0].map(|x| sphere([x, 0.0, 0.0], 0.5));
        assert!(!is_cut(balls));
        // one of each, where it costs 1.85: 0.15(2w + 1) against 6, so from w = 19.5 on
        let ball = || sphere([0.5, 0.5, 0.5], 0.5);
        assert!(!is_cut([ball(), cube_at(18.4)]));
        assert!(is_cut([ball(), cube_at(18.6)]));
    }

    #[test]
    fn the_cut_may_be_across_any_axis_and_need_not_be_in_the_middle() {
        use crate::scene::small_scene::solid;
        for axis in 0..3 {
            let cube = |at: f64| {
                let (mut min, mut max) = ([0.0; 3], [1.0; 3]);
                (min[axis], max[axis]) = (at, at + 1.0);
                solid(min, max)
            };
            // A₁·n₁ + A₂·n₂ = 7·3 + 3·1 = 24 where the one far away is cut off; elsewhere it is part of a long box
            let scene = scene_of(&[0.0, 20.0, 1.0, 2.0].map(cube));
            assert_eq!(links(&scene), [(1, 2, false), (0, 3, true), (3, 1, true)]);
            let scene = scene_of(&[0.0, 20.0, 19.0, 18.0].map(cube));
            assert_eq!(links(&scene), [(1, 2, false), (0, 1, true), (1, 3, true)]);
        }
    }

    #[test]
    fn of_objects_in_one_place_eight_make_a_leaf_and_more_are_halved() {
        let equal = |count: usize| links(&scene_of(&vec![cube_at(3.0); count]));
        assert_eq!(equal(1), [(0, 1, true)]);
        assert_eq!(equal(8), [(0, 8, true)]);
        assert_eq!(equal(9), [(1, 2, false), (0, 4, true), (4, 5, true)]);
        assert!(links(&scene_of(&[])).is_empty());
    }

    #[test]
    fn more_than_eight_objects_are_cut_even_where_a_leaf_would_cost_less() {
        // nearly in one place, so that every box is some 1 long: 9·3 against 1.5·3 + 9·3
        let near: Vec<_> = (0..9).map(|i| cube_at(1e-3 * f64::from(i))).collect();
        assert_eq!(links(&scene_of(&near)).len(), 3);
        assert_eq!(links(&scene_of(&near[..8])).len(), 1);
    }

    #[test]
    fn a_node_at_the_depth_limit_is_halved_by_number() {
        let scene =
            scene_of(&[0.0, 1.0, 2.0, 30.0, 31.0, 32.0, 33.0, 34.0, 35.0, 36.0].map(cube_at));
        let mut items = items(&scene);
        let whole = around(&items);
        let halves = |items: &mut [Item], depth| cut(items, &whole, depth, 1.5).map(|of| of.left);
        assert_eq!(halves(&mut items, DEEPEST - 1), Some(3));
        assert_eq!(halves(&mut items, DEEPEST), Some(5));
        assert_eq!(halves(&mut items[..8], DEEPEST), None);
    }

    #[test]
    fn bins_are_twice_as_many_as_objects_up_to_sixteen_from_the_first_center_to_the_last() {
        let scene = scene_of(&[0.0, 1.1, 2.0].map(cube_at));
        let of_three = items(&scene);
        let bins = Binning::new(&of_three);
        // six bins for centers at 0, at 1.1 of 2 and at 2, which belongs to the last bin
        let found = [0, 1, 2].map(|i| bins.along(0, &of_three[i]));
        assert_eq!(found, [0, 3, 5]);
        // across, all centers agree
        assert_eq!([1, 2].map(|axis| bins.along(axis, &of_three[2])), [0, 0]);
        let places = (0..=16).map(|i| f64::from(i) + if i % 16 == 0 { 0.0 } else { 0.3 });
        let scene = scene_of(&places.map(cube_at).collect::<Vec<_>>());
        let of_many = items(&scene);
        let bins = Binning::new(&of_many);
        // one apart each, and the last two share a bin
        let found: Vec<_> = of_many.iter().map(|item| bins.along(0, item)).collect();
        assert!(found[..16].iter().copied().eq(0..16), "{found:?}");
        assert_eq!(found[16], 15);
    }

    #[test]
    fn partitioning_moves_what_belongs_to_the_front_and_counts_it() {
        let scene = scene_of(&[0.0, 1.0, 2.0, 3.0, 4.0].map(cube_at));
        let mut items = items(&scene);
        let count = partition(&mut items, |item| item.id.0 % 2 == 1);
        assert_eq!(count, 2);
        let front: Vec<_> = items[..2].iter().map(|item| item.id.0).collect();
        assert_eq!(front, [1, 3]);
    }

    #[test]
    fn the_area_behind_a_cut_is_that_of_the_bins_behind_it_alone() {
        // sixteen touching cubes, one in each bin: 2·8 + 1 times 8 on either side
        let scene = scene_of(
            &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15].map(|i| cube_at(f64::from(i))),
        );
        let items = items(&scene);
        let cut = best_cut(&items, &Binning::new(&items)).unwrap();
        assert!((cut.cost - 272.0).abs() <= 1e-6, "{}", cut.cost);
        assert_eq!(cut.bin, 7);
    }

    #[test]
    fn a_row_whose_distances_double_makes_a_tree_that_is_halved_below_the_depth_limit() {
        // each cut takes a few of the furthest: without the limit the tree would be 79 deep. At depth 64 the objects that are
        // left are halved until leaves of up to 8 are
        let row: Vec<_> = (-160..160)
            .map(|i| sphere([2.0_f64.powi(i), 0.0, 0.0], 1e-50))
            .collect();
        let nodes = links(&scene_of(&row));
        let mut depths = vec![0; nodes.len()];
        for (node, &(first, count, is_leaf)) in nodes.iter().enumerate() {
            for child in (first..first + count).filter(|_| !is_leaf) {
                depths[child as usize] = depths[node] + 1;
            }
        }
        let deepest = depths.into_iter().max();
        assert!((65..=72).contains(&deepest.unwrap()), "{deepest:?}");
    }
}
