//! The vocabulary of the trace: what can happen to a ray.
//!
//! An event wraps the working that a layer below returned, or is defined here if a strategy or the
//! tracer fills it. It holds finite numbers and numbers of objects and lights; the log's writer puts
//! names, and words are made in `explain`.

pub(in crate::trace) mod fields;
pub(in crate::trace) mod kind;
mod kinds;
mod light;
mod light_kinds;
mod search;
mod search_kinds;
mod verdict;
mod words;

use glam::{DVec2, DVec3};

use crate::geometry::{
    Alignment, BoxTest, EdgeTest, PlaneTest, PolygonTest, QuadraticTest, Ray, Refraction, TRange,
};
use crate::scene::{PhongTerm, PrimitiveId};
use crate::structure::{AssignStep, MergeStep};

pub use kind::Kind;
pub use light::{
    Alternative, Arrival, Connection, Gathered, Nearby, PathStart, Photon, Stored, geometry_term,
};
pub use search::{
    Aligned, BoundOutcome, BoundTest, Bounded, CellVisit, GridEnter, GridExit, HitOutsideCell,
    NodeVisit, QueueStep, SlabTest, ZSort,
};
pub use words::{
    AlignedPart, NodeOutcome, Outcome, PhotonFate, Purpose, QueueAction, Verdict, Visibility,
    WalkEnd, Why,
};

/// One step of the working. `Copy` and at most 128 bytes, so that a record of many is one block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A place on the window is looked through.
    Pixel(PixelSample),
    /// The pixel has its colour.
    PixelColour(PixelColour),
    /// A ray starts.
    Ray(RayStart),
    /// A ray has come to its end.
    RayEnd(RayEnd),
    /// A sphere was tested: equation (iii).
    SphereTest {
        /// The sphere.
        object: PrimitiveId,
        /// The working.
        test: QuadraticTest,
    },
    /// An ellipsoid was tested: equation (iii) in the space in which it is a unit sphere.
    EllipsoidTest {
        /// The ellipsoid.
        object: PrimitiveId,
        /// The working.
        test: QuadraticTest,
    },
    /// A cone or cylinder was tested.
    ConeTest {
        /// The cone.
        object: PrimitiveId,
        /// The working.
        test: QuadraticTest,
    },
    /// A box was tested: three slabs.
    BoxTest {
        /// The box.
        object: PrimitiveId,
        /// The working.
        test: BoxTest,
    },
    /// A polygon's plane was tested: equations (iv) and (v).
    PlaneTest {
        /// The polygon.
        object: PrimitiveId,
        /// The working.
        test: PlaneTest,
    },
    /// An edge of a polygon was counted or not. All edges come before their `PolygonTest`.
    Edge {
        /// The polygon.
        object: PrimitiveId,
        /// The working.
        edge: EdgeTest,
    },
    /// A point of a plane was found inside a polygon or outside (Fig. 15.57).
    PolygonTest {
        /// The polygon.
        object: PrimitiveId,
        /// The working.
        test: PolygonTest,
    },
    /// A hit is the nearest so far.
    Nearest(Nearest),
    /// A light was weighed up.
    LightTerm(LightTerm),
    /// The shade of a point has all its terms but for the rays sent on.
    Shade(Shade),
    /// Snell's law was applied.
    Refraction(Refraction),
    /// Two volumes were joined while the hierarchy was built (Fig. 15.58(b)).
    Merge(MergeStep),
    /// An object was put into a cell's list while the grid was built.
    Assign(AssignStep),
    /// A bounding volume was tested. The slabs of a bound come before it.
    BoundTest(BoundTest),
    /// One slab of a bound was tested (Fig. 15.58(a)).
    SlabTest(SlabTest),
    /// A node of the hierarchy was come to.
    Node(NodeVisit),
    /// A node was put into the heap or taken out.
    Queue(QueueStep),
    /// A ray came to the grid.
    GridEnter(GridEnter),
    /// A ray pierces a cell (Fig. 15.62).
    Cell(CellVisit),
    /// An object is on the list of the cell.
    Listed {
        /// The object.
        object: PrimitiveId,
    },
    /// The object was tested in an earlier cell: its mailbox holds this ray already.
    Mailbox {
        /// The object.
        object: PrimitiveId,
    },
    /// A hit lies beyond the cell (erratum 6).
    HitOutsideCell(HitOutsideCell),
    /// The walk through the grid ended.
    GridExit(GridExit),
    /// A ray was laid along the z axis.
    Align(Alignment),
    /// A point of an object was transformed likewise. All points come before the object's test.
    Aligned(Aligned),
    /// A hit has its place in the z sort.
    ZSort(ZSort),
    /// A light sends out a photon: a path of light begins.
    Path(PathStart),
    /// Chance decides how a path goes on from a surface.
    Photon(Photon),
    /// A photon passes the window into the eye.
    Arrival(Arrival),
    /// A photon is stored on a surface.
    Stored(Stored),
    /// A stored photon is one of the nearest. All of them come before their `Gathered`.
    Nearby(Nearby),
    /// What is stored around a point was gathered.
    Gathered(Gathered),
    /// An edge of a path that could have been its connection. All edges come before their `Connection`.
    Alternative(Alternative),
    /// A path of light and one from the eye were connected.
    Connection(Connection),
}

