//! The steps of a walk through a grid (slides, "Spatial Partitioning", last point; 3DDDA): for each cell the t at
//! which the ray hits the next plane across x, y and z; the smallest is where it leaves the cell.

use glam::DVec2;

use crate::explain::cell_name;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::plan::{self, Plan};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::{Visit, Walk, axes};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::geometry::Ray;
use crate::trace::{GridEnter, WalkEnd};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[Layer::Objects, Layer::Ray, Layer::Numbers],
    more: &[Layer::Names],
};

/// The plane that is crossed.
const CHOSEN: Look = Look::VISITED.wide(2.5);

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let walk = Walk::of(&ray, figure.scene)?;
    if walk.visits.is_empty() {
        return Err(FigureError::new(
            "pixel",
            "the ray misses the grid",
            "name a pixel whose ray visits a cell",
        ));
    }
    let rows: Vec<Row> = (0..walk.visits.len())
        .map(|place| Row::of(&walk, place))
        .collect();
    let sentences = sentences(&walk, &rows);
    let ends = match ray.node.end.and_then(|end| end.object.zip(end.t)) {
        Some((object, t)) => format!(
            "The ray hits {} at t = {}.",
            scenery::name_of(figure.scene, object),
            quantity(t)
        ),
        None => "The ray leaves the grid and hits no object.".into(),
    };
    let end = plan::stages(sheet, &ray, &walk, &sentences, ends);
    let apart = ray.node.start.map(|start| apart(&walk, &start.ray));
    let apart = apart.unwrap_or_default();
    let table = Table::new(sheet, body, &rows, apart)?;
    let left = Frame {
        min: body.min,
        max: DVec2::new(table.left - 1.5 * sheet.letters, body.max.y),
    };
    let room = Frame {
        min: left.min + DVec2::new(3.0 * sheet.letters, 0.0),
        max: left.max - DVec2::new(0.0, 1.5 * sheet.letters),
    };
    let plan = Plan::new(figure, (&ray, &walk), room)?;

    plan.planes(sheet);
    if figure.shows(Layer::Numbers) {
        plan.indices(sheet, left);
    }
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &plan.space, |_| Look::OBJECT);
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &plan.space);
    }
    for (place, visit) in walk.visits.iter().enumerate() {
        plan.cell(sheet, visit, (place + 1).to_string());
    }
    if figure.shows(Layer::Ray) {
        plan.ray(sheet, &walk);
    }
    crossings(figure, sheet, &plan, &walk);
    table.head(sheet, apart);
    for (place, row) in rows.iter().enumerate() {
        sheet.event(walk.visits[place].step, |sheet| {
            table.row(sheet, place, row);
        });
        // how it ends is said at the end
        let is_last = place + 1 == rows.len();
        let since = |sheet: &mut Sheet| table.outcome(sheet, place, row);
        if is_last {
            sheet.at(end, since);
        } else {
            sheet.event(walk.visits[place].step, since);
        }
    }
    Ok(sentences.join(" "))
}

/// Where the ray hits planes: a form for each axis, the t beside it.
fn crossings(figure: &Figure, sheet: &mut Sheet, plan: &Plan, walk: &Walk) {
    let label = |sheet: &mut Sheet, t: f64, towards: DVec2| {
        // on a slide they stand in the table alone
        if figure.shows(Layer::Numbers) && sheet.width == Width::Book {
            /// The number of letters that fit beside `t = ` in a cell.
            const ROOM: usize = 5;
            let mut text = quantity(t);
            if text.len() <= ROOM {
                text = format!("t = {text}");
            }
            sheet.label(plan.space.frame, plan.place(t), towards, formula(&text));
        }
    };
    let above = plan.above();
    if let Some(first) = walk.visits.first() {
        // the plane through which it comes in has no event of its own
        sheet.event(walk.step, |sheet| {
            if let Some(axis) = plan.entered_across(first.cell.t_in) {
                marker(sheet, axis, plan.place(first.cell.t_in));
            }
            label(sheet, first.cell.t_in, above);
        });
    }
    for (place, visit) in walk.visits.iter().enumerate() {
        if !crosses(walk, place) {
            continue;
        }
        sheet.event(visit.step, |sheet| {
            let at = plan.place(visit.cell.t_out);
            for &axis in axes(visit.cell.across) {
                marker(sheet, axis, at);
            }
            // those across x on one side of the ray, the others on the other
            let is_across_x = axes(visit.cell.across) == [0];
            label(
                sheet,
                visit.cell.t_out,
                if is_across_x { -above } else { above },
            );
        });
    }
}

