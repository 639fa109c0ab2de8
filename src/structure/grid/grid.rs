//! The uniform grid: which objects lie in which cell (slides, "Spatial Partitioning", Figs 15.61 and 15.62).
//!
//! The scene's box is cut into equal cells, and each cell lists the objects that reach into it. A ray is then
//! tested against the objects of those cells alone that it passes through ([`Grid::walk`]).
//!
//! **Room for rounding.** A computed hit may lie off its object's exact surface, and the ray that has it pass the
//! object by. So an object is listed with a little room around it ([`Grid::new`]): in every cell that the
//! object with this room touches. The grid's box has more room still, so that no object touches its outer planes.

use crate::geometry::{AxisBox, Ray, TRange};
use crate::parallel;
use crate::scene::{PrimitiveId, Scene, Shape};
use crate::structure::bounds::box_with_room;
use crate::structure::grid::cell_lists::CellLists;
use crate::structure::grid::cell_overlap::CellOverlap;
use crate::structure::grid::cell_planes::CellPlanes;
use crate::structure::grid::grid_options::{GridOptions, Lists};
use crate::structure::grid::grid_resolution::resolution;
use crate::structure::{GridError, GridWalk};
use glam::DVec3;

/// Does an object lie in a cell as a whole?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Share {
    /// All of it.
    #[default]
    Whole,
    /// A part of it.
    Part,
}

/// An object put into a cell's list.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AssignStep {
    /// The primitive that was put into the list of the cell.
    pub object: PrimitiveId,
    /// i, j and k.
    pub cell: [u32; 3],
    /// Wholly or in part.
    pub share: Share,
}

/// A grid over a scene: the cells, and what lies in each.
#[doc(alias = "uniform grid")]
#[doc(alias = "spatial partitioning")]
#[doc(alias = "voxel grid")]
#[derive(Clone, Debug)]
pub struct Grid {
    cells: CellPlanes,
    lists: CellLists,
    by: Lists,
    room: f64,
}

impl Grid {
    /// Builds the grid over a scene. A scene without objects has one without cells.
    ///
    /// # Errors
    /// A density that is not above 0, a resolution of 0, or a grid that would take too much memory.
    pub fn new(scene: &Scene, options: &GridOptions) -> Result<Self, GridError> {
        let room = room(scene);
        let boxes: Vec<AxisBox> = parallel::map(scene.primitives.len(), |object| {
            around(&scene.primitives[object].shape, room)
        });
        let objects = boxes.len();
        let cells = match around_all(&boxes, room) {
            None => {
                // what makes no sense is refused in any scene
                resolution(&AxisBox::around([DVec3::ZERO, DVec3::ONE]), 1, options)?;
                CellPlanes::default()
            }
            Some(all) => CellPlanes::new(&all, resolution(&all, objects, options)?),
        };
        let mut overlap = CellOverlap::new(&cells, options.lists, room);
        let lists = CellLists::filled(cells.count(), objects, |object, put| {
            overlap.cells_of(&scene.primitives[object].shape, &boxes[object], put);
        })
        .ok_or(GridError::TooManyEntries {
            resolution: cells.resolution(),
        })?;
        Ok(Self {
            cells,
            lists,
            by: options.lists,
            room,
        })
    }

