//! What each strategy costs, as bars on a logarithmic axis.

use crate::explain::{Comparison, grouped};
use crate::figure::canvas::{ADVANCE, Anchor, Canvas, Look};

/// Width of the drawing: that of a page of mdBook, so that letters keep their size there.
const WIDTH: f64 = 760.0;
/// Around the drawing.
const MARGIN: f64 = 12.0;
/// Between letters and what they belong to.
const GAP: f64 = 8.0;
/// A line of letters with some air: 14 and a quarter of that above and below.
const LINE: f64 = 21.0;
/// Height of a bar, within its line.
const BAR: f64 = 14.0;
/// Between the bars of two strategies.
const BETWEEN: f64 = 10.0;
/// How long the bar of a single test is. A logarithmic axis has no 0: it begins a little before 1, so that
/// 1 differs from 0.
const ONE: f64 = 14.0;
/// Length of a tick.
const TICK: f64 = 6.0;

/// Draws two bars for each strategy: object tests, full; tests of bounds, nodes entered and cells visited,
/// outlined. The number stands at the bar's end; a bar of 0 is a 0 where the axis begins.
///
/// The drawing's name begins its ids and classes: a word of letters, digits and `-`. The same comparison
/// gives the same bytes: times are not drawn.
pub fn cost_chart(id: &str, comparison: &Comparison) -> String {
    let rows: Vec<Row> = comparison
        .compared
        .iter()
        .map(|compared| Row {
            name: compared.name(),
            counts: compared
                .cost
                .as_ref()
                .ok()
                .map(|cost| [cost.counts.objects_tested(), cost.searched()]),
        })
        .collect();
    let axis = Axis::of(&rows);
    let bottom = MARGIN + LINE + BETWEEN + rows.len() as f64 * ROW;
    let height = bottom + TICK + 2.0 * LINE + MARGIN;
    let title = format!("What each strategy costs. {}", comparison.title());
    let mut canvas = Canvas::new(id, [WIDTH, height], &title, &description(&rows));

    legend(&mut canvas, axis.start);
    for (place, row) in rows.iter().enumerate() {
        let top = MARGIN + LINE + BETWEEN + place as f64 * ROW;
        bars(&mut canvas, &axis, row, top);
    }
    axis.draw(&mut canvas, bottom);
    canvas.into_svg()
}

/// From one strategy to the next.
const ROW: f64 = 2.0 * LINE + BETWEEN;

/// A strategy's bars.
struct Row {
    name: String,
    /// Object tests; tests of bounds, nodes and cells. `None` if the structure cannot be built.
    counts: Option<[u64; 2]>,
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
    fn of(rows: &[Row]) -> Self {
        let width = |text: &str| text.chars().count() as f64 * ADVANCE;
        let names = rows.iter().map(|row| width(&row.name)).fold(0.0, f64::max);
        let counts = rows.iter().filter_map(|row| row.counts).flatten();
        let largest = counts.max().unwrap_or(0);
        let start = MARGIN + names + GAP;
        let end = WIDTH - MARGIN - width(&grouped(largest)) - GAP;
        // 10 is one power of ten, 11 reaches into the second; there is at least one
        let decades = largest.saturating_sub(1).checked_ilog10().unwrap_or(0) + 1;
        let one = start + ONE;
        Self {
            start,
            one,
            decade: (end - one) / f64::from(decades),
            decades,
        }
    }

    /// Where a count is, which is not 0.
    fn place(&self, count: u64) -> f64 {
        self.one + (count as f64).log10() * self.decade
    }

    fn draw(&self, canvas: &mut Canvas, y: f64) {
        let end = self.one + self.decade * f64::from(self.decades);
        let top = MARGIN + LINE + BETWEEN;
        canvas.line(Look::Thin, [self.start, top], [self.start, y]);
        canvas.line(Look::Thin, [self.start, y], [end, y]);
        // the longest label with some air: every so many powers of ten have one
        let label = power_of_ten(self.decades).chars().count() as f64 * ADVANCE + GAP;
        let labelled = (label / self.decade).ceil().max(1.0) as u32;
        for power in 0..=self.decades {
            let x = self.one + self.decade * f64::from(power);
            canvas.line(Look::Thin, [x, y], [x, y + TICK]);
            if power.is_multiple_of(labelled) {
                let middle = y + TICK + 0.5 * LINE;
                canvas.text(Anchor::Middle, [x, middle], &power_of_ten(power));
            }
        }
        let middle = [f64::midpoint(self.start, end), y + TICK + 1.5 * LINE];
        canvas.text(Anchor::Middle, middle, "tests (logarithmic)");
    }
}

/// The looks of the two bars, and what they count.
const BARS: [(Look, &str); 2] = [
    (Look::Full, "object tests"),
    (Look::Outlined, "bound tests, nodes and cells"),
];

/// What the looks of the bars mean.
fn legend(canvas: &mut Canvas, mut x: f64) {
    /// A piece of a bar.
    const SWATCH: f64 = 24.0;
    let middle = MARGIN + 0.5 * LINE;
    for (look, words) in BARS {
        canvas.rectangle(look, [x, middle - 0.5 * BAR], [SWATCH, BAR]);
        x += SWATCH + GAP;
        canvas.text(Anchor::Start, [x, middle], words);
        x += words.chars().count() as f64 * ADVANCE + 2.0 * GAP;
    }
}

/// One strategy.
fn bars(canvas: &mut Canvas, axis: &Axis, row: &Row, top: f64) {
    canvas.text(Anchor::End, [axis.start - GAP, top + LINE], &row.name);
    let Some(counts) = row.counts else {
        let at = [axis.start + GAP, top + LINE];
        canvas.text(Anchor::Start, at, "not built");
        return;
    };
    for (line, ((look, _), count)) in BARS.into_iter().zip(counts).enumerate() {
        let middle = top + (line as f64 + 0.5) * LINE;
        let mut end = axis.start;
        if 0 < count {
            end = axis.place(count);
            let corner = [axis.start, middle - 0.5 * BAR];
            canvas.rectangle(look, corner, [end - axis.start, BAR]);
        }
        canvas.text(Anchor::Start, [end + GAP, middle], &grouped(count));
    }
}

/// The numbers in words.
fn description(rows: &[Row]) -> String {
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

    #[test]
    fn powers_of_ten_are_written_with_raised_digits() {
        let written = [0, 1, 2, 8, 19].map(power_of_ten);
        assert_eq!(written, ["1", "10", "10²", "10⁸", "10¹⁹"]);
    }

    #[test]
    fn ten_times_as_many_tests_are_one_power_of_ten_further() {
        let rows = [Row {
            name: "x".into(),
            counts: Some([1, 100_000]),
        }];
        let axis = Axis::of(&rows);
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
            let axis = Axis::of(&[Row {
                name: "hierarchy, bottom-up, own slabs".into(),
                counts,
            }]);
            assert_eq!(axis.decades, decades, "{largest}");
            assert!(0.0 < axis.decade, "{largest}");
        }
    }
}
