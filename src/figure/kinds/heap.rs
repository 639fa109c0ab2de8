//! The heap of waiting nodes over time: what is taken out, what goes in, and where the search ends.
//!
//! One column for each node that is taken out: below it the heap as it is then, the nearest node at its top.

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::bound;
use crate::figure::parts::scenery;
use crate::figure::parts::tree::Tree;
use crate::figure::parts::visits::{Verdict, tested};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::scene::PrimitiveId;
use crate::trace::{Event, QueueAction, QueueStep, Record};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 420.0,
    usual: &[Layer::Legend],
    more: &[],
};

/// A node in the heap.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    node: u32,
    /// The estimated distance.
    key: f64,
    /// When it went in.
    step: u32,
}

/// What happened from one node that was taken out to the next.
#[derive(Clone, Debug, Default, PartialEq)]
struct Turn {
    /// Taken out, or looked at last; none before the root went in.
    taken: Option<QueueStep>,
    /// When.
    step: u32,
    /// What waits afterwards, the nearest first.
    waiting: Vec<Entry>,
    /// Objects that were tested, and whether they were hit.
    tested: Vec<(PrimitiveId, u32, bool)>,
    /// The nearest hit by then.
    nearest: Option<(PrimitiveId, f64, u32)>,
}

impl Turn {
    fn is_stop(&self) -> bool {
        self.taken
            .is_some_and(|taken| taken.action == QueueAction::Stop)
    }

    /// Did it go in at this turn?
    fn is_new(&self, entry: &Entry) -> bool {
        self.step < entry.step || self.taken.is_none()
    }
}

/// The turns of a search.
fn turns(events: &[&Record]) -> Vec<Turn> {
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
                (turn.taken, turn.step) = (Some(*queue), step);
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
    }
    turns
}

/// Waits, and has waited before.
const WAITS: Look = Look::THIN.wide(1.25);
/// Has just gone in.
const NEW: Look = Look::VISITED;
/// Is never taken out.
const LEFT: Look = Look::CULLED.wide(1.75);

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
    let body = if figure.shows(Layer::Legend) {
        let mut entries = vec![(NEW, "pushed"), (WAITS, "waits")];
        if turns
            .iter()
            .any(|turn| turn.is_stop() && !turn.waiting.is_empty())
        {
            entries.push((LEFT, "never taken out"));
        }
        sheet.legend(body, &entries)
    } else {
        body
    };
    let table = Table::new(sheet, body, &turns);
    table.head(sheet);
    let shown = turns.len().min(table.columns);
    for (place, turn) in turns[..shown].iter().enumerate() {
        table.turn(figure, sheet, place, turn);
    }
    if shown < turns.len() {
        let at = DVec2::new(body.max.x, table.row(0));
        sheet.text(Anchor::End, at, "…");
    }
    let tree = Tree::of(&bound::hierarchy(figure.first)?);
    Ok(in_words(figure, &turns, &tree))
}

/// Where columns and rows are: what is taken out, what is tested, the nearest hit, and the heap below.
struct Table {
    frame: Frame,
    /// How many columns have room.
    columns: usize,
    /// Where the first column begins.
    first: f64,
    column: f64,
    row: f64,
    cell: DVec2,
}

/// The heap begins in this row.
const HEAP: usize = 3;
/// What a row is called.
const NAMES: [&str; HEAP + 1] = ["popped", "tested", "nearest t", "heap"];

impl Table {
    fn new(sheet: &Sheet, frame: Frame, turns: &[Turn]) -> Self {
        let names = NAMES.map(|name| sheet.width_of(name));
        let first = frame.min.x + names.into_iter().fold(0.0, f64::max) + 0.75 * sheet.letters;
        let room = frame.max.x - first;
        let cell = widest(sheet, turns) + 0.5 * sheet.letters;
        let least = cell + 0.35 * sheet.letters;
        let fitting = |room: f64| ((room / least).floor() as usize).max(1);
        let room = if fitting(room) < turns.len() {
            // for the dots that say so
            room - 1.5 * sheet.letters
        } else {
            room
        };
        let columns = fitting(room);
        let column = (room / turns.len().min(columns) as f64).min(1.5 * least);
        let deepest = turns
            .iter()
            .map(|turn| turn.waiting.len())
            .max()
            .unwrap_or(0);
        let rows = (HEAP + deepest) as f64;
        let row = (frame.size().y / rows).min(2.5 * sheet.line_height());
        Self {
            frame,
            columns,
            first,
            column,
            row,
            cell: DVec2::new(cell, (0.8 * row).min(1.6 * sheet.letters)),
        }
    }

    /// The middle of a row.
    fn row(&self, row: usize) -> f64 {
        self.frame.min.y + (row as f64 + 0.5) * self.row
    }

    /// The middle of a column.
    fn column(&self, column: usize) -> f64 {
        self.first + (column as f64 + 0.5) * self.column
    }

    fn cell(&self, middle: DVec2) -> Frame {
        Frame {
            min: middle - 0.5 * self.cell,
            max: middle + 0.5 * self.cell,
        }
    }

    fn head(&self, sheet: &mut Sheet) {
        for (row, name) in NAMES.into_iter().enumerate() {
            let at = DVec2::new(self.frame.min.x, self.row(row));
            sheet.text(Anchor::Start, at, name);
        }
        let y = self.row(HEAP) - 0.5 * self.row;
        let ends = [self.frame.min.x, self.frame.max.x].map(|x| DVec2::new(x, y));
        sheet.line(Look::THIN, ends[0], ends[1]);
    }

