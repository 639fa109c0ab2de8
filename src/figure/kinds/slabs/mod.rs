//! An object in slabs, in 2D (Fig. 15.58(a)): each a pair of parallel lines, and their intersection bounds it.

mod argument;
mod found;
mod planes;
mod table;

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::slabs::argument::Argument;
pub(super) use crate::figure::kinds::slabs::argument::Shown;
pub(super) use crate::figure::kinds::slabs::found::{SlabRow, SlabTests, bounded};
pub(super) use crate::figure::kinds::slabs::planes::planes;
use crate::figure::kinds::slabs::table::Table;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::trace::Bounded;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 420.0,
    usual: &[
        Layer::Objects,
        Layer::Slabs,
        Layer::Normals,
        Layer::Volumes,
        Layer::Numbers,
    ],
    more: &[Layer::Names],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let found = SlabTests::find(figure, &ray.events)?;
    let all = bound::bound_of(figure.first, found.of)?;
    let projection = figure.projection();
    let argument = Argument::new(figure, sheet, &found);
    let on_edge = argument
        .slabs
        .iter()
        .filter(|of| of.slab.is_on_edge(&projection));
    let on_edge: Vec<Shown> = on_edge.copied().collect();
    let Some(first) = on_edge.first() else {
        return Err(FigureError::new(
            "view",
            "no slab is perpendicular to this view",
            "choose the \"view\" front, and directions [A, B] in the scene's \"slabs\"",
        ));
    };

    let drawing = if figure.shows(Layer::Numbers) {
        /// Of the width at most.
        const SHARE: f64 = 0.72;
        let table = Table::new(sheet, &argument.slabs, &projection);
        let gap = 2.0 * sheet.letters;
        let rest = 1.0 - table.width() / (body.size().x - gap);
        let [left, right] = body.split(rest.clamp(0.0, SHARE), gap);
        table.draw(sheet, right);
        left
    } else {
        body
    };
    let middle = bound::middle(&all);
    /// So much more than the bound is shown, so that its planes are seen to go on.
    const AROUND: f64 = 1.75;
    let corners = bound::corners(&all);
    let shown = corners.iter().map(|p| middle + AROUND * (*p - middle));
    let space = figure.space(drawing, shown);
    // labels stand at the ends of the lines
    let sheet_width = sheet.width;
    let names = match sheet_width {
        Width::Book => 5.8,
        Width::Slide => 3.4,
    };
    let margin = DVec2::new(names, 2.0) * sheet.letters;
    let room = Frame {
        min: space.frame.min + margin,
        max: space.frame.max - margin,
    };
    if figure.shows(Layer::Objects) {
        scenery::some_objects(figure, sheet, &space, &found.objects(figure), Look::OBJECT);
    }
    let origin = space.place(DVec3::ZERO);
    if figure.shows(Layer::Slabs) && space.frame.contains(origin) {
        sheet.at(argument.object, |sheet| {
            sheet.dot(Look::RAY, origin);
            sheet.label(space.frame, origin, DVec2::NEG_X, formula("O"));
        });
        planes::distance(sheet, &space, first);
    }
    if figure.shows(Layer::Slabs) {
        // on a slide there is no room for both: the normal stands at the pair
        let name = |slab: &Slab, d: &'static str| match sheet_width {
            Width::Book => formula(&format!("{d} of {}", slab.name())),
            Width::Slide => formula(d),
        };
        let normals = figure.shows(Layer::Normals);
        planes(sheet, (&space, room), &all, &on_edge, (name, normals));
    }
    if figure.shows(Layer::Volumes) {
        sheet.at(argument.bound, |sheet| {
            let around = bound::outline(&all, &space.projection);
            outline::rim(sheet, &space, &around.rim, Look::VISITED.wide(3.0));
        });
    }
    if figure.shows(Layer::Names) {
        let at = space.place(middle) - DVec2::new(sheet.letters, 0.0);
        sheet.label(space.frame, at, DVec2::X, bounded(figure, found.of));
    }
    let slabs: Vec<Slab> = on_edge.iter().map(|shown| shown.slab).collect();
    Ok(in_words(figure, found.of, &slabs))
}

fn in_words(figure: &Figure, of: Bounded, slabs: &[Slab]) -> String {
    let mut sentences = vec![format!(
        "The bound of {}: the intersection of its slabs, of which {} are perpendicular to the view.",
        bounded(figure, of),
        slabs.len()
    )];
    for slab in slabs {
        let [a, b, c] = slab.normal.to_array().map(quantity);
        sentences.push(format!(
            "Slab {} with normal ({a}, {b}, {c}): D_min {}, D_max {}; along the normal the object lies between {} and {}.",
            slab.number,
            quantity(slab.d_min),
            quantity(slab.d_max),
            quantity(-slab.d_max),
            quantity(-slab.d_min)
        ));
    }
    sentences.join(" ")
}