    /// The cells that a ray pierces in its range, in order.
    #[inline]
    pub fn walk(&self, ray: &Ray, range: TRange) -> GridWalk<'_> {
        GridWalk::new(&self.cells, ray, range)
    }

    /// Where the ray is inside the grid's box: from the largest near to the smallest far.
    ///
    /// `None` if it passes by, or has no direction; and in a scene without objects.
    pub fn inside(&self, ray: &Ray) -> Option<[f64; 2]> {
        if self.cells.is_empty() {
            return None;
        }
        self.around().inside(ray)
    }

    /// Cells along x, y and z; zeros in a scene without objects.
    #[inline]
    pub fn resolution(&self) -> [u32; 3] {
        self.cells.resolution()
    }

    /// The planes across x (0), y (1) or z (2), rising: one more than cells along that axis.
    ///
    /// These values are the grid: every decision about a cell is made by them.
    pub fn planes(&self, axis: usize) -> &[f64] {
        self.cells.axis(axis)
    }

    /// The box that is cut into cells; the point 0 in a scene without objects.
    pub fn around(&self) -> AxisBox {
        let outer = |axis| match *self.planes(axis) {
            [first, .., last] => [first, last],
            _ => [0.0, 0.0],
        };
        let [x, y, z] = [0, 1, 2].map(outer);
        AxisBox {
            min: DVec3::new(x[0], y[0], z[0]),
            max: DVec3::new(x[1], y[1], z[1]),
        }
    }

    /// The objects listed in cell (i, j, k), the first in the scene first.
    ///
    /// None beyond the grid.
    pub fn cell_objects(&self, cell: [u32; 3]) -> &[PrimitiveId] {
        let inside = cell.iter().zip(self.resolution()).all(|(&at, n)| at < n);
        if !inside {
            return &[];
        }
        self.lists.of(self.cells.number(cell))
    }

    /// The planes between the cells.
    #[inline]
    pub(crate) fn cells(&self) -> &CellPlanes {
        &self.cells
    }

    /// The lists of all cells.
    #[inline]
    pub(crate) fn lists(&self) -> &CellLists {
        &self.lists
    }

    /// The cell that lists the most objects, and how many; the first of equals. `None` without cells.
    pub fn fullest_cell(&self) -> Option<([u32; 3], usize)> {
        let lengths =
            (0..self.cells.count()).map(|number| (number, self.lists.range(number).len()));
        let longer = |a: (usize, usize), b: (usize, usize)| if a.1 < b.1 { b } else { a };
        let (number, length) = lengths.reduce(longer)?;
        Some((self.cells.cell(number), length))
    }

    /// How many entries all lists have together.
    pub fn lists_total(&self) -> usize {
        self.lists.total()
    }

    /// How the lists came about: object by object, in the order of the scene, each with its cells in the order
    /// of their numbers, x first (Fig. 15.61). The scene is the one that the grid was built over.
    pub fn assignments<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = AssignStep> + 'a {
        let mut overlap = CellOverlap::new(&self.cells, self.by, self.room);
        let primitives = (0..).map(PrimitiveId).zip(&scene.primitives);
        primitives.flat_map(move |(object, primitive)| {
            let shape = &primitive.shape;
            let around = around(shape, self.room);
            let mut numbers = Vec::new();
            overlap.cells_of(shape, &around, &mut |number| numbers.push(number));
            numbers.sort_unstable();
            let share = if overlap.is_in_one_cell(&around) {
                Share::Whole
            } else {
                Share::Part
            };
            numbers.into_iter().map(move |number| AssignStep {
                object,
                cell: self.cells.cell(number),
                share,
            })
        })
    }

    /// How much memory the planes and the lists take, in bytes.
    pub fn bytes(&self) -> usize {
        self.cells.bytes() + self.lists.bytes()
    }
}

/// The box around a shape, with the room of every object.
fn around(shape: &Shape, room: f64) -> AxisBox {
    box_with_room(shape).with_room(room)
}

/// The room of every object, besides [`box_with_room`]'s share of its own size: a share of the largest coordinate of the
/// scene and of the camera.
///
/// A ray starts at the camera or in the scene, and the rounding of what it hits grows with the coordinates
/// of its origin: some 10⁻¹⁵ of them, a hundredfold where it hits a surface flatly.
fn room(scene: &Scene) -> f64 {
    const SHARE: f64 = 1e-11;
    let reaches = scene.primitives.iter().map(|of| of.shape.reach());
    let reach = reaches.fold(scene.camera.cop.abs().max_element(), f64::max);
    SHARE * reach
}

