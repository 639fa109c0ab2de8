//! The nested volumes around the objects, and the ray.

use glam::DVec2;

use crate::figure::kinds::hierarchy::argument::Argument;
use crate::figure::kinds::hierarchy::walk::Walk;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::outline::{self, Outline, Rim};
use crate::figure::parts::scenery;
use crate::figure::parts::visits::{Turn, Verdict, met};
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;

/// A volume is drawn so much wider than those one level below it, in units of a book's sheet: edges that lie on each other
/// are told apart.
const LEVEL: f64 = 2.5;

/// Up to this number of objects, a slide shows their names too.
const FEW: usize = 8;

impl Walk<'_> {
    /// The volumes of the nodes around the objects, and the ray.
    pub(super) fn volumes(
        &self,
        figure: &Figure,
        sheet: &mut Sheet,
        frame: Frame,
        argument: &Argument,
    ) {
        let set = self.hierarchy.set();
        let nodes = self.hierarchy.nodes();
        let bounds: Vec<Vec<Slab>> = nodes
            .iter()
            .map(|node| bound::slabs(set, &node.bound))
            .collect();
        let origin = self.ray.node.start.map(|start| start.ray.origin);
        let root = bounds
            .first()
            .map_or(Vec::new(), |root| bound::corners(root));
        let shown = root
            .into_iter()
            .chain(origin.filter(|_| figure.shows(Layer::Ray)));
        let space = figure.space(frame, shown);
        let outlines = self.outlines(sheet, &space, &bounds);
        if figure.shows(Layer::Objects) {
            scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        }
        if figure.shows(Layer::Volumes) {
            for number in self.tree.shown() {
                self.volume(sheet, &space, number, &outlines[number]);
            }
            if figure.shows(Layer::Numbers) {
                self.numbers(figure, sheet, &space, &outlines);
            }
        }
        if figure.shows(Layer::Ray) {
            self.ray(figure, sheet, &space, argument);
        }
        if figure.shows(Layer::Names) {
            // the letters of a slide leave no room for all names, which the tree has as well
            let names_all = sheet.width == Width::Book
                || !figure.shows(Layer::Tree)
                || figure.scene.objects.len() <= FEW;
            let hit = met(&self.ray).map(|(object, _)| figure.scene.object_of(object).first);
            scenery::names_of(figure, sheet, &space, |object| {
                names_all || hit == Some(object.first)
            });
        }
    }

    /// The outlines of all volumes, each a little outside of those in it.
    fn outlines(&self, sheet: &Sheet, space: &Space, bounds: &[Vec<Slab>]) -> Vec<Outline> {
        let levels = self.tree.nodes.iter().map(|node| node.place.y);
        let deepest = levels.fold(0.0, f64::max);
        let nodes = self.tree.nodes.iter().zip(bounds);
        let outlines = nodes.map(|(node, slabs)| {
            let by = LEVEL * sheet.unit() * (deepest - node.place.y) / space.scale;
            wider(bound::outline(slabs, &space.projection), by)
        });
        outlines.collect()
    }

    /// A volume: first as not visited, then what becomes of it.
    fn volume(&self, sheet: &mut Sheet, space: &Space, number: usize, around: &Outline) {
        let visit = self.visits.nodes[number];
        let over = |sheet: &mut Sheet, look: Look| {
            outline::rim(sheet, space, &around.rim, Look::PAPER_LINE.wide(2.0));
            outline::draw(sheet, space, around, look.outline());
        };
        outline::draw(sheet, space, around, Look::CULLED.wide(1.0));
        if let Some((step, _)) = visit.hit {
            sheet.event(step, |sheet| over(sheet, Verdict::Waiting.look()));
        }
        if let (Some(step), Verdict::Entered | Verdict::Rejected | Verdict::Pruned) =
            (visit.step, visit.verdict)
        {
            sheet.event(step, |sheet| over(sheet, visit.verdict.look()));
        }
    }

    /// The numbers of the nodes that have nodes below them, each where nothing else is in its volume.
    fn numbers(&self, figure: &Figure, sheet: &mut Sheet, space: &Space, outlines: &[Outline]) {
        let frame_of = |around: &Outline| {
            let points = around.rim.points().into_iter();
            Frame::around(points.map(|point| space.place_flat(point)))
        };
        let shown = self.tree.shown();
        let frames = shown
            .into_iter()
            .map(|number| (number, frame_of(&outlines[number])));
        let frames: Vec<(usize, Frame)> = frames
            .filter_map(|(number, frame)| Some((number, frame?)))
            .collect();
        let ray = self.ray.node.start.and_then(|start| {
            let end = space.leaves(&start.ray)?;
            Some([start.ray.origin, start.ray.at(end)].map(|at| space.place(at)))
        });
        let mut taken: Vec<Frame> = Vec::new();
        if figure.shows(Layer::Objects) {
            let rims = figure.near.iter().map(|id| {
                let shape = &figure.scene.primitive(*id).shape;
                let rim = Outline::of(shape, &space.projection).rim;
                let points = rim.points().into_iter();
                Frame::around(points.map(|point| space.place_flat(point)))
            });
            taken.extend(rims.flatten());
        }
        for &(number, frame) in &frames {
            let node = &self.tree.nodes[number];
            // a leaf is known by its object
            if node.objects.len() == 1 && figure.shows(Layer::Names) {
                continue;
            }
            let text = number.to_string();
            let half = 0.5 * DVec2::new(sheet.width_of(&text), sheet.letters) + 1.5 * sheet.unit();
            let is_free = |place: &Frame, is_alone: bool| {
                let of_others = frames.iter().filter(|(other, _)| *other != number);
                let disturbs = |&(other, around): &(usize, Frame)| {
                    let is_apart = around.shared_area(*place) == 0.0;
                    // in the volumes of the nodes above it stands always; on their lines never
                    let is_in = around.holds(*place) && !self.is_above(number, other);
                    !is_apart && !(is_in && (!is_alone || self.is_above(other, number)))
                };
                let on_ray = ray.is_some_and(|ends| place.cut_line(ends).is_some());
                let mut others = taken.iter();
                !on_ray
                    && !of_others.into_iter().any(disturbs)
                    && others.all(|other| other.shared_area(*place) == 0.0)
            };
            let seen = Frame {
                min: frame.min.max(space.frame.min),
                max: frame.max.min(space.frame.max),
            };
            let places = places_in(seen.wider(-1.5 * sheet.unit()), half);
            let first = |is_alone| places.iter().find(|place| is_free(place, is_alone));
            if let Some(place) = first(true).or_else(|| first(false)).copied() {
                taken.push(place);
                sheet.text(Anchor::Middle, place.middle(), text);
            }
        }
    }

    /// Is a node above another one?
    fn is_above(&self, node: usize, other: usize) -> bool {
        let mut at = self.tree.nodes[other].parent;
        while let Some(parent) = at {
            if parent as usize == node {
                return true;
            }
            at = self.tree.nodes[parent as usize].parent;
        }
        false
    }

    /// The line of the ray, where it hits objects, and how far it goes in the end.
    fn ray(&self, figure: &Figure, sheet: &mut Sheet, space: &Space, argument: &Argument) {
        let Some(start) = self.ray.node.start else {
            return;
        };
        let ray = &start.ray;
        let place = |t: f64| space.place(ray.at(t));
        let Some(edge) = space.leaves(ray).map(place) else {
            return;
        };
        let Some([from, to]) = space.frame.cut_line([place(0.0), edge]) else {
            return;
        };
        let along = to - from;
        let root = self.visits.nodes.first().and_then(|root| root.hit);
        let first = self.visits.order.iter().find_map(|(node, _)| {
            let (_, near) = self.visits.nodes[*node as usize].hit?;
            Some(near)
        });
        let begins = root.map(|(_, near)| near).or(first).map_or(to, place);
        let aside = if 0.0 < along.perp().x {
            along.perp()
        } else {
            -along.perp()
        };
        sheet.at(argument.ray, |sheet| {
            sheet.line(Look::LINE_OF_RAY, from, to);
            let until = from.lerp(begins, 0.85);
            sheet.arrow(Look::RAY.in_front(), from, until);
            sheet.label(space.frame, from.lerp(begins, 0.4), aside, formula("r"));
        });
        // on a slide they stand beside the nodes of the tree alone
        let numbers = figure.shows(Layer::Numbers) && sheet.width == Width::Book;
        sheet.within(space.frame, |sheet| {
            for test in self.visits.tested() {
                let Some(t) = test.t else { continue };
                sheet.event(test.step, |sheet| {
                    sheet.dot(Look::MET, place(t));
                    if numbers {
                        let text = formula("t = ") + brief(t);
                        sheet.label(space.frame, place(t), aside, text);
                    }
                });
            }
            let pruned = |turn: &&Turn| !turn.is_entered;
            for turn in self.visits.turns.iter().filter(pruned) {
                let visit = self.visits.nodes[turn.node as usize];
                let (Some((_, near)), Some(step)) = (visit.hit, visit.step) else {
                    continue;
                };
                sheet.event(step, |sheet| {
                    sheet.ring(Verdict::Pruned.look(), place(near));
                    if numbers {
                        let text = formula("t = ") + brief(near);
                        sheet.label(space.frame, place(near), aside, text);
                    }
                });
            }
            sheet.at(argument.end, |sheet| {
                let end = met(&self.ray).map_or(to, |(_, t)| place(t));
                sheet.arrow(Look::RAY.in_front(), from, end);
                if met(&self.ray).is_some() {
                    sheet.dot(Look::ANSWER, end);
                }
            });
        });
    }
}

