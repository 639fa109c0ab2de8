//! Counts: how many rays of each purpose, how many tests of each kind, and how many of them hit.

use crate::trace::{
    BoundOutcome, Bounded, Event, Kind, NodeOutcome, Outcome, Purpose, QueueAction, RayEnd,
    Recorder,
};

/// What a trace cost. A recorder that keeps sums alone.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// By purpose: eye, shadow, reflected, refracted.
    pub rays: [RayCount; 4],
    /// By kind: sphere, ellipsoid, cone, box, plane, polygon.
    pub tests: [TestCount; 6],
    /// What the search for the objects to test cost.
    pub search: SearchCount,
    /// Purposes of the rays that have started and not ended.
    open: Vec<Purpose>,
    /// The volume of an object was met, and the object was not met since.
    in_vain: bool,
}

/// Rays of one purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCount {
    /// How many were traced.
    pub traced: u64,
    /// How many of these met an object; of shadow rays, how many were blocked.
    pub hits: u64,
    /// How many more were not traced because of the depth limit.
    pub beyond_depth: u64,
}

/// Tests of one kind. Tests are hits and misses, no more and no less.
///
/// A polygon takes two: `plane_test` hits if its plane is met where it counts, and then `polygon_test` if
/// the point lies inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TestCount {
    /// How many were made.
    pub tests: u64,
    /// How many met what they tested.
    pub hits: u64,
    /// How many did not.
    pub misses: u64,
}

impl TestCount {
    fn add(&mut self, hit: bool) {
        self.tests += 1;
        if hit {
            self.hits += 1;
        } else {
            self.misses += 1;
        }
    }

    fn sum(&mut self, other: &Self) {
        self.tests += other.tests;
        self.hits += other.hits;
        self.misses += other.misses;
    }
}

/// What it cost to find out which objects to test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SearchCount {
    /// Bounding volumes tested, and how many of them were met where it counts.
    pub bounds: TestCount,
    /// Volumes of objects that were met, and then the object was not.
    pub in_vain: u64,
    /// Slabs tested: fewer than bounds times directions, since a bound is left as soon as near and far cross.
    pub slabs: u64,
    /// Nodes whose children or objects were looked at.
    pub entered: u64,
    /// Nodes that the ray does not meet.
    pub rejected: u64,
    /// Nodes left out because a nearer hit was known.
    pub pruned: u64,
    /// Nodes put into the heap.
    pub pushed: u64,
    /// Cells whose lists were looked at.
    pub cells: u64,
    /// Objects found on the lists of cells.
    pub listed: u64,
    /// Objects that their mailbox saved from another test.
    pub mailbox: u64,
    /// Hits that lay beyond their cell.
    pub outside_cell: u64,
    /// Points and vectors brought into the frame of a ray.
    pub aligned: u64,
}

impl SearchCount {
    /// Each sum with its name in reports, in a fixed order.
    pub fn named(&self) -> [(&'static str, u64); 14] {
        [
            ("bound tests", self.bounds.tests),
            ("bounds met", self.bounds.hits),
            ("bounds missed", self.bounds.misses),
            ("bounds met in vain", self.in_vain),
            ("slab tests", self.slabs),
            ("nodes entered", self.entered),
            ("nodes rejected", self.rejected),
            ("nodes pruned", self.pruned),
            ("heap pushes", self.pushed),
            ("cells", self.cells),
            ("objects listed", self.listed),
            ("saved by mailboxes", self.mailbox),
            ("hits outside the cell", self.outside_cell),
            ("points aligned", self.aligned),
        ]
    }

    fn add(&mut self, other: &Self) {
        self.bounds.sum(&other.bounds);
        self.in_vain += other.in_vain;
        self.slabs += other.slabs;
        self.entered += other.entered;
        self.rejected += other.rejected;
        self.pruned += other.pruned;
        self.pushed += other.pushed;
        self.cells += other.cells;
        self.listed += other.listed;
        self.mailbox += other.mailbox;
        self.outside_cell += other.outside_cell;
        self.aligned += other.aligned;
    }
}

impl Counts {
    /// The purposes, in the order of [`Counts::rays`].
    pub const PURPOSES: [Purpose; 4] = [
        Purpose::Eye,
        Purpose::Shadow,
        Purpose::Reflected,
        Purpose::Refracted,
    ];

