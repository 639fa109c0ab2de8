//! What the search for the objects to test must come to, counted from its events.

use raystep::trace::{BoundVerdict, Bounded, NodeVerdict, QueueAction, RayEnd, RayVerdict};
use raystep::{Counts, Event, Scene, StrategyName};

/// The steps of a search, of one ray or of many.
#[derive(Clone, Debug, Default)]
pub(super) struct Searched {
    /// Bounds by what came of them: met, missed, behind the origin, beyond the nearest hit.
    bounds: [u64; 4],
    slabs: u64,
    /// Nodes by what came of them: entered, rejected, pruned.
    nodes: [u64; 3],
    /// Objects in the leaves that were entered.
    in_leaves: u64,
    /// Objects and faces whose bounds were met, by the objects' places.
    bounded: Vec<u32>,
    /// Put into the heap, taken out, and what was left in it at a stop.
    heap: [u64; 3],
    entered_grids: u64,
    cells: u64,
    /// What the ends of the walks say.
    cells_told: u64,
    /// What the cells say of their lists.
    list_lengths: u64,
    listed: u64,
    mailbox: u64,
    outside_cell: u64,
    frames: u64,
    aligned: u64,
    sorted: u64,
    tests: u64,
    hits: u64,
    /// Bounds of objects that were met for nothing.
    wasted: u64,
    /// The last bound of an object was met, and the object not since.
    waits: bool,
}

impl Searched {
    /// One more event, and whether an object was met by it.
    pub(super) fn event(&mut self, event: &Event, met: bool) {
        self.waits &= !met;
        self.hits += u64::from(met);
        match event {
            Event::BoundTest(test) => {
                self.wasted += u64::from(std::mem::take(&mut self.waits));
                self.bounds[test.verdict as usize] += 1;
                if let (BoundVerdict::Hit, Bounded::Object(object)) = (test.verdict, test.of) {
                    self.bounded.push(object);
                    self.waits = true;
                }
            }
            Event::SlabTest(_) => self.slabs += 1,
            Event::Node(visit) => {
                self.nodes[visit.verdict as usize] += 1;
                if visit.verdict == NodeVerdict::Entered {
                    self.in_leaves += u64::from(visit.objects);
                }
            }
            Event::Queue(step) => {
                self.heap[step.action as usize] += match step.action {
                    QueueAction::Push | QueueAction::Pop => 1,
                    QueueAction::Stop => u64::from(step.size),
                }
            }
            Event::GridEnter(_) => self.entered_grids += 1,
            Event::Cell(visit) => {
                self.cells += 1;
                self.list_lengths += u64::from(visit.listed);
            }
            Event::Listed { .. } => self.listed += 1,
            Event::Mailbox { .. } => self.mailbox += 1,
            Event::HitOutsideCell(_) => self.outside_cell += 1,
            Event::GridExit(exit) => self.cells_told += u64::from(exit.cells),
            Event::Align(_) => self.frames += 1,
            Event::Aligned(_) => self.aligned += 1,
            Event::ZSort(_) => self.sorted += 1,
            Event::SphereTest { .. }
            | Event::EllipsoidTest { .. }
            | Event::ConeTest { .. }
            | Event::BoxTest { .. }
            | Event::PlaneTest { .. } => self.tests += 1,
            Event::RayEnd(_) => {
                self.wasted += u64::from(std::mem::take(&mut self.waits));
            }
            _ => {}
        }
    }

