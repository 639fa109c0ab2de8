//! The log as JSON Lines: a head with the settings and the scene, then one line for each event.
//!
//! [`line_writer`] writes a line and [`line_reader`] reads it; `fast` does the same for logs of many lines: its
//! `EventWriter` is what a log is written with, and [`line_reader`] asks its scanner first.

mod error;
mod event_schema;
mod fast;
mod flat_json;
mod head;
mod light_options;
mod limits;
mod line_reader;
mod line_sink;
mod line_values;
mod line_writer;
mod lines;
mod name_table;
mod names;
mod of_pixels;
mod place;
pub(crate) mod png_bytes;
pub(crate) mod reader;
#[cfg(feature = "schema")]
mod schema;
pub(crate) mod settings;

pub use error::LogError;
pub use event_schema::fields_of;
pub(crate) use event_schema::keys_of;
pub(crate) use fast::EventWriter;
pub use head::{LOG_VERSION, write_log_head, write_of_pixels};
pub use light_options::LightOptions;
pub use line_sink::LineSink;
pub(crate) use line_values::{has_text, value_of};
pub(crate) use line_writer::write_event;
pub use names::LogNames;
pub use of_pixels::{
    LoggedMistake, LoggedPicture, OfPixels, Spoilt, SpoiltValue, TestsOfRow, Totals,
};
pub(crate) use reader::LogReader;
pub use reader::begins_log;
#[cfg(feature = "schema")]
pub(crate) use schema::generator;
#[cfg(feature = "schema")]
pub use schema::{scene_schema, trace_schema};
pub(crate) use settings::Settings;
pub(crate) use settings::StrategyName;
pub(crate) use settings::Through;
pub(crate) use settings::Transport;
