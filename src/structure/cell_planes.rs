//! Where the cells of a grid lie: the planes between them, and their numbers.

use glam::DVec3;

/// A box cut into equal cells by planes across x, y and z.
///
/// The f64 values of the planes *are* the grid: whatever is decided about a cell is decided by them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct CellPlanes {
    /// Cells along x, y and z.
    resolution: [u32; 3],
    /// The planes across x, then those across y, then those across z, each rising.
    planes: Vec<f64>,
    /// Cells for each unit of length.
    per_unit: [f64; 3],
}

impl CellPlanes {
    /// pᵢ = min + (max − min)·i/n, and exactly `max` for i = n.
    ///
    /// The planes of an axis rise strictly if it has at most [`CellPlanes::most_along`] cells.
    pub(crate) fn new(min: DVec3, max: DVec3, resolution: [u32; 3]) -> Self {
        let mut planes = Vec::new();
        let mut per_unit = [0.0; 3];
        for axis in 0..3 {
            let (low, high, n) = (min[axis], max[axis], resolution[axis]);
            let side = high - low;
            planes.extend((0..n).map(|i| low + side * (f64::from(i) / f64::from(n))));
            planes.push(high);
            per_unit[axis] = f64::from(n) / side;
        }
        Self {
            resolution,
            planes,
            per_unit,
        }
    }

    /// How many cells at most lie between two coordinates, so that each is many roundings wide.
    pub(crate) fn most_along(low: f64, high: f64) -> f64 {
        /// A plane is rounded twice; half a dozen ε apart they are in order.
        const APART: f64 = 8.0 * f64::EPSILON;
        ((high - low) / (APART * low.abs().max(high.abs()))).floor()
    }

    /// Cells along x, y and z.
    #[inline]
    pub(crate) fn resolution(&self) -> [u32; 3] {
        self.resolution
    }

    /// The planes of all axes, one axis after the other.
    #[inline]
    pub(crate) fn all(&self) -> &[f64] {
        &self.planes
    }

    /// Where the planes of an axis begin in [`CellPlanes::all`].
    #[inline]
    pub(crate) fn first(&self, axis: usize) -> usize {
        // n cells have n + 1 planes
        self.resolution[..axis]
            .iter()
            .map(|&n| n as usize + 1)
            .sum()
    }

    /// The planes across an axis; none if there are no cells.
    #[inline]
    pub(crate) fn axis(&self, axis: usize) -> &[f64] {
        if self.planes.is_empty() {
            return &[];
        }
        let first = self.first(axis);
        &self.planes[first..=first + self.resolution[axis] as usize]
    }

    /// How many cells there are.
    #[inline]
    pub(crate) fn count(&self) -> usize {
        self.resolution.iter().map(|&n| n as usize).product()
    }

    /// By how much a cell's number grows from one cell to the next along x, y and z.
    #[inline]
    pub(crate) fn strides(&self) -> [usize; 3] {
        let [nx, ny, _] = self.resolution.map(|n| n as usize);
        [1, nx, nx * ny]
    }

    /// The number of cell (i, j, k): i + nx·(j + ny·k).
    #[inline]
    pub(crate) fn number(&self, [i, j, k]: [u32; 3]) -> usize {
        let [nx, ny, _] = self.resolution.map(|n| n as usize);
        i as usize + nx * (j as usize + ny * k as usize)
    }

    /// The cell (i, j, k) with a number.
    pub(crate) fn cell(&self, number: usize) -> [u32; 3] {
        let [nx, ny, _] = self.resolution.map(|n| n as usize);
        [number % nx, number / nx % ny, number / nx / ny].map(|at| at as u32)
    }

    /// About which cell along an axis a coordinate lies in; the first or the last if it lies outside.
    #[inline]
    pub(crate) fn near(&self, axis: usize, x: f64) -> usize {
        let low = self.planes[self.first(axis)];
        // a conversion to whole numbers cuts off what does not fit
        let at = ((x - low) * self.per_unit[axis]) as u32;
        at.min(self.resolution[axis] - 1) as usize
    }

    /// The first and the last cell along an axis that [low, high] touches; a plane belongs to both sides.
    #[inline]
    pub(crate) fn touched(&self, axis: usize, [low, high]: [f64; 2]) -> [u32; 2] {
        let planes = self.axis(axis);
        let last_cell = planes.len() - 2;
        let mut first = self.near(axis, low);
        while 0 < first && low <= planes[first] {
            first -= 1;
        }
        while first < last_cell && planes[first + 1] < low {
            first += 1;
        }
        let mut last = self.near(axis, high).max(first);
        while first < last && high < planes[last] {
            last -= 1;
        }
        while last < last_cell && planes[last + 1] <= high {
            last += 1;
        }
        [first as u32, last as u32]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn four_two_one() -> CellPlanes {
        CellPlanes::new(DVec3::ZERO, DVec3::new(4.0, 4.0, 1.0), [4, 2, 1])
    }

    #[test]
    fn the_planes_cut_the_box_into_equal_cells() {
        let cells = four_two_one();
        assert_eq!(cells.axis(0), [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(cells.axis(1), [0.0, 2.0, 4.0]);
        assert_eq!(cells.axis(2), [0.0, 1.0]);
        assert_eq!(cells.count(), 8);
    }

    #[test]
    fn a_cell_s_number_counts_along_x_first() {
        let cells = four_two_one();
        assert_eq!(cells.number([3, 1, 0]), 7);
        assert_eq!(cells.number([0, 1, 0]), 4);
        assert_eq!(
            (0..8).map(|n| cells.number(cells.cell(n))).sum::<usize>(),
            28
        );
    }

    #[test]
    fn a_plane_belongs_to_the_cells_on_both_sides() {
        let cells = four_two_one();
        for (range, touched) in [
            ([0.5, 0.5], [0, 0]),
            ([1.0, 1.0], [0, 1]),
            ([1.5, 3.0], [1, 3]),
            ([-9.0, 9.0], [0, 3]),
            ([4.0, 4.0], [3, 3]),
            ([0.0, 0.0], [0, 0]),
        ] {
            assert_eq!(cells.touched(0, range), touched, "{range:?}");
        }
    }

    #[test]
    fn planes_rise_strictly_up_to_the_finest_grid() {
        let (low, high) = (1e6, 1e6 + 1e-6);
        let n = CellPlanes::most_along(low, high) as u32;
        let cells = CellPlanes::new(DVec3::splat(low), DVec3::splat(high), [n, 1, 1]);
        assert!(100 < n, "{n}");
        assert!(cells.axis(0).is_sorted_by(|a, b| a < b));
    }
}