    /// The kinds of test, in the order of [`Counts::tests`].
    pub const TESTS: [Kind; 6] = [
        Kind::SphereTest,
        Kind::EllipsoidTest,
        Kind::ConeTest,
        Kind::BoxTest,
        Kind::PlaneTest,
        Kind::PolygonTest,
    ];

    /// The rays of one purpose.
    pub fn of(&self, purpose: Purpose) -> RayCount {
        self.rays[purpose as usize]
    }

    /// All rays that were traced.
    pub fn traced(&self) -> u64 {
        self.rays.iter().map(|count| count.traced).sum()
    }

    /// Adds what another part of the picture cost.
    pub fn add(&mut self, other: &Self) {
        for (sum, count) in self.rays.iter_mut().zip(&other.rays) {
            sum.traced += count.traced;
            sum.hits += count.hits;
            sum.beyond_depth += count.beyond_depth;
        }
        for (sum, count) in self.tests.iter_mut().zip(&other.tests) {
            sum.sum(count);
        }
        self.search.add(&other.search);
    }

    /// All objects tested: a polygon counts once, by its plane.
    pub fn objects_tested(&self) -> u64 {
        let tests = Self::TESTS.iter().zip(&self.tests);
        tests
            .filter(|(kind, _)| **kind != Kind::PolygonTest)
            .map(|(_, count)| count.tests)
            .sum()
    }

    /// One step of the search.
    fn searched(&mut self, event: &Event) {
        let search = &mut self.search;
        match event {
            Event::BoundTest(test) => {
                search.in_vain += u64::from(std::mem::take(&mut self.in_vain));
                let met = test.outcome == BoundOutcome::Hit;
                search.bounds.add(met);
                self.in_vain = met && matches!(test.of, Bounded::Object(_));
            }
            Event::SlabTest(_) => search.slabs += 1,
            Event::Node(visit) => match visit.outcome {
                NodeOutcome::Entered => search.entered += 1,
                NodeOutcome::Rejected => search.rejected += 1,
                NodeOutcome::Pruned => search.pruned += 1,
            },
            Event::Queue(step) => {
                search.pushed += u64::from(step.action == QueueAction::Push);
            }
            Event::Cell(_) => search.cells += 1,
            Event::Listed { .. } => search.listed += 1,
            Event::Mailbox { .. } => search.mailbox += 1,
            Event::HitOutsideCell(_) => search.outside_cell += 1,
            Event::Aligned(_) => search.aligned += 1,
            _ => {}
        }
    }

    fn ended(&mut self, end: &RayEnd) {
        self.search.in_vain += u64::from(std::mem::take(&mut self.in_vain));
        let Some(purpose) = self.open.pop() else {
            return;
        };
        let count = &mut self.rays[purpose as usize];
        match end.outcome {
            Outcome::DepthLimit => count.beyond_depth += 1,
            Outcome::Hit | Outcome::Blocked => {
                count.traced += 1;
                count.hits += 1;
            }
            Outcome::Miss | Outcome::ReachesLight => count.traced += 1,
        }
    }
}

/// The place of `plane_test` in [`Counts::TESTS`].
const PLANE: usize = 4;

impl Recorder for Counts {
    const ENABLED: bool = true;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        let event = event();
        let of_kind = match &event {
            Event::SphereTest { .. } => 0,
            Event::EllipsoidTest { .. } => 1,
            Event::ConeTest { .. } => 2,
            Event::BoxTest { .. } => 3,
            Event::PlaneTest { .. } => PLANE,
            Event::PolygonTest { .. } => 5,
            Event::Ray(start) => return self.open.push(start.purpose),
            Event::RayEnd(end) => return self.ended(end),
            _ => return self.searched(&event),
        };
        let hit = event.test_hits() == Some(true);
        self.tests[of_kind].add(hit);
        // the hit of a polygon is that of its outline
        self.in_vain &= !hit || of_kind == PLANE;
    }
}
