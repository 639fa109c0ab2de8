//! Which root is the hit, and why each other one is not.
//!
//! The slides say "the one that yields the smallest positive t is the closest". Erratum 8 adds what
//! they leave out: all roots may lie behind the origin, from inside the far one is the hit, and a ray
//! that starts on a surface needs t > ε.

use crate::geometry::TRange;

/// Why is a root the hit, or why not?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RootVerdict {
    /// The smallest t that counts: the hit.
    Chosen,
    /// t ≤ 0: behind the origin, or the origin itself.
    #[default]
    Behind,
    /// |t| < ε: the surface on which the ray starts. On which side of 0 it falls is rounding.
    BelowEpsilon,
    /// Further than the nearest hit known so far, than the light, or than this object's other root.
    BeyondNearest,
    /// The surface shows only its front, and the ray hits its back.
    BackFace,
    /// The surface shows only its back, and the ray hits its front.
    FrontFace,
    /// On the infinite cone or cylinder, but not between base and apex.
    BeyondEnds,
}

/// Which sides of a surface can be seen?
///
/// The front is the side that the normal points to: the outside of a solid, the side from which a
/// polygon's vertices run counter-clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// Both.
    #[default]
    Both,
    /// Only the front: what the published statistics call one-sided.
    Front,
    /// Only the back: what a negative radius means in NFF.
    Back,
}

/// A value of t at which the ray hits a surface, and what became of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Root {
    /// t along the ray, in lengths of Δ.
    pub t: f64,
    /// Chosen, or the reason why not.
    pub verdict: RootVerdict,
}

/// Where does a ray hit a surface of second degree, or a box?
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Roots {
    /// Nowhere: no real root.
    #[default]
    None,
    /// One double root: the ray grazes the surface (discriminant within the stated tolerance of 0).
    Graze(Root),
    /// Two, `near` before `far`.
    Two {
        /// The smaller t.
        near: Root,
        /// The larger t.
        far: Root,
    },
    /// One, of a linear equation: a = 0 (a ray along a generator of a cone).
    Linear(Root),
}

impl Roots {
    /// The hit, if there is one.
    #[inline]
    pub fn chosen(&self) -> Option<f64> {
        let hit = |root: &Root| (root.verdict == RootVerdict::Chosen).then_some(root.t);
        match self {
            Self::None => None,
            Self::Graze(root) | Self::Linear(root) => hit(root),
            Self::Two { near, far } => hit(near).or_else(|| hit(far)),
        }
    }

    /// All of them, in the order of t.
    pub fn iter(&self) -> impl Iterator<Item = Root> {
        let (first, second) = match *self {
            Self::None => (None, None),
            Self::Graze(root) | Self::Linear(root) => (Some(root), None),
            Self::Two { near, far } => (Some(near), Some(far)),
        };
        first.into_iter().chain(second)
    }
}

/// Where is t: behind, too near, too far, or the hit?
#[inline]
pub(crate) fn verdict_of(t: f64, range: TRange) -> RootVerdict {
    if t.abs() < range.min {
        RootVerdict::BelowEpsilon
    } else if t <= 0.0 {
        RootVerdict::Behind
    } else if t <= range.max {
        RootVerdict::Chosen
    } else {
        RootVerdict::BeyondNearest
    }
}

/// Can the side be seen that the ray hits? `entering` means that it hits the front.
#[inline]
pub(crate) fn hidden_side(entering: bool, sides: Sides) -> Option<RootVerdict> {
    match sides {
        Sides::Front if !entering => Some(RootVerdict::BackFace),
        Sides::Back if entering => Some(RootVerdict::FrontFace),
        _ => None,
    }
}

/// Two roots, each with a verdict of its own: once `near` is chosen, `far` lies beyond the nearest.
#[inline]
pub(super) fn two_roots(near: Root, mut far: Root) -> Roots {
    if near.verdict == RootVerdict::Chosen && far.verdict == RootVerdict::Chosen {
        far.verdict = RootVerdict::BeyondNearest;
    }
    Roots::Two { near, far }
}

/// One root with its verdict: first where it lies, then what the surface itself refuses.
#[inline]
pub(super) fn judged(
    t: f64,
    range: TRange,
    mut refused: impl FnMut(f64) -> Option<RootVerdict>,
) -> Root {
    let verdict = match verdict_of(t, range) {
        RootVerdict::Behind => RootVerdict::Behind,
        RootVerdict::BelowEpsilon => RootVerdict::BelowEpsilon,
        place => refused(t).unwrap_or(place),
    };
    Root { t, verdict }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_of_the_range_count_and_the_origin_does_not() {
        let range = TRange {
            min: 0.25,
            max: 4.0,
        };
        for (t, verdict) in [
            (0.25, RootVerdict::Chosen),
            (0.25_f64.next_down(), RootVerdict::BelowEpsilon),
            (-0.25_f64.next_down(), RootVerdict::BelowEpsilon),
            (-0.25, RootVerdict::Behind),
            (4.0, RootVerdict::Chosen),
            (4.0_f64.next_up(), RootVerdict::BeyondNearest),
        ] {
            assert_eq!(verdict_of(t, range), verdict, "{t}");
        }
        for t in [0.0, -0.0] {
            assert_eq!(verdict_of(t, TRange::FORWARD), RootVerdict::Behind, "{t}");
        }
    }
}
