//! A grid as it is around its objects: without the room for rounding by which its box is larger.
//!
//! The planes of a [`Grid`](crate::structure::Grid) are those that decide. Words and figures show where the planes are
//! that cut the box of the objects into as many cells; to build that takes no lists.

use glam::DVec3;

use crate::geometry::{AxisBox, Ray};
use crate::scene::Scene;
use crate::structure::CellStep;
use crate::structure::bounds::box_around;

/// The box of the objects, cut into cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BareGrid {
    pub(crate) around: AxisBox,
    resolution: [u32; 3],
}

impl BareGrid {
    /// Around the objects of a scene; a point without objects.
    pub(crate) fn around(scene: &Scene, resolution: [u32; 3]) -> Self {
        let boxes = scene.primitives.iter().map(|of| box_around(&of.shape));
        let around = boxes.reduce(|a, b| a.union(&b));
        Self {
            around: around.unwrap_or(AxisBox::around([DVec3::ZERO])),
            resolution,
        }
    }

    /// Where a ray hits a plane across an axis: t = (pᵢ − o)/Δ, and pᵢ = min + (max − min)·i/n.
    fn t(&self, ray: &Ray, axis: usize, plane: u32) -> f64 {
        let share = f64::from(plane) / f64::from(self.resolution[axis]);
        let [min, max] = self.around.along(axis);
        (min + (max - min) * share - ray.origin[axis]) / ray.direction[axis]
    }

    /// Where the ray is inside the box; `None` if it passes by.
    pub(crate) fn inside(&self, ray: &Ray) -> Option<[f64; 2]> {
        self.around.inside(ray)
    }

    /// A step of the walk by these planes, for a ray that counts from `begins` on.
    pub(crate) fn step(&self, ray: &Ray, begins: f64, step: &CellStep) -> CellStep {
        let mut bare = CellStep {
            t_in: begins,
            t_out: f64::INFINITY,
            ..*step
        };
        for axis in 0..3 {
            let (direction, at) = (ray.direction[axis], step.cell[axis]);
            if direction == 0.0 || !step.next[axis].is_finite() {
                continue;
            }
            let [behind, next] = if direction < 0.0 {
                [at + 1, at]
            } else {
                [at, at + 1]
            };
            bare.t_in = bare.t_in.max(self.t(ray, axis, behind));
            bare.next[axis] = self.t(ray, axis, next);
            bare.t_out = bare.t_out.min(bare.next[axis]);
        }
        bare
    }
}

#[cfg(test)]
mod tests {

    use super::*;
    use crate::geometry::TRange;
    use crate::scene::{NoFiles, load_bytes};
    use crate::structure::{Grid, GridOptions};

