//! What the events of the search have in common: bounding volumes, and where a ray is inside.

use crate::geometry::TRange;
use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::verdict::Judged;
use crate::trace::event::words::Why;

/// What a bounding volume is around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounded {
    /// An object of the scene, by its place in [`Scene::objects`](crate::scene::Scene::objects).
    Object(u32),
    /// A node of the hierarchy, by its number; the root is 0.
    Node(u32),
}

impl Default for Bounded {
    fn default() -> Self {
        Self::Node(0)
    }
}

/// Either key is there.
impl Fields for Bounded {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let (mut object, mut node) = match *self {
            Self::Object(object) => (Some(object), None),
            Self::Node(node) => (None, Some(node)),
        };
        let meaning = "The object that the volume is around; absent: it is around a node.";
        v.whole_object("object", meaning, &mut object);
        let meaning =
            "The number of the node that the volume is around; absent: it is around an object.";
        v.optional("node", meaning, &mut node);
        *self = match (object, node) {
            (Some(object), None) => Self::Object(object),
            (None, Some(node)) => Self::Node(node),
            _ => return v.fail("a volume is around either an \"object\" or a \"node\""),
        };
    }
}

/// What a ray does to a bounding volume.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundVerdict {
    /// It hits it at a t that counts: what is inside is tested.
    Hit,
    /// It passes by.
    #[default]
    Missed,
    /// The volume lies behind the origin.
    Behind,
    /// The volume begins behind the nearest hit so far, or behind the light.
    Beyond,
}

impl BoundVerdict {
    /// What follows from where a ray is inside a volume, and from which t count. Equality counts.
    pub(crate) fn of(inside: Option<[f64; 2]>, range: TRange) -> Self {
        match inside {
            None => Self::Missed,
            Some([_, far]) if far < range.min => Self::Behind,
            Some([near, _]) if range.max < near => Self::Beyond,
            Some(_) => Self::Hit,
        }
    }

    /// Why the volume is rejected, if it is.
    pub(super) fn why(self) -> Option<Why> {
        match self {
            Self::Hit => None,
            Self::Missed => Some(Why::Missed),
            Self::Behind => Some(Why::Behind),
            Self::Beyond => Some(Why::BeyondNearest),
        }
    }
}

impl Fields for BoundVerdict {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let mut judged = Judged(self.why());
        judged.fields(v);
        *self = match judged.0 {
            None => Self::Hit,
            Some(Why::Missed) => Self::Missed,
            Some(Why::Behind) => Self::Behind,
            Some(Why::BeyondNearest) => Self::Beyond,
            Some(_) => return v.fail("a bound is rejected as missed, behind or beyond_nearest"),
        };
    }
}

/// Where a ray is inside a volume: the t at which it enters and leaves; `None` if it passes by.
pub(in crate::trace) type Stretch = Option<[f64; 2]>;

/// Both keys are there, or neither.
impl Fields for Stretch {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let (mut near, mut far) = self.map(|[near, far]| (near, far)).unzip();
        let meaning = "t at which the ray enters it; absent: it passes by.";
        v.optional("near", meaning, &mut near);
        let meaning = "t at which the ray leaves it; absent: it passes by.";
        v.optional("far", meaning, &mut far);
        *self = match (near, far) {
            (Some(near), Some(far)) => Some([near, far]),
            (None, None) => None,
            _ => return v.fail("a stretch of the ray has two ends"),
        };
    }
}
