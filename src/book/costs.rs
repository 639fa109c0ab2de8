//! `{{#raystep-compare NAME}}`: what each strategy, or each kind of ray tracing, costs.

use std::time::Duration;

use crate::book::words::unknown_option;
use crate::explain::render::escaped;
use crate::figure::Traced;
use crate::lesson::{NotCompared, compare, compare_transports, light_of_lamps};
use crate::tracer::{MAX_RAYS, Stopped};

/// What every strategy costs on the figure's pixel, or on its picture; or what each kind of ray tracing costs and
/// brings.
///
/// # Errors
/// A word that is no option, a scene without lights, or a tree of rays that does not end.
pub(super) fn table(
    traced: &Traced,
    mut pixel: Option<[u32; 2]>,
    words: &[String],
) -> Result<String, String> {
    let mut transports = false;
    for word in words {
        match word.as_str() {
            "picture" => pixel = None,
            "transports" => transports = true,
            _ => return Err(unknown_option(word, &["picture", "transports"])),
        }
    }
    let Traced {
        scene, settings, ..
    } = traced;
    // times would differ from build to build; a table of a book has none
    let no_clock = || Duration::ZERO;
    let (title, rows) = if transports {
        let scene = light_of_lamps(scene.clone());
        let comparison = compare_transports(&scene, settings, MAX_RAYS, no_clock, |_| {});
        let comparison = comparison.map_err(|error| match error {
            NotCompared::Light(fault) => format!("{fault}: {}", fault.fix()),
            NotCompared::Stopped { stopped, .. } => too_many_rays(stopped),
        })?;
        (comparison.title(), comparison.rows())
    } else {
        let comparison =
            compare(scene, settings, pixel, MAX_RAYS, no_clock, |_| {}).map_err(too_many_rays)?;
        (comparison.title(), comparison.rows())
    };
    let row = |cells: &[String], tag: &str| {
        let cells = cells.iter().enumerate().map(|(place, cell)| {
            let align = if place == 0 {
                ""
            } else {
                " style=\"text-align: right\""
            };
            format!("<{tag}{align}>{}</{tag}>", escaped(cell))
        });
        format!("<tr>{}</tr>", cells.collect::<String>())
    };
    let (head, body) = rows
        .split_first()
        .ok_or("there are no strategies to compare")?;
    let body: String = body.iter().map(|cells| row(cells, "td")).collect();
    Ok(format!(
        "<div class=\"table-wrapper\" tabindex=\"0\" role=\"group\" aria-label=\"Costs\"><table class=\"raystep-compare\"><caption>{}</caption><thead>{}</thead><tbody>{body}</tbody></table></div>",
        escaped(&title),
        row(head, "th")
    ))
}

/// A tree of rays that does not end, as a mistake in a directive.
fn too_many_rays(stopped: Stopped) -> String {
    format!("{stopped}\n  lower the scene's \"max_depth\", or its reflection and transmission")
}
