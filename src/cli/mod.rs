//! The command line: one file per verb. It reads scenes and logs, calls the library, writes files.

mod args;
mod compare;
mod completions;
mod convert;
mod error;
mod figure;
mod figures;
mod input;
mod light;
mod light_options;
mod mdbook;
mod output;
mod pixel;
mod progress;
mod raster;
mod render;
mod same_file;
mod schema;
mod signals;
mod stats;
mod structure_options;
mod trace;

pub(crate) use error::Error;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;

use args::{Args, Verb};

/// Does what the arguments say; the first one is the name of the program.
pub(crate) fn run(arguments: impl Iterator<Item = OsString>) -> Result<ExitCode, Error> {
    let arguments: Vec<OsString> = arguments.collect();
    args::refuse_negative(&arguments)?;
    let done = match Args::try_parse_from(arguments)?.verb {
        Verb::Pixel(args) => pixel::run(&args),
        Verb::Trace(args) => trace::run(&args),
        Verb::Render(args) => render::run(&args),
        Verb::Compare(args) => compare::run(&args),
        Verb::Figure(args) => figure::run(&args),
        Verb::Figures(args) => figures::run(&args),
        Verb::Convert(args) => convert::run(&args),
        Verb::Schema(args) => schema::run(&args),
        Verb::Completions(args) => completions::run(&args),
        Verb::Mdbook(args) => return mdbook::run(&args),
    };
    done.map(|()| ExitCode::SUCCESS)
}
