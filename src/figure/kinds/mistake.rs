//! The picture with a mistake beside the right one, what differs between them, and the quantity that the mistake spoils in the
//! first pixel that shows it.

use glam::DVec2;

use crate::explain::{grouped, shown};
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::picture::draw_image;
use crate::figure::sheet::canvas::in_powers;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::{Colour, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::subject::Figure;
use crate::mistake::mistake;
use crate::trace::{LoggedPicture, SpoiltValue};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 480.0,
    usual: &[],
    more: &[],
};

/// How many quantities are shown: the first ones. Those after them follow from them.
const MOST: usize = 3;

/// Significant digits of a quantity: more where two differ by less.
const DIGITS: std::ops::RangeInclusive<u32> = 3..=16;

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let of_pixels = &figure.first.of_pixels;
    let (Some(right), Some(logged)) = (&of_pixels.picture, &of_pixels.mistake) else {
        return Err(FigureError::of_log("the log of this figure has no mistake"));
    };
    if figure
        .spec
        .mistake
        .as_ref()
        .is_some_and(|name| *name != logged.name)
    {
        let what = format!("the log is that of the mistake {:?}", logged.name);
        return Err(FigureError::of_log(what));
    }
    let known = mistake(&logged.name)
        .ok_or_else(|| FigureError::of_log(format!("there is no mistake {:?}", logged.name)))?;

    let rows: Vec<Row> = logged.spoilt.iter().take(MOST).map(Row::of).collect();
    let [x, y] = logged.pixel;
    let [width, height] = right.pixels;
    let all = u64::from(width) * u64::from(height);
    let differing = logged.picture.as_ref().map(|wrong| differing(right, wrong));
    let count = differing
        .as_ref()
        .map_or(0, |of| of.iter().filter(|is| **is).count());
    let of_pixel = match count {
        0 => format!("The picture stays the same. On a ray of pixel ({x}, {y}):"),
        _ => format!(
            "{} of {} pixels differ. In the first, ({x}, {y}):",
            grouped(count as u64),
            grouped(all)
        ),
    };
    let in_words = rows.iter().map(|row| row.sentence.as_str());
    let in_words = in_words.collect::<Vec<_>>().join(" ");

    let line = sheet.line_height();
    let below = (rows.len() as f64 + 2.5) * line;
    let head = [prose(known.sentence)];
    let table = match (&logged.picture, differing) {
        (Some(wrong), Some(differing)) => {
            let gap = sheet.letters;
            let panel = (body.size().x - 2.0 * gap) / 3.0;
            // three pictures side by side, each below its name
            let high = panel * f64::from(height) / f64::from(width) + 1.5 * line;
            let panels = PANELS.map(|(name, sentence)| sheet.stage(name, None, sentence));
            // both pictures come before the sentence that says what is wrong: a lecturer can ask first
            let body = sheet.at(panels[2], |sheet| sheet.lines(body, &head));
            let [pictures, table] = body.split_top(high.min(body.size().y - below));
            let both = [right, wrong];
            draw_pictures(sheet, pictures, both, &differing, logged.pixel, panels);
            table
        }
        _ => sheet.lines(body, &head),
    };
    let stage = sheet.stage("quantity", None, format!("{of_pixel} {in_words}"));
    sheet.at(stage, |sheet| draw_table(sheet, table, &of_pixel, &rows));
    Ok(format!(
        "The mistake {}. {} {of_pixel} {in_words}",
        logged.name, known.sentence
    ))
}

/// Which pixels have another colour.
fn differing(right: &LoggedPicture, wrong: &LoggedPicture) -> Vec<bool> {
    let pairs = right
        .rgb
        .as_chunks::<3>()
        .0
        .iter()
        .zip(wrong.rgb.as_chunks::<3>().0);
    pairs.map(|(right, wrong)| right != wrong).collect()
}

/// The name of each panel, and its sentence.
const PANELS: [(&str, &str); 3] = [
    ("right", "The right picture."),
    ("with the mistake", "The picture with the mistake."),
    ("what differs", "The pixels that differ."),
];

/// Three panels, each with its stage: the right picture, the wrong one, and the pixels that differ.
fn draw_pictures(
    sheet: &mut Sheet,
    frame: Frame,
    pictures: [&LoggedPicture; 2],
    differing: &[bool],
    pixel: [u32; 2],
    stages: [StageId; 3],
) {
    let [right, wrong] = pictures.map(|of| Image::of_rgb(of.pixels, &of.rgb).in_squares());
    let shade = Some(Colour::Rejected.plain());
    let marked = differing.iter().map(|is| if *is { shade } else { None });
    let pixels = pictures[0].pixels;
    let marked = Image::new(pixels, marked.collect()).in_squares();
    let gap = sheet.letters;
    let width = (frame.size().x - 2.0 * gap) / 3.0;
    let line = sheet.line_height();
    let images = [right, wrong, marked];
    for (place, (image, stage)) in images.into_iter().zip(stages).enumerate() {
        let (name, _) = PANELS[place];
        let left = frame.min.x + place as f64 * (width + gap);
        let room = Frame {
            min: DVec2::new(left, frame.min.y + line),
            max: DVec2::new(left + width, frame.max.y - 0.5 * line),
        };
        sheet.at(stage, |sheet| {
            let whole = draw_image(sheet, room, image);
            let above = DVec2::new(whole.middle().x, whole.min.y - 0.5 * line);
            sheet.text(Anchor::Middle, above, name);
            if place < 2 {
                let side = whole.size() / DVec2::new(f64::from(pixels[0]), f64::from(pixels[1]));
                let [x, y] = pixel.map(f64::from);
                let corner = whole.min + side * DVec2::new(x, y);
                let pixel = Frame {
                    min: corner,
                    max: corner + side,
                };
                sheet.on_picture(&pixel.wider(sheet.unit()).corners(), true);
            }
        });
    }
}

