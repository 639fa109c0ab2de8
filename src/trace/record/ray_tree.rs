//! The tree of rays of one pixel: which ray spawned which, and what happened on each.

use std::collections::HashMap;

use crate::trace::{Event, RayEnd, RayStart, Record};

/// The rays of one pixel, made from its records.
#[derive(Clone, Debug, Default)]
pub struct RayTree {
    /// Events and eye rays of the pixel itself, in order.
    pub items: Vec<Item>,
    /// All rays, in the order in which they first appear.
    pub rays: Vec<RayNode>,
    /// The place of each number.
    places: HashMap<u32, usize>,
}

/// One ray.
#[derive(Clone, Debug, Default)]
pub struct RayNode {
    /// Its number in the pixel.
    pub id: u32,
    /// The ray that spawned it.
    pub parent: Option<u32>,
    /// Its start; `None` if the log was filtered.
    pub start: Option<RayStart>,
    /// Its end; `None` if the log was filtered.
    pub end: Option<RayEnd>,
    /// The places of its start and its end among the records.
    pub ends_at: [Option<usize>; 2],
    /// What happened on it, in order, its start and end left out.
    pub items: Vec<Item>,
}

/// What follows in a ray or a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Item {
    /// An event, by its place among the records.
    Event(usize),
    /// A ray that was spawned here, by its place in [`RayTree::rays`].
    Ray(usize),
}

impl RayTree {
    /// The tree of a pixel's records. Of a filtered log the rays that are there.
    pub fn new(records: &[Record]) -> Self {
        let mut tree = Self::default();
        for (at, record) in records.iter().enumerate() {
            let Some(id) = record.ray else {
                tree.items.push(Item::Event(at));
                continue;
            };
            let node = tree.node(id, record.parent);
            match record.event {
                Event::Ray(start) => {
                    tree.rays[node].start = Some(start);
                    tree.rays[node].ends_at[0] = Some(at);
                }
                Event::RayEnd(end) => {
                    tree.rays[node].end = Some(end);
                    tree.rays[node].ends_at[1] = Some(at);
                }
                _ => tree.rays[node].items.push(Item::Event(at)),
            }
        }
        tree
    }

    /// The place of a ray's node; a new one is hung below its parent, or below the pixel.
    fn node(&mut self, id: u32, parent: Option<u32>) -> usize {
        if let Some(known) = self.find(id) {
            return known;
        }
        // looked up before the ray is known itself: no ray is its own parent, whatever a log says
        let above = parent.and_then(|parent| self.find(parent));
        let place = self.rays.len();
        self.places.insert(id, place);
        self.rays.push(RayNode {
            id,
            parent,
            ..RayNode::default()
        });
        match above {
            Some(above) => self.rays[above].items.push(Item::Ray(place)),
            None => self.items.push(Item::Ray(place)),
        }
        place
    }

    /// The place of the ray with a number.
    pub fn find(&self, id: u32) -> Option<usize> {
        self.places.get(&id).copied()
    }
}
