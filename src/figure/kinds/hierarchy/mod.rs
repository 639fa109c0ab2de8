//! The tree of a hierarchy and its nested volumes, for one ray (slides, "Traverse the Hierarchies").
//!
//! Both show the same nodes under the same numbers: which were entered, rejected, pruned because a nearer hit was
//! known, and which the ray never visited.

mod argument;
mod nodes;
mod volumes;
mod walk;

use std::collections::HashSet;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::hierarchy::argument::Argument;
use crate::figure::kinds::hierarchy::walk::Walk;
use crate::figure::parts::bound;
use crate::figure::parts::scenery;
use crate::figure::parts::tree::Tree;
use crate::figure::parts::visits::{Verdict, Visits, met};
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;

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
    // of a large tree what the ray visits, from the first on
    let is_large = MOST_NODES < hierarchy.nodes().len();
    let visited = visits.order.iter().map(|(node, _)| *node);
    let visited: HashSet<u32> = visited.take(MOST_NODES).collect();
    let walk = Walk {
        tree: Tree::part_of(&hierarchy, |node| !is_large || visited.contains(&node)),
        ray,
        hierarchy,
        visits,
    };
    let argument = Argument::new(figure, sheet, &walk)?;
    let body = if figure.shows(Layer::Legend) {
        argument.legend(sheet, body, &walk)
    } else {
        body
    };
    let volumes = figure.shows(Layer::Volumes) || figure.shows(Layer::Objects);
    match (volumes, figure.shows(Layer::Tree)) {
        (true, true) => {
            // the numbers of a slide's tree are large, its boxes are not
            let share = match sheet.width {
                Width::Book => 0.5,
                Width::Slide => 0.4,
            };
            let [left, right] = body.split(share, 1.5 * sheet.letters);
            walk.volumes(figure, sheet, left, &argument);
            walk.tree(figure, sheet, right, &argument);
        }
        (true, false) => walk.volumes(figure, sheet, body, &argument),
        (false, _) => walk.tree(figure, sheet, body, &argument),
    }
    Ok(walk.in_words(figure))
}

impl Walk<'_> {
    fn in_words(&self, figure: &Figure) -> String {
        let name = |id| scenery::name_of(figure.scene, id);
        let mut sentences = Vec::new();
        for &(number, _) in &self.visits.order {
            let node = &self.tree.nodes[number as usize];
            let visit = self.visits.nodes[number as usize];
            let near = visit.hit.map_or(String::new(), |(_, near)| brief(near));
            let what = match visit.verdict {
                Verdict::Entered => "is entered".into(),
                Verdict::Rejected => "is rejected".into(),
                Verdict::Pruned => {
                    format!("is pruned, since it begins at t = {near}, behind the nearest hit")
                }
                Verdict::Waiting | Verdict::Unreached => continue,
            };
            let of: Vec<String> = node.objects.iter().map(|id| name(*id)).collect();
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
            Some((object, t)) => format!("The ray hits {} at t = {}.", name(object), brief(t)),
            None => "The ray hits no object.".into(),
        });
        sentences.join(" ")
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, ball};

    #[test]
    fn the_hit_and_where_a_node_begins_lie_on_the_ray() {
        let objects = json!([
            ball("A", [0.0; 3], 1.0),
            ball("B", [6.0, 0.0, 0.0], 1.5),
            ball("C", [6.0, 0.0, 5.0], 1.0)
        ]);
        let spec = json!({ "kind": "hierarchy", "strategy": "hierarchy", "view": "top" });
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, spec);
        // A is hit at t = 9, at the left end of its outline; B begins at x = 4.5, one and a half scene units before its middle
        let outlines = drawn.circles("ink");
        let radii = outlines.iter().map(|(_, radius)| *radius);
        let largest = radii.fold(0.0, f64::max);
        let of_radius = |share: f64| {
            let is_it = |(_, radius): &&(DVec2, f64)| (radius / largest - share).abs() < 0.01;
            let mut found: Vec<DVec2> = outlines.iter().filter(is_it).map(|(at, _)| *at).collect();
            found.sort_by(|a, b| a.x.total_cmp(&b.x));
            found
        };
        let (a, b) = (of_radius(1.0 / 1.5)[0], of_radius(1.0)[0]);
        let unit = (b.x - a.x) / 6.0;
        let hit = DVec2::new(a.x - unit, a.y);
        let answers = drawn.dots("answer");
        assert!(
            answers.iter().any(|at| at.distance(hit) < DRAWN),
            "{answers:?}, not {hit}"
        );
        let begins = DVec2::new(a.x + 4.5 * unit, a.y);
        let rings = drawn.dots("rejected");
        assert!(
            rings.iter().any(|at| at.distance(begins) < DRAWN),
            "{rings:?}, not {begins}"
        );
        let texts = drawn.texts();
        for text in ["t = 9", "t = 14.5"] {
            assert!(texts.iter().any(|of| of == text), "no {text}: {texts:?}");
        }
    }
}
