//! The preprocessor for mdBook: figures, worked solutions, numbers and tables come into a book from traces, so that none
//! of them can go stale.

mod directive;
mod error;
mod expand;
mod html;
pub(crate) mod preprocessor;
mod protocol;
mod stepper;
mod value;
mod words;

pub use error::{BookError, BookMistake};
pub use preprocessor::{BookOptions, Preprocessed};
