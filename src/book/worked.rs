//! `{{#raystep-log NAME}}` and `{{#raystep-blanks NAME}}`: the worked solution of a figure's pixel, whole or with results taken
//! out.

use crate::book::blanks::{Taken, USUAL, blanks};
use crate::book::words::{unknown_option, whole_log, whole_number};
use crate::explain::page::Page;
use crate::explain::render::html;
use crate::explain::{Unfold, WorkedOptions, worked_solution};
use crate::figure::Traced;
use crate::scene::{nearest_name, quoted};
use crate::trace::{Kind, Kinds};

/// The worked solution of a pixel, as HTML on one line.
///
/// # Errors
/// A word that is no option, a kind or a ray that is not there.
pub(super) fn log(
    traced: &Traced,
    pixel: Option<[u32; 2]>,
    words: &[String],
) -> Result<String, String> {
    let page = page(traced, pixel, words, None)?;
    Ok(html(&page, hint))
}

/// The worked solution with results taken out, as HTML on one line.
///
/// # Errors
/// Those of a log; or the lines have no result to take out.
pub(super) fn with_blanks(
    traced: &Traced,
    pixel: Option<[u32; 2]>,
    words: &[String],
) -> Result<String, String> {
    let mut taken = Taken {
        count: USUAL,
        word: None,
    };
    let page = page(traced, pixel, words, Some(&mut taken))?;
    blanks(page, &taken)
}

/// The page. What is taken out of it is noted where that may be said.
fn page(
    traced: &Traced,
    pixel: Option<[u32; 2]>,
    words: &[String],
    mut taken: Option<&mut Taken>,
) -> Result<Page, String> {
    const OPTIONS: [&str; 5] = ["only=KIND,KIND", "ray=N", "all", "blanks=N", "word=WORD"];
    let mut options = WorkedOptions::default();
    for word in words {
        match (word.split_once('='), &mut taken) {
            (Some(("only", kinds)), _) => options.kinds = only(kinds)?,
            (Some(("ray", number)), _) => options.ray = Some(whole_number("ray", number)?),
            (Some(("blanks", number)), Some(taken)) => {
                taken.count = whole_number("blanks", number)?;
            }
            (Some(("word", word)), Some(taken)) => taken.word = Some(word.into()),
            (None, _) if word == "all" => options.all = true,
            _ => {
                let known = if taken.is_some() { 5 } else { 3 };
                return Err(unknown_option(word, &OPTIONS[..known]));
            }
        }
    }
    let records = traced.of_pixel(pixel);
    let has = |ray: u32| records.iter().any(|record| record.ray == Some(ray));
    if let Some(ray) = options.ray.filter(|&ray| !has(ray)) {
        let last = records.iter().filter_map(|record| record.ray).max();
        return Err(match last {
            Some(last) => format!("the pixel has no ray {ray}\n  its rays are 0 to {last}"),
            None => "this figure has no pixel with rays\n  name a figure with a \"pixel\"".into(),
        });
    }
    let settings = whole_log(traced);
    Ok(worked_solution(
        &traced.scene,
        &settings,
        &records,
        &options,
    ))
}

/// The options of the directive that show what a page leaves out.
fn hint(unfold: Unfold) -> String {
    match unfold {
        Unfold::All => "all shows them".into(),
        Unfold::Ray(ray) => format!("ray={ray}"),
    }
}

/// Kinds of event by their names.
fn only(names: &str) -> Result<Kinds, String> {
    let mut kinds = Vec::new();
    for name in names.split(',') {
        let known = Kind::ALL.map(Kind::name);
        let kind =
            Kind::named(name).ok_or_else(|| match nearest_name(name, known.into_iter()) {
                Some(near) => format!("there is no kind {}\n  did you mean {near}?", quoted(name)),
                None => format!(
                    "there is no kind {}\n  the kinds are {}",
                    quoted(name),
                    known.join(", ")
                ),
            })?;
        kinds.push(kind);
    }
    Ok(Kinds::of(&kinds))
}
