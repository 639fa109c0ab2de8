//! The numbers that can stand in a log: those of pixels, nodes, slabs and cells that are there.
//!
//! Only what the log itself says is asked: its scene, its settings, and the events before. Whether a node or a cell
//! that can be there is the right one would take the structure built again.

use crate::scene::Scene;
use crate::structure::{MOST_CELLS, SlabChoice};
use crate::trace::log::line_reader::Damage;

use crate::trace::{Bounded, Event, GridEnter, Record, Settings};

/// How many there are of what events name by numbers.
#[derive(Debug)]
pub(super) struct Limits {
    /// Columns and rows.
    pixels: [u32; 2],
    /// Objects, each face of a mesh one of them.
    objects: u32,
    /// Paths of light.
    paths: u64,
    /// Directions of slabs.
    slabs: u32,
    /// Cells along x, y and z, once they are known.
    resolution: Option<[u32; 3]>,
    /// The largest i, j and k of cells that were named before.
    named: Option<[u32; 3]>,
}

impl Limits {
    /// The limits of a log with this head.
    pub(super) fn new(scene: &Scene, settings: &Settings) -> Self {
        let slabs = match settings.structure.slabs {
            SlabChoice::Axes => 3,
            SlabChoice::Seven => 7,
            SlabChoice::Scene => scene.slabs.as_ref().map_or(0, Vec::len) as u32,
        };
        let objects = scene.primitives.len() as u32;
        Self {
            pixels: scene.camera.pixels,
            objects,
            paths: settings.light_paths(scene.camera.pixels),
            slabs,
            // a grid over no objects has no cells, whatever was asked for
            resolution: settings.structure.grid.resolution.filter(|_| 0 < objects),
            named: None,
        }
    }

    /// Can there be what the record names by a number?
    #[inline]
    pub(super) fn check(&mut self, record: &Record) -> Result<(), Damage> {
        record.pixel.map_or(Ok(()), |pixel| self.pixel(pixel))?;
        record.path.map_or(Ok(()), |path| self.path(path))?;
        match &record.event {
            Event::Arrival(arrival) => self.pixel(arrival.pixel),
            Event::Nearby(photon) => self.path(photon.path),
            Event::Connection(connection) => {
                self.path(connection.path)?;
                connection.pixel.map_or(Ok(()), |pixel| self.pixel(pixel))
            }
            Event::Merge(step) => {
                self.node(step.node)?;
                self.node(step.first)?;
                self.node(step.second)?;
                self.slab(step.slab)
            }
            Event::SlabRay(line) => self.slab(line.slab),
            Event::SlabTest(test) => {
                self.bounded(test.of)?;
                self.slab(test.step.slab)
            }
            Event::BoundTest(test) => self.bounded(test.of),
            Event::Node(visit) => {
                self.node(visit.node)?;
                self.listed("objects", visit.objects)
            }
            Event::Queue(step) => self.node(step.node),
            Event::Assign(step) => self.cell(step.cell),
            Event::GridEnter(enter) => self.grid(enter),
            Event::Cell(visit) => {
                self.cell(visit.step.cell)?;
                self.listed("listed", visit.listed)
            }
            Event::ZSort(step) => self.place(step.place),
            _ => Ok(()),
        }
    }

    fn pixel(&self, [x, y]: [u32; 2]) -> Result<(), Damage> {
        let [width, height] = self.pixels;
        if x < width && y < height {
            return Ok(());
        }
        refused(format!(
            "there is no pixel [{x},{y}] in a picture of {width} × {height}"
        ))
    }

    fn path(&self, path: u32) -> Result<(), Damage> {
        if u64::from(path) < self.paths {
            return Ok(());
        }
        refused(format!(
            "there is no path {path}: the trace has {}",
            self.paths
        ))
    }

    fn bounded(&self, of: Bounded) -> Result<(), Damage> {
        match of {
            Bounded::Node(node) => self.node(node),
            // it was found by its name
            Bounded::Object(_) => Ok(()),
        }
    }

    /// A tree whose inner nodes have two children or more has fewer inner nodes than leaves, and each leaf has an
    /// object.
    fn node(&self, node: u32) -> Result<(), Damage> {
        let below = self.objects.saturating_mul(2);
        if node < below {
            return Ok(());
        }
        refused(format!(
            "there is no node {node}: a hierarchy over {} objects has fewer than {below}",
            self.objects
        ))
    }

    fn slab(&self, slab: u32) -> Result<(), Damage> {
        if slab < self.slabs {
            return Ok(());
        }
        refused(format!(
            "there is no slab {slab}: the set has {}",
            self.slabs
        ))
    }

    /// A number of objects.
    fn listed(&self, key: &str, count: u32) -> Result<(), Damage> {
        if count <= self.objects {
            return Ok(());
        }
        refused(format!(
            "{key:?} is {count}, and the scene has {} objects",
            self.objects
        ))
    }

    /// A place among the objects that were hit, from 0.
    fn place(&self, place: u32) -> Result<(), Damage> {
        if place < self.objects {
            return Ok(());
        }
        refused(format!(
            "\"place\" is {place}, and no more than {} objects can be hit",
            self.objects
        ))
    }

    fn grid(&mut self, enter: &GridEnter) -> Result<(), Damage> {
        let found = enter.resolution;
        let cells: f64 = found.iter().map(|&n| f64::from(n)).product();
        if f64::from(MOST_CELLS) < cells {
            return refused(format!("a grid has at most {MOST_CELLS} cells"));
        }
        let known = *self.resolution.get_or_insert(found);
        if found != known {
            return refused(format!("the grid has {known:?} cells"));
        }
        self.named.map_or(Ok(()), |cell| self.cell(cell))?;
        enter.cell.map_or(Ok(()), |cell| self.cell(cell))
    }

    fn cell(&mut self, cell: [u32; 3]) -> Result<(), Damage> {
        let Some(resolution) = self.resolution else {
            let before = self.named.unwrap_or(cell);
            self.named = Some([0, 1, 2].map(|axis| cell[axis].max(before[axis])));
            return Ok(());
        };
        if cell.iter().zip(resolution).all(|(&at, n)| at < n) {
            return Ok(());
        }
        refused(format!(
            "there is no cell {cell:?}: the grid has {resolution:?}"
        ))
    }
}

#[cold]
fn refused(what: String) -> Result<(), Damage> {
    Err(Damage::new(what))
}
