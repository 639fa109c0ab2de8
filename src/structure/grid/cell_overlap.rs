//! Which cells does an object reach into?
//!
//! "Solid" is meant: a cell in the middle of a sphere lists it. Every test is on the safe side: it may keep a
//! cell that the object passes by within the room for rounding, and never leaves out one that the object with that
//! room around it touches.

use glam::DVec3;

use crate::geometry::{AxisBox, Polygon, Sphere, clip};
use crate::scene::Shape;
use crate::structure::Lists;
use crate::structure::bounds::ROUNDING;
use crate::structure::grid::cell_planes::CellPlanes;
use crate::structure::grid::cone_overlap::cone_touches;

/// Finds the cells of one object after the other.
#[derive(Debug)]
pub(in crate::structure) struct CellOverlap<'c> {
    cells: &'c CellPlanes,
    lists: Lists,
    /// The room of every object, besides a share of its own size: a length.
    room: f64,
    /// The polygon whose cells are looked for.
    outline: Vec<DVec3>,
    /// What is left of it between two planes across x, and between two more across y.
    slab: Vec<DVec3>,
    column: Vec<DVec3>,
    /// What is left of it on one side of a plane.
    half: Vec<DVec3>,
}

/// The cells that the box around an object touches: the first and the last along each axis.
type Touched = [[u32; 2]; 3];

impl<'c> CellOverlap<'c> {
    pub(in crate::structure) fn new(cells: &'c CellPlanes, lists: Lists, room: f64) -> Self {
        Self {
            cells,
            lists,
            room,
            outline: Vec::new(),
            slab: Vec::new(),
            column: Vec::new(),
            half: Vec::new(),
        }
    }

    /// Gives `put` the number of each cell that lists the shape, which has this box around it, room included.
    pub(in crate::structure) fn cells_of(
        &mut self,
        shape: &Shape,
        around: &AxisBox,
        put: &mut dyn FnMut(usize),
    ) {
        let touched = self.touched(around);
        if self.lists == Lists::Boxes || is_one(touched) {
            return self.each(touched, |_| true, put);
        }
        let room = self.room + ROUNDING * shape.reach();
        match shape {
            Shape::Box(_) => self.each(touched, |_| true, put),
            Shape::Sphere(Sphere { center, radius }) => {
                self.ellipsoid(*center, DVec3::splat(*radius), room, touched, put);
            }
            Shape::Ellipsoid(of) => self.ellipsoid(of.center, of.radii, room, touched, put),
            Shape::Cone(cone) => {
                let meets = |cell| cone_touches(cone, &self.solid(cell).with_room(room));
                self.each(touched, meets, put);
            }
            Shape::Polygon(polygon) => self.polygon(polygon, room + polygon.room(), touched, put),
        }
    }

    /// Does the whole of an object lie in one cell, by the box around it?
    pub(in crate::structure) fn is_in_one_cell(&self, around: &AxisBox) -> bool {
        is_one(self.touched(around))
    }

    fn touched(&self, around: &AxisBox) -> Touched {
        [0, 1, 2].map(|axis| self.cells.touched(axis, around.along(axis)))
    }

    fn each(&self, touched: Touched, meets: impl Fn([u32; 3]) -> bool, put: &mut dyn FnMut(usize)) {
        let [i, j, k] = touched.map(|[first, last]| first..=last);
        for k in k {
            for j in j.clone() {
                for i in i.clone() {
                    if meets([i, j, k]) {
                        put(self.cells.number([i, j, k]));
                    }
                }
            }
        }
    }

    /// The space of a cell.
    fn solid(&self, cell: [u32; 3]) -> AxisBox {
        let plane = |axis: usize, by: u32| self.cells.axis(axis)[(cell[axis] + by) as usize];
        let [min, max] = [0, 1].map(|by| DVec3::new(plane(0, by), plane(1, by), plane(2, by)));
        AxisBox { min, max }
    }

