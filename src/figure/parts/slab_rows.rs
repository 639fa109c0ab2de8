//! Near and far of slabs as rows above an axis of t: the interval of each slab, and what all have in common so far.

use glam::DVec2;

use crate::figure::parts::bound::Slab;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Fill, Look};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::view::Space;
use crate::geometry::{Ray, SlabInterval};
use crate::structure::{SlabStep, SlabVerdict};

/// What all slabs so far have in common.
pub(in crate::figure) const COMMON: Look = Look {
    fill: Fill::Empty,
    ..Look::ANSWER.wide(4.0)
};
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

    /// The name of a slab before its row.
    pub(in crate::figure) fn name(&self, sheet: &mut Sheet, row: usize, slab: &Slab) {
        let at = DVec2::new(self.frame.min.x, self.middle(row));
        sheet.text(Anchor::Start, at, slab.name());
    }

    /// The row of a slab that was tested: its own interval, and below what all have in common so far.
    pub(in crate::figure) fn slab(&self, sheet: &mut Sheet, row: usize, step: &SlabStep) {
        let middle = self.middle(row) - 0.1 * sheet.line_height();
        match step.interval {
            SlabInterval::Between { near, far } => {
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
                let (mut start, mut end) = (quantity(near), quantity(far));
                if row == 0 {
                    (start, end) = (format!("near {start}"), format!("{end} far"));
                }
                // inside the bar's end what has no room before or behind it: there the axis ends, or the crossing is
                let is_null = step.verdict == SlabVerdict::Null;
                let before = from - gap - sheet.width_of(&start);
                if starts && !is_null && self.frame.min.x <= before {
                    sheet.text(Anchor::End, DVec2::new(from - gap, middle), start);
                } else {
                    let text = if starts {
                        start
                    } else {
                        format!("← {start}")
                    };
                    sheet.text(Anchor::Start, DVec2::new(from + gap, middle), text);
                }
                let behind = to + gap + sheet.width_of(&end);
                if ends && !is_null && behind <= self.frame.max.x {
                    sheet.text(Anchor::Start, DVec2::new(to + gap, middle), end);
                } else {
                    let text = if ends { end } else { format!("{end} →") };
                    sheet.text(Anchor::End, DVec2::new(to - gap, middle), text);
                }
            }
            SlabInterval::ParallelInside => self.parallel(sheet, step, middle, "parallel, inside"),
            SlabInterval::ParallelOutside => {
                self.parallel(sheet, step, middle, "parallel, outside: null");
            }
        }
        self.common(sheet, row, step);
    }

    /// That a slab has no ends on the ray.
    fn parallel(&self, sheet: &mut Sheet, step: &SlabStep, middle: f64, text: &str) {
        let (near, _) = self.place(step.max_near);
        let place = DVec2::new(near - 0.4 * sheet.letters, middle);
        let (left, _) = self.ends();
        if left + sheet.width_of(text) < place.x {
            sheet.text(Anchor::End, place, text);
        } else {
            sheet.text(Anchor::Start, DVec2::new(left, middle), text);
        }
    }

    /// What is left of the ray behind the last slab that was looked at.
    pub(in crate::figure) fn result(&self, sheet: &mut Sheet, row: usize, step: &SlabStep) {
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
        let gap = 0.4 * sheet.letters;
        let max_near = format!("max near {}", quantity(step.max_near));
        let min_far = format!("min far {}", quantity(step.min_far));
        let is_null = matches!(
            step.verdict,
            SlabVerdict::Null | SlabVerdict::ParallelOutside
        );
        let (left, right, texts) = if far < near {
            (far, near, [min_far, format!("{max_near}: null")])
        } else if is_null {
            (near, far, [max_near, format!("{min_far}: null")])
        } else {
            (near, far, [max_near, min_far])
        };
        let top = self.frame.min.y;
        for x in [left, right] {
            sheet.line(Look::HELP.wide(0.75), DVec2::new(x, top), DVec2::new(x, y));
        }
        if is_null {
            sheet.line(CROSSED, DVec2::new(left, y), DVec2::new(right, y));
            sheet.cross(CROSSED, DVec2::new(0.5 * (left + right), y));
        } else {
            sheet.line(COMMON, DVec2::new(left, y), DVec2::new(right, y));
        }
        let [before, behind] = texts;
        sheet.text(Anchor::End, DVec2::new(left - gap, y), before);
        sheet.text(Anchor::Start, DVec2::new(right + gap, y), behind);
    }

    /// From the largest near to the smallest far, or that they have crossed.
    fn common(&self, sheet: &mut Sheet, row: usize, step: &SlabStep) {
        let y = self.middle(row) + 0.4 * sheet.line_height();
        let [(near, _), (far, _)] = [step.max_near, step.min_far].map(|t| self.place(t));
        match step.verdict {
            SlabVerdict::GoesOn | SlabVerdict::ParallelInside => {
                sheet.line(COMMON, DVec2::new(near, y), DVec2::new(far, y));
            }
            SlabVerdict::Null => {
                sheet.line(CROSSED, DVec2::new(far, y), DVec2::new(near, y));
                sheet.cross(CROSSED, DVec2::new(0.5 * (near + far), y));
            }
            SlabVerdict::ParallelOutside => {}
        }
    }

    /// The row of a slab behind the one that ended the test.
    pub(in crate::figure) fn untouched(&self, sheet: &mut Sheet, row: usize) {
        let (left, right) = self.ends();
        let middle = self.middle(row);
        sheet.line(
            Look::CULLED,
            DVec2::new(left, middle),
            DVec2::new(right, middle),
        );
    }

    /// The axis itself, below the rows.
    pub(in crate::figure) fn draw(&self, sheet: &mut Sheet, rows: usize) {
        let y = self.middle(rows) - 0.25 * self.row;
        let (_, right) = self.ends();
        let (zero, _) = self.place(0.0);
        sheet.arrow(Look::THIN, DVec2::new(zero, y), DVec2::new(right, y));
        let below = y + 0.75 * sheet.line_height();
        sheet.text(Anchor::End, DVec2::new(right, below), "t");
        let (one, _) = self.place(1.0);
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
