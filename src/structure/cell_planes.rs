//! Where the cells of a grid lie: the planes between them, and their numbers.

use glam::DVec3;

/// A box cut into equal cells by planes across x, y and z.
///
/// The f64 values of the planes *are* the grid: whatever is decided about a cell is decided by them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct CellPlanes {
    /// The planes across x, then those across y, then those across z, each rising from one at −∞ to one at ∞: a walk
    /// that looks one plane too far finds one that it never meets.
    planes: Vec<f64>,
    /// Along x, y and z.
    axes: [CellsAlong; 3],
}

/// The cells along an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct CellsAlong {
    /// How many.
    pub(crate) count: u32,
    /// By how much a cell's number grows from one cell to the next.
    pub(crate) stride: usize,
    /// The place of the lowest plane among all planes.
    pub(crate) first_plane: usize,
    /// The lowest plane.
    pub(crate) low: f64,
    /// The highest plane.
    pub(crate) high: f64,
    /// Cells for each unit of length.
    pub(crate) per_unit: f64,
}

impl CellPlanes {
    /// pᵢ = min + (max − min)·i/n, and exactly `max` for i = n.
    ///
    /// The planes of an axis rise strictly if it has at most [`CellPlanes::most_along`] cells.
    pub(crate) fn new(min: DVec3, max: DVec3, resolution: [u32; 3]) -> Self {
        let mut planes = Vec::new();
        let mut axes = [CellsAlong::default(); 3];
        let mut stride = 1;
        for (axis, along) in axes.iter_mut().enumerate() {
            let (low, high, n) = (min[axis], max[axis], resolution[axis]);
            let side = high - low;
            planes.push(f64::NEG_INFINITY);
            *along = CellsAlong {
                count: n,
                stride,
                first_plane: planes.len(),
                low,
                high,
                per_unit: f64::from(n) / side,
            };
            planes.extend((0..n).map(|i| low + side * (f64::from(i) / f64::from(n))));
            planes.extend([high, f64::INFINITY]);
            stride *= n as usize;
        }
        Self { planes, axes }
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
        self.axes.map(|along| along.count)
    }

    /// The cells along x, y and z.
    #[inline]
    pub(crate) fn along(&self) -> &[CellsAlong; 3] {
        &self.axes
    }

    /// The plane in this place among all.
    #[inline]
    pub(crate) fn plane(&self, place: usize) -> f64 {
        self.planes[place]
    }

    /// The planes across an axis; none if there are no cells.
    pub(crate) fn axis(&self, axis: usize) -> &[f64] {
        if self.is_empty() {
            return &[];
        }
        let along = &self.axes[axis];
        &self.planes[along.first_plane..=along.last_plane()]
    }

    /// Are there no cells?
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.planes.is_empty()
    }

    /// How many cells there are.
    pub(crate) fn count(&self) -> usize {
        self.axes.iter().map(|along| along.count as usize).product()
    }

    /// How much memory the planes take, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.planes.as_slice())
    }

    /// The number of cell (i, j, k): i + nx·(j + ny·k).
    #[inline]
    pub(crate) fn number(&self, [i, j, k]: [u32; 3]) -> usize {
        let [x, y, z] = &self.axes;
        i as usize * x.stride + j as usize * y.stride + k as usize * z.stride
    }

    /// The cell (i, j, k) with a number.
    pub(crate) fn cell(&self, number: usize) -> [u32; 3] {
        self.axes
            .map(|along| (number / along.stride % along.count as usize) as u32)
    }

    /// The first and the last cell along an axis that [low, high] touches; a plane belongs to both sides.
    #[inline]
    pub(crate) fn touched(&self, axis: usize, [low, high]: [f64; 2]) -> [u32; 2] {
        let planes = self.axis(axis);
        let last_cell = planes.len() - 2;
        let mut first = self.axes[axis].near(low);
        while 0 < first && low <= planes[first] {
            first -= 1;
        }
        while first < last_cell && planes[first + 1] < low {
            first += 1;
        }
        let mut last = self.axes[axis].near(high).max(first);
        while first < last && high < planes[last] {
            last -= 1;
        }
        while last < last_cell && planes[last + 1] <= high {
            last += 1;
        }
        [first as u32, last as u32]
    }
}

impl CellsAlong {
    /// The place of the highest plane among all planes: n cells have n + 1.
    #[inline]
    pub(crate) fn last_plane(&self) -> usize {
        self.first_plane + self.count as usize
    }

    /// About which cell a coordinate lies in; the first or the last if it lies outside.
    pub(crate) fn near(&self, x: f64) -> usize {
        self.cell_at((x - self.low) * self.per_unit)
    }

    /// The cell so many cells' sides above the lowest plane; the first or the last if that is outside.
    #[inline]
    pub(crate) fn cell_at(&self, sides: f64) -> usize {
        // a conversion to whole numbers cuts off what does not fit
        (sides as u32).min(self.count - 1) as usize
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
