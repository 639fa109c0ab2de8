//! The integration tests: one binary, a module per subject.

mod exact;
mod layers;
mod polygon_exact;
mod polygon_tilings;
mod published_counts;
mod refraction_table;
mod scene_format;
mod seeded;
mod sphere_exact;
mod watertight;
