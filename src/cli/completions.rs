//! `raystep completions`: what a shell needs to complete the command.

use clap::CommandFactory;

use crate::cli::Error;
use crate::cli::args::{Args, CompletionsArgs};
use crate::cli::output::Output;

/// Prints completions.
pub(crate) fn run(args: &CompletionsArgs) -> Result<(), Error> {
    let mut command = Args::command();
    // into memory first: the generator itself panics on a closed pipe
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, "raystep", &mut script);
    Output::standard().write_whole(&script)
}