/// A place on the window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelSample {
    /// Column and row from the top left.
    pub pixel: [u32; 2],
    /// Which of the pixel's eye rays, from 0.
    pub sample: u32,
    /// How many eye rays the pixel has: 1 through its centre, or 4 through its corners.
    pub samples: u32,
    /// The place in pixels from the window's top left corner.
    pub place: DVec2,
    /// The point on the window, in world coordinates.
    pub point: DVec3,
}

/// A pixel's colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelColour {
    /// The mean over the pixel's eye rays.
    pub raw: DVec3,
    /// Cut to 0..1: what the picture shows.
    pub clamped: DVec3,
}

impl PixelColour {
    /// The colour in 8 bits a channel, without gamma: 255 times `clamped`, rounded.
    pub fn rgb(&self) -> [u8; 3] {
        (self.clamped * 255.0).round().to_array().map(|of| of as u8)
    }
}

/// A ray at its start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayStart {
    /// Origin and unit direction.
    pub ray: Ray,
    /// Which t count.
    pub range: TRange,
    /// What it is cast for.
    pub purpose: Purpose,
    /// 1 for an eye ray, one more for each surface it was sent on from.
    pub depth: u32,
    /// Where an eye ray passes the window (erratum 4).
    pub window_t: Option<f64>,
    /// The light that a shadow ray is cast to, or that the first leg of a path comes from.
    pub light: Option<u32>,
}

/// A ray at its end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayEnd {
    /// How it ended.
    pub outcome: Outcome,
    /// What it met.
    pub object: Option<PrimitiveId>,
    /// Where.
    pub t: Option<f64>,
    /// The colour it brings back; shadow rays bring none.
    pub colour: Option<DVec3>,
    /// How many objects it was tested against; the recording counts them.
    pub tests: u32,
    /// How many of those it met; the recording counts them.
    pub hits: u32,
}

/// A hit that is nearer than all before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nearest {
    /// What was hit.
    pub object: PrimitiveId,
    /// Where.
    pub t: f64,
    /// What was the nearest before.
    pub replaced: Option<PrimitiveId>,
}

/// What one light adds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightTerm {
    /// The light's place in the scene.
    pub light: u32,
    /// Whether its terms count.
    pub visibility: Visibility,
    /// Its terms.
    pub term: PhongTerm,
}

