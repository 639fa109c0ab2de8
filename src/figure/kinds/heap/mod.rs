//! The heap of waiting nodes over time: what is popped, what is pushed, and where the search ends.
//!
//! One row for each node that is popped: beside it the objects that are tested, the nearest hit, and the heap as it is
//! then, the nearest node first.

mod table;
mod turn;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::heap::table::Table;
use crate::figure::kinds::heap::turn::{Turn, turns};
use crate::figure::parts::bound;
use crate::figure::parts::scenery;
use crate::figure::parts::tree::Tree;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::stage::{StageId, parts};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 360.0,
    usual: &[Layer::Legend],
    more: &[],
};

/// With the first push a dozen.
const MOST_STAGES: usize = 11;

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let turns = turns(&ray.events);
    if turns.is_empty() {
        return Err(FigureError::new(
            "strategy",
            "no node was put into a heap on this ray",
            "add \"strategy\": \"heap\", and name a ray that hits the scene's bound",
        ));
    }
    let tree = Tree::of(&bound::hierarchy(figure.first)?);
    let sentences = sentences(figure, &turns, &tree);
    let stages = stages(sheet, &turns, &sentences);
    let body = if figure.shows(Layer::Legend) {
        table::legend(sheet, body, &turns, &stages)
    } else {
        body
    };
    let nearest = ray.node.end.and_then(|end| end.object);
    Table::new(figure, sheet, body, &turns).draw(figure, sheet, &turns, &stages, nearest);
    Ok(sentences.join(" "))
}

/// The stage of each turn.
fn stages(sheet: &mut Sheet, turns: &[Turn], sentences: &[String]) -> Vec<StageId> {
    let mut stages = Vec::new();
    // the first one has no pop yet
    let (first, pops) = turns.split_at(turns.len().min(1));
    for (place, turns) in [(0, first), (1, pops)] {
        for part in parts(turns.len(), MOST_STAGES) {
            let last = turns[part.clone()].iter().map(|turn| turn.last).max();
            let told = &sentences[place + part.start..place + part.end];
            let sentence = match told {
                [one] => one.clone(),
                several => format!(
                    "{} more nodes are popped: {}",
                    several.len(),
                    several.join(" ")
                ),
            };
            let stage = sheet.stage(Part::Heap, last, sentence);
            stages.extend(part.map(|_| stage));
        }
    }
    stages
}

