//! `raystep mdbook`: the preprocessor, as mdBook calls it.

use std::io;
use std::process::ExitCode;

use raystep::preprocess;

use crate::cli::Error;
use crate::cli::args::{MdbookArgs, MdbookVerb};
use crate::cli::notes::note;
use crate::cli::output::Output;
use crate::cli::shown::Shown;

/// Follows the directives of the book on standard input, or says whether a renderer is supported.
pub(crate) fn run(args: &MdbookArgs) -> Result<ExitCode, Error> {
    if let Some(MdbookVerb::Supports { renderer }) = &args.verb {
        // what comes into the book is HTML
        let supported = renderer == "html";
        return Ok(ExitCode::from(u8::from(!supported)));
    }
    let done = preprocess(io::stdin().lock(), &Shown)?;
    for text in &done.notes {
        note(text);
    }
    Output::standard().write_whole(done.book.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