/// An outline whose points lie further from its middle, by so much along both axes.
fn wider(outline: Outline, by: f64) -> Outline {
    let points = outline.rim.points();
    let Some(around) = Frame::around(points.iter().copied()) else {
        return outline;
    };
    let middle = around.middle();
    let half = (0.5 * around.size()).max(DVec2::splat(f64::MIN_POSITIVE));
    let scale = (half + by) / half;
    let moved = |points: Vec<DVec2>| -> Vec<DVec2> {
        let moved = points.into_iter().map(|p| middle + scale * (p - middle));
        moved.collect()
    };
    let lines = |lines: Vec<Vec<DVec2>>| lines.into_iter().map(moved).collect();
    Outline {
        rim: Rim::Points(moved(points)),
        edges: lines(outline.edges),
        hidden: lines(outline.hidden),
    }
}

/// Places of that half size in an area, from the upper right on: first those beside its edges, then those inside.
fn places_in(area: Frame, half: DVec2) -> Vec<Frame> {
    /// Places beside each other.
    const PLACES: u32 = 13;
    let last = PLACES - 1;
    let room = area.size() - 2.0 * half;
    if room.min_element() < 0.0 {
        return Vec::new();
    }
    let mut found = Vec::new();
    for row in 0..PLACES {
        for column in 0..PLACES {
            let share = DVec2::new(f64::from(last - column), f64::from(row)) / f64::from(last);
            let middle = area.min + half + share * room;
            let from_edge = [row, last - row, column, last - column];
            let depth = from_edge.into_iter().min().unwrap_or(0);
            let (min, max) = (middle - half, middle + half);
            found.push((depth, row + column, Frame { min, max }));
        }
    }
    found.sort_by_key(|(depth, place, _)| (*depth, *place));
    found.into_iter().map(|(_, _, frame)| frame).collect()
}
