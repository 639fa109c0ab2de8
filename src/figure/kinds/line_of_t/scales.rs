//! The two scales of t below the line, and what its parts are.

use glam::DVec2;

use crate::figure::kinds::line_of_t::argument::Argument;
use crate::figure::kinds::line_of_t::stops::{Line, Place, Stop};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::view::Space;

/// A line for the ticks' numbers, and air.
fn scale_height(sheet: &Sheet) -> f64 {
    2.4 * sheet.letters
}

/// The bracket, two lines of words, and air.
fn brackets_height(sheet: &Sheet) -> f64 {
    2.0 * sheet.line_height() + 1.6 * sheet.letters
}

/// How high all that is.
pub(super) fn height(sheet: &Sheet) -> f64 {
    brackets_height(sheet) + 2.0 * scale_height(sheet)
}

/// Where the rows are: the first scale, the brackets below it, the second scale.
struct Rows {
    brackets: f64,
    scales: [f64; 2],
}

impl Rows {
    fn in_frame(sheet: &Sheet, below: Frame) -> Self {
        let first = below.min.y + 0.8 * sheet.letters;
        Self {
            brackets: first + 2.2 * sheet.letters,
            scales: [first, first + scale_height(sheet) + brackets_height(sheet)],
        }
    }
}

/// The brackets and the scales in the frame below the line.
pub(super) fn draw(
    sheet: &mut Sheet,
    space: &Space,
    below: Frame,
    (line, stops): (&Line, &[Stop]),
    argument: &Argument,
) {
    let rows = Rows::in_frame(sheet, below);
    let lengths = [line.to_window.direction.length(), 1.0];
    let tick = 5.0 * sheet.unit();
    for (scale, length) in lengths.into_iter().enumerate() {
        let first = [argument.direction, argument.unit][scale];
        let y = rows.scales[scale];
        let [left, right] = [space.frame.min.x, space.frame.max.x].map(|x| DVec2::new(x, y));
        sheet.at(first, |sheet| {
            sheet.arrow(Look::THIN.wide(1.25), left, right);
            let end = right - DVec2::new(0.0, 0.8 * sheet.letters);
            let text = formula("|Δ| = ") + quantity(length) + formula(": t");
            sheet.text(Anchor::End, end, text);
        });
        for stop in stops {
            let x = space.place(stop.point).x;
            let from_when = first.max(match stop.place {
                Place::Cop | Place::PixelCentre => argument.direction,
                Place::BehindCop | Place::Hit => argument.of(stop),
            });
            sheet.at(from_when, |sheet| {
                let [from, to] = [-tick, tick].map(|by| DVec2::new(x, y + by));
                sheet.line(Look::THIN.wide(1.5), from, to);
                let place = DVec2::new(x, y + tick + 0.75 * sheet.letters);
                sheet.text(Anchor::Middle, place, quantity(stop.t[scale]));
            });
        }
    }
    parts(sheet, space, rows.brackets, stops, argument);
    // from the points down to the first scale
    for stop in stops {
        let from = space.place(stop.point);
        let stage = argument.of(stop).max(argument.direction);
        sheet.at(stage, |sheet| {
            let to = DVec2::new(from.x, rows.scales[0] - tick);
            sheet.line(Look::HELP.wide(0.75), from, to);
        });
    }
}

/// What the parts of the line are, each below its bracket.
fn parts(sheet: &mut Sheet, space: &Space, y: f64, stops: &[Stop], argument: &Argument) {
    let x = |stop: &Stop| space.place(stop.point).x;
    let [_, cop, window, ..] = stops else {
        return;
    };
    let [left, right] = [space.frame.min.x, space.frame.max.x];
    let parts = [
        ([left, x(cop)], "behind the COP", "t < 0"),
        ([x(window), right], "beyond the window", "t > 1"),
    ];
    sheet.at(argument.ray, |sheet| {
        let up = DVec2::new(0.0, 4.0 * sheet.unit());
        for ([from, to], name, which) in parts {
            let [left, right] = [from, to].map(|x| DVec2::new(x, y));
            sheet.path(Look::THIN, vec![left - up, left, right, right - up]);
            let words: [Text; 2] = [name.into(), formula(which)];
            let middle = left.midpoint(right);
            for (number, text) in words.into_iter().enumerate() {
                let down = (0.6 + number as f64) * sheet.line_height();
                sheet.text(Anchor::Middle, middle + DVec2::new(0.0, down), text);
            }
        }
    });
}