/// What happens at each turn.
fn sentences(figure: &Figure, turns: &[Turn], tree: &Tree) -> Vec<String> {
    let mut sentences = Vec::new();
    let mut before: Option<u32> = None;
    for (pop, turn) in turns.iter().enumerate() {
        let Some(taken) = turn.taken else {
            let pushed = turn.waiting.iter().map(|entry| {
                let (node, key) = (entry.node, brief(entry.key));
                format!("The ray enters the volume of node {node} at t = {key}: the node is pushed with this key.")
            });
            sentences.push(pushed.collect::<Vec<_>>().join(" "));
            continue;
        };
        let (node, key) = (taken.node, brief(taken.key));
        if turn.is_stop() {
            let t = turn.nearest.map_or(String::new(), |(_, t, _)| brief(t));
            let left = match turn.waiting.len() {
                0 => String::new(),
                1 => "; 1 more node is never popped".into(),
                count => format!("; {count} more nodes are never popped"),
            };
            sentences.push(format!(
                "The nearest node is {node} with key {key}, behind the nearest hit at t = {t}: the search ends{left}."
            ));
            continue;
        }
        let of = tree.nodes.get(node as usize);
        let is_jump = before.is_some() && of.is_some_and(|of| of.parent != before);
        let is_leaf = of.is_some_and(|of| of.children.is_empty());
        before = Some(node);
        let jump = if is_jump {
            ", in another part of the tree,"
        } else {
            ""
        };
        let kind = if is_leaf { "leaf" } else { "node" };
        let tested = turn.tested.iter().map(|(id, _, is_hit)| {
            let name = scenery::name_of(figure.scene, *id);
            match (is_hit, turn.nearest) {
                (true, Some((nearest, t, _))) if nearest == *id => {
                    format!("{name} is hit at t = {}", brief(t))
                }
                (true, _) => format!("{name} is hit"),
                (false, _) => format!("{name} is missed"),
            }
        });
        let tested: Vec<String> = tested.collect();
        let pushed = turn.waiting.iter().filter(|entry| turn.is_new(entry));
        let pushed: Vec<String> = pushed.map(|entry| entry.node.to_string()).collect();
        let so = match (is_leaf, pushed.as_slice()) {
            (true, _) => tested.join(", "),
            (false, []) => "no child is pushed".into(),
            (false, [one]) => format!("its child {one} is pushed"),
            (false, all) => format!("its children {} are pushed", all.join(" and ")),
        };
        sentences.push(format!(
            "Pop {pop} takes {kind} {node}{jump} with key {key}: {so}."
        ));
    }
    sentences
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use serde_json::json;

    use super::*;
    use crate::figure::read_back::{ReadBack, ball};
    use crate::trace::{Event, QueueAction, QueueStep, Record};

    fn record(step: u32, action: QueueAction, node: u32, key: f64) -> Record {
        let size = 0;
        Record {
            pixel: Some([0, 0]),
            path: None,
            step,
            ray: Some(0),
            parent: None,
            event: Event::Queue(QueueStep {
                action,
                node,
                key,
                size,
            }),
        }
    }

    #[test]
    fn the_heap_is_followed_from_turn_to_turn() {
        use QueueAction::{Pop, Push, Stop};
        let records = [
            record(3, Push, 0, 1.0),
            record(4, Pop, 0, 1.0),
            record(6, Push, 1, 5.0),
            record(8, Push, 2, 2.0),
            record(9, Pop, 2, 2.0),
            record(10, Stop, 1, 5.0),
        ];
        let turns = turns(&records.iter().collect::<Vec<_>>());
        let waiting: Vec<Vec<u32>> = turns
            .iter()
            .map(|turn| turn.waiting.iter().map(|entry| entry.node).collect())
            .collect();
        assert_eq!(waiting, [vec![0], vec![2, 1], vec![1], vec![]]);
        assert!(turns[1].waiting.iter().all(|entry| turns[1].is_new(entry)));
        assert!(!turns[2].is_new(&turns[2].waiting[0]));
        assert!(turns[3].is_stop());
        let last: Vec<u32> = turns.iter().map(|turn| turn.last).collect();
        assert_eq!(last, [3, 8, 9, 10]);
    }

    #[test]
    fn the_nodes_that_wait_stand_in_the_order_of_their_keys() {
        let objects = json!([
            ball("A", [0.0; 3], 1.0),
            ball("B", [6.0, 0.0, 0.0], 1.0),
            ball("C", [-5.0, 1.2, 0.0], 1.3),
            ball("D", [3.0, 1.1, 0.0], 1.0)
        ]);
        let (drawn, traced) =
            ReadBack::of_ray_along_x(&objects, json!({ "kind": "heap", "strategy": "heap" }));
        let mut keys: Vec<f64> = Vec::new();
        for record in &traced[0].records {
            if let (Some(0), Event::Queue(step)) = (record.ray, &record.event)
                && step.action == QueueAction::Push
            {
                keys.push(step.key);
            }
        }
        let texts = drawn.placed_texts();
        let entries = texts.iter().filter_map(|(text, at)| {
            let (node, key) = text.split_once(": ")?;
            let _: u32 = node.parse().ok()?;
            Some((*at, key.parse::<f64>().ok()?))
        });
        let mut entries: Vec<(DVec2, f64)> = entries.collect();
        // by rows, each from the left; what is popped stands at the left of the heap
        entries.sort_by(|(a, _), (b, _)| a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x)));
        let popped = entries
            .iter()
            .map(|(at, _)| at.x)
            .fold(f64::INFINITY, f64::min);
        let heap: Vec<_> = entries
            .into_iter()
            .filter(|(at, _)| popped < at.x)
            .collect();
        let rows = heap.chunk_by(|(a, _), (b, _)| a.y == b.y);
        assert!(rows.clone().any(|row| 2 <= row.len()), "{heap:?}");
        for row in rows {
            assert!(row.is_sorted_by(|(_, a), (_, b)| a <= b), "{row:?}");
            for (_, key) in row {
                assert!(
                    keys.iter().any(|of| (of - key).abs() < 0.01),
                    "{key} of {keys:?}"
                );
            }
        }
    }
}
