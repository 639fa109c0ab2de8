//! What the trace says of a ray that is laid along the z axis.

use crate::figure::error::FigureError;
use crate::figure::subject::{DrawnRay, Figure};
use crate::geometry::{Alignment, Ray};
use crate::scene::PrimitiveId;
use crate::structure::extent;
use crate::trace::{Aligned, Event, ZSort};

/// What was recorded on the ray.
pub(super) struct Laid {
    pub(super) ray: Ray,
    pub(super) starts: Option<u32>,
    pub(super) frame: Alignment,
    /// When it was laid along the axis.
    pub(super) step: u32,
    /// The transformed points, with their steps.
    pub(super) points: Vec<(Aligned, u32)>,
    /// The hits, nearest first.
    pub(super) sorted: Vec<(ZSort, u32)>,
}

impl Laid {
    pub(super) fn find(figure: &Figure) -> Result<Self, FigureError> {
        let DrawnRay { node, events } = figure.ray()?;
        let none = || {
            FigureError::new(
                "strategy",
                "the trace of this ray has no ray that is turned into the z axis",
                "add \"strategy\": \"z-aligned\"",
            )
        };
        let frame = events.iter().find_map(|record| match record.event {
            Event::Align(frame) => Some((frame, record.step)),
            _ => None,
        });
        let (Some((frame, step)), Some(start)) = (frame, node.start) else {
            return Err(none());
        };
        let points = events.iter().filter_map(|record| match record.event {
            Event::Aligned(point) => Some((point, record.step)),
            _ => None,
        });
        let sorted = events.iter().filter_map(|record| match record.event {
            Event::ZSort(hit) => Some((hit, record.step)),
            _ => None,
        });
        let records = figure.records()?;
        Ok(Self {
            ray: start.ray,
            starts: node.ends_at[0].map(|at| records[at].step),
            frame,
            step,
            points: points.collect(),
            sorted: sorted.collect(),
        })
    }

    /// The transformed points of one object, and the step of the last one.
    pub(super) fn of(&self, id: PrimitiveId) -> (Vec<Aligned>, Option<u32>) {
        let own = self.points.iter().filter(|(point, _)| point.object == id);
        let steps = own.clone().map(|(_, step)| *step);
        (own.map(|(point, _)| *point).collect(), steps.max())
    }
}

/// The t to which the ray is drawn: a little beyond the last object that it hits, or beyond all if it hits none.
pub(super) fn furthest(figure: &Figure, laid: &Laid) -> f64 {
    let Ray { origin, direction } = laid.ray;
    let is_met = |id: PrimitiveId| laid.sorted.iter().any(|(hit, _)| hit.object == id);
    let all = (0..).map(PrimitiveId).zip(&figure.scene.primitives);
    let ends = all
        .filter(|(id, _)| laid.sorted.is_empty() || is_met(*id))
        .map(|(_, primitive)| extent(&primitive.shape, direction)[1] - origin.dot(direction));
    1.06 * ends.fold(0.0, f64::max)
}
