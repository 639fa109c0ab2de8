//! What a student begins with.
#![allow(
    unreachable_pub,
    unused_imports,
    unused_variables,
    clippy::duplicate_mod,
    clippy::pedantic
)]

#[path = "../../src/lesson/start/attempts.rs.txt"]
pub(super) mod attempts;
#[path = "../../lessons/01-pinhole/exercise.rs"]
pub(super) mod l01;
#[path = "../../lessons/02-simple-tracer/exercise.rs"]
pub(super) mod l02;
#[path = "../../lessons/03-ray/exercise.rs"]
pub(super) mod l03;
#[path = "../../lessons/04-sphere/exercise.rs"]
pub(super) mod l04;
#[path = "../../lessons/05-shading/exercise.rs"]
pub(super) mod l05;
#[path = "../../lessons/06-polygon/exercise.rs"]
pub(super) mod l06;
#[path = "../../lessons/07-reflection-refraction/exercise.rs"]
pub(super) mod l07;
#[path = "../../lessons/08-transport/exercise.rs"]
pub(super) mod l08;
#[path = "../../lessons/09-cost/exercise.rs"]
pub(super) mod l09;
#[path = "../../lessons/10-bounds/exercise.rs"]
pub(super) mod l10;
#[path = "../../lessons/11-hierarchy/exercise.rs"]
pub(super) mod l11;
#[path = "../../lessons/12-grid/exercise.rs"]
pub(super) mod l12;
