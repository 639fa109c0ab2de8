//! What each strategy costs, as bars of honest length: on a linear axis from 0, all tests in one bar.

use glam::DVec2;

use crate::explain::{Comparison, grouped, grouped_sum};
use crate::figure::parts::ticks;
use crate::figure::sheet::canvas::{Canvas, Rendition};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::{Anchor, Sheet, Width};

/// Between letters and what they belong to, in sizes of the letters.
const GAP: f64 = 0.6;
/// A line of letters with some air: the letters and a quarter of that above and below.
const LINE: f64 = 1.5;
/// Height of a bar, within its line.
const BAR: f64 = 1.1;
/// Between the bars of two strategies.
const BETWEEN: f64 = 0.5;
/// Length of a tick.
const TICK: f64 = 0.4;
/// From one strategy to the next.
const ROW: f64 = LINE + BETWEEN;

/// Draws one bar for each strategy, the cheapest first: object tests, full; behind them tests of bounds, nodes entered and
/// cells visited, light. The total stands at the bar's end, and what it consists of.
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
    let description = cost_bars(&mut sheet, body, rows);
    let title = format!("What each strategy costs. {}", comparison.title());
    Canvas::write(sheet, id, [&title, &description], Rendition::default())
}

/// How high the bars of a number of strategies are, with legend and axis, in sizes of the letters.
pub(super) fn height(rows: usize) -> f64 {
    LINE + BETWEEN + rows as f64 * ROW + TICK + 2.0 * LINE
}

/// A strategy's bar.
pub(super) struct CostRow {
    pub(super) name: String,
    /// Object tests; tests of bounds, nodes and cells. `None` if the structure cannot be built.
    pub(super) counts: Option<[u64; 2]>,
}

impl CostRow {
    /// All tests.
    fn total(&self) -> Option<u128> {
        let counts = self.counts?;
        Some(counts.into_iter().map(u128::from).sum())
    }

    /// The total, and what it consists of if that is of two kinds.
    fn numbers(&self) -> String {
        match (self.counts, self.total()) {
            (Some([tests, searched]), Some(total)) if 0 < tests && 0 < searched => format!(
                "{} = {} + {}",
                grouped_sum(total),
                grouped(tests),
                grouped(searched)
            ),
            (_, Some(total)) => grouped_sum(total),
            (_, None) => "not built".into(),
        }
    }
}

/// Draws the bars from the top of a frame, the cheapest first, and says them in words.
pub(super) fn cost_bars(sheet: &mut Sheet, frame: Frame, mut rows: Vec<CostRow>) -> String {
    rows.sort_by_key(|row| row.total().unwrap_or(u128::MAX));
    let axis = Axis::of(sheet, frame, &rows);
    let em = sheet.letters;
    let top = frame.min.y + (LINE + BETWEEN) * em;
    legend(sheet, DVec2::new(axis.start, frame.min.y + 0.5 * LINE * em));
    // told from the dearest to the cheapest
    let dearest_first = rows.iter().rev();
    let mut stages: Vec<StageId> = dearest_first
        .map(|row| sheet.stage(row.name.clone(), None, sentence(row)))
        .collect();
    stages.reverse();
    for (place, (row, stage)) in rows.iter().zip(stages).enumerate() {
        sheet.at(stage, |sheet| {
            bars(sheet, &axis, row, top + place as f64 * ROW * em);
        });
    }
    axis.draw(sheet, [top, top + rows.len() as f64 * ROW * em]);
    description(&rows)
}

/// The axis of counts, from 0.
struct Axis {
    /// Where 0 is, and where bars begin.
    start: f64,
    /// Where the last tick is.
    end: f64,
    ticks: Vec<u128>,
}

impl Axis {
    /// From the longest name to as far right as the numbers behind the bars allow.
    fn of(sheet: &Sheet, frame: Frame, rows: &[CostRow]) -> Self {
        let em = sheet.letters;
        let names = rows.iter().map(|row| sheet.width_of(&row.name));
        let names = names.fold(0.0, f64::max);
        let start = frame.min.x + names + GAP * em;
        let most = rows.iter().filter_map(CostRow::total).max().unwrap_or(0);
        let ticks = ticks::linear(most);
        let last = ticks[ticks.len() - 1];
        // each bar with its numbers ends within the frame, and the axis as well, with half of its last number
        let room = |row: &CostRow| {
            let share = row.total().unwrap_or(0) as f64 / last as f64;
            let numbers = sheet.width_of(row.numbers()) + 2.0 * GAP * em;
            (frame.max.x - start - numbers) / share
        };
        let half = 0.5 * sheet.width_of(grouped_sum(last));
        let longest = frame.max.x - start - half;
        let length = rows.iter().map(room).fold(longest, f64::min);
        Self {
            start,
            end: start + length,
            ticks,
        }
    }

    /// Where a count is.
    fn place(&self, count: u128) -> f64 {
        let last = self.ticks[self.ticks.len() - 1];
        self.start + count as f64 / last as f64 * (self.end - self.start)
    }

