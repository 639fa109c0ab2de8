//! What became of each node of a hierarchy on one ray, from the events alone.

use crate::figure::sheet::look::{Colour, Dash, Look};
use crate::figure::subject::DrawnRay;
use crate::scene::PrimitiveId;
use crate::trace::{BoundTest, BoundVerdict, Bounded, Event, NodeVerdict, NodeVisit, Record};

/// What became of a node in the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::figure) enum Verdict {
    /// The ray never visited it.
    #[default]
    Unreached,
    /// The ray hits its bound, and the search ended before it was its turn.
    Waiting,
    /// What is below it was looked at.
    Entered,
    /// The ray does not hit its bound in front of it.
    Rejected,
    /// A nearer hit was known.
    Pruned,
}

impl Verdict {
    pub(in crate::figure) const ALL: [Self; 5] = [
        Self::Entered,
        Self::Rejected,
        Self::Pruned,
        Self::Waiting,
        Self::Unreached,
    ];

    /// How a node with this verdict looks: each has a pattern of its own, and [`Verdict::Rejected`] and
    /// [`Verdict::Pruned`] a mark.
    pub(in crate::figure) fn look(self) -> Look {
        match self {
            Self::Entered => Look::VISITED.wide(2.0),
            Self::Rejected => Look::REJECTED.outline(),
            Self::Pruned => Look {
                colour: Colour::Rejected,
                dash: Dash::Alternating,
                ..Look::REJECTED.outline()
            },
            Self::Waiting => Look {
                dash: Dash::Long,
                ..Look::VISITED.outline()
            },
            Self::Unreached => Look::CULLED,
        }
    }

    /// What a legend calls it.
    pub(in crate::figure) fn name(self) -> &'static str {
        match self {
            Self::Entered => "entered",
            Self::Rejected => "rejected",
            Self::Pruned => "pruned: behind the hit",
            Self::Waiting => "waits",
            Self::Unreached => "not visited",
        }
    }
}

/// What became of a node, with the step that decided it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::figure) struct Visit {
    pub(in crate::figure) verdict: Verdict,
    pub(in crate::figure) step: Option<u32>,
    /// The step at which its bound was hit, and where the ray enters that.
    pub(in crate::figure) hit: Option<(u32, f64)>,
}

/// An object at a leaf that was tested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::figure) struct ObjectTest {
    pub(in crate::figure) object: PrimitiveId,
    pub(in crate::figure) step: u32,
    pub(in crate::figure) is_hit: bool,
    /// Where it is the nearest hit so far.
    pub(in crate::figure) t: Option<f64>,
}

/// A node whose turn it is, and what follows before the next one.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Turn {
    pub(in crate::figure) node: u32,
    /// Is it entered, or left out since a nearer hit is known?
    pub(in crate::figure) is_entered: bool,
    /// The last step of it.
    pub(in crate::figure) last: u32,
    /// The nodes below it whose bounds the ray hits, and those that it misses.
    pub(in crate::figure) hit: Vec<u32>,
    pub(in crate::figure) missed: Vec<u32>,
    pub(in crate::figure) tested: Vec<ObjectTest>,
}

/// What happened to the nodes of a hierarchy and to the objects at its leaves.
#[derive(Clone, Debug, Default)]
pub(in crate::figure) struct Visits {
    /// By the number of the node.
    pub(in crate::figure) nodes: Vec<Visit>,
    /// Nodes in the order in which they were decided, each with its step.
    pub(in crate::figure) order: Vec<(u32, u32)>,
    /// The nodes that were entered or left out when it was their turn, in order.
    pub(in crate::figure) turns: Vec<Turn>,
}

impl Visits {
    /// Gathers what happened on a ray to a number of nodes.
    pub(in crate::figure) fn of(events: &[&Record], nodes: usize) -> Self {
        let mut visits = Self {
            nodes: vec![Visit::default(); nodes],
            ..Self::default()
        };
        for record in events {
            let step = record.step;
            match &record.event {
                Event::BoundTest(test) => {
                    if let Bounded::Node(node) = test.of {
                        visits.bound(node, step, test);
                    }
                }
                Event::Node(visit) if (visit.node as usize) < nodes => visits.decide(visit, step),
                Event::Nearest(nearest) => {
                    let tests = visits.turns.last_mut().map(|turn| &mut turn.tested);
                    let mut tests = tests.into_iter().flatten();
                    if let Some(test) = tests.find(|test| test.object == nearest.object) {
                        test.t = Some(nearest.t);
                    }
                }
                event => {
                    if let Some((object, is_hit)) = tested(event) {
                        visits.note_test(object, step, is_hit);
                    }
                }
            }
            if let Some(turn) = visits.turns.last_mut() {
                turn.last = step;
            }
        }
        visits
    }

