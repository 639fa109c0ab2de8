//! Built from the top down by the surface-area heuristic, for speed.
//!
//! A ray that meets a node meets a child in proportion to the areas of their boxes (J. Goldsmith and
//! J. Salmon 1987). Cutting a node with area A into halves with areas A₁, A₂ and n₁, n₂ objects costs about
//!
//! C_node + C_object·(A₁·n₁ + A₂·n₂)/A,   and not cutting it C_object·n.
//!
//! The cut is looked for between [`BINS`] bins along each axis (I. Wald 2007). Erratum 14: hierarchies are
//! built top-down as well.

use glam::DVec3;

use crate::scene::{PrimitiveId, Scene};
use crate::structure::build::solid::Solid;
use crate::structure::hierarchy::{Link, Topology};

/// Into how many bins the centers are sorted along an axis: more of them find hardly better cuts.
const BINS: usize = 16;
/// What a node costs in tests of objects.
const NODE_COST: f64 = 2.0;
/// The most objects in a leaf, unless nothing tells them apart.
const LARGEST_LEAF: usize = 8;
/// From this depth on a node is cut into equal halves: what is left is few objects, or hopeless.
const DEEPEST: u32 = 64;

/// An object on its way into a leaf.
#[derive(Clone, Copy)]
struct Item {
    solid: Solid,
    id: PrimitiveId,
}

/// A node that is not cut yet: its place and its objects.
struct Task {
    node: usize,
    from: usize,
    to: usize,
    depth: u32,
}

/// The hierarchy by the surface-area heuristic.
pub(in crate::structure) fn surface_area(scene: &Scene) -> Topology {
    let mut items: Vec<Item> = (0..)
        .map(PrimitiveId)
        .zip(&scene.primitives)
        .map(|(id, primitive)| Item {
            solid: Solid::of(&primitive.shape),
            id,
        })
        .collect();
    if items.is_empty() {
        return Topology::default();
    }
    let placeholder = Link::Objects { first: 0, count: 0 };
    let mut links = vec![placeholder];
    let mut tasks = vec![Task {
        node: 0,
        from: 0,
        to: items.len(),
        depth: 0,
    }];
    while let Some(Task {
        node,
        from,
        to,
        depth,
    }) = tasks.pop()
    {
        links[node] = match cut(&mut items[from..to], depth) {
            None => Link::Objects {
                first: from as u32,
                count: (to - from) as u32,
            },
            Some(left) => {
                let first = links.len();
                links.extend([placeholder; 2]);
                let depth = depth + 1;
                let middle = from + left;
                // the first half is laid out next
                for (node, from, to) in [(first + 1, middle, to), (first, from, middle)] {
                    tasks.push(Task {
                        node,
                        from,
                        to,
                        depth,
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
        links,
        order: items.into_iter().map(|item| item.id).collect(),
    }
}

/// Sorts the objects of a node into two halves and says how many the first has; `None` if it stays whole.
fn cut(items: &mut [Item], depth: u32) -> Option<usize> {
    let count = items.len();
    if count <= 1 {
        return None;
    }
    let mut around = Solid::EMPTY;
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for item in &*items {
        around = around.union(&item.solid);
        low = low.min(item.solid.doubled_center());
        high = high.max(item.solid.doubled_center());
    }
    let bins = Binning::new(low, high);
    let best = if depth < DEEPEST {
        best_cut(items, &bins)
    } else {
        None
    };
    let cost_of_leaf = count as f64 * around.half_area();
    match best {
        Some(cut) => {
            let cost = NODE_COST * around.half_area() + cut.cost;
            if count <= LARGEST_LEAF && cost_of_leaf <= cost {
                return None;
            }
            Some(partition(items, |item| bins.of(item)[cut.axis] <= cut.bin))
        }
        // all centers in one place: nothing tells the objects apart
        None if count <= LARGEST_LEAF => None,
        None => Some(count / 2),
    }
}

/// A cut behind a bin.
struct Cut {
    cost: f64,
    axis: usize,
    bin: usize,
}

/// Which bin an object belongs to, along each axis.
struct Binning {
    low: DVec3,
    /// Bins for each unit of a doubled center; 0 where all centers agree.
    scale: DVec3,
}

impl Binning {
    fn new(low: DVec3, high: DVec3) -> Self {
        let scale = (high - low).to_array().map(|side| {
            let scale = BINS as f64 / side;
            if scale.is_finite() { scale } else { 0.0 }
        });
        Self {
            low,
            scale: scale.into(),
        }
    }

    #[inline]
    fn of(&self, item: &Item) -> [usize; 3] {
        let place = (item.solid.doubled_center() - self.low) * self.scale;
        place.to_array().map(|p| (p as usize).min(BINS - 1))
    }
}

#[derive(Clone, Copy)]
struct Bin {
    solid: Solid,
    count: usize,
}

/// The cut with the least A₁·n₁ + A₂·n₂, over all axes; `None` if all centers are in one bin.
fn best_cut(items: &[Item], bins: &Binning) -> Option<Cut> {
    const EMPTY: Bin = Bin {
        solid: Solid::EMPTY,
        count: 0,
    };
    let mut filled = [[EMPTY; BINS]; 3];
    for item in items {
        for (axis, bin) in bins.of(item).into_iter().enumerate() {
            let bin = &mut filled[axis][bin];
            bin.solid = bin.solid.union(&item.solid);
            bin.count += 1;
        }
    }
    let mut best: Option<Cut> = None;
    for (axis, bins) in filled.iter().enumerate() {
        // A₂·n₂ for a cut behind each bin, from the last one down
        let mut behind = [0.0; BINS];
        let mut sum = EMPTY;
        for bin in (1..BINS).rev() {
            sum.solid = sum.solid.union(&bins[bin].solid);
            sum.count += bins[bin].count;
            behind[bin - 1] = sum.solid.half_area() * sum.count as f64;
        }
        let mut sum = EMPTY;
        for bin in 0..BINS - 1 {
            sum.solid = sum.solid.union(&bins[bin].solid);
            sum.count += bins[bin].count;
            if sum.count == 0 || sum.count == items.len() {
                continue;
            }
            let cost = sum.solid.half_area() * sum.count as f64 + behind[bin];
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Cut { cost, axis, bin });
            }
        }
    }
    best
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
