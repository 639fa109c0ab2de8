//! What each strategy costs, as bars on a logarithmic axis.

use glam::DVec2;

use crate::explain::{Comparison, grouped};
use crate::figure::sheet::canvas::{Canvas, Rendition};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet, Width};

/// Between letters and what they belong to, in sizes of the letters.
const GAP: f64 = 0.6;
/// A line of letters with some air: the letters and a quarter of that above and below.
const LINE: f64 = 1.5;
/// Height of a bar, within its line.
const BAR: f64 = 1.0;
/// Between the bars of two strategies.
const BETWEEN: f64 = 0.7;
/// How long the bar of a single test is. A logarithmic axis has no 0: it begins a little before 1, so that
/// 1 differs from 0.
const ONE: f64 = 1.0;
/// Length of a tick.
const TICK: f64 = 0.4;
/// From one strategy to the next.
const ROW: f64 = 2.0 * LINE + BETWEEN;

/// Draws two bars for each strategy: object tests, full; tests of bounds, nodes entered and cells visited,
/// faint. The number stands at the bar's end; a bar of 0 is a 0 where the axis begins.
///
/// The drawing's name begins its ids and classes: a word of letters, digits and `-`. The same comparison
/// gives the same bytes: times are not drawn.
pub fn cost_chart(id: &str, comparison: &Comparison) -> String {
    let rows: Vec<CostRow> = comparison
        .compared
        .iter()
        .map(|compared| CostRow {
            name: compared.name(),
            counts: compared
                .cost
                .as_ref()
                .ok()
                .map(|cost| [cost.counts.objects_tested(), cost.searched()]),
        })
        .collect();
    let mut sheet = Sheet::new(Width::Book, 0.0);
    sheet.size.y = (height(rows.len()) + 2.0) * sheet.letters;
    let body = sheet.body();
    let description = cost_bars(&mut sheet, body, &rows);
    let title = format!("What each strategy costs. {}", comparison.title());
    Canvas::write(sheet, id, [&title, &description], Rendition::default())
}

/// How high the bars of a number of strategies are, with legend and axis, in sizes of the letters.
pub(super) fn height(rows: usize) -> f64 {
    LINE + BETWEEN + rows as f64 * ROW + TICK + 2.0 * LINE
}

/// A strategy's bars.
pub(super) struct CostRow {
    pub(super) name: String,
    /// Object tests; tests of bounds, nodes and cells. `None` if the structure cannot be built.
    pub(super) counts: Option<[u64; 2]>,
}

/// Draws the bars from the top of a frame, and says them in words.
pub(super) fn cost_bars(sheet: &mut Sheet, frame: Frame, rows: &[CostRow]) -> String {
    let axis = Axis::of(sheet, frame, rows);
    let em = sheet.letters;
    let top = frame.min.y + (LINE + BETWEEN) * em;
    legend(sheet, DVec2::new(axis.start, frame.min.y + 0.5 * LINE * em));
    for (place, row) in rows.iter().enumerate() {
        bars(sheet, &axis, row, top + place as f64 * ROW * em);
    }
    axis.draw(sheet, [top, top + rows.len() as f64 * ROW * em]);
    description(rows)
}

/// The logarithmic axis.
struct Axis {
    /// Where bars begin.
    start: f64,
    /// Where 1 is.
    one: f64,
    /// Width of a power of ten.
    decade: f64,
    /// How many of them.
    decades: u32,
}

impl Axis {
    /// Between the longest name and the longest number, up to the power of ten above the largest count.
    fn of(sheet: &Sheet, frame: Frame, rows: &[CostRow]) -> Self {
        let em = sheet.letters;
        let names = rows.iter().map(|row| sheet.width_of(&row.name));
        let names = names.fold(0.0, f64::max);
        let counts = rows.iter().filter_map(|row| row.counts).flatten();
        let largest = counts.max().unwrap_or(0);
        let start = frame.min.x + names + GAP * em;
        let end = frame.max.x - sheet.width_of(grouped(largest)) - GAP * em;
        // 10 is one power of ten, 11 reaches into the second; there is at least one
        let decades = largest.saturating_sub(1).checked_ilog10().unwrap_or(0) + 1;
        let one = start + ONE * em;
        Self {
            start,
            one,
            decade: (end - one) / f64::from(decades),
            decades,
        }
    }

    /// Where a count is, which is not 0.
    fn place(&self, count: u64) -> f64 {
        self.one + libm::log10(count as f64) * self.decade
    }