/// How much t grows from one plane to the next across each axis: the size of a cell divided by that part of Δ.
fn apart(walk: &Walk, ray: &Ray) -> [f64; 3] {
    let GridEnter {
        around, resolution, ..
    } = &walk.grid;
    let size = around.size();
    [0, 1, 2].map(|axis| size[axis] / f64::from(resolution[axis]) / ray.direction[axis].abs())
}

/// Does the walk go on across a plane after this cell, or leave the grid there?
fn crosses(walk: &Walk, place: usize) -> bool {
    place + 1 < walk.visits.len() || walk.end == WalkEnd::Left
}

/// A plane across an axis: a dot for x, a triangle for y, a square for z.
fn marker(sheet: &mut Sheet, axis: usize, at: DVec2) {
    let unit = sheet.unit();
    match axis {
        0 => sheet.circle(Look::RAY.full(), at, 3.5 * unit),
        1 => {
            let corners = [[0.0, -5.5], [5.0, 3.5], [-5.0, 3.5]];
            let corners = corners.map(|corner| at + unit * DVec2::from(corner));
            sheet.polygon(Look::PAPER_LINE.full(), corners.into());
            sheet.polygon(Look::THIN.wide(1.5), corners.into());
        }
        _ => {
            let half = DVec2::splat(4.0 * unit);
            let square = Frame {
                min: at - half,
                max: at + half,
            };
            sheet.rectangle(Look::PAPER_LINE.full(), square);
            sheet.rectangle(Look::THIN.wide(1.5), square);
        }
    }
}

/// A cell in the table.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    cell: String,
    /// t of the next plane across each axis.
    next: [String; 3],
    /// Which of them are crossed.
    chosen: Vec<usize>,
    /// What follows: the next index, or the end.
    then: String,
}

impl Row {
    fn of(walk: &Walk, place: usize) -> Self {
        let visit = &walk.visits[place];
        let chosen = if crosses(walk, place) {
            axes(visit.cell.across).to_vec()
        } else {
            Vec::new()
        };
        Self {
            cell: cell_name(visit.cell.cell),
            next: visit.cell.next.map(|t| finite(t, quantity)),
            chosen,
            then: match (walk.visits.get(place + 1), walk.end) {
                (Some(next), _) => index_steps(visit, next),
                (None, WalkEnd::HitInCell) => "hit".into(),
                (None, _) => "leaves".into(),
            },
        }
    }
}

/// A t; ∞ across an axis along which the ray does not go.
fn finite(t: f64, shown: fn(f64) -> String) -> String {
    if t.is_finite() {
        shown(t)
    } else {
        "∞".into()
    }
}

/// How the indices change from one cell to the next: `i + 1`, `k − 1`.
fn index_steps(from: &Visit, to: &Visit) -> String {
    let changed = (0..3).filter_map(|axis| {
        let name = ["i", "j", "k"][axis];
        let (from, to) = (from.cell.cell[axis], to.cell.cell[axis]);
        match from.cmp(&to) {
            std::cmp::Ordering::Less => Some(format!("{name} + 1")),
            std::cmp::Ordering::Greater => Some(format!("{name} − 1")),
            std::cmp::Ordering::Equal => None,
        }
    });
    let changed: Vec<String> = changed.collect();
    changed.join(", ")
}

/// Where the columns and rows of the table are.
struct Table {
    left: f64,
    top: f64,
    em: f64,
    /// From row to row in sizes of letters.
    row: f64,
    /// Widths of the columns in sizes of letters: the cell, a t, and what follows.
    cell: f64,
    next: f64,
    then: f64,
}

/// Width of the first column in sizes of letters.
const NUMBER: f64 = 1.8;
/// From row to row, at least and at most.
const ROW: [f64; 2] = [1.5, 1.9];
/// Above the first row: three lines.
const HEAD: f64 = 5.3;