    fn turn(&self, figure: &Figure, sheet: &mut Sheet, place: usize, turn: &Turn) {
        let x = self.column(place);
        let at = |row: usize| DVec2::new(x, self.row(row));
        if let Some(taken) = turn.taken {
            sheet.step(turn.step, |sheet| {
                let verdict = if turn.is_stop() {
                    Verdict::Pruned
                } else {
                    Verdict::Entered
                };
                sheet.rectangle(verdict.look(), self.cell(at(0)));
                sheet.text(Anchor::Middle, at(0), entry_text(taken.node, taken.key));
                // from the top of the heap a column before
                let before = self.column(place) - self.column;
                let from = DVec2::new(before + 0.5 * self.cell.x, self.row(HEAP));
                let to = DVec2::new(x - 0.5 * self.cell.x, self.row(0));
                let between = 0.5 * (from.x + to.x);
                let look = Look::THIN.wide(1.25);
                let points = vec![from, DVec2::new(between, from.y), DVec2::new(between, to.y)];
                sheet.path(look, points);
                sheet.arrow(look, DVec2::new(between, to.y), to);
            });
        }
        if turn.is_stop() {
            sheet.step(turn.step, |sheet| sheet.text(Anchor::Middle, at(1), "stop"));
        }
        tests(figure, sheet, at(1), turn);
        if let Some((_, t, step)) = turn.nearest {
            sheet.step(step.max(turn.step), |sheet| {
                let mut text = quantity(t);
                let why = format!("{text} < key");
                if turn.is_stop() && sheet.width_of(&why) < self.column - 0.3 * sheet.letters {
                    text = why;
                }
                sheet.text(Anchor::Middle, at(2), text);
            });
        }
        for (row, entry) in turn.waiting.iter().enumerate() {
            let middle = at(HEAP + row);
            let look = if turn.is_stop() {
                LEFT
            } else if turn.is_new(entry) {
                NEW
            } else {
                WAITS
            };
            sheet.step(entry.step.max(turn.step), |sheet| {
                sheet.rectangle(look, self.cell(middle));
                sheet.text(Anchor::Middle, middle, entry_text(entry.node, entry.key));
            });
        }
    }
}

/// How wide the longest text of a cell is; no less than a number of two digits and a distance of four.
fn widest(sheet: &Sheet, turns: &[Turn]) -> f64 {
    let width = |node: u32, key: f64| sheet.width_of(entry_text(node, key));
    let texts = turns.iter().flat_map(|turn| {
        let taken = turn.taken.map(|taken| width(taken.node, taken.key));
        let waiting = turn.waiting.iter();
        let nearest = turn.nearest.map(|(_, t, _)| sheet.width_of(quantity(t)));
        taken
            .into_iter()
            .chain(nearest)
            .chain(waiting.map(|entry| width(entry.node, entry.key)))
    });
    texts.fold(sheet.width_of("00: 0.000"), f64::max)
}

/// The objects of a leaf that were tested: those that were hit in a solid frame.
fn tests(figure: &Figure, sheet: &mut Sheet, middle: DVec2, turn: &Turn) {
    let gap = 0.5 * sheet.letters;
    let names = turn
        .tested
        .iter()
        .map(|(id, _, _)| scenery::name_of(figure.scene, *id));
    let names: Vec<String> = names.collect();
    let widths: Vec<f64> = names
        .iter()
        .map(|name| sheet.width_of(name) + 2.0 * gap)
        .collect();
    let all: f64 = widths.iter().sum();
    let mut left = middle.x - 0.5 * all;
    for ((name, width), (_, step, is_hit)) in names.into_iter().zip(widths).zip(&turn.tested) {
        sheet.step(*step, |sheet| {
            let look = if *is_hit {
                Look::ANSWER
            } else {
                Look::REJECTED
            };
            let half = DVec2::new(0.5 * width - 0.1 * gap, 0.75 * sheet.letters);
            let at = DVec2::new(left + 0.5 * width, middle.y);
            let (min, max) = (at - half, at + half);
            sheet.rectangle(look.outline(), Frame { min, max });
            sheet.text(Anchor::Middle, at, name);
            left += width;
        });
    }
}

fn entry_text(node: u32, key: f64) -> String {
    format!("{node}: {}", quantity(key))
}

fn in_words(figure: &Figure, turns: &[Turn], tree: &Tree) -> String {
    let mut sentences = Vec::new();
    for turn in turns {
        let Some(taken) = turn.taken else {
            continue;
        };
        let (node, key) = (taken.node, quantity(taken.key));
        if turn.is_stop() {
            let t = turn.nearest.map_or(String::new(), |(_, t, _)| quantity(t));
            sentences.push(format!(
                "The nearest waiting node, {node}, has key {key}, behind the nearest hit at {t}: the search ends; \
                 {} more waited.",
                turn.waiting.len()
            ));
            continue;
        }
        let pushed = turn.waiting.iter().filter(|entry| turn.is_new(entry));
        let pushed: Vec<String> = pushed.map(|entry| entry.node.to_string()).collect();
        let tested = turn.tested.iter().map(|(id, _, is_hit)| {
            let verdict = if *is_hit { "hit" } else { "missed" };
            format!("{} is {verdict}", scenery::name_of(figure.scene, *id))
        });
        let tested: Vec<String> = tested.collect();
        let is_leaf = tree
            .nodes
            .get(node as usize)
            .is_some_and(|node| node.children.is_empty());
        sentences.push(match (is_leaf, pushed.as_slice()) {
            (true, _) => format!(
                "Leaf {node} with key {key} is taken out: {}.",
                tested.join(", ")
            ),
            (false, []) => format!("Node {node} with key {key} is taken out; put in: none."),
            (false, _) => format!(
                "Node {node} with key {key} is taken out; put in: {}.",
                pushed.join(", ")
            ),
        });
    }
    sentences.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

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
    }
}