/// Words with quantities among them: what stands alone, has one letter or an index is set as a formula.
fn prose(words: &str) -> Text {
    let is_quantity = |word: &str| {
        let letters = word.trim_matches([',', '.']);
        word.contains('_') || (letters.chars().count() == 1 && !matches!(letters, "a" | "A" | "I"))
    };
    if !words.contains(' ') {
        return formula(words);
    }
    let parts = words.split_inclusive(' ').map(|part| {
        if is_quantity(part.trim_end()) {
            formula(part)
        } else {
            part.into()
        }
    });
    parts.fold(Text::default(), |text, part| text + part)
}

/// A quantity: its name, and both values.
struct Row {
    name: Text,
    values: [String; 2],
    sentence: String,
}

impl Row {
    fn of(spoilt: &crate::trace::Spoilt) -> Self {
        let both = [&spoilt.right, &spoilt.wrong];
        // as many digits as show that they differ
        let enough = |digits: &u32| value(both[0], *digits) != value(both[1], *digits);
        let digits = DIGITS.clone().find(enough).unwrap_or(*DIGITS.start());
        let values = both.map(|of| value(of, digits));
        let sentence = format!(
            "{}: right {}, with the mistake {}.",
            spoilt.quantity, values[0], values[1]
        );
        Self {
            name: prose(&spoilt.quantity),
            values,
            sentence,
        }
    }
}

fn value(of: &SpoiltValue, digits: u32) -> String {
    match of {
        SpoiltValue::Number(number) if number.fract() == 0.0 && number.abs() < 1e9 => {
            let count = grouped(number.abs() as u64);
            if *number < 0.0 {
                format!("−{count}")
            } else {
                count
            }
        }
        SpoiltValue::Number(number) => in_powers(&shown(*number, digits)),
        SpoiltValue::Vector(vector) => {
            let [x, y, z] = vector.map(|number| in_powers(&shown(number, digits)));
            format!("({x}, {y}, {z})")
        }
        SpoiltValue::Words(words) => words.clone(),
    }
}

/// The quantities in three columns.
fn draw_table(sheet: &mut Sheet, frame: Frame, of_pixel: &str, rows: &[Row]) {
    let frame = sheet.lines(frame, &[of_pixel]);
    let line = sheet.line_height();
    let names = rows.iter().map(|row| row.name.width() * sheet.letters);
    let names = names.fold(0.0, f64::max) + 2.0 * sheet.letters;
    let heads = ["right", "with the mistake"];
    let rights = rows.iter().map(|row| sheet.width_of(&row.values[0]));
    let rights = rights.fold(sheet.width_of(heads[0]), f64::max) + 2.0 * sheet.letters;
    let columns = [0.0, names, names + rights].map(|x| frame.min.x + x);
    let at = |column: usize, row: usize| {
        DVec2::new(columns[column], frame.min.y + (row as f64 + 0.5) * line)
    };
    for (column, head) in (1..).zip(heads) {
        sheet.text(Anchor::Start, at(column, 0), head);
    }
    let y = frame.min.y + line;
    let end = rows.iter().map(|row| sheet.width_of(&row.values[1]));
    let end = end.fold(sheet.width_of(heads[1]), f64::max);
    let right = DVec2::new(columns[2] + end, y);
    sheet.line(Look::THIN, DVec2::new(columns[0], y), right);
    for (place, row) in (1..).zip(rows) {
        sheet.text(Anchor::Start, at(0, place), row.name.clone());
        for (column, value) in (1..).zip(&row.values) {
            sheet.text(Anchor::Start, at(column, place), value.as_str());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn italic(of: &str) -> String {
        let runs = prose(of).runs.into_iter().filter(|run| run.italic);
        runs.map(|run| run.letters).collect()
    }

    #[test]
    fn quantities_in_a_sentence_are_set_as_such_and_articles_are_not() {
        assert_eq!(italic("near of a slab"), "");
        assert_eq!(italic("t of the root"), "t");
        assert_eq!(italic("t of D_min is taken"), "tD");
        assert_eq!(italic("N·L"), "NL");
        assert_eq!(italic("b lacks its factor 2"), "b");
    }

    #[test]
    fn two_values_have_as_many_digits_as_show_that_they_differ() {
        let spoilt = |right: f64, wrong: f64| crate::trace::Spoilt {
            quantity: "t".into(),
            right: right.into(),
            wrong: wrong.into(),
        };
        assert_eq!(Row::of(&spoilt(1.5, -2.25)).values, ["1.5", "−2.25"]);
        assert_eq!(
            Row::of(&spoilt(0.123_451, 0.123_456)).values,
            ["0.12345", "0.12346"]
        );
        // counts are whole
        assert_eq!(Row::of(&spoilt(43_130.0, 7.0)).values, ["43 130", "7"]);
    }
}
