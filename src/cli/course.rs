//! The lessons that a command is about: of a folder, or those that the program has in itself.

use std::path::PathBuf;

use raystep::lesson::Lesson;
use raystep::{Folder, Library};

use crate::cli::Error;

/// The lessons, and the folder in which their scenes are.
pub(crate) fn library(number: u8, folder: Option<&PathBuf>) -> Result<(Library, PathBuf), Error> {
    if let Some(folder) = folder {
        return Ok((Library::open(&Folder::new(folder))?, folder.clone()));
    }
    let prefix = format!("{number:02}-");
    let has_it = |folder: &str| {
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        entries
            .filter(|entry| entry.file_name().to_string_lossy().starts_with(&prefix))
            .any(|entry| entry.path().join("lesson.json").is_file())
    };
    match [".", "lessons"].iter().find(|folder| has_it(folder)) {
        Some(&".") => Ok((Library::open(&Folder::new("."))?, PathBuf::new())),
        Some(folder) => Ok((Library::open(&Folder::new(*folder))?, folder.into())),
        None => Ok((raystep::lesson::course()?, "course".into())),
    }
}

/// The lesson with a number.
pub(crate) fn lesson(library: &Library, number: u8) -> Result<&Lesson, Error> {
    let prefix = format!("{number:02}-");
    let found = library
        .lessons
        .iter()
        .find(|of| of.name.starts_with(&prefix));
    found.ok_or_else(|| {
        let with_questions = library
            .lessons
            .iter()
            .filter(|of| !of.content.questions.is_empty());
        let known: Vec<&str> = with_questions.map(|of| of.name.as_str()).collect();
        Error::Exercise {
            what: format!("there is no lesson {number}"),
            fix: format!("the lessons are {}", known.join(", ")),
        }
    })
}
