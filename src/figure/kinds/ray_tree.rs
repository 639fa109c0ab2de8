//! The rays of a pixel beside their tree: each ray has its number in the scene and in the tree, each edge of the tree the
//! weight with which the colour below it counts (T. Whitted 1980).
//!
//! I = ambient + Σ visible lights + reflection·I_reflected + transmission·I_refracted.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{brief, coordinates};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::trace::{Event, Item, Purpose, RayNode, RayTree, RayVerdict, Record, Shade};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 430.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Eye,
        Layer::Window,
        Layer::Lights,
    ],
    more: &[],
};

/// More would not be legible.
const MOST: usize = 12;

/// A node of the drawn tree.
struct Node<'a> {
    ray: &'a RayNode,
    purpose: Purpose,
    verdict: RayVerdict,
    /// The shade where it hits something.
    shade: Option<Shade>,
    /// With what its colour counts in that of the ray above it; none for an eye ray and a shadow ray.
    weight: Option<f64>,
    /// Its place in the row of the leaves, and its depth.
    across: f64,
    depth: usize,
    /// The step at which it is known where it ends: that of the nearest hit, before the rays that it spawns.
    known: u32,
}

impl Node<'_> {
    fn what(&self) -> &'static str {
        match self.purpose {
            Purpose::Eye => "eye",
            Purpose::Shadow => "shadow",
            Purpose::Reflected => "reflected",
            Purpose::Refracted => "refracted",
            Purpose::Scattered => "scattered",
            Purpose::Light => "light",
            Purpose::Connection => "connection",
        }
    }

    fn look(&self) -> Look {
        match self.purpose {
            Purpose::Shadow => Look::SHADOW_RAY,
            Purpose::Reflected | Purpose::Scattered => Look::REFLECTED_RAY,
            Purpose::Refracted => Look::REFRACTED_RAY,
            _ => Look::RAY,
        }
    }

    /// What it comes to.
    fn end(&self, figure: &Figure) -> String {
        let object = self.ray.end.and_then(|end| end.object);
        let name = object.map_or_else(String::new, |id| scenery::name_of(figure.scene, id));
        match self.verdict {
            RayVerdict::Hit => format!("hits {name}"),
            RayVerdict::Miss => "misses".into(),
            RayVerdict::Blocked => "blocked".into(),
            RayVerdict::ReachesLight => "lit".into(),
            RayVerdict::DepthLimit => "limit: 0".into(),
            RayVerdict::Absorbed | RayVerdict::CutOff => "ends".into(),
            RayVerdict::Connects => "connects".into(),
        }
    }

    fn sentence(&self, figure: &Figure) -> String {
        let id = self.ray.id;
        let end = self.end(figure);
        let blocked_by = self.ray.end.and_then(|end| end.object);
        let end = match (self.verdict, blocked_by) {
            (RayVerdict::Blocked, Some(by)) => {
                format!("is blocked by {}", scenery::name_of(figure.scene, by))
            }
            (RayVerdict::ReachesLight, _) => "reaches the light".into(),
            (RayVerdict::DepthLimit, _) => "is beyond the depth limit and counts as 0".into(),
            _ => end,
        };
        let counts = match self.weight {
            Some(weight) => format!(", and its colour counts with {}", brief(weight)),
            None => String::new(),
        };
        format!("Ray {id}, {}: it {end}{counts}.", named(self.purpose))
    }
}

fn named(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Eye => "an eye ray",
        Purpose::Shadow => "a shadow ray",
        Purpose::Reflected => "a reflected ray",
        Purpose::Refracted => "a refracted ray",
        Purpose::Scattered => "a scattered ray",
        Purpose::Light => "a path of light",
        Purpose::Connection => "a connecting line",
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let records = figure.records()?;
    let tree = RayTree::new(records);
    let nodes = nodes(records, &tree);
    if nodes.is_empty() || MOST < nodes.len() {
        return Err(FigureError::new(
            "pixel",
            format!(
                "the tree of this pixel has {} rays, and 1 to {MOST} can be drawn",
                nodes.len()
            ),
            "name another pixel, or lower the scene's \"max_depth\"",
        ));
    }
    let stages: BTreeMap<u32, StageId> = in_order(&nodes)
        .into_iter()
        .map(|(node, step)| {
            let name = node.what();
            (node.ray.id, sheet.stage(name, step, node.sentence(figure)))
        })
        .collect();
    let sum = sum_of(&nodes, records, sheet.width);
    let colour = records.iter().find_map(|record| match record.event {
        Event::PixelColour(_) => Some(record.step),
        _ => None,
    });
    let mut body = body;
    let last = sum
        .as_ref()
        .map(|(_, said)| sheet.stage("sum", colour, said.clone()));
    if let (Some((lines, _)), Some(last)) = (&sum, last) {
        let room = body.size().x / sheet.letters;
        let count: usize = lines.iter().map(|line| line.wrapped(room).len()).sum();
        let [above, below] =
            body.split_top(body.size().y - (count as f64 + 0.4) * sheet.line_height());
        sheet.at(last, |sheet| sheet.lines(below, lines));
        body = above;
    }
    let share = match sheet.width {
        Width::Book => 0.5,
        Width::Slide => 0.42,
    };
    let [left, right] = body.split(share, sheet.letters);
    let mut points = scenery::points_of(figure);
    points.extend(nodes.iter().filter_map(|of| Some(ends(of.ray)?[1])));
    let space = figure.space(left, points);
    in_scene(figure, sheet, &space, &nodes, &stages);
    as_tree(figure, sheet, right, &nodes, &stages);
    let mut told: Vec<String> = nodes.iter().map(|node| node.sentence(figure)).collect();
    told.extend(sum.map(|(_, said)| said));
    Ok(told.join(" "))
}

