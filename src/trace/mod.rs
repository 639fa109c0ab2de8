//! What happened: events, who records them, and the log that they are kept in.
//!
//! Three rooms: `event` says what can happen, `record` who listens to it, `log` how it is written and read.

pub(crate) mod event;
pub(crate) mod log;
pub(crate) mod record;

pub(crate) use event::Event;
pub use event::{
    Aligned, AlignedPart, Alternative, Arrival, BoundTest, BoundVerdict, Bounded, CellVisit,
    Connection, Gathered, GridEnter, GridExit, HitOutsideCell, Kind, LightTerm, Nearby, Nearest,
    NodeVerdict, NodeVisit, PathStart, Photon, PhotonVerdict, PixelColour, PixelSample, Purpose,
    QueueAction, QueueStep, RayEnd, RaySlab, RayStart, RayVerdict, Shade, SlabTest, Stored,
    Verdict, Visibility, WalkEnd, Why, ZSort, geometry_term,
};
pub(crate) use log::LogReader;
pub(crate) use log::Settings;
pub(crate) use log::StrategyName;
pub(crate) use log::Through;
pub(crate) use log::Transport;
#[cfg(feature = "schema")]
pub(crate) use log::generator;
pub(crate) use log::keys_of;
pub(crate) use log::png_bytes;
pub(crate) use log::{EventWriter, has_text, value_of, write_event};
pub use log::{
    LOG_VERSION, LightOptions, LineSink, LogError, LogNames, LoggedMistake, LoggedPicture,
    OfPixels, Spoilt, SpoiltValue, TestsOfRow, Totals, begins_log, fields_of, write_log_head,
    write_of_pixels,
};
#[cfg(feature = "schema")]
pub use log::{scene_schema, trace_schema};
pub(crate) use record::Counts;
pub(crate) use record::Off;
pub(crate) use record::Record;
pub(crate) use record::Recorder;
pub(crate) use record::Recording;
pub(crate) use record::keep_paths_behind;
pub use record::{
    Budget, Filter, Item, Kinds, LightCount, PathSieve, RayCount, RayNode, RayTree, Region,
    SearchCount, Sink, TestCount, UsefulRays,
};
