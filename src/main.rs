//! The command `raystep`: parse, run, print one error.

mod cli;

use std::io::{self, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::run(std::env::args_os()) {
        Ok(code) => code,
        // who closes a pipe has read enough
        Err(error) if error.is_closed_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            // if this fails, there is no place to report it
            let _ = match &error {
                cli::Error::Usage(usage) => usage.print(),
                told => writeln!(
                    io::stderr(),
                    "error: {}",
                    printable_lines(&told.to_string())
                ),
            };
            ExitCode::from(error.exit_code())
        }
    }
}

/// A message whose names cannot control the terminal.
fn printable_lines(message: &str) -> String {
    let lines: Vec<_> = message.lines().map(raystep::scene::printable).collect();
    lines.join("\n")
}