/// The nodes with the steps at which their stages end, which do not fall: each comes when it is known where its ray ends.
fn in_order<'a, 'b>(nodes: &'b [Node<'a>]) -> Vec<(&'b Node<'a>, u32)> {
    let mut last = 0;
    let step = |node: &'b Node<'a>| {
        last = node.known.max(last);
        (node, last)
    };
    nodes.iter().map(step).collect()
}

/// The rays that have a start and an end, in their order, with their places in the tree.
fn nodes<'a>(records: &[Record], tree: &'a RayTree) -> Vec<Node<'a>> {
    let mut leaves = 0.0;
    let mut nodes: Vec<Node<'a>> = Vec::new();
    for node in &tree.rays {
        let (Some(start), Some(end)) = (node.start, node.end) else {
            continue;
        };
        let shade = shade_of(records, node);
        let above = nodes.iter().find(|of| Some(of.ray.id) == node.parent);
        let weight = above.and_then(|above| {
            let shade = above.shade?;
            match start.purpose {
                Purpose::Reflected => Some(shade.reflection),
                Purpose::Refracted => Some(shade.transmission),
                _ => None,
            }
        });
        let depth = above.map_or(0, |above| above.depth + 1);
        let hit = node.items.iter().rev().find_map(|item| match item {
            Item::Event(at) => {
                let record = &records[*at];
                matches!(record.event, Event::Nearest(_)).then_some(record.step)
            }
            Item::Ray(_) => None,
        });
        let ends = node.ends_at[1].map_or(0, |at| records[at].step);
        let known = match end.verdict {
            RayVerdict::Hit => hit.unwrap_or(ends),
            _ => ends,
        };
        nodes.push(Node {
            ray: node,
            purpose: start.purpose,
            verdict: end.verdict,
            shade,
            weight,
            across: 0.0,
            depth,
            known,
        });
    }
    // the leaves beside each other, each other node over the middle of those below it
    let parents: Vec<Option<u32>> = nodes.iter().map(|of| of.ray.parent).collect();
    for place in (0..nodes.len()).rev() {
        let id = nodes[place].ray.id;
        let below: Vec<f64> = (0..nodes.len())
            .filter(|of| parents[*of] == Some(id))
            .map(|of| nodes[of].across)
            .collect();
        nodes[place].across = if below.is_empty() {
            leaves -= 1.0;
            leaves
        } else {
            let [low, high] = [f64::min, f64::max]
                .map(|of: fn(f64, f64) -> f64| below.iter().copied().reduce(of).unwrap_or(0.0));
            f64::midpoint(low, high)
        };
    }
    nodes
}

fn shade_of(records: &[Record], node: &RayNode) -> Option<Shade> {
    node.items.iter().find_map(|item| match item {
        Item::Event(at) => match records[*at].event {
            Event::Shade(shade) => Some(shade),
            _ => None,
        },
        Item::Ray(_) => None,
    })
}

/// Where a ray starts and ends: at its hit, at the light, or nowhere.
fn ends(node: &RayNode) -> Option<[DVec3; 2]> {
    let (start, end) = (node.start?, node.end?);
    let t = match (end.t, end.verdict) {
        (Some(t), _) => t,
        (None, RayVerdict::ReachesLight) => start.range.max,
        _ => return None,
    };
    Some([start.ray.origin, start.ray.at(t)])
}

/// The rays in the scene, each with its number.
fn in_scene(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    nodes: &[Node],
    stages: &BTreeMap<u32, StageId>,
) {
    scenery::objects(figure, sheet, space, |_| Look::OBJECT);
    scenery::names(figure, sheet, space);
    scenery::camera_and_lights(figure, sheet, space);
    for of in nodes
        .iter()
        .filter(|of| of.verdict != RayVerdict::DepthLimit)
    {
        let Some(start) = of.ray.start else { continue };
        let from = space.place(start.ray.origin);
        let (to, is_open) = match ends(of.ray) {
            Some([_, to]) => (space.place(to), false),
            None => {
                let edge = space.leaves(&start.ray).unwrap_or(0.0);
                (space.place(start.ray.at(edge)), true)
            }
        };
        let half = from.lerp(to, 0.55);
        let across = (to - from).perp().normalize_or_zero();
        sheet.at(stages[&of.ray.id], |sheet| {
            sheet.arrow(of.look(), from, half);
            if is_open {
                sheet.arrow(of.look(), half, to);
            } else {
                sheet.line(of.look(), half, to);
            }
            match of.verdict {
                RayVerdict::Blocked => sheet.cross(Look::REJECTED, to),
                RayVerdict::Hit => sheet.dot(Look::RAY, to),
                _ => {}
            }
            let text = of.ray.id.to_string();
            sheet.label(space.frame, from.lerp(to, 0.4), across, text);
        });
    }
}