    /// In the space where the ellipsoid is a sphere of radius 1, how far is the cell's closest point?
    ///
    /// Room in the world is at most room/r in that space, with the smallest r.
    fn ellipsoid(
        &self,
        center: DVec3,
        radii: DVec3,
        room: f64,
        touched: Touched,
        put: &mut dyn FnMut(usize),
    ) {
        let radius = 1.0 + room / radii.min_element();
        let distance2 = |axis: usize, at: u32| {
            let planes = self.cells.axis(axis);
            let (low, high) = (planes[at as usize], planes[at as usize + 1]);
            let beside = (low - center[axis]).max(center[axis] - high).max(0.0);
            let scaled = beside / radii[axis];
            scaled * scaled
        };
        let radius2 = radius * radius;
        let [[i, i_last], [j, j_last], [k, k_last]] = touched;
        for k in k..=k_last {
            let in_z = distance2(2, k);
            for j in j..=j_last {
                let in_yz = distance2(1, j) + in_z;
                if radius2 < in_yz {
                    continue;
                }
                for i in i..=i_last {
                    if distance2(0, i) + in_yz <= radius2 {
                        put(self.cells.number([i, j, k]));
                    }
                }
            }
        }
    }

    /// What a column of cells along z cuts out of the polygon reaches from some cell of it to another.
    fn polygon(
        &mut self,
        polygon: &Polygon,
        room: f64,
        [[i, i_last], [j, j_last], _]: Touched,
        put: &mut dyn FnMut(usize),
    ) {
        let with_room = |axis: usize, at: u32| {
            let planes = self.cells.axis(axis);
            [planes[at as usize] - room, planes[at as usize + 1] + room]
        };
        self.outline.clear();
        self.outline.extend(polygon.vertices());
        for i in i..=i_last {
            let Self {
                outline,
                slab,
                half,
                ..
            } = self;
            clip_between(outline, 0, with_room(0, i), half, slab);
            let Some(in_y) = range(&self.slab, 1, room) else {
                continue;
            };
            let [j_first, j_end] = self.cells.touched(1, in_y);
            for j in j_first.max(j)..=j_end.min(j_last) {
                clip_between(
                    &self.slab,
                    1,
                    with_room(1, j),
                    &mut self.half,
                    &mut self.column,
                );
                let Some(in_z) = range(&self.column, 2, room) else {
                    continue;
                };
                let [k, k_last] = self.cells.touched(2, in_z);
                for k in k..=k_last {
                    put(self.cells.number([i, j, k]));
                }
            }
        }
    }
}

fn is_one(touched: Touched) -> bool {
    touched.iter().all(|[first, last]| first == last)
}

/// From the smallest to the largest coordinate of some points, with room on either side; `None` without points.
fn range(points: &[DVec3], axis: usize, room: f64) -> Option<[f64; 2]> {
    let first = points.first()?[axis];
    let (low, high) = points.iter().fold((first, first), |(low, high), point| {
        (low.min(point[axis]), high.max(point[axis]))
    });
    Some([low - room, high + room])
}

