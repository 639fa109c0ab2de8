//! The integration tests: one binary, a module per subject.

mod exact;
mod polygon_exact;
mod polygon_tilings;
mod refraction_table;
mod scene_format;
mod seeded;
mod sphere_exact;
mod watertight;
