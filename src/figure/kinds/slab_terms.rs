//! t = (S + D)·T as a table: what is constant for the scene, for each bound and for each ray, and what is left for each slab of
//! a bound: a sum and a product (slides, "Optimizing Intersection Calculations"; erratum 2). A parallel ray has no T.

use glam::DVec2;

use crate::explain::{Part, shown};
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::slabs::{SlabRow, SlabTests, bounded};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::{StageId, StageName};
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::geometry::SlabInterval;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 340.0,
    usual: &[],
    more: &[],
};

/// A column: the group that it belongs to, its head, and a cell for each slab.
struct Column {
    group: usize,
    head: Text,
    cells: Vec<Text>,
}

#[expect(clippy::too_many_lines, reason = "the table column by column")]
fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let drawn = figure.ray()?;
    let found = SlabTests::find(figure, &drawn.events)?;
    let rows: Vec<_> = found.rows().collect();
    let of = bounded(figure, found.of);
    let digits = match sheet.width {
        Width::Book => 4,
        Width::Slide => 3,
    };
    let number = |value: f64| -> Text {
        if value.is_finite() {
            shown(value, digits).into()
        } else {
            "∞".into()
        }
    };
    let column = |group: usize, head: &str, cell: &dyn Fn(usize) -> Text| Column {
        group,
        head: formula(head),
        cells: (0..rows.len()).map(cell).collect(),
    };
    let columns = [
        column(0, "n", &|row| formula(&rows[row].slab.name())),
        column(0, "(A, B, C)", &|row| {
            let [a, b, c] = rows[row].slab.normal.to_array().map(|of| shown(of, digits));
            format!("({a}, {b}, {c})").into()
        }),
        column(1, "D_min", &|row| number(rows[row].slab.d_min)),
        column(1, "D_max", &|row| number(rows[row].slab.d_max)),
        column(2, "S", &|row| number(rows[row].line.s)),
        column(2, "T", &|row| number(rows[row].line.t_scale)),
        column(3, "near", &|row| match rows[row].interval {
            SlabInterval::Between { near, .. } => number(near),
            SlabInterval::ParallelInside => "inside".into(),
            SlabInterval::ParallelOutside => "outside".into(),
        }),
        column(3, "far", &|row| match rows[row].interval {
            SlabInterval::Between { far, .. } => number(far),
            _ => Text::default(),
        }),
    ];
    let groups = match sheet.width {
        Width::Book => [
            "once for the scene",
            "once for each bound",
            "once for each ray",
            "t = (S + D)·T",
        ],
        Width::Slide => ["scene", "bound", "ray", "t = (S + D)·T"],
    };
    let count = rows.len();
    let sentences = [
        format!("Once for the scene: the directions of {count} slabs."),
        format!("Once for each bound: D_min and D_max of each slab, here of {of}."),
        "Once for each ray: S = A·x₀ + B·y₀ + C·z₀ and T = −1/(A·Δx + B·Δy + C·Δz).".to_owned(),
        format!(
            "For each slab of each bound a sum and a product are left: {}",
            worked(&rows)
        ),
    ];
    let names: [StageName; 4] = [
        "scene".into(),
        "bound".into(),
        "ray".into(),
        Part::NearFar.into(),
    ];
    let last = found.tests.last().map(|(step, _)| *step);
    let mut stages: Vec<StageId> = names
        .into_iter()
        .zip(&sentences)
        .map(|(name, sentence)| sheet.stage(name, last, sentence.as_str()))
        .collect();
    let parallel = rows
        .iter()
        .filter(|row| !matches!(row.interval, SlabInterval::Between { .. }));
    let parallel: Vec<String> = parallel.map(parallel_in_words).collect();
    if !parallel.is_empty() {
        stages.push(sheet.stage("parallel", last, parallel.join(" ")));
    }

    let line = sheet.line_height();
    let em = sheet.letters;
    let widths: Vec<f64> = columns
        .iter()
        .map(|of| {
            let cells = of.cells.iter().chain([&of.head]);
            cells.map(|text| text.width() * em).fold(0.0, f64::max)
        })
        .collect();
    let all: f64 = widths.iter().sum();
    // groups stand further apart than columns
    let gaps = (widths.len() + 3) as f64;
    let gap = ((body.size().x - all) / gaps).min(2.0 * em);
    // the ground of a group is a little wider than its columns
    let mut x = body.min.x + 0.4 * gap;
    let top = body.min.y;
    let mut spans = [[f64::INFINITY, f64::NEG_INFINITY]; 4];
    let mut places = Vec::new();
    let mut group = 0;
    for (of, width) in columns.iter().zip(&widths) {
        if of.group != group {
            x += gap;
            group = of.group;
        }
        places.push(x);
        let [start, end] = &mut spans[of.group];
        *start = start.min(x);
        *end = end.max(x + width);
        x += width + gap;
    }
    for ((span, name), stage) in spans.into_iter().zip(groups).zip(&stages) {
        let half = 0.4 * gap;
        sheet.at(*stage, |sheet| {
            sheet.rectangle(
                Look::VISITED.inside(),
                Frame {
                    min: DVec2::new(span[0] - half, top + line),
                    max: DVec2::new(span[1] + half, top + (count as f64 + 2.2) * line),
                },
            );
            let middle = DVec2::new(f64::midpoint(span[0], span[1]), top + 0.5 * line);
            sheet.text(Anchor::Middle, middle, formula(name));
        });
    }
    for ((of, x), width) in columns.iter().zip(&places).zip(&widths) {
        sheet.at(stages[of.group], |sheet| {
            let middle = x + 0.5 * width;
            let head = DVec2::new(middle, top + 1.6 * line);
            sheet.text(Anchor::Middle, head, of.head.clone());
            for (row, cell) in (0..).zip(&of.cells) {
                let at = DVec2::new(middle, top + (f64::from(row) + 2.7) * line);
                sheet.text(Anchor::Middle, at, cell.clone());
            }
        });
    }
    let [_, below] = body.split_top((count as f64 + 2.7) * line);
    let formulas = [
        (
            2,
            "S = A·x₀ + B·y₀ + C·z₀,   T = -1/(A·Δx + B·Δy + C·Δz)".to_owned(),
        ),
        (3, worked(&rows)),
    ];
    let mut rest = below;
    for (stage, text) in formulas {
        rest = sheet.at(stages[stage], |sheet| sheet.lines(rest, &[formula(&text)]));
    }
    if let Some(stage) = stages.get(4) {
        let texts: Vec<Text> = parallel.iter().map(|text| formula(text)).collect();
        sheet.at(*stage, |sheet| sheet.lines(rest, &texts));
    }
    let mut told = Vec::from(sentences);
    told.extend(parallel);
    Ok(told.join(" "))
}

