//! The drawing of a step, in a file of its own that was not there before.

use std::fs::{self, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use raystep::lesson::{StepFigure, StepFigures};
use raystep::scene::printable;
use raystep::step::StepLog;
use raystep::{Rendition, Width};

use crate::cli::Error;
use crate::cli::output::Output;
use crate::cli::same_file::Taken;
use crate::cli::step::address::Words;
use crate::cli::step::address_of;
use crate::cli::word::word;

/// The most drawings of one step that a folder keeps.
const MOST: u32 = 999;

/// Draws a step, writes the drawing into a new file of the current folder, and says which, with the command that makes it
/// again.
pub(crate) fn save(log: &StepLog, step: usize, words: &Words) -> Result<String, Error> {
    let rendition = Rendition {
        titled: true,
        ..Rendition::default()
    };
    let figures = StepFigures::new(log);
    let drawn = figures.draw(log, step, "raystep-step", (Width::Book, rendition));
    let StepFigure { spec, drawn } = drawn.map_err(|error| Error::Subject {
        what: error.what,
        fix: "go to a ray, a place or a test, and save there",
    })?;
    let at = address_of(log, log.step(step).events.start);
    let name = name_of(word(spec.kind), &words.stem(), words.pixel(), &at);
    let file = reserved(&name)?;
    let written = Output::create(&file, &Taken::nothing())
        .and_then(|out| out.write_whole(drawn.svg.as_bytes()));
    if let Err(error) = written {
        // the name was taken for the drawing alone
        let _ = fs::remove_file(&file);
        return Err(error);
    }
    // from the leaf at which the command begins, out to the step
    let leaf = log.leaf(log.step(step).events.start);
    let with_leaf = std::iter::once(leaf).chain(log.above(leaf));
    let outs = with_leaf.take_while(|&inner| inner != step).count();
    let script = format!("{}s", "out ".repeat(outs));
    Ok(format!(
        "saved as {}\nmade again by: {}",
        printable(&file.display().to_string()),
        words.doing(&at, &script)
    ))
}

/// `raystep-sphere-scene-80,60-37`
fn name_of(kind: &str, scene: &str, [x, y]: [u32; 2], at: &str) -> String {
    let plain = |text: &str| -> String {
        let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
        let letters = text.chars().map(|c| if is_plain(c) { c } else { '-' });
        letters.collect::<String>().trim_matches('-').into()
    };
    let scene = match plain(scene) {
        empty if empty.is_empty() => "scene".into(),
        scene => scene,
    };
    format!("raystep-{kind}-{scene}-{x},{y}-{}", plain(at))
}

/// An empty file of this name, or with a number behind it: one that was not there.
fn reserved(name: &str) -> Result<PathBuf, Error> {
    let error = |file: &Path, what: String, fix: &str| Error::Target {
        file: file.display().to_string(),
        what,
        fix: fix.into(),
    };
    let names = (1..=MOST).map(|number| match number {
        1 => PathBuf::from(format!("{name}.svg")),
        _ => PathBuf::from(format!("{name}-{number}.svg")),
    });
    for file in names {
        match OpenOptions::new().write(true).create_new(true).open(&file) {
            Ok(_) => return Ok(file),
            Err(source) if source.kind() == io::ErrorKind::AlreadyExists => {}
            Err(source) => {
                let what = format!("cannot be written: {source}");
                let fix = "start raystep in a folder that you may write to";
                return Err(error(&file, what, fix));
            }
        }
    }
    let file = PathBuf::from(format!("{name}.svg"));
    let what = format!("there are {MOST} drawings of this step already");
    Err(error(&file, what, "remove some of them"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_of_a_file_has_letters_that_every_system_takes() {
        let pixel = [80, 60];
        assert_eq!(
            name_of("sphere", "04-two roots", pixel, "37"),
            "raystep-sphere-04-two-roots-80,60-37"
        );
        assert_eq!(
            name_of("paths", "../a\u{1b}[31m", pixel, "#path17:3"),
            "raystep-paths-a--31m-80,60-path17-3"
        );
        assert_eq!(
            name_of("grid", "-", pixel, "0"),
            "raystep-grid-scene-80,60-0"
        );
    }
}
