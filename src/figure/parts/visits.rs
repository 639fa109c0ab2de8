//! What became of each node of a hierarchy on one ray, from the events alone.

use crate::figure::sheet::look::{Colour, Dash, Look};
use crate::figure::subject::DrawnRay;
use crate::scene::PrimitiveId;
use crate::trace::{BoundVerdict, Bounded, Event, NodeVerdict, Record};

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
                dash: Dash::Dashed,
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
            Self::Waiting => "left waiting",
            Self::Unreached => "never visited",
        }
    }
}

/// What became of a node, with the step that decided it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::figure) struct Visit {
    pub(in crate::figure) verdict: Verdict,
    pub(in crate::figure) step: Option<u32>,
}

/// What happened to the nodes of a hierarchy and to the objects at its leaves.
#[derive(Clone, Debug, Default)]
pub(in crate::figure) struct Visits {
    /// By the number of the node.
    pub(in crate::figure) nodes: Vec<Visit>,
    /// Nodes in the order in which they were decided.
    pub(in crate::figure) order: Vec<u32>,
    /// Objects that were tested, in order: at which step, and whether they were hit.
    pub(in crate::figure) tested: Vec<(PrimitiveId, u32, bool)>,
}

impl Visits {
    /// Gathers what happened on a ray to a number of nodes.
    pub(in crate::figure) fn of(events: &[&Record], nodes: usize) -> Self {
        let mut visits = Self {
            nodes: vec![Visit::default(); nodes],
            ..Self::default()
        };
        for record in events {
            let step = Some(record.step);
            match &record.event {
                Event::BoundTest(test) if test.verdict == BoundVerdict::Hit => {
                    if let Bounded::Node(node) = test.of {
                        let verdict = Verdict::Waiting;
                        visits.set(node, Visit { verdict, step });
                    }
                }
                Event::Node(visit) => {
                    let verdict = match visit.verdict {
                        NodeVerdict::Entered => Verdict::Entered,
                        NodeVerdict::Rejected => Verdict::Rejected,
                        NodeVerdict::Pruned => Verdict::Pruned,
                    };
                    visits.set(visit.node, Visit { verdict, step });
                    if (visit.node as usize) < nodes {
                        visits.order.push(visit.node);
                    }
                }
                event => {
                    if let Some((object, is_hit)) = tested(event) {
                        visits.note_test(object, record.step, is_hit);
                    }
                }
            }
        }
        visits
    }

    fn set(&mut self, node: u32, visit: Visit) {
        if let Some(of) = self.nodes.get_mut(node as usize) {
            *of = visit;
        }
    }

    /// A polygon is tested twice: its plane, and whether the point is inside.
    fn note_test(&mut self, object: PrimitiveId, step: u32, is_hit: bool) {
        match self.tested.last_mut() {
            Some(last) if last.0 == object => *last = (object, step, is_hit),
            _ => self.tested.push((object, step, is_hit)),
        }
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
    use crate::trace::{BoundTest, NodeVisit};

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
        assert_eq!(visits.order, [0, 2]);
        assert_eq!(visits.nodes[2].step, Some(5));
    }
}
