//! Threads, and a bar that shows how far they are.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::Error;
use crate::cli::notes::is_quiet;

/// Does the work on this number of threads; on all cores without a number.
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

/// A bar of scan lines on standard error; none where that is no terminal, and none with `--quiet`.
pub(crate) fn bar(scan_lines: u64) -> ProgressBar {
    bar_of(scan_lines, "scan lines")
}

/// A bar of whatever is counted.
pub(crate) fn bar_of(count: u64, what: &str) -> ProgressBar {
    if is_quiet() || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(count);
    let template = format!("{{bar:40}} {{pos}} of {{len}} {what}, {{eta}} left");
    match ProgressStyle::with_template(&template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
