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

/// Room for the error of an object's own t: a computed root is good to 10⁻¹⁰ of itself. What error it has
/// beyond that, where t is small beside the coordinates, lies within the room around each object in the lists.
const STRETCH: f64 = 1e-9;

/// The range in which cells are visited: a little longer than that of the hits.
pub(super) fn walked(range: TRange) -> TRange {
    TRange {
        min: range.min * (1.0 - STRETCH),
        max: range.max * (1.0 + STRETCH),
    }
}

/// Does a nearest hit lie before the end of a cell, so that no later cell can hold a nearer one?
///
/// Equal t does not end the walk: of two such hits the object first in the scene wins.
pub(super) fn is_passed(nearest: f64, t_out: f64) -> bool {
    nearest * (1.0 + STRETCH) < t_out
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
                min: self.grid.min(),
                max: self.grid.max(),
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
