//! The heap as a table: a row for each pop, with arrows from the top of the heap to what is popped next.

use glam::DVec2;

use crate::figure::kinds::heap::turn::{Entry, Turn, entry_text};
use crate::figure::parts::scenery;
use crate::figure::parts::visits::Verdict;
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::scene::PrimitiveId;

/// Waits, and has waited before.
const WAITS: Look = Look::THIN.wide(1.25);
/// Has just gone in.
const NEW: Look = Look::VISITED;
/// Is never taken out.
const LEFT: Look = Look::CULLED.wide(1.75);

/// What the looks of nodes mean, each from the stage on in which it is seen first.
pub(super) fn legend(sheet: &mut Sheet, body: Frame, turns: &[Turn], stages: &[StageId]) -> Frame {
    let waits = |turn: &Turn| !turn.is_stop() && turn.waiting.iter().any(|of| !turn.is_new(of));
    let left = |turn: &Turn| turn.is_stop() && !turn.waiting.is_empty();
    let first = |is_it: &dyn Fn(&Turn) -> bool| {
        let place = turns.iter().position(is_it)?;
        stages.get(place).copied()
    };
    let all = [
        (first(&|turn| turn.taken.is_none()), NEW, "pushed"),
        (first(&waits), WAITS, "waits"),
        (
            first(&Turn::is_stop),
            Verdict::Pruned.look(),
            "behind the hit",
        ),
        (first(&left), LEFT, "never popped"),
    ];
    let there: Vec<_> = all
        .into_iter()
        .filter(|(stage, ..)| stage.is_some())
        .collect();
    sheet.staged_legend(body, &there)
}

/// Where columns and rows are.
pub(super) struct Table {
    frame: Frame,
    row: f64,
    /// How many rows have room.
    rows: usize,
    cell: DVec2,
    gap: f64,
    /// The left ends of the columns: the number of the pop, what is popped, what is tested, the nearest hit, the heap.
    columns: [f64; 5],
    /// How many nodes beside each other have room.
    waiting: usize,
}

impl Table {
    const HEADS: [&str; 5] = [
        "pop",
        "popped",
        "tested",
        "nearest",
        "heap: node and its key, nearest first",
    ];

    pub(super) fn new(figure: &Figure, sheet: &Sheet, frame: Frame, turns: &[Turn]) -> Self {
        /// Rows are so far apart at least and at most, in sizes of letters.
        const ROW: [f64; 2] = [1.75, 2.3];
        let gap = match sheet.width {
            Width::Book => 0.6,
            Width::Slide => 0.35,
        } * sheet.letters;
        let needed = turns.len() as f64 + 1.0;
        let fitting = frame.size().y / needed;
        let row = fitting.clamp(ROW[0] * sheet.letters, ROW[1] * sheet.letters);
        let rows = ((frame.size().y / row).floor() as usize).saturating_sub(1);
        // no less than a number of two digits and a distance of three
        let entries = turns.iter().flat_map(|turn| {
            let taken = turn.taken.map(|of| {
                entry_text(&Entry {
                    node: of.node,
                    key: of.key,
                    step: 0,
                })
            });
            taken.into_iter().chain(turn.waiting.iter().map(entry_text))
        });
        let widest = entries.map(|text| sheet.width_of(text));
        let cell = widest.fold(sheet.width_of("00: 0.00"), f64::max) + 0.6 * sheet.letters;
        let [pop, popped, tested, nearest, _] = Self::HEADS.map(|head| sheet.width_of(head));
        let boxes = |turn: &Turn| {
            let names = turn.tested.iter().map(|(id, _, _)| {
                let name = scenery::name_of(figure.scene, *id);
                sheet.width_of(name) + 1.3 * sheet.letters
            });
            names.sum::<f64>()
        };
        let tested = turns.iter().map(boxes).fold(tested, f64::max);
        let compared = turns.iter().map(|turn| sheet.width_of(comparison(turn)));
        let nearest = compared.fold(nearest, f64::max);
        let mut left = frame.min.x;
        let columns = [0.0, pop, popped.max(cell), tested, nearest].map(|width| {
            left += if width == 0.0 { 0.0 } else { width + 1.6 * gap };
            left
        });
        let room = frame.max.x - columns[4];
        let waiting = ((room + gap) / (cell + gap)).floor() as usize;
        Self {
            frame,
            row,
            rows,
            cell: DVec2::new(cell, (row - 0.6 * sheet.letters).min(1.55 * sheet.letters)),
            gap,
            columns,
            waiting: waiting.max(1),
        }
    }

    /// The middle of a row, below that of the heads.
    fn row(&self, row: usize) -> f64 {
        self.frame.min.y + (row as f64 + 1.5) * self.row
    }

    /// The cell of a node in the heap.
    fn entry(&self, row: usize, place: usize) -> Frame {
        let left = self.columns[4] + place as f64 * (self.cell.x + self.gap);
        self.cell_at(left, row)
    }

    fn cell_at(&self, left: f64, row: usize) -> Frame {
        let min = DVec2::new(left, self.row(row) - 0.5 * self.cell.y);
        Frame {
            min,
            max: min + self.cell,
        }
    }

