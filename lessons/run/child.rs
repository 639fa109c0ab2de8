//! A check in a process of its own, so that a function that never comes back ends nothing but its own check.

use std::cell::RefCell;
use std::fs::{self, File};
use std::io::{Seek, SeekFrom, Write};
use std::panic;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use raystep::lesson::exercise::{Outcome, Report, Seeds, Watch, message};

use crate::hand_in::SECRET;
use crate::limits::limit;
use crate::run::{Attempts, Files, commands};

/// Where the last panic was.
static PANICKED_AT: Mutex<Option<String>> = Mutex::new(None);

/// Writes where the check is into a file, over what stood there.
struct InFile(RefCell<(File, String)>);

impl InFile {
    fn write(&self, text: &str) {
        let (file, _) = &mut *self.0.borrow_mut();
        // who reads it finds nothing worse than an old place
        let _ = file.seek(SeekFrom::Start(0));
        let _ = file.write_all(text.as_bytes());
        let _ = file.set_len(text.len() as u64);
    }
}

impl Watch for InFile {
    fn case(&self, number: usize, note: &str) {
        let case = format!("{number}\n{note}");
        self.write(&case);
        self.0.borrow_mut().1 = case;
    }

    fn place(&self, place: &str) {
        let case = self.0.borrow().1.clone();
        self.write(&format!("{case}\n{place}"));
    }

    fn panicked_at(&self) -> Option<String> {
        let at = PANICKED_AT.lock().unwrap_or_else(PoisonError::into_inner);
        at.clone()
    }
}

/// Checks an exercise and writes the result.
pub(crate) fn check(attempts: Attempts, id: &str, seconds: u64, folder: &Path) {
    limit(seconds);
    panic::set_hook(Box::new(|info| {
        let mut at = PANICKED_AT.lock().unwrap_or_else(PoisonError::into_inner);
        *at = info.location().map(|place| {
            let file = Path::new(place.file());
            let parts: Vec<_> = file.iter().rev().take(2).collect();
            let parts: Vec<_> = parts
                .iter()
                .rev()
                .map(|part| part.to_string_lossy())
                .collect();
            format!("{}:{}", parts.join("/"), place.line())
        });
    }));
    let files = Files::of(id, folder);
    let (Some(attempt), Ok(progress)) = (
        attempts()
            .into_iter()
            .find(|attempt| attempt.about().id() == id),
        File::create(&files.progress),
    ) else {
        return;
    };
    let watch = InFile(RefCell::new((progress, String::new())));
    let seeds = SECRET.map_or(Seeds::PUBLIC, Seeds::of_secret);
    let outcome = attempt.check_with(&seeds, &watch);
    let picture = match &outcome {
        Outcome::Wrong(divergence) => fs::write(&files.picture, &divergence.picture).is_ok(),
        _ => false,
    };
    let commands = commands(attempt.about(), picture.then_some(&files.picture));
    let lines = message(attempt.about(), &outcome, &commands);
    let report = Report::new(
        attempt.about(),
        &outcome,
        &lines,
        commands.picture.as_deref(),
    );
    // without a report the check counts as broken
    let _ = fs::write(&files.report, report.to_string());
}
