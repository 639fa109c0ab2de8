//! Counts: how many rays of each purpose, how many tests of each kind, and how many of them hit.

use crate::trace::{Event, Kind, Outcome, Purpose, RayEnd, Recorder};

/// What a trace cost. A recorder that keeps sums alone.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// By purpose: eye, shadow, reflected, refracted.
    pub rays: [RayCount; 4],
    /// By kind: sphere, ellipsoid, cone, box, plane, polygon.
    pub tests: [TestCount; 6],
    /// Purposes of the rays that have started and not ended.
    open: Vec<Purpose>,
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
            sum.tests += count.tests;
            sum.hits += count.hits;
            sum.misses += count.misses;
        }
    }

    fn ended(&mut self, end: &RayEnd) {
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
            Event::PlaneTest { .. } => 4,
            Event::PolygonTest { .. } => 5,
            Event::Ray(start) => return self.open.push(start.purpose),
            Event::RayEnd(end) => return self.ended(end),
            _ => return,
        };
        let count = &mut self.tests[of_kind];
        count.tests += 1;
        match event.test_hits() {
            Some(true) => count.hits += 1,
            Some(false) => count.misses += 1,
            None => {}
        }
    }
}
