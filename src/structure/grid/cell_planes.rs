//! Where the cells of a grid lie: the planes between them, and their numbers.

use crate::geometry::AxisBox;

/// A box cut into equal cells by planes across x, y and z.
///
/// The f64 values of the planes *are* the grid: whatever is decided about a cell is decided by them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct CellPlanes {
    /// Along x, y and z.
    axes: [CellsAlong; 3],
}

/// The cells along an axis.
#[derive(Clone, Debug, Default, PartialEq)]
struct CellsAlong {
    /// How many.
    count: u32,
    /// By how much a cell's number grows from one cell to the next.
    stride: usize,
    /// The planes across the axis, rising.
    planes: Vec<f64>,
}

impl CellPlanes {
    /// pᵢ = min + (max − min)·i/n, and exactly `max` for i = n.
    ///
    /// The planes of an axis rise strictly if it has at most [`CellPlanes::most_along`] cells.
    pub(crate) fn new(around: &AxisBox, resolution: [u32; 3]) -> Self {
        let mut stride = 1;
        let axes = [0, 1, 2].map(|axis: usize| {
            let ([low, high], n) = (around.along(axis), resolution[axis]);
            let side = high - low;
            let mut planes = Vec::with_capacity(n as usize + 1);
            planes.extend((0..n).map(|i| low + side * (f64::from(i) / f64::from(n))));
            planes.push(high);
            let along = CellsAlong {
                count: n,
                stride,
                planes,
            };
            stride *= n as usize;
            along
        });
        Self { axes }
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
        self.axes.each_ref().map(|along| along.count)
    }

    /// By how much a cell's number grows from one cell to the next along x, y and z.
    pub(crate) fn strides(&self) -> [usize; 3] {
        self.axes.each_ref().map(|along| along.stride)
    }

    /// The planes across an axis, rising; none if there are no cells.
    pub(crate) fn axis(&self, axis: usize) -> &[f64] {
        &self.axes[axis].planes
    }

