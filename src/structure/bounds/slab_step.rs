//! One slab of a bound against a ray: its near and far t, and whether the next slab is looked at.
//!
//! Slides, "Optimizing Intersection Calculations": the maximum of the near values of t and the minimum of the far ones
//! are "updated as each of its slabs is processed, and the processing of the bound terminated if the former ever
//! exceeds the latter".

use crate::geometry::{Inside, SlabInterval, SlabRay};

/// What became of a bound at one of its slabs?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SlabVerdict {
    /// Near and far have not crossed: the next slab is looked at.
    #[default]
    GoesOn,
    /// The largest near is above the smallest far: the ray misses the bound.
    Null,
    /// The ray is parallel to the slab and inside it.
    ParallelInside,
    /// The ray is parallel to the slab and outside of it: it misses the bound.
    ParallelOutside,
}

/// One slab of a bound against a ray. Near and far are those of the slab with its room: they decide.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlabStep {
    /// Which direction of the set, from 0.
    pub slab: u32,
    /// D of the plane that is furthest along the normal, without room.
    pub d_min: f64,
    /// D of the plane that is furthest back, without room.
    pub d_max: f64,
    /// The near and the far t of this slab, with the room of its [`RaySlabs`](crate::structure::RaySlabs): either plane is
    /// moved outwards by that.
    pub interval: SlabInterval,
    /// The largest near of the slabs up to this one; −∞ if the ray is parallel to all of them.
    pub max_near: f64,
    /// The smallest far of the slabs up to this one; ∞ if the ray is parallel to all of them.
    pub min_far: f64,
    /// Whether the next slab is looked at.
    pub verdict: SlabVerdict,
}

impl SlabStep {
    /// Where the ray is inside the slabs up to this one; `None` if it misses the bound.
    pub fn inside(&self) -> Option<Inside> {
        match self.verdict {
            SlabVerdict::Null | SlabVerdict::ParallelOutside => None,
            SlabVerdict::GoesOn | SlabVerdict::ParallelInside => Some(Inside {
                near: self.max_near,
                far: self.min_far,
            }),
        }
    }

    /// The step as it would be without room: what the slab itself says. `line` is S and T for its direction, `before` the
    /// slab before it, without room.
    ///
    /// Words and figures show this; what decided is the step with its room.
    #[must_use]
    pub fn without_room(&self, line: &SlabRay, before: Option<&Self>) -> Self {
        let so_far = before.map_or(Inside::EVERYWHERE, |before| Inside {
            near: before.max_near,
            far: before.min_far,
        });
        self.decided(line, 0.0, so_far)
    }

    /// Fills in near and far of the slab with this room on either side, and what follows from them.
    pub(in crate::structure) fn decided(self, line: &SlabRay, room: f64, so_far: Inside) -> Self {
        let interval = line.interval_with_room(self.d_min, self.d_max, room);
        let inside = match interval {
            SlabInterval::ParallelOutside => so_far,
            meets => so_far.and(meets),
        };
        let verdict = match interval {
            SlabInterval::ParallelOutside => SlabVerdict::ParallelOutside,
            _ if inside.is_empty() => SlabVerdict::Null,
            SlabInterval::ParallelInside => SlabVerdict::ParallelInside,
            SlabInterval::Between { .. } => SlabVerdict::GoesOn,
        };
        Self {
            interval,
            max_near: inside.near,
            min_far: inside.far,
            verdict,
            ..self
        }
    }
}
