//! What happened: events, who records them, and the log that they are kept in.
//!
//! Three rooms: `event` says what can happen, `record` who listens to it, `log` how it is written and read.

mod event;
mod log;
mod record;

pub use event::{
    Aligned, AlignedPart, Alternative, Arrival, BoundTest, BoundVerdict, Bounded, CellVisit,
    Connection, Event, Gathered, GridEnter, GridExit, HitOutsideCell, Kind, LightTerm, Nearby,
    Nearest, NodeVerdict, NodeVisit, PathStart, Photon, PhotonVerdict, PixelColour, PixelSample,
    Purpose, QueueAction, QueueStep, RayEnd, RaySlab, RayStart, RayVerdict, Shade, SlabTest,
    Stored, Verdict, Visibility, WalkEnd, Why, ZSort, geometry_term,
};
#[cfg(feature = "schema")]
pub(crate) use log::generator;
pub(crate) use log::{EventWriter, write_event};
pub use log::{
    LOG_VERSION, LightOptions, LineSink, LogError, LogNames, LogReader, Settings, StrategyName,
    Through, Transport, begins_log, write_log_head,
};
#[cfg(feature = "schema")]
pub use log::{scene_schema, trace_schema};
pub use record::{
    Budget, Counts, Filter, Item, Kinds, LightCount, Off, PathSieve, RayCount, RayNode, RayTree,
    Record, Recorder, Recording, Region, SearchCount, Sink, TestCount, UsefulRays,
};
