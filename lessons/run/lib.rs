//! The student's crate: the functions of the course, and what checks them.
//!
//! You write in `NN-topic/exercise.rs`. Nothing here is to be changed.

pub mod attempts;
mod child;
pub mod files;
mod hand_in;
mod limits;
pub mod parts;
pub mod run;

#[cfg_attr(feature = "solutions", path = "../01-pinhole/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../01-pinhole/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l01;

#[cfg_attr(feature = "solutions", path = "../02-simple-tracer/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../02-simple-tracer/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l02;

#[cfg_attr(feature = "solutions", path = "../03-ray/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../03-ray/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l03;

#[cfg_attr(feature = "solutions", path = "../04-sphere/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../04-sphere/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l04;

#[cfg_attr(feature = "solutions", path = "../05-shading/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../05-shading/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l05;

#[cfg_attr(feature = "solutions", path = "../06-polygon/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../06-polygon/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l06;

#[cfg_attr(
    feature = "solutions",
    path = "../07-reflection-refraction/solution.rs"
)]
#[cfg_attr(
    not(feature = "solutions"),
    path = "../07-reflection-refraction/exercise.rs"
)]
#[allow(unused_imports, unused_variables)]
pub mod l07;

#[cfg_attr(feature = "solutions", path = "../08-transport/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../08-transport/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l08;

#[cfg_attr(feature = "solutions", path = "../09-cost/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../09-cost/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l09;

#[cfg_attr(feature = "solutions", path = "../10-bounds/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../10-bounds/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l10;

#[cfg_attr(feature = "solutions", path = "../11-hierarchy/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../11-hierarchy/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l11;

#[cfg_attr(feature = "solutions", path = "../12-grid/solution.rs")]
#[cfg_attr(not(feature = "solutions"), path = "../12-grid/exercise.rs")]
#[allow(unused_imports, unused_variables)]
pub mod l12;