impl Table {
    /// At the right of a frame, in the middle of its height.
    fn new(sheet: &Sheet, frame: Frame, of: &[Row], apart: [f64; 3]) -> Result<Self, FigureError> {
        let em = sheet.letters;
        let rows = of.len();
        let room = frame.size().y / em - HEAD;
        let row = (room / rows as f64).min(ROW[1]);
        if row < ROW[0] {
            let most = (room / ROW[0]).floor();
            return Err(FigureError::new(
                "pixel",
                format!("the ray visits {rows} cells, and the table has room for {most}"),
                "choose another pixel, or a coarser grid with \"structure\": {\"grid\": {\"resolution\": …}}",
            ));
        }
        // as wide as the longest text; the least keeps the heads apart
        let wide = |text: &String| sheet.width_of(text) / em;
        let cells = of.iter().map(|row| wide(&row.cell) + 1.0);
        // on a slide the indices stand at the grid alone
        let cell = match sheet.width {
            Width::Book => cells.fold(5.2, f64::max),
            Width::Slide => 0.6,
        };
        let nexts = of.iter().flat_map(|row| &row.next);
        let changes = apart.map(|of| wide(&format!("+ {}", finite(of, quantity))) + 0.7);
        let next = nexts
            .map(|t| wide(t) + 0.7)
            .chain(changes)
            .fold(3.9, f64::max);
        let thens = of.iter().map(|row| wide(&row.then) + 0.8);
        let then = thens.fold(4.0, f64::max);
        Ok(Self {
            left: frame.max.x - (NUMBER + cell + 3.0 * next + then) * em,
            top: frame.middle().y - 0.5 * (HEAD + row * rows as f64) * em,
            em,
            row,
            cell,
            next,
            then,
        })
    }

    /// The middle of the column of an axis.
    fn next(&self, axis: usize) -> f64 {
        self.left + (NUMBER + self.cell + (axis as f64 + 0.5) * self.next) * self.em
    }

    fn then(&self) -> f64 {
        self.left + (NUMBER + self.cell + 3.0 * self.next + 0.8) * self.em
    }

    fn head(&self, sheet: &mut Sheet, apart: [f64; 3]) {
        let em = self.em;
        let first = self.top + 0.7 * em;
        let second = self.top + 2.3 * em;
        let third = self.top + 4.1 * em;
        let at = DVec2::new;
        sheet.text(
            Anchor::Middle,
            at(self.next(1), first),
            formula("t") + " of the next plane across",
        );
        let has_cells = sheet.width == Width::Book;
        if has_cells {
            let place = at(self.left + NUMBER * em, second);
            sheet.text(Anchor::Start, place, formula("[i, j, k]"));
        }
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let x = self.next(axis);
            marker(sheet, axis, at(x - 0.6 * em, second));
            sheet.text(Anchor::Start, at(x + 0.1 * em, second), formula(name));
            let step = finite(apart[axis], quantity);
            sheet.text(Anchor::Middle, at(x, third), format!("+ {step}"));
        }
        let left = self.left + if has_cells { NUMBER * em } else { 0.0 };
        sheet.text(Anchor::Start, at(left, third), formula("Δt"));
        sheet.text(Anchor::Start, at(self.then(), second), "then");
        let y = self.top + HEAD * em - 0.1 * em;
        let right = self.then() + (self.then - 0.8) * em;
        sheet.line(Look::THIN, at(self.left, y), at(right, y));
    }

    /// What follows from a row.
    fn outcome(&self, sheet: &mut Sheet, place: usize, row: &Row) {
        let y = self.top + (HEAD + (place as f64 + 0.5) * self.row) * self.em;
        let at = DVec2::new(self.then(), y);
        sheet.text(Anchor::Start, at, formula(&row.then));
    }

    fn row(&self, sheet: &mut Sheet, place: usize, row: &Row) {
        let em = self.em;
        let y = self.top + (HEAD + (place as f64 + 0.5) * self.row) * em;
        let at = DVec2::new;
        for &axis in &row.chosen {
            let half = DVec2::new(0.46 * self.next, 0.42 * self.row) * em;
            let middle = at(self.next(axis), y);
            let frame = Frame {
                min: middle - half,
                max: middle + half,
            };
            sheet.rectangle(CHOSEN, frame);
        }
        sheet.text(
            Anchor::End,
            at(self.left + (NUMBER - 0.6) * em, y),
            (place + 1).to_string(),
        );
        if sheet.width == Width::Book {
            sheet.text(Anchor::Start, at(self.left + NUMBER * em, y), &row.cell);
        }
        for (axis, t) in row.next.iter().enumerate() {
            sheet.text(Anchor::Middle, at(self.next(axis), y), t);
        }
    }
}

