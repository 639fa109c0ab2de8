//! What is of interest by itself: where a student wants to look next.

use std::fmt;

use crate::trace::{Event, NodeVerdict, RayVerdict, Record, Verdict, Why};

/// Why an event is of interest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interest {
    /// A hit became the nearest.
    Nearest,
    /// A test was rejected for a reason that no test on this ray had before.
    NewReason(Why),
    /// The interval of a bound is empty.
    Empty,
    /// The ray is parallel to a plane or a slab.
    Parallel,
    /// A node was pruned.
    Pruned,
    /// A cell has objects.
    CellWithObjects,
    /// A mailbox saved a test.
    Mailbox,
    /// A hit lies outside of its cell.
    HitOutsideCell,
    /// A light, or the other end of a connecting line, is blocked.
    Blocked,
    /// All light is reflected at the inside of a surface.
    TotalReflection,
    /// The depth limit ended a ray.
    DepthLimit,
    /// Light arrives at the eye, was gathered, or comes along a connecting line.
    Light,
    /// The colour of the pixel.
    Colour,
}

impl fmt::Display for Interest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Nearest => "a nearer hit",
            Self::NewReason(_) => "a rejection for a new reason",
            Self::Empty => "the interval is empty",
            Self::Parallel => "parallel",
            Self::Pruned => "a node is pruned",
            Self::CellWithObjects => "a cell with objects",
            Self::Mailbox => "a mailbox saves a test",
            Self::HitOutsideCell => "a hit outside its cell",
            Self::Blocked => "blocked",
            Self::TotalReflection => "total internal reflection",
            Self::DepthLimit => "the depth limit",
            Self::Light => "light arrives",
            Self::Colour => "the colour of the pixel",
        })
    }
}

/// Finds what is of interest, event after event.
#[derive(Clone, Debug, Default)]
pub(in crate::step) struct Interests {
    pub(in crate::step) found: Vec<(usize, Interest)>,
    /// The reasons of each ray that is open, a bit each, with the ray's number.
    seen: Vec<(u32, u32)>,
}

impl Interests {
    pub(in crate::step) fn hear(&mut self, at: usize, record: &Record) {
        if let Some(interest) = self.of(record) {
            self.found.push((at, interest));
        }
    }

    fn of(&mut self, record: &Record) -> Option<Interest> {
        if let Some((Verdict::Rejected, Some(why))) = record.event.verdict() {
            let is_new = self.is_new(record.ray, why);
            return match why {
                Why::Parallel => Some(Interest::Parallel),
                Why::Empty => Some(Interest::Empty),
                _ => is_new.then_some(Interest::NewReason(why)),
            };
        }
        match &record.event {
            Event::Pixel(_) | Event::Path(_) => self.seen.clear(),
            Event::Nearest(_) => return Some(Interest::Nearest),
            Event::Node(visit) if visit.verdict == NodeVerdict::Pruned => {
                return Some(Interest::Pruned);
            }
            Event::Cell(cell) if 0 < cell.listed => return Some(Interest::CellWithObjects),
            Event::Mailbox { .. } => return Some(Interest::Mailbox),
            Event::HitOutsideCell(_) => return Some(Interest::HitOutsideCell),
            Event::Refraction(refraction) if refraction.direction.is_none() => {
                return Some(Interest::TotalReflection);
            }
            Event::RayEnd(end) => {
                self.seen.retain(|&(ray, _)| Some(ray) != record.ray);
                return match end.verdict {
                    RayVerdict::Blocked => Some(Interest::Blocked),
                    RayVerdict::DepthLimit => Some(Interest::DepthLimit),
                    _ => None,
                };
            }
            Event::Arrival(_) | Event::Gathered(_) => return Some(Interest::Light),
            Event::Connection(line) if line.visible => return Some(Interest::Light),
            Event::PixelColour(_) => return Some(Interest::Colour),
            _ => {}
        }
        None
    }

    /// Is this the first rejection for a reason on its ray?
    fn is_new(&mut self, ray: Option<u32>, why: Why) -> bool {
        let Some(ray) = ray else {
            return false;
        };
        let bit = 1 << why as u32;
        match self.seen.iter_mut().rev().find(|(open, _)| *open == ray) {
            Some((_, reasons)) => {
                let is_new = *reasons & bit == 0;
                *reasons |= bit;
                is_new
            }
            None => {
                self.seen.push((ray, bit));
                true
            }
        }
    }
}
