//! `{{#raystep-mistakes}}`: the mistakes that the exercises recognise, each with what it does, what it spoils, and where it is
//! found. And what stands below the picture of a mistake: its step, its exercises, its questions.

use crate::book::inline_code::code;
use crate::book::places::{Places, link, question_id};
use crate::book::run::for_shell;
use crate::explain::render::escaped;
use crate::lesson::Library;
use crate::lesson::exercise::{About, Exercise, exercises};
use crate::lesson::question::{Ask, QuestionSpec};
use crate::mistake::{Mistake, mistakes};
use crate::scene::{nearest_name, quoted};
use crate::trace::LoggedMistake;

/// The largest number of questions that are named for a mistake.
const MOST_QUESTIONS: usize = 3;

/// The table of all mistakes, or of those of a lesson, as HTML on one line.
///
/// # Errors
/// There is no such lesson, or no mistake in it.
pub(super) fn table(words: &[String], library: &Library) -> Result<String, String> {
    let lesson = match words {
        [] => None,
        [lesson] => Some(number(lesson, library)?),
        _ => return Err("one lesson may be named\n  as in {{#raystep-mistakes 04-sphere}}".into()),
    };
    let rows: String = mistakes()
        .filter_map(|mistake| {
            let found: Vec<String> = abouts()
                .filter(|about| about.mistakes.contains(&mistake.name))
                .filter(|about| lesson.is_none_or(|lesson| about.lesson == lesson))
                .map(About::id)
                .collect();
            let is_asked_for = lesson.is_none() || !found.is_empty();
            is_asked_for.then(|| row(mistake, &found))
        })
        .collect();
    if rows.is_empty() {
        return Err("no exercise of this lesson knows a mistake\n  omit the directive".into());
    }
    Ok(format!(
        "<div class=\"table-wrapper\" tabindex=\"0\" role=\"group\" aria-label=\"Mistakes\"><table class=\"raystep-mistakes\"><thead><tr><th>Mistake</th><th>What it does</th>\
         <th>It spoils</th><th>Exercise</th></tr></thead><tbody>{rows}</tbody></table></div>"
    ))
}

/// What leads on from the picture of a mistake: the command that steps through the first pixel that it spoils, the exercises that
/// know it, and the questions about it, those first that have it as a wrong choice.
///
/// `scene` is the scene's file as commands have it, `from` the chapter.
pub(super) fn leads(
    mistake: &LoggedMistake,
    scene: &str,
    library: &Library,
    places: &Places,
    from: &str,
) -> String {
    let [x, y] = mistake.pixel;
    let step = format!("raystep step {} {x},{y}", for_shell(scene));
    let mut all = vec![format!("Step: {}", code(&step))];
    let known = abouts().filter(|about| about.mistakes.contains(&mistake.name.as_str()));
    let ids: Vec<String> = known.map(|about| code(&about.id())).collect();
    if !ids.is_empty() {
        all.push(format!("Exercise: {}", ids.join(", ")));
    }
    let of_choice = |question: &QuestionSpec| has_choice(question, &mistake.name);
    let of_confusion = |question: &QuestionSpec| {
        let mut confusions = question.confusions.iter();
        confusions.any(|of| of.mistakes().contains(&mistake.name.as_str()))
    };
    let questions = library.lessons.iter().flat_map(|lesson| {
        let all = lesson.content.questions.iter();
        all.map(|of| (format!("{}/{}", lesson.name, of.name), of))
    });
    let (mut first, others): (Vec<_>, Vec<_>) = questions
        .filter(|(_, of)| of_choice(of) || of_confusion(of))
        .partition(|(_, of)| of_choice(of));
    first.extend(others);
    let links: Vec<String> = first
        .iter()
        .filter_map(|(name, _)| {
            let to = link(from, places.of_question(name)?, &question_id(name));
            Some(format!(
                "<a href=\"{}\">{}</a>",
                escaped(&to),
                escaped(name)
            ))
        })
        .take(MOST_QUESTIONS)
        .collect();
    if !links.is_empty() {
        all.push(format!("Question: {}", links.join(", ")));
    }
    all.join(". ") + "."
}

/// Is the mistake one of the wrong choices or numbers of a question?
fn has_choice(question: &QuestionSpec, mistake: &str) -> bool {
    let is_it = |name: &Option<String>| name.as_deref() == Some(mistake);
    match &question.ask {
        Ask::Number(of) | Ask::Value(of) => of.wrong.iter().any(|wrong| is_it(&wrong.mistake)),
        Ask::Choice(of) | Ask::Several(of) | Ask::Place(of) => {
            of.choices.iter().any(|choice| is_it(&choice.mistake))
        }
        Ask::Order(_)
        | Ask::Program(_)
        | Ask::Blank(_)
        | Ask::Reason(_)
        | Ask::Step(_)
        | Ask::Counterexample(_) => false,
    }
}

fn abouts() -> impl Iterator<Item = &'static About> {
    exercises().into_iter().map(Exercise::about)
}

fn row(mistake: &Mistake, found: &[String]) -> String {
    let exercises: Vec<String> = found
        .iter()
        .map(|id| format!("<code>{}</code>", escaped(id)))
        .collect();
    format!(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
        escaped(mistake.name),
        escaped(mistake.sentence),
        escaped(mistake.spoils),
        if exercises.is_empty() {
            "–".into()
        } else {
            exercises.join(" ")
        }
    )
}

/// The number of a lesson's folder.
fn number(lesson: &str, library: &Library) -> Result<u8, String> {
    let names: Vec<&str> = library.lessons.iter().map(|of| of.name.as_str()).collect();
    let digits = lesson.split('-').next().unwrap_or_default();
    let number = digits.parse().ok().filter(|_| names.contains(&lesson));
    number.ok_or_else(|| match nearest_name(lesson, names.iter().copied()) {
        Some(near) => format!(
            "there is no lesson {}\n  did you mean {near}?",
            quoted(lesson)
        ),
        None => format!(
            "there is no lesson {}\n  the lessons are {}",
            quoted(lesson),
            names.join(", ")
        ),
    })
}
