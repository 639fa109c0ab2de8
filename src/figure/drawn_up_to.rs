//! Up to which step a figure is drawn when an event has happened.

use std::collections::BTreeMap;

use crate::explain::Section as Of;
use crate::figure::spec::FigureKind;
use crate::figure::traced::{Section, Traced};
use crate::trace::Record;

/// Up to which step a figure is drawn when an event has happened.
///
/// A figure of how a structure is built numbers the steps of the building; all others show the building from the first. Where
/// paths of light are drawn, their steps come one after the other and then those of a pixel.
#[derive(Clone, Debug)]
pub struct DrawnUpTo {
    numbers: Numbers,
    /// By the number of a path the steps before its first.
    before_path: BTreeMap<u32, u32>,
    before_pixel: u32,
}

/// Which steps a kind of figure numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Numbers {
    Building,
    PathsAndPixel,
    Pixel,
}

/// How far a figure is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Far {
    /// Only what is there from the first.
    Nothing,
    /// Up to this step, as [`UpTo::Step`](crate::figure::UpTo).
    Step(u32),
    /// All of it.
    Whole,
}

impl Numbers {
    fn of(kind: FigureKind) -> Self {
        use FigureKind as Kind;
        match kind {
            Kind::Partition | Kind::Merge => Self::Building,
            Kind::Rays | Kind::Paths | Kind::Gather | Kind::Connections | Kind::Irradiance => {
                Self::PathsAndPixel
            }
            _ => Self::Pixel,
        }
    }
}

impl DrawnUpTo {
    /// Of a figure of this kind that is drawn from a trace.
    pub fn new(kind: FigureKind, traced: &Traced) -> Self {
        let numbers = Numbers::of(kind);
        let paths = if numbers == Numbers::PathsAndPixel {
            traced.paths()
        } else {
            Vec::new()
        };
        let first = |section: &Section<'_>| {
            let first = section.records.first()?;
            Some((first.path?, section.step(first) - first.step))
        };
        let before_pixel = paths.last().map_or(0, Section::after);
        Self {
            numbers,
            before_path: paths.iter().filter_map(first).collect(),
            before_pixel,
        }
    }

    /// Behind an event.
    pub fn after(&self, record: &Record) -> Far {
        let of_building = self.numbers == Numbers::Building;
        match Of::of(record) {
            Of::Building if of_building => Far::Step(record.step),
            Of::Building => Far::Nothing,
            _ if of_building => Far::Whole,
            Of::Path(path) => match self.before_path.get(&path) {
                Some(before) => Far::Step(before + record.step),
                None => Far::Nothing,
            },
            Of::Pixel => Far::Step(self.before_pixel + record.step),
        }
    }
}
