//! The kinds of figure, one file each.

mod alignment;
mod connections;
mod costs;
mod gather;
mod grid;
mod heap;
mod heat;
mod hierarchy;
mod intervals;
mod irradiance;
mod line_of_t;
mod merge;
mod named_lines;
mod partition;
mod paths;
mod picture;
mod pinhole;
mod plan;
mod polygon;
mod rays;
mod shading;
mod slabs;
mod sphere;
mod steps;
mod surface;
mod volumes;
mod walk;
mod window;

use crate::figure::drawing::Figure;
use crate::figure::error::FigureError;
use crate::figure::frame::Frame;
use crate::figure::sheet::Sheet;
use crate::figure::spec::{FigureKind, Layer};

/// A kind of figure.
pub(super) struct Kind {
    /// Draws into a frame of the sheet, and says in words what there is to be seen.
    pub(super) draw: fn(&Figure, &mut Sheet, Frame) -> Result<String, FigureError>,
    /// How high it is in a book's column, in units of the sheet.
    pub(super) height: f64,
    /// What it shows if nothing is said.
    pub(super) usual: &'static [Layer],
    /// What else it can show.
    pub(super) more: &'static [Layer],
}

/// The kind of that name.
pub(super) fn kind(name: FigureKind) -> Kind {
    match name {
        FigureKind::Pinhole => pinhole::KIND,
        FigureKind::Window => window::KIND,
        FigureKind::Rays => rays::KIND,
        FigureKind::Paths => paths::KIND,
        FigureKind::Gather => gather::KIND,
        FigureKind::Connections => connections::KIND,
        FigureKind::Irradiance => irradiance::KIND,
        FigureKind::Shading => shading::KIND,
        FigureKind::LineOfT => line_of_t::KIND,
        FigureKind::Sphere => sphere::KIND,
        FigureKind::Polygon => polygon::KIND,
        FigureKind::Alignment => alignment::KIND,
        FigureKind::Volumes => volumes::KIND,
        FigureKind::Slabs => slabs::KIND,
        FigureKind::Merge => merge::KIND,
        FigureKind::Intervals => intervals::KIND,
        FigureKind::Hierarchy => hierarchy::KIND,
        FigureKind::Heap => heap::KIND,
        FigureKind::Partition => partition::KIND,
        FigureKind::Grid => grid::KIND,
        FigureKind::Steps => steps::KIND,
        FigureKind::Costs => costs::KIND,
        FigureKind::Heat => heat::KIND,
        FigureKind::Picture => picture::KIND,
    }
}
