//! The uniform grid: only the objects in the cells along the ray (slides, "Spatial Partitioning").
//!
//! "As soon as a partition is found in which there is an intersection, no more partitions need to be inspected"
//! holds only if the intersection lies *inside* that partition (erratum 6, Fig. 15.62): an object on this cell's
//! list may be hit in a later cell, with a nearer object in between. Such a hit is kept, and the walk goes
//! on until it has passed it.
//!
//! **Mailboxes.** An object in several cells is on the list of each. A ray that passes through them tests it in the
//! first and leaves a stamp in the object's mailbox; the stamp says in the others that it is done (B. Arnaldi, T. Priol
//! and K. Bouatouch 1987; J. Amanatides and A. Woo 1987). Here the stamped objects are a set.

use std::collections::HashSet;
use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::{Search, Strategy, test_primitive};
use crate::structure::{CellStep, Grid, GridError, GridOptions};
use crate::trace::{CellVisit, Event, GridEnter, GridExit, HitOutsideCell, Recorder, WalkEnd};

/// Tests the objects of the cells that a ray pierces, cell by cell.
#[derive(Clone, Debug)]
pub struct UniformGrid<'a> {
    pub(super) scene: &'a Scene,
    pub(super) grid: Grid,
    pub(super) mailboxes: bool,
}

/// Of t, for the error of an object's own: a computed root is good to 10⁻¹⁰ of itself. What error it has
/// beyond that, where t is small beside the coordinates, lies within the room around each object in the lists.
const TOLERANCE: f64 = 1e-9;

/// The range in which cells are visited: a little longer than that of the hits.
pub(super) fn walked(range: TRange) -> TRange {
    TRange {
        min: range.min * (1.0 - TOLERANCE),
        max: range.max * (1.0 + TOLERANCE),
    }
}

/// Does a nearest hit lie before the end of a cell, so that no later cell can hold a nearer one?
///
/// Equal t does not end the walk: of two such hits the object first in the scene wins.
pub(crate) fn is_passed(nearest: f64, t_out: f64) -> bool {
    nearest * (1.0 + TOLERANCE) < t_out
}

impl<'a> UniformGrid<'a> {
    /// Builds the grid over a scene.
    ///
    /// # Errors
    /// Options that make no sense, or a grid that would take too much memory.
    pub fn new(scene: &'a Scene, options: &GridOptions) -> Result<Self, GridError> {
        Ok(Self {
            scene,
            grid: Grid::new(scene, options)?,
            mailboxes: options.mailboxes,
        })
    }

    /// The grid that is walked.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Tests the objects on a cell's list, unless they have a stamp of this ray.
    fn test_listed<R: Recorder>(
        &self,
        cell: &CellStep,
        stamped: &mut HashSet<PrimitiveId>,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        for &object in self.grid.cell_objects(cell.cell) {
            recorder.note(|| Event::Listed { object });
            if self.mailboxes && !stamped.insert(object) {
                recorder.note(|| Event::Mailbox { object });
                continue;
            }
            let primitive = self.scene.primitive(object);
            let Some(t) = test_primitive(object, primitive, ray, search.range(), recorder) else {
                continue;
            };
            let offered = search.offer(object, t, recorder);
            let t_out = cell.t_out;
            if t_out < t {
                recorder.note(|| Event::HitOutsideCell(HitOutsideCell { object, t, t_out }));
            }
            offered?;
        }
        ControlFlow::Continue(())
    }
}

