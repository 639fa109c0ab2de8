//! What each strategy costs for one pixel, as bars: object tests, and what it took to find those objects (slides,
//! "Efficiency Considerations").

use crate::explain::{Compared, Cost};
use crate::figure::cost_chart::{CostRow, cost_bars, height};
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::subject::{Figure, records_in};
use crate::figure::traced::Traced;
use crate::trace::{Counts, Record, Recorder};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 440.0,
    usual: &[],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let pixel = figure.pixel()?;
    let row = |traced| Ok(row_of(traced, records_in(traced, pixel)?));
    let rows: Vec<CostRow> = figure
        .traced
        .iter()
        .map(row)
        .collect::<Result<_, FigureError>>()?;
    let above = body.size().y - height(rows.len()) * sheet.letters;
    if above < 0.0 {
        return Err(FigureError::new(
            "strategies",
            format!("the bars of {} strategies do not fit", rows.len()),
            "compare fewer of them",
        ));
    }
    let [_, chart] = body.split_top(0.5 * above);
    let [x, y] = pixel;
    let bars = cost_bars(sheet, chart, rows);
    Ok(format!("The rays of pixel ({x}, {y}). {bars}"))
}

/// The bars of a strategy, from the events of a pixel.
fn row_of(traced: &Traced, records: &[Record]) -> CostRow {
    let mut counts = Counts::default();
    for record in records {
        counts.note(|| record.event);
    }
    let cost = Cost {
        counts,
        ..Cost::default()
    };
    let numbers = [cost.counts.objects_tested(), cost.searched()];
    let compared = Compared {
        settings: traced.settings.clone(),
        cost: Ok(cost),
    };
    CostRow {
        name: compared.name(),
        counts: Some(numbers),
    }
}
