//! Notes: what a command says on standard error beside its result. `--quiet` silences them.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use raystep::scene::printable;

/// Was `--quiet` given? One command has one answer, and it is set before any work.
static QUIET: AtomicBool = AtomicBool::new(false);

/// No notes and no progress from now on. Errors remain.
pub(crate) fn be_quiet() {
    QUIET.store(true, Ordering::Relaxed);
}

/// Was `--quiet` given?
pub(crate) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Prints a note on standard error, on one line whatever the names in it hold.
pub(crate) fn note(text: &str) {
    if !is_quiet() {
        // a note that nobody can read stops nothing
        let _ = writeln!(io::stderr(), "note: {}", printable(text));
    }
}
