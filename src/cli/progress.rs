//! Threads, and a bar that shows how far they are.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::Error;

/// Does the work on so many threads; on all cores without a number.
pub(crate) fn on_threads<T: Send>(
    threads: Option<u16>,
    work: impl FnOnce() -> T + Send,
) -> Result<T, Error> {
    // 0 means as many as there are cores
    let threads = threads.map_or(0, usize::from);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|source| Error::Threads { source })?;
    Ok(pool.install(work))
}

/// A bar of scan lines on standard error; none where that is no terminal.
pub(crate) fn bar(scan_lines: u64) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(scan_lines);
    match ProgressStyle::with_template("{bar:40} {pos} of {len} scan lines, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
