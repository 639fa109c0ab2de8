//! Which events make a place or a test together.
//!
//! What a strategy does with a node, a cell or an object is several events one after the other: `listed`, `sphere_test`,
//! `nearest`. They are one step. In a filtered log some of them may be missing; what is there is put together in the same way.

use crate::scene::PrimitiveId;
use crate::trace::{Bounded, Event, NodeVerdict, QueueAction};

/// A place on a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::step) enum PlaceKey {
    /// A node that is visited or left out.
    Node(u32),
    /// A cell that is visited.
    Cell,
    /// A node whose bound is made while the hierarchy is built.
    Merged(u32),
}

/// What the events of a test have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::step) enum TestKey {
    /// They are about an object.
    Object(PrimitiveId),
    /// They are about a bound.
    Bound(Bounded),
    /// S and T of the ray and each slab.
    SlabRays,
    /// The hits are sorted.
    ZSort,
    /// Light is gathered.
    Gather,
    /// A line is weighed.
    Connection,
    /// An object is put on the lists of cells.
    Assigned(PrimitiveId),
}

/// What is open on a ray.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::step) struct OpenGroup {
    /// The place, and whether its node or cell has been visited.
    pub(in crate::step) place: Option<(PlaceKey, bool)>,
    /// The test, and whether it is decided.
    pub(in crate::step) test: Option<(TestKey, bool)>,
}

/// Where an event belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::step) enum Belongs {
    /// To the ray or the section itself: no place and no test goes on.
    Ray,
    /// To the open place, or to the ray if none is open: no test goes on.
    Alone,
    /// It begins a place.
    OpensPlace(PlaceKey),
    /// It visits the place that is open.
    Visits,
    /// It begins a test.
    OpensTest(TestKey),
    /// It belongs to the test that is open.
    Joins,
}

impl OpenGroup {
    /// Where the next event belongs.
    pub(in crate::step) fn belongs(&self, event: &Event) -> Belongs {
        match *event {
            Event::Path(_)
            | Event::Pixel(_)
            | Event::Ray(_)
            | Event::Align(_)
            | Event::GridEnter(_)
            | Event::GridExit(_)
            | Event::Arrival(_)
            | Event::Stored(_)
            | Event::LightTerm(_)
            | Event::Refraction(_)
            | Event::Photon(_)
            | Event::Shade(_)
            | Event::RayEnd(_)
            | Event::PixelColour(_) => Belongs::Ray,

            Event::Merge(step) => self.place(PlaceKey::Merged(step.node)),
            Event::Cell(_) => Belongs::OpensPlace(PlaceKey::Cell),
            Event::Queue(step) => match step.action {
                QueueAction::Push => self.test(TestKey::Bound(Bounded::Node(step.node)), true),
                QueueAction::Pop | QueueAction::Stop => {
                    Belongs::OpensPlace(PlaceKey::Node(step.node))
                }
            },
            Event::Node(visit) => {
                let bound = TestKey::Bound(Bounded::Node(visit.node));
                let is_tested = self.test.is_some_and(|(key, _)| key == bound);
                match visit.verdict {
                    NodeVerdict::Rejected => self.test(bound, true),
                    NodeVerdict::Pruned if is_tested => Belongs::Joins,
                    NodeVerdict::Entered | NodeVerdict::Pruned => match self.place {
                        // it was taken out of the heap
                        Some((PlaceKey::Node(node), false)) if node == visit.node => {
                            Belongs::Visits
                        }
                        _ => Belongs::OpensPlace(PlaceKey::Node(visit.node)),
                    },
                }
            }

            Event::SlabRay(_) => self.test(TestKey::SlabRays, false),
            Event::SlabTest(test) => self.test(TestKey::Bound(test.of), false),
            Event::BoundTest(test) => self.test(TestKey::Bound(test.of), false),
            Event::ZSort(_) => self.test(TestKey::ZSort, false),
            Event::Nearby(_) | Event::Gathered(_) => self.test(TestKey::Gather, false),
            Event::Alternative(_) | Event::Connection(_) => self.test(TestKey::Connection, false),
            Event::Assign(step) => self.test(TestKey::Assigned(step.object), false),

            Event::Listed { object } => Belongs::OpensTest(TestKey::Object(object)),
            Event::Mailbox { object }
            | Event::Aligned(crate::trace::Aligned { object, .. })
            | Event::SphereTest { object, .. }
            | Event::EllipsoidTest { object, .. }
            | Event::ConeTest { object, .. }
            | Event::BoxTest { object, .. }
            | Event::PlaneTest { object, .. } => self.test(TestKey::Object(object), false),
            Event::Edge { object, .. } | Event::PolygonTest { object, .. } => {
                self.test(TestKey::Object(object), true)
            }
            Event::Nearest(hit) => match self.test {
                Some((TestKey::ZSort, _)) => Belongs::Joins,
                Some((TestKey::Object(object), _)) if object == hit.object => Belongs::Joins,
                _ => Belongs::Alone,
            },
            Event::HitOutsideCell(hit) => match self.test {
                Some((TestKey::Object(object), _)) if object == hit.object => Belongs::Joins,
                _ => Belongs::Alone,
            },
        }
    }

    /// An event of a place that goes on while the same node is worked on.
    fn place(&self, key: PlaceKey) -> Belongs {
        match self.place {
            Some((open, _)) if open == key => Belongs::Alone,
            _ => Belongs::OpensPlace(key),
        }
    }

    /// An event of a test: of the open one, if that is of the same thing and, unless the event may follow the decision, not
    /// decided.
    fn test(&self, key: TestKey, may_follow: bool) -> Belongs {
        match self.test {
            Some((open, is_decided)) if open == key && (may_follow || !is_decided) => {
                Belongs::Joins
            }
            _ => Belongs::OpensTest(key),
        }
    }
}

/// Does an event decide the test that it belongs to, so that one more of its kind begins another?
pub(in crate::step) fn decides(event: &Event) -> bool {
    matches!(
        event,
        Event::BoundTest(_)
            | Event::Mailbox { .. }
            | Event::SphereTest { .. }
            | Event::EllipsoidTest { .. }
            | Event::ConeTest { .. }
            | Event::BoxTest { .. }
            | Event::PlaneTest { .. }
            | Event::Gathered(_)
            | Event::Connection(_)
    )
}
