//! The hits in the order of their z.

use glam::DVec2;

use crate::figure::kinds::alignment::argument::Argument;
use crate::figure::kinds::alignment::laid::Laid;
use crate::figure::kinds::alignment::marks::mark;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::subject::Figure;

/// How many lines it has.
pub(super) fn rows(figure: &Figure, laid: &Laid) -> f64 {
    let missed = if missed(figure, laid).is_some() {
        1.0
    } else {
        0.0
    };
    laid.sorted.len() as f64 + 1.0 + missed
}

pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    laid: &Laid,
    argument: &Argument,
) {
    let height = sheet.line_height();
    let line = |row: f64| frame.min + DVec2::new(0.0, (row + 0.9) * height);
    let indent = 1.2 * sheet.letters;
    let head = match laid.sorted.len() {
        0 => formula("z") + " sort: no hit at " + formula("x = y = 0"),
        _ => formula("z") + " sort of the hits at " + formula("x = y = 0"),
    };
    let missed = missed(figure, laid);
    sheet.at(argument.sort, |sheet| {
        sheet.text(Anchor::Start, line(0.0), head);
        if let Some(missed) = missed {
            let place = line(laid.sorted.len() as f64 + 1.0) + DVec2::new(1.5 * indent, 0.0);
            sheet.text(Anchor::Start, place, missed);
        }
    });
    let names = laid
        .sorted
        .iter()
        .map(|(hit, _)| scenery::name_of(figure.scene, hit.object));
    let names: Vec<String> = names.collect();
    let widths = names.iter().map(|name| sheet.width_of(name));
    let column = widths.fold(0.0, f64::max) + indent;
    for (row, ((hit, step), name)) in laid.sorted.iter().zip(&names).enumerate() {
        let at = line(row as f64 + 1.0);
        let dot = at + DVec2::new(0.5 * indent, 0.0);
        let mut place = at + DVec2::new(1.5 * indent, 0.0);
        let text = formula("z = ") + quantity(hit.z);
        let end = place.x + column + sheet.width_of(&text) + sheet.letters;
        sheet.at(argument.sort, |sheet| {
            sheet.step(*step, |sheet| {
                mark(sheet, false, dot);
                sheet.text(Anchor::Start, place, name.as_str());
                place.x += column;
                sheet.text(Anchor::Start, place, text);
            });
        });
        if hit.place == 0 {
            sheet.at(argument.nearest, |sheet| {
                mark(sheet, true, dot);
                sheet.text(Anchor::Start, DVec2::new(end, at.y), "nearest");
            });
        }
    }
}

/// The objects that the ray misses, or how many they are.
fn missed(figure: &Figure, laid: &Laid) -> Option<String> {
    /// More are counted.
    const NAMED: usize = 3;
    let scene = figure.scene;
    let is_hit = |object: usize| {
        let mut hits = laid.sorted.iter();
        hits.any(|(hit, _)| scene.primitive(hit.object).object as usize == object)
    };
    let missed = scene.objects.iter().enumerate();
    let missed = missed.filter(|(number, object)| 0 < object.count && !is_hit(*number));
    let names: Vec<String> = missed
        .map(|(_, object)| scenery::short(&object.name))
        .collect();
    match names.len() {
        0 => None,
        1..=NAMED => Some(format!("missed: {}", names.join(", "))),
        count => Some(format!("missed: {count} objects")),
    }
}
