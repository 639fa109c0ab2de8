//! The options of the stepper.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use raystep::step::Address;

use crate::cli::args::values::pixel;
use crate::cli::args::{Reading, Tracing};

/// The steps of one pixel.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep step scene.json 80,60
  raystep step scene.json 80,60 --strategy grid --script \"into over into n n w t\"
  raystep step part.jsonl 80,60 --at 37
  raystep step scene.json 80,60 --predict

The command ? lists all commands.")]
pub(crate) struct StepArgs {
    /// Scene (.json, .nff, .obj) or log; - is standard input
    pub(crate) scene: PathBuf,
    /// Column and row, counted from 0,0 at the top left
    #[arg(value_name = "X,Y", value_parser = pixel)]
    pub(crate) pixel: [u64; 2],
    /// Read commands, one or more a line, and print steps as plain text; this is also done where there is no terminal
    #[arg(long)]
    pub(crate) plain: bool,
    /// Do these commands and end, as in \"into n n w t\"
    #[arg(long, value_name = "COMMANDS")]
    pub(crate) script: Option<String>,
    /// Draw signs and lines in the terminal with letters of ASCII alone
    #[arg(long)]
    pub(crate) ascii: bool,
    /// Ask a question before a verdict is shown; the answer is a letter, or skip
    #[arg(long)]
    pub(crate) predict: bool,
    /// Begin at a step by its number in the log: 37, or #path17:37 on a path of light
    #[arg(long, value_name = "STEP")]
    pub(crate) at: Option<Address>,
    /// The most events of the pixel: all are kept in memory, 168 bytes each
    #[arg(long, value_name = "N", default_value_t = 2_000_000)]
    pub(crate) budget: u64,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// How it is traced.
    #[command(flatten)]
    pub(crate) tracing: Tracing,
}
