//! The stages of a ray's way through a hierarchy: the ray, each node whose turn it is, the hit.

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kinds::hierarchy::walk::Walk;
use crate::figure::parts::scenery;
use crate::figure::parts::visits::{Turn, Verdict, met};
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::{StageId, parts};
use crate::figure::sheet::{Sheet, Width};
use crate::figure::subject::Figure;

/// The stages that are drawn at once; what an event makes is drawn with [`Sheet::event`].
pub(super) struct Argument {
    pub(super) ray: StageId,
    pub(super) end: StageId,
    /// The turns of the nodes, with the last step of each.
    turns: Vec<(StageId, u32)>,
}

/// With the ray and the end a dozen.
const MOST_TURNS: usize = 10;

impl Argument {
    pub(super) fn new(
        figure: &Figure,
        sheet: &mut Sheet,
        walk: &Walk,
    ) -> Result<Self, FigureError> {
        let [starts, ends] = figure.steps_of(&walk.ray)?;
        let nodes = walk.tree.nodes.len();
        let objects = walk.tree.nodes.iter().map(|node| node.objects.len());
        let objects: usize = objects.sum();
        let ray = sheet.stage(
            Part::Ray,
            starts,
            format!("The scene has {objects} objects in a hierarchy of {nodes} nodes; the ray r comes from the COP."),
        );
        let turns = &walk.visits.turns;
        let mut stages = Vec::new();
        for part in parts(turns.len(), MOST_TURNS) {
            let part = &turns[part];
            let last = part.iter().map(|turn| turn.last).max().unwrap_or(0);
            let sentence = match part {
                [turn] => walk.sentence(figure, turn),
                several => {
                    let numbers: Vec<String> =
                        several.iter().map(|turn| turn.node.to_string()).collect();
                    format!("Nodes {} follow.", numbers.join(", "))
                }
            };
            stages.push((sheet.stage(Part::Node, last, sentence), last));
        }
        let end = match met(&walk.ray) {
            Some((object, t)) => format!(
                "The nearest hit is {} at t = {}.",
                scenery::name_of(figure.scene, object),
                brief(t)
            ),
            None => "The ray hits no object.".into(),
        };
        Ok(Self {
            ray,
            end: sheet.stage(Part::Nearest, ends, end),
            turns: stages,
        })
    }

    /// The stage of the turn in which an event happens.
    fn of(&self, step: u32) -> StageId {
        let first = self.turns.iter().find(|(_, last)| step <= *last);
        first.map_or(self.end, |(stage, _)| *stage)
    }

    /// What the looks of nodes mean, from when on there is such a node.
    pub(super) fn legend(&self, sheet: &mut Sheet, body: Frame, walk: &Walk) -> Frame {
        let nodes = &walk.visits.nodes;
        let first = |verdict: Verdict| {
            let steps = nodes.iter().filter(|visit| visit.verdict == verdict);
            steps.filter_map(|visit| visit.step).min()
        };
        let waits = nodes
            .iter()
            .filter_map(|visit| visit.hit.map(|(step, _)| step))
            .min();
        let mut entries: Vec<(Option<StageId>, Look, &str)> = Vec::new();
        for verdict in Verdict::ALL {
            let since = match verdict {
                Verdict::Unreached => None,
                Verdict::Waiting => waits,
                other => first(other),
            };
            if since.is_some() || verdict == Verdict::Unreached {
                let stage = since.map(|step| self.of(step));
                let name = verdict.name();
                // one line of a slide has room for one word each
                let name = match sheet.width {
                    Width::Book => name,
                    Width::Slide => name.split_once(": ").map_or(name, |(word, _)| word),
                };
                entries.push((stage, verdict.look(), name));
            }
        }
        sheet.staged_legend(body, &entries)
    }
}

impl Walk<'_> {
    /// What happens when it is a node's turn.
    fn sentence(&self, figure: &Figure, turn: &Turn) -> String {
        let node = turn.node;
        let near = self.visits.nodes[node as usize].hit;
        let near = near.map_or(String::new(), |(_, near)| brief(near));
        if !turn.is_entered {
            return format!(
                "Node {node} begins at t = {near}, behind the nearest hit: it is pruned, with all below it."
            );
        }
        let numbers = |nodes: &[u32]| {
            let numbers: Vec<String> = nodes.iter().map(u32::to_string).collect();
            numbers.join(" and ")
        };
        let name = |id| scenery::name_of(figure.scene, id);
        let tests = turn.tested.iter().map(|test| match (test.is_hit, test.t) {
            (true, Some(t)) => format!("hits {} at t = {}", name(test.object), brief(t)),
            (true, None) => format!("hits {} behind the nearest hit", name(test.object)),
            (false, _) => format!("misses {}", name(test.object)),
        });
        let tests: Vec<String> = tests.collect();
        // the children that are tested come after the node; its own bound before it
        let so = match (turn.hit.as_slice(), turn.missed.as_slice()) {
            ([], []) if tests.is_empty() => return format!("Node {node} is entered."),
            ([], []) => return format!("Leaf {node} is entered: the ray {}.", tests.join(" and ")),
            (hit, []) => format!("the ray hits the volumes of {}", numbers(hit)),
            ([], missed) => format!("the ray misses the volumes of {}", numbers(missed)),
            (hit, missed) => format!(
                "the ray hits the volume of {} and misses that of {}",
                numbers(hit),
                numbers(missed)
            ),
        };
        format!("Node {node} is entered, at t = {near}: {so}.")
    }
}
