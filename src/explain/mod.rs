//! From events to words: the worked solution of a pixel, and tables of counts.
//!
//! Nothing here traces: what is printed comes from the records and the scene in the log.

mod counts;
mod json;
mod number;
mod page;
mod worked;

pub use counts::{counts_json, counts_text};
pub use json::pixel_json;
pub use page::printable;
pub use worked::{WorkedOptions, worked_solution};
