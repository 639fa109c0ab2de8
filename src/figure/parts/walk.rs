//! A ray's walk through a grid, gathered from its events.

use crate::figure::error::FigureError;
use crate::figure::subject::DrawnRay;
use crate::scene::{PrimitiveId, Scene};
use crate::structure::{Across, BareGrid, CellStep};
use crate::trace::{Event, GridEnter, HitOutsideCell, Record, WalkEnd};

/// What happened on the way of a ray through a grid.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Walk {
    /// The step at which the ray enters the grid.
    pub(in crate::figure) step: u32,
    pub(in crate::figure) grid: GridEnter,
    /// The cells it pierces, in order.
    pub(in crate::figure) visits: Vec<Visit>,
    pub(in crate::figure) end: WalkEnd,
}

/// A cell whose list was looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::figure) struct Visit {
    pub(in crate::figure) step: u32,
    pub(in crate::figure) cell: CellStep,
    /// How many objects are on the list; a walk that has its hit may leave some of them.
    pub(in crate::figure) length: u32,
    /// The objects that were looked at, in order.
    pub(in crate::figure) listed: Vec<Listed>,
}

/// An object on the list of a cell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::figure) struct Listed {
    /// The step with its verdict.
    pub(in crate::figure) step: u32,
    pub(in crate::figure) object: PrimitiveId,
    /// Was it met? `None` if it was not tested again.
    pub(in crate::figure) met: Option<bool>,
    /// Where, if that lies beyond the cell.
    pub(in crate::figure) outside: Option<HitOutsideCell>,
}

impl Walk {
    /// The walk of a ray.
    ///
    /// # Errors
    /// The ray was not traced through a grid.
    pub(in crate::figure) fn of(ray: &DrawnRay, scene: &Scene) -> Result<Self, FigureError> {
        let gathered = Self::gathered(ray.events.iter().copied());
        let mut walk = gathered.ok_or_else(|| {
            FigureError::new(
                "strategy",
                "the ray was not traced through a grid",
                "add \"strategy\": \"grid\", and draw a scene that has objects",
            )
        })?;
        // t is shown without the padding of the grid's planes
        let bare = BareGrid::around(scene, walk.grid.resolution);
        if let Some(start) = ray.node.start
            && bare.inside(&start.ray).is_some()
        {
            for visit in &mut walk.visits {
                visit.cell = bare.step(&start.ray, start.range.min, &visit.cell);
            }
        }
        Ok(walk)
    }

    fn gathered<'r>(events: impl Iterator<Item = &'r Record>) -> Option<Self> {
        let mut walk = None;
        for record in events {
            let step = record.step;
            if let Event::GridEnter(grid) = record.event {
                walk = (!grid.resolution.contains(&0)).then(|| Self {
                    step,
                    grid,
                    visits: Vec::new(),
                    end: WalkEnd::Left,
                });
            }
            let Some(walk) = &mut walk else { continue };
            match record.event {
                Event::Cell(visit) => walk.visits.push(Visit {
                    step,
                    cell: visit.step,
                    length: visit.listed,
                    listed: Vec::new(),
                }),
                Event::GridExit(exit) => walk.end = exit.end,
                event => {
                    if let Some(visit) = walk.visits.last_mut() {
                        visit.gather(step, &event);
                    }
                }
            }
        }
        walk
    }

    /// Each object that was tested, at its last test.
    pub(in crate::figure) fn tested(&self) -> Vec<Listed> {
        let mut tested: Vec<Listed> = Vec::new();
        let all = self.visits.iter().flat_map(|visit| &visit.listed);
        for listed in all.filter(|listed| listed.met.is_some()) {
            tested.retain(|other| other.object != listed.object);
            tested.push(*listed);
        }
        tested
    }
}

