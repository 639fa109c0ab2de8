//! D_min and D_max of two bounds, and which of them the bound of both takes.

use glam::DVec2;

use crate::figure::kinds::merge::joined::Joined;
use crate::figure::kinds::slabs::Shown;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};

/// D_min and D_max of both bounds for each slab; what the bound of both takes is in a frame.
pub(super) struct Table {
    /// The slab's name, then D_min of both bounds and D_max of both.
    rows: Vec<(Shown, [Cell; 5])>,
    head: [Text; 5],
    /// How wide each column is, and the gap before it.
    columns: [f64; 5],
    gap: f64,
}

/// A text, and whether the bound of both takes it.
#[derive(Clone, Debug, Default)]
struct Cell {
    text: Text,
    is_taken: bool,
}

/// What stands above the columns of both bounds.
const HEADS: [&str; 2] = ["D_min: minimum", "D_max: maximum"];

impl Table {
    /// As wide as the texts; names too long for half of the frame lose their beginnings.
    pub(super) fn new(sheet: &Sheet, frame: Frame, joined: &Joined, slabs: &[Shown]) -> Self {
        let row = |shown: &Shown| {
            let mut steps = joined.steps.iter();
            let (_, merge) = steps.find(|(_, merge)| merge.slab == shown.slab.number)?;
            let (d_min, d_max) = merge.joined();
            let cell = |d: f64, taken: f64| Cell {
                text: quantity(d).into(),
                is_taken: d == taken,
            };
            let name = Cell {
                text: formula(&shown.slab.name()),
                is_taken: false,
            };
            let ([a, b], [c, d]) = (
                merge.d_min.map(|d| cell(d, d_min)),
                merge.d_max.map(|d| cell(d, d_max)),
            );
            Some((*shown, [name, a, b, c, d]))
        };
        let rows: Vec<(Shown, [Cell; 5])> = slabs.iter().filter_map(row).collect();
        let gap = sheet.letters
            * match sheet.width {
                Width::Book => 1.4,
                Width::Slide => 1.0,
            };
        let widest = |column: usize| {
            let widths = rows
                .iter()
                .map(|(_, row)| sheet.width_of(&row[column].text));
            widths.fold(sheet.width_of(formula("n")), f64::max)
        };
        let numbers: [f64; 5] = std::array::from_fn(widest);
        let most = (0.5 * frame.size().x - numbers[0]) / 4.0 - gap;
        let names = joined.names.each_ref().map(|name| {
            let room = most.max(numbers[1..].iter().copied().fold(0.0, f64::max));
            end_of_name(name, |text| sheet.width_of(text) <= room)
        });
        let [first, second] = names.map(Text::from);
        let head = [formula("n"), first.clone(), second.clone(), first, second];
        let mut columns = std::array::from_fn(|i| numbers[i].max(sheet.width_of(&head[i])));
        for (pair, text) in [1, 3].into_iter().zip(HEADS) {
            let missing = sheet.width_of(formula(text)) - (columns[pair] + gap + columns[pair + 1]);
            for column in &mut columns[pair..pair + 2] {
                *column += 0.5 * missing.max(0.0);
            }
        }
        Self {
            rows,
            head,
            columns,
            gap,
        }
    }

    pub(super) fn width(&self) -> f64 {
        // air for the last frame
        self.columns.iter().sum::<f64>() + 4.5 * self.gap
    }

    /// The right end of a column.
    fn end(&self, frame: Frame, column: usize) -> f64 {
        let columns: f64 = self.columns[..=column].iter().sum();
        frame.min.x + columns + column as f64 * self.gap
    }

    pub(super) fn draw(&self, sheet: &mut Sheet, frame: Frame, bounds: StageId) {
        let line = 1.35 * sheet.line_height();
        let rows = self.rows.len() as f64 + 2.0;
        let top = frame.middle().y - 0.5 * rows * line;
        let row = |place: usize| top + (place as f64 + 0.5) * line;
        let pad = 0.35 * sheet.letters;
        for (column, text) in [2, 4].into_iter().zip(HEADS) {
            let middle = 0.5 * (self.end(frame, column) + self.start(frame, column - 1));
            sheet.text(Anchor::Middle, DVec2::new(middle, row(0)), formula(text));
        }
        for (column, text) in self.head.iter().enumerate() {
            let at = DVec2::new(self.end(frame, column), row(1));
            sheet.text(Anchor::End, at, text.clone());
        }
        let under = top + 2.0 * line;
        let ends = [frame.min.x, self.end(frame, 4) + pad].map(|x| DVec2::new(x, under));
        sheet.line(Look::THIN, ends[0], ends[1]);
        for (place, (shown, cells)) in self.rows.iter().enumerate() {
            let y = row(place + 2);
            for (column, cell) in cells.iter().enumerate() {
                let x = self.end(frame, column);
                sheet.at(bounds, |sheet| {
                    sheet.text(Anchor::End, DVec2::new(x, y), cell.text.clone());
                });
                if cell.is_taken {
                    let width = sheet.width_of(&cell.text);
                    let half = DVec2::new(0.5 * width + pad, 0.75 * sheet.letters);
                    let middle = DVec2::new(x - 0.5 * width, y);
                    let (min, max) = (middle - half, middle + half);
                    shown.draw(sheet, |sheet| {
                        sheet.rectangle(Look::VISITED, Frame { min, max });
                    });
                }
            }
        }
    }

    /// The left end of a column.
    fn start(&self, frame: Frame, column: usize) -> f64 {
        self.end(frame, column) - self.columns[column]
    }
}

/// A name, or as much of its end as fits: names that belong together differ there.
fn end_of_name(name: &str, fits: impl Fn(&str) -> bool) -> String {
    if fits(name) {
        return name.into();
    }
    let ends = name.char_indices().skip(1);
    let mut ends = ends.map(|(at, _)| format!("…{}", name[at..].trim_start()));
    ends.find(|end| fits(end)).unwrap_or_else(|| "…".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_name_keeps_its_end() {
        let fits = |most: usize| move |text: &str| text.chars().count() <= most;
        assert_eq!(end_of_name("shape face 0", fits(12)), "shape face 0");
        assert_eq!(end_of_name("shape face 0", fits(7)), "…face 0");
        assert_eq!(end_of_name("shape face 0", fits(2)), "…0");
        assert_eq!(end_of_name("shape", fits(0)), "…");
    }
}
