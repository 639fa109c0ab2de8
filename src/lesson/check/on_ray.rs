//! A ray on which a log may have computed its tests: that of the scene, or its own.

use crate::geometry::{Ray, TRange};
use crate::lesson::check::reference::{Expected, Reference};
use crate::strategy::Hit;

/// A ray on which tests are computed: that of the scene, or the log's own.
pub(super) struct OnRay {
    pub(super) ray: Ray,
    pub(super) range: TRange,
    /// The length of its direction.
    pub(super) length: f64,
    pub(super) tests: Vec<Expected>,
    /// The nearest hit.
    pub(super) nearest: Option<Hit>,
}

impl OnRay {
    /// The tests of all objects on a ray, whose direction may have any length; the range is that of the unit direction.
    pub(super) fn new(reference: &Reference<'_, '_>, ray: Ray, range: TRange) -> Self {
        let length = ray.direction.length();
        let range = TRange {
            min: range.min / length,
            max: range.max / length,
        };
        Self {
            tests: reference.tests(&ray, range),
            nearest: reference.nearest(&ray, range),
            ray,
            range,
            length,
        }
    }
}
