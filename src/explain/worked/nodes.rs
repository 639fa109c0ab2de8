//! Nodes of a hierarchy, the heap in which they wait, and how the hierarchy was built.

use crate::explain::number::Digits;
use crate::explain::number::count;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::leaves::Leaves;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::structure::MergeStep;
use crate::trace::{BoundVerdict, Bounded, Event, NodeVerdict, NodeVisit, QueueAction, QueueStep};

/// The verdict on a node. One that was rejected a line before needs no second line.
pub(super) fn node(context: &Context, visit: &NodeVisit, course: &Course, page: &mut Pen) {
    let told = course.last.filter(|last| context.shows(last.kind()));
    if refused_node(told.as_ref()) == Some(visit.node) {
        return;
    }
    let d = Digits::USUAL;
    let below = if visit.children == 0 {
        format!("a leaf with {}", count(visit.objects as usize, "object"))
    } else {
        format!("with {}", count(visit.children as usize, "child node"))
    };
    let node = format!(" {}, depth {}, {below}", visit.node, visit.depth);
    let near = visit.near.map_or(String::new(), |near| d.number(near));
    let (tone, verdict) = match visit.verdict {
        NodeVerdict::Entered => (Tone::Found, "entered".into()),
        NodeVerdict::Rejected => (Tone::Refused, "rejected".into()),
        NodeVerdict::Pruned => {
            let why = format!("pruned, it begins at t = {near}, behind the nearest hit so far");
            (Tone::Refused, why)
        }
    };
    page.headed_line(tone, Part::Node, format!("{node}: {verdict}"));
}

/// A node goes into the heap or comes out of it.
pub(super) fn queue(step: &QueueStep, course: &Course, page: &mut Pen) {
    let d = Digits::USUAL;
    // a bound that the ray starts in is entered before any t counts
    let starts = course
        .start
        .is_some_and(|start| start.range.min == step.key);
    let inside = if starts {
        " (the ray starts in it)"
    } else {
        ""
    };
    let (node, key) = (step.node, d.number(step.key));
    let waiting = match step.size {
        0 => "none waits".into(),
        1 => "1 node waits".into(),
        size => format!("{size} nodes wait"),
    };
    let text = match step.action {
        QueueAction::Push => {
            format!(": node {node} goes in with key {key}{inside}; {waiting}")
        }
        QueueAction::Pop => format!(": node {node} is the nearest, key {key}; {waiting}"),
        QueueAction::Stop => {
            let left = match step.size {
                0 => String::new(),
                1 => "; 1 other node is not visited".into(),
                size => format!("; {size} other nodes are not visited"),
            };
            format!(
                ": node {node} is the nearest, key {key}, behind the nearest hit: the search ends{left}"
            )
        }
    };
    page.headed_line(Tone::Aside, Part::Heap, text);
}

/// D_min and D_max of two volumes together.
pub(super) fn merge(context: &Context, step: &MergeStep, leaves: &Leaves, page: &mut Pen) {
    let d = Digits::USUAL;
    let ([a_min, b_min], [a_max, b_max]) = (step.d_min, step.d_max);
    let (d_min, d_max) = step.joined();
    page.plain(format!(
        "node {} from {} and {}, slab {}: D_min = min({}, {}) = {}, D_max = max({}, {}) = {}",
        step.node,
        leaves.name(step.first, context),
        leaves.name(step.second, context),
        step.slab,
        d.number(a_min),
        d.number(b_min),
        d.number(d_min),
        d.number(a_max),
        d.number(b_max),
        d.number(d_max)
    ));
}

/// The node that this step rejects, if it rejects one.
pub(super) fn refused_node(step: Option<&Event>) -> Option<u32> {
    match step {
        Some(Event::BoundTest(test)) if test.verdict != BoundVerdict::Hit => match test.of {
            Bounded::Node(node) => Some(node),
            Bounded::Object(_) => None,
        },
        Some(Event::Queue(step)) if step.action == QueueAction::Stop => Some(step.node),
        _ => None,
    }
}