    fn bound(&mut self, node: u32, step: u32, test: &BoundTest) {
        let is_hit = test.verdict == BoundVerdict::Hit;
        if let Some(turn) = self.turns.last_mut() {
            let nodes = if is_hit {
                &mut turn.hit
            } else {
                &mut turn.missed
            };
            nodes.push(node);
        }
        if let (true, Some(of)) = (is_hit, self.nodes.get_mut(node as usize)) {
            *of = Visit {
                verdict: Verdict::Waiting,
                step: Some(step),
                hit: test.inside.map(|[near, _]| (step, near)),
            };
        }
    }

    fn decide(&mut self, visit: &NodeVisit, step: u32) {
        let of = &mut self.nodes[visit.node as usize];
        of.step = Some(step);
        of.verdict = match visit.verdict {
            NodeVerdict::Entered => Verdict::Entered,
            NodeVerdict::Rejected => Verdict::Rejected,
            NodeVerdict::Pruned => Verdict::Pruned,
        };
        self.order.push((visit.node, step));
        if of.verdict != Verdict::Rejected {
            self.turns.push(Turn {
                node: visit.node,
                is_entered: of.verdict == Verdict::Entered,
                last: step,
                hit: Vec::new(),
                missed: Vec::new(),
                tested: Vec::new(),
            });
        }
    }

    /// All tests of objects, in order.
    pub(in crate::figure) fn tested(&self) -> impl Iterator<Item = &ObjectTest> {
        self.turns.iter().flat_map(|turn| &turn.tested)
    }

    /// A polygon is tested twice: its plane, and whether the point is inside.
    fn note_test(&mut self, object: PrimitiveId, step: u32, is_hit: bool) {
        let Some(turn) = self.turns.last_mut() else {
            return;
        };
        turn.tested.retain(|test| test.object != object);
        turn.tested.push(ObjectTest {
            object,
            step,
            is_hit,
            t: None,
        });
    }

    /// How many nodes have this verdict.
    pub(in crate::figure) fn count(&self, verdict: Verdict) -> usize {
        self.nodes
            .iter()
            .filter(|visit| visit.verdict == verdict)
            .count()
    }
}

/// The object that an event tests, and whether it is hit.
pub(in crate::figure) fn tested(event: &Event) -> Option<(PrimitiveId, bool)> {
    let object = match event {
        Event::SphereTest { object, .. }
        | Event::EllipsoidTest { object, .. }
        | Event::ConeTest { object, .. }
        | Event::BoxTest { object, .. }
        | Event::PlaneTest { object, .. }
        | Event::PolygonTest { object, .. } => *object,
        _ => return None,
    };
    Some((object, event.test_hits().unwrap_or(false)))
}

/// The object that a ray has hit when it ends, and where.
pub(in crate::figure) fn met(ray: &DrawnRay) -> Option<(PrimitiveId, f64)> {
    let end = ray.node.end?;
    Some((end.object?, end.t?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(step: u32, event: Event) -> Record {
        Record {
            pixel: Some([0, 0]),
            path: None,
            step,
            ray: Some(0),
            parent: None,
            event,
        }
    }

    fn met(node: u32) -> Event {
        Event::BoundTest(BoundTest {
            of: Bounded::Node(node),
            inside: Some([2.5, 4.0]),
            verdict: BoundVerdict::Hit,
            ..BoundTest::default()
        })
    }

    fn decided(node: u32, verdict: NodeVerdict) -> Event {
        Event::Node(NodeVisit {
            node,
            verdict,
            ..NodeVisit::default()
        })
    }

    #[test]
    fn a_node_that_was_met_waits_until_it_is_decided() {
        let records = [
            record(1, met(0)),
            record(2, decided(0, NodeVerdict::Entered)),
            record(3, met(1)),
            record(4, met(2)),
            record(5, decided(2, NodeVerdict::Pruned)),
            // a number that the hierarchy does not have
            record(6, decided(9, NodeVerdict::Entered)),
        ];
        let visits = Visits::of(&records.iter().collect::<Vec<_>>(), 4);
        let verdicts: Vec<Verdict> = visits.nodes.iter().map(|visit| visit.verdict).collect();
        let expected = [
            Verdict::Entered,
            Verdict::Waiting,
            Verdict::Pruned,
            Verdict::Unreached,
        ];
        assert_eq!(verdicts, expected);
        assert_eq!(visits.order, [(0, 2), (2, 5)]);
        assert_eq!(visits.nodes[2].step, Some(5));
        assert_eq!(visits.nodes[2].hit, Some((4, 2.5)));
        let turns = visits.turns.iter();
        let turns: Vec<_> = turns
            .map(|turn| (turn.node, turn.is_entered, turn.last, turn.hit.as_slice()))
            .collect();
        assert_eq!(turns, [(0, true, 4, &[1, 2][..]), (2, false, 6, &[][..])]);
    }
}
