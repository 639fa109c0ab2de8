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
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
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

/// An object that was hit, but behind another.
const MET: Look = Look {
    dash: Dash::Alternating,
    ..Look::ANSWER
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let walk = Walk::of(&ray, figure.scene)?;
    let tested = walk.tested();
    let body = if figure.shows(Layer::Legend) {
        legend(figure, (&ray, &tested), sheet, body)
    } else {
        body
    };
    let plan = Plan::new(figure, (&ray, &walk), body)?;

    if figure.shows(Layer::Cells) {
        plan.planes(sheet);
        for (place, visit) in walk.visits.iter().enumerate() {
            plan.cell(sheet, visit, label(figure, place + 1, visit));
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
            object(figure, sheet, &plan.space, (&ray, listed));
        }
    }
    if figure.shows(Layer::Ray) {
        plan.ray(sheet, &walk);
    }
    if figure.shows(Layer::Tests) {
        hits(figure, sheet, &plan, (&ray, &walk));
    }
    if figure.shows(Layer::Eye) {
        scenery::eye(figure, sheet, &plan.space);
    }
    scenery::names_of(figure, sheet, &plan.space, |object| {
        let is_it = |listed: &Listed| figure.scene.object_of(listed.object).first == object.first;
        let is_tested = figure.shows(Layer::Tests) && tested.iter().any(is_it);
        is_tested || figure.shows(Layer::Names)
    });
    Ok(in_words(figure, &ray, &walk))
}

/// The number of a cell, and its list if lists are shown: what was tested before stands in brackets.
fn label(figure: &Figure, number: usize, visit: &Visit) -> String {
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
    format!("{number}: {}", names.join(", "))
}

/// Was this object the nearest in the end?
fn is_nearest(ray: &DrawnRay, object: PrimitiveId) -> bool {
    ray.node.end.is_some_and(|end| end.object == Some(object))
}

fn look(ray: &DrawnRay, tested: &Listed) -> Look {
    match tested.met {
        Some(true) if is_nearest(ray, tested.object) => Look::ANSWER,
        Some(true) => MET,
        _ => Look::REJECTED,
    }
}

/// An object that was tested, over its own outline.
fn object(figure: &Figure, sheet: &mut Sheet, space: &Space, (ray, tested): (&DrawnRay, &Listed)) {
    let shape = &figure.scene.primitive(tested.object).shape;
    let outline = Outline::of(shape, &space.projection);
    sheet.step(tested.step, |sheet| {
        outline::rim(sheet, space, &outline.rim, Look::PAPER_LINE.wide(2.0));
        outline::draw(sheet, space, &outline, look(ray, tested));
    });
}

/// Where objects were hit.
fn hits(figure: &Figure, sheet: &mut Sheet, plan: &Plan, (ray, walk): (&DrawnRay, &Walk)) {
    let frame = plan.space.frame;
    for (place, visit) in walk.visits.iter().enumerate() {
        for listed in &visit.listed {
            let Some(outside) = listed.outside else {
                continue;
            };
            let at = plan.place(outside.t);
            sheet.step(listed.step, |sheet| {
                sheet.ring(MET, at);
                let beyond = format!("beyond cell {}", place + 1);
                sheet.label(frame, at, plan.above(), beyond);
            });
        }
    }
    let Some(t) = ray.node.end.and_then(|end| end.t) else {
        return;
    };
    let at = plan.place(t);
    sheet.step(plan.last_step(), |sheet| {
        sheet.dot(Look::ANSWER, at);
        if figure.shows(Layer::Numbers) {
            sheet.label(frame, at, plan.above(), format!("t = {}", quantity(t)));
        }
    });
}

/// The looks that this figure distinguishes.
fn legend(
    figure: &Figure,
    (ray, tested): (&DrawnRay, &[Listed]),
    sheet: &mut Sheet,
    body: Frame,
) -> Frame {
    let mut entries = Vec::new();
    if figure.shows(Layer::Cells) {
        entries.push((plan::EMPTY, "visited, empty"));
        entries.push((plan::LISTED, "visited, with objects"));
    }
    if figure.shows(Layer::Tests) {
        let looks: Vec<Look> = tested.iter().map(|of| look(ray, of)).collect();
        let known = [
            (Look::ANSWER, "hit"),
            (MET, "hit, but farther"),
            (Look::REJECTED, "missed"),
        ];
        entries.extend(known.into_iter().filter(|(look, _)| looks.contains(look)));
        if looks.len() < figure.scene.primitives.len() {
            entries.push((Look::CULLED, "not tested"));
        }
    }
    sheet.legend(body, &entries)
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
    sentences.extend(visits.filter_map(|(number, visit)| list_in_words(figure, number, visit)));
    let met = ray.node.end.and_then(|end| end.object.zip(end.t));
    sentences.push(match (met, walk.end) {
        (Some((object, t)), _) => {
            let name = scenery::name_of(figure.scene, object);
            format!("It hits {name} at t = {}.", quantity(t))
        }
        (None, WalkEnd::Outside) => "It misses the grid.".into(),
        (None, _) => "It hits no object.".into(),
    });
    sentences.join(" ")
}

/// What became of the objects on a cell's list; `None` if there are none.
fn list_in_words(figure: &Figure, number: u32, visit: &Visit) -> Option<String> {
    if visit.listed.is_empty() {
        return None;
    }
    let found = visit.listed.iter().map(|listed| {
        let name = scenery::name_of(figure.scene, listed.object);
        match (listed.met, listed.outside) {
            (None, _) => format!("{name} was tested before"),
            (Some(false), _) => format!("{name} is missed"),
            (Some(true), None) => format!("{name} is hit"),
            (Some(true), Some(_)) => format!("{name} is hit, but beyond the cell"),
        }
    });
    let found: Vec<String> = found.collect();
    let cell = cell_name(visit.cell.cell);
    Some(format!(
        "On the list of cell {number}, {cell}: {}.",
        found.join("; ")
    ))
}
