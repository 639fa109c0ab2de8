//! Steps in HTML: a pixel's steps as data, and the pages that show them.
//!
//! ```text
//! step + explain ─▶ steps    all that the steps of a pixel say, their questions, and the tables of their moves
//!                     │
//!                     ├─ json      the data inside a page: every text stays text
//!                     ├─ stepper   the stepper of a book: the figure, and the list of its steps
//!                     ├─ quiz      a question of a book
//!                     ├─ packed    all steps of a pixel with their moves, for a page that holds many
//!                     ├─ forms     texts that differ in numbers alone: each form once
//!                     ├─ filter    what a filter looks at, by event
//!                     └─ inspect   one page of a picture and its pixels
//!
//! core.js, core.css         what the pages share: a step's words, and its question
//! stepper.js, stepper.css   the stepper of a book
//! quiz.js, quiz.css         a question of a book
//! inspect.js, inspect.css   the page of a picture
//! ```
//!
//! The words, the questions and the moves come from `step`. The scripts look them up and show them; they compute none.

mod filter;
mod forms;
mod inspect;
mod json;
mod packed;
mod quiz;
mod stepper;
mod steps;

pub use filter::FILTER_KEYS;
pub use inspect::{HeatOverlay, InspectPage, PageTooLarge};
pub use packed::{PackedPixel, View};
pub use quiz::{Quiz, QuizData, quiz, told};
pub use stepper::{Stepper, shared, stepper};
pub use steps::{LineFace, MovesFace, PixelSteps, QuestionFace, StepFace, TracePlace};
