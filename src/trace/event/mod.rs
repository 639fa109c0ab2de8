//! The vocabulary of the trace: what can happen to a ray.
//!
//! An event wraps the working that a layer below returned, or is declared in the [`table`] if a strategy or the
//! tracer fills it. It holds finite numbers and numbers of objects and lights; the log's writer puts
//! names, and words are made in `explain`.

mod columns;
mod declare;
pub(in crate::trace) mod fields;
mod kind;
mod light;
pub(in crate::trace) mod place;
mod search;
pub(crate) mod table;
mod tested;
mod verdict;
mod words;
mod working;

pub use light::geometry_term;
pub use search::{BoundVerdict, Bounded};
pub(crate) use table::Event;
pub use table::{
    Aligned, Alternative, Arrival, BoundTest, CellVisit, Connection, Gathered, GridEnter, GridExit,
    HitOutsideCell, Kind, LightTerm, Nearby, Nearest, NodeVisit, PathStart, Photon, PixelColour,
    PixelSample, QueueStep, RayEnd, RaySlab, RayStart, Shade, SlabTest, Stored, ZSort,
};
pub use words::{
    AlignedPart, NodeVerdict, PhotonVerdict, Purpose, QueueAction, RayVerdict, Verdict, Visibility,
    WalkEnd, Why,
};
