//! Programs whose lines are put in order, with lines of their mistakes.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A program of the course.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum ProgramName {
    /// `HIER_traverse` of the slides.
    HierTraverse,
    /// The walk through a grid.
    GridWalk,
}

/// A line that belongs to the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProgramLine {
    pub(super) text: &'static str,
    /// The lines that must come before it, by their places: it uses what they compute, or stands in them.
    pub(super) after: &'static [usize],
    pub(super) reason: &'static str,
}

/// A line of a mistake.
#[derive(Clone, Copy, Debug)]
pub(super) struct WrongLine {
    pub(super) text: &'static str,
    pub(super) mistake: &'static str,
    pub(super) reason: &'static str,
}

const fn line(text: &'static str, after: &'static [usize], reason: &'static str) -> ProgramLine {
    ProgramLine {
        text,
        after,
        reason,
    }
}

const fn wrong(text: &'static str, mistake: &'static str, reason: &'static str) -> WrongLine {
    WrongLine {
        text,
        mistake,
        reason,
    }
}

impl ProgramName {
    /// Its lines, in an order that is right.
    pub(super) fn lines(self) -> &'static [ProgramLine] {
        match self {
            Self::HierTraverse => HIER_TRAVERSE,
            Self::GridWalk => GRID_WALK,
        }
    }

    /// Lines that are no part of it.
    pub(super) fn wrong(self) -> &'static [WrongLine] {
        match self {
            Self::HierTraverse => NOT_HIER_TRAVERSE,
            Self::GridWalk => NOT_GRID_WALK,
        }
    }
}

const HIER_TRAVERSE: &[ProgramLine] = &[
    line(
        "if (r intersects the bounding volume of n)",
        &[],
        "The volume is tested first: if the ray misses it, nothing in the node is tested.",
    ),
    line(
        "  if (n is a leaf)",
        &[0],
        "Only a node whose volume is hit is looked into.",
    ),
    line(
        "    intersect r with the object of n, and keep the nearer hit",
        &[1],
        "A leaf holds an object, and its own test decides.",
    ),
    line("  else", &[2], "The other case of the same question."),
    line(
        "    for (each child c of n)",
        &[3],
        "The ray may hit the volumes of both children.",
    ),
    line(
        "      HIER_traverse(r, c)",
        &[4],
        "Each child is a node, and the same function traverses it.",
    ),
];

const NOT_HIER_TRAVERSE: &[WrongLine] = &[
    wrong(
        "    for (the first child c of n)",
        "one child only",
        "The nearest hit may be in the other child.",
    ),
    wrong(
        "    intersect r with the object of n, and end the search if it is hit",
        "stops at the first leaf",
        "A leaf that is visited later may hold a nearer hit.",
    ),
    wrong(
        "    take t of the bounding volume as the hit of the object",
        "t of the box taken as the hit",
        "A volume that is hit says that its object may be hit, and not where.",
    ),
];

const GRID_WALK: &[ProgramLine] = &[
    line(
        "cell ← the cell where r enters the grid; next ← t of the next plane of each axis",
        &[],
        "The walk needs a first cell and the first plane of each axis.",
    ),
    line(
        "while (cell is in the grid)",
        &[0],
        "Without this line the walk never ends for a ray that hits nothing.",
    ),
    line(
        "  intersect r with each object on the list of cell, and keep the nearest hit",
        &[1],
        "All objects on the list are tested, because a later one may be nearer.",
    ),
    line(
        "  axis ← the axis with the smallest next",
        &[1],
        "The ray leaves the cell through the plane that it reaches first.",
    ),
    line(
        "  if (t of the nearest hit ≤ next[axis]) return the nearest hit",
        &[2, 3],
        "Only a hit inside this cell is final. A hit beyond it may have a nearer one before it.",
    ),
    line(
        "  cell[axis] ← cell[axis] + step[axis], where step is +1 or −1 as r runs up or down",
        &[2, 3],
        "One step along one axis leads to the neighbour that the ray enters.",
    ),
    line(
        "  next[axis] ← next[axis] + delta[axis]",
        &[4],
        "The planes of an axis lie at equal distances in t.",
    ),
    line(
        "return the nearest hit, if there is one",
        &[4, 5, 6],
        "The walk has left the grid.",
    ),
];

const NOT_GRID_WALK: &[WrongLine] = &[
    wrong(
        "  axis ← the axis with the largest next",
        "steps the largest t",
        "The ray passes the plane with the smallest t first.",
    ),
    wrong(
        "  if (an object was hit) return the nearest hit",
        "stops at the first cell with a hit",
        "The hit may lie beyond this cell, with a nearer one in a cell before it.",
    ),
    wrong(
        "  cell[axis] ← cell[axis] + 1",
        "next plane always +1",
        "A ray that runs down enters the neighbour with the smaller index.",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mistake::mistake;

    #[test]
    fn a_line_comes_after_lines_before_it_and_wrong_lines_have_mistakes() {
        for name in [ProgramName::HierTraverse, ProgramName::GridWalk] {
            for (place, line) in name.lines().iter().enumerate() {
                assert!(line.after.iter().all(|of| *of < place), "{}", line.text);
            }
            for line in name.wrong() {
                assert!(mistake(line.mistake).is_some(), "{}", line.mistake);
                assert!(name.lines().iter().all(|of| of.text != line.text));
            }
        }
    }
}
