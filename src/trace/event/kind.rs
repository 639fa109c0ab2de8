//! The names of the events: what the log calls each of them, and an empty one for a reader to fill.

use crate::geometry::{
    Alignment, BoxTest, EdgeTest, PlaneTest, PolygonTest, QuadraticTest, Refraction,
};
use crate::scene::PrimitiveId;
use crate::structure::{AssignStep, MergeStep};
use crate::trace::event::light::{
    Alternative, Arrival, Connection, Gathered, Nearby, PathStart, Photon, Stored,
};
use crate::trace::event::search::{
    Aligned, BoundTest, CellVisit, GridEnter, GridExit, HitOutsideCell, NodeVisit, QueueStep,
    SlabTest, ZSort,
};
use crate::trace::event::{
    Event, LightTerm, Nearest, PixelColour, PixelSample, RayEnd, RayStart, Shade,
};

/// The name of each event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is described at its event")]
pub enum Kind {
    Pixel,
    PixelColour,
    Ray,
    RayEnd,
    SphereTest,
    EllipsoidTest,
    ConeTest,
    BoxTest,
    PlaneTest,
    Edge,
    PolygonTest,
    Nearest,
    LightTerm,
    Shade,
    Refraction,
    Merge,
    Assign,
    BoundTest,
    SlabTest,
    Node,
    Queue,
    GridEnter,
    Cell,
    Listed,
    Mailbox,
    HitOutsideCell,
    GridExit,
    Align,
    Aligned,
    ZSort,
    Path,
    Photon,
    Arrival,
    Stored,
    Nearby,
    Gathered,
    Alternative,
    Connection,
}

/// What an event of a kind belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KindPlace {
    /// A structure, before the first pixel.
    Building,
    /// A path of light.
    Path,
    /// A pixel.
    Pixel,
    /// A path or a pixel.
    Either,
}

impl Kind {
    /// All kinds, in the order in which a ray meets them.
    pub const ALL: [Self; 38] = [
        Self::Merge,
        Self::Assign,
        Self::Path,
        Self::Pixel,
        Self::Ray,
        Self::Align,
        Self::GridEnter,
        Self::Queue,
        Self::SlabTest,
        Self::BoundTest,
        Self::Node,
        Self::Cell,
        Self::Listed,
        Self::Mailbox,
        Self::Aligned,
        Self::SphereTest,
        Self::EllipsoidTest,
        Self::ConeTest,
        Self::BoxTest,
        Self::PlaneTest,
        Self::Edge,
        Self::PolygonTest,
        Self::Nearest,
        Self::HitOutsideCell,
        Self::GridExit,
        Self::ZSort,
        Self::Arrival,
        Self::Stored,
        Self::Nearby,
        Self::Gathered,
        Self::LightTerm,
        Self::Refraction,
        Self::Photon,
        Self::Alternative,
        Self::Connection,
        Self::Shade,
        Self::RayEnd,
        Self::PixelColour,
    ];