    /// Do the counts say the same?
    #[track_caller]
    pub(super) fn check(&self, scene: &str, counts: &Counts) {
        let search = counts.search;
        let [met, missed, behind, beyond] = self.bounds;
        assert_eq!(search.bounds.hits, met, "{scene}: bounds hit");
        assert_eq!(search.bounds.misses, missed + behind + beyond, "{scene}");
        assert_eq!(
            search.bounds.tests,
            search.bounds.hits + search.bounds.misses,
            "{scene}: bounds"
        );
        let nodes = [search.entered, search.rejected, search.pruned];
        assert_eq!(nodes, self.nodes, "{scene}: nodes");
        for (what, found, expected) in [
            ("bounds wasted", search.wasted, self.wasted),
            ("slabs", search.slabs, self.slabs),
            ("heap pushes", search.pushed, self.heap[0]),
            ("cells", search.cells, self.cells),
            ("listed", search.listed, self.listed),
            ("mailboxes", search.mailbox, self.mailbox),
            ("outside the cell", search.outside_cell, self.outside_cell),
            ("aligned", search.aligned, self.aligned),
        ] {
            assert_eq!(found, expected, "{scene}: {what}");
        }
    }

    /// Does what one ray was tested against follow from its search?
    #[track_caller]
    pub(super) fn check_ray(&self, scene: &Scene, strategy: StrategyName, end: &RayEnd) {
        assert_eq!(self.tests, u64::from(end.tests), "{self:?}");
        assert_eq!(self.hits, u64::from(end.hits), "{self:?}");
        // a shadow ray that is blocked ends in the middle of its search
        let whole = end.verdict != RayVerdict::Blocked;
        let objects = scene.primitives.len() as u64;
        match strategy {
            StrategyName::Exhaustive => self.all(objects, whole),
            StrategyName::ZAligned => {
                self.all(objects, whole);
                assert_eq!(self.frames, 1);
                assert!(!whole || self.sorted == self.hits, "{self:?}");
            }
            StrategyName::Bounds => self.bounded(scene, whole),
            StrategyName::Hierarchy | StrategyName::Heap => self.nodes(whole),
            StrategyName::Grid => self.cells(whole),
        }
    }

    #[track_caller]
    fn all(&self, objects: u64, whole: bool) {
        let enough = self.tests == objects || !whole && self.tests <= objects;
        assert!(enough, "{self:?}");
        assert_eq!((self.bounds, self.cells), ([0; 4], 0));
    }

    /// Each object has one bound, and what is in those that are met is tested.
    #[track_caller]
    fn bounded(&self, scene: &Scene, whole: bool) {
        let faces = |&object: &u32| u64::from(scene.objects[object as usize].count);
        let inside: u64 = self.bounded.iter().map(faces).sum();
        let tested: u64 = self.bounds.iter().sum();
        if whole {
            assert_eq!(tested, scene.objects.len() as u64);
            assert_eq!(self.tests, inside, "{self:?}");
        } else {
            assert!(tested <= scene.objects.len() as u64);
            assert!(self.tests <= inside, "{self:?}");
        }
        assert_eq!(self.nodes, [0; 3]);
    }

    /// Each node whose bound is tested is entered, rejected or pruned, or stays in the heap.
    #[track_caller]
    fn nodes(&self, whole: bool) {
        let [met, missed, behind, beyond] = self.bounds;
        let [entered, rejected, pruned] = self.nodes;
        let [pushed, popped, left] = self.heap;
        assert_eq!(rejected, missed + behind, "{self:?}");
        assert!(beyond <= pruned, "{self:?}");
        if whole {
            assert_eq!(entered + (pruned - beyond) + left, met, "{self:?}");
            assert_eq!(self.tests, self.in_leaves, "{self:?}");
        } else {
            assert!(entered + (pruned - beyond) <= met, "{self:?}");
            assert!(self.tests <= self.in_leaves, "{self:?}");
        }
        if 0 < pushed {
            assert_eq!((pushed, popped), (met, entered), "{self:?}");
        }
    }

    /// Each object on a list is tested or saved by its mailbox.
    #[track_caller]
    fn cells(&self, whole: bool) {
        assert_eq!(self.entered_grids, 1, "{self:?}");
        assert_eq!(self.cells, self.cells_told, "{self:?}");
        assert_eq!(self.listed, self.tests + self.mailbox, "{self:?}");
        assert!(self.outside_cell <= self.hits, "{self:?}");
        let lists = self.list_lengths;
        let enough = self.listed == lists || !whole && self.listed <= lists;
        assert!(enough, "{self:?}");
    }
}
