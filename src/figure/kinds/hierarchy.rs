//! The tree of a hierarchy and its nested volumes, for one ray (slides, "Traverse the Hierarchies").
//!
//! Both show the same nodes under the same numbers: which were entered, rejected, pruned because a nearer hit was
//! known, and which the ray never visited.

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::bound;
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::parts::tree::Tree;
use crate::figure::parts::visits::{Verdict, Visits, met};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure};
use crate::geometry::MOST_SLABS;
use crate::structure::Hierarchy;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 420.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Volumes,
        Layer::Numbers,
        Layer::Ray,
        Layer::Tree,
        Layer::Legend,
    ],
    more: &[],
};

/// Some 32 leaves stand side by side on a slide, with their numbers; a binary tree has as many nodes above them.
const MOST_NODES: usize = 63;

/// What is drawn.
struct Walk<'a> {
    ray: DrawnRay<'a>,
    hierarchy: Hierarchy<MOST_SLABS>,
    tree: Tree,
    visits: Visits,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let ray = figure.ray()?;
    let hierarchy = bound::hierarchy(figure.first)?;
    let visits = Visits::of(&ray.events, hierarchy.nodes().len());
    if visits.order.is_empty() {
        return Err(FigureError::new(
            "ray",
            "the ray visits no node",
            "name a ray that is tested against objects, in a scene with objects",
        ));
    }
    let nodes = hierarchy.nodes().len();
    if MOST_NODES < nodes {
        return Err(FigureError::new(
            "scene",
            format!("the tree has {nodes} nodes, more than a page has room for"),
            format!("draw a scene with fewer objects: a figure has room for {MOST_NODES} nodes"),
        ));
    }
    let walk = Walk {
        tree: Tree::of(&hierarchy),
        ray,
        hierarchy,
        visits,
    };
    let body = if figure.shows(Layer::Legend) {
        let there = Verdict::ALL
            .into_iter()
            .filter(|verdict| 0 < walk.visits.count(*verdict));
        let entries: Vec<(Look, &str)> = there
            .map(|verdict| (verdict.look(), verdict.name()))
            .collect();
        sheet.legend(body, &entries)
    } else {
        body
    };
    let volumes = figure.shows(Layer::Volumes) || figure.shows(Layer::Objects);
    match (volumes, figure.shows(Layer::Tree)) {
        (true, true) => {
            let [left, right] = body.split(0.5, 1.5 * sheet.letters);
            walk.volumes(figure, sheet, left);
            walk.tree(figure, sheet, right);
        }
        (true, false) => walk.volumes(figure, sheet, body),
        (false, _) => walk.tree(figure, sheet, body),
    }
    Ok(walk.in_words(figure))
}

