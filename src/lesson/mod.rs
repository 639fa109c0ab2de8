//! The course's data: lesson files, the traces that their figures are drawn from, the questions, and the exercises.

pub mod check;
mod compare;
mod compare_transports;
mod error;
pub mod exercise;
mod file;
pub(crate) mod library;
mod own_figure;
mod picture;
pub mod question;
#[cfg(feature = "files")]
mod start;
mod step_figure;
mod thumbnail;
mod trace;
pub mod worksheet;

pub use compare::{compare, scan_lines_to_compare};
pub use compare_transports::{NotCompared, compare_transports, light_of_lamps};
pub use error::LessonError;
pub use file::LessonFile;
#[cfg(feature = "schema")]
pub use file::lesson_schema;
#[cfg(feature = "book")]
pub(crate) use library::FigureName;
pub use library::Lesson;
#[cfg(feature = "files")]
pub(crate) use library::Library;
pub use own_figure::{own_figure, wrong_figure};
#[cfg(feature = "files")]
pub use start::{CourseFile, Dependency, course, course_files, grading_files, handout_files};
pub use step_figure::{StepFigure, StepFigures, StepStrokes};
pub use thumbnail::{Thumbnail, thumbnail};
pub use trace::trace_figure;
