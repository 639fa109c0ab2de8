//! The slides' own sum: a picture's pixels times its objects, against what each strategy takes. Testing every object is counted
//! exactly; the others are measured on every n-th pixel both ways, times n².

use crate::explain::{Compared, Cost, grouped};
use crate::figure::cost_chart::{CostRow, cost_bars, height};
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::subject::Figure;
use crate::trace::StrategyName;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 460.0,
    usual: &[],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let [width, height_of_picture] = figure.scene.camera.pixels.map(u64::from);
    let objects = figure.scene.primitives.len() as u64;
    let pixels = width * height_of_picture;
    let product = pixels * objects;
    let mut rows = Vec::new();
    let mut measured = None;
    for traced in figure.traced {
        let totals = traced.of_pixels.totals.ok_or_else(|| {
            FigureError::new(
                "scene",
                "the log does not have the number of tests of the picture",
                "trace the figure again",
            )
        })?;
        let every = u64::from(totals.every);
        let scale = every * every;
        let compared = Compared {
            settings: traced.settings.clone(),
            cost: Ok(Cost::default()),
        };
        let counts = if traced.settings.strategy == StrategyName::Exhaustive {
            [product, 0]
        } else {
            measured = Some(every);
            [
                totals.objects * scale,
                (totals.nodes + totals.cells) * scale,
            ]
        };
        rows.push(CostRow {
            name: compared.name(),
            counts: Some(counts),
        });
    }
    let sum = format!(
        "{width} × {height_of_picture} pixels × {objects} objects = {} tests",
        grouped(product)
    );
    let mut lines = vec![sum.clone()];
    if let Some(every) = measured {
        lines.push(format!(
            "others: measured on every {every}th pixel both ways, times {}",
            every * every
        ));
    }
    let there = sheet.stage("pixels × objects", None, format!("{sum}."));
    let rest = sheet.at(there, |sheet| sheet.lines(body, &lines));
    if rest.size().y < height(rows.len()) * sheet.letters {
        return Err(FigureError::new(
            "strategies",
            format!("the bars of {} strategies do not fit", rows.len()),
            "compare fewer of them",
        ));
    }
    let bars = cost_bars(sheet, rest, rows);
    Ok(format!("{}. {bars}", lines.join("; ")))
}
