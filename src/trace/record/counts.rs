//! Counts: how many rays of each purpose, how many tests of each kind, and how many of them hit.

use std::ops::AddAssign;

use glam::DVec3;

use crate::trace::{
    BoundVerdict, Bounded, Event, Kind, NodeVerdict, Purpose, QueueAction, RayEnd, RayVerdict,
    Recorder,
};

/// What a trace cost. A recorder that keeps sums alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counts {
    /// By purpose, in the order of [`Counts::PURPOSES`].
    pub rays: [RayCount; 7],
    /// By kind: sphere, ellipsoid, cone, box, plane, polygon.
    pub tests: [TestCount; 6],
    /// What the search for the objects to test cost.
    pub search: SearchCount,
    /// What became of the light that was followed from the lamps.
    pub light: LightCount,
    /// Purposes of the rays that have started and not ended.
    open: Vec<Purpose>,
    /// The volume of an object was hit, and the object was not hit since.
    wasted: bool,
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
/// A polygon takes two: `plane_test` hits if its plane is hit where it counts, and then `polygon_test` if
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
    /// Bounding volumes tested, and how many of them were hit where it counts.
    pub bounds: TestCount,
    /// Volumes of objects that were hit, and then the object was not.
    pub wasted: u64,
    /// Slabs tested: fewer than bounds times directions, since a bound is left as soon as near and far cross.
    pub slabs: u64,
    /// Nodes whose children or objects were looked at.
    pub entered: u64,
    /// Nodes that the ray does not hit.
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

/// What became of the light that was followed from the lamps: how many paths, and where their power went.
///
/// The ledger: emitted = absorbed + left + cut off, channel by channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightCount {
    /// Paths that a light sent out.
    pub paths: u64,
    /// Paths that met a surface.
    pub hit: u64,
    /// Paths that left the scene.
    pub left: u64,
    /// Paths that ended on a surface.
    pub absorbed: u64,
    /// Paths that met as many surfaces as they may.
    pub cut_off: u64,
    /// Paths that passed the window into the eye, or were seen by a line to the eye that counts.
    pub reached_eye: u64,
    /// Photons that were stored.
    pub stored: u64,
    /// Points at which stored light was gathered.
    pub gathered: u64,
    /// Connecting lines that were drawn.
    pub connections: u64,
    /// Connecting lines with nothing between their ends.
    pub connected: u64,
    /// What the lights sent out, in watts for each channel.
    pub emitted_power: DVec3,
    /// What the surfaces absorbed.
    pub absorbed_power: DVec3,
    /// What left the scene.
    pub left_power: DVec3,
    /// What was still on its way when its path was cut off.
    pub cut_off_power: DVec3,
    /// The path that is followed now.
    path: Option<OpenPath>,
}

/// A path of light on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct OpenPath {
    power: DVec3,
    hit: bool,
    reached_eye: bool,
}

