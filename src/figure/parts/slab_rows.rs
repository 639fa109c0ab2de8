//! Near and far of slabs as rows above an axis of t: the interval of each slab, and what all have in common so far.

use glam::DVec2;

use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::view::Space;
use crate::geometry::{Ray, SlabInterval};
use crate::structure::{SlabStep, SlabVerdict};

/// What all slabs so far have in common.
pub(in crate::figure) const SO_FAR: Look = Look::MET.outline().wide(3.5);
/// What is left of the ray inside all slabs.
pub(in crate::figure) const LEFT: Look = Look::ANSWER.outline().wide(4.0);
/// What one slab says.
pub(in crate::figure) const OF_SLAB: Look = Look::VISITED.wide(1.25);
/// From the smallest far to the largest near, where they have crossed.
const CROSSED: Look = Look::REJECTED.outline();

/// The axis of t below the ray, with a row for each slab.
pub(in crate::figure) struct Axis<'a> {
    pub(in crate::figure) space: &'a Space,
    pub(in crate::figure) ray: &'a Ray,
    pub(in crate::figure) frame: Frame,
    pub(in crate::figure) row: f64,
}

impl Axis<'_> {
    /// Where a t stands, and whether it lies on the axis.
    fn place(&self, t: f64) -> (f64, bool) {
        let x = self.space.place(self.ray.at(t)).x;
        let (left, right) = self.ends();
        (x.clamp(left, right), left <= x && x <= right)
    }

    fn ends(&self) -> (f64, f64) {
        (self.space.frame.min.x, self.space.frame.max.x)
    }

    /// The middle of a row.
    fn middle(&self, row: usize) -> f64 {
        self.frame.min.y + (row as f64 + 0.5) * self.row
    }

    /// The middle of the bar in a row, and of the line below it.
    fn bar_and_line(&self, sheet: &Sheet, row: usize) -> [f64; 2] {
        let middle = self.middle(row);
        [-0.1, 0.4].map(|down| middle + down * sheet.line_height())
    }

    /// The row of a slab that was tested: its own interval, and below what all have in common so far.
    pub(in crate::figure) fn slab(
        &self,
        sheet: &mut Sheet,
        row: usize,
        (name, title): (Text, Text),
        step: &SlabStep,
    ) {
        match step.interval {
            SlabInterval::Between { near, far } => {
                let is_null = step.verdict == SlabVerdict::Null;
                self.bar(sheet, row, name, [near, far], is_null);
            }
            SlabInterval::ParallelInside => {
                self.parallel(sheet, row, step, title + ": parallel, inside");
            }
            SlabInterval::ParallelOutside => {
                self.parallel(sheet, row, step, title + ": parallel, outside");
            }
        }
        if step.inside().is_some() {
            let [_, y] = self.bar_and_line(sheet, row);
            let [(near, _), (far, _)] = [step.max_near, step.min_far].map(|t| self.place(t));
            sheet.line(SO_FAR, DVec2::new(near, y), DVec2::new(far, y));
        }
    }

    /// From near to far, with their numbers beside it; inside it what has no room there, because the axis ends, or
    /// because nothing is left and the room is the crossing's.
    fn bar(&self, sheet: &mut Sheet, row: usize, name: Text, [near, far]: [f64; 2], is_null: bool) {
        let [middle, _] = self.bar_and_line(sheet, row);
        let [(from, starts), (to, ends)] = [near, far].map(|t| self.place(t));
        let half = 0.4 * sheet.letters;
        let min = DVec2::new(from, middle - half);
        let max = DVec2::new(to, middle + half);
        sheet.rectangle(OF_SLAB.inside(), Frame { min, max });
        for (is_end, x) in [(starts, from), (ends, to)] {
            if is_end {
                let at = |y: f64| DVec2::new(x, y);
                sheet.line(OF_SLAB.outline().wide(2.0), at(min.y), at(max.y));
            }
        }
        let gap = 0.4 * sheet.letters;
        let (start, end) = match row {
            0 => (
                format!("near {}", quantity(near)),
                format!("{} far", quantity(far)),
            ),
            _ => (quantity(near), quantity(far)),
        };
        let named = name.clone() + ": " + &start;
        let behind = to + gap;
        let has_room = behind + sheet.width_of(&end) <= self.frame.max.x;
        let is_short = to - from < sheet.width_of(&named) + sheet.width_of(&end) + 3.0 * gap;
        if starts && ends && is_short && !has_room {
            // a short bar at the end of the axis has both of its words before it
            let both = named + ", " + &end;
            sheet.text(Anchor::End, DVec2::new(from - gap, middle), both);
            return;
        }
        let inside = DVec2::new(from + gap, middle);
        // how much of the bar its own words take
        let mut taken = 0.0;
        if starts && !is_null && self.frame.min.x <= from - gap - sheet.width_of(&named) {
            sheet.text(Anchor::End, DVec2::new(from - gap, middle), named);
        } else if starts {
            taken = sheet.width_of(&named) + 2.0 * gap;
            sheet.text(Anchor::Start, inside, named);
        } else {
            let start = format!("← {start}");
            taken = sheet.width_of(&start) + 2.0 * gap;
            sheet.text(Anchor::Start, inside, start);
            sheet.text(Anchor::End, DVec2::new(from - gap, middle), name);
        }
        // words that do not end in a short bar go on behind it
        let behind = to.max(from + taken) + gap;
        let has_room = behind + sheet.width_of(&end) <= self.frame.max.x;
        let is_short = to - from < taken + gap + sheet.width_of(&end);
        if ends && has_room && (!is_null || is_short) {
            sheet.text(Anchor::Start, DVec2::new(behind, middle), end);
        } else {
            let text = if ends { end } else { format!("{end} →") };
            sheet.text(Anchor::End, DVec2::new(to - gap, middle), text);
        }
    }

    /// That a slab has no ends on the ray.
    fn parallel(&self, sheet: &mut Sheet, row: usize, step: &SlabStep, text: Text) {
        let [middle, _] = self.bar_and_line(sheet, row);
        let (near, _) = self.place(step.max_near);
        let place = DVec2::new(near - 0.4 * sheet.letters, middle);
        if self.frame.min.x + sheet.width_of(&text) < place.x {
            sheet.text(Anchor::End, place, text);
        } else {
            sheet.text(Anchor::Start, DVec2::new(self.frame.min.x, middle), text);
        }
    }

    /// What is left of the ray behind the last slab that was looked at. `rows` are the slabs that were, each with its row.
    pub(in crate::figure) fn result(
        &self,
        sheet: &mut Sheet,
        row: usize,
        rows: &[(usize, SlabStep)],
    ) {
        let Some((last, step)) = rows.last() else {
            return;
        };
        let y = self.middle(row);
        if !step.max_near.is_finite() || !step.min_far.is_finite() {
            // the ray is parallel to every slab that was looked at: there is no t to show
            let text = match step.verdict {
                SlabVerdict::ParallelOutside | SlabVerdict::Null => "null at every t",
                SlabVerdict::ParallelInside | SlabVerdict::GoesOn => "inside at every t",
            };
            let (left, _) = self.ends();
            sheet.text(Anchor::Start, DVec2::new(left, y), text);
            return;
        }
        let [(near, _), (far, _)] = [step.max_near, step.min_far].map(|t| self.place(t));
        // from the slab on that says it
        let near_row = rows.iter().find(|(_, of)| of.max_near == step.max_near);
        let far_row = rows.iter().find(|(_, of)| of.min_far == step.min_far);
        for (x, from) in [(near, near_row), (far, far_row)] {
            let [bar, _] = self.bar_and_line(sheet, from.map_or(*last, |(row, _)| *row));
            let top = DVec2::new(x, bar + 0.4 * sheet.letters);
            sheet.line(Look::HELP.wide(0.75), top, DVec2::new(x, y));
        }
        let max_near = format!("max near {}", quantity(step.max_near));
        let min_far = format!("min far {}", quantity(step.min_far));
        let is_null = step.inside().is_none();
        let (left, right, [before, behind]) = if far < near {
            (far, near, [min_far, format!("{max_near}: null")])
        } else if is_null {
            (near, far, [max_near, format!("{min_far}: null")])
        } else {
            (near, far, [max_near, min_far])
        };
        if is_null {
            let mut rows = vec![y];
            if step.verdict == SlabVerdict::Null {
                let [_, of_last] = self.bar_and_line(sheet, *last);
                rows.push(of_last);
            }
            for y in rows {
                sheet.line(CROSSED, DVec2::new(left, y), DVec2::new(right, y));
                sheet.cross(CROSSED, DVec2::new(0.5 * (left + right), y));
            }
        } else {
            sheet.line(LEFT, DVec2::new(left, y), DVec2::new(right, y));
        }
        let gap = 0.4 * sheet.letters;
        sheet.text(Anchor::End, DVec2::new(left - gap, y), before);
        sheet.text(Anchor::Start, DVec2::new(right + gap, y), behind);
    }

    /// The row of a slab behind the one that ended the test.
    pub(in crate::figure) fn untouched(&self, sheet: &mut Sheet, row: usize, title: Text) {
        let (_, right) = self.ends();
        let middle = self.middle(row);
        let text = title + ": not tested";
        let left = self.frame.min.x + sheet.width_of(&text) + 0.6 * sheet.letters;
        sheet.text(Anchor::Start, DVec2::new(self.frame.min.x, middle), text);
        sheet.line(
            Look::CULLED,
            DVec2::new(left, middle),
            DVec2::new(right, middle),
        );
    }

    /// The axis itself, below the rows.
    pub(in crate::figure) fn draw(&self, sheet: &mut Sheet, rows: usize) {
        let y = self.middle(rows) - 0.25 * self.row;
        let (left, right) = self.ends();
        sheet.arrow(Look::THIN, DVec2::new(left, y), DVec2::new(right, y));
        let below = y + 0.75 * sheet.line_height();
        sheet.text(Anchor::End, DVec2::new(right, below), formula("t"));
        let [(zero, _), (one, _)] = [0.0, 1.0].map(|t| self.place(t));
        let step = ticks(one - zero, 4.0 * sheet.letters);
        let tick = 0.25 * sheet.letters;
        for place in 0..100 {
            let t = f64::from(place) * step;
            let (x, is_on) = self.place(t);
            if !is_on || right - 2.0 * sheet.letters < x {
                break;
            }
            sheet.line(Look::THIN, DVec2::new(x, y - tick), DVec2::new(x, y + tick));
            sheet.text(Anchor::Middle, DVec2::new(x, below), quantity(t));
        }
    }
}

/// The distance of ticks in t: 1, 2 or 5 of a power of ten, and at least so wide where 1 is `unit` wide.
fn ticks(unit: f64, least: f64) -> f64 {
    let least = least / unit.max(f64::MIN_POSITIVE);
    let power = libm::pow(10.0, libm::log10(least).floor());
    let step = [1.0, 2.0, 5.0].into_iter().find(|of| least <= of * power);
    step.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_not_too_close() {
        // 60 units for 1, at least 50 apart; 6 for 1: 50/6 = 8.3, so 10; 30: 1.67, so 2; 12: 4.17, so 5
        for (unit, step) in [
            (60.0, 1.0),
            (6.0, 10.0),
            (30.0, 2.0),
            (12.0, 5.0),
            (600.0, 0.1),
        ] {
            assert!((ticks(unit, 50.0) - step).abs() < 1e-12, "{unit}");
        }
    }
}
