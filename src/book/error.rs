//! What is wrong in a book, with its chapter and line.

use std::fmt;

use crate::book::html::shortened;
use crate::lesson::LessonError;
use crate::scene::printable;

/// A directive that cannot be followed.
#[derive(Debug)]
pub struct BookMistake {
    /// The chapter's file, counted from the book's source folder.
    pub chapter: String,
    /// The line of the directive, counted from 1.
    pub line: usize,
    /// The directive as it stands there.
    pub directive: String,
    /// What is wrong, and what to do about it.
    pub what: String,
}

/// Why a book cannot be made.
#[derive(Debug)]
pub enum BookError {
    /// What mdBook handed over cannot be read.
    Protocol(String),
    /// The settings in `book.toml` make no sense.
    Settings(String),
    /// The lessons cannot be read.
    Lessons(Box<LessonError>),
    /// Directives that cannot be followed: all of them, in the order of the book.
    Directives(Vec<BookMistake>),
}

impl fmt::Display for BookMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            chapter,
            line,
            directive,
            what,
        } = self;
        /// More letters of a directive do not help to find it: its line is named, too.
        const LONGEST: usize = 120;
        let directive = shortened(directive, LONGEST);
        let what: Vec<String> = what.lines().map(printable).collect();
        write!(
            f,
            "{}, line {line}: {}: {}",
            printable(chapter),
            printable(&directive),
            what.join("\n")
        )
    }
}

impl fmt::Display for BookError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Protocol(why) => write!(
                f,
                "the input from mdBook cannot be read: {}\n  this verb is called by mdBook: put \
                 [preprocessor.raystep] into book.toml and run mdbook build",
                printable(why)
            ),
            Self::Settings(why) => write!(
                f,
                "book.toml, at preprocessor.raystep: {}\n  it may have \"lessons\", the folder of the lessons, \
                 relative to book.toml, and \"allow-outside\", true if their scenes may be outside it",
                printable(why)
            ),
            Self::Lessons(error) => match &**error {
                LessonError::Folder { folder, source } => {
                    let why = source
                        .as_ref()
                        .map_or("there is no lesson in it".into(), ToString::to_string);
                    write!(
                        f,
                        "book.toml, at preprocessor.raystep.lessons: {}: {why}\n  name the folder of the lessons, \
                         relative to book.toml; a lesson is a folder with a lesson.json",
                        printable(folder)
                    )
                }
                other => other.fmt(f),
            },
            Self::Directives(mistakes) => {
                let lines: Vec<String> = mistakes.iter().map(ToString::to_string).collect();
                f.write_str(&lines.join("\n"))
            }
        }
    }
}

impl std::error::Error for BookError {}
