//! Which lines of a sheet are near a place: a uniform grid over the sheet, as the course has it for a scene
//! (Fig. 15.61), with the lines of each cell on a list.

use glam::DVec2;

use crate::figure::sheet::frame::Frame;

/// Side of a cell in units of the sheet: some letters.
const SIDE: f64 = 40.0;

/// Lines by the cells that the box around them reaches into.
#[derive(Clone, Debug)]
pub(in crate::figure) struct Buckets {
    columns: usize,
    rows: usize,
    lines: Vec<[DVec2; 2]>,
    cells: Vec<Vec<u32>>,
}

impl Buckets {
    /// No lines on a sheet of this size; what lies outside counts to the cells at its edge.
    pub(in crate::figure) fn new(size: DVec2) -> Self {
        let [columns, rows] = (size / SIDE)
            .to_array()
            .map(|of| of.ceil().max(1.0) as usize);
        Self {
            columns,
            rows,
            lines: Vec::new(),
            cells: vec![Vec::new(); columns * rows],
        }
    }

    pub(in crate::figure) fn add(&mut self, line: [DVec2; 2]) {
        let number = self.lines.len() as u32;
        self.lines.push(line);
        if let Some(around) = Frame::around(line) {
            for cell in self.cells_of(around) {
                self.cells[cell].push(number);
            }
        }
    }

    /// How many lines reach into a frame.
    pub(in crate::figure) fn crossing(&self, frame: Frame) -> usize {
        self.count(frame, |line| frame.cut_line(line).is_some())
    }

    /// How many lines a line crosses.
    pub(in crate::figure) fn crossing_line(&self, line: [DVec2; 2]) -> usize {
        let around = Frame::around(line);
        around.map_or(0, |frame| self.count(frame, |other| cross(line, other)))
    }

    /// How many lines near a frame are such ones.
    fn count(&self, frame: Frame, is_one: impl Fn([DVec2; 2]) -> bool) -> usize {
        let near = self.cells_of(frame).flat_map(|cell| &self.cells[cell]);
        let mut found: Vec<u32> = near
            .copied()
            .filter(|&line| is_one(self.lines[line as usize]))
            .collect();
        // a line is on the list of each of its cells
        found.sort_unstable();
        found.dedup();
        found.len()
    }

    fn cells_of(&self, frame: Frame) -> impl Iterator<Item = usize> + use<> {
        let columns = self.columns;
        let place = |at: f64, count: usize| ((at / SIDE).max(0.0) as usize).min(count - 1);
        let [left, right] = [frame.min.x, frame.max.x].map(|at| place(at, self.columns));
        let [top, bottom] = [frame.min.y, frame.max.y].map(|at| place(at, self.rows));
        (top..=bottom).flat_map(move |row| (left..=right).map(move |column| row * columns + column))
    }
}

/// Do two lines cross? Each has the ends of the other on both sides; those that only touch do not.
fn cross([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let side = |from: DVec2, to: DVec2, of: DVec2| (to - from).perp_dot(of - from);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_over_several_cells_is_counted_once_and_others_not_at_all() {
        let mut buckets = Buckets::new(DVec2::new(400.0, 200.0));
        let at = DVec2::new;
        buckets.add([at(0.0, 0.0), at(400.0, 200.0)]);
        buckets.add([at(0.0, 150.0), at(400.0, 150.0)]);
        // outside of the sheet
        buckets.add([at(-50.0, -50.0), at(500.0, -50.0)]);
        let frame = |min, max| Frame { min, max };
        // the slanted line and the level one cross at (300, 150)
        assert_eq!(
            buckets.crossing_line([at(200.0, 90.0), at(200.0, 160.0)]),
            2
        );
        assert_eq!(
            buckets.crossing_line([at(200.0, 110.0), at(200.0, 140.0)]),
            0
        );
        assert_eq!(
            buckets.crossing_line([at(380.0, 140.0), at(390.0, 180.0)]),
            1
        );
        assert_eq!(buckets.crossing(frame(at(90.0, 30.0), at(210.0, 120.0))), 1);
        assert_eq!(
            buckets.crossing(frame(at(290.0, 140.0), at(310.0, 160.0))),
            2
        );
        assert_eq!(buckets.crossing(frame(at(10.0, 100.0), at(60.0, 120.0))), 0);
        assert_eq!(buckets.crossing(frame(at(0.0, -60.0), at(10.0, -40.0))), 1);
    }
}
