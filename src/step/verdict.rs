//! What became of a step: the verdict of the event that decides it.

use std::ops::Range;

use crate::trace::{
    Event, NodeVerdict, PhotonVerdict, RayVerdict, Record, Verdict, Visibility, Why,
};

/// What became of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Became {
    /// Of a test: hit, or rejected and why.
    Tested(Verdict, Option<Why>),
    /// Of an object on a cell's list: its mailbox saves the test.
    Saved,
    /// Of an edge: does it count as a crossing?
    Counted(bool),
    /// Of a node of the hierarchy.
    Node(NodeVerdict),
    /// Of a ray.
    Ray(RayVerdict),
    /// Of a photon at a surface.
    Photon(PhotonVerdict),
    /// Of a light at a point.
    Light(Visibility),
}

impl Became {
    /// What became of a single event; `None` where nothing is decided.
    pub(in crate::step) fn of(event: &Event) -> Option<Self> {
        if let Some((verdict, why)) = event.verdict() {
            return Some(Self::Tested(verdict, why));
        }
        match event {
            Event::Mailbox { .. } => Some(Self::Saved),
            Event::Edge { edge, .. } => Some(Self::Counted(edge.counts)),
            Event::Node(visit) => Some(Self::Node(visit.verdict)),
            Event::RayEnd(end) => Some(Self::Ray(end.verdict)),
            Event::Photon(photon) => Some(Self::Photon(photon.verdict)),
            Event::LightTerm(term) => Some(Self::Light(term.visibility)),
            _ => None,
        }
    }

    /// What became of a test of several events: a slab and an edge decide about themselves alone, and the point in the
    /// polygon after its plane.
    pub(in crate::step) fn of_test(records: &[Record], events: Range<usize>) -> Option<Self> {
        let deciding = records[events].iter().rev().find_map(|record| {
            let of_part = matches!(
                record.event,
                Event::SlabTest(_) | Event::Edge { .. } | Event::Node(_)
            );
            Self::of(&record.event).filter(|_| !of_part)
        });
        deciding.filter(|became| matches!(became, Self::Tested(..) | Self::Saved))
    }

    /// ✓ of what was found, arrives or counts, ✗ of what was refused, · where neither is said.
    pub fn sign(self) -> char {
        match self {
            Self::Tested(Verdict::Hit, _)
            | Self::Counted(true)
            | Self::Node(NodeVerdict::Entered)
            | Self::Ray(RayVerdict::Hit | RayVerdict::ReachesLight | RayVerdict::Connects)
            | Self::Photon(
                PhotonVerdict::Mirrored | PhotonVerdict::Refracted | PhotonVerdict::Diffused,
            )
            | Self::Light(Visibility::Visible) => '✓',
            Self::Tested(Verdict::Rejected, _)
            | Self::Counted(false)
            | Self::Node(NodeVerdict::Rejected | NodeVerdict::Pruned)
            | Self::Ray(RayVerdict::Miss | RayVerdict::Blocked)
            | Self::Photon(PhotonVerdict::Absorbed)
            | Self::Light(Visibility::Shadowed | Visibility::FacesAway) => '✗',
            Self::Saved
            | Self::Ray(RayVerdict::DepthLimit | RayVerdict::Absorbed | RayVerdict::CutOff)
            | Self::Light(Visibility::NotTested) => '·',
        }
    }

    /// Is it the same but for the reason?
    pub(in crate::step) fn is_like(self, other: Self) -> bool {
        match (self, other) {
            (Self::Tested(one, _), Self::Tested(other, _)) => one == other,
            _ => self == other,
        }
    }
}