    #[test]
    fn cells_are_told_by_planes_through_whole_numbers() {
        let json = r#"{"camera":{"look_at":{"cop":[9,1,1],"target":[0,1,1],"up":[0,1,0],"fov_degrees":40},
            "pixels":[2,2]},"materials":{"m":{"colour":[1,1,1]}},
            "objects":[{"name":"A","material":"m","shape":{"box":{"min":[0,0,0],"max":[4,2,2]}}}]}"#;
        let loaded = load_bytes("scene.json", json.as_bytes(), &NoFiles);
        let scene = loaded.unwrap().build().unwrap();
        let options = GridOptions {
            resolution: Some([4, 2, 2]),
            ..GridOptions::default()
        };
        let grid = Grid::new(&scene, &options).unwrap();
        let bare = BareGrid::around(&scene, grid.resolution());
        // from the face x = 4 downwards: x = 4 − t, and y = ½ + t/5 is 1 at t = 2½
        let ray = Ray::new(DVec3::new(4.0, 0.5, 0.5), DVec3::new(-1.0, 0.2, 0.0));
        assert_eq!(bare.inside(&ray), Some([0.0, 4.0]));
        let steps = grid.walk(&ray, TRange::FORWARD);
        let steps: Vec<_> = steps.map(|step| bare.step(&ray, 0.0, &step)).collect();
        let told = steps.iter().map(|step| (step.cell, step.t_in, step.t_out));
        let expected = [
            ([3, 0, 0], 0.0, 1.0),
            ([2, 0, 0], 1.0, 2.0),
            ([1, 0, 0], 2.0, 2.5),
            ([1, 1, 0], 2.5, 3.0),
            ([0, 1, 0], 3.0, 4.0),
        ];
        assert_eq!(told.collect::<Vec<_>>(), expected);
        assert_eq!(steps[0].next, [1.0, 2.5, f64::INFINITY]);
        // the grid's own planes lie a little further out
        let AxisBox { min, max } = grid.around();
        assert!(min.x < 0.0 && 4.0 < max.x);
    }

    /// A box from (1, 2, 3) to (5, 4, 9) in 4 × 2 × 3 cells: planes at 1 … 5, at 2, 3, 4 and at 3, 5, 7, 9.
    fn off_the_origin() -> BareGrid {
        use crate::scene::small_scene::{scene_of, solid};
        let scene = scene_of(&[solid([1.0, 2.0, 3.0], [5.0, 4.0, 9.0])]);
        BareGrid::around(&scene, [4, 2, 3])
    }

    #[test]
    fn the_bare_box_is_that_of_the_objects_and_a_point_without_any() {
        use crate::scene::small_scene::{cube_at, scene_of, sphere};
        let scene = scene_of(&[cube_at(3.0), sphere([1.0, 5.0, 2.0], 4.0)]);
        let grid = BareGrid::around(&scene, [1; 3]);
        let AxisBox { min, max } = grid.around;
        assert_eq!(
            (min, max),
            (DVec3::new(-3.0, 0.0, -2.0), DVec3::new(5.0, 9.0, 6.0))
        );
        let grid = BareGrid::around(&scene_of(&[]), [1; 3]);
        assert_eq!(grid.around, AxisBox::around([DVec3::ZERO]));
    }

    #[test]
    fn a_ray_is_inside_from_the_largest_near_to_the_smallest_far() {
        let grid = off_the_origin();
        let inside = |origin: [f64; 3], direction: [f64; 3]| {
            grid.inside(&Ray::new(origin.into(), direction.into()))
        };
        // x = 1 … 5 at t = 1 … 5, y = 2 … 4 at 2 … 4, z = 3 … 9 at ¼ … 3¼
        let along = [1.0, 1.0, 2.0];
        assert_eq!(inside([0.0, 0.0, 2.5], along), Some([2.0, 3.25]));
        assert_eq!(
            inside([6.0, 6.0, 9.5], [-1.0, -1.0, -2.0]),
            Some([2.0, 3.25])
        );
        // x from 1, y up to 4: crossed, and touching an edge in one t
        assert_eq!(inside([0.0, 3.5, 2.5], along), None);
        assert_eq!(inside([0.0, 3.0, 2.5], along), Some([1.0, 1.0]));
    }

    #[test]
    fn a_parallel_ray_is_inside_between_the_planes_and_in_them() {
        let grid = off_the_origin();
        let crosses = |y: f64| {
            let ray = Ray::new(DVec3::new(0.0, y, 6.0), DVec3::X);
            grid.inside(&ray).is_some()
        };
        assert_eq!(
            [1.9, 2.0, 3.0, 4.0, 4.1].map(crosses),
            [false, true, true, true, false]
        );
        // without a direction there is no t
        assert_eq!(
            grid.inside(&Ray::new(DVec3::new(2.0, 3.0, 6.0), DVec3::ZERO)),
            None
        );
    }

    #[test]
    fn a_step_begins_at_the_planes_behind_and_ends_at_the_next_ones() {
        use crate::structure::Across;
        let grid = off_the_origin();
        // in the cell (2, 0, 1): x from 3 to 4, y from 2 to 3, z from 5 to 7
        let step = CellStep {
            cell: [2, 0, 1],
            t_in: 0.0,
            t_out: 9.0,
            next: [9.0; 3],
            across: Across::X,
        };
        let up = Ray::new(DVec3::new(2.5, 2.5, 5.5), DVec3::new(1.0, 0.25, 0.5));
        let expected = CellStep {
            t_in: 0.5,
            t_out: 1.5,
            next: [1.5, 2.0, 3.0],
            ..step
        };
        assert_eq!(grid.step(&up, 0.0, &step), expected);
        // a range that begins inside the cell
        let later = CellStep {
            t_in: 0.75,
            ..expected
        };
        assert_eq!(grid.step(&up, 0.75, &step), later);
        let down = Ray::new(DVec3::new(4.5, 3.25, 7.5), DVec3::new(-1.0, -0.25, -0.5));
        let expected = CellStep {
            t_in: 1.0,
            t_out: 1.5,
            next: [1.5, 5.0, 5.0],
            ..step
        };
        assert_eq!(grid.step(&down, 0.0, &step), expected);
        // along x alone: the others have no next plane
        let level = Ray::new(DVec3::new(2.5, 2.5, 5.5), DVec3::X);
        let walked = CellStep {
            next: [9.0, f64::INFINITY, f64::INFINITY],
            ..step
        };
        let expected = CellStep {
            t_in: 0.5,
            t_out: 1.5,
            next: [1.5, f64::INFINITY, f64::INFINITY],
            ..walked
        };
        assert_eq!(grid.step(&level, 0.0, &walked), expected);
    }
}
