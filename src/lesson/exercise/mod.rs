//! Exercises: a student writes a function of the course, and learns which quantity went wrong first.
//!
//! A [`Task`] is the declaration of an exercise: what is asked for, the cases, the crate's own function, and which mistakes can
//! be recognised. It is generic over what goes in and over the function, so that an exercise is data and no mechanism of its own.
//! `course/` has a file for each lesson.
//!
//! ```
//! use raystep::geometry::Ray;
//! use raystep::lesson::exercise::{Outcome, Silent, course};
//!
//! // a student who forgets the origin
//! let student = course::POINT_AT_T.with(|ray: &Ray, t: f64| t * ray.direction);
//! let Outcome::Wrong(divergence) = student.check(&Silent) else {
//!     panic!("this is wrong");
//! };
//! assert_eq!(divergence.lines[0].label, "ray");
//! ```

mod about;
mod answer;
pub mod course;
mod keyed_hash;
mod message;
mod outcome;
mod report;
mod seeded;
pub mod supplied;
mod task;
mod value;
mod watch;

pub use about::{About, See};
pub use answer::{Answer, answer};
pub use course::exercises;
pub use message::{Commands, MOST_LINES, message};
pub use outcome::{CaseSaid, Compared, Divergence, Outcome};
pub use report::{Report, junit};
pub(in crate::lesson) use seeded::Seeded;
pub use seeded::Seeds;
pub use task::{Attempt, Case, Exercise, Form, Task};
pub use value::Value;
pub use watch::{Silent, Watch};
