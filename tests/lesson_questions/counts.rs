//! How many questions there are, and about what.

use std::collections::BTreeSet;

use raystep::lesson::exercise::{Exercise, exercises};
use raystep::lesson::question::{Ask, Confusion, QuestionSpec};

use raystep::Library;
use raystep::lesson::Lesson;

use super::lessons;

/// The lessons that have a number; other folders have figures alone.
fn numbered(library: &Library) -> Vec<&Lesson> {
    let has_number = |of: &&Lesson| of.name.starts_with(|c: char| c.is_ascii_digit());
    library.lessons.iter().filter(has_number).collect()
}

/// Does the question ask why or which?
fn asks_why_or_which(question: &QuestionSpec) -> bool {
    let text = question.text.to_lowercase();
    let mut words = text.split(|c: char| !c.is_alphabetic());
    words.any(|word| word == "why" || word == "which")
}

#[test]
fn each_lesson_has_eight_questions_and_half_of_them_ask_why_or_which() {
    let library = lessons();
    assert_eq!(numbered(library).len(), 12);
    for lesson in numbered(library) {
        let questions = &lesson.content.questions;
        let why = questions.iter().filter(|of| asks_why_or_which(of)).count();
        assert!(8 <= questions.len(), "{}: {}", lesson.name, questions.len());
        assert!(
            questions.len() <= 2 * why,
            "{}: {why} of {}",
            lesson.name,
            questions.len()
        );
    }
}

#[test]
fn from_lesson_03_on_one_question_is_from_two_lessons_before() {
    let library = lessons();
    let lessons = numbered(library);
    for place in 2..lessons.len() {
        let (lesson, before) = (lessons[place], lessons[place - 2]);
        let mut questions = lesson.content.questions.iter();
        let is_from = |of: &QuestionSpec| of.lesson.as_deref() == Some(before.name.as_str());
        assert!(
            questions.any(is_from),
            "{} asks nothing of {}",
            lesson.name,
            before.name
        );
    }
}

#[test]
fn each_of_the_twenty_confusions_has_a_question_and_all_but_the_last_an_exercise() {
    let library = lessons();
    let questions = || library.lessons.iter().flat_map(|of| &of.content.questions);
    let in_exercises: BTreeSet<&str> = exercises()
        .into_iter()
        .flat_map(|of| Exercise::about(of).mistakes)
        .copied()
        .collect();
    for confusion in Confusion::ALL {
        assert!(
            questions().any(|of| of.confusions.contains(confusion)),
            "no question about: {}",
            confusion.title()
        );
        let has_exercise = confusion
            .mistakes()
            .iter()
            .any(|name| in_exercises.contains(name));
        assert_eq!(
            has_exercise,
            *confusion != Confusion::EggsAtTheRim,
            "{}",
            confusion.title()
        );
    }
}

#[test]
fn every_way_to_answer_is_used() {
    let library = lessons();
    let questions = library.lessons.iter().flat_map(|of| &of.content.questions);
    let mut used = BTreeSet::new();
    let mut changed = 0;
    for question in questions {
        changed += usize::from(!question.change.is_empty());
        used.insert(match &question.ask {
            Ask::Number(_) => "number",
            Ask::Value(_) => "value",
            Ask::Choice(_) => "choice",
            Ask::Several(_) => "several",
            Ask::Place(_) => "place",
            Ask::Order(_) => "order",
            Ask::Program(_) => "program",
            Ask::Blank(_) => "blank",
            Ask::Reason(_) => "reason",
            Ask::Step(_) => "step",
            Ask::Counterexample(_) => "counterexample",
        });
    }
    assert_eq!(used.len(), 11, "{used:?}");
    assert!(6 <= changed, "{changed}");
}
