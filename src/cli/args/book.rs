//! The arguments of the verbs that build a book and begin a course.

use std::path::PathBuf;

use clap::{Args as ClapArgs, Subcommand};

/// A book.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep book build
  raystep book build my-course -o site")]
pub(crate) struct BookArgs {
    /// What is to be done.
    #[command(subcommand)]
    pub(crate) verb: BookVerb,
}

/// What can be done with a book.
#[derive(Debug, Subcommand)]
pub(crate) enum BookVerb {
    /// Build the pages; mdBook need not be installed.
    Build {
        /// Folder with book.toml [default: book, or this folder]
        #[arg(value_name = "DIR")]
        dir: Option<PathBuf>,
        /// Folder for the pages: a new or an empty one, or one with an older build [default: as book.toml says]
        #[arg(short, long, value_name = "OUT")]
        output: Option<PathBuf>,
    },
}

/// A new course.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Example:
  raystep init my-course")]
pub(crate) struct InitArgs {
    /// A new or an empty folder
    #[arg(value_name = "DIR")]
    pub(crate) dir: PathBuf,
}
