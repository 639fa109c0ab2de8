//! A grid over a scene, small enough to be looked at, which notes the cells that are visited.

use std::cell::RefCell;
use std::fmt;

use crate::geometry::{AxisBox, Ray, TRange};
use crate::lesson::exercise::Watch;
use crate::scene::{Scene, Shape};
use crate::structure::CellPlanes;
use crate::tracer::simple::{Own, Parts};

/// More visits than any walk through such a grid needs.
const MOST_VISITS: usize = 1000;

/// A box cut into equal cells, with the objects of each.
pub struct Cells<'a> {
    scene: &'a Scene,
    planes: CellPlanes,
    watch: &'a dyn Watch,
    visited: RefCell<Vec<[u32; 3]>>,
}

impl fmt::Debug for Cells<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Cells")
            .field("resolution", &self.resolution())
            .finish_non_exhaustive()
    }
}

impl<'a> Cells<'a> {
    pub(in crate::lesson::exercise) fn new(
        scene: &'a Scene,
        around: &AxisBox,
        resolution: [u32; 3],
        watch: &'a dyn Watch,
    ) -> Self {
        Self {
            scene,
            planes: CellPlanes::new(around, resolution),
            watch,
            visited: RefCell::default(),
        }
    }

    /// How many cells there are along x, y and z.
    pub fn resolution(&self) -> [u32; 3] {
        self.planes.resolution()
    }

    /// The planes across an axis (0, 1, 2), rising: cell i lies between plane i and plane i + 1.
    pub fn planes(&self, axis: usize) -> &[f64] {
        self.planes.axis(axis)
    }

    /// The cell in which the ray is first; `None` if it passes by.
    pub fn first(&self, ray: &Ray) -> Option<[u32; 3]> {
        crate::structure::start(&self.planes, ray, TRange::FORWARD).map(|(cell, _)| cell)
    }

    /// Visits a cell: the objects on its list that the ray hits, by their numbers, each with its t, which may lie beyond the cell.
    ///
    /// # Panics
    /// A cell outside of the grid, or thousands of visits.
    pub fn visit(&self, cell: [u32; 3], ray: &Ray) -> Vec<(usize, f64)> {
        let resolution = self.resolution();
        let [i, j, k] = cell;
        self.watch.place(&format!("cell ({i}, {j}, {k})"));
        let is_inside = (0..3).all(|axis| cell[axis] < resolution[axis]);
        let [nx, ny, nz] = resolution;
        assert!(
            is_inside,
            "cell ({i}, {j}, {k}) is outside of the grid of {nx} × {ny} × {nz} cells"
        );
        let mut visited = self.visited.borrow_mut();
        visited.push(cell);
        assert!(
            visited.len() <= MOST_VISITS,
            "{MOST_VISITS} visits of {nx} × {ny} × {nz} cells, the last one of cell ({i}, {j}, {k}): the walk does not end"
        );
        let objects = self.scene.primitives.iter().enumerate();
        let hits = objects.filter(|(_, object)| self.lists(cell, &object.shape));
        let hits = hits
            .filter_map(|(number, object)| Some((number, Own.hit(object, ray, TRange::FORWARD)?)));
        hits.collect()
    }

    /// Does the box around the shape touch the cell?
    fn lists(&self, cell: [u32; 3], shape: &Shape) -> bool {
        let Shape::Sphere(sphere) = shape else {
            return true;
        };
        (0..3).all(|axis| {
            let ends = [-1.0, 1.0].map(|sign| sphere.center[axis] + sign * sphere.radius);
            let [first, last] = self.planes.touched(axis, ends);
            first <= cell[axis] && cell[axis] <= last
        })
    }

    /// Where the ray leaves a cell.
    pub(in crate::lesson::exercise) fn leaves(&self, cell: [u32; 3], ray: &Ray) -> f64 {
        let far = (0..3).map(|axis| {
            let direction = ray.direction[axis];
            let up = u32::from(0.0 < direction);
            let plane = self.planes(axis)[(cell[axis] + up) as usize];
            if direction == 0.0 {
                f64::INFINITY
            } else {
                (plane - ray.origin[axis]) / direction
            }
        });
        far.fold(f64::INFINITY, f64::min)
    }

    pub(in crate::lesson::exercise) fn visited(&self) -> Vec<[u32; 3]> {
        self.visited.borrow().clone()
    }
}
