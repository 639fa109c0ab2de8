//! What students write instead: wrong functions, each with a name and the signature of the right one.
//!
//! A [`Mistake`] is a pure function with a name, one sentence and the quantity that it spoils. There is a file for each subject,
//! and [`mistakes`] lists them all. They are the wrong answers of questions; and since a [`Wrong`] function is a set of
//! [`Parts`](crate::tracer::simple::Parts), each that replaces a part of the simple ray tracer has a picture:
//!
//! ```
//! use raystep::geometry::{Ray, Sides, Sphere, TRange};
//! use raystep::mistake::{Wrong, mistake};
//! use raystep::tracer::simple::Parts;
//!
//! // from the centre of a sphere of radius 2 the roots are −2 and 2
//! let wrong = mistake("first root always").unwrap().wrong;
//! let sphere = Sphere { center: glam::DVec3::ZERO, radius: 2.0 };
//! let ray = Ray::new(glam::DVec3::ZERO, glam::DVec3::X);
//! assert_eq!(wrong.root(&sphere, &ray, TRange::FORWARD, Sides::Both), Some(-2.0));
//! ```
//!
//! It leaves out what does not return at all, such as a walk that goes on beyond the last cell for ever.

mod at_work;
mod bound;
mod epsilon;
mod eye;
mod grid;
mod hierarchy;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
mod mistake;
mod normal;
mod outline;
mod plane;
mod polygon;
mod ray;
mod recursion;
mod reflection;
mod refraction;
mod registry;
mod root;
mod searched;
mod shade;
mod shadow;
mod shown;
mod slab;
mod spoil;
mod wrong;

pub use mistake::Mistake;
pub use registry::{mistake, mistakes};
pub use shown::{NotShown, shown};
pub use wrong::{WalkOfCells, Wrong};
