//! The nodes that wait: which one is next, and is it entered or pruned?

use crate::step::quantity::{Quantity, Value};
use crate::step::question::at::{At, alike, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::trace::{NodeVerdict, NodeVisit, QueueStep};

/// The most nodes that a question names.
const MOST_NODES: usize = 6;

/// Which node leaves the heap.
pub(super) fn next_node(at: &At, popped: &QueueStep) -> Option<Question> {
    let Value::Nodes(waiting) = &at.ray()?.quantities.get(&Quantity::Waiting)?.value else {
        return None;
    };
    let key = number(popped.key);
    let is_clear = waiting
        .iter()
        .all(|&(node, near)| node == popped.node || !alike(near, popped.key));
    if !is_clear || MOST_NODES < waiting.len() || waiting.len() < 2 {
        return None;
    }
    // by their numbers: the state has them sorted by t
    let mut waiting = waiting.clone();
    waiting.sort_by_key(|&(node, _)| node);
    let largest = waiting
        .iter()
        .max_by(|one, other| one.1.total_cmp(&other.1))?
        .0;
    let newest = waiting.last()?.0;
    let first = waiting.first()?.0;
    let text_of = |node: u32| format!("node {node}");
    let right = Choice::new(
        text_of(popped.node),
        format!("Its estimated distance {key} is the smallest."),
    );
    let mut wrong = Vec::new();
    for (node, habit) in [
        (
            newest,
            "A stack would take the newest node, as the depth-first traversal does.",
        ),
        (first, "A queue would take the oldest node."),
        (largest, "This one begins furthest away."),
    ] {
        let near = waiting.iter().find(|&&(known, _)| known == node)?.1;
        wrong.push(Choice::new(
            text_of(node),
            format!(
                "{habit} It begins at t = {}, and node {} at {key}.",
                number(near),
                popped.node
            ),
        ));
    }
    for &(node, near) in &waiting {
        wrong.push(Choice::new(
            text_of(node),
            format!(
                "It begins at t = {}, and node {} at {key}.",
                number(near),
                popped.node
            ),
        ));
    }
    let nodes: Vec<String> = waiting
        .iter()
        .map(|&(node, near)| format!("node {node} at t = {}", number(near)))
        .collect();
    let text = format!(
        "In the heap are {}. Which node leaves it next?",
        nodes.join(", ")
    );
    Question::new(Asks::NextNode, text, at.step(), right, wrong)
}

/// Is the node entered, or does it begin beyond the nearest hit?
pub(super) fn pruned(at: &At, visit: &NodeVisit) -> Option<Question> {
    let near = visit.near?;
    let (object, t) = at.nearest()?;
    if alike(near, t) || visit.verdict == NodeVerdict::Rejected {
        return None;
    }
    let is_pruned = visit.verdict == NodeVerdict::Pruned;
    if is_pruned != (t < near) {
        return None;
    }
    let [near, t] = [near, t].map(number);
    let entered = Choice::new(
        "it is entered: it may hold a nearer hit",
        if is_pruned {
            format!("Whatever it holds has t ≥ {near}, and the nearest hit has t = {t}.")
        } else {
            format!("It begins at t = {near}, before the nearest hit at t = {t}.")
        },
    );
    let left_out = Choice::new(
        "it is pruned: nothing in it can be nearer",
        if is_pruned {
            format!("It begins at t = {near}, beyond the nearest hit at t = {t}.")
        } else {
            format!("It begins at t = {near}, and the nearest hit comes later, at t = {t}.")
        },
    );
    let done = Choice::new(
        "it is pruned: a hit is found, so the search may end",
        format!(
            "The first hit is not always the nearest: what counts is where the node begins, t = {near}, and t = {t} of the hit."
        ),
    );
    let done = match crate::mistake::mistake("stops at the first leaf") {
        Some(mistake) => done.by(mistake),
        None => done,
    };
    let (right, wrong) = if is_pruned {
        (left_out, entered)
    } else {
        (entered, left_out)
    };
    let text = format!(
        "Node {} begins at t = {near}; the nearest hit so far is {} at t = {t}. What becomes of the node?",
        visit.node,
        at.name(object)
    );
    Question::new(Asks::Pruned, text, at.step(), right, [done, wrong])
}
