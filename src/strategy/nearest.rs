//! What is looked for: the nearest hit, with the rule for hits at equal t, or any hit.

use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::scene::{Primitive, PrimitiveId};
use crate::strategy::test_primitive;
use crate::trace::{Event, Nearest, Recorder};

/// A hit: which object, and where along the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The primitive that was hit.
    pub object: PrimitiveId,
    /// t of the hit along the ray, in lengths of Δ.
    pub t: f64,
}

/// What a strategy searches for, one object after the other.
pub trait Search {
    /// Where a hit still counts.
    fn range(&self) -> TRange;

    /// Does the first hit end the search? Then there is nothing to sort.
    #[inline]
    fn ends_at_first(&self) -> bool {
        false
    }

    /// Takes a hit within the range; `Break` if no other can matter.
    fn offer<R: Recorder>(
        &mut self,
        object: PrimitiveId,
        t: f64,
        recorder: &mut R,
    ) -> ControlFlow<()>;

    /// Tests an object and takes its hit, if there is one.
    #[inline]
    fn test<R: Recorder>(
        &mut self,
        object: PrimitiveId,
        primitive: &Primitive,
        ray: &Ray,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        match test_primitive(object, primitive, ray, self.range(), recorder) {
            Some(t) => self.offer(object, t, recorder),
            None => ControlFlow::Continue(()),
        }
    }
}

/// Keeps the nearest of the hits that are offered: "is intersected and is closest considered thus
/// far" (Fig. 15.56).
#[derive(Clone, Copy, Debug)]
pub struct NearestSoFar {
    range: TRange,
    hit: Option<Hit>,
}

impl NearestSoFar {
    /// Nothing hit yet.
    #[inline]
    pub fn new(range: TRange) -> Self {
        Self { range, hit: None }
    }

    /// The nearest so far.
    #[inline]
    pub fn hit(&self) -> Option<Hit> {
        self.hit
    }
}

impl Search for NearestSoFar {
    /// Up to the nearest so far, equal t included.
    #[inline]
    fn range(&self) -> TRange {
        self.range
    }

    /// Keeps the hit if it is nearer, or as near and earlier in the scene; a still nearer one may follow.
    #[inline]
    fn offer<R: Recorder>(
        &mut self,
        object: PrimitiveId,
        t: f64,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let nearer = |known: Hit| t < known.t || (t == known.t && object < known.object);
        if self.hit.is_none_or(nearer) {
            let replaced = self.hit.map(|known| known.object);
            recorder.note(|| {
                Event::Nearest(Nearest {
                    object,
                    t,
                    replaced,
                })
            });
            self.hit = Some(Hit { object, t });
            self.range = self.range.up_to(t);
        }
        ControlFlow::Continue(())
    }
}

/// Keeps the first hit that is offered.
#[derive(Clone, Copy, Debug)]
pub struct AnyHit {
    range: TRange,
    hit: Option<Hit>,
}

impl AnyHit {
    /// Nothing hit yet.
    #[inline]
    pub fn new(range: TRange) -> Self {
        Self { range, hit: None }
    }

    /// The hit that was offered.
    #[inline]
    pub fn hit(&self) -> Option<Hit> {
        self.hit
    }
}

impl Search for AnyHit {
    #[inline]
    fn range(&self) -> TRange {
        self.range
    }

    #[inline]
    fn ends_at_first(&self) -> bool {
        true
    }

    #[inline]
    fn offer<R: Recorder>(&mut self, object: PrimitiveId, t: f64, _: &mut R) -> ControlFlow<()> {
        self.hit = Some(Hit { object, t });
        ControlFlow::Break(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::Off;

    #[test]
    fn of_two_hits_at_equal_t_the_first_in_the_scene_wins_in_any_order() {
        for order in [[1, 2], [2, 1]] {
            let mut nearest = NearestSoFar::new(TRange::FORWARD);
            for id in order {
                let _ = nearest.offer(PrimitiveId(id), 5.0, &mut Off);
            }
            let expected = Hit {
                object: PrimitiveId(1),
                t: 5.0,
            };
            assert_eq!(nearest.hit(), Some(expected));
        }
    }

    #[test]
    fn the_range_ends_at_the_nearest_hit() {
        let mut nearest = NearestSoFar::new(TRange::FORWARD);
        for t in [7.0, 4.0, 5.0] {
            let _ = nearest.offer(PrimitiveId(0), t, &mut Off);
        }
        assert_eq!(nearest.range().max, 4.0);
    }

    #[test]
    fn an_object_that_is_offered_once_more_replaces_nothing() {
        use crate::trace::Recording;
        let mut recording = Recording::new(Vec::new());
        let mut nearest = NearestSoFar::new(TRange::FORWARD);
        for (object, t) in [(4, 7.0), (4, 7.0), (2, 5.0), (2, 5.0), (3, 5.0), (1, 5.0)] {
            let _ = nearest.offer(PrimitiveId(object), t, &mut recording);
        }
        let noted = recording.into_sink();
        let noted = noted.iter().map(|record| match record.event {
            Event::Nearest(of) => (of.object.0, of.replaced.map(|id| id.0)),
            other => panic!("{other:?}"),
        });
        let expected = [(4, None), (2, Some(4)), (1, Some(2))];
        assert_eq!(noted.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn any_hit_ends_the_search_with_the_first_that_is_offered() {
        let mut any = AnyHit::new(TRange::FORWARD.up_to(9.0));
        assert!(any.ends_at_first() && !NearestSoFar::new(TRange::FORWARD).ends_at_first());
        assert_eq!((any.hit(), any.range().max), (None, 9.0));
        assert!(any.offer(PrimitiveId(3), 7.0, &mut Off).is_break());
        assert_eq!(any.hit().map(|hit| (hit.object.0, hit.t)), Some((3, 7.0)));
    }
}
