//! From events to words: the worked solution of a pixel, tables of counts, strategies compared.
//!
//! Nothing here traces: what is printed comes from the records and the scene in the log.

mod advance;
mod compare;
mod compare_text;
mod counts;
mod crowded;
mod json;
pub(crate) mod name;
mod number;
pub(crate) mod page;
mod part;
pub mod render;
mod table;
mod transports;
mod variants;
pub(crate) mod worked;

pub use crate::scene::printable;
pub use advance::{InAdvance, in_advance, in_advance_json, in_advance_text};
pub use compare::{Compared, Comparison, Cost};
pub use counts::{counts_json, counts_text};
pub use crowded::CrowdedCell;
pub use json::pixel_json;
pub use number::grouped;
pub(crate) use number::grouped_sum;
pub(crate) use number::{MINUS, cell_name, shown};
pub use page::{Fold, Line, Section, StepAddress, StepRange, Tone, Unfold};
pub use part::{DERIVATIONS, Derivation, Part};
pub use transports::{ErrorOf, TransportComparison, TransportCost};
pub use variants::{strategies_to_compare, strategy_title};
#[cfg(feature = "book")]
pub(crate) use worked::WorkedOptions;
pub(crate) use worked::WorkedSteps;
#[cfg(feature = "book")]
pub(crate) use worked::worked_solution;
