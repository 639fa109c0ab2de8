//! Which steps of the log each line is about, once all lines are written.
//!
//! A line is written with the events that it has words for. Events without words of their own belong to the step of others:
//! one that introduces a step, as `listed` does a test, with the step after it; one that closes a step, as the end of a
//! ray whose photon says it all, with the step before.

use std::ops::Range;

use crate::explain::page::{Page, Section, StepAddress, StepRange};
use crate::explain::worked::extent::Extent;
use crate::explain::worked::pen::Draft;
use crate::trace::{Kind, Record};

/// The page of these lines. `of_page` are the places of the records that it is about; of them it shows those that
/// `is_shown` says.
pub(super) fn settle(
    drafts: Vec<Draft>,
    records: &[Record],
    of_page: Range<usize>,
    is_shown: impl Fn(usize) -> bool,
) -> Page {
    let told = apart(drafts.iter().filter_map(|draft| draft.extent));
    let mut whole = told.clone();
    let shown = |place: &usize| is_shown(*place);
    let section = |place: usize| Section::of(&records[place]);
    // between two steps, before the first and behind the last
    for next in 0..=told.len() {
        let previous = next.checked_sub(1);
        let start = previous.map_or(of_page.start, |at| told[at].last + 1);
        let end = told.get(next).map_or(of_page.end, |next| next.first);
        for place in (start..end).filter(shown) {
            let is_of = |at: &usize| section(told[*at].first) == section(place);
            let before = previous.filter(|at| section(told[*at].last) == section(place));
            let after = Some(next).filter(|&at| at < told.len()).filter(is_of);
            let at = if closes(records[place].event.kind()) {
                before.or(after)
            } else {
                after.or(before)
            };
            if let Some(at) = at {
                whole[at] = whole[at].to(Extent::at(place));
            }
        }
    }
    // an event that closes may lie behind one that introduces
    for at in 1..whole.len() {
        whole[at].first = whole[at].first.max(whole[at - 1].last + 1);
    }
    let lines = drafts.into_iter().map(|draft| {
        let at = draft
            .extent
            .map(|extent| told.partition_point(|told| told.last < extent.first));
        let steps = at.and_then(|at| whole.get(at)).map(|extent| StepRange {
            first: StepAddress::of(&records[extent.first]),
            last: StepAddress::of(&records[extent.last]),
        });
        let mut line = draft.line;
        line.steps = steps;
        line
    });
    Page {
        lines: lines.collect(),
    }
}

/// Extents in their order, those that overlap put together: of a log whose rays do not nest.
fn apart(extents: impl Iterator<Item = Extent>) -> Vec<Extent> {
    let mut extents: Vec<Extent> = extents.collect();
    extents.sort_unstable();
    let mut apart: Vec<Extent> = Vec::new();
    for extent in extents {
        match apart.last_mut() {
            Some(last) if extent.first <= last.last => *last = last.to(extent),
            _ => apart.push(extent),
        }
    }
    apart
}

/// Does an event of this kind, where it has no words of its own, belong to the step before it?
fn closes(kind: Kind) -> bool {
    matches!(kind, Kind::RayEnd | Kind::Node)
}
