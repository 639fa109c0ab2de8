//! What became of a test, by its event, and what else follows from an event's numbers.

use glam::DVec3;

use crate::geometry::{PARALLEL, SlabRay};
use crate::trace::event::table::{Event, PixelColour, RaySlab};
use crate::trace::event::verdict::{of_box, of_plane, of_polygon, of_quadratic, of_slab, verdict};
use crate::trace::event::words::{Verdict, Why};

impl Event {
    /// What became of a test, and if it was rejected, why. `None` for all that is no test.
    ///
    /// ```
    /// use raystep::Event;
    /// use raystep::geometry::PolygonTest;
    /// use raystep::scene::PrimitiveId;
    /// use raystep::trace::{Verdict, Why};
    ///
    /// let test = PolygonTest { inside: false, ..PolygonTest::default() };
    /// let event = Event::PolygonTest { object: PrimitiveId(0), test };
    /// assert_eq!(event.verdict(), Some((Verdict::Rejected, Some(Why::Outside))));
    /// ```
    pub fn verdict(&self) -> Option<(Verdict, Option<Why>)> {
        let why = match self {
            Self::SphereTest { test, .. }
            | Self::EllipsoidTest { test, .. }
            | Self::ConeTest { test, .. } => of_quadratic(test),
            Self::BoxTest { test, .. } => of_box(test),
            Self::PlaneTest { test, .. } => of_plane(test),
            Self::PolygonTest { test, .. } => of_polygon(test),
            Self::BoundTest(test) => test.verdict.why(),
            Self::SlabTest(test) => of_slab(test.step.verdict),
            _ => return None,
        };
        Some((verdict(why), why))
    }

    /// Was an object tested, and was it met? A polygon is tested by its plane, and met if the point
    /// lies inside: both tests together are one object's.
    #[inline]
    pub(crate) fn object_tested(&self) -> (bool, bool) {
        let hit = self.test_hits();
        match self {
            Self::PlaneTest { .. } => (true, false),
            Self::PolygonTest { .. } => (false, hit == Some(true)),
            _ => (hit.is_some(), hit == Some(true)),
        }
    }

    /// Did a test of an object meet it? `None` for all that is no such test.
    ///
    /// A polygon has two tests: its plane is hit or not, and then the point is inside or not.
    #[inline]
    pub fn test_hits(&self) -> Option<bool> {
        match self {
            Self::SphereTest { test, .. }
            | Self::EllipsoidTest { test, .. }
            | Self::ConeTest { test, .. } => Some(test.roots.chosen().is_some()),
            Self::BoxTest { test, .. } => Some(test.roots.chosen().is_some()),
            Self::PlaneTest { test, .. } => Some(test.chosen().is_some()),
            Self::PolygonTest { test, .. } => Some(test.inside),
            _ => None,
        }
    }
}

impl RaySlab {
    /// S and T of a ray and one direction of a set, and the room. T of a parallel ray is ∞: its sign says nothing.
    pub(crate) fn new(slab: u32, normal: DVec3, line: SlabRay, room: f64) -> Self {
        let SlabRay { s, t_scale } = line;
        Self {
            slab,
            normal,
            s,
            t_scale: if PARALLEL < t_scale.abs() {
                f64::INFINITY
            } else {
                t_scale
            },
            room,
        }
    }

    /// S and T, of the ray and the slab.
    pub(crate) fn line(&self) -> SlabRay {
        SlabRay {
            s: self.s,
            t_scale: self.t_scale,
        }
    }
}

impl PixelColour {
    /// The colour in 8 bits a channel, without gamma: 255 times `clamped`, rounded.
    pub fn rgb(&self) -> [u8; 3] {
        (self.clamped * 255.0).round().to_array().map(|of| of as u8)
    }
}