impl LightCount {
    /// Each number of paths and events with its name in reports, in a fixed order.
    pub fn named(&self) -> [(&'static str, u64); 10] {
        [
            ("paths emitted", self.paths),
            ("hit something", self.hit),
            ("left the scene", self.left),
            ("absorbed", self.absorbed),
            ("cut off", self.cut_off),
            ("reached the eye", self.reached_eye),
            ("photons stored", self.stored),
            ("gathered at points", self.gathered),
            ("connecting lines", self.connections),
            ("of them unblocked", self.connected),
        ]
    }

    /// Each power with its name in reports: what was emitted, then where it went.
    pub fn ledger(&self) -> [(&'static str, DVec3); 4] {
        [
            ("emitted", self.emitted_power),
            ("absorbed", self.absorbed_power),
            ("left the scene", self.left_power),
            ("cut off", self.cut_off_power),
        ]
    }

    /// The share of the paths that never reached the eye; `None` without paths.
    pub fn wasted(&self) -> Option<f64> {
        (0 < self.paths).then(|| 1.0 - self.reached_eye as f64 / self.paths as f64)
    }

    fn carried(&mut self, event: &Event) {
        match event {
            // what is hit in a pixel is hit by paths from the eye
            Event::Pixel(_) => self.path = None,
            Event::Path(start) => {
                self.paths += 1;
                self.emitted_power += start.power;
                self.path = Some(OpenPath {
                    power: start.power,
                    ..OpenPath::default()
                });
            }
            Event::Photon(photon) => {
                if let Some(path) = &mut self.path {
                    let leaving = photon.leaving();
                    self.absorbed_power += photon.power - leaving;
                    self.hit += u64::from(!path.hit);
                    path.hit = true;
                    path.power = leaving;
                }
            }
            Event::Arrival(_) => self.reaches_eye(),
            Event::Stored(_) => self.stored += 1,
            Event::Gathered(_) => self.gathered += 1,
            Event::Connection(connection) => {
                self.connections += 1;
                self.connected += u64::from(connection.visible);
                if connection.contribution != DVec3::ZERO {
                    self.reaches_eye();
                }
            }
            _ => {}
        }
    }

    fn reaches_eye(&mut self) {
        if let Some(path) = &mut self.path {
            self.reached_eye += u64::from(!path.reached_eye);
            path.reached_eye = true;
        }
    }

    fn leg_ended(&mut self, verdict: RayVerdict) {
        let Some(path) = self.path else { return };
        match verdict {
            RayVerdict::Miss => {
                self.left += 1;
                self.left_power += path.power;
            }
            RayVerdict::CutOff => {
                self.cut_off += 1;
                self.cut_off_power += path.power;
            }
            RayVerdict::Absorbed => self.absorbed += 1,
            _ => {}
        }
    }

    fn add(&mut self, other: &Self) {
        self.paths += other.paths;
        self.hit += other.hit;
        self.left += other.left;
        self.absorbed += other.absorbed;
        self.cut_off += other.cut_off;
        self.reached_eye += other.reached_eye;
        self.stored += other.stored;
        self.gathered += other.gathered;
        self.connections += other.connections;
        self.connected += other.connected;
        self.emitted_power += other.emitted_power;
        self.absorbed_power += other.absorbed_power;
        self.left_power += other.left_power;
        self.cut_off_power += other.cut_off_power;
    }
}

impl SearchCount {
    /// Each sum with its name in reports, in a fixed order.
    pub fn named(&self) -> [(&'static str, u64); 14] {
        [
            ("bound tests", self.bounds.tests),
            ("bounds hit", self.bounds.hits),
            ("bounds missed", self.bounds.misses),
            ("bounds wasted", self.wasted),
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
        self.wasted += other.wasted;
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
    pub const PURPOSES: [Purpose; 7] = [
        Purpose::Eye,
        Purpose::Shadow,
        Purpose::Reflected,
        Purpose::Refracted,
        Purpose::Scattered,
        Purpose::Light,
        Purpose::Connection,
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
        self.light.add(&other.light);
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
    #[inline]
    fn searched(&mut self, event: &Event) {
        let search = &mut self.search;
        match event {
            Event::BoundTest(test) => {
                search.wasted += u64::from(std::mem::take(&mut self.wasted));
                let met = test.verdict == BoundVerdict::Hit;
                search.bounds.add(met);
                self.wasted = met && matches!(test.of, Bounded::Object(_));
            }
            Event::SlabTest(_) => search.slabs += 1,
            Event::Node(visit) => match visit.verdict {
                NodeVerdict::Entered => search.entered += 1,
                NodeVerdict::Rejected => search.rejected += 1,
                NodeVerdict::Pruned => search.pruned += 1,
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
        self.search.wasted += u64::from(std::mem::take(&mut self.wasted));
        let Some(purpose) = self.open.pop() else {
            return;
        };
        if purpose == Purpose::Light {
            self.light.leg_ended(end.verdict);
        }
        let count = &mut self.rays[purpose as usize];
        match end.verdict {
            RayVerdict::DepthLimit => count.beyond_depth += 1,
            RayVerdict::Hit | RayVerdict::Blocked | RayVerdict::Absorbed | RayVerdict::CutOff => {
                count.traced += 1;
                count.hits += 1;
            }
            RayVerdict::Miss | RayVerdict::ReachesLight | RayVerdict::Connects => count.traced += 1,
        }
    }
}

/// The place of `plane_test` in [`Counts::TESTS`].
const PLANE: usize = 4;

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.add(&other);
    }
}

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
            Event::Path(_)
            | Event::Photon(_)
            | Event::Arrival(_)
            | Event::Stored(_)
            | Event::Gathered(_)
            | Event::Connection(_)
            | Event::Pixel(_) => return self.light.carried(&event),
            _ => return self.searched(&event),
        };
        let hit = event.test_hits() == Some(true);
        self.tests[of_kind].add(hit);
        // the hit of a polygon is that of its outline
        self.wasted &= !hit || of_kind == PLANE;
    }
}
