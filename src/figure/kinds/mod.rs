//! The kinds of figure, one file each.

mod algorithm;
mod alignment;
mod building;
mod connections;
mod costs;
mod epsilon;
mod forms;
mod gather;
mod grid;
mod grids;
mod heap;
mod heat;
mod hierarchy;
mod intervals;
mod irradiance;
mod line_drawing;
mod line_of_t;
mod merge;
mod mistake;
mod partition;
mod paths;
mod picture;
mod pinhole;
mod pixel_grid;
mod plane_cases;
mod polygon;
mod ray_tree;
mod rays;
mod rim;
mod root_cases;
mod shading;
mod sides;
mod slab_terms;
mod slabs;
mod sphere;
mod steps;
mod stretched;
mod sum;
mod terms;
mod transports;
mod volumes;
mod window;

use crate::figure::kind::Kind;
use crate::figure::spec::FigureKind;

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
        FigureKind::Sum => sum::KIND,
        FigureKind::Transports => transports::KIND,
        FigureKind::SlabTerms => slab_terms::KIND,
        FigureKind::Building => building::KIND,
        FigureKind::LineDrawing => line_drawing::KIND,
        FigureKind::Grids => grids::KIND,
        FigureKind::Picture => picture::KIND,
        FigureKind::Mistake => mistake::KIND,
        FigureKind::RootCases => root_cases::KIND,
        FigureKind::Forms => forms::KIND,
        FigureKind::Stretched => stretched::KIND,
        FigureKind::PlaneCases => plane_cases::KIND,
        FigureKind::Terms => terms::KIND,
        FigureKind::Sides => sides::KIND,
        FigureKind::Epsilon => epsilon::KIND,
        FigureKind::Rim => rim::KIND,
        FigureKind::Algorithm => algorithm::KIND,
        FigureKind::RayTree => ray_tree::KIND,
        FigureKind::PixelGrid => pixel_grid::KIND,
    }
}