    /// The name in the log.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pixel => "pixel",
            Self::PixelColour => "pixel_colour",
            Self::Ray => "ray",
            Self::RayEnd => "ray_end",
            Self::SphereTest => "sphere_test",
            Self::EllipsoidTest => "ellipsoid_test",
            Self::ConeTest => "cone_test",
            Self::BoxTest => "box_test",
            Self::PlaneTest => "plane_test",
            Self::Edge => "edge",
            Self::PolygonTest => "polygon_test",
            Self::Nearest => "nearest",
            Self::LightTerm => "light_term",
            Self::Shade => "shade",
            Self::Refraction => "refraction",
            Self::Merge => "merge",
            Self::Assign => "assign",
            Self::BoundTest => "bound_test",
            Self::SlabTest => "slab_test",
            Self::Node => "node",
            Self::Queue => "queue",
            Self::GridEnter => "grid_enter",
            Self::Cell => "cell",
            Self::Listed => "listed",
            Self::Mailbox => "mailbox",
            Self::HitOutsideCell => "hit_outside_cell",
            Self::GridExit => "grid_exit",
            Self::Align => "align",
            Self::Aligned => "aligned",
            Self::ZSort => "z_sort",
            Self::Path => "path",
            Self::Photon => "photon",
            Self::Arrival => "arrival",
            Self::Stored => "stored",
            Self::Nearby => "nearby",
            Self::Gathered => "gathered",
            Self::Alternative => "alternative",
            Self::Connection => "connection",
        }
    }

    /// Does it happen while a structure is built, before the first pixel?
    pub const fn is_of_building(self) -> bool {
        matches!(self, Self::Merge | Self::Assign)
    }

    /// Where it can happen.
    pub(crate) const fn place(self) -> KindPlace {
        match self {
            Self::Merge | Self::Assign => KindPlace::Building,
            Self::Path | Self::Arrival | Self::Stored => KindPlace::Path,
            Self::Pixel
            | Self::PixelColour
            | Self::LightTerm
            | Self::Shade
            | Self::Nearby
            | Self::Gathered => KindPlace::Pixel,
            _ => KindPlace::Either,
        }
    }

    /// The kind with a name of the log.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// An event of this kind with nothing in it, for a reader to fill.
    pub(crate) fn blank(self) -> Event {
        let object = PrimitiveId::default();
        match self {
            Self::Pixel => Event::Pixel(PixelSample::default()),
            Self::PixelColour => Event::PixelColour(PixelColour::default()),
            Self::Ray => Event::Ray(RayStart::default()),
            Self::RayEnd => Event::RayEnd(RayEnd::default()),
            Self::SphereTest => Event::SphereTest {
                object,
                test: QuadraticTest::default(),
            },
            Self::EllipsoidTest => Event::EllipsoidTest {
                object,
                test: QuadraticTest::default(),
            },
            Self::ConeTest => Event::ConeTest {
                object,
                test: QuadraticTest::default(),
            },
            Self::BoxTest => Event::BoxTest {
                object,
                test: BoxTest::default(),
            },
            Self::PlaneTest => Event::PlaneTest {
                object,
                test: PlaneTest::default(),
            },
            Self::Edge => Event::Edge {
                object,
                edge: EdgeTest::default(),
            },
            Self::PolygonTest => Event::PolygonTest {
                object,
                test: PolygonTest::default(),
            },
            Self::Nearest => Event::Nearest(Nearest::default()),
            Self::LightTerm => Event::LightTerm(LightTerm::default()),
            Self::Shade => Event::Shade(Shade::default()),
            Self::Refraction => Event::Refraction(Refraction::default()),
            Self::Merge => Event::Merge(MergeStep::default()),
            Self::Assign => Event::Assign(AssignStep::default()),
            Self::BoundTest => Event::BoundTest(BoundTest::default()),
            Self::SlabTest => Event::SlabTest(SlabTest::default()),
            Self::Node => Event::Node(NodeVisit::default()),
            Self::Queue => Event::Queue(QueueStep::default()),
            Self::GridEnter => Event::GridEnter(GridEnter::default()),
            Self::Cell => Event::Cell(CellVisit::default()),
            Self::Listed => Event::Listed { object },
            Self::Mailbox => Event::Mailbox { object },
            Self::HitOutsideCell => Event::HitOutsideCell(HitOutsideCell::default()),
            Self::GridExit => Event::GridExit(GridExit::default()),
            Self::Align => Event::Align(Alignment::default()),
            Self::Aligned => Event::Aligned(Aligned::default()),
            Self::ZSort => Event::ZSort(ZSort::default()),
            Self::Path => Event::Path(PathStart::default()),
            Self::Photon => Event::Photon(Photon::default()),
            Self::Arrival => Event::Arrival(Arrival::default()),
            Self::Stored => Event::Stored(Stored::default()),
            Self::Nearby => Event::Nearby(Nearby::default()),
            Self::Gathered => Event::Gathered(Gathered::default()),
            Self::Alternative => Event::Alternative(Alternative::default()),
            Self::Connection => Event::Connection(Connection::default()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_name_of_its_own_and_a_blank_event() {
        for kind in Kind::ALL {
            assert_eq!(Kind::named(kind.name()), Some(kind));
            assert_eq!(kind.blank().kind(), kind);
        }
    }
}
