//! A ray through a grid in 2D (Fig. 15.62): the cells it pierces, in order, and the objects on their lists.
//!
//! An object in several cells is tested in the first of them; a hit beyond its cell does not end the walk (erratum 6).

use crate::explain::cell_name;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::plan::{self, Plan};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::{Listed, Visit, Walk};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure};
use crate::figure::view::Space;
use crate::scene::PrimitiveId;
use crate::trace::WalkEnd;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 440.0,
    usual: &[Layer::Objects, Layer::Cells, Layer::Ray, Layer::Tests],
    more: &[
        Layer::Names,
        Layer::Eye,
        Layer::Lists,
        Layer::Numbers,
        Layer::Legend,
    ],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let walk = Walk::of(&ray, figure.scene)?;
    let tested = walk.tested();
    let cells: Vec<String> = (1..)
        .zip(&walk.visits)
        .map(|(number, visit)| cell_in_words(figure, number, visit))
        .collect();
    let end = plan::stages(
        sheet,
        &ray,
        &walk,
        &cells,
        end_in_words(figure, &ray, &walk),
    );
    let body = if figure.shows(Layer::Legend) {
        legend(figure, (&walk, &tested), end, sheet, body)
    } else {
        body
    };
    let body = if figure.shows(Layer::Lists) {
        counted(sheet, &walk, end, body)
    } else {
        body
    };
    let plan = Plan::new(figure, (&ray, &walk), body)?;

    if figure.shows(Layer::Cells) {
        plan.planes(sheet);
        for (place, visit) in walk.visits.iter().enumerate() {
            let label = label(figure, sheet.width, place + 1, visit);
            plan.cell(sheet, visit, label);
        }
    }
    if figure.shows(Layer::Objects) {
        let look = if figure.shows(Layer::Tests) {
            Look::CULLED
        } else {
            Look::OBJECT
        };
        scenery::objects(figure, sheet, &plan.space, |_| look);
    }
    if figure.shows(Layer::Tests) {
        for listed in &tested {
            object(figure, sheet, &plan.space, (&ray, listed), end);
        }
    }
    if figure.shows(Layer::Ray) {
        plan.ray(sheet, &walk);
    }
    if figure.shows(Layer::Tests) {
        sheet.within(plan.space.frame, |sheet| {
            hits(figure, sheet, &plan, (&ray, &walk), end);
        });
    }
    if figure.shows(Layer::Eye) {
        scenery::eye(figure, sheet, &plan.space);
    }
    for object in &figure.scene.objects {
        let is_it = |listed: &&Listed| figure.scene.object_of(listed.object).first == object.first;
        // a name belongs to the test, unless all have one
        let since = tested
            .iter()
            .filter(|_| figure.shows(Layer::Tests))
            .find(is_it);
        let name = |sheet: &mut Sheet| {
            scenery::names_of(figure, sheet, &plan.space, |other| {
                other.first == object.first
            });
        };
        match since {
            _ if figure.shows(Layer::Names) => name(sheet),
            Some(listed) => sheet.event(listed.step, name),
            None => {}
        }
    }
    Ok(in_words(figure, &ray, &walk))
}

/// The number of a cell, and its list if lists are shown: what was tested before stands in brackets.
fn label(figure: &Figure, width: Width, number: usize, visit: &Visit) -> String {
    if !figure.shows(Layer::Lists) || visit.listed.is_empty() {
        return number.to_string();
    }
    let names = visit.listed.iter().map(|listed| {
        let name = scenery::name_of(figure.scene, listed.object);
        match listed.met {
            Some(_) => name,
            None => format!("({name})"),
        }
    });
    let names: Vec<String> = names.collect();
    match width {
        Width::Book => format!("{number}: {}", names.join(", ")),
        Width::Slide => names.join(", "),
    }
}

/// Was this object the nearest in the end?
fn is_nearest(ray: &DrawnRay, object: PrimitiveId) -> bool {
    ray.node.end.is_some_and(|end| end.object == Some(object))
}

/// An object that was tested, over its own outline; in the end the nearest one.
fn object(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    (ray, tested): (&DrawnRay, &Listed),
    end: StageId,
) {
    let shape = &figure.scene.primitive(tested.object).shape;
    let outline = Outline::of(shape, &space.projection);
    let over = |sheet: &mut Sheet, look: Look| {
        outline::rim(sheet, space, &outline.rim, Look::PAPER_LINE.wide(2.0));
        outline::draw(sheet, space, &outline, look);
    };
    let is_hit = tested.met == Some(true);
    let look = if is_hit { Look::MET } else { Look::REJECTED };
    sheet.event(tested.step, |sheet| over(sheet, look));
    if is_hit && is_nearest(ray, tested.object) {
        sheet.at(end, |sheet| over(sheet, Look::ANSWER));
    }
}

/// The number of tests, if mailboxes have saved some.
fn counted(sheet: &mut Sheet, walk: &Walk, end: StageId, body: Frame) -> Frame {
    let all = walk.visits.iter().flat_map(|visit| &visit.listed);
    let listed = all.clone().count();
    let tested = all.filter(|listed| listed.met.is_some()).count();
    if tested == listed {
        return body;
    }
    let tests = if tested == 1 { "test" } else { "tests" };
    let saved =
        format!("{tested} {tests} in place of {listed}: in brackets what was tested before");
    sheet.at(end, |sheet| sheet.lines(body, &[saved]))
}

