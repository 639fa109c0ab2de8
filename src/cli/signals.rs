//! Signals that end the program: what it has not finished is removed first, and the shell learns which signal it was.

use std::sync::{Mutex, Once, PoisonError};

/// What is done before a signal ends the program.
type CleanUp = Box<dyn FnOnce() + Send>;

/// All that is to be done then.
static CLEAN_UPS: Mutex<Vec<CleanUp>> = Mutex::new(Vec::new());

/// Does this once when a signal ends the program, after what was asked for before; then the program ends with 128 + the signal's
/// number, as shells do: 130 for SIGINT (Ctrl-C), 143 for SIGTERM, 129 for SIGHUP. A signal that was ignored when the program started
/// stays ignored, as SIGHUP under nohup.
pub(crate) fn before_the_end(clean_up: impl FnOnce() + Send + 'static) {
    static LISTENS: Once = Once::new();
    clean_ups().push(Box::new(clean_up));
    LISTENS.call_once(|| {
        listen(|| {
            let all = std::mem::take(&mut *clean_ups());
            for clean_up in all {
                clean_up();
            }
        });
    });
}

fn clean_ups() -> std::sync::MutexGuard<'static, Vec<CleanUp>> {
    CLEAN_UPS.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(unix)]
fn listen(clean_up: impl FnOnce() + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    let heeded = [SIGINT, SIGTERM, SIGHUP].into_iter();
    let heeded = heeded.filter(|signal| !is_ignored(*signal));
    // without a handler a signal ends the program all the same, and leaves its temporary file behind
    if let Ok(mut signals) = Signals::new(heeded) {
        std::thread::spawn(move || {
            if let Some(signal) = signals.forever().next() {
                clean_up();
                std::process::exit(128 + signal);
            }
        });
    }
}

/// Was the signal ignored when the program started?
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        return ignored_in(&status, signal);
    }
    // A system without /proc: a child inherits what is ignored, and lives on after such a signal.
    let kill = format!("kill -{signal} $$");
    let shell = std::process::Command::new("sh")
        .args(["-c", &kill])
        .status();
    shell.is_ok_and(|status| status.success())
}

/// What Linux says of a process: of the ignored signals a number in base 16, signal 1 its lowest bit.
#[cfg(unix)]
fn ignored_in(status: &str, signal: i32) -> bool {
    let mut lines = status.lines();
    let mask = lines.find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
    mask.is_some_and(|mask| (mask >> (signal - 1)) & 1 == 1)
}

/// Where there is Ctrl-C alone, it ends the program with 130, as a shell on Unix would.
#[cfg(not(unix))]
fn listen(clean_up: impl FnOnce() + Send + 'static) {
    const INTERRUPTED: i32 = 130;
    let mut clean_up = Some(clean_up);
    // without a handler Ctrl-C ends the program all the same, and leaves its temporary file behind
    let _ = ctrlc::try_set_handler(move || {
        if let Some(clean_up) = clean_up.take() {
            clean_up();
        }
        std::process::exit(INTERRUPTED);
    });
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn the_mask_of_ignored_signals_begins_with_signal_1() {
        let status = "Name:\traystep\nSigBlk:\tffffffffffffffff\nSigIgn:\t0000000000001001\n";
        let ignored: Vec<i32> = (1..=64).filter(|of| ignored_in(status, *of)).collect();
        assert_eq!(ignored, [1, 13]);
    }
}