    fn draw(&self, sheet: &mut Sheet, [top, y]: [f64; 2]) {
        let em = sheet.letters;
        let at = DVec2::new;
        sheet.line(Look::THIN, at(self.start, top), at(self.start, y));
        sheet.line(Look::THIN, at(self.start, y), at(self.end, y));
        // the longest label with some air: only some ticks have one
        let last = self.ticks.len() - 1;
        let label = sheet.width_of(grouped_sum(self.ticks[last])) + GAP * em;
        let apart = (self.end - self.start) / last as f64;
        let labelled = (label / apart).ceil().max(1.0) as usize;
        for (place, tick) in self.ticks.iter().enumerate() {
            let x = self.place(*tick);
            sheet.line(Look::THIN, at(x, y), at(x, y + TICK * em));
            if (last - place).is_multiple_of(labelled) {
                let middle = y + (TICK + 0.5 * LINE) * em;
                sheet.text(Anchor::Middle, at(x, middle), grouped_sum(*tick));
            }
        }
        let middle = at(
            f64::midpoint(self.start, self.end),
            y + (TICK + 1.5 * LINE) * em,
        );
        sheet.text(Anchor::Middle, middle, "tests");
    }
}

/// The looks of the parts of a bar, and what they count.
const PARTS: [(Look, &str); 2] = [
    (Look::VISITED.inside().full(), "object tests"),
    (Look::VISITED.wide(0.75), "bound tests, nodes and cells"),
];

/// What the looks of the bars mean.
fn legend(sheet: &mut Sheet, mut at: DVec2) {
    let em = sheet.letters;
    for (look, words) in PARTS {
        bar(sheet, look, at, 2.0 * em);
        at.x += (2.0 + GAP) * em;
        sheet.text(Anchor::Start, at, words);
        at.x += sheet.width_of(words) + 2.0 * GAP * em;
    }
}

/// A bar from its left end, in height around it; one that is too short to be seen is left out.
fn bar(sheet: &mut Sheet, look: Look, from: DVec2, length: f64) {
    /// Of a unit of a book's sheet.
    const SEEN: f64 = 0.05;
    if length < SEEN {
        return;
    }
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
    let middle = top + 0.5 * ROW * em;
    let name = DVec2::new(axis.start - GAP * em, middle);
    sheet.text(Anchor::End, name, &row.name);
    let mut from = 0;
    for ((look, _), count) in PARTS.into_iter().zip(row.counts.unwrap_or_default()) {
        let to = from + u128::from(count);
        let [left, right] = [from, to].map(|count| axis.place(count));
        bar(sheet, look, DVec2::new(left, middle), right - left);
        from = to;
    }
    let end = DVec2::new(axis.place(from) + GAP * em, middle);
    sheet.text(Anchor::Start, end, row.numbers());
}

/// The numbers in words.
fn description(rows: &[CostRow]) -> String {
    let sentences: Vec<String> = rows.iter().map(sentence).collect();
    sentences.join(" ")
}

fn sentence(row: &CostRow) -> String {
    match (row.counts, row.total()) {
        (Some([tests, searched]), Some(total)) => format!(
            "{}: {} tests in all, {} of objects and {} of bounds, nodes and cells.",
            row.name,
            grouped_sum(total),
            grouped(tests),
            grouped(searched)
        ),
        _ => format!("{}: not built.", row.name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::sheet::Form;
    use crate::figure::sheet::text::Text;

    fn row(name: &str, counts: [u64; 2]) -> CostRow {
        CostRow {
            name: name.into(),
            counts: Some(counts),
        }
    }

    fn drawn(rows: Vec<CostRow>) -> Sheet {
        let mut sheet = Sheet::new(Width::Book, 400.0);
        let body = sheet.body();
        cost_bars(&mut sheet, body, rows);
        sheet
    }

    /// The bars behind the two of the legend: left end and length.
    fn bars_of(sheet: &Sheet) -> Vec<[f64; 2]> {
        let bars = sheet.marks.iter().filter_map(|mark| match mark.form {
            Form::Rectangle(frame) => Some([frame.min.x, frame.size().x]),
            _ => None,
        });
        bars.skip(2).collect()
    }

    #[test]
    fn a_bar_is_as_long_as_its_count_and_the_second_begins_where_the_first_ends() {
        let sheet = drawn(vec![row("b", [200, 0]), row("a", [6, 24])]);
        // the cheaper strategy comes first
        let [tests, searched, all] = bars_of(&sheet)[..] else {
            panic!("{:?}", bars_of(&sheet));
        };
        let of_one = all[1] / 200.0;
        assert!((tests[1] - 6.0 * of_one).abs() < 1e-9);
        assert!((searched[1] - 24.0 * of_one).abs() < 1e-9);
        assert!((searched[0] - (tests[0] + tests[1])).abs() < 1e-9);
        assert_eq!(tests[0], all[0]);
        for text in ["30 = 6 + 24", "200", "0", "150"].map(Text::from) {
            let has = sheet.words.iter().any(|words| words.text == text);
            assert!(has, "{text:?}");
        }
    }

    #[test]
    fn the_axis_ends_at_a_round_number_and_holds_every_count() {
        for (largest, end) in [(0, 1), (1, 1), (7, 8), (200, 200), (201, 250)] {
            let sheet = Sheet::new(Width::Book, 400.0);
            let rows = [row("hierarchy, bottom-up, own slabs", [largest, 0])];
            let axis = Axis::of(&sheet, sheet.body(), &rows);
            assert_eq!(axis.ticks.last(), Some(&end), "{largest}");
            let place = axis.place(largest.into());
            assert!(axis.start <= place && place <= axis.end, "{largest}");
        }
    }
}
