//! Worksheets: a lesson's questions with other numbers for each seed, to be printed, and the key to them.
//!
//! ```text
//! vary       another pixel or other numbers of the scene, drawn from the seed
//!   ▶ skeleton  what must stay as it is, so that the question still makes sense
//!   ▶ sheet     which questions a sheet has, each traced anew, with its figure
//!   ▶ markdown  the sheet as text: with blanks, or with the key
//! ```

mod markdown;
mod sheet;
mod skeleton;
mod vary;

pub use sheet::{Figure, Item, Worksheet, worksheet};
