//! A connection with the rays and the alternatives that belong to it.

use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::trace::{Alternative, Connection, Event, Item, Purpose};

/// What belongs to one line: its ray, the edges of the whole path, and what came of it. In a filtered log any of the
/// three may be missing.
#[derive(Clone, Debug, Default)]
pub(super) struct Joined {
    pub(super) ray: Option<usize>,
    pub(super) alternatives: Vec<Alternative>,
    pub(super) connection: Option<Connection>,
    /// The events of the edges, and of what came of the line.
    pub(super) alternatives_at: Option<Extent>,
    pub(super) connection_at: Option<Extent>,
}

/// The line that the items begin with, and how many items belong to it.
pub(super) fn joined(context: &Context, items: &[Item]) -> Option<(Joined, usize)> {
    let mut joined = Joined::default();
    let mut taken = 0;
    for item in items {
        match *item {
            Item::Ray(place) if taken == 0 && is_connection(context, place) => {
                joined.ray = Some(place);
            }
            Item::Event(at) => match context.records[at].event {
                Event::Alternative(edge) => {
                    joined.alternatives.push(edge);
                    let before = joined.alternatives_at.into_iter();
                    joined.alternatives_at = Extent::around(before.chain([context.at(at)]));
                }
                Event::Connection(connection) => {
                    joined.connection = Some(connection);
                    joined.connection_at = Some(context.at(at));
                    return Some((joined, taken + 1));
                }
                _ => break,
            },
            Item::Ray(_) => break,
        }
        taken += 1;
    }
    (0 < taken).then_some((joined, taken))
}

fn is_connection(context: &Context, place: usize) -> bool {
    let start = context.tree.rays[place].start;
    start.is_some_and(|start| start.purpose == Purpose::Connection)
}
