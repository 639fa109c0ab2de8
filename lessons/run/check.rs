//! Checks the exercises whose names begin with, or contain, the words of the command line; all without words.

use std::process::ExitCode;

fn main() -> ExitCode {
    lessons::run::main(std::env::args().skip(1), lessons::attempts::attempts)
}