impl Strategy for UniformGrid<'_> {
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let range = search.range();
        let walk = self.grid.walk(ray, walked(range));
        recorder.note(|| {
            Event::GridEnter(GridEnter {
                around: self.grid.around(),
                resolution: self.grid.resolution(),
                inside: self.grid.inside(ray),
                cell: walk.cell(),
            })
        });
        let mut stamped = HashSet::new();
        let (mut cells, mut end) = (0, WalkEnd::Outside);
        let mut found = ControlFlow::Continue(());
        for step in walk {
            cells += 1;
            end = WalkEnd::Left;
            let listed = self.grid.cell_objects(step.cell).len() as u32;
            recorder.note(|| Event::Cell(CellVisit { step, listed }));
            found = self.test_listed(&step, &mut stamped, ray, search, recorder);
            let nearest = search.range().max;
            if found.is_break() || (nearest < range.max && is_passed(nearest, step.t_out)) {
                end = WalkEnd::HitInCell;
                break;
            }
        }
        recorder.note(|| Event::GridExit(GridExit { end, cells }));
        found
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        if R::ENABLED {
            for assignment in self.grid.assignments(self.scene) {
                recorder.note(|| Event::Assign(assignment));
            }
        }
    }

    fn bytes(&self) -> usize {
        self.grid.bytes()
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{cube_at, polygon, scene_of, solid};
    use crate::strategy::noted::noted;

    fn options(resolution: [u32; 3], mailboxes: bool) -> GridOptions {
        GridOptions {
            resolution: Some(resolution),
            mailboxes,
            ..GridOptions::default()
        }
    }

    #[test]
    fn cells_are_visited_a_billionth_before_the_range_and_behind_it() {
        let range = walked(TRange { min: 2.0, max: 4.0 });
        assert_eq!(
            (range.min, range.max),
            (2.0 * (1.0 - 1e-9), 4.0 * (1.0 + 1e-9))
        );
    }

    #[test]
    fn a_hit_is_passed_from_a_billionth_of_t_on() {
        assert!(is_passed(2.0, 2.1));
        assert!(!is_passed(2.0, 2.0));
        assert!(!is_passed(2.0, 2.0 + 1.9e-9));
        assert!(is_passed(2.0, 2.0 + 2.1e-9));
        assert!(!is_passed(2.0, 1.9));
    }

    /// A wall from (0.5, 0, 0) to (3.5, 2, 0), slanted through four cells in a row, and cubes that hold the grid from 0 to 4.
    fn slanted_wall() -> Scene {
        let wall = [
            [0.5, 0.1, 0.1],
            [3.5, 1.9, 0.1],
            [3.5, 1.9, 1.9],
            [0.5, 0.1, 1.9],
        ];
        let ends = [
            solid([0.0, 1.5, 0.0], [0.25, 2.0, 2.0]),
            solid([3.75, 0.0, 0.0], [4.0, 2.0, 2.0]),
        ];
        scene_of(&[polygon(&wall), ends[0].clone(), ends[1].clone()])
    }

    #[test]
    fn a_hit_in_a_later_cell_is_kept_and_its_mailbox_spares_the_test_there() {
        let scene = slanted_wall();
        // y = 0.1 + 0.6(x − 0.5) is 1.2 at x = 2⅓: the hit is in the third cell
        let ray = Ray::new(DVec3::new(-1.0, 1.2, 1.0), DVec3::X);
        let grid = UniformGrid::new(&scene, &options([4, 1, 1], true)).unwrap();
        let (events, hit) = noted(&grid, &ray);
        let hit = hit.unwrap();
        assert_eq!(hit.object, PrimitiveId(0));
        assert!((hit.t - (1.0 + 0.5 + 1.1 / 0.6)).abs() <= 1e-14, "{hit:?}");
        let told: Vec<String> = events
            .iter()
            .filter_map(|event| match event {
                Event::GridEnter(enter) => Some(format!("enter {:?}", enter.cell)),
                Event::Cell(cell) => Some(format!("cell {} of {}", cell.step.cell[0], cell.listed)),
                Event::Listed { object } => Some(format!("listed {}", object.0)),
                Event::Mailbox { object } => Some(format!("mailbox {}", object.0)),
                Event::HitOutsideCell(of) => Some(format!("hit outside {:.6}", of.t_out)),
                Event::GridExit(exit) => Some(format!("{:?} after {}", exit.end, exit.cells)),
                _ => None,
            })
            .collect();
        let expected = [
            "enter Some([0, 0, 0])",
            "cell 0 of 2",
            "listed 0",
            "hit outside 2.000000",
            "listed 1",
            "cell 1 of 1",
            "listed 0",
            "mailbox 0",
            "cell 2 of 1",
            "listed 0",
            "mailbox 0",
            "HitInCell after 3",
        ];
        assert_eq!(told, expected);
    }

    #[test]
    fn without_mailboxes_an_object_is_tested_in_each_of_its_cells() {
        let scene = slanted_wall();
        let ray = Ray::new(DVec3::new(-1.0, 1.2, 1.0), DVec3::X);
        let tests = |mailboxes| {
            let grid = UniformGrid::new(&scene, &options([4, 1, 1], mailboxes)).unwrap();
            let (events, _) = noted(&grid, &ray);
            let is_test = |event: &&Event| matches!(event, Event::PlaneTest { .. });
            events.iter().filter(is_test).count()
        };
        assert_eq!((tests(true), tests(false)), (1, 3));
    }

    #[test]
    fn a_walk_that_hits_nothing_leaves_the_grid_and_one_beside_it_begins_nowhere() {
        let scene = scene_of(&[cube_at(0.0), cube_at(3.0)]);
        let grid = UniformGrid::new(&scene, &options([4, 1, 1], true)).unwrap();
        let end = |origin: [f64; 3], direction: [f64; 3]| {
            let (events, hit) = noted(&grid, &Ray::new(origin.into(), direction.into()));
            assert_eq!(hit, None);
            match events.last() {
                Some(Event::GridExit(exit)) => (exit.end, exit.cells),
                other => panic!("{other:?}"),
            }
        };
        // through the two empty cells in the middle, across
        assert_eq!(end([1.5, 0.5, -1.0], [0.0, 0.0, 1.0]), (WalkEnd::Left, 1));
        assert_eq!(end([1.5, 0.5, -1.0], [0.1, 0.0, 1.0]), (WalkEnd::Left, 1));
        assert_eq!(
            end([-1.0, 1.5, 0.5], [1.0, 0.0, 0.0]),
            (WalkEnd::Outside, 0)
        );
    }

    #[test]
    fn the_grid_s_building_puts_each_object_into_its_cells() {
        let scene = scene_of(&[
            solid([0.0; 3], [2.0, 1.0, 1.0]),
            solid([2.5, 0.2, 0.2], [4.0, 0.8, 0.8]),
        ]);
        let grid = UniformGrid::new(&scene, &options([4, 1, 1], true)).unwrap();
        let mut recording = crate::trace::Recording::new(Vec::new());
        grid.note_building(&mut recording);
        let cells: Vec<_> = recording
            .into_sink()
            .into_iter()
            .map(|record| match record.event {
                Event::Assign(step) => (step.object.0, step.cell[0]),
                other => panic!("{other:?}"),
            })
            .collect();
        // the first reaches with its room across the plane at 2
        assert_eq!(cells, [(0, 0), (0, 1), (0, 2), (1, 2), (1, 3)]);
        // 5 + 2 + 2 planes of 8 bytes, 5 starts and 5 entries of 4
        assert_eq!(grid.bytes(), 72 + 20 + 20);
    }

    #[test]
    fn a_hit_just_where_a_cell_ends_lies_in_it_and_a_tie_is_not_passed() {
        // the second box begins in the plane between the second and the third of four cells, which is 2 but for rounding
        let beginning_at = |x: f64| {
            scene_of(&[
                solid([0.0, 1.5, 0.0], [0.5, 4.0, 2.0]),
                solid([x, 0.0, 0.0], [4.0, 2.0, 2.0]),
            ])
        };
        let options = options([4, 1, 1], true);
        let plane = Grid::new(&beginning_at(2.0), &options).unwrap().planes(0)[2];
        let scene = beginning_at(plane);
        let grid = UniformGrid::new(&scene, &options).unwrap();
        let (events, hit) = noted(&grid, &Ray::new(DVec3::new(-1.0, 1.0, 1.0), DVec3::X));
        assert_eq!(hit.map(|hit| (hit.object.0, hit.t)), Some((1, plane + 1.0)));
        let cells = events.iter().filter_map(|event| match event {
            Event::Cell(cell) => Some(cell.step.t_out),
            _ => None,
        });
        assert_eq!(cells.collect::<Vec<_>>()[1], plane + 1.0);
        let outside = |event: &Event| matches!(event, Event::HitOutsideCell(_));
        assert!(!events.iter().any(outside));
        assert!(!is_passed(1.0, 1.0 + TOLERANCE));
    }

    #[test]
    fn a_range_that_ends_before_any_hit_leaves_the_grid_without_one() {
        let scene = scene_of(&[cube_at(0.0), cube_at(3.0)]);
        let grid = UniformGrid::new(&scene, &options([4, 1, 1], true)).unwrap();
        let ray = Ray::new(DVec3::new(1.2, 0.5, 0.5), DVec3::X);
        let (events, hit) =
            crate::strategy::noted::noted_in(&grid, &ray, TRange::FORWARD.up_to(1.0));
        assert_eq!(hit, None);
        match events.last() {
            Some(Event::GridExit(exit)) => assert_eq!((exit.end, exit.cells), (WalkEnd::Left, 2)),
            other => panic!("{other:?}"),
        }
    }
}
