//! The protocol between mdBook and this program: a book goes in, the same book with its directives followed comes out.

use std::io::Read;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::book::directive::directives;
use crate::book::expand::{Expander, word};
use crate::book::protocol::{self, Book, Context, MDBOOK_VERSION};
use crate::book::{BookError, BookMistake};
use crate::files::Folder;
use crate::lesson::Library;
use crate::scene::LARGEST_FILE;

/// What `book.toml` says below `[preprocessor.raystep]`; the other keys are mdBook's own.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct BookOptions {
    /// The folder of the lessons, counted from that of `book.toml`.
    pub lessons: Option<PathBuf>,
    /// Whether a lesson's scenes, and their meshes, may lie outside of its folder.
    #[serde(default)]
    pub allow_outside: bool,
    /// mdBook's: the command that is called.
    #[serde(default)]
    command: Option<String>,
    /// mdBook's: for which renderers.
    #[serde(default)]
    renderers: Option<Vec<String>>,
    /// mdBook's: before which preprocessors.
    #[serde(default)]
    before: Option<Vec<String>>,
    /// mdBook's: after which preprocessors.
    #[serde(default)]
    after: Option<Vec<String>>,
    /// mdBook's: whether the book can do without.
    #[serde(default)]
    optional: Option<bool>,
}

/// Where lessons are looked for if nothing is said, here and on the command line.
const LESSONS: &str = "lessons";

/// A book with its directives followed.
#[derive(Clone, Debug)]
pub struct Preprocessed {
    /// As mdBook reads it: JSON.
    pub book: String,
    /// Notes, which stop nothing.
    pub notes: Vec<String>,
}

/// Reads what mdBook hands over and follows every directive of the book. Nothing is written anywhere.
///
/// # Errors
/// Input that is not mdBook's, settings that make no sense, lessons that cannot be read, or directives that cannot be
/// followed: all of those, each with its chapter and line.
pub fn preprocess(input: impl Read) -> Result<Preprocessed, BookError> {
    let mut json = Vec::new();
    let read = input.take(LARGEST_FILE).read_to_end(&mut json);
    read.map_err(|error| BookError::Protocol(error.to_string()))?;
    if json.is_empty() {
        return Err(BookError::Protocol("standard input is empty".into()));
    }
    let (context, mut book) = protocol::parse(&json).map_err(BookError::Protocol)?;
    let options = match context.config.pointer("/preprocessor/raystep") {
        Some(options) => BookOptions::deserialize(options)
            .map(Some)
            .map_err(|error| BookError::Settings(error.to_string()))?,
        None => None,
    };
    let options = options.unwrap_or_default();
    let given = options.lessons.clone();
    let folder = context
        .root
        .join(given.as_deref().unwrap_or(Path::new(LESSONS)));
    let mut notes: Vec<String> = version_note(&context).into_iter().collect();

    // a book without directives needs no lessons
    let [mut asks, mut escapes] = [false; 2];
    book.for_each_chapter(&mut |chapter| {
        asks |= !directives(chapter.content).is_empty();
        escapes |= chapter.content.contains("\\{{#raystep");
    });
    if asks {
        let library = Library::open(&Folder::new(folder).allow_outside(options.allow_outside))
            .map_err(|error| BookError::Lessons(Box::new(error)))?;
        // the command line looks there by itself
        let other = given.filter(|given| given != Path::new(LESSONS));
        let lessons = other.map(|given| given.display().to_string());
        let mistakes = follow(&mut book, &mut Expander::new(&library, lessons));
        if !mistakes.is_empty() {
            return Err(BookError::Directives(mistakes));
        }
    }
    let before = options.before.unwrap_or_default();
    if escapes && !before.iter().any(|name| name == "links") {
        notes.push(
            "book.toml: add before = [\"links\"] to [preprocessor.raystep]: mdBook's own preprocessor takes \
             the backslash from \\{{#raystep …}}"
                .into(),
        );
    }
    Ok(Preprocessed {
        book: book.json(),
        notes,
    })
}

/// Follows the directives of all chapters, sub-chapters included.
fn follow(book: &mut Book, expander: &mut Expander) -> Vec<BookMistake> {
    let mut mistakes = Vec::new();
    book.for_each_chapter(&mut |chapter| {
        let file = chapter.file;
        expander.begin_chapter(word(file.trim_end_matches(".md")));
        let content = &*chapter.content;
        let mut followed = String::with_capacity(content.len());
        let mut copied = 0;
        for directive in directives(content) {
            followed.push_str(&content[copied..directive.range.start]);
            copied = directive.range.end;
            match expander.expand(&directive) {
                Ok(text) => followed.push_str(&text),
                Err(what) => mistakes.push(BookMistake {
                    chapter: file.clone(),
                    line: directive.line,
                    directive: content[directive.range].into(),
                    what,
                }),
            }
        }
        followed.push_str(&content[copied..]);
        *chapter.content = followed;
    });
    mistakes
}

/// mdBook's protocol may change with every 0.x.
fn version_note(context: &Context) -> Option<String> {
    let series = |version: &str| {
        version
            .split('.')
            .take(2)
            .map(String::from)
            .collect::<Vec<_>>()
    };
    (series(&context.mdbook_version) != series(MDBOOK_VERSION)).then(|| {
        format!(
            "this raystep was made for mdBook {MDBOOK_VERSION}, and is called by {}: it may not work",
            context.mdbook_version
        )
    })
}
