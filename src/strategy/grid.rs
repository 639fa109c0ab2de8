//! The uniform grid: only the objects in the cells along the ray (slides, "Spatial Partitioning").
//!
//! "As soon as a partition is found in which there is an intersection, no more partitions need to be inspected"
//! holds only if the intersection lies *inside* that partition (erratum 6, Fig. 15.62): an object on this cell's
//! list may be hit in a later cell, with a nearer object in between. Such a hit is kept, and the walk goes
//! on until it has passed it.

use std::ops::{ControlFlow, Range};

use crate::geometry::{Ray, TRange};
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::leaf_order::LeafOrder;
use crate::strategy::mailbox::Mailboxes;
use crate::strategy::{Search, Strategy};
use crate::structure::{Grid, GridError, GridOptions};
use crate::trace::{CellVisit, Event, GridEnter, GridExit, HitOutsideCell, Recorder, WalkEnd};

/// Tests the objects of the cells that a ray pierces, cell by cell.
#[derive(Clone, Debug)]
pub struct UniformGrid<'a> {
    grid: Grid,
    /// The objects in the order of the lists.
    objects: LeafOrder<'a>,
    mailboxes: bool,
}

/// Room for the error of an object's own t: a computed root is good to 10⁻¹⁰ of itself. What error it has
/// beyond that, where t is small beside the coordinates, lies within the room around each object in the lists.
const STRETCH: f64 = 1e-9;

impl<'a> UniformGrid<'a> {
    /// Builds the grid over a scene.
    ///
    /// # Errors
    /// Options that make no sense, or a grid that would take too much memory.
    pub fn new(scene: &'a Scene, options: &GridOptions) -> Result<Self, GridError> {
        let grid = Grid::new(scene, options)?;
        Ok(Self {
            objects: LeafOrder::of_cells(scene, grid.lists().objects()),
            grid,
            mailboxes: options.mailboxes,
        })
    }

    /// The grid that is walked.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Walks the cells; `is_first` says whether an object is to be tested.
    #[inline]
    fn walk<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
        mut is_first: impl FnMut(PrimitiveId) -> bool,
    ) {
        let range = search.range();
        let mut walk = self.grid.walk(
            ray,
            TRange {
                min: range.min * (1.0 - STRETCH),
                max: range.max * (1.0 + STRETCH),
            },
        );
        recorder.note(|| {
            Event::GridEnter(GridEnter {
                min: self.grid.min(),
                max: self.grid.max(),
                resolution: self.grid.resolution(),
                inside: self.grid.inside(ray),
                cell: walk.cell(),
            })
        });
        let mut end = WalkEnd::Outside;
        let mut cells = 0;
        loop {
            let entering = if R::ENABLED { walk.entering() } else { None };
            let Some((number, leaving)) = walk.step() else {
                break;
            };
            cells += 1;
            end = WalkEnd::Left;
            let listed = self.grid.lists().range(number);
            if let Some(entering) = entering {
                recorder.note(|| {
                    Event::Cell(CellVisit {
                        step: leaving.completes(entering),
                        listed: listed.len() as u32,
                    })
                });
            }
            let tested = self.test_listed(listed, leaving.t, ray, search, recorder, &mut is_first);
            // equal t does not end it: of two such hits the object first in the scene wins
            let nearest = search.range().max;
            let is_passed = nearest < range.max && nearest * (1.0 + STRETCH) < leaving.t;
            if tested.is_break() || is_passed {
                end = WalkEnd::HitInCell;
                break;
            }
        }
        recorder.note(|| Event::GridExit(GridExit { end, cells }));
    }

    /// Tests the objects of a cell: those in these places of all lists.
    #[inline]
    fn test_listed<R: Recorder>(
        &self,
        listed: Range<usize>,
        t_out: f64,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
        is_first: &mut impl FnMut(PrimitiveId) -> bool,
    ) -> ControlFlow<()> {
        let order = self.grid.lists().objects();
        self.objects.visit::<R>(order, listed, ray, |listed| {
            let object = listed.id();
            recorder.note(|| Event::Listed { object });
            if !is_first(object) {
                recorder.note(|| Event::Mailbox { object });
                return ControlFlow::Continue(());
            }
            let scene = self.objects.scene();
            let Some(t) = listed.test(scene, ray, search.range(), recorder) else {
                return ControlFlow::Continue(());
            };
            let offered = search.offer(object, t, recorder);
            if t_out < t {
                recorder.note(|| Event::HitOutsideCell(HitOutsideCell { object, t, t_out }));
            }
            offered
        })
    }
}

impl Strategy for UniformGrid<'_> {
    #[inline]
    fn search<R: Recorder>(&self, ray: &Ray, search: &mut impl Search, recorder: &mut R) {
        if self.mailboxes {
            let mut mailboxes = Mailboxes::for_ray(self.objects.scene().primitives.len());
            self.walk(ray, search, recorder, |object| {
                mailboxes.is_first(object.0 as usize)
            });
        } else {
            self.walk(ray, search, recorder, |_| true);
        }
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        if R::ENABLED {
            for assignment in self.grid.assignments(self.objects.scene()) {
                recorder.note(|| Event::Assign(assignment));
            }
        }
    }

    fn bytes(&self) -> usize {
        self.grid.bytes() + self.objects.bytes()
    }
}
