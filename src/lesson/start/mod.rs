//! The course in a new folder: as a student starts it, as a lecturer hands it out, and as the hand-in is checked.

mod course;
mod embedded;
mod export;

pub use course::{CourseFile, Dependency, course, course_files};
pub use export::{grading_files, handout_files};
