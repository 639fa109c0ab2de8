//! The log as JSON Lines: a head with the settings and the scene, then one line for each event.

mod error;
pub(in crate::trace) mod fast;
pub(in crate::trace) mod flat_json;
mod light_options;
mod limits;
mod line_reader;
mod lines;
mod name_table;
mod reader;
mod schema;
mod settings;
mod writer;

pub use error::LogError;
pub use light_options::LightOptions;
pub use reader::{LogReader, begins_log};
pub(crate) use schema::generator;
pub use schema::{scene_schema, trace_schema};
pub use settings::{Settings, StrategyName, Through, Transport};
pub(crate) use writer::{EventWriter, write_event};
pub use writer::{LOG_VERSION, LineSink, LogNames, write_log_head};