/// A trace for tests, made by hand: a cube of side 2 around (5, 0, 0) in the slabs of the axes, and one ray.
#[cfg(test)]
pub(super) mod by_hand {
    use glam::DVec3;

    use crate::figure::read_back::traced;
    use crate::figure::traced::Traced;
    use crate::geometry::Ray;
    use crate::scene::small_scene::{scene_of, solid};
    use crate::structure::{SlabStep, VolumeKind};
    use crate::trace::{
        Bounded, Event, PixelSample, RayEnd, RaySlab, RayStart, SlabTest, StrategyName,
    };

    pub(in crate::figure::kinds) fn trace(origin: DVec3, direction: DVec3) -> Traced {
        let scene = scene_of(&[solid([4.0, -1.0, -1.0], [6.0, 1.0, 1.0])]);
        let start = RayStart {
            ray: Ray::new(origin, direction),
            ..RayStart::default()
        };
        let mut events = vec![
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(start)),
        ];
        let planes = [[-6.0, -4.0], [-1.0, 1.0], [-1.0, 1.0]];
        for ((slab, normal), [d_min, d_max]) in (0..).zip(DVec3::AXES).zip(planes) {
            let line = RaySlab {
                slab,
                normal,
                s: normal.dot(origin),
                t_scale: -1.0 / normal.dot(direction),
                ..RaySlab::default()
            };
            let step = SlabStep {
                slab,
                d_min,
                d_max,
                ..SlabStep::default()
            };
            let of = Bounded::Object(0);
            events.push((Some(0), Event::SlabRay(line)));
            events.push((Some(0), Event::SlabTest(SlabTest { of, step })));
        }
        events.push((Some(0), Event::RayEnd(RayEnd::default())));
        let mut traced = traced(scene, events);
        traced.settings.strategy = StrategyName::Bounds;
        traced.settings.structure.volume = VolumeKind::Slabs;
        traced
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};
    use serde_json::json;

    use crate::figure::kinds::slabs::by_hand;
    use crate::figure::read_back::ReadBack;

    #[test]
    fn the_planes_are_as_far_apart_as_their_d() {
        let traced = by_hand::trace(DVec3::new(0.0, -4.6, 0.0), DVec3::new(0.8, 0.6, 0.0));
        let spec = json!({"kind": "slabs", "pixel": [0, 0], "view": "front", "show": ["slabs"]});
        let drawn = ReadBack::of(spec, traced);
        let lines = drawn.paths("visited");
        let places = |of: usize| {
            let is_along = |line: &&Vec<DVec2>| (line[0][of] - line[1][of]).abs() < 0.02;
            let mut found: Vec<f64> = lines.iter().filter(is_along).map(|l| l[0][of]).collect();
            found.sort_by(f64::total_cmp);
            found
        };
        // x = 4 and x = 6, y = 1 and y = −1: both pairs are 2 apart; those along z are not seen from their edge
        let (x, y) = (places(0), places(1));
        assert_eq!([x.len(), y.len(), lines.len()], [2, 2, 4]);
        let apart = x[1] - x[0];
        assert!(
            50.0 < apart && (y[1] - y[0] - apart).abs() < 0.03,
            "{x:?} {y:?}"
        );
        // the cube is drawn by itself: its corners are where the planes cross
        let spec = json!({"kind": "slabs", "pixel": [0, 0], "view": "front", "show": ["objects"]});
        let traced = by_hand::trace(DVec3::new(0.0, -4.6, 0.0), DVec3::new(0.8, 0.6, 0.0));
        let cube = ReadBack::of(spec, traced).paths("ink");
        let corner = DVec2::new(x[0], y[0]);
        let is_corner = |at: &DVec2| at.distance(corner) < 0.03;
        assert!(cube.iter().flatten().any(is_corner), "{corner}: {cube:?}");
    }

    #[test]
    fn the_table_has_d_of_every_slab() {
        let traced = by_hand::trace(DVec3::new(0.0, -4.6, 0.0), DVec3::new(0.8, 0.6, 0.0));
        let spec = json!({"kind": "slabs", "pixel": [0, 0], "view": "front", "show": ["numbers"]});
        let texts = ReadBack::of(spec, traced).texts();
        let row = |from: &str| {
            let at = texts.iter().position(|of| of == from).unwrap();
            texts[at..at + 3].join(" ")
        };
        assert_eq!(row("n0"), "n0 −6 −4");
        assert_eq!(row("n2 (z)"), "n2 (z) −1 1");
    }
}