/// Where objects were hit.
fn hits(
    figure: &Figure,
    sheet: &mut Sheet,
    plan: &Plan,
    (ray, walk): (&DrawnRay, &Walk),
    end: StageId,
) {
    let frame = plan.space.frame;
    for (place, visit) in walk.visits.iter().enumerate() {
        for listed in &visit.listed {
            let Some(outside) = listed.outside else {
                continue;
            };
            let at = plan.place(outside.t);
            sheet.event(listed.step, |sheet| {
                sheet.ring(Look::MET, at);
                let beyond = match sheet.width {
                    Width::Book => format!("beyond cell {}", place + 1),
                    Width::Slide => "beyond".into(),
                };
                sheet.label(frame, at, plan.above(), beyond);
            });
        }
    }
    let Some(t) = ray.node.end.and_then(|end| end.t) else {
        return;
    };
    let at = plan.place(t);
    sheet.at(end, |sheet| {
        sheet.dot(Look::ANSWER, at);
        if figure.shows(Layer::Numbers) {
            sheet.label(frame, at, plan.above(), formula("t = ") + quantity(t));
        }
    });
}

/// The looks that this figure distinguishes, each since it is seen first.
fn legend(
    figure: &Figure,
    (walk, tested): (&Walk, &[Listed]),
    end: StageId,
    sheet: &mut Sheet,
    body: Frame,
) -> Frame {
    let mut listed = walk.visits.iter().flat_map(|visit| &visit.listed);
    let is_beyond = listed.any(|of| of.outside.is_some());
    let mut entries = Vec::new();
    if figure.shows(Layer::Cells) {
        let first = |is_empty: bool| {
            let mut visits = walk.visits.iter();
            let first = visits.find(|visit| (visit.length == 0) == is_empty);
            first.map(|visit| visit.step)
        };
        entries.push((first(true), plan::EMPTY, "visited"));
        entries.push((first(false), plan::LISTED, "with objects"));
    }
    if figure.shows(Layer::Tests) {
        let first = |is_hit: bool| {
            let tests = tested.iter().filter(|of| of.met == Some(is_hit));
            tests.map(|of| of.step).min()
        };
        if is_beyond {
            entries.push((first(true), Look::MET, "hit"));
        }
        entries.push((first(false), Look::REJECTED, "missed"));
    }
    let mut entries: Vec<_> = entries
        .into_iter()
        .filter_map(|(step, look, text)| Some((sheet.stage_of(step?), look, text)))
        .collect();
    if tested.iter().any(|of| of.met == Some(true)) {
        let name = if is_beyond { "nearest hit" } else { "hit" };
        entries.push((Some(end), Look::ANSWER, name));
    }
    if figure.shows(Layer::Tests) && tested.len() < figure.scene.primitives.len() {
        entries.push((None, Look::CULLED, "not tested"));
    }
    sheet.staged_legend(body, &entries)
}

/// The walk in words.
fn in_words(figure: &Figure, ray: &DrawnRay, walk: &Walk) -> String {
    let [nx, ny, nz] = walk.grid.resolution;
    let count = walk.visits.len();
    let cells = if count == 1 { "cell" } else { "cells" };
    let mut sentences = vec![format!(
        "Ray R visits {count} {cells} of a grid of {nx} × {ny} × {nz}."
    )];
    let visits = (1..).zip(&walk.visits);
    let listed = visits.filter(|(_, visit)| !visit.listed.is_empty());
    sentences.extend(listed.map(|(number, visit)| cell_in_words(figure, number, visit)));
    sentences.push(end_in_words(figure, ray, walk));
    sentences.join(" ")
}

/// What a ray through the grid hits.
fn end_in_words(figure: &Figure, ray: &DrawnRay, walk: &Walk) -> String {
    let met = ray.node.end.and_then(|end| end.object.zip(end.t));
    match (met, walk.end) {
        (Some((object, t)), _) => {
            let name = scenery::name_of(figure.scene, object);
            format!("The ray hits {name} at t = {}.", quantity(t))
        }
        (None, WalkEnd::Outside) => "The ray misses the grid.".into(),
        (None, _) => "The ray hits no object.".into(),
    }
}

/// What became of the objects on a cell's list.
fn cell_in_words(figure: &Figure, number: u32, visit: &Visit) -> String {
    let cell = cell_name(visit.cell.cell);
    if visit.length == 0 {
        return format!("Cell {number}, {cell}: no object is on its list.");
    }
    let found = visit.listed.iter().map(|listed| {
        let name = scenery::name_of(figure.scene, listed.object);
        match (listed.met, listed.outside) {
            (None, _) => format!("{name} was tested before"),
            (Some(false), _) => format!("{name} is missed"),
            (Some(true), None) => format!("{name} is hit"),
            (Some(true), Some(outside)) => format!(
                "{name} is hit, but at t = {}, beyond the cell, so the walk goes on",
                quantity(outside.t)
            ),
        }
    });
    let found: Vec<String> = found.collect();
    format!("Cell {number}, {cell}: {}.", found.join("; "))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, ball};

    #[test]
    fn the_hit_lies_a_third_of_the_way_through_the_grid() {
        let objects = json!([
            ball("A", [0.0; 3], 1.0),
            ball("B", [6.0, 0.0, 0.0], 1.0),
            ball("C", [-4.0, 0.0, 3.0], 1.0)
        ]);
        let spec = json!({ "kind": "grid", "strategy": "grid", "view": "top", "structure": { "grid": { "resolution": [4, 1, 1] } } });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        // the box goes from x = −5 to 7, and A is hit at −1
        let planes = drawn.upright("ink");
        let (first, last) = (planes[0], planes[planes.len() - 1]);
        let third = first + (last - first) / 3.0;
        let hit = drawn
            .dots("answer")
            .into_iter()
            .find(|at| (at.x - third).abs() < DRAWN);
        assert!(hit.is_some(), "{:?}, not {third}", drawn.dots("answer"));
        // two cells of a width of 3, of which the second one has A on its list
        let cells = drawn.rectangles("visited").len() + drawn.paths("visited").len();
        assert!(2 <= cells, "{cells}");
    }
}