/// The first slab worked out.
fn worked(rows: &[SlabRow]) -> String {
    let first = rows
        .iter()
        .find(|row| matches!(row.interval, SlabInterval::Between { .. }));
    let Some(row) = first else {
        return "all slabs are parallel to the ray.".into();
    };
    let SlabInterval::Between { near, .. } = row.interval else {
        return String::new();
    };
    // n·Δ > 0 makes T negative: then the near plane is that of D_max (erratum 5)
    let (d, name) = if row.line.t_scale < 0.0 {
        (row.slab.d_max, "D_max")
    } else {
        (row.slab.d_min, "D_min")
    };
    let bracket = |value: f64| {
        let text = quantity(value);
        if value < 0.0 {
            format!("({text})")
        } else {
            text
        }
    };
    format!(
        "near of {} = (S + {name})·T = ({} + {})·{} = {}.",
        row.slab.name(),
        quantity(row.line.s),
        bracket(d),
        bracket(row.line.t_scale),
        quantity(near)
    )
}

/// A ray that is parallel to a slab: it is compared, not divided.
fn parallel_in_words(row: &SlabRow) -> String {
    let [low, high] = [0.0 - row.slab.d_max, 0.0 - row.slab.d_min].map(quantity);
    let s = quantity(row.line.s);
    let (verdict, sign) = match row.interval {
        SlabInterval::ParallelOutside => ("outside", "is not true"),
        _ => ("inside", "is true"),
    };
    format!(
        "{}: the ray is parallel, T = ∞. -D_max ≤ S ≤ -D_min, which is {low} ≤ {s} ≤ {high}, {sign}: {verdict} at every t.",
        row.slab.name()
    )
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use serde_json::json;

    use crate::figure::kinds::slabs::by_hand;
    use crate::figure::read_back::ReadBack;

    #[test]
    fn s_t_near_and_far_are_those_of_the_ray_and_the_cube() {
        // from (0, −4.6, 0) along (0.8, 0.6, 0): S = 0 and −4.6, T = −1/0.8 and −1/0.6; x from 4 to 6, y from −1 to 1
        let traced = by_hand::trace(DVec3::new(0.0, -4.6, 0.0), DVec3::new(0.8, 0.6, 0.0));
        let drawn = ReadBack::of(
            json!({"kind": "slab-terms", "pixel": [0, 0], "view": "front"}),
            traced,
        );
        let texts = drawn.texts();
        for text in ["−1.25", "−1.667", "−4.6", "5", "7.5", "6", "9.333"] {
            assert!(texts.iter().any(|of| of == text), "{text}: {texts:?}");
        }
    }
}
