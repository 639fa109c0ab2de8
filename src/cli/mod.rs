//! The command line: one file per verb. It reads scenes and logs, calls the library, writes files.

mod args;
mod book;
mod check;
mod compare;
mod completions;
mod convert;
mod course;
mod error;
mod figure;
mod figures;
mod init;
mod input;
mod inspect;
mod lesson;
mod light;
mod light_options;
mod mdbook;
mod new_folder;
mod notes;
mod one_word;
mod output;
mod output_folder;
mod pixel;
mod progress;
mod quiz;
mod raster;
mod render;
mod same_file;
mod schema;
mod shown;
mod signals;
mod stats;
mod step;
mod step_command;
mod structure_options;
mod trace;
mod typed;
mod usual;
mod word;

pub(crate) use error::Error;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{ArgMatches, CommandFactory, FromArgMatches};

use args::{Args, Colours, Verb};

/// Does what the arguments say; the first one is the name of the program.
pub(crate) fn run(arguments: impl Iterator<Item = OsString>) -> Result<ExitCode, Error> {
    let arguments: Vec<OsString> = arguments.collect();
    args::refuse_negative(&arguments)?;
    // before they are parsed, for help and usage errors
    anstream::ColorChoice::write_global(Colours::of(&arguments).into());
    let (Args { verb, quiet, .. }, matches) = parse(&arguments)?;
    if quiet {
        notes::be_quiet();
    }
    let done = match verb {
        Verb::Pixel(args) => pixel::run(&args),
        Verb::Step(args) => step::run(&args, &matches),
        Verb::Inspect(args) => inspect::run(&args, &matches),
        Verb::Trace(args) => trace::run(&args),
        Verb::Render(args) => render::run(&args),
        Verb::Compare(args) => compare::run(&args),
        Verb::Figure(args) => figure::run(&args),
        Verb::Figures(args) => figures::run(&args),
        Verb::Lesson(args) => return lesson::run(&args),
        Verb::Check(args) => return check::run(&args),
        Verb::Convert(args) => convert::run(&args),
        Verb::Schema(args) => schema::run(&args),
        Verb::Completions(args) => completions::run(&args),
        Verb::Book(args) => book::run(&args),
        Verb::Init(args) => init::run(&args),
        Verb::Mdbook(args) => return mdbook::run(&args),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// The arguments, with a tip where the numbers of one word were given as several.
fn parse(arguments: &[OsString]) -> Result<(Args, ArgMatches), Error> {
    let command = Args::command().color(Colours::of(arguments).into());
    let matches = |words: &[OsString]| command.clone().try_get_matches_from(words);
    let parsed =
        matches(arguments).and_then(|matches| Ok((Args::from_arg_matches(&matches)?, matches)));
    parsed.map_err(|error| {
        let makes_sense = |words: &[OsString]| matches(words).is_ok();
        Error::from(one_word::with_tip(error, arguments, makes_sense))
    })
}
