//! The terms of a shade with their factors, in two columns.

use glam::{DVec2, DVec3};

use crate::figure::kinds::shading::argument::Argument;
use crate::figure::kinds::shading::point::{Point, counts};
use crate::figure::parts::angle::degrees;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Level, Run, Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};

/// A name, what it is, and when it comes.
pub(super) struct Row {
    name: Text,
    value: Text,
    stage: StageId,
    /// Is there a line above it, as over a sum?
    is_sum: bool,
}

/// The rows from the top.
struct Table {
    rows: Vec<Row>,
}

impl Table {
    fn add(&mut self, stage: StageId, name: impl Into<Text>, value: impl Into<Text>) {
        self.rows.push(Row {
            name: name.into(),
            value: value.into(),
            stage,
            is_sum: false,
        });
    }

    /// A term: its factors, which a slide has no room for, and its value.
    fn add_term(&mut self, stage: StageId, name: &str, factors: Vec<Text>, value: String) {
        let mut name = name;
        let is_alone = factors.is_empty();
        for line in factors {
            self.add(stage, std::mem::take(&mut name), line);
        }
        let value = if is_alone {
            value
        } else {
            format!("= {value}")
        };
        self.add(stage, name, value);
    }
}

/// The terms with their factors; a slide has room for the values alone.
pub(super) fn rows(sheet: &Sheet, point: &Point, argument: &Argument) -> Vec<Row> {
    let (term, shade) = (&point.light.term, point.shade);
    let cosine = |name: &str, of: f64| formula(&format!("cos {name} = ")) + quantity(of);
    let book = sheet.width == Width::Book;
    let factors = |of: Option<[Text; 2]>| match of {
        Some(lines) if book => lines.into(),
        _ => Vec::new(),
    };
    let mut table = Table { rows: Vec::new() };
    if book {
        table.add(argument.normal, formula("N"), "normal");
        let at = Text::from("to the light, ") + formula("θ = ") + degrees(term.n_dot_l);
        table.add(argument.to_light, formula("L"), at);
    }
    let n_dot_l = cosine("θ", term.n_dot_l);
    table.add(argument.to_light, formula("N·L"), n_dot_l);
    let value = coordinates(term.diffuse);
    table.add_term(argument.diffuse, "diffuse", factors(diffuse(point)), value);
    if book {
        let mirrored = formula("L") + " mirrored at " + formula("N");
        table.add(argument.mirrored, formula("R"), mirrored);
        let at = Text::from("to the viewer, ") + formula("α = ") + degrees(term.r_dot_v);
        table.add(argument.to_viewer, formula("V"), at);
    }
    let r_dot_v = cosine("α", term.r_dot_v);
    table.add(argument.to_viewer, formula("R·V"), r_dot_v);
    let value = alike(term.specular);
    table.add_term(
        argument.specular,
        "specular",
        factors(highlight(point)),
        value,
    );
    table.add(argument.ambient, "ambient", coordinates(shade.ambient));
    if !counts(point.light) {
        table.add(argument.sum, "", "in shadow: ambient alone");
    }
    let sum = coordinates(shade.ambient + shade.direct);
    table.add(argument.sum, formula("I"), sum);
    if let Some(last) = table.rows.last_mut() {
        last.is_sum = true;
    }
    table.rows
}

/// The factors of the diffuse term, in letters and in numbers; none of a light with a power, whose term is another.
fn diffuse(point: &Point) -> Option<[Text; 2]> {
    let colour = alike(point.colour?);
    let letters = Text::from("light·colour·diffuse·(") + formula("N·L") + ")";
    let numbers = format!(
        "= {colour}·{}·{}·{}",
        alike(point.material.colour.into()),
        quantity(point.material.diffuse),
        quantity(point.light.term.n_dot_l)
    );
    Some([letters, numbers.into()])
}

/// Those of the specular term.
fn highlight(point: &Point) -> Option<[Text; 2]> {
    let colour = alike(point.colour?);
    let letters = Text::from("light·specular·(") + formula("R·V") + ")" + raised("shininess");
    let numbers = format!(
        "= {colour}·{}·{}",
        quantity(point.material.specular),
        quantity(point.light.term.r_dot_v.max(0.0))
    );
    let shininess = quantity(point.material.shininess);
    Some([letters, Text::from(numbers) + raised(&shininess)])
}

/// Letters as an exponent.
fn raised(letters: &str) -> Text {
    let runs = vec![Run {
        letters: letters.into(),
        italic: false,
        level: Level::Exponent,
    }];
    Text { runs }
}

/// A colour by its three parts, or by one number if they are alike.
fn alike(colour: DVec3) -> String {
    if colour == DVec3::splat(colour.x) {
        quantity(colour.x)
    } else {
        coordinates(colour)
    }
}

fn widest<'a>(sheet: &Sheet, texts: impl Iterator<Item = &'a Text>) -> f64 {
    texts.map(|text| sheet.width_of(text)).fold(0.0, f64::max)
}

/// How far from the left the values are, behind the longest name.
fn values_begin(sheet: &Sheet, rows: &[Row]) -> f64 {
    widest(sheet, rows.iter().map(|row| &row.name)) + sheet.letters
}

/// How wide the two columns are.
pub(super) fn width(sheet: &Sheet, rows: &[Row]) -> f64 {
    values_begin(sheet, rows) + widest(sheet, rows.iter().map(|row| &row.value))
}

/// The numbers in two columns, in the middle of a frame's height.
pub(super) fn draw(sheet: &mut Sheet, frame: Frame, rows: Vec<Row>) {
    let usual = match sheet.width {
        Width::Book => sheet.line_height(),
        Width::Slide => 1.3 * sheet.line_height(),
    };
    let line = usual.min(frame.size().y / rows.len() as f64);
    let column = frame.min.x + values_begin(sheet, &rows);
    let top = frame.middle().y - 0.5 * line * (rows.len() as f64 - 1.0);
    for (i, row) in rows.into_iter().enumerate() {
        let middle = top + i as f64 * line;
        sheet.at(row.stage, |sheet| {
            if row.is_sum {
                let rule = middle - 0.5 * line;
                let [from, to] = [frame.min.x, frame.max.x].map(|x| DVec2::new(x, rule));
                sheet.line(Look::THIN, from, to);
            }
            for (x, text) in [(frame.min.x, row.name), (column, row.value)] {
                if !text.is_empty() {
                    sheet.text(Anchor::Start, DVec2::new(x, middle), text);
                }
            }
        });
    }
}
