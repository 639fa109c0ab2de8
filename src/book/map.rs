//! `{{#raystep-map FILE}}`: where each subject of a course is: slide, chapter, figure, kind of event, exercise.
//!
//! The rows are data in a file beside `book.toml`; each name in it must exist, and the chapter is found by the figure.

use std::fs;

use serde::Deserialize;

use crate::book::Project;
use crate::book::places::{Places, figure_id, link};
use crate::explain::render::escaped;
use crate::lesson::Library;
use crate::lesson::exercise::{About, Exercise, exercises};
use crate::scene::{nearest_name, quoted};
use crate::trace::Kind;

/// The file of a map.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Map {
    rows: Vec<Row>,
}

/// A subject.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    /// Where the slides have it.
    slide: String,
    /// What it is.
    subject: String,
    /// Its figure; the chapter is the first that shows it.
    figure: Option<String>,
    /// Its chapter, where no figure tells it.
    chapter: Option<String>,
    /// The kind of event that records it.
    kind: Option<String>,
    /// The exercise in which it is written, as in `04/roots`.
    exercise: Option<String>,
    /// Why a figure, a kind or an exercise is missing.
    why: Option<String>,
}

/// The table of a map, as HTML on one line.
///
/// # Errors
/// The file cannot be read, or names what does not exist.
pub(super) fn map(
    words: &[String],
    chapter: &str,
    project: &Project,
    library: &Library,
    places: &Places,
) -> Result<String, String> {
    let [file] = words else {
        return Err("one file has the rows\n  as in {{#raystep-map map.json}}".into());
    };
    let path = project.book.join(file);
    let text = fs::read_to_string(&path).map_err(|error| {
        format!(
            "{} cannot be read: {error}\n  it lies beside book.toml",
            quoted(file)
        )
    })?;
    let map: Map =
        serde_json::from_str(&text).map_err(|error| format!("{file}: {error}\n  mend it"))?;
    let mut body = String::new();
    for row in &map.rows {
        let row = row_of(row, chapter, library, places)
            .map_err(|why| format!("{file}, {}: {why}", quoted(&row.subject)))?;
        body.push_str(&row);
    }
    let head = [
        "Slide",
        "Subject",
        "Chapter",
        "Figure",
        "Kind of event",
        "Exercise",
    ];
    let head = head.map(|name| ["<th>", name, "</th>"].concat()).concat();
    Ok(format!(
        "<div class=\"table-wrapper\" tabindex=\"0\" role=\"group\" aria-label=\"Map\"><table class=\"raystep-map\"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    ))
}

fn row_of(row: &Row, from: &str, library: &Library, places: &Places) -> Result<String, String> {
    let mut is_missing = false;
    let none = "–";
    let figure = match &row.figure {
        Some(name) => {
            let parsed = name.parse().map_err(|why: String| why)?;
            library.find(&parsed).map_err(|error| error.to_string())?;
            Some(name)
        }
        None => None,
    };
    let shown_in = figure.and_then(|name| places.of_figure(name));
    let chapter = match (shown_in, &row.chapter) {
        (Some(chapter), _) => chapter,
        (None, Some(chapter)) => chapter,
        (None, None) => {
            return Err("no chapter shows its figure\n  show it, or name a \"chapter\"".into());
        }
    };
    if !places.has_chapter(chapter) {
        return Err(format!(
            "there is no chapter {}\n  name a file of SUMMARY.md",
            quoted(chapter)
        ));
    }
    let to_chapter = format!(
        "<a href=\"{}\">{}</a>",
        escaped(link(from, chapter, "").trim_end_matches('#')),
        escaped(chapter.trim_end_matches(".md"))
    );
    let figure = match (figure, shown_in) {
        (Some(name), Some(chapter)) => {
            let id = format!("{}_figure", figure_id(chapter, name));
            format!(
                "<a href=\"{}\">{}</a>",
                escaped(&link(from, chapter, &id)),
                escaped(name)
            )
        }
        (Some(name), None) => escaped(name),
        (None, _) => none.into(),
    };
    let kind = match &row.kind {
        Some(name) => {
            let known = Kind::ALL.map(Kind::name);
            Kind::named(name).ok_or_else(|| match nearest_name(name, known.into_iter()) {
                Some(near) => format!("there is no kind {}\n  did you mean {near}?", quoted(name)),
                None => format!("there is no kind {}", quoted(name)),
            })?;
            format!("<code>{}</code>", escaped(name))
        }
        None => {
            is_missing = true;
            none.into()
        }
    };
    let exercise = match &row.exercise {
        Some(name) => format!("<code>{}</code>", escaped(&about(name)?.id())),
        None => {
            is_missing = true;
            none.into()
        }
    };
    let exercise = match &row.why {
        Some(why) => format!("{exercise} {}", escaped(why)),
        None if is_missing => {
            return Err("it has no kind or no exercise\n  say \"why\"".into());
        }
        None => exercise,
    };
    let cells = [
        escaped(&row.slide),
        escaped(&row.subject),
        to_chapter,
        figure,
        kind,
        exercise,
    ];
    let cells = cells.map(|cell| ["<td>", &cell, "</td>"].concat()).concat();
    Ok(format!("<tr>{cells}</tr>"))
}

/// The exercise of a name such as `04/roots`.
fn about(name: &str) -> Result<&'static About, String> {
    let all = || exercises().into_iter().map(Exercise::about);
    let of = |about: &About| format!("{:02}/{}", about.lesson, about.name);
    let names: Vec<String> = all().map(of).collect();
    all().find(|about| of(about) == name).ok_or_else(|| {
        match nearest_name(name, names.iter().map(String::as_str)) {
            Some(near) => format!(
                "there is no exercise {}\n  did you mean {near}?",
                quoted(name)
            ),
            None => format!("there is no exercise {}\n  as in 04/roots", quoted(name)),
        }
    })
}
