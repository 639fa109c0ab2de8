//! Where figures and questions stand in a book: links from one chapter to another lead there.

use std::collections::HashMap;

use crate::book::asks::Asks;
use crate::book::directive::Directive;
use crate::book::words::word;

/// The chapters that ask for what is linked to, the first for each.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    figures: HashMap<String, String>,
    chapters: Vec<String>,
}

impl Places {
    /// Notes what a chapter asks for; chapters come in the order of the book.
    pub(super) fn note(&mut self, chapter: &str, directives: &[Directive]) {
        self.chapters.push(chapter.into());
        for directive in directives {
            let Some(name) = directive.words.first() else {
                continue;
            };
            if Asks::named(&directive.word) == Ok(Asks::Figure) {
                let place = self.figures.entry(name.clone());
                place.or_insert_with(|| chapter.into());
            }
        }
    }

    /// Does the book have a chapter of this file?
    pub(super) fn has_chapter(&self, chapter: &str) -> bool {
        self.chapters.iter().any(|known| known == chapter)
    }

    /// The chapter that shows a figure.
    pub(super) fn of_figure(&self, name: &str) -> Option<&str> {
        self.figures.get(name).map(String::as_str)
    }
}

/// The id of the first drawing of a figure in a chapter, without that of later ones.
pub(super) fn figure_id(chapter: &str, figure: &str) -> String {
    word(&format!(
        "raystep-{}-{figure}",
        chapter.trim_end_matches(".md")
    ))
}

/// A link from one chapter's file to a place in another.
pub(super) fn link(from: &str, to: &str, id: &str) -> String {
    if from == to {
        return format!("#{id}");
    }
    let up = "../".repeat(from.matches('/').count());
    format!("{up}{to}#{id}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_leads_from_chapter_to_chapter() {
        assert_eq!(link("a.md", "a.md", "x"), "#x");
        assert_eq!(link("a.md", "below/b.md", "x"), "below/b.md#x");
        assert_eq!(link("below/b.md", "a.md", "x"), "../a.md#x");
        assert_eq!(
            figure_id("below/b.md", "12-grid/walk"),
            "raystep-below-b-12-grid-walk"
        );
    }
}
