//! Two bounds and how they were joined, from the building of a hierarchy.

use glam::DVec3;

use crate::figure::error::FigureError;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::scenery;
use crate::figure::subject::Figure;
use crate::geometry::MOST_SLABS;
use crate::scene::PrimitiveId;
use crate::structure::{Hierarchy, Link, MergeStep, range};
use crate::trace::Event;

/// Two bounds and how they were joined.
pub(super) struct Joined {
    /// Slab by slab, with the step of the building.
    pub(super) steps: Vec<(u32, MergeStep)>,
    /// The slabs of both bounds, and of the one around them.
    pub(super) bounds: [Vec<Slab>; 3],
    /// What the two are called.
    pub(super) names: [String; 2],
    /// The objects in them.
    pub(super) objects: Vec<PrimitiveId>,
}

impl Joined {
    /// The first two bounds below the node that is above the object of the specification, or below the root.
    pub(super) fn find(figure: &Figure) -> Result<Self, FigureError> {
        let hierarchy = bound::hierarchy(figure.first)?;
        let node = match figure.object()? {
            None => 0,
            Some(object) => parent_of_leaf(&hierarchy, object),
        };
        let nodes = hierarchy.nodes().len();
        let known = |merge: &MergeStep| (merge.first.max(merge.second) as usize) < nodes;
        let merges = figure
            .first
            .building()
            .filter_map(|record| match record.event {
                Event::Merge(merge) if merge.node == node && known(&merge) => {
                    Some((record.step, merge))
                }
                _ => None,
            });
        let merges: Vec<(u32, MergeStep)> = merges.collect();
        let pair = merges.first().map(|(_, merge)| (merge.first, merge.second));
        let Some((first, second)) = pair else {
            return Err(FigureError::new(
                "scene",
                "no two bounds were joined while the hierarchy was built",
                "draw a scene with two or more objects",
            ));
        };
        let mut steps = merges;
        steps.retain(|(_, merge)| (merge.first, merge.second) == (first, second));
        let directions = hierarchy.set().directions();
        let slab = |merge: &MergeStep, d_min: f64, d_max: f64| {
            let normal = directions.get(merge.slab as usize);
            Slab {
                number: merge.slab,
                normal: normal.copied().unwrap_or(DVec3::X),
                d_min,
                d_max,
            }
        };
        let of = |part: usize| -> Vec<Slab> {
            let slabs = steps.iter().map(|(_, merge)| match part {
                2 => {
                    let (d_min, d_max) = merge.joined();
                    slab(merge, d_min, d_max)
                }
                _ => slab(merge, merge.d_min[part], merge.d_max[part]),
            });
            slabs.collect()
        };
        let mut objects = Vec::new();
        for child in [first, second] {
            objects_below(&hierarchy, child, &mut objects);
        }
        Ok(Self {
            bounds: [of(0), of(1), of(2)],
            names: [first, second].map(|node| name(figure, &hierarchy, node)),
            objects,
            steps,
        })
    }
}

/// The node whose child is the leaf of an object; the root if there is none.
fn parent_of_leaf(hierarchy: &Hierarchy<MOST_SLABS>, object: PrimitiveId) -> u32 {
    let nodes = hierarchy.nodes();
    let holds = |link: Link| match link {
        Link::Objects { first, count } => hierarchy.order()[range(first, count)].contains(&object),
        Link::Children { .. } => false,
    };
    let is_parent = |link: Link| match link {
        Link::Children { first, count } => nodes[range(first, count)]
            .iter()
            .any(|child| holds(child.link)),
        Link::Objects { .. } => false,
    };
    let found = (0..).zip(nodes).find(|(_, node)| is_parent(node.link));
    found.map_or(0, |(number, _)| number)
}

/// All objects at the leaves below a node.
fn objects_below(hierarchy: &Hierarchy<MOST_SLABS>, node: u32, found: &mut Vec<PrimitiveId>) {
    match hierarchy.nodes()[node as usize].link {
        Link::Objects { first, count } => found.extend(&hierarchy.order()[range(first, count)]),
        Link::Children { first, count } => {
            for child in first..first + count {
                objects_below(hierarchy, child, found);
            }
        }
    }
}

/// What a bound is called: the object in it, or its number.
fn name(figure: &Figure, hierarchy: &Hierarchy<MOST_SLABS>, node: u32) -> String {
    match hierarchy.nodes()[node as usize].link {
        Link::Objects { first, count: 1 } => {
            let object = hierarchy.order()[first as usize];
            scenery::name_of(figure.scene, object)
        }
        _ => format!("node {node}"),
    }
}
