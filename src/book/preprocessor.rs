//! The protocol between mdBook and this program: a book goes in, the same book with its directives followed comes out.

use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::book::directive::{Directive, directives};
use crate::book::expand::{Expander, LESSONS};
use crate::book::formula::{Formula, Is, formulas, latex, mathml};
use crate::book::inline_code::inline_code;
use crate::book::places::Places;
use crate::book::protocol::{self, Book, Context, MDBOOK_VERSION};
use crate::book::question::names as question_names;
use crate::book::{BookError, BookMistake, Commands, Project};
use crate::explain::render::whole;
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

/// A book with its directives followed.
#[derive(Clone, Debug)]
pub struct Preprocessed {
    /// As mdBook reads it: JSON.
    pub book: String,
    /// Notes, which stop nothing.
    pub notes: Vec<String>,
}

/// Reads what mdBook hands over and follows every directive and every formula of the book. Nothing is written anywhere.
///
/// # Errors
/// Input that is not mdBook's, settings that make no sense, lessons that cannot be read, or directives that cannot be
/// followed: all of those, each with its chapter and line.
pub fn preprocess(input: impl Read, commands: &dyn Commands) -> Result<Preprocessed, BookError> {
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
    let lessons = options.lessons.as_deref().unwrap_or(Path::new(LESSONS));
    let mut notes: Vec<String> = version_note(&context).into_iter().collect();

    // a book without directives needs no lessons
    let [mut asks, mut escapes] = [false; 2];
    book.for_each_chapter(&mut |chapter| {
        asks |= !directives(chapter.content).is_empty();
        escapes |= chapter.content.contains("\\{{#raystep");
    });
    let mistakes = if asks {
        let folder = Folder::new(context.root.join(lessons)).allow_outside(options.allow_outside);
        let library =
            Library::open(&folder).map_err(|error| BookError::Lessons(Box::new(error)))?;
        let project = Project::new(&context.root, lessons);
        let mut places = Places::default();
        let questions = |lesson: Option<&str>| {
            let all = library.lessons.iter();
            let of = all.filter(|of| lesson.is_none_or(|lesson| lesson == of.name));
            of.flat_map(question_names).collect()
        };
        book.for_each_chapter(&mut |chapter| {
            places.note(&chapter.file, &directives(chapter.content), &questions);
        });
        follow(
            &mut book,
            &mut Some(Expander::new(&library, &project, commands, places)),
        )
    } else {
        follow(&mut book, &mut None)
    };
    if !mistakes.is_empty() {
        return Err(BookError::Directives(mistakes));
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

/// Follows the directives and the formulas of all chapters, sub-chapters included. Without directives there is no expander.
fn follow(book: &mut Book, expander: &mut Option<Expander>) -> Vec<BookMistake> {
    let mut mistakes = Vec::new();
    book.for_each_chapter(&mut |chapter| {
        if let Some(expander) = expander {
            expander.begin_chapter(chapter.file.clone());
        }
        let content = &*chapter.content;
        let mut followed = String::with_capacity(content.len());
        let mut copied = 0;
        for piece in pieces(content) {
            let range = piece.range(content);
            followed.push_str(&content[copied..range.start]);
            copied = range.end;
            match piece.follow(content, expander) {
                Ok(text) => followed.push_str(&text),
                Err(Fault { at, what }) => mistakes.push(BookMistake {
                    chapter: chapter.file.clone(),
                    line: content[..at.start].matches('\n').count() + 1,
                    directive: content[at].into(),
                    what,
                }),
            }
        }
        followed.push_str(&content[copied..]);
        *chapter.content = followed;
    });
    mistakes
}

/// Marks that may follow a formula, each a byte long.
const MARKS: [char; 7] = ['.', ',', ';', ':', '!', '?', ')'];

/// What takes another shape in a chapter.
enum Piece {
    Directive(Directive),
    /// A formula and the directives in it.
    Formula(Formula, Vec<Directive>),
    /// Inline code, and what comes in its place.
    Code(Range<usize>, String),
}

/// What is wrong with a piece, and where.
struct Fault {
    at: Range<usize>,
    what: String,
}

/// The directives and the formulas of a chapter, in order.
fn pieces(content: &str) -> Vec<Piece> {
    let all = directives(content);
    let ranges: Vec<Range<usize>> = all.iter().map(|of| of.range.clone()).collect();
    let mut all = all.into_iter().peekable();
    let mut pieces = Vec::new();
    for formula in formulas(content, &ranges) {
        let Range { start, end } = formula.range;
        while let Some(before) = all.next_if(|of| of.range.start < start) {
            pieces.push(Piece::Directive(before));
        }
        let inside = std::iter::from_fn(|| all.next_if(|of| of.range.start < end));
        let inside = inside.collect();
        pieces.push(Piece::Formula(formula, inside));
    }
    pieces.extend(all.map(Piece::Directive));
    for (range, html) in inline_code(content) {
        let meets = |piece: &Piece| {
            let other = piece.range(content);
            other.start < range.end && range.start < other.end
        };
        if !pieces.iter().any(meets) {
            pieces.push(Piece::Code(range, html));
        }
    }
    pieces.sort_by_key(|piece| piece.range(content).start);
    pieces
}

impl Piece {
    /// Where it stands; with a formula the mark that ends its sentence, so that both stay on one line.
    fn range(&self, content: &str) -> Range<usize> {
        match self {
            Self::Directive(directive) => directive.range.clone(),
            Self::Code(range, _) => range.clone(),
            Self::Formula(formula, _) => {
                let Range { start, end } = formula.range;
                let has_mark = formula.is == Is::Inline && content[end..].starts_with(MARKS);
                start..end + usize::from(has_mark)
            }
        }
    }

    /// What stands in its place.
    fn follow(&self, content: &str, expander: &mut Option<Expander>) -> Result<String, Fault> {
        let fault = |at: &Range<usize>| {
            let at = at.clone();
            move |what| Fault { at, what }
        };
        match (self, expander) {
            (Self::Code(_, html), _) => Ok(html.clone()),
            (Self::Directive(directive), Some(expander)) => {
                let text = expander.expand(directive);
                text.map_err(fault(&directive.range))
            }
            // there is an expander wherever there are directives
            (Self::Directive(directive), None) => Ok(content[directive.range.clone()].into()),
            (Self::Formula(formula, inside), expander) => {
                let mut filled = String::new();
                let mut copied = formula.range.start;
                for directive in inside {
                    filled.push_str(&content[copied..directive.range.start]);
                    copied = directive.range.end;
                    if let Some(expander) = expander {
                        let value = expander.expand_in_formula(directive);
                        filled.push_str(&value.map_err(fault(&directive.range))?);
                    }
                }
                filled.push_str(&content[copied..formula.range.end]);
                let before = &content[..formula.range.start];
                let formula_latex = latex(before, &filled, formula.is);
                let html = mathml(&formula_latex, formula.is).map_err(fault(&formula.range))?;
                let mark = &content[formula.range.end..self.range(content).end];
                Ok(match mark {
                    "" => html,
                    _ => whole(&format!("{html}{mark}")),
                })
            }
        }
    }
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
