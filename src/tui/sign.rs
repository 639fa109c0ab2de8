//! What became of a step, as a sign in front of its title.

use crate::step::Became;
use crate::trace::{NodeVerdict, PhotonVerdict, RayVerdict, Verdict, Visibility};

/// What became of a step, in three words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    /// Hit, entered, counted, lit.
    Yes,
    /// Rejected, pruned, blocked.
    No,
    /// Nothing is decided, or it says neither.
    Neither,
}

impl Sign {
    /// The sign of what became of a step.
    pub(super) fn of(became: Option<Became>) -> Self {
        match became {
            Some(
                Became::Tested(Verdict::Hit, _)
                | Became::Counted(true)
                | Became::Node(NodeVerdict::Entered)
                | Became::Ray(RayVerdict::Hit | RayVerdict::ReachesLight)
                | Became::Light(Visibility::Visible),
            ) => Self::Yes,
            Some(
                Became::Tested(Verdict::Rejected, _)
                | Became::Counted(false)
                | Became::Node(NodeVerdict::Rejected | NodeVerdict::Pruned)
                | Became::Ray(RayVerdict::Blocked | RayVerdict::DepthLimit)
                | Became::Photon(PhotonVerdict::Absorbed)
                | Became::Light(Visibility::Shadowed | Visibility::FacesAway),
            ) => Self::No,
            _ => Self::Neither,
        }
    }

    /// The letter that stands for it.
    pub(super) const fn letter(self, is_ascii: bool) -> char {
        match (self, is_ascii) {
            (Self::Yes, false) => '✓',
            (Self::No, false) => '✗',
            (Self::Neither, false) => '·',
            (Self::Yes, true) => '+',
            (Self::No, true) => 'x',
            (Self::Neither, true) => '.',
        }
    }
}
