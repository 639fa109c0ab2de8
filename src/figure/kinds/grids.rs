//! The same ray through grids of several resolutions, with the cells and the tests that each takes: too coarse a grid tests
//! many objects, too fine a grid visits many cells.

use glam::DVec2;

use crate::explain::grouped;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::plan::{Lattice, Plan};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::Walk;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure, records_in};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 340.0,
    usual: &[Layer::Ray],
    more: &[],
};

/// A cell that was visited: with a rim, as the tint of a small one drowns between the planes.
const CELL: Look = Look::VISITED.wide(1.0);

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let pixel = figure.pixel()?;
    let mut walks = Vec::new();
    for traced in figure.traced {
        let ray = DrawnRay::find(records_in(traced, pixel)?, figure.spec.ray.unwrap_or(0))?;
        let walk = Walk::of(&ray, figure.scene)?;
        walks.push((ray, walk));
    }
    let objects = figure.scene.primitives.len();
    let sentences = walks.iter().map(|(_, walk)| {
        let [nx, ny, nz] = walk.grid.resolution;
        let (cells, tests) = numbers(walk);
        format!(
            "{nx} × {ny} × {nz} cells: the ray visits {} and tests {} of {objects} objects, {} in all.",
            counted(cells, "cell"),
            grouped(tests),
            grouped(cells + tests)
        )
    });
    let sentences: Vec<String> = sentences.collect();
    // each grid has a log of its own, so a later one may need fewer steps; a stage shows all grids up to its own
    let mut needs = None;
    let mut stages = Vec::new();
    for ((ray, walk), sentence) in walks.iter().zip(&sentences) {
        let [nx, ny, nz] = walk.grid.resolution;
        needs = needs.max(ray.events.last().map(|record| record.step));
        stages.push(sheet.stage(
            format!("{nx} × {ny} × {nz} cells"),
            needs,
            sentence.as_str(),
        ));
    }
    let entries = [
        (stages.first().copied(), CELL, "visited"),
        (stages.first().copied(), Look::REJECTED, "tested and missed"),
        (stages.first().copied(), Look::ANSWER, "hit"),
        (None, Look::CULLED, "not tested"),
    ];
    let body = sheet.staged_legend(body, &entries);
    let count = walks.len() as f64;
    let gap = 1.5 * sheet.letters;
    let width = (body.size().x - (count - 1.0) * gap) / count;
    let line = sheet.line_height();
    for (place, ((ray, walk), stage)) in walks.iter().zip(stages).enumerate() {
        let left = body.min.x + place as f64 * (width + gap);
        let room = Frame {
            min: DVec2::new(left, body.min.y + line),
            max: DVec2::new(left + width, body.max.y - 2.5 * line),
        };
        let plan = Plan::new(figure, (ray, walk), room)?;
        let lattice = Lattice::of(&walk.grid);
        let [nx, ny, nz] = walk.grid.resolution;
        let (cells, tests) = numbers(walk);
        plan.planes(sheet);
        sheet.at(stage, |sheet| {
            for visit in &walk.visits {
                let outline = lattice.cell(visit.cell.cell, &plan.space.projection);
                outline::rim(sheet, &plan.space, &outline.rim, CELL);
            }
        });
        let tested = walk.tested();
        scenery::objects(figure, sheet, &plan.space, |_| Look::CULLED);
        let nearest = ray.node.end.and_then(|end| end.object);
        sheet.at(stage, |sheet| {
            for listed in &tested {
                let shape = &figure.scene.primitive(listed.object).shape;
                let outline = Outline::of(shape, &plan.space.projection);
                let look = if nearest == Some(listed.object) {
                    Look::ANSWER.wide(2.0)
                } else {
                    Look::REJECTED.wide(1.25)
                };
                outline::rim(sheet, &plan.space, &outline.rim, look);
            }
            plan.whole_ray(sheet, true);
            if let Some(t) = ray.node.end.and_then(|end| end.t) {
                sheet.dot(Look::ANSWER, plan.place(t));
            }
            let around = lattice_frame(&lattice, &plan);
            let middle = 0.5 * (left + left + width);
            let head = DVec2::new(middle, around.min.y - 0.6 * line);
            sheet.text(Anchor::Middle, head, format!("{nx} × {ny} × {nz} cells"));
            let texts = [
                format!("{} + {}", counted(cells, "cell"), counted(tests, "test")),
                format!("= {}", grouped(cells + tests)),
            ];
            for (below, text) in (0..).zip(texts) {
                let y = around.max.y + (f64::from(below) + 0.8) * line;
                sheet.text(Anchor::Middle, DVec2::new(middle, y), text);
            }
        });
    }
    Ok(sentences.join(" "))
}

/// What a grid's box fills.
fn lattice_frame(lattice: &Lattice, plan: &Plan) -> Frame {
    let corners = lattice.box_corners().map(|corner| plan.space.place(corner));
    Frame::around(corners).unwrap_or(plan.space.frame)
}

fn counted(number: u64, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{} {thing}{plural}", grouped(number))
}

/// How many cells were visited, and how many objects tested.
fn numbers(walk: &Walk) -> (u64, u64) {
    (walk.visits.len() as u64, walk.tested().len() as u64)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, ball};

    #[test]
    fn cells_and_tests_are_those_of_the_walk() {
        let objects = json!([
            ball("A", [0.0; 3], 1.0),
            ball("B", [6.0, 0.0, 0.0], 1.0),
            ball("C", [-4.0, 0.0, 3.0], 1.0)
        ]);
        let spec = json!({ "kind": "grids", "strategy": "grid", "view": "top", "structure": { "grid": { "resolution": [4, 1, 1] } } });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        // x from −5 to 7 in four columns: C is in the first, A in the second, and the walk ends there
        let texts = drawn.texts();
        for text in ["4 × 1 × 1 cells", "2 cells + 2 tests", "= 4"] {
            assert!(texts.iter().any(|of| of == text), "{text}: {texts:?}");
        }
    }
}