    pub(super) fn draw(
        &self,
        figure: &Figure,
        sheet: &mut Sheet,
        turns: &[Turn],
        stages: &[StageId],
        nearest: Option<PrimitiveId>,
    ) {
        let y = self.frame.min.y + 0.5 * self.row;
        for (head, left) in Self::HEADS.into_iter().zip(self.columns) {
            sheet.text(Anchor::Start, DVec2::new(left, y), head);
        }
        let below = y + 0.5 * self.row;
        let ends = [self.frame.min.x, self.frame.max.x].map(|x| DVec2::new(x, below));
        sheet.line(Look::THIN, ends[0], ends[1]);
        let shown = if self.rows < turns.len() {
            self.rows.saturating_sub(1).max(1)
        } else {
            turns.len()
        };
        for (row, turn) in turns[..shown].iter().enumerate() {
            sheet.at(stages[row], |sheet| self.turn(sheet, row, turn));
            self.tests(figure, sheet, row, turn);
        }
        if shown < turns.len() {
            let at = DVec2::new(self.columns[0], self.row(shown));
            sheet.at(stages[shown], |sheet| sheet.text(Anchor::Start, at, "…"));
        }
        // which hit is the nearest is known at the end
        let found = turns
            .iter()
            .enumerate()
            .take(shown)
            .find_map(|(row, turn)| {
                let place = turn
                    .tested
                    .iter()
                    .position(|(id, _, is_hit)| *is_hit && Some(*id) == nearest)?;
                Some((row, place, turn))
            });
        if let (Some((row, place, turn)), Some(last)) = (found, stages.last()) {
            let frames = self.frames(figure, sheet, row, turn);
            sheet.at(*last, |sheet| {
                sheet.rectangle(Look::PAPER_LINE, frames[place].1);
                sheet.rectangle(Look::ANSWER.outline(), frames[place].1);
            });
        }
    }

    fn turn(&self, sheet: &mut Sheet, row: usize, turn: &Turn) {
        let y = self.row(row);
        if let Some(taken) = turn.taken {
            sheet.event(turn.step, |sheet| {
                sheet.text(
                    Anchor::Start,
                    DVec2::new(self.columns[0], y),
                    row.to_string(),
                );
                let verdict = if turn.is_stop() {
                    Verdict::Pruned
                } else {
                    Verdict::Entered
                };
                let cell = self.cell_at(self.columns[1], row);
                sheet.rectangle(verdict.look(), cell);
                let (node, key) = (taken.node, taken.key);
                let text = entry_text(&Entry { node, key, step: 0 });
                sheet.text(Anchor::Middle, cell.middle(), text);
                // from the first node of the heap a row before
                let top = self.entry(row - 1, 0);
                let from = DVec2::new(top.middle().x, top.max.y);
                let to = DVec2::new(cell.middle().x, cell.min.y);
                let between = 0.5 * (from.y + to.y);
                let look = Look::THIN.wide(1.25);
                let corners = [from.x, to.x].map(|x| DVec2::new(x, between));
                sheet.path(look, vec![from, corners[0], corners[1], to]);
                head(sheet, to);
            });
        }
        if let Some((_, _, step)) = turn.nearest {
            let at = DVec2::new(self.columns[3], y);
            sheet.event(step.max(turn.step), |sheet| {
                sheet.text(Anchor::Start, at, comparison(turn));
            });
        }
        for (place, entry) in turn.waiting.iter().enumerate() {
            if place + 1 == self.waiting && place + 1 < turn.waiting.len() {
                let cell = self.entry(row, place);
                let more = format!("{} more", turn.waiting.len() - place);
                sheet.event(turn.last, |sheet| {
                    sheet.text(Anchor::Middle, cell.middle(), more);
                });
                break;
            }
            let look = if turn.is_stop() {
                LEFT
            } else if turn.is_new(entry) {
                NEW
            } else {
                WAITS
            };
            // where it stands in the row is known when all of them are pushed
            sheet.event(turn.last, |sheet| {
                let cell = self.entry(row, place);
                sheet.rectangle(look, cell);
                sheet.text(Anchor::Middle, cell.middle(), entry_text(entry));
            });
        }
    }

    /// The names of the objects that were tested, each with its frame.
    fn frames(
        &self,
        figure: &Figure,
        sheet: &Sheet,
        row: usize,
        turn: &Turn,
    ) -> Vec<(String, Frame)> {
        let mut left = self.columns[2];
        let frames = turn.tested.iter().map(|(id, _, _)| {
            let name = scenery::name_of(figure.scene, *id);
            let width = sheet.width_of(&name) + sheet.letters;
            let min = DVec2::new(left, self.row(row) - 0.5 * self.cell.y);
            left += width + 0.3 * sheet.letters;
            let max = min + DVec2::new(width, self.cell.y);
            (name, Frame { min, max })
        });
        frames.collect()
    }

    /// The objects of a leaf that were tested: those that were hit in a solid frame.
    fn tests(&self, figure: &Figure, sheet: &mut Sheet, row: usize, turn: &Turn) {
        let frames = self.frames(figure, sheet, row, turn);
        for ((name, frame), (_, step, is_hit)) in frames.into_iter().zip(&turn.tested) {
            let look = if *is_hit { Look::MET } else { Look::REJECTED };
            sheet.event(*step, |sheet| {
                sheet.rectangle(look.outline(), frame);
                sheet.text(Anchor::Middle, frame.middle(), name);
            });
        }
    }
}

/// The head of an arrow that points down.
fn head(sheet: &mut Sheet, tip: DVec2) {
    let (length, half) = (7.0 * sheet.unit(), 3.0 * sheet.unit());
    let base = tip - DVec2::new(0.0, length);
    let across = DVec2::new(half, 0.0);
    sheet.polygon(
        Look::THIN.inside().full(),
        vec![tip, base + across, base - across],
    );
}

/// The nearest hit so far, and at the end why the search goes no further.
fn comparison(turn: &Turn) -> Text {
    match (turn.nearest, turn.taken) {
        (Some((_, t, _)), Some(taken)) if turn.is_stop() => {
            Text::from(format!("{} < {}", brief(t), brief(taken.key)))
        }
        (Some((_, t, _)), _) => formula("t = ") + brief(t),
        (None, _) => Text::default(),
    }
}
