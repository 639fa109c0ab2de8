//! The bound of two bounds (Fig. 15.58(b)): of each pair of planes the minimum D_min and the maximum D_max.

mod argument;
mod joined;
mod table;

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::merge::argument::Argument;
use crate::figure::kinds::merge::joined::Joined;
use crate::figure::kinds::merge::table::Table;
use crate::figure::kinds::slabs::planes;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Projection;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 420.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Slabs,
        Layer::Normals,
        Layer::Volumes,
        Layer::Numbers,
    ],
    more: &[],
};

/// The bound of both.
const BOTH: Look = Look::VISITED.wide(3.0);
/// A bound that goes into it.
const ONE: Look = Look {
    dash: Dash::Dashed,
    ..Look::THIN.wide(1.25)
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let joined = Joined::find(figure)?;
    let projection = figure.projection();
    let argument = Argument::new(sheet, &joined, &projection);
    let drawing = if figure.shows(Layer::Numbers) {
        let table = Table::new(sheet, body, &joined, &argument.slabs);
        let gap = 2.0 * sheet.letters;
        /// Of the width at most.
        const SHARE: f64 = 0.58;
        let rest = 1.0 - table.width() / (body.size().x - gap);
        let [left, right] = body.split(rest.clamp(0.0, SHARE), gap);
        table.draw(sheet, right, argument.bounds);
        left
    } else {
        body
    };
    let [first, second, both] = &joined.bounds;
    let middle = bound::middle(both);
    /// So much more than the bound is shown, so that its planes are seen to go on.
    const AROUND: f64 = 1.4;
    let shown = bound::corners(both).into_iter();
    let space = figure.space(drawing, shown.map(|p| middle + AROUND * (p - middle)));
    sheet.at(argument.bounds, |sheet| {
        if figure.shows(Layer::Objects) {
            scenery::some_objects(figure, sheet, &space, &joined.objects, Look::OBJECT);
        }
        if figure.shows(Layer::Volumes) {
            for slabs in [first, second] {
                let around = bound::outline(slabs, &space.projection);
                outline::rim(sheet, &space, &around.rim, ONE);
            }
        }
        if figure.shows(Layer::Names) {
            for (slabs, name) in [first, second].into_iter().zip(&joined.names) {
                let at = space.place(bound::middle(slabs));
                sheet.label(space.frame, at, DVec2::X, name.as_str());
            }
        }
    });
    if figure.shows(Layer::Slabs) {
        // a slide has room for the table or for normals: there the lines have the names of theirs
        let is_book = sheet.width == Width::Book;
        let names = if is_book { 3.2 } else { 1.75 };
        let margin = DVec2::new(names, 2.0) * sheet.letters;
        let room = Frame {
            min: space.frame.min + margin,
            max: space.frame.max - margin,
        };
        let name = |slab: &Slab, d: &'static str| {
            if is_book {
                formula(d)
            } else {
                formula(&slab.name())
            }
        };
        let normals = figure.shows(Layer::Normals) && is_book;
        planes(
            sheet,
            (&space, room),
            both,
            &argument.slabs,
            (name, normals),
        );
    }
    if figure.shows(Layer::Volumes) {
        sheet.at(argument.both, |sheet| {
            let around = bound::outline(both, &space.projection);
            outline::rim(sheet, &space, &around.rim, BOTH);
        });
    }
    Ok(in_words(&joined, &projection))
}

fn in_words(joined: &Joined, projection: &Projection) -> String {
    let [first, second] = &joined.names;
    let mut sentences = vec![format!(
        "The bounds of {first} and {second}, and the bound of both."
    )];
    for ((_, merge), slab) in joined.steps.iter().zip(&joined.bounds[2]) {
        if !slab.is_on_edge(projection) {
            continue;
        }
        let [a, b] = merge.d_min.map(quantity);
        let [c, d] = merge.d_max.map(quantity);
        sentences.push(format!(
            "Slab {}: D_min is the minimum of {a} and {b}, {}; D_max is the maximum of {c} and {d}, {}.",
            merge.slab,
            quantity(slab.d_min),
            quantity(slab.d_max)
        ));
    }
    sentences.join(" ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, traced};
    use crate::scene::small_scene::{cube_at, scene_of};
    use crate::structure::MergeStep;
    use crate::trace::{Event, Record, StrategyName};

    #[test]
    fn the_bound_of_both_reaches_from_one_to_the_other() {
        // two cubes with sides of 1, from x = 0 and from x = 3
        let scene = scene_of(&[cube_at(0.0), cube_at(3.0)]);
        let mut traced = traced(scene, []);
        traced.settings.strategy = StrategyName::Hierarchy;
        let of_x = ([-1.0, -4.0], [0.0, -3.0]);
        let of_yz = ([-1.0, -1.0], [0.0, 0.0]);
        for (slab, (d_min, d_max)) in (0..).zip([of_x, of_yz, of_yz]) {
            let merge = MergeStep {
                node: 0,
                first: 1,
                second: 2,
                slab,
                d_min,
                d_max,
            };
            traced.records.push(Record {
                pixel: None,
                path: None,
                step: slab,
                ray: None,
                parent: None,
                event: Event::Merge(merge),
            });
        }
        let drawn = ReadBack::of(json!({"kind": "merge", "view": "front"}), traced);
        let width = |points: &Vec<glam::DVec2>| {
            let x = points.iter().map(|at| at.x);
            let [left, right] = [x.clone().fold(f64::MAX, f64::min), x.fold(0.0, f64::max)];
            right - left
        };
        // one cube is 1 wide, both are 4
        let closed = |colour| {
            let mut all = drawn.paths(colour);
            all.retain(|points| 4 <= points.len());
            all
        };
        let both = closed("visited");
        assert_eq!(both.len(), 1, "{both:?}");
        let one = width(&closed("ink")[0]);
        assert!(
            10.0 < one && (width(&both[0]) - 4.0 * one).abs() < 0.1,
            "{one} {both:?}"
        );
    }
}
