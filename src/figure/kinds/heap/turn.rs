//! The turns of a search that keeps its nodes in a heap, from the events.

use crate::figure::parts::visits::tested;
use crate::figure::sheet::canvas::brief;
use crate::scene::PrimitiveId;
use crate::trace::{Event, QueueAction, QueueStep, Record};

/// A node in the heap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) node: u32,
    /// The estimated distance.
    pub(super) key: f64,
    /// When it went in.
    pub(super) step: u32,
}

/// What happened from one node that was taken out to the next.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Turn {
    /// Taken out, or looked at last; none before the root went in.
    pub(super) taken: Option<QueueStep>,
    /// When.
    pub(super) step: u32,
    /// The last step before the next one.
    pub(super) last: u32,
    /// What waits afterwards, the nearest first.
    pub(super) waiting: Vec<Entry>,
    /// Objects that were tested, and whether they were hit.
    pub(super) tested: Vec<(PrimitiveId, u32, bool)>,
    /// The nearest hit by then.
    pub(super) nearest: Option<(PrimitiveId, f64, u32)>,
}

impl Turn {
    pub(super) fn is_stop(&self) -> bool {
        self.taken
            .is_some_and(|taken| taken.action == QueueAction::Stop)
    }

    /// Did it go in at this turn?
    pub(super) fn is_new(&self, entry: &Entry) -> bool {
        self.step < entry.step || self.taken.is_none()
    }
}

/// The turns of a search.
pub(super) fn turns(events: &[&Record]) -> Vec<Turn> {
    let mut turns: Vec<Turn> = Vec::new();
    for record in events {
        let step = record.step;
        match &record.event {
            Event::Queue(queue) if queue.action == QueueAction::Push => {
                if turns.is_empty() {
                    turns.push(Turn::default());
                }
                if let Some(turn) = turns.last_mut() {
                    let (node, key) = (queue.node, queue.key);
                    turn.waiting.push(Entry { node, key, step });
                    turn.waiting
                        .sort_by(|a, b| a.key.total_cmp(&b.key).then(a.node.cmp(&b.node)));
                }
            }
            Event::Queue(queue) => {
                let mut turn = turns.last().cloned().unwrap_or_default();
                turn.waiting.retain(|entry| entry.node != queue.node);
                turn.tested.clear();
                (turn.taken, turn.step, turn.last) = (Some(*queue), step, step);
                turns.push(turn);
            }
            Event::Nearest(nearest) => {
                if let Some(turn) = turns.last_mut() {
                    turn.nearest = Some((nearest.object, nearest.t, step));
                }
            }
            event => {
                if let (Some((object, is_hit)), Some(turn)) = (tested(event), turns.last_mut()) {
                    // a polygon is tested twice: its plane, and whether the point is inside
                    turn.tested.retain(|(of, _, _)| *of != object);
                    turn.tested.push((object, step, is_hit));
                }
            }
        }
        if let Some(turn) = turns.last_mut() {
            turn.last = step;
        }
    }
    turns
}

/// A node and the t at which the ray enters it.
pub(super) fn entry_text(entry: &Entry) -> String {
    format!("{}: {}", entry.node, brief(entry.key))
}