/// The tree: the eye ray at the top, what each ray spawns below it, the weights at the edges.
fn as_tree(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    nodes: &[Node],
    stages: &BTreeMap<u32, StageId>,
) {
    let line = sheet.line_height();
    let [low, high] = [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| {
        nodes
            .iter()
            .map(|node| node.across)
            .reduce(of)
            .unwrap_or(0.0)
    });
    let depth = nodes.iter().map(|node| node.depth).max().unwrap_or(0);
    // a node has two lines
    let high_of_node = 2.0 * line;
    let between = (frame.size().y - high_of_node) / depth.max(1) as f64;
    let between = between.min(2.4 * high_of_node);
    let slot = frame.size().x / (high - low + 1.0);
    let at = |node: &Node| {
        DVec2::new(
            frame.min.x + slot * (node.across - low + 0.5),
            frame.min.y + 0.5 * high_of_node + between * node.depth as f64,
        )
    };
    for node in nodes {
        let stage = stages[&node.ray.id];
        let place = at(node);
        let above = nodes.iter().find(|of| Some(of.ray.id) == node.ray.parent);
        sheet.at(stage, |sheet| {
            if let Some(above) = above {
                let edge = DVec2::new(0.0, 0.5 * high_of_node);
                let (from, to) = (at(above) + edge, place - edge);
                sheet.line(node.look(), from, to);
                if let Some(weight) = node.weight {
                    let text = format!("× {}", brief(weight));
                    let aside = DVec2::new((to.x - from.x).signum(), 0.0);
                    let aside = if aside.x == 0.0 { DVec2::X } else { aside };
                    sheet.label(frame, from.lerp(to, 0.5), aside, text);
                }
            }
            let first = format!("{} {}", node.ray.id, node.what());
            let half = DVec2::new(0.0, 0.5 * line);
            sheet.text(Anchor::Middle, place - half, first);
            sheet.text(Anchor::Middle, place + half, node.end(figure));
        });
    }
}

/// The sum at the eye ray's hit, in letters and in numbers, and as a sentence.
fn sum_of(nodes: &[Node], records: &[Record], width: Width) -> Option<(Vec<Text>, String)> {
    let eye = nodes.iter().find(|node| node.depth == 0)?;
    let shade = eye.shade?;
    let own = shade.ambient + shade.direct;
    let mut letters = formula("I_0") + " = own";
    let mut numbers = Text::from("= ") + coordinates(own);
    for node in nodes {
        let (Some(weight), true) = (node.weight, node.ray.parent == Some(eye.ray.id)) else {
            continue;
        };
        let colour = node
            .ray
            .end
            .and_then(|end| end.colour)
            .unwrap_or(DVec3::ZERO);
        letters =
            letters + format!(" + {}·", brief(weight)) + formula(&format!("I_{}", node.ray.id));
        numbers = numbers + format!(" + {}·", brief(weight)) + coordinates(colour);
    }
    let whole = records.iter().find_map(|record| match record.event {
        Event::PixelColour(colour) => Some(colour.raw),
        _ => None,
    })?;
    let value = coordinates(whole);
    let said = format!(
        "The pixel has the sum {value}: what the surface shows itself, and each spawned colour with its weight."
    );
    let lines = match width {
        Width::Book => vec![letters, numbers, Text::from("= ") + value],
        // the tree needs the room
        Width::Slide => vec![letters + " = " + value],
    };
    Some((lines, said))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::ReadBack;
    use crate::trace::Event;

    #[test]
    fn the_numbers_of_the_sum_are_those_of_the_pixel() {
        // a mirror across the ray: the eye ray comes back and misses
        let objects = json!([{ "name": "A", "material": "m",
            "shape": { "polygon": { "vertices": [[0, -1, -1], [0, -1, 1], [0, 1, 1], [0, 1, -1]] } } }]);
        let (drawn, traced) = ReadBack::of_ray_along_x(
            &objects,
            json!({"kind": "ray-tree", "transport": "hybrid-light", "view": "front"}),
        );
        let texts = drawn.texts();
        assert!(
            texts.contains(&"0 eye".into()) && texts.contains(&"hits A".into()),
            "{texts:?}"
        );
        assert!(
            texts.iter().any(|text| text.starts_with("I0 = own")),
            "{texts:?}"
        );
        let colour = traced[0]
            .records
            .iter()
            .find_map(|record| match record.event {
                Event::PixelColour(colour) => Some(colour.raw),
                _ => None,
            });
        // nothing is ambient, and no light is there
        assert_eq!(colour.unwrap().to_array(), [0.0; 3]);
        assert!(texts.contains(&"= (0, 0, 0)".into()), "{texts:?}");
    }
}
