//! An object in slabs, in 2D (Fig. 15.58(a)): each a pair of parallel lines, and their intersection bounds it.

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::named_lines::{NamedLine, nearest_on, with_names};
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::scene::PrimitiveId;
use crate::trace::{BoundTest, Bounded, Event, RaySlab, Record, SlabTest};

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

/// The tests of one bound's slabs, as they are in the trace, and the step at which the bound was decided.
pub(super) struct SlabTests<'a> {
    pub(super) of: Bounded,
    /// Without the room for rounding with which they are decided.
    pub(super) tests: Vec<(u32, SlabTest)>,
    /// S and T of the ray and each slab.
    lines: Vec<&'a RaySlab>,
    pub(super) decided: Option<(u32, &'a BoundTest)>,
}

impl<'a> SlabTests<'a> {
    /// Those of the object that the specification names, or else of the first bound on the ray.
    ///
    /// # Errors
    /// The ray was tested against no such slabs.
    pub(super) fn find(figure: &Figure, events: &[&'a Record]) -> Result<Self, FigureError> {
        let wanted = figure.object()?.map(|id| {
            let object = figure.scene.primitive(id).object;
            Bounded::Object(object)
        });
        let found = events.iter().find_map(|record| match &record.event {
            Event::SlabTest(test) if wanted.is_none_or(|of| of == test.of) => Some(test.of),
            _ => None,
        });
        let of = found.ok_or_else(|| {
            FigureError::new(
                "structure",
                "no slab was tested on this ray",
                "add \"strategy\": \"bounds\" with \"structure\": { \"volume\": \"slabs\", \"slabs\": \"scene\" }",
            )
        })?;
        let mut tests: Vec<(u32, SlabTest)> = Vec::new();
        let mut lines: Vec<&RaySlab> = Vec::new();
        let mut decided = None;
        for record in events {
            match &record.event {
                Event::SlabRay(line) => lines.push(line),
                Event::SlabTest(test) if test.of == of => {
                    let line = lines.iter().find(|line| line.slab == test.step.slab);
                    let before = tests.last().map(|(_, test)| &test.step);
                    let bare = |line: &&RaySlab| test.step.without_room(&line.line(), before);
                    let step = line.map_or(test.step, bare);
                    tests.push((record.step, SlabTest { of, step }));
                }
                Event::BoundTest(test) if test.of == of => decided = Some((record.step, test)),
                _ => {}
            }
        }
        Ok(Self {
            of,
            tests,
            lines,
            decided,
        })
    }

    /// The slabs that were tested, each with its step.
    fn slabs(&self) -> impl Iterator<Item = (u32, Slab)> {
        self.tests.iter().filter_map(|(step, test)| {
            let mut lines = self.lines.iter();
            let line = lines.find(|line| line.slab == test.step.slab)?;
            Some((*step, Slab::of(test, line)))
        })
    }

    /// What is in the bound: an object's faces, or of a node of a hierarchy the whole scene.
    pub(super) fn objects(&self, figure: &Figure) -> Vec<PrimitiveId> {
        let ids = (0..figure.scene.primitives.len() as u32).map(PrimitiveId);
        let is_inside = |id: &PrimitiveId| match self.of {
            Bounded::Object(object) => figure.scene.primitive(*id).object == object,
            Bounded::Node(_) => true,
        };
        ids.filter(is_inside).collect()
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let found = SlabTests::find(figure, &ray.events)?;
    let all = bound::bound_of(figure.first, found.of)?;
    let projection = figure.projection();
    let slabs: Vec<(u32, Slab)> = found
        .slabs()
        .filter(|(_, slab)| slab.is_on_edge(&projection))
        .collect();
    if slabs.is_empty() {
        return Err(FigureError::new(
            "view",
            "no slab is perpendicular to this view",
            "choose the \"view\" front, and directions [A, B] in the scene's \"slabs\"",
        ));
    }

    let drawing = if figure.shows(Layer::Numbers) {
        /// Of the width at most.
        const SHARE: f64 = 0.66;
        let table = Table::new(sheet, &slabs);
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
    let margin = DVec2::new(4.9, 2.0) * sheet.letters;
    let room = Frame {
        min: space.frame.min + margin,
        max: space.frame.max - margin,
    };
    if figure.shows(Layer::Objects) {
        scenery::some_objects(figure, sheet, &space, &found.objects(figure), Look::OBJECT);
    }
    planes(figure, sheet, &space, room, &all, &slabs);
    if figure.shows(Layer::Volumes) {
        sheet.step(found.decided.map(|(step, _)| step), |sheet| {
            let around = bound::outline(&all, &space.projection);
            outline::rim(sheet, &space, &around.rim, Look::VISITED.wide(3.0));
        });
    }
    if figure.shows(Layer::Names) {
        let at = space.place(middle) - DVec2::new(sheet.letters, 0.0);
        sheet.label(space.frame, at, DVec2::X, bounded(figure, found.of));
    }
    Ok(in_words(figure, found.of, &slabs))
}

/// The two planes of each slab as lines with the names of their D, and its normal.
fn planes(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    room: Frame,
    all: &[Slab],
    slabs: &[(u32, Slab)],
) {
    let middle = bound::middle(all);
    let mut of = Vec::new();
    let mut lines = Vec::new();
    for (step, slab) in slabs {
        for (d, name) in [(slab.d_min, "D_min"), (slab.d_max, "D_max")] {
            if let Some(line) = slab.line(space, room, d, middle) {
                of.push((*step, *slab, name));
                lines.push(line);
            }
        }
    }
    let rim = bound::outline(all, &space.projection).rim.points();
    let rim: Vec<DVec2> = rim.iter().map(|at| space.place_flat(*at)).collect();
    let lines = with_names(&lines, &rim, sheet.letters);
    for ((step, slab, d), line) in of.iter().zip(&lines) {
        let [from, to] = line.ends;
        sheet.step(*step, |sheet| {
            if figure.shows(Layer::Slabs) {
                sheet.line(Look::VISITED.outline().wide(1.0), from, to);
                let text = format!("{} {d}", slab.name());
                sheet.label(space.frame, to, line.towards, text);
            }
        });
    }
    if !figure.shows(Layer::Normals) {
        return;
    }
    for (place, (step, slab, d)) in of.iter().enumerate() {
        if *d != "D_min" {
            continue;
        }
        let along = space.direction(slab.normal);
        let from = foot(&lines, place, along, sheet.letters);
        let to = from + ARROW * sheet.letters * along;
        sheet.step(*step, |sheet| {
            sheet.arrow(Look::RAY.wide(1.5), from, to);
            sheet.label(space.frame, to, along, slab.name());
        });
    }
}

/// Length of a normal's arrow in sizes of letters.
const ARROW: f64 = 2.4;

/// Where on its line a normal has most room: from other lines, and from their names.
fn foot(lines: &[NamedLine], place: usize, along: DVec2, letters: f64) -> DVec2 {
    /// Places that are tried, from the end without a name.
    const PLACES: [f64; 12] = [
        0.06, 0.14, 0.22, 0.3, 0.38, 0.46, 0.54, 0.62, 0.7, 0.78, 0.86, 0.94,
    ];
    /// What is so far away in sizes of letters does not disturb.
    const ENOUGH: f64 = 2.5;
    let [start, end] = lines[place].ends;
    let room = |from: DVec2| {
        let name = from + (ARROW + 1.2) * letters * along;
        let others = lines.iter().enumerate().filter(|(i, _)| *i != place);
        let to_lines = others.map(|(_, line)| {
            let [a, b] = line.ends;
            let points = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| from.lerp(name, share));
            let far = points.into_iter();
            let far = far.map(|at| at.distance(nearest_on(a, b, at)));
            far.fold(f64::INFINITY, f64::min)
        });
        // a name as "n₀ D_min" is five letters wide and reaches half of it from its middle
        let to_names = lines.iter().map(|line| {
            let at = nearest_on(from, name, line.name);
            at.distance(line.name) - 2.5 * letters
        });
        to_lines.chain(to_names).fold(ENOUGH * letters, f64::min)
    };
    let feet = PLACES.map(|share| start.lerp(end, share));
    // the first of those that are equal
    let best = feet.into_iter().rev();
    let best = best.max_by(|a, b| room(*a).total_cmp(&room(*b)));
    best.unwrap_or(start)
}

/// What describes the bound: D_min and D_max of each slab.
struct Table {
    rows: Vec<(u32, [String; 3])>,
    /// How wide each column is, and the gap between them.
    columns: [f64; 3],
    gap: f64,
}

impl Table {
    const HEAD: [&str; 3] = ["n", "D_min", "D_max"];

    /// As wide as the texts.
    fn new(sheet: &Sheet, slabs: &[(u32, Slab)]) -> Self {
        let rows = slabs.iter().map(|(step, slab)| {
            let texts = [slab.name(), quantity(slab.d_min), quantity(slab.d_max)];
            (*step, texts)
        });
        let rows: Vec<(u32, [String; 3])> = rows.collect();
        let widest = |column: usize| {
            let widths = rows.iter().map(|(_, row)| sheet.width_of(&row[column]));
            widths.fold(sheet.width_of(Self::HEAD[column]), f64::max)
        };
        Self {
            columns: std::array::from_fn(widest),
            gap: 1.5 * sheet.letters,
            rows,
        }
    }

    /// The least width.
    fn width(&self) -> f64 {
        self.columns.iter().sum::<f64>() + 2.0 * self.gap
    }

    /// In a frame; what it has too much is between the columns.
    fn draw(&self, sheet: &mut Sheet, frame: Frame) {
        let more = 0.5 * (frame.size().x - self.width()).max(0.0);
        let gap = self.gap + more;
        let end = |column: usize| {
            let columns: f64 = self.columns[..=column].iter().sum();
            frame.min.x + columns + column as f64 * gap
        };
        let line = 1.25 * sheet.line_height();
        let rows = self.rows.len() as f64 + 1.0;
        let top = frame.middle().y - 0.5 * rows * line;
        let row = |place: f64| top + (place + 0.5) * line;
        for (column, text) in Self::HEAD.into_iter().enumerate() {
            sheet.text(Anchor::End, DVec2::new(end(column), row(0.0)), text);
        }
        let under = top + line;
        let ends = [frame.min.x, end(2)].map(|x| DVec2::new(x, under));
        sheet.line(Look::THIN, ends[0], ends[1]);
        for (place, (step, texts)) in self.rows.iter().enumerate() {
            sheet.step(*step, |sheet| {
                for (column, text) in texts.iter().enumerate() {
                    let at = DVec2::new(end(column), row(place as f64 + 1.0));
                    sheet.text(Anchor::End, at, text);
                }
            });
        }
    }
}

/// What a bound is around.
pub(super) fn bounded(figure: &Figure, of: Bounded) -> String {
    match of {
        Bounded::Object(object) => {
            let object = figure.scene.objects.get(object as usize);
            object.map_or(String::new(), |object| scenery::short(&object.name))
        }
        Bounded::Node(node) => format!("node {node}"),
    }
}

fn in_words(figure: &Figure, of: Bounded, slabs: &[(u32, Slab)]) -> String {
    let mut sentences = vec![format!(
        "The bound of {}: the intersection of its slabs, of which {} are perpendicular to the view.",
        bounded(figure, of),
        slabs.len()
    )];
    for (_, slab) in slabs {
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
