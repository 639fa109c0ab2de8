//! The options of the checker of foreign logs.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};
use raystep::lesson::check::TOLERANCE;
use raystep::trace::Kind;

use crate::cli::args::values::{kind, tolerance};
use crate::cli::args::{Reading, Tracing};

/// A log of any ray tracer against a scene.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep check scene.json mine.jsonl
  ./my-tracer scene.json | raystep check scene.json -
  raystep check scene.json mine.jsonl --only sphere_test --tolerance 1e-3

The log has one JSON object a line, of any kinds and with any of their fields; lessons/any-language says how to write
one. The answer is the first line that differs, with the mistake that gives it; exit 1 then, 0 if nothing differs.")]
pub(crate) struct CheckArgs {
    /// Scene (.json, .nff, .obj)
    pub(crate) scene: PathBuf,
    /// Log; - is standard input
    pub(crate) log: PathBuf,
    /// Kinds of event to compare, such as ray,sphere_test
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = kind)]
    pub(crate) only: Vec<Kind>,
    /// How far numbers may differ, relative to the larger of 1 and the expected one; 1e-3 for 32-bit numbers
    #[arg(long, value_name = "T", default_value_t = TOLERANCE, value_parser = tolerance)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) tolerance: f64,
    /// How the answer is written
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: CheckFormat,
    /// Where the picture with both answers goes, if something differs
    #[arg(long, value_name = "F.svg", default_value = "raystep-check.svg")]
    pub(crate) picture: PathBuf,
    /// Draw no picture
    #[arg(long, conflicts_with = "picture")]
    pub(crate) no_picture: bool,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// How the scene is traced.
    #[command(flatten)]
    pub(crate) tracing: Tracing,
}

/// How the answer of a check is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CheckFormat {
    /// For reading.
    Text,
    /// For programs.
    Json,
    /// For programs that show tests.
    Junit,
}
