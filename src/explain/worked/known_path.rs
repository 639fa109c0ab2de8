//! What is known of the paths of light that led to a pixel.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;

use crate::trace::{Arrival, Connection, Event, PathStart, Photon, Record};

/// What is known of a path of light in every part of the text.
#[derive(Clone, Debug, Default)]
pub(super) struct KnownPath {
    pub(super) start: Option<PathStart>,
    /// The photon at each of its surfaces, in order.
    pub(super) met: Vec<Photon>,
    /// What of it arrived at the eye.
    pub(super) arrivals: Vec<Arrival>,
    /// Lines from it to the eye.
    pub(super) lines: Vec<Connection>,
    /// The numbers of its surfaces where it was stored and the pixel has gathered it.
    pub(super) gathered: BTreeSet<u32>,
}

impl KnownPath {
    /// All paths in the records.
    pub(super) fn all(records: &[Record]) -> BTreeMap<u32, Self> {
        let mut paths: BTreeMap<u32, Self> = BTreeMap::new();
        for record in records {
            let Some(path) = record.path else {
                if let Event::Nearby(photon) = record.event {
                    let known = paths.entry(photon.path).or_default();
                    known.gathered.insert(photon.surface);
                }
                continue;
            };
            let known = paths.entry(path).or_default();
            match record.event {
                Event::Path(start) => known.start = Some(start),
                Event::Photon(photon) => known.met.push(photon),
                Event::Arrival(arrival) => known.arrivals.push(arrival),
                Event::Connection(line) => known.lines.push(line),
                _ => {}
            }
        }
        paths
    }
}

impl KnownPath {
    /// What the path carries after its first `surfaces` surfaces.
    pub(super) fn carried_after(&self, surfaces: u32) -> Option<DVec3> {
        match (surfaces as usize).checked_sub(1) {
            None => self.start.map(|start| start.power),
            Some(before) => self.met.get(before).map(Photon::leaving),
        }
    }
}
