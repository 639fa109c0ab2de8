//! The preprocessor for mdBook: figures, worked solutions, numbers and tables come into a book from traces, so that none
//! of them can go stale.

mod asks;
mod blanks;
mod code;
mod costs;
mod directive;
mod error;
mod expand;
mod formula;
mod html;
mod inline_code;
mod map;
mod mistakes;
mod paper;
mod places;
pub(crate) mod preprocessor;
mod project;
mod protocol;
mod question;
mod run;
mod same_trace;
mod stepper;
mod value;
mod words;
mod worked;

pub use error::{BookError, BookMistake};
pub use paper::PrintPage;
pub use preprocessor::{BookOptions, Preprocessed};
pub use project::Project;
pub use run::{Commands, NoCommands, Ran};