/// What is left of an outline between two planes across an axis. Parts of a concave outline stay connected by edges in
/// the planes, which adds no more than what lies between them.
fn clip_between(
    outline: &[DVec3],
    axis: usize,
    [low, high]: [f64; 2],
    half: &mut Vec<DVec3>,
    clipped: &mut Vec<DVec3>,
) {
    clip(outline, |p| p[axis] - low, half);
    clip(half, |p| high - p[axis], clipped);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{polygon, scene_of, sphere};
    use crate::structure::bounds::box_with_room;

    const ROOM: f64 = 1e-12;

    /// Which of 4 × 4 × 4 cells with sides of 1 list a shape: i, j, k of each.
    fn cells_of(shape: &str, lists: Lists) -> Vec<[u32; 3]> {
        let cells = CellPlanes::new(&AxisBox::around([DVec3::ZERO, DVec3::splat(4.0)]), [4; 3]);
        let mut overlap = CellOverlap::new(&cells, lists, ROOM);
        let scene = scene_of(&[shape.to_string()]);
        let shape = &scene.primitives[0].shape;
        let around = box_with_room(shape).with_room(ROOM);
        let mut numbers = Vec::new();
        overlap.cells_of(shape, &around, &mut |number| numbers.push(number));
        numbers.sort_unstable();
        numbers
            .into_iter()
            .map(|number| cells.cell(number))
            .collect()
    }

    fn count(shape: &str) -> usize {
        cells_of(shape, Lists::Objects).len()
    }

    #[test]
    fn a_sphere_in_the_middle_reaches_into_the_cells_whose_closest_point_is_within_its_radius() {
        // closest points of the 64 cells around (2, 2, 2): 8 at 0, 24 at 1, 24 at √2, 8 at √3
        let of = |radius: f64| count(&sphere([2.0; 3], radius));
        let counts = [0.9, 1.1, 1.4, 1.45, 1.7, 1.75].map(of);
        assert_eq!(counts, [8, 32, 32, 56, 56, 64]);
        // at 1 it touches the planes
        assert_eq!(of(1.0), 32);
        assert_eq!(cells_of(&sphere([2.0; 3], 1.1), Lists::Boxes).len(), 64);
    }

    #[test]
    fn a_sphere_in_a_corner_reaches_into_the_cells_near_it() {
        // from (0.5, 0.5, 3.5) the cells beside are 0.5 away, those across an edge √½ = 0.707, across the corner √¾ = 0.866
        let of = |radius: f64| count(&sphere([0.5, 0.5, 3.5], radius));
        assert_eq!([0.4, 0.6, 0.8, 0.9].map(of), [1, 4, 7, 8]);
    }

    #[test]
    fn an_ellipsoid_reaches_as_far_as_its_half_axis_along_each_axis() {
        // 1.9 along y alone: the cells beside the four columns are too far across
        let upright = r#"{"ellipsoid":{"center":[2,2,2],"radii":[0.9,1.9,0.9]}}"#;
        assert_eq!(count(upright), 16);
        // (1/1.9)² + (1/1.2)² = 0.97 within, (1/1.9)² + (1/1.1)² = 1.10 outside
        let flat =
            |z: f64| format!(r#"{{"ellipsoid":{{"center":[2,2,2],"radii":[0.9,1.9,{z}]}}}}"#);
        assert_eq!([1.2, 1.1].map(|z| count(&flat(z))), [32, 24]);
    }

    #[test]
    fn a_box_is_listed_in_every_cell_it_touches_and_a_shape_in_one_cell_in_that() {
        let solid = r#"{"box":{"min":[0.5,1.5,2.5],"max":[2.5,2.5,2.75]}}"#;
        let expected = [
            [0, 1, 2],
            [1, 1, 2],
            [2, 1, 2],
            [0, 2, 2],
            [1, 2, 2],
            [2, 2, 2],
        ];
        assert_eq!(cells_of(solid, Lists::Objects), expected);
        assert_eq!(
            cells_of(&sphere([3.5, 0.5, 1.5], 0.25), Lists::Objects),
            [[3, 0, 1]]
        );
    }

    #[test]
    fn a_flat_triangle_reaches_into_the_cells_before_its_slanted_side() {
        // x + y ≤ 3.9 from (0.5, 0.5) on: 4, 3, 2 and 1 cells of each column
        let triangle = polygon(&[[0.5, 0.5, 1.5], [3.4, 0.5, 1.5], [0.5, 3.4, 1.5]]);
        let mut expected = Vec::new();
        for j in 0..4 {
            expected.extend((0..4 - j).map(|i| [i, j, 1]));
        }
        assert_eq!(cells_of(&triangle, Lists::Objects), expected);
        assert_eq!(cells_of(&triangle, Lists::Boxes).len(), 16);
    }

    #[test]
    fn an_upright_triangle_reaches_into_the_cells_below_its_slanted_side() {
        // z ≤ x − 0.2 in the plane y = 1.5: one cell of the first column, two of the second, and so on
        let triangle = polygon(&[[0.7, 1.5, 0.5], [3.5, 1.5, 0.5], [3.5, 1.5, 3.3]]);
        let mut expected = Vec::new();
        for k in 0..4 {
            expected.extend((k..4).map(|i| [i, 1, k]));
        }
        assert_eq!(cells_of(&triangle, Lists::Objects), expected);
        // the same across x: y from z + 0.2 on
        let across = polygon(&[[1.5, 0.7, 0.5], [1.5, 3.5, 0.5], [1.5, 3.5, 3.3]]);
        let mut expected = Vec::new();
        for k in 0..4 {
            expected.extend((k..4).map(|j| [1, j, k]));
        }
        assert_eq!(cells_of(&across, Lists::Objects), expected);
    }

    #[test]
    fn a_cone_reaches_into_the_cells_of_its_box_that_it_touches() {
        // a tip at (2, 2, 4) over a base of radius 1.9 at z = 0: in the top layer z ≥ 3 its radius is at most 0.475, in the
        // third 0.95, in the second 1.425, where a corner is √2 = 1.414 away
        let cone = r#"{"cone":{"base":[2,2,0],"base_radius":1.9,"apex":[2,2,4],"apex_radius":0}}"#;
        let found = cells_of(cone, Lists::Objects);
        let layers = [0, 1, 2, 3].map(|k| found.iter().filter(|cell| cell[2] == k).count());
        assert_eq!(layers, [16, 16, 4, 4]);
    }

    #[test]
    fn an_outline_is_cut_at_a_plane_in_the_order_of_its_corners() {
        let square = [
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 2.0],
            [4.0, 4.0, 2.0],
            [0.0, 4.0, 0.0],
        ]
        .map(DVec3::from);
        let mut left = Vec::new();
        clip(&square, |p| p.x - 1.0, &mut left);
        // a quarter of the way along the lower and three quarters along the upper edge
        let expected = [
            [1.0, 0.0, 0.5],
            [4.0, 0.0, 2.0],
            [4.0, 4.0, 2.0],
            [1.0, 4.0, 0.5],
        ];
        assert_eq!(left, expected.map(DVec3::from));
        let (mut half, mut clipped) = (Vec::new(), Vec::new());
        clip_between(&square, 0, [1.0, 3.0], &mut half, &mut clipped);
        let mut xs: Vec<_> = clipped.iter().map(|p| p.x).collect();
        xs.sort_by(f64::total_cmp);
        assert_eq!(xs, [1.0, 1.0, 3.0, 3.0]);
        assert_eq!(range(&clipped, 2, 0.25), Some([0.25, 1.75]));
        clip(&square, |p| p.x - 5.0, &mut left);
        assert_eq!(range(&left, 2, 0.25), None);
    }

    #[test]
    fn an_object_is_listed_beyond_a_plane_that_it_misses_by_less_than_its_room() {
        // 10⁻¹⁰ of its largest coordinate and what the grid adds: 3·10⁻¹⁰ of a ball around (2, 2, 2)
        let ball = |gap: f64| count(&sphere([2.0; 3], 1.0 - gap));
        assert_eq!([2e-10, 4e-10].map(ball), [32, 8]);
        // a small ball by its own room, not by a share of its radius: 1.3·10⁻¹⁰ in the row above the plane x = 1
        let small = |gap: f64| count(&sphere([1.1 + gap, 0.5, 0.5], 0.1));
        assert_eq!([1e-10, 1.5e-10].map(small), [2, 1]);
        // the tip of a cone below the plane z = 3, and above z = 1: 3.4·10⁻¹⁰ and 2.9·10⁻¹⁰
        let cone = |base: f64, tip: f64| {
            let text = format!(
                r#"{{"cone":{{"base":[2.5,2.5,{base:?}],"base_radius":0.4,"apex":[2.5,2.5,{tip:?}],"apex_radius":0}}}}"#
            );
            let cells = cells_of(&text, Lists::Objects);
            [cells[0][2], cells[cells.len() - 1][2]]
        };
        assert_eq!(
            [2e-10, 5e-10].map(|gap| cone(2.5, 3.0 - gap)),
            [[2, 3], [2, 2]]
        );
        assert_eq!(
            [2e-10, 5e-10].map(|gap| cone(1.5, 1.0 + gap)),
            [[0, 1], [1, 1]]
        );
        // a triangle above the plane z = 1, which reaches to 3.5
        let flat = |gap: f64| {
            let z = 1.0 + gap;
            let triangle = polygon(&[[0.5, 0.5, z], [3.5, 0.5, z], [3.5, 0.75, z]]);
            cells_of(&triangle, Lists::Objects)[0][2]
        };
        assert_eq!([2e-10, 5e-10].map(flat), [0, 1]);
        // across x and y, 3.4·10⁻¹⁰ of the larger coordinate
        let upright = |gap: f64| {
            let (x, y) = (1.0 + gap, 2.0 - gap);
            let triangle = polygon(&[[x, 1.5, 0.5], [x + 1.5, 1.5, 0.5], [x, y, 3.4]]);
            let cells = cells_of(&triangle, Lists::Objects);
            [0, 2].map(|row| cells.iter().any(|cell| cell[usize::from(row != 0)] == row))
        };
        assert_eq!([2e-10, 5e-10].map(upright), [[true, true], [false, false]]);
    }

    #[test]
    fn a_bent_polygon_is_listed_as_far_as_it_is_thick() {
        // a corner 4·10⁻⁶ higher: 64·10⁻⁶ thick
        let bent = |gap: f64| {
            let z = 1.0 + gap;
            let corners = [
                [0.5, 0.5, z],
                [1.5, 0.5, z],
                [1.5, 1.5, z + 4e-6],
                [0.5, 1.5, z],
            ];
            cells_of(&polygon(&corners), Lists::Objects)[0][2]
        };
        assert_eq!([60e-6, 68e-6].map(bent), [0, 1]);
    }
}