impl Visit {
    /// What became of the object that was listed last.
    fn gather(&mut self, step: u32, event: &Event) {
        if let Event::Listed { object } = *event {
            self.listed.push(Listed {
                step,
                object,
                ..Listed::default()
            });
        }
        let Some(last) = self.listed.last_mut() else {
            return;
        };
        if let Some(met) = event.test_hits() {
            // of a polygon's two tests the last decides
            (last.step, last.met) = (step, Some(met));
        }
        match *event {
            Event::Mailbox { .. } => last.step = step,
            Event::HitOutsideCell(outside) => last.outside = Some(outside),
            _ => {}
        }
    }
}

/// The axes whose planes a step crosses.
pub(in crate::figure) fn axes(across: Across) -> &'static [usize] {
    match across {
        Across::None => &[],
        Across::X => &[0],
        Across::Y => &[1],
        Across::Z => &[2],
        Across::XY => &[0, 1],
        Across::XZ => &[0, 2],
        Across::YZ => &[1, 2],
        Across::XYZ => &[0, 1, 2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{QuadraticTest, Root, RootVerdict, Roots};
    use crate::trace::{CellVisit, GridExit};

    fn records(events: &[Event]) -> Vec<Record> {
        let record = |(step, event): (u32, &Event)| Record {
            pixel: Some([0, 0]),
            path: None,
            step,
            ray: Some(0),
            parent: None,
            event: *event,
        };
        (2..).zip(events).map(record).collect()
    }

    fn enter(resolution: [u32; 3]) -> Event {
        Event::GridEnter(GridEnter {
            resolution,
            ..GridEnter::default()
        })
    }

    fn cell(i: u32, listed: u32) -> Event {
        let step = CellStep {
            cell: [i, 0, 0],
            ..CellStep::default()
        };
        Event::Cell(CellVisit { step, listed })
    }

    fn listed(object: u32) -> Event {
        Event::Listed {
            object: PrimitiveId(object),
        }
    }

    fn sphere(object: u32, met: bool) -> Event {
        let root = Root {
            t: 3.0,
            verdict: RootVerdict::Chosen,
        };
        let test = QuadraticTest {
            roots: if met { Roots::Graze(root) } else { Roots::None },
            ..QuadraticTest::default()
        };
        Event::SphereTest {
            object: PrimitiveId(object),
            test,
        }
    }

    #[test]
    fn what_became_of_an_object_is_told_by_the_events_after_it_is_listed() {
        let beyond = HitOutsideCell {
            object: PrimitiveId(7),
            t: 3.0,
            t_out: 2.0,
        };
        let records = records(&[
            enter([4, 1, 1]),
            cell(0, 0),
            cell(1, 2),
            listed(5),
            sphere(5, false),
            listed(7),
            sphere(7, true),
            Event::HitOutsideCell(beyond),
            cell(2, 1),
            listed(5),
            Event::Mailbox {
                object: PrimitiveId(5),
            },
            Event::GridExit(GridExit {
                end: WalkEnd::HitInCell,
                cells: 3,
            }),
        ]);
        let walk = Walk::gathered(records.iter()).unwrap();
        assert_eq!((walk.step, walk.end), (2, WalkEnd::HitInCell));
        let visits = walk.visits.iter().map(|of| (of.step, of.length));
        assert_eq!(visits.collect::<Vec<_>>(), [(3, 0), (4, 2), (10, 1)]);
        let missed = Listed {
            step: 6,
            object: PrimitiveId(5),
            met: Some(false),
            outside: None,
        };
        let met = Listed {
            step: 8,
            object: PrimitiveId(7),
            met: Some(true),
            outside: Some(beyond),
        };
        assert_eq!(walk.visits[1].listed, [missed, met]);
        assert_eq!(walk.visits[2].listed[0].met, None);
        assert_eq!(walk.tested(), [missed, met]);
    }

    #[test]
    fn without_a_grid_there_is_no_walk() {
        assert_eq!(Walk::gathered(records(&[sphere(0, true)]).iter()), None);
        // a scene without objects has a grid without cells
        assert_eq!(Walk::gathered(records(&[enter([0; 3])]).iter()), None);
    }
}
