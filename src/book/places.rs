//! Where figures and questions stand in a book: links from one chapter to another lead there.

use std::collections::HashMap;

use crate::book::asks::Asks;
use crate::book::directive::Directive;
use crate::book::words::word;

/// The chapters that ask for what is linked to, the first for each.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    figures: HashMap<String, String>,
    questions: HashMap<String, String>,
    answers: Option<String>,
    chapters: Vec<String>,
}

impl Places {
    /// Notes what a chapter asks for; chapters come in the order of the book. `questions` names those of a lesson, or all.
    pub(super) fn note(
        &mut self,
        chapter: &str,
        directives: &[Directive],
        questions: &dyn Fn(Option<&str>) -> Vec<String>,
    ) {
        self.chapters.push(chapter.into());
        for directive in directives {
            let first = directive.words.first();
            let named: Vec<String> = first.cloned().into_iter().collect();
            match Asks::named(&directive.word) {
                Ok(Asks::Figure) => keep(&mut self.figures, named, chapter),
                Ok(Asks::Question) => keep(&mut self.questions, named, chapter),
                Ok(Asks::Questions) => {
                    let all = questions(first.map(String::as_str));
                    keep(&mut self.questions, all, chapter);
                }
                Ok(Asks::Answers) => {
                    self.answers.get_or_insert_with(|| chapter.into());
                }
                _ => {}
            }
        }
    }

    /// The chapter that asks a question.
    pub(super) fn of_question(&self, name: &str) -> Option<&str> {
        self.questions.get(name).map(String::as_str)
    }

    /// The chapter that has all answers.
    pub(super) fn answers(&self) -> Option<&str> {
        self.answers.as_deref()
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

/// The first chapter stays.
fn keep(map: &mut HashMap<String, String>, names: Vec<String>, chapter: &str) {
    for name in names {
        map.entry(name).or_insert_with(|| chapter.into());
    }
}

/// The id of the first place that asks a question.
pub(super) fn question_id(name: &str) -> String {
    word(&format!("raystep-question-{name}"))
}

/// The id of an answer.
pub(super) fn answer_id(name: &str) -> String {
    word(&format!("raystep-answer-{name}"))
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