/// The shade of a point:
/// I = ambient + Σ lights + reflection·I_reflected + transmission·I_refracted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shade {
    /// What was hit.
    pub object: PrimitiveId,
    /// The point, in world coordinates.
    pub point: DVec3,
    /// N: the unit normal on the side that the ray comes from.
    pub normal: DVec3,
    /// The ray meets the back of the surface, so that N is the surface's normal turned round.
    pub back: bool,
    /// ambient·colour.
    pub ambient: DVec3,
    /// Σ over visible lights of the diffuse and the specular term.
    pub direct: DVec3,
    /// The weight of the reflected ray; total internal reflection adds the transmission to it.
    pub reflection: f64,
    /// The weight of the refracted ray.
    pub transmission: f64,
}

impl Event {
    /// The name of the event.
    #[inline]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Pixel(_) => Kind::Pixel,
            Self::PixelColour(_) => Kind::PixelColour,
            Self::Ray(_) => Kind::Ray,
            Self::RayEnd(_) => Kind::RayEnd,
            Self::SphereTest { .. } => Kind::SphereTest,
            Self::EllipsoidTest { .. } => Kind::EllipsoidTest,
            Self::ConeTest { .. } => Kind::ConeTest,
            Self::BoxTest { .. } => Kind::BoxTest,
            Self::PlaneTest { .. } => Kind::PlaneTest,
            Self::Edge { .. } => Kind::Edge,
            Self::PolygonTest { .. } => Kind::PolygonTest,
            Self::Nearest(_) => Kind::Nearest,
            Self::LightTerm(_) => Kind::LightTerm,
            Self::Shade(_) => Kind::Shade,
            Self::Refraction(_) => Kind::Refraction,
            Self::Merge(_) => Kind::Merge,
            Self::Assign(_) => Kind::Assign,
            Self::BoundTest(_) => Kind::BoundTest,
            Self::SlabTest(_) => Kind::SlabTest,
            Self::Node(_) => Kind::Node,
            Self::Queue(_) => Kind::Queue,
            Self::GridEnter(_) => Kind::GridEnter,
            Self::Cell(_) => Kind::Cell,
            Self::Listed { .. } => Kind::Listed,
            Self::Mailbox { .. } => Kind::Mailbox,
            Self::HitOutsideCell(_) => Kind::HitOutsideCell,
            Self::GridExit(_) => Kind::GridExit,
            Self::Align(_) => Kind::Align,
            Self::Aligned(_) => Kind::Aligned,
            Self::ZSort(_) => Kind::ZSort,
            Self::Path(_) => Kind::Path,
            Self::Photon(_) => Kind::Photon,
            Self::Arrival(_) => Kind::Arrival,
            Self::Stored(_) => Kind::Stored,
            Self::Nearby(_) => Kind::Nearby,
            Self::Gathered(_) => Kind::Gathered,
            Self::Alternative(_) => Kind::Alternative,
            Self::Connection(_) => Kind::Connection,
        }
    }

    /// Was an object tested, and was it met? A polygon is tested by its plane, and met if the point
    /// lies inside: both tests together are one object's.
    #[inline]
    pub(crate) fn object_tested(&self) -> (bool, bool) {
        let hit = self.test_hits();
        match self {
            Self::PlaneTest { .. } => (true, false),
            Self::PolygonTest { .. } => (false, hit == Some(true)),
            _ => (hit.is_some(), hit == Some(true)),
        }
    }

    /// Did a test of an object meet it? `None` for all that is no such test.
    ///
    /// A polygon has two tests: its plane is met or not, and then the point is inside or not.
    #[inline]
    pub fn test_hits(&self) -> Option<bool> {
        match self {
            Self::SphereTest { test, .. }
            | Self::EllipsoidTest { test, .. }
            | Self::ConeTest { test, .. } => Some(test.roots.chosen().is_some()),
            Self::BoxTest { test, .. } => Some(test.roots.chosen().is_some()),
            Self::PlaneTest { test, .. } => Some(test.chosen().is_some()),
            Self::PolygonTest { test, .. } => Some(test.inside),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_event_is_at_most_128_bytes() {
        assert!(size_of::<Event>() <= 128, "{}", size_of::<Event>());
    }
}
