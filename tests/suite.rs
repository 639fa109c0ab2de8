//! The integration tests: one binary, a module per subject.

mod bad_input;
mod book;
mod bounds;
mod calculator;
mod cli;
mod compare;
mod exact;
mod figures;
mod grid_exact;
mod layers;
mod polygon_exact;
mod polygon_tilings;
mod published_counts;
mod recording;
mod refraction_table;
mod scene_format;
mod schema;
mod seeded;
mod simple_tracer;
mod sphere_exact;
mod strategies;
mod trace_log;
mod transports;
mod watertight;
mod worked_solution;
mod z_aligned;
