//! `{{#raystep-mistakes}}`: the mistakes that the exercises recognise, each with what it does, what it spoils, and where it is
//! found.

use crate::explain::render::escaped;
use crate::lesson::Library;
use crate::lesson::exercise::{About, Exercise, exercises};
use crate::mistake::{Mistake, mistakes};
use crate::scene::{nearest_name, quoted};

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
        "<div class=\"table-wrapper\"><table class=\"raystep-mistakes\"><thead><tr><th>Mistake</th><th>What it does</th>\
         <th>It spoils</th><th>Exercise</th></tr></thead><tbody>{rows}</tbody></table></div>"
    ))
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