/// The box around all objects, with so much more room that none touches its planes.
fn around_all(boxes: &[AxisBox], room: f64) -> Option<AxisBox> {
    /// Of the box's size; with ten times the room of an object.
    const SHARE: f64 = 1e-9;
    if boxes.is_empty() {
        return None;
    }
    let join = |sum: AxisBox, of: &AxisBox| sum.union(of);
    let all = boxes.iter().fold(AxisBox::EMPTY, join);
    Some(all.with_room(SHARE * all.size().max_element() + 10.0 * room))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{cube_at, scene_of, solid, sphere};

    fn grid(scene: &Scene, resolution: [u32; 3]) -> Grid {
        let options = GridOptions {
            resolution: Some(resolution),
            ..GridOptions::default()
        };
        Grid::new(scene, &options).unwrap()
    }

    /// The box from (1, 2, 3) to (5, 4, 9).
    fn off_the_origin() -> Scene {
        scene_of(&[solid([1.0, 2.0, 3.0], [5.0, 4.0, 9.0])])
    }

    #[test]
    fn the_box_of_the_grid_is_that_of_the_objects_and_their_room_and_a_hair() {
        // the eye is in the origin, and 9 is the largest coordinate: each object has 10⁻¹⁰ and 10⁻¹¹ of it as room, the grid
        // 10⁻⁹ of its length of 6 and ten times the second
        let found = grid(&off_the_origin(), [4, 2, 3]);
        let wider = 0.9e-9 + 0.09e-9 + 6e-9 + 0.9e-9;
        let min = DVec3::new(1.0, 2.0, 3.0) - wider;
        let max = DVec3::new(5.0, 4.0, 9.0) + wider;
        // roundings of coordinates up to 9, and of the room itself
        let off = (found.around().min - min)
            .abs()
            .max((found.around().max - max).abs());
        assert!(off.max_element() <= 1e-14, "{off}");
    }

    #[test]
    fn an_eye_far_away_widens_objects_and_grid() {
        let mut scene = off_the_origin();
        scene.camera.cop = DVec3::new(0.0, -1000.0, 0.0);
        // 10⁻¹¹ of 1000 for each object and ten times that for the grid
        let found = grid(&scene, [4, 2, 3]);
        let wider = 0.9e-9 + 10e-9 + 6e-9 + 100e-9;
        let off = (found.around().min - (DVec3::new(1.0, 2.0, 3.0) - wider)).abs();
        assert!(off.max_element() <= 1e-14, "{off}");
    }

    #[test]
    fn a_ray_is_inside_from_the_largest_near_to_the_smallest_far() {
        let grid = grid(&off_the_origin(), [4, 2, 3]);
        #[track_caller]
        fn check(grid: &Grid, origin: [f64; 3], direction: [f64; 3], expected: Option<[f64; 2]>) {
            let found = grid.inside(&Ray::new(origin.into(), direction.into()));
            let near = |(found, expected): ([f64; 2], [f64; 2])| {
                // the grid is some 8·10⁻⁹ wider than the objects
                (0..2).all(|end| (found[end] - expected[end]).abs() <= 1e-8)
            };
            let same = found.is_some() == expected.is_some();
            assert!(same && found.zip(expected).is_none_or(near), "{found:?}");
        }
        // x = 1 … 5 at t = 1 … 5, y = 2 … 4 at 2 … 4, z = 3 … 9 at ¼ … 3¼
        let along = [1.0, 1.0, 2.0];
        check(&grid, [0.0, 0.0, 2.5], along, Some([2.0, 3.25]));
        check(
            &grid,
            [6.0, 6.0, 9.5],
            [-1.0, -1.0, -2.0],
            Some([2.0, 3.25]),
        );
        check(&grid, [0.0, 3.5, 2.5], along, None);
        // parallel to y: from below to above
        for (y, expected) in [(1.9, None), (3.0, Some([1.0, 5.0])), (4.1, None)] {
            check(&grid, [0.0, y, 6.0], [1.0, 0.0, 0.0], expected);
            check(&grid, [0.0, y, 6.0], [1.0, -0.0, 0.0], expected);
        }
        check(&grid, [2.0, 3.0, 6.0], [0.0; 3], None);
    }

    #[test]
    fn a_ray_in_an_outer_plane_is_inside() {
        let grid = grid(&off_the_origin(), [4, 2, 3]);
        let inside = |y: f64| {
            let ray = Ray::new(DVec3::new(0.0, y, 6.0), DVec3::X);
            grid.inside(&ray).is_some()
        };
        let [low, high] = grid.around().along(1);
        let places = [low.next_down(), low, high, high.next_up()];
        assert_eq!(places.map(inside), [false, true, true, false]);
    }

    #[test]
    fn the_fullest_cell_lists_the_most_objects_and_is_the_first_of_equals() {
        // ten cells of 1 along x; with their room cubes from a whole number on reach into the cells beside
        let at = |x: f64| solid([x + 0.2, 0.2, 0.2], [x + 0.8, 0.8, 0.8]);
        let ends = || [cube_at(0.0), cube_at(9.0)];
        let with = |places: &[f64]| {
            let inner = places.iter().map(|&x| at(x));
            let shapes: Vec<_> = ends().into_iter().chain(inner).collect();
            grid(&scene_of(&shapes), [10, 1, 1]).fullest_cell()
        };
        assert_eq!(with(&[3.0, 6.0, 6.0]), Some(([6, 0, 0], 2)));
        assert_eq!(with(&[6.0, 6.0, 3.0, 3.0]), Some(([3, 0, 0], 2)));
        let empty = Grid::new(&scene_of(&[]), &GridOptions::default()).unwrap();
        assert_eq!(empty.fullest_cell(), None);
        assert_eq!(empty.around(), AxisBox::around([DVec3::ZERO]));
        assert_eq!(empty.inside(&Ray::new(DVec3::ZERO, DVec3::X)), None);
    }

    #[test]
    fn an_object_lies_in_its_cell_wholly_or_in_part_in_several() {
        let shapes = [
            solid([0.0, 0.0, 0.0], [4.0, 2.0, 2.0]),
            sphere([2.5, 1.5, 0.5], 0.25),
        ];
        let scene = scene_of(&shapes);
        let grid = grid(&scene, [4, 2, 2]);
        let steps: Vec<_> = grid.assignments(&scene).collect();
        assert_eq!(steps.len(), 17);
        assert_eq!(grid.lists_total(), 17);
        let part = |step: &AssignStep| step.share == Share::Part && step.object == PrimitiveId(0);
        assert!(steps[..16].iter().all(part));
        // x first, then y, then z
        assert_eq!(
            [0, 3, 4, 8].map(|at| steps[at].cell),
            [[0, 0, 0], [3, 0, 0], [0, 1, 0], [0, 0, 1]]
        );
        let whole = AssignStep {
            object: PrimitiveId(1),
            cell: [2, 1, 0],
            share: Share::Whole,
        };
        assert_eq!(steps[16], whole);
        assert_eq!(
            grid.cell_objects([2, 1, 0]),
            [PrimitiveId(0), PrimitiveId(1)]
        );
        // beyond the grid there is nothing
        for cell in [[4, 0, 0], [0, 2, 0], [0, 0, 2]] {
            assert!(grid.cell_objects(cell).is_empty());
        }
        // 5 + 3 + 3 planes of 8 bytes, 17 starts and 17 entries of 4
        assert_eq!(grid.bytes(), 88 + 68 + 68);
    }
}
