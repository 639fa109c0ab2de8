//! Which objects are in the leaves of a hierarchy.

use crate::explain::worked::context::Context;
use crate::structure::{Hierarchy, Link, SlabSet, range};

/// A hierarchy built again from the scene: the events of its building name nodes by their numbers alone.
///
/// Which nodes there are does not depend on the slabs, so those across the axes do.
pub(super) struct Leaves(Hierarchy<3>);

impl Leaves {
    /// The leaves of the hierarchy of the log.
    pub(super) fn of(context: &Context) -> Self {
        let build = context.settings.structure.build;
        Self(Hierarchy::new(context.scene, &SlabSet::AXES, build))
    }

    /// A node as it is called in the text: `node 3`, or `leaf 5 (ball A)`.
    pub(super) fn name(&self, node: u32, context: &Context) -> String {
        /// A line names no more objects of a leaf than that; few builds put more into one.
        const NAMED: usize = 4;
        match self.0.nodes().get(node as usize).map(|node| node.link) {
            Some(Link::Objects { first, count }) => {
                let objects = &self.0.order()[range(first, count)];
                let names = objects.iter().take(NAMED).map(|&id| context.name(id));
                let mut names: Vec<String> = names.collect();
                if NAMED < objects.len() {
                    names.push(format!("{} more", objects.len() - NAMED));
                }
                format!("leaf {node} ({})", names.join(", "))
            }
            Some(Link::Children { .. }) | None => format!("node {node}"),
        }
    }
}
