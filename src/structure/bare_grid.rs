//! A grid as it is around its objects: without the room for rounding by which its box is larger.
//!
//! The planes of a [`Grid`](crate::structure::Grid) are those that decide. Words and figures show where the planes are
//! that cut the box of the objects into as many cells; to build that takes no lists.

use glam::DVec3;

use crate::geometry::Ray;
use crate::scene::Scene;
use crate::structure::{CellStep, extent};

/// The box of the objects, cut into cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BareGrid {
    pub(crate) min: DVec3,
    pub(crate) max: DVec3,
    resolution: [u32; 3],
}

impl BareGrid {
    /// Around the objects of a scene; a point without objects.
    pub(crate) fn around(scene: &Scene, resolution: [u32; 3]) -> Self {
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for primitive in &scene.primitives {
            let [x, y, z] = DVec3::AXES.map(|axis| extent(&primitive.shape, axis));
            min = min.min(DVec3::new(x[0], y[0], z[0]));
            max = max.max(DVec3::new(x[1], y[1], z[1]));
        }
        if scene.primitives.is_empty() {
            (min, max) = (DVec3::ZERO, DVec3::ZERO);
        }
        Self {
            min,
            max,
            resolution,
        }
    }

    /// Where a ray meets a plane across an axis: t = (pᵢ − o)/Δ, and pᵢ = min + (max − min)·i/n.
    fn t(&self, ray: &Ray, axis: usize, plane: u32) -> f64 {
        let share = f64::from(plane) / f64::from(self.resolution[axis]);
        let (min, max) = (self.min[axis], self.max[axis]);
        (min + (max - min) * share - ray.origin[axis]) / ray.direction[axis]
    }

    /// Where the ray is inside the box; `None` if it passes by.
    pub(crate) fn inside(&self, ray: &Ray) -> Option<[f64; 2]> {
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            if ray.direction[axis] == 0.0 {
                let at = ray.origin[axis];
                if at < self.min[axis] || self.max[axis] < at {
                    return None;
                }
                continue;
            }
            let ends = [0, self.resolution[axis]].map(|plane| self.t(ray, axis, plane));
            near = near.max(ends[0].min(ends[1]));
            far = far.min(ends[0].max(ends[1]));
        }
        (near <= far && near.is_finite() && far.is_finite()).then_some([near, far])
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
    use std::path::Path;

    use super::*;
    use crate::geometry::TRange;
    use crate::scene::load_bytes;
    use crate::structure::{Grid, GridOptions};

    #[test]
    fn cells_are_told_by_planes_through_whole_numbers() {
        let json = r#"{"camera":{"look_at":{"cop":[9,1,1],"target":[0,1,1],"up":[0,1,0],"fov_degrees":40},
            "pixels":[2,2]},"materials":{"m":{"colour":[1,1,1]}},
            "objects":[{"name":"A","material":"m","shape":{"box":{"min":[0,0,0],"max":[4,2,2]}}}]}"#;
        let loaded = load_bytes("scene.json", json.as_bytes(), Path::new("."));
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
        assert!(grid.min().x < 0.0 && 4.0 < grid.max().x);
    }
}
