//! What a search notes, for unit tests.

use crate::geometry::{Ray, TRange};
use crate::strategy::{Hit, Strategy};
use crate::trace::{Event, Recording};

/// What a search of this strategy for the nearest hit notes, and the hit.
pub(super) fn noted(strategy: &impl Strategy, ray: &Ray) -> (Vec<Event>, Option<Hit>) {
    noted_in(strategy, ray, TRange::FORWARD)
}

/// The same in a range.
pub(super) fn noted_in(
    strategy: &impl Strategy,
    ray: &Ray,
    range: TRange,
) -> (Vec<Event>, Option<Hit>) {
    let mut recording = Recording::new(Vec::new());
    let hit = strategy.nearest(ray, range, &mut recording);
    let records = recording.into_sink();
    let events = records.into_iter().map(|record| record.event);
    (events.collect(), hit)
}