    fn draw(&self, sheet: &mut Sheet, [top, y]: [f64; 2]) {
        let em = sheet.letters;
        let end = self.one + self.decade * f64::from(self.decades);
        let at = DVec2::new;
        sheet.line(Look::THIN, at(self.start, top), at(self.start, y));
        sheet.line(Look::THIN, at(self.start, y), at(end, y));
        // the longest label with some air: every so many powers of ten have one
        let label = sheet.width_of(power_of_ten(self.decades)) + GAP * em;
        let labelled = (label / self.decade).ceil().max(1.0) as u32;
        for power in 0..=self.decades {
            let x = self.one + self.decade * f64::from(power);
            sheet.line(Look::THIN, at(x, y), at(x, y + TICK * em));
            if power.is_multiple_of(labelled) {
                let middle = y + (TICK + 0.5 * LINE) * em;
                sheet.text(Anchor::Middle, at(x, middle), power_of_ten(power));
            }
        }
        let middle = at(f64::midpoint(self.start, end), y + (TICK + 1.5 * LINE) * em);
        sheet.text(Anchor::Middle, middle, "tests (logarithmic)");
    }
}

/// The looks of the two bars, and what they count.
const BARS: [(Look, &str); 2] = [
    (Look::VISITED.full(), "object tests"),
    (Look::REJECTED, "bound tests, nodes and cells"),
];

/// What the looks of the bars mean.
fn legend(sheet: &mut Sheet, mut at: DVec2) {
    let em = sheet.letters;
    for (look, words) in BARS {
        bar(sheet, look, at, 2.0 * em);
        at.x += (2.0 + GAP) * em;
        sheet.text(Anchor::Start, at, words);
        at.x += sheet.width_of(words) + 2.0 * GAP * em;
    }
}

/// A bar from its left end, in height around it.
fn bar(sheet: &mut Sheet, look: Look, from: DVec2, length: f64) {
    let half = DVec2::new(0.0, 0.5 * BAR * sheet.letters);
    let frame = Frame {
        min: from - half,
        max: from + DVec2::new(length, 0.0) + half,
    };
    sheet.rectangle(look, frame);
}

/// One strategy.
fn bars(sheet: &mut Sheet, axis: &Axis, row: &CostRow, top: f64) {
    let em = sheet.letters;
    let name = DVec2::new(axis.start - GAP * em, top + LINE * em);
    sheet.text(Anchor::End, name, &row.name);
    let Some(counts) = row.counts else {
        let at = DVec2::new(axis.start + GAP * em, top + LINE * em);
        sheet.text(Anchor::Start, at, "not built");
        return;
    };
    for (line, ((look, _), count)) in BARS.into_iter().zip(counts).enumerate() {
        let middle = top + (line as f64 + 0.5) * LINE * em;
        let mut end = axis.start;
        if 0 < count {
            end = axis.place(count);
            let from = DVec2::new(axis.start, middle);
            bar(sheet, look, from, end - axis.start);
        }
        let place = DVec2::new(end + GAP * em, middle);
        sheet.text(Anchor::Start, place, grouped(count));
    }
}

/// The numbers in words.
fn description(rows: &[CostRow]) -> String {
    let sentences = rows.iter().map(|row| match row.counts {
        Some([tests, searched]) => format!(
            "{}: {} object tests; {} bound tests, nodes and cells.",
            row.name,
            grouped(tests),
            grouped(searched)
        ),
        None => format!("{}: not built.", row.name),
    });
    let sentences: Vec<String> = sentences.collect();
    sentences.join(" ")
}

/// 1, 10, 10², 10³, …
fn power_of_ten(power: u32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match power {
        0 => "1".into(),
        1 => "10".into(),
        _ => {
            let digits = power.to_string();
            let raised = digits
                .bytes()
                .map(|digit| RAISED[usize::from(digit - b'0')]);
            format!("10{}", raised.collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis_of(rows: &[CostRow]) -> Axis {
        let sheet = Sheet::new(Width::Book, 400.0);
        Axis::of(&sheet, sheet.body(), rows)
    }

    #[test]
    fn powers_of_ten_are_written_with_raised_digits() {
        let written = [0, 1, 2, 8, 19].map(power_of_ten);
        assert_eq!(written, ["1", "10", "10²", "10⁸", "10¹⁹"]);
    }

    #[test]
    fn ten_times_as_many_tests_are_one_power_of_ten_further() {
        let rows = [CostRow {
            name: "x".into(),
            counts: Some([1, 100_000]),
        }];
        let axis = axis_of(&rows);
        assert_eq!(axis.decades, 5);
        assert_eq!(axis.place(1), axis.one);
        for count in [1, 10, 100, 1000, 10_000] {
            let step = axis.place(10 * count) - axis.place(count);
            assert!((step - axis.decade).abs() < 1e-9, "{count}");
        }
    }

    #[test]
    fn every_count_lies_on_the_axis() {
        for (largest, decades) in [(0, 1), (1, 1), (2, 1), (10, 1), (11, 2), (u64::MAX, 20)] {
            let counts = Some([0, largest]);
            let axis = axis_of(&[CostRow {
                name: "hierarchy, bottom-up, own slabs".into(),
                counts,
            }]);
            assert_eq!(axis.decades, decades, "{largest}");
            assert!(0.0 < axis.decade, "{largest}");
        }
    }
}
