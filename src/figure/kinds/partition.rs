//! The scene's box cut into a regular grid of equal-sized volumes (Fig. 15.61); in 2D also the list of each cell.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline;
use crate::figure::parts::plan::{self, Lattice, depth_axis};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::Walk;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::scene::PrimitiveId;
use crate::structure::AssignStep;
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 440.0,
    usual: &[Layer::Objects, Layer::Cells, Layer::Numbers],
    more: &[Layer::Names, Layer::Lists],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let walk = Walk::of(&figure.ray()?, figure.scene)?;
    let lattice = Lattice::of(&walk.grid);
    // room for what stands beside the box
    let room = body.wider(-0.5 * sheet.letters);
    let space = figure.space(room, lattice.box_corners());

    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    }
    let [x, y, z] = lattice.resolution;
    let mut words = format!(
        "The scene's box is cut into {x} × {y} × {z} cells of equal size, {} in all.",
        u64::from(x) * u64::from(y) * u64::from(z)
    );
    if figure.shows(Layer::Lists) {
        depth_axis(figure)?;
        words += &lists(figure, sheet, &space, &lattice);
    }
    if figure.shows(Layer::Cells) {
        planes(sheet, &space, &lattice);
    }
    let whole = lattice.whole(&space.projection);
    outline::draw(sheet, &space, &whole, Look::THIN.wide(1.75));
    if figure.shows(Layer::Numbers) {
        numbers(sheet, &space, &lattice);
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    Ok(words)
}

/// The list of each cell in braces, as the events of the building fill it; and in words.
fn lists(figure: &Figure, sheet: &mut Sheet, space: &Space, lattice: &Lattice) -> String {
    let mut lists: BTreeMap<[u32; 3], (u32, Vec<String>)> = BTreeMap::new();
    let mut cells_of: Vec<(PrimitiveId, usize)> = Vec::new();
    for record in figure.first.building() {
        let Event::Assign(AssignStep { object, cell, .. }) = record.event else {
            continue;
        };
        let (step, names) = lists.entry(cell).or_default();
        *step = record.step;
        names.push(scenery::name_of(figure.scene, object));
        match cells_of.last_mut() {
            Some((last, count)) if *last == object => *count += 1,
            _ => cells_of.push((object, 1)),
        }
    }
    for (cell, (step, names)) in lists {
        let Some(area) = lattice.area(cell, space) else {
            continue;
        };
        sheet.step(step, |sheet| {
            sheet.rectangle(plan::LISTED.outline(), area);
            sheet.label_in(area, format!("{{{}}}", names.join(", ")));
        });
    }
    let sentences = cells_of.iter().map(|(object, count)| {
        let name = scenery::name_of(figure.scene, *object);
        let lists = if *count == 1 { "list" } else { "lists" };
        format!(" {name} is on {count} {lists}.")
    });
    sentences.collect()
}

/// A face is seen from its edge if no more than this of a unit vector is across it: rounding.
const FLAT: f64 = 1e-9;

/// The planes between the cells, on the faces of the box that are seen.
fn planes(sheet: &mut Sheet, space: &Space, lattice: &Lattice) {
    let towards = space.projection.towards();
    for axis in 0..3 {
        if towards[axis].abs() <= FLAT {
            continue;
        }
        let n = lattice.resolution;
        let face = if 0.0 < towards[axis] { n[axis] } else { 0 };
        let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
        for (across, along) in [(a, b), (b, a)] {
            for place in 1..n[across] {
                let end = |to: u32| {
                    let mut at = [face; 3];
                    (at[across], at[along]) = (place, to);
                    space.projection.of(lattice.corner(at))
                };
                let line = [end(0), end(n[along])];
                outline::line_on(sheet, space, Look::THIN.wide(0.75), &line);
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
            format!("{cells} along {name}"),
        );
    }
}