/// The steps in words.
fn sentences(walk: &Walk, rows: &[Row]) -> Vec<String> {
    let sentences = rows.iter().enumerate().map(|(place, row)| {
        let [x, y, z] = &row.next;
        let across: Vec<&str> = row.chosen.iter().map(|&axis| ["x", "y", "z"][axis]).collect();
        let t_out = quantity(walk.visits[place].cell.t_out);
        let then = match across.as_slice() {
            [] => "the traversal ends with a hit".into(),
            _ if row.then == "leaves" => format!("the ray leaves the grid at t = {t_out}"),
            _ => format!("the smallest is across {}: {}", across.join(" and "), row.then),
        };
        format!(
            "Cell {} {}: the next planes are at t = {x} across x, {y} across y, {z} across z; {then}.",
            place + 1,
            row.cell
        )
    });
    sentences.collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::figure::read_back::{DRAWN, ReadBack, ball};
    use crate::structure::{Across, CellStep};

    fn visit(cell: [u32; 3], next: [f64; 3], across: Across) -> Visit {
        Visit {
            cell: CellStep {
                cell,
                next,
                across,
                ..CellStep::default()
            },
            ..Visit::default()
        }
    }

    fn walk(end: WalkEnd) -> Walk {
        let infinite = f64::INFINITY;
        Walk {
            step: 0,
            grid: GridEnter::default(),
            visits: vec![
                visit([0, 0, 3], [5.0, infinite, 4.25], Across::Z),
                visit([0, 0, 2], [5.0, infinite, 5.0], Across::XZ),
                visit([1, 0, 1], [8.0, infinite, 9.5], Across::X),
            ],
            end,
        }
    }

    #[track_caller]
    fn check(walk: &Walk, place: usize, next: [&str; 3], chosen: &[usize], then: &str) {
        let row = Row::of(walk, place);
        assert_eq!(row.next, next);
        assert_eq!((row.chosen.as_slice(), row.then.as_str()), (chosen, then));
    }

    #[test]
    fn the_smallest_t_says_which_index_changes() {
        let walk = walk(WalkEnd::Left);
        check(&walk, 0, ["5", "∞", "4.25"], &[2], "k − 1");
        // through an edge
        check(&walk, 1, ["5", "∞", "5"], &[0, 2], "i + 1, k − 1");
        check(&walk, 2, ["8", "∞", "9.5"], &[0], "leaves");
    }

    #[test]
    fn a_walk_that_ends_with_a_hit_crosses_no_plane_after_it() {
        check(&walk(WalkEnd::HitInCell), 2, ["8", "∞", "9.5"], &[], "hit");
    }

    #[test]
    fn each_plane_that_is_crossed_has_its_mark_on_it() {
        let objects = json!([
            ball("A", [0.0; 3], 1.0),
            ball("B", [6.0, 0.0, 0.0], 1.0),
            ball("C", [-4.0, 0.0, 3.0], 1.0)
        ]);
        let spec = json!({ "kind": "steps", "strategy": "grid", "view": "top", "structure": { "grid": { "resolution": [4, 1, 1] } } });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        let planes = drawn.upright("ink");
        // it enters at the first of the five planes, x = −5, t = 5, and crosses the second one at t = 8
        let marks = drawn.dots("ink");
        for plane in &planes[..2] {
            let is_on = |at: &&DVec2| (at.x - plane).abs() < DRAWN;
            assert!(marks.iter().any(|at| is_on(&at)), "{plane}: {marks:?}");
        }
        let quarter = planes[0] + (planes[4] - planes[0]) / 4.0;
        assert!((planes[1] - quarter).abs() < DRAWN, "{planes:?}");
        let texts = drawn.texts();
        // the cells are 3 wide
        for text in ["t = 5", "t = 8", "+ 3", "+ ∞", "i = 0", "3"] {
            assert!(texts.iter().any(|of| of == text), "no {text}: {texts:?}");
        }
    }
}
