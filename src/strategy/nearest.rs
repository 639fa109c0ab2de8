//! The nearest hit so far, and the rule for hits at equal t.

use crate::geometry::TRange;
use crate::scene::PrimitiveId;
use crate::trace::{Event, Nearest, Recorder};

/// A hit: which object, and where along the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// What was hit.
    pub object: PrimitiveId,
    /// Where.
    pub t: f64,
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

    /// Where a hit still counts: up to the nearest so far, equal t included.
    #[inline]
    pub fn range(&self) -> TRange {
        self.range
    }

    /// The nearest so far.
    #[inline]
    pub fn hit(&self) -> Option<Hit> {
        self.hit
    }

    /// Takes a hit within [`NearestSoFar::range`] if it is nearer, or as near and earlier in the scene.
    #[inline]
    pub fn offer<R: Recorder>(&mut self, object: PrimitiveId, t: f64, recorder: &mut R) {
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
                nearest.offer(PrimitiveId(id), 5.0, &mut Off);
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
            nearest.offer(PrimitiveId(0), t, &mut Off);
        }
        assert_eq!(nearest.range().max, 4.0);
    }
}
