//! A line-drawing algorithm beside the grid walk, on one ray (slides, "3D version of the line-drawing algorithm"; erratum 7):
//! the first sets one cell in each column, the second visits every cell that the ray pierces.

use glam::DVec2;

use crate::explain::cell_name;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline;
use crate::figure::parts::plan::{EMPTY, Lattice, Plan};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::Walk;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::mistake::{Wrong, mistake};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 340.0,
    usual: &[crate::figure::spec::Layer::Ray],
    more: &[],
};

/// What students write in place of the walk, and what the slides name.
const LINE: &str = "one cell per column";

/// A cell that the line leaves out.
const SKIPPED: Look = Look::REJECTED.wide(2.0);

#[expect(clippy::too_many_lines, reason = "the drawing from left to right")]
fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let walk = Walk::of(&ray, figure.scene)?;
    let start = ray.node.start.ok_or_else(no_ray)?;
    let line = match mistake(LINE).map(|of| of.wrong) {
        Some(Wrong::CellsVisited(cells)) => {
            let grid = &walk.grid;
            cells(&grid.around, grid.resolution, &start.ray, start.range)
        }
        _ => return Err(no_ray()),
    };
    let pierced: Vec<[u32; 3]> = walk.visits.iter().map(|visit| visit.cell.cell).collect();
    let is_skipped = |cell: &&[u32; 3]| !line.contains(cell);
    let skipped: Vec<[u32; 3]> = pierced.iter().filter(is_skipped).copied().collect();
    let hit = ray.node.end.and_then(|end| end.object.zip(end.t));

    let of_line = format!(
        "Line drawing sets {} cells, one in each column.",
        line.len()
    );
    let names: Vec<String> = skipped.iter().map(|cell| cell_name(*cell)).collect();
    let of_skipped = format!(
        "It skips {}, which the ray passes through.",
        names.join(", ")
    );
    let of_walk = format!("The walk visits {} cells and skips none.", pierced.len());
    let last = ray.events.last().map(|record| record.step);
    let there = sheet.stage("line drawing", walk.step, of_line.as_str());
    let left_out = sheet.stage("skipped", walk.step, of_skipped.as_str());
    let visited = sheet.stage("grid walk", last, of_walk.as_str());
    let of_hit = match (hit, pierced.last()) {
        (Some((object, t)), Some(cell)) => {
            let name = scenery::name_of(figure.scene, object);
            let is_lost = skipped.contains(cell);
            let lost = if is_lost {
                " Line drawing never looks there."
            } else {
                ""
            };
            format!(
                "Cell {} holds the hit with {name} at t = {}.{lost}",
                cell_name(*cell),
                quantity(t)
            )
        }
        _ => "The ray hits nothing.".into(),
    };
    let end = sheet.stage("hit", last, of_hit.as_str());

    let entries = [
        (Some(there), EMPTY, "visited"),
        (
            Some(left_out),
            SKIPPED,
            "skipped, though the ray passes through",
        ),
        (Some(end), Look::ANSWER, "hit"),
    ];
    let body = sheet.staged_legend(body, &entries);
    let gap = 2.0 * sheet.letters;
    let panels = body.split(0.5, gap);
    let heads = match sheet.width {
        Width::Book => [
            format!("line drawing: {} cells, one in each column", line.len()),
            format!("grid walk: {} cells, all on the ray", pierced.len()),
        ],
        Width::Slide => [
            format!("line drawing: {} cells", line.len()),
            format!("grid walk: {} cells", pierced.len()),
        ],
    };
    let lattice = Lattice::of(&walk.grid);
    for (place, (panel, head)) in panels.into_iter().zip(heads).enumerate() {
        let [above, panel] = panel.split_top(1.3 * sheet.line_height());
        let plan = Plan::new(figure, (&ray, &walk), panel)?;
        let is_line = place == 0;
        let stage = if is_line { there } else { visited };
        let at = DVec2::new(above.middle().x, above.min.y + 0.5 * sheet.line_height());
        sheet.at(stage, |sheet| sheet.text(Anchor::Middle, at, head));
        let area = |sheet: &mut Sheet, cell: [u32; 3], look: Look| {
            let outline = lattice.cell(cell, &plan.space.projection);
            outline::rim(sheet, &plan.space, &outline.rim, look);
        };
        for &cell in if is_line { &line } else { &pierced } {
            sheet.at(stage, |sheet| area(sheet, cell, EMPTY));
        }
        plan.planes(sheet);
        if is_line {
            for &cell in &skipped {
                sheet.at(left_out, |sheet| area(sheet, cell, SKIPPED));
            }
        }
        scenery::objects(figure, sheet, &plan.space, |_| Look::OBJECT);
        scenery::names(figure, sheet, &plan.space);
        sheet.at(stage, |sheet| plan.whole_ray(sheet, !is_line));
        if let (Some((object, t)), false) = (hit, is_line) {
            let shape = &figure.scene.primitive(object).shape;
            let outline = outline::Outline::of(shape, &plan.space.projection);
            sheet.at(end, |sheet| {
                outline::rim(sheet, &plan.space, &outline.rim, Look::ANSWER.outline());
                sheet.dot(Look::ANSWER, plan.place(t));
            });
        }
    }
    Ok(format!("{of_line} {of_skipped} {of_walk} {of_hit}"))
}

fn no_ray() -> FigureError {
    FigureError::new(
        "strategy",
        "the ray was not traced through a grid",
        "add \"strategy\": \"grid\"",
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, ball};

    #[test]
    fn along_an_axis_both_visit_the_same_cells() {
        let objects = json!([
            ball("A", [0.0; 3], 1.0),
            ball("B", [6.0, 0.0, 0.0], 1.0),
            ball("C", [-4.0, 0.0, 3.0], 1.0)
        ]);
        let spec = json!({ "kind": "line-drawing", "strategy": "grid", "view": "top", "structure": { "grid": { "resolution": [4, 1, 1] } } });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        let texts = drawn.texts();
        // the box goes from x = −5 to 7 in four columns, and A is hit at −1, in the second one
        for text in [
            "line drawing: 4 cells, one in each column",
            "grid walk: 2 cells, all on the ray",
        ] {
            assert!(texts.iter().any(|of| of == text), "{text}: {texts:?}");
        }
        // the swatch of the legend alone
        assert_eq!(
            drawn.paths("rejected").len() + drawn.rectangles("rejected").len(),
            1
        );
    }
}
