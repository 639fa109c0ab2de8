//! The walk through a grid: the next plane, the mailboxes, and whether a hit is final.

use crate::explain::cell_name;
use crate::mistake::{WalkOfCells, Wrong, mistake, mistakes};
use crate::scene::PrimitiveId;
use crate::step::quantity::{Quantity, Value};
use crate::step::question::at::{At, alike, listed, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::structure::{Across, CellStep};
use crate::trace::{Event, Nearest, Purpose};

/// The most objects that a question names.
const MOST_NAMED: usize = 6;

/// Which axes.
fn axes(across: Across) -> [bool; 3] {
    let place = Across::BY_BITS.iter().position(|known| *known == across);
    let bits = place.unwrap_or_default();
    [1, 2, 4].map(|bit| bits & bit != 0)
}

fn text_of(across: Across) -> String {
    let crossed = axes(across);
    let names: Vec<String> = ["x", "y", "z"]
        .iter()
        .zip(crossed)
        .filter(|&(_, is_crossed)| is_crossed)
        .map(|(name, _)| (*name).to_owned())
        .collect();
    match names.len() {
        0 => "none: the ray never leaves the cell".into(),
        1 => format!("the one across {}", names[0]),
        _ => format!("those across {} at once", listed(&names)),
    }
}

/// Which plane is crossed next.
pub(super) fn next_plane(at: &At, step: &CellStep) -> Option<Question> {
    let crossed = axes(step.across);
    let first = step.t_out;
    // planes that are not crossed must be later to see
    let is_plain = (0..3).all(|axis| {
        let is_first = number(step.next[axis]) == number(first);
        crossed[axis] == is_first && (crossed[axis] || !alike(step.next[axis], first))
    });
    if step.across == Across::None || !is_plain {
        return None;
    }
    let reason = |across: Across| {
        let own = (0..3).find(|&axis| axes(across)[axis] && !crossed[axis]);
        match own {
            Some(axis) => format!(
                "The plane across {} comes at t = {}, and the ray leaves the cell at t = {} already.",
                ["x", "y", "z"][axis],
                number(step.next[axis]),
                number(first)
            ),
            None => format!("More than one plane is crossed at t = {}.", number(first)),
        }
    };
    let mut wrong = Vec::new();
    for mistake in mistakes() {
        let across = match mistake.wrong {
            Wrong::CellsVisited(function) => next_of_walk(at, step.cell, function),
            _ => None,
        };
        if let Some(across) = across.filter(|&across| across != step.across) {
            wrong.push(Choice::new(text_of(across), reason(across)).by(mistake));
        }
    }
    for mistake in mistakes() {
        if let Wrong::PlanesCrossed(function) = mistake.wrong {
            let across = function(step.next);
            if across != step.across {
                wrong.push(Choice::new(text_of(across), reason(across)).by(mistake));
            }
        }
    }
    for across in [Across::X, Across::Y, Across::Z] {
        if across != step.across {
            wrong.push(Choice::new(text_of(across), reason(across)));
        }
    }
    let right = Choice::new(
        text_of(step.across),
        format!("Its t is the smallest: {}.", number(first)),
    );
    let [x, y, z] = step.next.map(number);
    let text = format!(
        "From cell {} the next planes are at t = {x} across x, {y} across y, {z} across z. Which plane is crossed next?",
        cell_name(step.cell)
    );
    Question::new(Asks::NextPlane, text, at.step(), right, wrong)
}

/// Which planes another walk crosses behind a cell; `None` if it does not visit that cell, or ends there.
fn next_of_walk(at: &At, cell: [u32; 3], walk: WalkOfCells) -> Option<Across> {
    let start = at.ray()?.start?;
    let id = at.record().ray;
    let before = at.log.records[..at.event].iter().rev();
    let grid = before
        .take_while(|record| record.path == at.record().path)
        .find_map(|record| match &record.event {
            Event::GridEnter(grid) if record.ray == id => Some(grid),
            _ => None,
        })?;
    let cells = walk(&grid.around, grid.resolution, &start.ray, start.range);
    let here = cells.iter().position(|&visited| visited == cell)?;
    let next = cells.get(here + 1)?;
    let crossed = (0..3).filter(|&axis| next[axis] != cell[axis]);
    Some(Across::BY_BITS[crossed.map(|axis| 1 << axis).sum::<usize>()])
}

/// Must an object on the cell's list be tested?
pub(super) fn mailbox(at: &At, object: PrimitiveId) -> Option<Question> {
    if !at.log.settings.structure.grid.mailboxes {
        return None;
    }
    let ray = at.ray()?;
    let Value::Cell(cell, _) = ray.quantities.get(&Quantity::Cell)?.value else {
        return None;
    };
    let stamped = match ray.quantities.get(&Quantity::Mailboxes) {
        Some(held) => match &held.value {
            Value::Objects(objects) => objects.clone(),
            _ => return None,
        },
        None => Vec::new(),
    };
    if MOST_NAMED < stamped.len() {
        return None;
    }
    let name = at.name(object);
    let is_saved = stamped.contains(&object);
    let saved_text = "no: its mailbox has the number of this ray";
    let tested_text = "yes: its mailbox does not have the number of this ray";
    let (saved, tested) = (
        Choice::new(
            saved_text,
            if is_saved {
                format!("{name} was tested in an earlier cell, and the result would be the same.")
            } else {
                format!("{name} was not tested on this ray yet.")
            },
        ),
        Choice::new(
            tested_text,
            if is_saved {
                format!("{name} is among the objects that were tested on this ray.")
            } else {
                format!("{name} was not tested on this ray yet, so it must be tested now.")
            },
        ),
    );
    let again = Choice::new(
        "yes: each object on the list of a cell is tested in that cell",
        "The test is of the whole object, not of its part in the cell, so one test for a ray is enough; the mailbox decides.",
    );
    let (right, wrong) = if is_saved {
        (saved, [tested, again])
    } else {
        (tested, [saved, again])
    };
    let stamped: Vec<String> = stamped.iter().map(|&object| at.name(object)).collect();
    let text = format!(
        "{name} is on the list of cell {}. Objects whose mailbox has the number of this ray: {}. Must {name} be tested?",
        cell_name(cell),
        listed(&stamped)
    );
    Question::new(Asks::Mailbox, text, at.step(), right, wrong)
}

/// May the walk end with this hit?
pub(super) fn hit_is_final(at: &At, hit: &Nearest) -> Option<Question> {
    let ray = at.ray()?;
    // any hit ends a shadow ray
    let purpose = ray.start?.purpose;
    if matches!(purpose, Purpose::Shadow | Purpose::Connection) {
        return None;
    }
    let Value::Cell(cell, [_, t_out]) = ray.quantities.get(&Quantity::Cell)?.value else {
        return None;
    };
    if alike(hit.t, t_out) {
        return None;
    }
    let is_inside = hit.t < t_out;
    let [t, out] = [hit.t, t_out].map(number);
    let ends = Choice::new(
        "the walk ends after the list of this cell",
        if is_inside {
            format!(
                "t = {t} lies before the end of the cell at t = {out}, so no later cell has a nearer hit."
            )
        } else {
            format!(
                "t = {t} lies beyond the end of the cell at t = {out}: an object of a cell in between may be nearer."
            )
        },
    );
    let ends = match mistake("stops at the first cell with a hit").filter(|_| !is_inside) {
        Some(mistake) => ends.by(mistake),
        None => ends,
    };
    let goes_on = Choice::new(
        "the walk goes on: a later cell may have a nearer hit",
        if is_inside {
            format!("Every later cell begins at t = {out} or later, beyond the hit at t = {t}.")
        } else {
            format!(
                "t = {t} lies beyond the end of the cell at t = {out}, so the cells up to there must be looked at."
            )
        },
    );
    let goes_on = match mistake("no end test").filter(|_| is_inside) {
        Some(mistake) => goes_on.by(mistake),
        None => goes_on,
    };
    let at_once = Choice::new(
        "the search ends at once, before the rest of the list",
        "Another object on the list of this cell may be hit at a smaller t.",
    );
    let (right, wrong) = if is_inside {
        (ends, goes_on)
    } else {
        (goes_on, ends)
    };
    let text = format!(
        "{} is hit at t = {t}. It is on the list of cell {}, which the ray leaves at t = {out}. If no nearer hit is found in this cell, what follows?",
        at.name(hit.object),
        cell_name(cell)
    );
    Question::new(Asks::FinalHit, text, at.step(), right, [wrong, at_once])
}