impl Walk<'_> {
    /// The volumes of the nodes around the objects, and the ray.
    fn volumes(&self, figure: &Figure, sheet: &mut Sheet, frame: Frame) {
        let set = self.hierarchy.set();
        let nodes = self.hierarchy.nodes();
        let bounds: Vec<_> = nodes
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
        if figure.shows(Layer::Objects) {
            scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        }
        for (visit, slabs) in self.visits.nodes.iter().zip(&bounds) {
            if figure.shows(Layer::Volumes) {
                sheet.step(visit.step, |sheet| {
                    let around = bound::outline(slabs, &space.projection);
                    outline::draw(sheet, &space, &around, visit.verdict.look().outline());
                });
            }
        }
        if figure.shows(Layer::Ray) {
            self.ray(sheet, &space);
        }
        if figure.shows(Layer::Names) {
            scenery::names(figure, sheet, &space);
        }
        if figure.shows(Layer::Volumes) && figure.shows(Layer::Numbers) {
            for (number, slabs) in bounds.iter().enumerate() {
                // a leaf is known by its object
                if self.tree.nodes[number].objects.len() == 1 && figure.shows(Layer::Names) {
                    continue;
                }
                let rim = bound::outline(slabs, &space.projection).rim.points();
                let on_sheet = rim.into_iter().map(|point| space.place_flat(point));
                let Some(around) = Frame::around(on_sheet) else {
                    continue;
                };
                let corner = DVec2::new(around.max.x, around.min.y);
                if space.frame.contains(corner) {
                    sheet.step(self.visits.nodes[number].step, |sheet| {
                        sheet.label(
                            space.frame,
                            corner,
                            DVec2::new(1.0, -1.0),
                            number.to_string(),
                        );
                    });
                }
            }
        }
    }

    /// The ray as far as it goes.
    fn ray(&self, sheet: &mut Sheet, space: &crate::figure::view::Space) {
        let Some(start) = self.ray.node.start else {
            return;
        };
        let origin = space.place(start.ray.origin);
        let met = met(&self.ray);
        let end = met.map(|(_, t)| t).or_else(|| space.leaves(&start.ray));
        let Some(end) = end.map(|t| space.place(start.ray.at(t))) else {
            return;
        };
        if let Some([from, to]) = space.frame.cut_line([origin, end]) {
            sheet.arrow(Look::RAY, from, to);
            let along = to - from;
            sheet.label(space.frame, from + 0.1 * along, along.perp(), "ray r");
            if met.is_some() {
                let test = self.visits.tested.iter().rfind(|(_, _, is_hit)| *is_hit);
                sheet.step(test.map(|(_, step, _)| *step), |sheet| {
                    sheet.dot(Look::ANSWER, to);
                });
            }
        }
    }

    /// The tree of the nodes.
    fn tree(&self, figure: &Figure, sheet: &mut Sheet, frame: Frame) {
        /// Wider or higher apart a tree falls to pieces: in letters.
        const MOST: DVec2 = DVec2::new(7.0, 6.0);
        let below = DVec2::new(0.0, 1.5 * sheet.letters);
        let frame = Frame {
            min: frame.min,
            max: frame.max - below,
        };
        let spacing = self.tree.spacing(frame, MOST * sheet.letters);
        let radius = (0.95 * sheet.letters).min(0.45 * spacing.x);
        let at = |node: u32| self.tree.at(node as usize, frame, spacing);
        // all of it is there from the beginning, and what becomes of a node is drawn in place of that
        for (number, node) in (0..).zip(&self.tree.nodes) {
            let visit = self.visits.nodes[number as usize];
            let step = visit.step.filter(|_| visit.verdict != Verdict::Unreached);
            let looks = [
                Some((None, Look::CULLED)),
                step.map(|step| (Some(step), Look::PAPER_LINE)),
                step.map(|step| (Some(step), visit.verdict.look())),
            ];
            for (step, look) in looks.into_iter().flatten() {
                sheet.step(step, |sheet| {
                    if let Some(parent) = node.parent {
                        let along = (at(number) - at(parent)).normalize_or_zero() * radius;
                        let (from, to) = (at(parent) + along, at(number) - along);
                        sheet.line(look.outline(), from, to);
                    }
                    sheet.circle(look, at(number), radius);
                });
            }
            sheet.step(step, |sheet| {
                mark(
                    sheet,
                    visit.verdict,
                    node.parent.map(at),
                    at(number),
                    radius,
                );
            });
            if 0.75 * sheet.letters <= radius {
                sheet.text(Anchor::Middle, at(number), number.to_string());
            }
            self.objects(
                figure,
                sheet,
                number,
                at(number) + DVec2::new(0.0, radius),
                spacing.x,
            );
        }
    }

    /// The objects of a leaf below it, those that were tested in a frame.
    fn objects(&self, figure: &Figure, sheet: &mut Sheet, node: u32, below: DVec2, room: f64) {
        let objects = &self.tree.nodes[node as usize].objects;
        let names = objects.iter().map(|id| scenery::name_of(figure.scene, *id));
        let text = names.collect::<Vec<_>>().join(", ");
        let width = sheet.width_of(&text);
        if !figure.shows(Layer::Names) || text.is_empty() || room < width {
            return;
        }
        let middle = below + DVec2::new(0.0, 1.05 * sheet.letters);
        sheet.text(Anchor::Middle, middle, text);
        for (object, step, is_hit) in &self.visits.tested {
            if !objects.contains(object) {
                continue;
            }
            let half = DVec2::new(0.5 * width + 0.4 * sheet.letters, 0.75 * sheet.letters);
            let (min, max) = (middle - half, middle + half);
            let look = if *is_hit {
                Look::ANSWER
            } else {
                Look::REJECTED
            };
            sheet.step(*step, |sheet| {
                sheet.rectangle(look.outline(), Frame { min, max });
            });
        }
    }

    fn in_words(&self, figure: &Figure) -> String {
        let mut sentences = Vec::new();
        for &number in &self.visits.order {
            let node = &self.tree.nodes[number as usize];
            let what = match self.visits.nodes[number as usize].verdict {
                Verdict::Entered => "is entered",
                Verdict::Rejected => "is rejected",
                Verdict::Pruned => "is pruned, since it begins behind the nearest hit",
                Verdict::Waiting | Verdict::Unreached => continue,
            };
            let of: Vec<String> = node
                .objects
                .iter()
                .map(|id| scenery::name_of(figure.scene, *id))
                .collect();
            let of = if of.is_empty() {
                String::new()
            } else {
                format!(" with {}", of.join(", "))
            };
            sentences.push(format!("Node {number}{of} {what}."));
        }
        let unreached = self.visits.count(Verdict::Unreached);
        if 0 < unreached {
            sentences.push(format!(
                "{unreached} of {} nodes are never visited.",
                self.visits.nodes.len()
            ));
        }
        sentences.push(match met(&self.ray) {
            Some((object, _)) => {
                format!("The ray hits {}.", scenery::name_of(figure.scene, object))
            }
            None => "The ray hits no object.".into(),
        });
        sentences.join(" ")
    }
}

/// What a refused node has on the line to its parent: a cross, or two strokes where it was cut off.
fn mark(sheet: &mut Sheet, verdict: Verdict, parent: Option<DVec2>, at: DVec2, radius: f64) {
    let along = parent.map_or(DVec2::NEG_Y, |parent| (parent - at).normalize_or_zero());
    let look = verdict.look().outline();
    let middle = at + 2.0 * radius * along;
    match verdict {
        Verdict::Rejected => sheet.cross(look, middle),
        Verdict::Pruned => {
            let look = Look {
                dash: crate::figure::sheet::look::Dash::Solid,
                ..look
            };
            let across = 0.6 * radius * along.perp();
            for place in [-0.2, 0.2] {
                let middle = middle + place * radius * along;
                sheet.line(look, middle - across, middle + across);
            }
        }
        Verdict::Entered | Verdict::Waiting | Verdict::Unreached => {}
    }
}
