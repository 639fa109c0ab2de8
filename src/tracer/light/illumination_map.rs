//! An illumination map: light that has fallen on a flat surface, cell by cell.
//!
//! J. Arvo, *Backward ray tracing* (1986): a surface's own texture, into which light is traced.

use glam::{DVec2, DVec3};

use crate::geometry::polygon_in_rectangle;
use crate::tracer::light::flat_face::{along, on_plane};

/// The map of one side of a flat face.
#[derive(Clone, Debug)]
pub(in crate::tracer) struct IlluminationMap {
    origin: DVec3,
    /// Unit vectors along the columns and the rows.
    axes: [DVec3; 2],
    /// The lower left corner of the first cell.
    corner: DVec2,
    /// How wide and high a cell is.
    cell: f64,
    columns: usize,
    outline: Vec<DVec2>,
    /// What has fallen on each cell, in watts, and how many photons brought it.
    cells: Vec<(DVec3, u32)>,
}

/// How much memory a cell takes.
pub(in crate::tracer) const BYTES_PER_CELL: usize = size_of::<(DVec3, u32)>();

/// What a map says about a place.
pub(in crate::tracer) struct CellLight {
    pub(in crate::tracer) power: DVec3,
    pub(in crate::tracer) count: u32,
    /// What of the cell the surface covers.
    pub(in crate::tracer) area: f64,
}

impl IlluminationMap {
    /// An empty map with square cells, this number along the longer side of the corners' extent.
    pub(in crate::tracer) fn new(corners: &[DVec3], normal: DVec3, along_longer: u32) -> Self {
        let axes = along(normal);
        let origin = corners.first().copied().unwrap_or_default();
        let outline: Vec<DVec2> = on_plane(corners, origin, axes).collect();
        let low = outline.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = outline
            .iter()
            .copied()
            .fold(DVec2::NEG_INFINITY, DVec2::max);
        let size = high - low;
        let cell = size.max_element() / f64::from(along_longer);
        let [columns, rows] = size
            .to_array()
            .map(|side| (side / cell).ceil().max(1.0) as usize);
        Self {
            origin,
            axes,
            corner: low,
            cell,
            columns,
            outline,
            cells: vec![(DVec3::ZERO, 0); columns * rows],
        }
    }

    /// A photon falls on the surface.
    pub(in crate::tracer) fn add(&mut self, point: DVec3, power: DVec3) {
        let (index, _) = self.cell_at(point);
        let (sum, count) = &mut self.cells[index];
        *sum += power;
        *count += 1;
    }

    /// What has fallen on the cell around a point.
    pub(in crate::tracer) fn look_up(&self, point: DVec3) -> CellLight {
        let (index, corner) = self.cell_at(point);
        let (power, count) = self.cells[index];
        let area = polygon_in_rectangle(&self.outline, corner, corner + DVec2::splat(self.cell));
        CellLight { power, count, area }
    }

    /// The number of the cell, and its lower left corner. A point on the rim belongs to the cell inside.
    fn cell_at(&self, point: DVec3) -> (usize, DVec2) {
        let offset = point - self.origin;
        let place = DVec2::new(offset.dot(self.axes[0]), offset.dot(self.axes[1])) - self.corner;
        let rows = self.cells.len() / self.columns;
        let number =
            |along: f64, count: usize| ((along / self.cell).max(0.0) as usize).min(count - 1);
        let (column, row) = (number(place.x, self.columns), number(place.y, rows));
        let corner = self.corner + self.cell * DVec2::new(column as f64, row as f64);
        (row * self.columns + column, corner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_at_the_rim_is_as_large_as_what_the_surface_covers_of_it() {
        // a right triangle of sides 4: with cells of 1, the ten cells on and below the diagonal
        let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [0.0, 4.0, 5.0]].map(DVec3::from);
        let mut map = IlluminationMap::new(&corners, DVec3::Z, 4);
        let inner = DVec3::new(0.5, 0.5, 5.0);
        let rim = DVec3::new(2.2, 1.3, 5.0);
        map.add(inner, DVec3::ONE);
        map.add(rim, DVec3::new(0.0, 2.0, 0.0));
        map.add(rim, DVec3::new(1.0, 0.0, 0.0));
        let found = map.look_up(DVec3::new(0.9, 0.1, 5.0));
        assert_eq!((found.power, found.count), (DVec3::ONE, 1));
        assert!((found.area - 1.0).abs() <= 1e-14);
        let found = map.look_up(rim);
        assert_eq!((found.power, found.count), (DVec3::new(1.0, 2.0, 0.0), 2));
        assert!((found.area - 0.5).abs() <= 1e-14, "{}", found.area);
    }

    #[test]
    fn a_map_beside_the_origin_counts_its_cells_from_the_lowest_corner_of_the_face() {
        // 4 × 2 in the plane x = 3, from y = 5 and z = −1: cells of 1
        let corners = [
            [3.0, 5.0, -1.0],
            [3.0, 9.0, -1.0],
            [3.0, 9.0, 1.0],
            [3.0, 5.0, 1.0],
        ]
        .map(DVec3::from);
        let mut map = IlluminationMap::new(&corners, DVec3::X, 4);
        assert_eq!(map.cells.len(), 8);
        let at = |y: f64, z: f64| DVec3::new(3.0, y, z);
        map.add(at(8.5, 0.5), DVec3::ONE);
        map.add(at(8.1, 0.9), DVec3::ONE);
        map.add(at(7.9, 0.5), DVec3::X);
        let light = |y: f64, z: f64| {
            let found = map.look_up(at(y, z));
            assert!((found.area - 1.0).abs() <= 1e-14, "{}", found.area);
            (found.power, found.count)
        };
        assert_eq!(light(8.9, 0.1), (DVec3::splat(2.0), 2));
        assert_eq!(light(7.1, 0.1), (DVec3::X, 1));
        assert_eq!(light(8.5, -0.5), (DVec3::ZERO, 0));
        // the corner itself belongs to the cell inside
        assert_eq!(light(9.0, 1.0), (DVec3::splat(2.0), 2));
        assert_eq!(light(5.0, -1.0), (DVec3::ZERO, 0));
    }

    #[test]
    fn the_shorter_side_has_as_many_cells_as_it_takes_to_cover_it() {
        let rows = |height: f64, along_longer: u32| {
            let corners = [
                [0.0, 0.0, 0.0],
                [4.0, 0.0, 0.0],
                [4.0, height, 0.0],
                [0.0, height, 0.0],
            ];
            let map = IlluminationMap::new(&corners.map(DVec3::from), DVec3::Z, along_longer);
            map.cells.len() / map.columns.max(map.cells.len() / map.columns)
        };
        // cells of ½ and of 2; at least one row
        assert_eq!(
            [rows(2.0, 8), rows(3.0, 2), rows(2.9, 8), rows(0.1, 8)],
            [4, 2, 6, 1]
        );
    }
}
