//! A page as text: plain, with ANSI colours, as Markdown and as HTML.
//!
//! The words are the page's. A renderer adds what its medium has: room, colour, marks, and a hint at each fold, for
//! only who asked for the page knows how to ask for more of it.

mod ansi;
mod html;
mod markdown;
mod plain;

pub use ansi::ansi;
#[cfg(feature = "book")]
pub(crate) use html::whole;
pub use html::{STYLE, html, html_document};
pub(crate) use html::{escaped, whole_words};
pub(crate) use markdown::escaped as escaped_markdown;
pub use markdown::markdown;
pub use plain::plain;

use crate::explain::page::{Line, Tone, Unfold};

/// How a reader gets at what a line leaves out, in the words of the medium: `--all shows them`. No words where there
/// is no way.
pub type Hint = fn(Unfold) -> String;

/// The hint of a medium that has no way to show more.
pub fn no_hint(_: Unfold) -> String {
    String::new()
}

/// The hint at the end of a line, with its space and brackets.
fn hint_of(line: &Line, hint: Hint) -> String {
    let Tone::Folded(fold) = line.tone else {
        return String::new();
    };
    match hint(fold.shown_by) {
        words if words.is_empty() => words,
        words => format!(" ({words})"),
    }
}
