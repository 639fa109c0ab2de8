//! What describes a bound of slabs: D_min and D_max of each.

use glam::DVec2;

use crate::figure::kinds::slabs::argument::Shown;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::view::Projection;

/// A row for each slab: how its planes are drawn, its normal, D_min and D_max.
pub(super) struct Table {
    rows: Vec<(Shown, [Text; 3])>,
    /// Are its planes drawn?
    drawn: Vec<bool>,
    /// How wide each column is, and the gap between them.
    columns: [f64; 3],
    gap: f64,
    /// How wide the pattern before the first column is, with its gap.
    pattern: f64,
}

impl Table {
    /// As wide as the texts.
    pub(super) fn new(sheet: &Sheet, slabs: &[Shown], projection: &Projection) -> Self {
        let rows = slabs.iter().map(|shown| {
            let slab = &shown.slab;
            let numbers = [slab.d_min, slab.d_max].map(|d| Text::from(quantity(d)));
            let [d_min, d_max] = numbers;
            (*shown, [slab.title(projection), d_min, d_max])
        });
        let rows: Vec<(Shown, [Text; 3])> = rows.collect();
        let head = Self::head();
        let widest = |column: usize| {
            let widths = rows.iter().map(|(_, row)| sheet.width_of(&row[column]));
            widths.fold(sheet.width_of(&head[column]), f64::max)
        };
        Self {
            columns: std::array::from_fn(widest),
            gap: 1.5 * sheet.letters,
            pattern: 3.0 * sheet.letters,
            drawn: slabs
                .iter()
                .map(|of| of.slab.is_on_edge(projection))
                .collect(),
            rows,
        }
    }

    fn head() -> [Text; 3] {
        ["n", "D_min", "D_max"].map(formula)
    }

    /// The least width.
    pub(super) fn width(&self) -> f64 {
        self.pattern + self.columns.iter().sum::<f64>() + 2.0 * self.gap
    }

    /// In a frame; what it has too much is between the columns.
    pub(super) fn draw(&self, sheet: &mut Sheet, frame: Frame) {
        let more = 0.5 * (frame.size().x - self.width()).max(0.0);
        let gap = self.gap + more;
        let left = frame.min.x + self.pattern;
        let end = |column: usize| {
            let columns: f64 = self.columns[..=column].iter().sum();
            left + columns + column as f64 * gap
        };
        let line = 1.25 * sheet.line_height();
        let rows = self.rows.len() as f64 + 1.0;
        let top = frame.middle().y - 0.5 * rows * line;
        let row = |place: f64| top + (place + 0.5) * line;
        // names begin where their column does, numbers end there
        let place = |column: usize, y: f64| match column {
            0 => (Anchor::Start, DVec2::new(left, y)),
            _ => (Anchor::End, DVec2::new(end(column), y)),
        };
        for (column, text) in Self::head().into_iter().enumerate() {
            let (anchor, at) = place(column, row(0.0));
            sheet.text(anchor, at, text);
        }
        let under = top + line;
        let ends = [frame.min.x, end(2)].map(|x| DVec2::new(x, under));
        sheet.line(Look::THIN, ends[0], ends[1]);
        for (number, (shown, texts)) in self.rows.iter().enumerate() {
            let y = row(number as f64 + 1.0);
            shown.draw(sheet, |sheet| {
                if self.drawn[number] {
                    let from = DVec2::new(frame.min.x, y);
                    let to = DVec2::new(left - 0.8 * sheet.letters, y);
                    sheet.line(shown.look(), from, to);
                }
                for (column, text) in texts.iter().enumerate() {
                    let (anchor, at) = place(column, y);
                    sheet.text(anchor, at, text.clone());
                }
            });
        }
    }
}
