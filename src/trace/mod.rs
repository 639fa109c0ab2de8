//! What happened: events, who records them, and the log that they are kept in.

mod counts;
mod event;
mod event_blocks;
mod fields;
mod filter;
mod flat_json;
mod kind;
mod kinds;
mod light;
mod light_kinds;
mod light_options;
mod limits;
mod line_reader;
mod line_scanner;
mod log_error;
mod log_lines;
mod log_reader;
mod log_writer;
mod name_table;
mod number_texts;
mod path_sieve;
mod ray_tree;
mod recorder;
mod scanner;
mod schema;
mod search;
mod search_kinds;
mod settings;
mod short_text;
mod small_numbers;
mod useful_rays;
mod words;

pub use counts::{Counts, LightCount, RayCount, SearchCount, TestCount};
pub use event::{
    Event, LightTerm, Nearest, Outcome, PixelColour, PixelSample, Purpose, RayEnd, RayStart, Shade,
    Visibility,
};
pub use event_blocks::EventBlocks;
pub use filter::{Budget, Filter, Kinds, Region};
pub use kind::Kind;
pub use light::{
    Alternative, Arrival, Connection, Gathered, Nearby, PathStart, Photon, PhotonFate, Stored,
    geometry_term,
};
pub use light_options::LightOptions;
pub use log_error::LogError;
pub use log_reader::{LogReader, begins_log};
pub(crate) use log_writer::{EventWriter, write_event};
pub use log_writer::{LOG_VERSION, LineSink, LogNames, write_log_head};
pub use path_sieve::PathSieve;
pub use ray_tree::{Item, RayNode, RayTree};
use recorder::Numbering;
pub use recorder::{Off, Record, Recorder, Recording, Sink};
pub(crate) use schema::generator;
pub use schema::{scene_schema, trace_schema};
pub use search::{
    Aligned, AlignedPart, BoundOutcome, BoundTest, Bounded, CellVisit, GridEnter, GridExit,
    HitOutsideCell, NodeOutcome, NodeVisit, QueueAction, QueueStep, SlabTest, WalkEnd, ZSort,
};
pub use settings::{Settings, StrategyName, Through, Transport};
pub use useful_rays::UsefulRays;
