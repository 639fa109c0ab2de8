//! The exercises of the course: a file for each lesson.

#![expect(
    clippy::type_complexity,
    reason = "the type of an exercise says the signature of the function that a student writes"
)]

mod l01;
mod l02;
mod l03;
mod l04;
mod l05;
mod l06;
mod l07;
mod l08;
mod l09;
mod l10;
mod l11;
mod l12;
mod shared;

pub use l01::{EYE_RAY, WINDOW_POINT};
pub use l02::NEAREST;
pub use l03::{NORMALISED, POINT_AT_T};
pub use l04::{COEFFICIENTS, ROOT_THAT_COUNTS, ROOTS};
pub use l05::{BLOCKED, EPSILON, LIGHT_TERM, NORMALS, SHADE};
pub use l06::{CROSSINGS, DROPPED_AXIS, INSIDE, PLANE_T};
pub use l07::{CHILDREN, REFLECT, REFRACT};
pub use l08::{DIFFUSE_DIRECTION, GEOMETRY_TERM, IRRADIANCE};
pub use l09::{ALIGN, COST, Z_SORT};
pub use l10::{BOUND_VERDICT, INTERVAL, SLAB_INTERVAL, SLAB_OF, SLAB_RAY, SPHERE_AROUND, UNION};
pub use l11::{HEAP, HIER_TRAVERSE, SPLIT_COST};
pub use l12::{CELL_OF, FIRST_PLANES, NEXT_CELL, OBJECT_TO_CELLS, WALK, WALK_ENDS};

use crate::lesson::exercise::Exercise;

/// All exercises, in the order of the course.
pub fn exercises() -> Vec<&'static dyn Exercise> {
    let lessons: [&[&'static dyn Exercise]; 12] = [
        &l01::ALL,
        &l02::ALL,
        &l03::ALL,
        &l04::ALL,
        &l05::ALL,
        &l06::ALL,
        &l07::ALL,
        &l08::ALL,
        &l09::ALL,
        &l10::ALL,
        &l11::ALL,
        &l12::ALL,
    ];
    lessons.concat()
}
