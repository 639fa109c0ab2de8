//! The scene's box cut into a regular grid of equal-sized volumes (Fig. 15.61); in 2D also the list of each cell.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::plan::{self, Lattice, depth_axis};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::Walk;
use crate::figure::parts::{depth, outline};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::parts;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::scene::{Primitive, PrimitiveId};
use crate::structure::AssignStep;
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 440.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Cells, Layer::Numbers],
    more: &[Layer::Lists],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let walk = Walk::of(&figure.ray()?, figure.scene)?;
    let lattice = Lattice::of(&walk.grid);
    let [x, y, z] = lattice.resolution;
    let words = format!(
        "The box is cut into {x} × {y} × {z} cells of equal size, {} in all.",
        u64::from(x) * u64::from(y) * u64::from(z)
    );
    let objects = figure.scene.objects.len();
    let there = sheet.stage(
        "scene",
        None,
        format!("All {objects} objects of the scene lie in one box."),
    );
    let cut = sheet.stage(Part::Grid, None, words.as_str());
    let lists = if figure.shows(Layer::Lists) {
        depth_axis(figure)?;
        lists_of(figure)
    } else {
        Vec::new()
    };
    let sentences = sentences(figure, &lists);
    for part in parts(lists.len(), MOST_LISTS) {
        let last = lists[part.clone()].iter().flat_map(|of| &of.cells);
        let step = last.map(|(_, step)| *step).max();
        sheet.stage(Part::Building, step, sentences[part].join(" "));
    }
    let body = if lists.is_empty() {
        body
    } else {
        let stage = lists.first().and_then(|of| of.cells.first());
        let stage = stage.and_then(|(_, step)| sheet.stage_of(*step));
        sheet.staged_legend(body, &[(stage, plan::EMPTY, "list not empty")])
    };
    // room for what stands beside the box
    let room = body.wider(-0.5 * sheet.letters);
    let space = figure.space(room, lattice.box_corners());
    let in_space = space.projection.in_space;

    if figure.shows(Layer::Cells) {
        sheet.at(cut, |sheet| planes(figure, sheet, &space, &lattice));
    }
    if figure.shows(Layer::Lists) {
        draw_lists(figure, sheet, &space, &lattice, &lists);
    }
    sheet.at(there, |sheet| {
        frame(sheet, &space, &lattice);
    });
    if figure.shows(Layer::Objects) {
        sheet.at(there, |sheet| {
            scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        });
    }
    if figure.shows(Layer::Numbers) {
        sheet.at(cut, |sheet| numbers(sheet, &space, &lattice));
    }
    let mut told = vec![words];
    if in_space && figure.shows(Layer::Cells) {
        told.push(one_cell(sheet, &space, &lattice));
    }
    if figure.shows(Layer::Names) {
        sheet.at(there, |sheet| scenery::names(figure, sheet, &space));
    }
    told.extend(sentences);
    Ok(told.join(" "))
}

/// With those of the scene and of the grid a dozen.
const MOST_LISTS: usize = 10;

/// The box: its rear edges and what is around it; those in front, through which it is seen, are dashed.
fn frame(sheet: &mut Sheet, space: &Space, lattice: &Lattice) {
    let whole = lattice.whole(&space.projection);
    outline::rim(sheet, space, &whole.rim, Look::THIN.wide(1.75));
    for edge in &whole.hidden {
        outline::line_on(sheet, space, Look::THIN.wide(1.25), edge);
    }
    let rim = whole.rim.points();
    let is_inside = |edge: &&Vec<DVec2>| !edge.iter().all(|end| rim.contains(end));
    for edge in whole.edges.iter().filter(is_inside) {
        outline::line_on(sheet, space, Look::HELP.wide(0.75), edge);
    }
}

/// The cell that is nearest to who looks, as an example of all.
fn one_cell(sheet: &mut Sheet, space: &Space, lattice: &Lattice) -> String {
    let towards = space.projection.towards();
    let cell = [0, 1, 2].map(|axis| {
        if 0.0 < towards[axis] {
            lattice.resolution[axis] - 1
        } else {
            0
        }
    });
    let size = lattice.corner(cell.map(|at| at + 1)) - lattice.corner(cell);
    let [x, y, z] = size.to_array().map(quantity);
    let sentence = format!("Each cell is {x} × {y} × {z} large.");
    let stage = sheet.stage(Part::Cell, None, sentence.as_str());
    sheet.at(stage, |sheet| {
        let outline = lattice.cell(cell, &space.projection);
        outline::draw(sheet, space, &outline, Look::VISITED.wide(2.0));
        if let Some(area) = lattice.area(cell, space) {
            let upper = DVec2::new(area.middle().x, area.min.y);
            sheet.label(sheet.body(), upper, DVec2::new(1.0, -1.0), "one cell");
        }
    });
    sentence
}

/// The cells on whose lists an object is.
struct OnLists {
    object: PrimitiveId,
    /// Each with the step of the building.
    cells: Vec<([u32; 3], u32)>,
}

/// The objects in the order in which they are put on lists.
fn lists_of(figure: &Figure) -> Vec<OnLists> {
    let mut lists: Vec<OnLists> = Vec::new();
    for record in figure.first.building() {
        let Event::Assign(AssignStep { object, cell, .. }) = record.event else {
            continue;
        };
        match lists.last_mut() {
            Some(last) if last.object == object => last.cells.push((cell, record.step)),
            _ => lists.push(OnLists {
                object,
                cells: vec![(cell, record.step)],
            }),
        }
    }
    lists
}