    /// Are there no cells?
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.axes[0].planes.is_empty()
    }

    /// How many cells there are.
    pub(crate) fn count(&self) -> usize {
        self.axes.iter().map(|along| along.count as usize).product()
    }

    /// How much memory the planes take, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let planes = self.axes.iter().map(|along| along.planes.as_slice());
        planes.map(size_of_val).sum()
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
            .each_ref()
            .map(|along| (number / along.stride % along.count as usize) as u32)
    }

    /// The first and the last cell along an axis that [low, high] touches; a plane belongs to both sides.
    #[inline]
    pub(crate) fn touched(&self, axis: usize, [low, high]: [f64; 2]) -> [u32; 2] {
        let planes = self.axis(axis);
        let last_cell = planes.len() - 2;
        let (from, to) = (planes[0], planes[last_cell + 1]);
        let per_unit = (last_cell + 1) as f64 / (to - from);
        // a conversion to whole numbers cuts off what does not fit
        let near = |x: f64| (((x - from) * per_unit) as usize).min(last_cell);
        let mut first = near(low);
        while 0 < first && low <= planes[first] {
            first -= 1;
        }
        while first < last_cell && planes[first + 1] < low {
            first += 1;
        }
        let mut last = near(high).max(first);
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
    use glam::DVec3;

    use super::*;

    fn four_two_one() -> CellPlanes {
        let around = AxisBox {
            min: DVec3::ZERO,
            max: DVec3::new(4.0, 4.0, 1.0),
        };
        CellPlanes::new(&around, [4, 2, 1])
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
        let around = AxisBox::around([DVec3::splat(low), DVec3::splat(high)]);
        let cells = CellPlanes::new(&around, [n, 1, 1]);
        assert!(100 < n, "{n}");
        assert!(cells.axis(0).is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn a_number_is_that_of_one_cell_and_back() {
        // 2 × 3 × 4: z counts in sixes, y in twos
        let cells = CellPlanes::new(&AxisBox::around([DVec3::ZERO, DVec3::ONE]), [2, 3, 4]);
        assert_eq!(cells.number([1, 2, 3]), 1 + 2 * 2 + 3 * 6);
        assert_eq!(cells.cell(23), [1, 2, 3]);
        assert_eq!(cells.cell(8), [0, 1, 1]);
        assert_eq!(cells.strides(), [1, 2, 6]);
        assert_eq!(cells.resolution(), [2, 3, 4]);
        // 3 + 4 + 5 planes of 8 bytes
        assert_eq!(cells.bytes(), 96);
        assert!(!cells.is_empty() && CellPlanes::default().is_empty());
    }

    #[test]
    fn planes_of_a_box_beside_the_origin_go_from_its_smallest_to_its_largest_coordinate() {
        let (min, max) = (DVec3::new(1.0, -2.0, 3.0), DVec3::new(5.0, 0.0, 9.0));
        let cells = CellPlanes::new(&AxisBox { min, max }, [4, 2, 3]);
        assert_eq!(cells.axis(0), [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(cells.axis(1), [-2.0, -1.0, 0.0]);
        assert_eq!(cells.axis(2), [3.0, 5.0, 7.0, 9.0]);
        for (range, touched) in [
            ([3.5, 6.9], [0, 1]),
            ([5.0, 8.0], [0, 2]),
            ([7.5, 99.0], [2, 2]),
        ] {
            assert_eq!(cells.touched(2, range), touched, "{range:?}");
        }
    }

    #[test]
    fn cells_along_an_axis_are_at_least_eight_roundings_wide() {
        // of 1 unit beside coordinates up to 2: 1/(8ε·2) = 2⁵²/16
        assert_eq!(CellPlanes::most_along(1.0, 2.0), 2.0_f64.powi(48));
        assert_eq!(CellPlanes::most_along(-2.0, -1.0), 2.0_f64.powi(48));
        assert_eq!(CellPlanes::most_along(-1.0, 1.0), 2.0_f64.powi(50));
    }

    #[test]
    fn the_cells_touched_are_those_whose_planes_enclose_the_range_wherever_rounding_puts_the_planes()
     {
        // lengths that are no sums of few powers of two: the planes are rounded, and a division lands on either side of them
        let boxes = [
            ([0.1; 3], [1e3, 1e6 + 0.3, 7.7], [13, 97, 51]),
            (
                [-7.7, -1.1, -0.9],
                [-7.7 + 7.9, -1.1 + 3.0, 2.1],
                [44, 63, 98],
            ),
        ];
        for (min, max, resolution) in boxes {
            let (min, max) = (min.into(), max.into());
            check_touched(&CellPlanes::new(&AxisBox { min, max }, resolution));
        }
    }

    /// The cells touched by ranges that begin and end at planes, beside them and between them.
    #[track_caller]
    fn check_touched(cells: &CellPlanes) {
        for axis in 0..3 {
            let planes = cells.axis(axis);
            let last = planes.len() - 2;
            // each plane, its neighbours among the numbers, and a point between it and the next
            let mut places = vec![planes[0] - 1.0, planes[last + 1] + 1.0];
            for pair in planes.windows(2) {
                places.extend([pair[0].next_down(), pair[0], pair[0].next_up()]);
                places.push(0.5 * (pair[0] + pair[1]));
            }
            for &low in &places {
                for high in [low, low + 0.3 * (planes[1] - planes[0]), planes[last + 1]] {
                    // a cell is touched if it ends at `low` or later, and begins at `high` or sooner
                    let first = (0..last).find(|&i| low <= planes[i + 1]).unwrap_or(last);
                    let end = (first..=last).rev().find(|&i| planes[i] <= high);
                    let expected = [first as u32, end.unwrap_or(first) as u32];
                    let found = cells.touched(axis, [low, high]);
                    assert_eq!(found, expected, "{axis}: {low} {high}");
                }
            }
        }
    }
}