fn sentences(figure: &Figure, lists: &[OnLists]) -> Vec<String> {
    let sentences = lists.iter().map(|of| {
        let name = scenery::name_of(figure.scene, of.object);
        let lists = match of.cells.len() {
            1 => "1 list".into(),
            count => format!("{count} lists"),
        };
        format!("{name} is on {lists}.")
    });
    sentences.collect()
}

/// The list of each cell in braces, as the events of the building fill it.
fn draw_lists(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    lattice: &Lattice,
    lists: &[OnLists],
) {
    let mut cells: BTreeMap<[u32; 3], Vec<(u32, String)>> = BTreeMap::new();
    for of in lists {
        for (cell, step) in &of.cells {
            let names = cells.entry(*cell).or_default();
            if let (true, Some(area)) = (names.is_empty(), lattice.area(*cell, space)) {
                sheet.event(*step, |sheet| sheet.rectangle(plan::EMPTY, area));
            }
            names.push((*step, scenery::name_of(figure.scene, of.object)));
        }
    }
    for (cell, names) in cells {
        let Some(area) = lattice.area(cell, space) else {
            continue;
        };
        let Some(((first, name), more)) = names.split_first() else {
            continue;
        };
        sheet.event(*first, |sheet| sheet.label_in(area, format!("{{{name}")));
        for (step, name) in more {
            sheet.event(*step, |sheet| sheet.label_goes_on(format!(", {name}")));
        }
        // the list has an end from the first, with room for who comes later
        sheet.event(*first, |sheet| sheet.label_goes_on("}"));
    }
}

/// A face is seen from its edge if no more than this of a unit vector is across it: rounding.
const FLAT: f64 = 1e-9;

/// The planes between the cells, on the faces of the box behind everything.
fn planes(figure: &Figure, sheet: &mut Sheet, space: &Space, lattice: &Lattice) {
    let towards = space.projection.towards();
    let covers: Vec<&Primitive> = if space.projection.in_space && figure.shows(Layer::Objects) {
        figure.scene.primitives.iter().collect()
    } else {
        Vec::new()
    };
    for axis in 0..3 {
        if towards[axis].abs() <= FLAT {
            continue;
        }
        let n = lattice.resolution;
        let face = if 0.0 < towards[axis] { 0 } else { n[axis] };
        let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
        for (across, along) in [(a, b), (b, a)] {
            for place in 1..n[across] {
                let end = |to: u32| {
                    let mut at = [face; 3];
                    (at[across], at[along]) = (place, to);
                    lattice.corner(at)
                };
                let ends = [end(0), end(n[along])];
                sheet.within(space.frame, |sheet| {
                    depth::line(sheet, space, Look::THIN.wide(0.75), ends, &covers);
                });
            }
        }
    }
}

/// How many cells there are along each axis, beside an edge.
fn numbers(sheet: &mut Sheet, space: &Space, lattice: &Lattice) {
    let towards = space.projection.towards();
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if 1.0 - FLAT <= towards[axis].abs() {
            // seen from its end
            continue;
        }
        // the lowest edge along x or z, the rightmost along y
        let outwards = if axis == 1 { DVec2::X } else { DVec2::Y };
        let middles = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|ends: [u32; 2]| {
            let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
            let n = lattice.resolution;
            let end = |of: u32| {
                let mut at = [of * n[axis]; 3];
                (at[a], at[b]) = (ends[0] * n[a], ends[1] * n[b]);
                space.place(lattice.corner(at))
            };
            end(0).lerp(end(1), 0.5)
        });
        let far = |middle: &DVec2| outwards.dot(*middle);
        let Some(at) = middles.into_iter().max_by(|a, b| far(a).total_cmp(&far(b))) else {
            continue;
        };
        let cells = match lattice.resolution[axis] {
            1 => "1 cell".into(),
            many => format!("{many} cells"),
        };
        let middle = space.frame.middle();
        let sideways = DVec2::new((at.x - middle.x).signum(), 0.0);
        sheet.label(
            sheet.body(),
            at,
            outwards + sideways,
            Text::from(format!("{cells} along ")) + formula(name),
        );
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, ball};

    #[test]
    fn the_cells_with_a_list_are_those_that_hold_an_object() {
        let objects = json!([
            ball("A", [0.0; 3], 0.9),
            ball("B", [6.0, 0.0, 0.0], 1.0),
            ball("C", [-4.0, 0.0, 3.0], 1.0)
        ]);
        let spec = json!({
            "kind": "partition", "strategy": "grid", "view": "top", "structure": { "grid": { "resolution": [4, 1, 1] } }, "show": ["objects", "names", "cells", "lists"]
        });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        let mut cells = drawn.rectangles("visited");
        // the last one is that of the legend
        cells.sort_by(|a, b| {
            a.min
                .y
                .total_cmp(&b.min.y)
                .then(a.min.x.total_cmp(&b.min.x))
        });
        cells.pop();
        // x from −5 to 7 in four cells: C in the first one, A in the second one, B in the fourth one
        let width = cells[0].size().x;
        let columns = cells
            .iter()
            .map(|cell| (cell.min.x - cells[0].min.x) / width);
        let columns: Vec<f64> = columns.collect();
        assert_eq!(columns.len(), 3, "{columns:?}");
        for (column, expected) in columns.iter().zip([0.0, 1.0, 3.0]) {
            assert!((column - expected).abs() < 1e-3, "{columns:?}");
        }
    }
}
